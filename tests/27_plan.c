/* Tests of chapters/27_effects: what materials call for, the plan, the camera, the sky.
 *
 * Oracles: the table of (27.3) by hand; scenes with one effect each; projection of 02.
 */
#include "../chapters/27_effects/framing.h"
#include "../chapters/27_effects/lab/explain.h"
#include "../chapters/27_effects/files/effects_read.h"
#include "../chapters/27_effects/files/studio_read.h"
#include "../chapters/23_brdf/lab/reference.h"
#include "../common/random.h"
#include "check.h"

static random_stream rng;
static real uniform(void) { return 2 * random_next(&rng) - 1; }
static bool grey(vec3 a, double x) { return a.x == (real)x && a.y == (real)x && a.z == (real)x; }

static bool read_text(const char *text, studio *s)
{
    failure f = {0, ""};
    bool ok = studio_read_text(text, "t", NULL, s, &f);
    check(ok, "%s: %s", f.text, text);
    return ok;
}

/* ---- materials ---- */

static appearance look_of(const char *keys)
{
    studio s;
    char text[400];
    appearance a = {.excess = -1};
    snprintf(text, sizeof text, "material m\n%s\n", keys);
    if (!read_text(text, &s)) return a;
    a = appearance_of(&s.material[1]);
    studio_free(&s);
    return a;
}

/* (27.3), row by row; the numbers are sums and products of powers of two. */
static void test_appearance(void)
{
    static const struct {
        const char *keys;
        double flat, matte, highlight, mirror, glossy, through;
    } row[] = {
            {"Kd .5\nKs .25\nNs 9\nillum 0", .5, 0, 0, 0, 0, 0},
            {"Kd .5\nKs .25\nNs 9\nillum 1", 0, .5, 0, 0, 0, 0},
            {"Kd .5\nKs .25\nNs 9\nillum 10", 0, .5, 0, 0, 0, 0},
            {"Kd .5\nKs .25\nNs 9\nillum 2", 0, .5, .25, 0, 0, 0},
            {"Kd .5\nKs .25\nNs 9\nillum 8", 0, .5, .25, 0, 0, 0},
            {"Kd .5\nKs .25\nillum 2", 0, .5, 0, 0, 0, 0},
            {"Kd .5\nKs .25\nillum 3", 0, .5, 0, .25, 0, 0},
            {"Kd .5\nKs .25\nNs 1000\nillum 3", 0, .5, 0, .25, 0, 0},
            {"Kd .5\nKs .25\nNs 999\nillum 3", 0, .5, 0, 0, .25, 0},
            {"Kd .5\nKs .25\nNs 0\nillum 5", 0, .5, 0, 0, .25, 0},
            {"Kd .5\nKs .25\nillum 4\nd .5\nTf .5", 0, .25, 0, .25, 0, .1875},
            {"Kd .5\nKs .25\nNs 9\nillum 9\nd .25", 0, .125, .25, 0, 0, .5625},
            {"Kd .5\nKs .25\nillum 4", 0, .5, 0, .25, 0, 0},
            {"Kd .5\nKs .25\nillum 6", 0, 0, 0, .25, 0, .75},
            {"Kd .5\nKs .25\nillum 6\nTf .5\nNi 1.5", 0, .25, 0, .25, 0, .375},
            {"Kd .5\nKs .25\nillum 7\nTf .5\nNi 1.5", 0, .25, 0, 1, 0, .5},
            {"Kd .5\nKs .25\nillum 7\nTf .5", 0, .25, 0, 0, 0, .5},
            {"Kd .5\nKs .25\nillum 7\nTf 0\nNi 3\nNs 9", 0, .5, 0, 0, .25, 0},  /* (2/4)^2 */
            {"Kd .5\nKs .25\nNs 9\nillum 7\nTf .5\nNi 2\nroughness .5", 0, 0, 0, 1, 0, .5},
            {"Kd .5\nillum 7\nTf .5\nNi 2\nroughness 0", 0, .25, 0, 1, 0, .5},
            {"Kd .5\nKs .25\nNs 9", 0, .5, .25, 0, 0, 0},
            {"Kd .5\nd .5", 0, .25, 0, 0, 0, .5},
            {"Kd .5\nd .5\nillum 2", 0, .5, 0, 0, 0, 0},
            {"Ke 3\nillum 1", 0, 0, 0, 0, 0, 0},
            {"Ke 3\nKd .5\nillum 1", 0, .5, 0, 0, 0, 0}};
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        appearance a = look_of(row[i].keys);
        check(grey(a.flat, row[i].flat) && grey(a.m.kd, row[i].matte)
              && grey(a.m.ks, a.glossy ? row[i].glossy : row[i].highlight)
              && grey(a.m.mirror, row[i].mirror) && grey(a.m.through, row[i].through),
              "'%s': flat %g matte %g %s %g mirror %g through %g", row[i].keys,
              (double)a.flat.x, (double)a.m.kd.x, a.glossy ? "glossy" : "highlight",
              (double)a.m.ks.x, (double)a.m.mirror.x, (double)a.m.through.x);
        check(a.glossy || row[i].glossy == 0, "'%s': reflects all that is around", row[i].keys);
    }
    check(look_of("illum 7\nNi 2\nroughness .5").m.alpha == (real)0.25, "alpha, of roughness");
    check(look_of("Ks .5\nillum 5").fresnel && look_of("illum 7\nNi 1.5").fresnel, "Fresnel: 5, 7");
    check(!look_of("Ks 1\nillum 3").fresnel && !look_of("illum 7").fresnel, "not: 3, 7 with Ni 1");
    check(!look_of("Ks 0\nillum 5").fresnel, "black reflects nothing, at no angle");
    appearance bent = look_of("illum 6\nNi 1.5"), clear = look_of("illum 6");
    appearance sheet = look_of("illum 4\nNi 1.5\nd .5"), shut = look_of("illum 7\nNi 2\nTf 0");
    check(appearance_bends(&bent) && !appearance_bends(&clear) && !appearance_bends(&sheet),
          "bent by Ni in 6 and 7 only");
    check(appearance_body(&clear) && !appearance_body(&sheet) && !appearance_body(&shut),
          "a body: 6 and 7, if they let light through");
}

