/* 26's first.h: its pictures against path.h's on the same walls, its
 * roulette, its noise, its options. Fixed seeds; a comparison alarms falsely once in 1e8 seeds. */
#include "program.h"
#include "../common/lab/t_test.h"
#include "../chapters/24_direct_light/scenes/lit_first.h"
#include "../chapters/26_path_tracer/first.h"
#include "../chapters/26_path_tracer/lab/measure.h"
#include "../chapters/26_path_tracer/path.h"
#include "check.h"
#include "first_cube.h"

static const double false_alarm = 1e-8;
static const double sigmas = 5.8;

/* Two estimates of the same number. */
#define check_same(a, b, ...) \
    check_close((a).mean, (b).mean, sigmas * hypot(estimate_error(a), estimate_error(b)), \
                __VA_ARGS__)

/* ---- the Cornell box, 4 x 4 regions ---- */

enum { across = 4, regions = across * across };
typedef struct { estimate e[regions][3]; } picture;

static int region_of(point2 u) { return (int)(u.v * across) * across + (int)(u.u * across); }

static void seen(picture *p, point2 u, vec3 L)
{
    for (int k = 0; k < 3; k++) {
        estimate *e = &p->e[region_of(u)][k];
        *e = estimate_add(*e, (double)vaxis(L, k));
    }
}

static point2 eye_point(uint64_t i)
{
    return (point2){random_real(1, i, 0, 0), random_real(1, i, 0, 1)};
}

static ray eye_ray(point2 u) { return first_camera_ray(first_cornell_camera(1, 1), u.u, u.v); }

static void by_first(picture *p, size_t n)
{
    first_scene s = first_cornell();
    for (size_t i = 0; i < n; i++) {
        random_stream random = random_start(2, i, 0);
        point2 u = eye_point(i);
        seen(p, u, first_path(&s, eye_ray(u), &random));
    }
}

static void by_path(picture *p, const lit_scene *s, size_t n)
{
    path_tracer t;
    path_counts c = {0};
    path_options how = path_defaults;
    how.sequence = SEQUENCE_RANDOM;  /* independent samples, for the t-test */
    path_tracer_of(s, NULL, how, &t);
    for (size_t i = 0; i < n; i++) {
        path_random random = path_start(&t.how, 3, i, 0, 1);
        point2 u = eye_point(i);
        seen(p, u, path_radiance(&t, eye_ray(u), &random, &c));
    }
    path_tracer_free(&t);
}

/* Region by region and channel by channel, 48 comparisons; in all to 1 % or so. */
static void test_picture(void)
{
    static picture a, b;
    size_t n = check_count(200000);
    first_scene f = first_cornell();
    lit_scene s;
    lit_first(&f, &s);
    by_first(&a, n), by_path(&b, &s, n);
    estimate whole[2][3] = {{{0, 0, 0}}};
    for (int i = 0; i < regions; i++)
        for (int k = 0; k < 3; k++) {
            check_same(a.e[i][k], b.e[i][k], "region %d, channel %d", i, k);
            whole[0][k] = estimate_merge(whole[0][k], a.e[i][k]);
            whole[1][k] = estimate_merge(whole[1][k], b.e[i][k]);
        }
    for (int k = 0; k < 3; k++) {
        double error = hypot(estimate_error(whole[0][k]), estimate_error(whole[1][k]));
        check_same(whole[0][k], whole[1][k], "the whole picture, channel %d", k);
        check_at_most(error, 15 / sqrt((double)n) * whole[1][k].mean, "the noise of both");
    }
    lit_free(&s);
}

/* ---- one point, and what roulette does ---- */

static ray wall_ray(void) { return eye_ray((point2){(real)0.2, (real)0.12}); }  /* the ceiling */

static estimate ceiling(size_t n, uint64_t seed)
{
    estimate e = {0, 0, 0};
    first_scene s = first_cornell();
    for (size_t i = 0; i < n; i++) {
        random_stream random = random_start(seed, i, 0);
        e = estimate_add(e, (double)first_path(&s, wall_ray(), &random).y);
    }
    return e;
}

