/* Tests of chapters/27_effects: directions towards lamps and sky. What draws them and what says how
 * likely they were must agree, and a lamp must be drawn evenly.
 */
#include "../chapters/27_effects/lamps.h"
#include "../chapters/27_effects/sky_light.h"
#include "../chapters/27_effects/files/studio_read.h"
#include "../common/random.h"
#include "check.h"

/* (27.6) for the lamp that was drawn, whichever it was, against the pdf it was drawn with. */
static void test_pdf(const studio_tree *t, const lamp_list *l)
{
    double worst = 0;
    size_t spheres = 0, n = check_count(20000);
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(5, i, 0);
        real x = random_next(&s), y = random_next(&s), z = random_next(&s), u = random_next(&s);
        vec3 p = {6 * x - 3, 4 * y, 6 * z - 3};
        lamp_draw w;
        if (!lamps_sample(l, p, (vec3){0, 1, 0}, (point2){u, random_next(&s)}, &w)) continue;
        const shape *ball = t->s->shape;  /* the first; all that shine are told apart by Ke */
        bool is_ball = w.Le.y > 0;
        vec3 to = vsub(w.s.p, p);
        real pdf = lamps_pdf(l, w.Le, is_ball ? ball : NULL, p, w.wi, vlength(to),
                             -vdot(w.s.n, w.wi));
        spheres += is_ball, worst = check_worse(worst, fabs((double)(pdf / w.pdf) - 1));
    }
    check_at_least(spheres, n / 20, "times the ball was drawn");
    check_at_least(n - spheres, n / 20, "times others were");
    check_at_most(worst, 16 * (double)real_epsilon, "pdf of what was drawn: a dozen roundings");
}

/* Below height s of a cone lies (2 ra + (rb - ra) s) s / (ra + rb) of its side: that is u. */
static void test_cone(void)
{
    cone c = {.a = {1, 2, 3}, .b = {2, 4, 5}, .ra = 0.25, .rb = 1};
    lamp_list l = {.face = NULL};
    vec3 axis = vsub(c.b, c.a);
    double worst = 0, seen = 0;
    lamps_add_cone(&l, c, (vec3){1, 1, 1});
    check_close((double)l.face[0].e.area, (double)pi * 1.25 * sqrt(9 + 0.5625),
                8 * (double)real_epsilon * 12, "its side: pi (ra + rb) times the slanted height");
    for (int i = 0; i < 400; i++) {
        emitter_point x;
        point2 u = {((real)i + (real)0.5) / 400, (real)(i % 7) / 7};
        if (!lamps_cone(&l.face[0], (vec3){-4, 20, 1}, u, &x)) continue;
        double s = (double)(vdot(vsub(x.s.p, c.a), axis) / vdot(axis, axis));
        worst = check_worse(worst, fabs(s * (0.5 + 0.75 * s) / 1.25 - (double)u.u)), seen++;
    }
    check_at_least(seen, 100, "points of the cone that face p");
    check_at_most(worst, 64 * (double)real_epsilon, "share of the side below the point drawn");
    lamps_free(&l);
}

/* A direction drawn by the picture has the light and the pdf that a ray there finds. */
static void test_sky(void)
{
    effects_sky s = {.kind = SKY_IMAGE, .scale = 2, .picture = image_new(8, 4), .up = {0, 1, 0},
             .front = {0.6, 0, -0.8}, .right = {0.8, 0, 0.6}};
    failure f;
    sky_light l;
    size_t seen = 0, other = 0, likely = 0;
    for (int i = 0; i < 32; i++)
        image_set(&s.picture, i % 8, i / 8, vec((1 + i), (40 - i), 1));
    check(sky_light_build(&s, &l, &f), "%s", f.text);
    for (int i = 0; i < 4000; i++) {
        random_stream r = random_start(6, (uint64_t)i, 0);
        sky_draw x;
        real u = random_next(&r);
        if (!sky_light_sample(&l, (vec3){0, i % 2 ? 1 : -1, 0}, (point2){u, random_next(&r)}, &x))
            continue;
        vec3 L = sky_radiance(&s, x.wi);
        seen++, other += vlength(vsub(L, x.L)) > 8 * real_epsilon * vlength(L);
        likely += !(fabs(sky_light_pdf(&l, x.wi, 1) - x.pdf) <= 64 * real_epsilon * x.pdf);
    }
    check_at_least(seen, 1500, "directions in the half that n looks into");
    check_at_most((double)other, real_is_float ? 2 : 0, "with another light: at edges of pixels");
    check_at_most((double)likely, real_is_float ? 2 : 0, "with another pdf");
    sky_light_free(&l), image_free(&s.picture);
}

int main(void)
{
    failure f;
    studio s;
    studio_tree t;
    lamp_list l;
    if (!studio_read_text("material ball\nKe 1 2 0\nsphere 0 6 0 0.5\nmaterial others\nKe 3 0 1\n"
                          "polygon -1 5 1  1 5 1  1 5 -1  -1 5 -1\ncone 2 5 0 0.2  3 5 1 0.4\n"
                          "polygon -2 5 0  -1.5 5.5 0  -2 6 0\n", "lamps", NULL, &s, &f)) fail(f);
    if (!studio_tree_build(&s, &t, &f)) fail(f);
    lamps_build(&t, &l);
    lamps_add(&l, (lamp_face){.e = {.area = 0}});
    lamps_add(&l, (lamp_face){.e = {.area = real_infinity}});
    check_equal((double)l.n, 4, "lamps, all of some area");
    test_pdf(&t, &l);
    test_cone();
    test_sky();
    lamps_free(&l), studio_tree_free(&t), studio_free(&s);
    return check_report("27_lamps");
}
