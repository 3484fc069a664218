/* Tests of chapters/27_effects: can the plan be refuted?
 *
 * Random scenes, of all statements and all three formats. The oracle is everything at every hit, by
 * a stage that was built without the plan. "Cannot occur" must hold byte for byte, since random
 * numbers have names; but for the rule "one plane", where the weights of shadow rays and bounces
 * are others: there by a t-test. Then each rule is broken in turn: the same scenes must show it.
 */
#include "27_files.h"
#include "../chapters/27_effects/lab/draw.h"
#include "../chapters/27_effects/plan.h"
#include "../common/lab/t_test.h"

enum { columns = 8, rows = 6, proof_room = 1 << 14, proof_scenes = 1000 };  /* of `make test` */

static double some(random_stream *r, double lowest, double highest)
{
    return lowest + (highest - lowest) * (double)random_next(r);
}

static bool chance(random_stream *r, double p) { return (double)random_next(r) < p; }

typedef struct { char *text; size_t n; } writing;

__attribute__((format(printf, 2, 3)))
static void say(writing *w, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    w->n += (size_t)vsnprintf(w->text + w->n, proof_room - w->n, format, arguments);
    va_end(arguments);
}

/* ---- scenes that nobody thought of ---- */

/* The keys of a material of any illum, with what it may call for, often nothing of it. */
static void random_keys(random_stream *r, writing *w)
{
    double ks = chance(r, 0.3) ? 0 : chance(r, 0.1) ? 1 : some(r, 0.1, 0.95);
    if (chance(r, 0.8)) say(w, "illum %d\n", (int)some(r, 0, 11));
    say(w, "Kd %g\nKs %g %g %g\n", chance(r, 0.5) ? 0 : some(r, 0, 1), ks, ks, ks / 2);
    if (chance(r, 0.7))
        say(w, "Ns %g\n", chance(r, 0.3) ? 2000 : chance(r, 0.2) ? some(r, 0, 1) : 30.0);
    if (chance(r, 0.5)) say(w, "Ni %g\n", chance(r, 0.1) ? 1 : some(r, 0.7, 2));
    if (chance(r, 0.5)) say(w, "Tf %g 1 1\n", some(r, 0, 1));
    bool tr = chance(r, 0.3);
    if (chance(r, 0.3)) say(w, "%s %g\n", tr ? "Tr" : "d", some(r, 0, 1));
    if (chance(r, 0.3)) say(w, "absorb 1 0 %g\n", some(r, 0, 2));
    if (chance(r, 0.15)) say(w, "illum 7\nNi 1.4\nTf 0.9\nroughness %g\n", some(r, 0, 0.8));
    if (chance(r, 0.3)) say(w, "priority %d\n", (int)some(r, 0, 3));
    if (chance(r, 0.1)) say(w, "Ke %g\n", chance(r, 0.2) ? 0 : some(r, 0, 5));
}

static void random_material(random_stream *r, writing *w, int number)
{
    if (chance(r, 0.15)) {
        say(w, "use %s\n", (const char *[]){"library", "lamp", "red"}[(int)some(r, 0, 3)]);
        return;
    }
    if (chance(r, 0.3)) say(w, "material m%d\nKd %g\n", number, chance(r, 0.5) ? 0 : 0.6);
    else say(w, "material m%d\n", number), random_keys(r, w);
}