/* What a surface of this look gives back of an even light around it, by its own lobes: (23.4). The
 * mirror's, the lobe's and the highlight's shares are albedos if the lobe's own is at most 1. */
static double furnace(const appearance *a, double cosine)
{
    vec3 f = {1, 1, 1}, albedo = brdf_albedo(&a->lobe, (real)cosine);
    const material *m = &a->m;
    vec3 back = vmax(vmul(m->ks, albedo), m->mirror);  /* what mirrors has ks for points alone */
    vec3 rest = vadd(m->kd, m->through);
    if (a->fresnel && vzero(m->through)) {
        f = fresnel_schlick(a->glossy ? m->ks : m->mirror, (real)cosine);
        back = a->glossy ? vmul(f, albedo) : f;
        rest = vmul(rest, vrest(f));
    } else if (a->fresnel) {  /* of glass: R of the one, 1 - R of the other */
        return (double)real_max(vlargest(back), vlargest(rest));
    }
    return (double)vlargest(vadd(back, rest));
}

/* No channel gives back more than it gets, whatever the numbers and the angle; hues stay. */
static void test_energy(void)
{
    for (size_t i = check_count(1500); i-- > 0;) {
        mtl_material m = {.tf = {1, 1, 1}, .ni = 1 + random_next(&rng), .d = random_next(&rng),
                          .ns = pow((real)10, 4 * random_next(&rng)) - 1,
                          .illum = (int)(i % 12) - 1};
        m.kd = (vec3){2 * random_next(&rng), random_next(&rng), random_next(&rng)};
        m.ks = (vec3){random_next(&rng), 2 * random_next(&rng), random_next(&rng)};
        if (i % 2) m.tf = (vec3){random_next(&rng), random_next(&rng), 2 * random_next(&rng)};
        if (i % 5 == 0) m.ns = 1, m.kd = (vec3){0, 0, 0}, m.ks = (vec3){1, 1, 1};
        studio_material of = {.mtl = m, .classic = i % 13 == 0};
        of.said[MTL_NS].file = 1, of.said[MTL_KD].file = 1;
        appearance a = appearance_of(&of);
        for (int k = 0; k < 2; k++)  /* brdf_albedo is a mean of samples: within 2e-4 */
            check_at_most(furnace(&a, k ? 1 : (double)random_next(&rng)),
                          1 + 2e-4 + 20 * (double)real_epsilon, "illum %d, Ns %g: energy", m.illum,
                          (double)m.ns);
        bool ok = vfinite(a.m.kd) && a.m.kd.x >= 0 && a.m.through.x >= 0;
        if (!ok) check(false, "illum %d: not finite or below 0", m.illum);
    }
    appearance a = look_of("Kd .75 .5 0\nKs .75\nNs 9\nillum 2");
    check(a.excess == (real)1.5 && a.m.kd.x == (real)0.5 && a.m.ks.z == (real)0.5,
          "1.5 times too much: all divided by it");
}

