/* Tests of chapter 27: the short book's first.h beside the full version: that a studio as first.h
 * has it has the same surfaces, that both see the same light where they must, and that they do not
 * where the page says so.
 */
#include "../chapters/27_effects/lab/six.h"
#include "../common/lab/t_test.h"
#include "check.h"

typedef struct {
    studio s;
    studio_view view;
    plan p;
    effects_stage e;
    first_scene f;
    const char *lacks;
} pair;

/* Lights the six scenes in place of the sun, about as bright: first.h has no sun, and in float what
 * stands for it is a hundredth off. */
#define NEAR_LIGHT "light at 6 4.4 8 colour 350\n"

static void pair_open(pair *q, const char *text)
{
    failure f;
    camera c;
    if (!studio_read_text(text, "test.scene", NULL, &q->s, &f)) fail(f);
    if (!studio_camera(&q->s, 4 / (real)3, &q->view, &c, &f)) fail(f);
    if (!effects_stage_build(&q->s, &q->e, &f)) fail(f);
    q->p = plan_of(&q->s);
    effects_stage_view(&q->e, &q->view, c);
    effects_stage_effects(&q->e, q->p.effects);
    q->lacks = first_of_studio(&q->s, &q->view, &q->f);
}

static void pair_close(pair *q)
{
    effects_stage_free(&q->e), plan_free(&q->p), studio_free(&q->s);
}

/* The text of scene k of the six with `line` in place of the line that begins with `word`. */
static void with_line(int k, const char *word, const char *line, char text[six_room])
{
    char from[six_room];
    six_text(k, from);
    const char *at = strstr(from, word), *end = strchr(at, '\n') + 1;
    snprintf(text, six_room, "%.*s%s%s", (int)(at - from), from, line, end);
}

/* ---- the same surfaces ---- */

static void test_surfaces(int k)
{
    pair q;
    char text[six_room];
    six_text(k, text);
    pair_open(&q, text);
    check(!q.lacks, "%s: first.h has %s", six_list[k].name, q.lacks ? q.lacks : "");
    size_t n = check_count(20000), met = 0, other = 0;
    for (size_t i = 0; i < n; i++) {
        random_stream r = random_start(1, i, (uint64_t)k);
        vec3 o, d;
        o.x = random_between(&r, -4, 4), o.y = random_between(&r, 0, 7);
        o.z = random_between(&r, -5, 8);
        d.x = random_between(&r, -1, 1), d.y = random_between(&r, -1, 1);
        d.z = random_between(&r, -1, 1);
        ray way = {o, (real)1e-3, vunit(d), real_infinity};
        hit a;
        studio_hit b;
        bool ha = first_scene_hit(&q.f, way, &a), hb = studio_tree_hit(&q.e.t, way, &b);
        met += hb;
        if (ha != hb) { other++; continue; }
        if (!ha) continue;
        const appearance *look = &q.e.look[studio_hit_material(&q.e.t, b)];
        const first_material *m = &q.f.thing[a.shape].m;
        bool glass = !vzero(look->through);
        other += fabs(a.t - b.h.t) > 1024 * real_epsilon * (1 + b.h.t) * (1 + b.h.t)
              || memcmp(&m->kd, &look->matte, sizeof m->kd) != 0
              || memcmp(&m->ke, &look->emits, sizeof m->ke) != 0
              || m->ior != (glass ? look->ior : 0)
              || (!glass && memcmp(&m->mirror, &look->mirror, sizeof m->mirror) != 0);
    }
    check_at_least((double)met, 0.4 * (double)n, "%s: rays that meet something", six_list[k].name);
    /* Rounding moves edges, and what rays meet that graze a plane: of 1000 one or two. Each thing
     * is met by more than ten. */
    check_at_most((double)other, 0.002 * (double)n,
                  "%s: rays of %zu that meet another surface", six_list[k].name, n);
    pair_close(&q);
}

/* ---- the same light ---- */

/* Of rays of the eye, the difference first - full, and the light that the full version sees. */
static estimate light_apart(const pair *q, size_t n, double *mean)
{
    enum { w = 64, h = 48 };
    estimate d = {0}, all = {0};
    first_plan p = first_plan_of(&q->f);
    effects_function *full = effects_made_for(q->e.mask);
    for (size_t i = 0; i < n; i++) {
        random_stream at = random_start(5, i, 0), random = random_start(6, i, 0);
        dice_pixel of;
        dice_pixel_of(7, i, true, &of);
        dice throws = dice_sample(&of, 0);
        effects_counts c = {.lost = 0};
        real x = random_between(&at, 0, w), y = random_between(&at, 0, h);
        ray r = camera_ray(q->e.eye, x, y, w, h);
        vec3 L = full(&q->e, r, (media_set){0}, &throws, &c);
        first_camera eye = first_studio_camera(&q->view, w, h);
        vec3 F = first_planned(&q->f, &p, first_ray_unit(first_camera_ray(eye, x, y)), true,
                               first_row_depth, &random);
        all = estimate_add(all, (double)(L.x + L.y + L.z) / 3);
        d = estimate_add(d, (double)((F.x + F.y + F.z) - (L.x + L.y + L.z)) / 3);
    }
    *mean = all.mean;
    return d;
}

/* least, most: of what first.h sees more, as a part of all, by six standard errors; 0, 0: nothing,
 * by a t-test that alarms falsely once in 1e7 seeds. Forgiven is what the sun's distance and the
 * eps of shadow rays bring, in double each 5e-7 of the whole, and the pixels' own contrast. */