static void random_shape(random_stream *r, writing *w)
{
    double x = some(r, -2, 2), y = some(r, 0, 2), z = some(r, -2, 2), a = some(r, 0.2, 1.2);
    switch ((int)some(r, 0, 11)) {
    case 10:  /* round the eye, too */
        say(w, "sphere 0 0.8 0 %g\n", (double[]){0.3, 0.6, 1.2, 3, 7}[(int)some(r, 0, 5)]);
        return;
    case 9:  /* folded like a book, open towards the eye */
        say(w, "polygon -3 -1 %g  0 -1 %g  3 -1 %g  3 3 %g  0 3 %g  -3 3 %g\n", z, z - 3, z, z,
            z - 3, z);
        return;
    case 8:
        say(w, "solid %s difference(sphere %g %g %g %g, box %g %g -9 9 9 9)\n",
            chance(r, 0.5) ? "red" : "chrome", x, y, z, a, x, y);
        return;
    case 0: case 1: say(w, "sphere %g %g %g %g\n", x, y, z, chance(r, 0.1) ? -9 : a); return;
    case 2:
        say(w, "cone %g 0 %g %g %g 2 %g 0.1  %s\n", x, z, a, x, z,
            (const char *[]){"red", "glass", "brushed"}[(int)some(r, 0, 3)]);
        return;
    case 3:  /* upright, towards the eye */
        say(w, "polygon -3 -1 %g  3 -1 %g  3 3 %g  -3 3 %g\n", z, z, z, z);
        return;
    case 4: say(w, "obj roof.obj scale %g move %g 0 %g\n", a, x, z); return;
    case 5: say(w, "mesh roof%g roof.obj\ninstance roof%g turn 0 1 0 %g\n", x, x, 90 * y); return;
    }
    y = chance(r, 0.7) ? 0 : -some(r, 0, 1);
    say(w, "polygon -9 %g 9  9 %g 9  9 %g -9  -9 %g -9\n", y, y, y, y);
}

/* On the ground, and side by side with others. */
static void random_box(random_stream *r, writing *w)
{
    int left = (int)some(r, 0, 3), front = (int)some(r, 0, 2);
    say(w, "box %d 0 %d  %d 1 %d\n", left - 1, front - 1, left, front);
}

/* own: light of the scene file, not black; glows: a material of it does, which may be in use */
typedef struct { bool off, on, own, glows; } proof_said;

static void random_light(random_stream *r, writing *w, proof_said *said)
{
    static const char *const behind[] = {
        "", "", "", "background 0.1 0.3 0.5\n", "environment 0.4 0.5 0.6\n", "environment 0.3 1\n",
        "environment sky.pfm turn 30\n", "environment 0\n"};
    int sky = (int)some(r, 0, 8);
    say(w, "%s", behind[sky]), said->own = sky > 3 && sky < 7;
    if (chance(r, 0.4)) say(w, "lens radius %g focus 4\n", chance(r, 0.2) ? 0 : 0.1);
    if (chance(r, 0.4)) said->own = true, say(w, "light at 1 4 3 colour 40\n");
    if (chance(r, 0.1)) say(w, "light at 1 4 3 colour 0\n");
    if (chance(r, 0.2)) said->own = true, say(w, "sun to -1 2 1 colour 1\n");
    if (chance(r, 0.2)) said->off = true, say(w, "indirect off\n");
    if (chance(r, 0.1)) said->on = true, said->off = false, say(w, "indirect on\n");
}

/* One thing or two, in a light of their own: what rules about the whole scene take for nothing, for
 * a plane, for dark or for a light of MTL. */