/* ---- the plan ---- */

#define FLOOR "material floor\nKd .5\nillum 1\npolygon -5 0 5 5 0 5 5 0 -5 -5 0 -5\n"
#define BLACK "material black\nKd 0\nillum 1\nsphere 0 1 0 1\n"
#define POINT "light at 1 9 2 colour 9\n"
#define LAMP "material lamp\nKe 5\npolygon -1 9 -1 1 9 -1 1 9 1 -1 9 1\n"
#define SKY "environment .5 1\n"
#define BALL(keys) "material ball\n" keys "\nsphere 0 1 0 1\n"

static void test_effects(void)
{
    enum { H = EFFECT_HARD_SHADOWS, S = EFFECT_SOFT_SHADOWS, M = EFFECT_MIRROR, G = EFFECT_GLOSSY,
           R = EFFECT_REFRACTION, A = EFFECT_ABSORPTION, N = EFFECT_INDIRECT,
           E = EFFECT_ENVIRONMENT, D = EFFECT_DEPTH_OF_FIELD };
    const char *casting = "ray casting", *whitted = "Whitted ray tracing", *paths = "path tracing";
    const struct { const char *text; unsigned effects; const char *how; } list[] = {
        {"", 0, casting},
        {FLOOR, 0, casting},
        {FLOOR POINT BLACK, H, casting},
        {FLOOR "sun to 1 1 1 colour 1\n", H, casting},
        {FLOOR "light at 1 9 2 colour 0\n", 0, casting},
        {BLACK POINT, 0, casting},
        {POINT "material m\nKd 1\nillum 0\nsphere 0 0 0 1\n", 0, casting},
        {FLOOR BLACK LAMP, S, paths},
        {FLOOR BLACK LAMP POINT, S | H, paths},
        {FLOOR BLACK SKY, E, paths},
        {FLOOR "environment 0\n", 0, casting},
        {BALL("Kd 0\nKs 1\nillum 3"), M, whitted},
        {BALL("Kd 0\nKs 1\nillum 3") SKY, M, whitted},   /* it shows in the mirror */
        {BALL("Kd 0\nKs 1\nillum 3") POINT FLOOR, M | H | N, paths},
        {BALL("Kd 0\nKs 1\nillum 3") POINT FLOOR "indirect off\n", M | H, whitted},
        {BALL("Kd 0\nKs 1\nNs 50\nillum 3"), G, paths},
        {BALL("Kd 0\nKs 1\nNs 50\nillum 3") POINT, G | H, paths},
        {BALL("Kd 0\nKs 1\nNs 50\nillum 3") SKY, G | E, paths},
        {BALL("Kd 0\nNi 1.5\nillum 6"), R, whitted},
        {BALL("Kd 0\nNi 1.5\nillum 7"), R | M, whitted},
        {BALL("Kd 0\nNi 1.5\nillum 7\nroughness .1"), R | G, paths},
        {BALL("Kd 0\nNi 1.5\nillum 7\nroughness .1") POINT, R | G | H, paths},
        {BALL("Kd 0\nNi 1.5\nillum 7\nroughness .1") LAMP, R | G | S, paths},
        {BALL("Kd 0\nNi 1.5\nillum 7\nroughness 0"), R | M, whitted},
        {BALL("Kd 0\nillum 7"), R, whitted},             /* Ni 1 reflects nothing */
        {BALL("Kd 0\nNi 1.5\nabsorb 1 0 0\nillum 6"), R | A, whitted},
        {BALL("Kd 0\nd .5\nabsorb 1 0 0\nillum 4"), R, whitted},
        {BALL("Kd 0\nTf 0\nabsorb 1 0 0\nillum 6"), 0, casting},
        {FLOOR BALL("Kd .5\nillum 1") LAMP, S | N, paths},
        {FLOOR BALL("Kd 0\nKs 1\nillum 3") LAMP, S | N | M, paths},
        {FLOOR BALL("Kd .5\nillum 1") SKY, E | N, paths},
        {FLOOR BALL("Kd .5\nillum 1") POINT, H | N, paths},
        {"indirect off\n" FLOOR BALL("Kd .5\nillum 1") POINT, H, casting},
        {"indirect off\n" FLOOR BALL("Kd .5\nillum 1") LAMP, S, paths},
        {"indirect off\nindirect on\n" FLOOR BALL("Kd .5\nillum 1") POINT, H | N,
         paths},
        {FLOOR SKY, E, paths},                          /* one polygon */
        {FLOOR "polygon 9 0 0 9 1 1 8 0 1\n" SKY, E | N, paths},
        {"material m\nKd .5\nillum 1\npolygon -5 0 5 5 0 5 5 1 -5 -5 0 -5\n" SKY, E | N,
         paths},                                        /* bent: it sees itself */
        {FLOOR "solid black sphere 0 2 0 1\n" SKY, E | N, paths},  /* not looked into */
        {FLOOR POINT "lens radius .1\n", H | D, paths},
        {FLOOR POINT "lens radius 0\n", H, casting},
        {"lens radius 1\n", 0, casting},                /* one colour everywhere */
        {"lens radius 1\n" "environment 1\n", 0, casting},
        {"lens radius 1\n" SKY, D, paths},              /* E: nothing gathers it */
        {"lens radius 1\nsphere 0 0 0 1\n", D, paths},
        {FLOOR LAMP SKY POINT "lens radius .1\nmaterial a\nKd .1\nKs .2\nillum 3\nsphere 0 1 0 1\n"
         "material b\nKd .1\nKs .2\nNs 10\nillum 3\nsphere 3 1 0 1\nmaterial c\nNi 1.5\nillum 6\n"
         "absorb 1\nsphere 6 1 0 1\n", EFFECTS_ALL, paths},
        {"material unused\nKs 1\nillum 3\n" FLOOR POINT, H, casting}};
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        studio s;
        if (!read_text(list[i].text, &s)) continue;
        plan p = plan_of(&s);
        check(p.effects == list[i].effects, "effects %x, expected %x: %s", p.effects,
              list[i].effects, list[i].text);
        const char *how = integrator_of(p.effects);
        check(strcmp(how, list[i].how) == 0, "%s: %s", how, list[i].text);
        bool dark = !strstr(list[i].text, "colour 9") && !strstr(list[i].text, "colour 1")
            && !strstr(list[i].text, "lamp") && !strstr(list[i].text, SKY)
            && !strstr(list[i].text, "environment 1");
        check(studio_dark(&s) == dark, "a lamp of its own if no light is there: %s", list[i].text);
        for (int k = 0; k < effect_kinds; k++)
            check(explain_why(&p, k).text[0], "each effect has its reason");
        unsigned sum = p.effects & EFFECT_DEPTH_OF_FIELD;
        for (uint32_t m = 0; m < s.materials; m++)
            if (s.material[m].used) sum |= plan_calls(&p.facts.look[m]) & p.effects;
        check(sum == p.effects, "what materials have a part in: %x of %x", sum, p.effects);
        plan_free(&p), studio_free(&s);
    }
}