/* The same function with another q: all of first.h but the chance to go on. */
static vec3 shade_with(const first_scene *s, first_point x, real q, int *hits,
                       random_stream *random)
{
    vec3 L = first_direct_by_lamp(s, 0, x, random);
    hit h;
    ++*hits;
    if (random_next(random) >= q) return L;
    ray r = first_bounce(s, x, random);
    if (!first_scene_hit(s, r, &h)) return L;
    vec3 Li = shade_with(s, first_point_at(s, r, h), q, hits, random);
    return vadd(L, vscale(vmul(x.kd, Li), 1 / q));
}

static void test_roulette(void)
{
    static const double q[] = {0.3, 0.6, 0.9};
    first_scene s = first_cornell();
    size_t n = check_count(80000);
    estimate own = ceiling(n, 6);
    hit h;
    check(first_scene_hit(&s, wall_ray(), &h), "the ceiling is seen");
    first_point x = first_point_at(&s, wall_ray(), h);
    for (int k = 0; k < 3; k++) {
        estimate e = {0, 0, 0};
        for (size_t i = 0; i < n; i++) {
            random_stream random = random_start(7 + (uint64_t)k, i, 0);
            int hits = 0;
            e = estimate_add(e, (double)shade_with(&s, x, (real)q[k], &hits, &random).y);
        }
        check_same(own, e, "q = %g", q[k]);
    }
}

/* Without a light sample and without dice: the same light, far more noise. Forty hits suffice: no
 * wall reflects more than .78, and .78^40 < 1e-4. After one hit the ceiling is black. */
static void test_by_luck(void)
{
    first_scene s = first_cornell();
    size_t n = check_count(80000);
    random_stream one = random_start(14, 0, 0);
    estimate own = ceiling(n, 12), luck = {0, 0, 0};
    for (size_t i = 0; i < n; i++) {
        random_stream random = random_start(13, i, 0);
        luck = estimate_add(luck, (double)first_path_by_luck(&s, wall_ray(), 40, &random).y);
    }
    check_same(own, luck, "by luck");
    check(vzero(first_path_by_luck(&s, wall_ray(), 1, &one)), "one hit of the ceiling");
    check_at_least(estimate_variance(luck), 10 * estimate_variance(own), "and the noise");
}

/* ---- a closed room that loses nothing: light without end, paths with one ---- */

/* Hits of a path: P(n) = q^(n-1) (1 - q), on average 1 / (1 - q) = 5, more than 93 with the
 * probability q^93 = 1e-9. The recursion is as deep as that. With albedo 1 the light grows without
 * end; each path ends. */
static void test_ends(void)
{
    first_scene s = first_cube(0, (first_material){.kd = {1, 1, 1}}, (vec3){1, 1, 1}, (real)1e-5);
    estimate hits = {0, 0, 0};
    int most = 0;
    bool finite = true;
    ray r = ray_from(vec(0, 0, 0), vec(1, 0.2, 0.3));
    hit h;
    check(first_scene_hit(&s, r, &h), "the room is closed");
    first_point x = first_point_at(&s, r, h);
    for (size_t i = 0; i < check_count(200000); i++) {
        random_stream a = random_start(8, i, 0), b = a;
        int n = 0;
        vec3 L = shade_with(&s, x, (real)first_go_on, &n, &a), own = first_path_shade(&s, x, &b);
        finite = finite && vfinite(L) && L.x == own.x && L.y == own.y && L.z == own.z;
        hits = estimate_add(hits, n);
        most = n > most ? n : most;
    }
    check(finite, "finite, and the same as this test's own copy of it");
    check_at_least(t_test(hits, 5, 0), false_alarm, "hits of a path: %g", hits.mean);
    check_at_most(most, 1 + log(1e-14) / log(0.8), "the longest path");
    check_close(pow(first_go_on, 93), 1e-9, 1e-10, "one path in 1e9 has more than 93 hits");
}

/* "noisy close to a lamp": a wall that shines stands on the floor, a hundredth off. path.h, which
 * takes both ways to it, sees the same with less than a hundredth of the variance. */