static void random_few(random_stream *r, writing *w, proof_said *said)
{
    static const char *const thing[] = {
        "", "sphere 0.3 0.9 0 0.9\n", "cone 0.3 0 0 1 0.3 2 0 0.2\n", "box -1 0 -1  1 1 1\n",
        "polygon -2 0 -1  2 0 -1  2 2 -1  -2 2 -1\n",
        "polygon -3 -1 0  0 -1 -3  3 -1 0  3 3 0  0 3 -3  -3 3 0\n", "obj roof.obj\n",
        "mesh roof roof.obj\ninstance roof scale 1.5\n",
        "solid red difference(sphere 0 0.9 0 0.9, box 0 0.9 -9 9 9 9)\n",
        "solid red union(sphere 0.3 0.9 0 0.9, sphere -0.5 0.6 0 0.6)\n",
        "sphere 0 1 0 8\n", "sphere 0 -1 0 9\n",  /* around the eye and the light */
        "solid chrome intersection(sphere 0 0.9 0 1, box -0.7 0 -0.7 0.7 2 0.7)\n"};
    static const char *const lit[] = {
        "light at 1 4 3 colour 40\n", "sun to -1 2 1 colour 1\n", "environment 0.3 1\n",
        "light at 1 4 3 colour 0\nlight at -1 4 3 colour 40\n",
        "light at -1 4 3 colour 40\nlight at 1 4 3 colour 0\n",
        "material glow\nKe 3\npolygon -2 4 3  2 4 3  2 4 -1  -2 4 -1\n",
        "nff lit.nff\nlight at 1 4 3 colour 0\n",
        "use lamp\npolygon -2 4 3  2 4 3  2 4 -1  -2 4 -1\n"};
    enum { things = sizeof thing / sizeof *thing, lights = sizeof lit / sizeof *lit };
    int by = (int)some(r, 0, lights + 1);
    if (chance(r, 0.5)) say(w, "background 0.1 0.3 0.5\n");
    if (chance(r, 0.5)) say(w, "lens radius 0.1 focus 3\n");
    if (by < lights) say(w, "%s", lit[by]), said->own = by + 2 < lights;
    if (chance(r, said->own ? 0.1 : 0.5)) said->on = true, say(w, "indirect on\n");
    if (chance(r, 0.8)) say(w, "use red\n");
    else say(w, "material shiny\nKd 0\nKs 0.7\nNs 20\nillum 2\n");
    if (chance(r, 0.5)) say(w, "polygon -9 0 9  9 0 9  9 0 -9  -9 0 -9\n");
    say(w, "%s", thing[(int)some(r, 0, things)]);
}

static proof_said random_scene(random_stream *r, writing *w)
{
    proof_said said = {.own = false};
    double near = chance(r, 0.8) ? 0 : some(r, 0, 4), far = some(r, 1, 6);
    if (chance(r, 0.2)) say(w, "up y\n");
    say(w, "camera from 0 1 %g at 0 0.8 0 angle 45 hither %g\nmtl library.mtl\n"
        "material red\nKd 0.7 0.1 0.1\n", far, near);
    if (chance(r, 0.3)) return random_few(r, w, &said), said;
    random_light(r, w, &said);
    if (chance(r, 0.1)) say(w, "nff lit.nff\n");
    for (int k = 0, m = (int)some(r, 0, 5); k < m; k++)
        random_material(r, w, k), random_shape(r, w);
    for (int k = 5; k < 9 && chance(r, 0.2); k++) random_material(r, w, k), random_box(r, w);
    said.glows = strstr(w->text, "Ke ") != NULL;
    return said;
}

/* All statements of NFF; light by `l` alone. */
static void random_nff(random_stream *r, writing *w)
{
    double far = some(r, 2, 6), near = chance(r, 0.8) ? 0 : some(r, 0, 4);
    say(w, "v\nfrom 0 1 %g\nat 0 0.8 0\nup 0 1 0\nangle 45\nhither %g\nresolution 8 6\n", far,
        near);
    if (chance(r, 0.5)) say(w, "b 0.1 0.3 0.5\n");
    if (chance(r, 0.8)) say(w, "l 1 4 3\n");
    if (chance(r, 0.3)) say(w, "l -2 4 3 %g 0.5 0.5\n", some(r, 0, 1));
    for (int k = 0, m = (int)some(r, 0, 5); k < m; k++) {
        double x = some(r, -2, 2), z = some(r, -2, 1);
        double ior = some(r, 1, 2), T = chance(r, 0.7) ? 0 : some(r, 0, 1), shine = some(r, 1, 50);
        double ks = chance(r, 0.5) ? 0 : some(r, 0, 1), kd = chance(r, 0.3) ? 0 : some(r, 0, 1);
        say(w, "f 0.9 0.5 %g %g %g %g %g %g\n", some(r, 0, 1), kd, ks, shine, T, ior);
        switch ((int)some(r, 0, 5)) {
        case 4: say(w, "p 5 %g 0 %g 1 1 0 1 %g 1 0 2 1 -1 1 %g\n", x, z, -x, z); break;  /* bent */
        case 0: say(w, "s %g 0.5 %g %g\n", x, z, chance(r, 0.2) ? -2 : 0.5); break;
        case 1: say(w, "c %g 0 %g 0.5 %g 1 %g 0.1\n", x, z, x, z); break;
        case 2: say(w, "p 4 -9 0 9 9 0 9 9 0 -9 -9 0 -9\n"); break;
        case 3: say(w, "pp 3 %g 0 %g 0 0 1 1 0 %g 0 0 1 0 2 %g 0 0.1 1\n", x, z, z, z); break;
        }
    }
}