/* A reason ends with the line that it is about, if it is about one. */
static void test_reasons(void)
{
    static const struct { const char *text; int kind; const char *why; } list[] = {
        {"indirect off\n" FLOOR BALL("Kd 1") POINT, RAY_SCATTERED, "`indirect off` (t:1)"},
        {"\n\n" FLOOR "indirect off\n" BALL("Kd 1") POINT, RAY_SCATTERED, "`indirect off` (t:7)"},
        {BALL("Kd 0\nTr 0.5"), RAY_REFRACTED, "material 'ball' (t:3)"},
        {FLOOR POINT, RAY_TO_LAMP, "nothing in use emits light (Ke)"}};
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        studio s;
        if (!read_text(list[i].text, &s)) continue;
        plan p = plan_of(&s);
        check_text(explain_why(&p, list[i].kind).text, list[i].why, "%s", list[i].text);
        plan_free(&p), studio_free(&s);
    }
}

/* A mesh of two triangles, the first without a material, and a third material with none. */
static void test_finish(void)
{
    const vec3 corner[3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 4}};
    const uint32_t index[6] = {0, 1, 2, 2, 1, 0};
    const mesh_run run[2] = {{1, 0}, {2, 0}};
    affine at = affine_then(affine_scaling((vec3){2, 2, 2}), affine_translation((vec3){1, 2, 3}));
    studio s;
    failure f;
    vec3 lo, hi;
    at.z.y = -2;  /* askew: y' = 2 y - 2 z + 2 */
    studio_begin(&s);
    for (int i = 0; i < 3; i++) studio_add_material(&s, "m", (cite){0, 0});
    s.material[1].mtl.ke.x = 1;
    mesh m = {.v = allocate(3, sizeof *m.v), .vertices = 3, .triangles = 2, .runs = 2,
              .index = allocate(6, sizeof *m.index), .run = allocate(2, sizeof *m.run)};
    uint32_t *paint = allocate(2, sizeof *paint);
    memcpy(m.v, corner, sizeof corner), memcpy(m.index, index, sizeof index);
    memcpy(m.run, run, sizeof run), paint[0] = 1, paint[1] = 2;
    studio_place(&s, studio_add_mesh(&s, m, paint, 0, false), at, 3, (cite){0, 0});
    check(studio_finish(&s, &f), "finished");
    check(!s.material[0].used && s.material[1].used && !s.material[2].used && s.material[3].used,
          "in use: of the second triangle, and of the place for the first");
    check(s.emitters == 1 && s.emitter[0].place == 0 && s.emitter[0].index == 1, "what emits");
    check(studio_bounds(&s, &lo, &hi) && lo.x == 1 && lo.y == -6 && lo.z == 3 && hi.x == 3
          && hi.y == 4 && hi.z == 11, "the box of what was scaled and moved");
    studio_free(&s);
}