static void test_close_to_a_lamp(void)
{
    first_scene f = {.eps = (real)1e-5};
    first_material grey = {.kd = vec(0.5, 0.5, 0.5)}, lamp = {.ke = vec(1, 1, 1)};
    first_add_flat(&f, vec(0.01, -1, 0), vec(0, 0, 2), vec(0, 2, 0), lamp);
    first_add_flat(&f, vec(-2, -2, 0), vec(4, 0, 0), vec(0, 4, 0), grey);
    lit_scene s;
    path_tracer t;
    path_counts c = {0};
    path_options how = path_defaults;
    how.sequence = SEQUENCE_RANDOM;
    lit_first(&f, &s);
    path_tracer_of(&s, NULL, how, &t);
    ray r = ray_from(vec(-1, 0, 1), vec(1, 0, -1));
    estimate a = {0, 0, 0}, b = a;
    for (size_t i = 0; i < check_count(200000); i++) {
        random_stream random = random_start(10, i, 0);
        path_random q = path_start(&t.how, 11, i, 0, 1);
        a = estimate_add(a, (double)first_path(&f, r, &random).y);
        b = estimate_add(b, (double)path_radiance(&t, r, &q, &c).y);
    }
    check_same(a, b, "close to a lamp, on average");
    check_at_least(estimate_variance(a), 100 * estimate_variance(b), "and the noise");
    path_tracer_free(&t), lit_free(&s);
}

static void test_odd_input(void)
{
    first_scene empty = {.eps = (real)1e-5}, s = first_cornell();
    random_stream random = random_start(9, 0, 0);
    ray r = wall_ray();
    check(vzero(first_path(&empty, r, &random)), "an empty scene is black");
    r.d = vec((double)NAN, 0, 0);
    check(vzero(first_path(&s, r, &random)), "a ray of NaN meets nothing");
    r.d = vec(0, 0, 0);
    check(vzero(first_path(&s, r, &random)), "a ray without direction meets nothing");
}

/* What counts its rays goes its way: as many numbers are drawn. Of five a hit the last has three if
 * it ends the path, or five, if it leads out of the box; a ray to the lamp is sent or is not. */
static void test_rays(void)
{
    first_scene s = first_cornell(), open = s;
    size_t other = 0, wrong = 0, shadow = 0, hits = 0;
    open.eps = 1;
    for (size_t i = 0; i < check_count(20000); i++) {
        random_stream a = random_start(4, i, 0), b = a;
        ray r = eye_ray(eye_point(i));
        size_t rays = measure_first_rays(&s, &open, r, &a);
        first_path(&s, r, &b);
        size_t drawn = (size_t)b.dimension, on = drawn / 5, all = on + (drawn % 5 != 0);
        other += a.dimension != b.dimension;
        wrong += rays < 1 + on || rays > 1 + on + all;
        shadow += rays - 1 - on, hits += all;
    }
    check_equal(other, 0, "paths that drew other numbers");
    check_equal(wrong, 0, "paths with other rays");
    check_at_least(shadow, hits / 2, "of the hits most see the lamp's front");
    check_at_most(shadow, hits - hits / 20, "not the ceiling");
}

/* ---- the program ---- */

static void test_program(void)
{
    static const char *const bad[] = {"0", "65537", "1e3", "99999999999999999999", "4 a.png b.png",
                                      "-1", "abc", "4 abc", "+4", "''"};
    for (int k = 0; k < 10; k++) {
        check_equal(run("26_path_tracer_first", bad[k]), 2, "%s", bad[k]);
        check(printed("err", "26_path_tracer_first: "), "%s: names the program", bad[k]);
    }
    check_equal(run("26_path_tracer_first", "4 @b.png"), 0, "4 samples");
    check(printed("out", "b.png"), "it says where its picture is");
    check_equal(run("26_path_tracer_first", "1"), 0, "1 sample");
    check(printed("out", "-> build/26_path_tracer_first.png"), "not into images/");
    remove_directory();
}

int main(void)
{
    check(mkdtemp(directory), "a directory");
    return check_all("26_first", test_picture, test_roulette, test_by_luck, test_ends,
                     test_close_to_a_lamp, test_odd_input, test_rays, test_program);
}