/* A closed block, but for what its faces may be made of instead. */
static void random_block(random_stream *r, writing *w, int materials)
{
    static const char *const face[6] = {"-8 -4 -2 -6", "-7 -5 -1 -3", "-8 -7 -3 -4",
                                        "-6 -2 -1 -5", "-8 -6 -5 -7", "-4 -3 -1 -2"};
    double x = some(r, -2, 2), y = some(r, 0, 2), z = some(r, -2, 2), a = some(r, 0.2, 1);
    for (int k = 0; k < 8; k++)
        say(w, "v %.9g %.9g %.9g\n", x + (k & 1 ? a : -a), y + (k & 2 ? a : -a),
            z + (k & 4 ? a : -a));
    for (int k = 0; k < 6; k++) {
        if (chance(r, 0.1)) say(w, "usemtl m%d\n", (int)some(r, 0, materials));
        say(w, "f %s\n", face[k]);
    }
}

/* OBJ with a library, which is put before it; light by Ke, and as the command line says. */
static studio_words random_obj(random_stream *r, writing *w, proof_said *said)
{
    studio_words words = {.camera = "from 0 1 5 at 0 0.8 0"};
    int m = 1 + (int)some(r, 0, 4);
    for (int k = 0; k < m; k++)
        say(w, "newmtl m%d\nKa 1\nmap_Kd a.png\n", k), random_keys(r, w);
    put("random.mtl", w->text);
    size_t begin = w->n;
    say(w, "mtllib random.mtl\n");
    for (int k = (int)some(r, 0, 5); k >= 0; k--) {
        const char *kind = chance(r, 0.1) ? "none" : "m";
        if (chance(r, 0.9)) say(w, "usemtl %s%d\n", kind, (int)some(r, 0, m));
        if (chance(r, 0.7)) random_block(r, w, m);
        else say(w, "v -9 0 9\nv 9 0 9\nv 9 0 -9\nv -9 0 -9\nf -4 -3 -2 -1\n");
    }
    put("random.obj", w->text + begin);
    if (chance(r, 0.3)) said->own = true, words.light = "at 1 4 3 colour 40";
    if (chance(r, 0.2)) said->own = true, words.environment = "0.3 1";
    if (chance(r, 0.2)) words.lens = "radius 0.1";
    if (chance(r, 0.2)) said->off = true, words.indirect = "off";
    return words;
}

/* ---- one scene, judged ---- */

typedef struct {
    studio s;
    effects_stage e;      /* built without any plan */
    image everything;
    int samples;
    bool drawn;
    proof_said said;
} proof;

static bool proof_begin(proof *q, size_t number, char *text)
{
    random_stream r = random_start(27, number, 0);
    writing w = {text, 0};
    failure f = {0, ""};
    studio_view v;
    camera c;
    *q = (proof){.samples = 2};
    studio_words words = {.camera = NULL};
    const char *name = number % 5 == 4 ? "random.nff" : number % 5 == 3 ? "random.obj"
                                                                       : "random.scene";
    if (number % 5 == 4) random_nff(&r, &w);
    else if (number % 5 == 3) words = random_obj(&r, &w, &q->said);
    else q->said = random_scene(&r, &w);
    if (number % 5 != 3) put(name, text);
    bool ok = studio_read(in_directory(name), &words, &q->s, &f);
    if (ok && !studio_camera(&q->s, 4 / (real)3, &v, &c, &f)) ok = false, studio_free(&q->s);
    if (ok && !effects_stage_build(&q->s, &q->e, &f)) ok = false, studio_free(&q->s);
    check(ok, "scene %zu: %s\n%s", number, f.text, text);
    if (ok) effects_stage_view(&q->e, &v, c);
    return ok;
}