static void test_effects_option(void)
{
    static const struct { const char *text; unsigned called, mask; } list[] = {
        {"all", 1, 511}, {"none", 1, 0}, {"called", 5, 5}, {"hard,depth", 4, 257},
        {"called,-mirror", 5, 1}, {"all,-indirect,-soft", 0, 511 - 64 - 2}, {"-all,glossy", 3, 8}};
    failure f;
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        unsigned mask = list[i].called;
        check(effects_read(list[i].text, &mask, &f) && mask == list[i].mask, "%s: %x", list[i].text,
              mask);
    }
    unsigned mask = 0;
    check(!effects_read("hard,bogus", &mask, &f) && f.exit_code == 2 && strstr(f.text, "'bogus'")
          && strstr(f.text, "allowed: all"), "%s", f.text);
    check(!effects_read("", &mask, &f) && !effects_read("hard,", &mask, &f), "nothing: none");
}

/* ---- camera ---- */

/* Is the whole box in the picture, if the eye stands at `part` of its distance? */
static bool box_shows(studio_view v, real part, real aspect, vec3 lo, vec3 hi)
{
    camera_frame frame;
    camera c;
    failure f;
    v.from = vmadd(v.at, vsub(v.from, v.at), part);
    if (!frame_look_at(v.from, v.at, v.up, &frame, &f)
        || !camera_perspective(frame, v.angle, aspect, &c, &f)) return false;
    for (int k = 0; k < 8; k++) {
        vec3 q = {k & 1 ? hi.x : lo.x, k & 2 ? hi.y : lo.y, k & 4 ? hi.z : lo.z};
        real x, y;
        if (!camera_project(c, q, 1, 1, &x, &y) || x < 0 || x > 1 || y < 0 || y > 1) return false;
    }
    return true;
}