static void test_light(const char *name, const char *text, double least, double most)
{
    pair q;
    double mean;
    pair_open(&q, text);
    check(!q.lacks, "%s: first.h has %s", name, q.lacks ? q.lacks : "");
    size_t n = check_count(200000);
    estimate d = light_apart(&q, n < 10000 ? 10000 : n, &mean);  /* fewer see nothing */
    bool sun = strstr(text, "sun ") != NULL;
    double rounding = (sun ? 1e-5 : 256 * (double)real_epsilon) * mean;
    check_at_most(estimate_error(d), 0.01 * mean, "%s: noise, too much to see anything", name);
    if (most > 0) {
        check_at_least(d.mean - 6 * estimate_error(d), least * mean, "%s: brighter by first.h",
                       name);
        check_at_most(d.mean + 6 * estimate_error(d), most * mean, "%s: by so much", name);
    } else check_at_least(t_test(d, 0, rounding), 1e-7, "%s: first.h sees %g of %g more", name,
                          d.mean, mean);
    pair_close(&q);
}

static void test_six(void)
{
    char text[six_room];
    for (int k = 0; k < 3; k++) {  /* point lights: no chance but the coin of first.h in glass */
        six_text(k, text);
        if (!real_is_float) test_light(six_list[k].name, text, 0, 0);
        with_line(k, "sun", NEAR_LIGHT, text);
        test_light("the same with a light that is near", text, 0, 0);
    }
    /* Lamp and walls: the same as long as nothing is behind them. */
    char room[six_room];
    with_line(4, "background", "background 0\n", room);
    const char *at = strstr(room, "sun"), *end = strchr(at, '\n') + 1;
    snprintf(text, sizeof text, "%.*s%s%s", (int)(at - room), room, NEAR_LIGHT, end);
    test_light("5_wall, black behind it", text, 0, 0);
    if (!real_is_float) test_light("5_wall, black behind it, and a sun", room, 0, 0);
    /* What MEASURED.md says: a background lights nobody; first.h passes it on by mirrors and glass.
     * And first.h cannot leave out what the scene declines. */
    with_line(4, "sun", NEAR_LIGHT, text);
    test_light("5_wall with its background", text, 0, 0.1);
    with_line(3, "sun", NEAR_LIGHT, text);
    test_light("4_lamp: indirect light is declined", text, 0.03, 0.2);
}

/* ---- what it has no word for ---- */

static void test_lacks(void)
{
#define EYE "camera from 0 1 5 at 0 1 0\n"
#define SUN EYE "sun to 1 2 3 colour 1\n"
    static const struct { const char *text, *lacks; } at[] = {
        {SUN "sphere 0 1 0 1 white\n", NULL}, {SUN "sphere 0 1 0 1 gold\n", NULL},
        {SUN "sphere 0 1 0 1 glass\n", NULL}, {SUN "sphere 0 1 0 1 brushed\n", "no lobe"},
        {SUN "sphere 0 1 0 1 frosted\n", "no lobe"},
        {SUN "sphere 0 1 0 1 bottle\n", "no glass but clear glass"},
        {SUN "sphere 0 1 0 -1 white\n", "no such shape"},
        {SUN "polygon 0 0 0  1 0 0  1 1 0 white\n", "no such shape"},
        {SUN "polygon 0 0 0  1 0 0  2 2 0  0 1 0 white\n", "no polygon but parallelograms"},
        {SUN "sphere 0 1 0 1 lamp\n", "no lamp but parallelograms"},
        {SUN "box 0 0 0 1 1 1 white\nlens radius 0.1\n", "no lens"},
        {SUN "environment 1\nsphere 0 1 0 1 white\n", "no light of the sky"},
        {EYE "sphere 0 1 0 1 white\n", "no headlight"},
        {EYE "polygon 0 3 0  1 3 0  1 3 1  0 3 1 lamp\nsphere 0 1 0 1 white\n", NULL},
        {EYE "polygon 0 3 0  0 3 1  1 3 1  1 3 0 lamp\nsphere 0 1 0 1 white\n", NULL},
        {EYE "polygon 0 3 0  0 3 1  1 3 1  1 3 0 lamp\nsphere 0 4 0 0.5 white\n",
         "no lamp with two sides"},
        {EYE "polygon 0 3 0  0 3 1  1 3 1  1 3 0 lamp\n"
         "polygon 0 4 0  0 4 1  1 4 1  1 4 0 lamp\n", "no second lamp"},
        {SUN "material unlit\nKd 1\nillum 0\nsphere 0 1 0 1\n", "no unlit surface"},
        {SUN "material both\nKd 0.5\nKs 0.4\nillum 3\nsphere 0 1 0 1\n", "no matte mirror"},
        {SUN "material water\nKd 0\nKs 0.1\nillum 5\nsphere 0 1 0 1\n", "no Fresnel but of glass"}};
    for (size_t i = 0; i < sizeof at / sizeof *at; i++) {
        pair q;
        pair_open(&q, at[i].text);
        const char *lacks = q.lacks ? q.lacks : "all", *due = at[i].lacks ? at[i].lacks : "all";
        check(strcmp(lacks, due) == 0, "scene %zu: first.h has %s, expected %s", i, lacks, due);
        if (!q.lacks && q.s.emitters)
            check(q.f.thing[0].n.y < 0 && !vzero(q.f.thing[0].m.ke), "scene %zu: the lamp shines "
                  "down, whichever way round its corners are", i);
        pair_close(&q);
    }
}

int main(void)
{
    for (int k = 0; k + 1 < six_count; k++) test_surfaces(k);
    test_six();
    test_lacks();
    return check_report("27_beside");
}