static void proof_end(proof *q)
{
    image_free(&q->everything), effects_stage_free(&q->e), studio_free(&q->s);
}

/* What is not simulated takes no ray. */
static image proof_draw(proof *q, unsigned mask, int samples, uint64_t seed)
{
    image im;
    drawing j = {.e = &q->e, .samples = samples, .seed = seed, .width = columns, .height = rows};
    effects_stage_effects(&q->e, mask);
    draw_image(&j, &im, 1);
    for (int k = 0; k < effect_kinds; k++)
        if (!(mask >> k & 1) && j.counts.rays[k])
            check(false, "%zu rays for %s, which is not in %x", j.counts.rays[k],
                  effect_names[k].name, mask);
    return im;
}

/* The same light? The probability of so large a difference of the means of so many pictures, which
 * are independent of each other; each pair throws the same dice, so that little else is left. */
static double proof_likely(proof *q, unsigned mask, uint64_t pictures)
{
    estimate off = {0};
    for (uint64_t seed = 6; seed < 6 + pictures; seed++) {
        image a = proof_draw(q, mask, 4, seed);
        image b = proof_draw(q, EFFECTS_EVERYTHING, 4, seed);
        double sum = 0;
        for (size_t i = 0; i < 3 * columns * rows; i++) sum += (double)(a.rgb[i] - b.rgb[i]);
        off = estimate_add(off, sum / (3 * columns * rows));
        image_free(&a), image_free(&b);
    }
    double mean = off.mean < 0 ? -off.mean : off.mean;
    return mean <= 1e-5 ? 1 : t_test(off, 0, 300 * (double)real_epsilon);
}

/* Is the light declined for a reason that the file gives? By what was written into it. */
static bool proof_may_decline(const proof *q)
{
    if (q->said.on) return false;
    return q->said.off || !q->said.own;
}

/* Nobody called for it: no plan may. */
static bool proof_must_decline(const proof *q)
{
    return proof_may_decline(q) && (q->said.off || !q->said.glows);
}

/* Of the rule "one plane", or of what stands in its place. */
static bool proof_by_dice(const plan_rule *rule)
{
    for (const plan_rule *k = plan_rules; rule && k < plan_rules + plan_rule_count; k++)
        if (k->holds == rule_one_plane) return rule->reason == k->reason;
    return false;
}

/* True: this plan is refuted: it says "cannot occur" of light that is there, or it declines what
 * nobody told it to decline. */
static bool proof_refutes(proof *q, const plan *p, bool *by_chance)
{
    unsigned mask = p->effects | p->declined | EFFECTS_DICED;
    *by_chance = false;
    if (p->declined && !proof_may_decline(q)) return true;
    if (!q->drawn) q->everything = proof_draw(q, EFFECTS_EVERYTHING, q->samples, 5);
    q->drawn = true;
    image lean = proof_draw(q, mask, q->samples, 5);
    bool same = memcmp(lean.rgb, q->everything.rgb, 3 * columns * rows * sizeof *lean.rgb) == 0;
    image_free(&lean);
    if (same) return false;
    if (!proof_by_dice(p->rule[RAY_SCATTERED])) return true;  /* all numbers are the same */
    *by_chance = true;
    double likely = proof_likely(q, mask, 16);  /* false alarms: one in 10^9 scenes */
    if (likely < 1e-2 && likely >= 1e-9) likely = proof_likely(q, mask, 64);
    return likely < 1e-9;
}