/* All of a random scene shows, and from no nearer would it. */
static void test_framing(void)
{
    static const char *const ups[] = {"up x\n", "up y\n", "up z\n"};
    for (size_t round = check_count(300); round-- > 0;) {
        char text[2000];
        size_t n = (size_t)sprintf(text, "%s", ups[round % 3]);
        real size = pow((real)10, 4 * uniform()), off = round % 2 ? 0 : 20 * size;
        vec3 p[6];
        for (int k = 0; k < 6; k++) {
            p[k] = (vec3){off + size * uniform(), size * uniform(), size * uniform()};
            p[k].z += off * uniform();
        }
        for (int k = 0; k < 2; k++) {
            n += (size_t)sprintf(text + n, "polygon");
            for (int j = 0; j < 3; j++)
                n += (size_t)sprintf(text + n, " %.17g %.17g %.17g", (double)p[3 * k + j].x,
                                     (double)p[3 * k + j].y, (double)p[3 * k + j].z);
            n += (size_t)sprintf(text + n, "\n");
        }
        studio s;
        studio_view v;
        camera c;
        failure f;
        real aspect = (const real[]){1, 2, 0.25}[round / 3 % 3];
        if (!read_text(text, &s)) continue;
        bool ok = studio_camera(&s, aspect, &v, &c, &f);
        check(ok, "%s", f.text);
        /* From 1/1.04 of the distance the box of all just fits: a thousandth nearer it does not. */
        vec3 lo = p[0], hi = p[0];
        for (int k = 1; k < 6; k++) lo = vmin(lo, p[k]), hi = vmax(hi, p[k]);
        check(ok && box_shows(v, 1, aspect, lo, hi), "all of it shows");
        check(ok && box_shows(v, (real)(1.001 / 1.04), aspect, lo, hi), "and a little nearer");
        check(ok && !box_shows(v, (real)(0.999 / 1.04), aspect, lo, hi), "but no nearer than that");
        check(v.up.x == (real)(round % 3 == 0) && v.up.y == (real)(round % 3 == 1), "up");
        studio_free(&s);
    }
}

static void test_odd_cameras(void)
{
    static const char *const fine[] = {"", "sphere 0 0 0 0\n", "sphere 5 5 5 0\n",
                                       "polygon 1 1 1 1 1 1 1 1 1\n", "sphere 0 0 0 1e15\n",
                                       "sphere 1e9 0 0 1e-9\n"};
    static const char *const bad[] = {"camera from 0 0 0 at 0 0 0\n",
                                      "camera from 0 1 0 at 0 0 0\n"};
    studio s;
    studio_view v;
    camera c;
    failure f;
    for (size_t i = 0; i < sizeof fine / sizeof *fine; i++)
        if (read_text(fine[i], &s)) {
            check(studio_camera(&s, 1, &v, &c, &f), "%s: %s", fine[i], f.text);
            studio_free(&s);
        }
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        if (read_text(bad[i], &s)) {
            check(!studio_camera(&s, 1, &v, &c, &f) && f.exit_code == 2
                  && strstr(f.text, "t:1: camera:"), "%s: %s", bad[i], f.text);
            studio_free(&s);
        }
    if (read_text("camera from 0 3 4 at 0 0 0\nlens radius 1\n", &s)) {
        check(studio_camera(&s, 1, &v, &c, &f) && studio_focus(&s, &v) == 5, "in focus: at");
        studio_free(&s);
    }
}