static void test_promise(void)
{
    char *text = allocate(proof_room, 1);
    size_t n = check_count(8 * proof_scenes), by_dice = 0, refuted = 0;
    size_t counts[effect_kinds][3] = {{0}};
    for (size_t i = 0; i < n; i++) {
        proof q;
        bool by_chance;
        if (!proof_begin(&q, i, text)) continue;
        plan p = plan_of(&q.s);
        if (proof_refutes(&q, &p, &by_chance)) {
            refuted++;
            check(false, "scene %zu, called %x, declined %x: everything gives another picture:\n%s",
                  i, p.effects, p.declined, text);
        }
        if (proof_must_decline(&q))
            check(p.verdict[RAY_SCATTERED] != VERDICT_CALLED, "scene %zu: direct light alone:\n%s",
                  i, text);
        by_dice += by_chance;
        for (int k = 0; k < effect_kinds; k++) counts[k][p.verdict[k]]++;
        plan_free(&p), proof_end(&q);
    }
    check_equal(refuted, 0, "of %zu scenes", n);
    if (n >= 400) check_at_least(by_dice, 1, "scenes that a t-test judged");
    for (int k = 0; k < effect_kinds && n >= 100; k++)
        check(counts[k][VERDICT_CALLED] > n / 100 && counts[k][VERDICT_CANNOT] > n / 100,
              "%s: called for in %zu scenes, cannot occur in %zu", effect_names[k].name,
              counts[k][VERDICT_CALLED], counts[k][VERDICT_CANNOT]);
    free(text);
}

/* ---- holes, planted ---- */

/* A rule in the place of another, by what it asks. */
#define HOLE(name, test)                                  \
    static bool name(const plan_facts *q, cite *line)     \
    {                                                     \
        (void)q, (void)line;                              \
        return test;                                      \
    }
HOLE(always, true)

/* Rules that a tired programmer might have written. */
HOLE(looks_at_first_light,
     !q->s->lights || vzero(q->s->light[q->s->lights - 1].light.colour))
HOLE(thinks_matte_is_lit, !q->has[RAY_SCATTERED].n)
HOLE(forgets_points, !q->s->emitters && !q->around)  /* what 27 once did */
HOLE(forgets_the_sky, !q->s->emitters && !q->lights)

static bool forgets_suns(const plan_facts *q, cite *line)
{
    (void)line;
    for (size_t i = 0; i < q->s->lights; i++)
        if (q->s->light[i].light.kind == LIGHT_POINT) return false;
    return true;
}

static bool forgets_meshes(const plan_facts *q, cite *line)
{
    (void)line;
    for (size_t i = 0; i < q->s->emitters; i++)
        if (q->s->emitter[i].place == no_shape) return false;
    return true;
}

/* As if the scene had none of these: a part of a rule that was left out. */
/* NOLINTBEGIN(bugprone-macro-parentheses): a member takes none */
#define FORGETS(name, rule, part, none)                                      \
    static bool name(const plan_facts *q, cite *line)                        \
    {                                                                        \
        studio bare = *q->s;                                                 \
        plan_facts facts = *q;                                               \
        bare.part = none, facts.s = &bare;                                   \
        facts.flat = plan_flat(&bare, q->look);                              \
        facts.direct_only = plan_direct_only(&facts);                        \
        return rule(&facts, line);                                           \
    }
/* NOLINTEND(bugprone-macro-parentheses) */
FORGETS(a_plane_but_for_meshes, rule_one_plane, places, 0)
FORGETS(a_plane_but_for_solids, rule_one_plane, solids, 0)
FORGETS(sees_no_shapes, rule_nothing_seen, shapes, 0)
FORGETS(sees_no_meshes, rule_nothing_seen, places, 0)
FORGETS(sees_no_solids, rule_nothing_seen, solids, 0)
FORGETS(sees_no_sky, rule_nothing_seen, sky.kind, SKY_NONE)
FORGETS(is_told_nothing, rule_direct_formats, indirect, INDIRECT_UNSAID)
FORGETS(knows_lamps_alone, rule_direct_formats, lights, 0)
FORGETS(knows_no_lamps, rule_direct_formats, emitters, 0)

static bool knows_no_sky(const plan_facts *q, cite *line)
{
    plan_facts facts = *q;
    facts.around = false, facts.direct_only = plan_direct_only(&facts);
    return rule_direct_formats(&facts, line);
}

/* How many things reflect, where each of a kind counts for so many. */
static size_t reflecting(const plan_facts *q, size_t flat, size_t folded, size_t round)
{
    size_t n = q->s->places || q->s->solids ? 2 : 0;
    for (size_t i = 0; i < q->s->shapes; i++) {
        const shape *x = &q->s->shape[i];
        if (q->look[q->s->shape_material[i]].calls)
            n += x->kind != SHAPE_POLYGON ? round : polygon_is_flat(&x->polygon) ? flat : folded;
    }
    return n;
}

HOLE(counts_polygons_alone, reflecting(q, 1, 2, 0) < 2)
HOLE(takes_a_ball_for_a_plane, reflecting(q, 1, 2, 1) < 2)  /* it may be seen from within */
HOLE(takes_two_planes_for_one, reflecting(q, 0, 2, 2) < 2)
HOLE(takes_all_polygons_for_planes, reflecting(q, 1, 1, 2) < 2)

static bool looks_at_first_material(const plan_facts *q, cite *line)
{
    (void)line;
    for (uint32_t m = 0; m < q->s->materials; m++)
        if (q->s->material[m].used) return vzero(q->look[m].m.mirror);
    return true;
}

static bool forgets_rough_glass(const plan_facts *q, cite *line)
{
    (void)line;
    for (uint32_t m = 0; m < q->s->materials; m++)
        if (q->s->material[m].used && q->look[m].glossy && !vzero(q->look[m].m.ks)) return false;
    return true;
}

static const struct {
    bool (*rule)(const plan_facts *, cite *);
    unsigned effect;
    bool (*holds)(const plan_facts *, cite *);
} holes[] = {
        {rule_no_light, EFFECT_HARD_SHADOWS, forgets_suns},
        {rule_black_light, EFFECT_HARD_SHADOWS, looks_at_first_light},
        {rule_unlit, EFFECT_HARD_SHADOWS, thinks_matte_is_lit},
        {rule_unlit, EFFECT_SOFT_SHADOWS, thinks_matte_is_lit},
        {rule_unlit, EFFECT_ENVIRONMENT, thinks_matte_is_lit},
        {rule_no_lamp, EFFECT_SOFT_SHADOWS, forgets_meshes},
        {rule_dark, EFFECT_INDIRECT, forgets_points}, {rule_dark, EFFECT_INDIRECT, forgets_the_sky},
        {rule_one_plane, EFFECT_INDIRECT, a_plane_but_for_meshes},
        {rule_one_plane, EFFECT_INDIRECT, a_plane_but_for_solids},
        {rule_one_plane, EFFECT_INDIRECT, counts_polygons_alone},
        {rule_one_plane, EFFECT_INDIRECT, takes_a_ball_for_a_plane},
        {rule_one_plane, EFFECT_INDIRECT, takes_two_planes_for_one},
        {rule_one_plane, EFFECT_INDIRECT, takes_all_polygons_for_planes},
        {rule_direct_formats, EFFECT_INDIRECT, is_told_nothing},
        {rule_direct_formats, EFFECT_INDIRECT, knows_lamps_alone},
        {rule_direct_formats, EFFECT_INDIRECT, knows_no_lamps},
        {rule_direct_formats, EFFECT_INDIRECT, knows_no_sky},
        {rule_nothing_seen, EFFECT_DEPTH_OF_FIELD, sees_no_shapes},
        {rule_nothing_seen, EFFECT_DEPTH_OF_FIELD, sees_no_meshes},
        {rule_nothing_seen, EFFECT_DEPTH_OF_FIELD, sees_no_solids},
        {rule_nothing_seen, EFFECT_DEPTH_OF_FIELD, sees_no_sky},
        {rule_no_mirror, EFFECT_MIRROR, looks_at_first_material},
        {rule_no_lobe, EFFECT_GLOSSY, forgets_rough_glass}};