/* ---- sky ---- */

static void test_sky(void)
{
    effects_sky s = {.kind = SKY_IMAGE, .scale = 2};
    image im = image_new(8, 4);
    failure f;
    for (int y = 0; y < 4; y++)
        for (int x = 0; x < 8; x++)
            image_set(&im, x, y, vec(x, y, 1));
    if (!environment_of_image(&im, &s.picture, &f)) abort();
    image_free(&im);
    /* Up y: the middle of the picture is -z, its right half begins there, +x is at 3/4. */
    static const struct { int up; real turn; vec3 d; int x, y; } list[] = {
        {1, 0, {0.1, 0.1, -1}, 4, 1}, {1, 0, {-0.1, -0.1, -1}, 3, 2},
        {1, 0, {1, 0.1, -0.1}, 5, 1}, {1, 0, {-1, -0.1, -0.1}, 2, 2},
        {1, 0, {0.1, 5, -0.2}, 4, 0}, {1, 0, {-0.1, -9, -0.2}, 3, 3},
        {1, 0, {-1e-12, -9, -2e-12}, 3, 3},     /* straight down, where y is 4 */
        {1, 0, {0.1, -0.1, 9}, 7, 2}, {1, 0, {-0.1, 0.1, 9}, 0, 1},
        {2, 0, {0.1, 1, 0.1}, 4, 1},            /* z up: the middle is +y, then +x */
        {1, 90, {-1, 0.1, -0.1}, 4, 1},         /* turned about y: the middle is -x */
        {0, 0, {0.1, 1, -0.1}, 4, 1}};          /* x up: right = y x x = -z */
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        sky_aim(&s, list[i].up, list[i].turn);
        vec3 c = sky_radiance(&s, vscale(list[i].d, 3));
        bool ok = c.x == 2 * (real)list[i].x && c.y == 2 * (real)list[i].y && c.z == 2;
        check(ok, "direction %zu: pixel %g %g, expected %d %d", i, (double)c.x / 2, (double)c.y / 2,
              list[i].x, list[i].y);
    }
    check(vfinite(sky_radiance(&s, (vec3){0, 0, 0})), "no direction: any pixel");
    check(sky_lights(&s), "a picture that is not black lights");
    for (int k = 0; k < 4; k++) {
        effects_sky two = {.kind = SKY_GRADIENT, .low = {0, (real)(k & 1), 0},
                           .high = {0, 0, (real)(k >> 1)}};
        check_equal(sky_lights(&two), k > 0, "a gradient from dark to dark does not, %d", k);
    }
    sky_free(&s);
}

static bool never(const plan_facts *q, cite *line) { return (void)q, (void)line, false; }

/* Rules that are wrong may call for what no material has; the plan says so. */
static void test_wrong_rules(void)
{
    plan_rule rules[plan_rule_count];
    studio s;
    if (!read_text(FLOOR POINT, &s)) return;
    memcpy(rules, plan_rules, sizeof rules);
    for (size_t i = 0; i < plan_rule_count; i++)
        if (rules[i].effect & (EFFECT_MIRROR | EFFECT_GLOSSY)) rules[i].holds = never;
    plan p = plan_of_rules(&s, rules);
    check(p.effects & EFFECT_MIRROR && p.effects & EFFECT_GLOSSY, "called for by wrong rules");
    check_text(explain_why(&p, RAY_MIRRORED).text, "no material", "a mirror that is none");
    check_text(explain_why(&p, RAY_GLOSSY).text, "no material", "a lobe that is none");
    plan_free(&p), studio_free(&s);
}

int main(void)
{
    rng = random_start(27, 1, 0);
    return check_all("27_plan", test_appearance, test_energy, test_effects, test_reasons,
                     test_wrong_rules, test_finish, test_effects_option, test_framing,
                     test_odd_cameras, test_sky);
}