/* One of the scenes refutes a stage that looks for neighbours of glass nowhere. */
static bool noticed_neighbours(char *text)
{
    bool found = false, by_chance;
    for (size_t i = 0; i < proof_scenes && !found; i++) {
        proof q;
        if (!proof_begin(&q, i, text)) continue;
        plan p = plan_of(&q.s);
        for (size_t k = 0; q.e.near && k < q.s.shapes + q.s.places; k++)
            q.e.near[k].box = aabb_empty();
        if (p.effects & EFFECT_REFRACTION) found = proof_refutes(&q, &p, &by_chance);
        plan_free(&p), proof_end(&q);
    }
    return found;
}

/* Does this scene refute the plan by this table? Where both plans are one, it does not. */
static bool notices(proof *q, const plan *p, const plan_rule *table)
{
    bool by_chance;
    plan bad = plan_of_rules(&q->s, table);
    bool found = (bad.effects != p->effects || bad.declined != p->declined)
                 && proof_refutes(q, &bad, &by_chance);
    plan_free(&bad);
    return found;
}

/* Tables in which one rule always holds, and those with a hole: each is refuted by one of the
 * scenes of `make test`. Each is read once for all. */
static void test_holes(void)
{
    enum { hole_count = sizeof holes / sizeof *holes, tables = plan_rule_count + hole_count };
    static plan_rule table[tables][plan_rule_count];
    bool seen[tables] = {false};
    size_t left = tables;
    char *text = allocate(proof_room, 1);
    check(noticed_neighbours(text), "that glass has no neighbours is not noticed");
    for (size_t t = 0; t < tables; t++) {
        size_t i = t < plan_rule_count ? t : 0, h = t - plan_rule_count;
        memcpy(table[t], plan_rules, sizeof table[t]);
        while (t >= plan_rule_count && i < plan_rule_count
               && (plan_rules[i].effect != holes[h].effect
                   || plan_rules[i].holds != holes[h].rule)) i++;
        check(i < plan_rule_count, "hole %zu: no such rule", h);
        if (i < plan_rule_count) table[t][i].holds = t < plan_rule_count ? always : holes[h].holds;
    }
    for (size_t i = 0; i < proof_scenes && left > 0; i++) {
        proof q;
        if (!proof_begin(&q, i, text)) continue;
        plan p = plan_of(&q.s);
        for (size_t t = 0; t < tables; t++)
            if (!seen[t] && notices(&q, &p, table[t])) seen[t] = true, left--;
        plan_free(&p), proof_end(&q);
    }
    for (size_t t = 0; t < tables; t++)
        if (t < plan_rule_count)
            check(seen[t], "effect %x: that the rule '%s' always holds is not noticed",
                  plan_rules[t].effect, plan_rules[t].reason);
        else
            check(seen[t], "hole %zu is not noticed by %d scenes", t - plan_rule_count,
                  proof_scenes);
    free(text);
}

static void files(void)
{
    char sky[9 + 96] = "PF 4 2 -1\n";
    float pixel[24];
    for (int i = 0; i < 24; i++) pixel[i] = (float)(i % 7) / 4;
    put("roof.obj", "v -1 0 1\nv 1 0 1\nv 0 1 0\nv 0 0 -1\nf 1 2 3\nusemtl none\nf 1 3 4\n");
    put("library.mtl", "newmtl library\nKd .6\nKs .3\nNs 20\nillum 2\nnewmtl lamp\nKe 3\nKd .2\n"
        "illum 1\n");
    put("lit.nff", "l 0 3 4\nf 1 1 1 0.5 0 1 0 1\ns 0 0 0 0.2\n");
    FILE *out = fopen(in_directory("sky.pfm"), "wb");
    if (!out || fwrite(sky, 1, 10, out) != 10 || fwrite(pixel, 4, 24, out) != 24
        || fclose(out) != 0) abort();
}

int main(void)
{
    seconds_at_most(240);
    if (!mkdtemp(directory)) abort();
    files();
    test_promise();
    test_holes();
    remove_directory();
    return check_report("27_proof");
}
