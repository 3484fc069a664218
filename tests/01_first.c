/* 01's first.h: what ray.h says of the same points, and where both forms of a point fail. */
#include "../chapters/01_ray/ray.h"
#include "../common/numbers/wide.h"
#include "../common/random.h"
#include "check.h"

static const double eps = (double)real_epsilon;

static double apart(vec3 a, vec3 b) { return (double)vlength(vsub(a, b)); }

/* |computed - ((1 - t) a + t b)|, exactly, along x */
static double off(real computed, real a, real b, real t)
{
    wide wa = wide_of((double)a), d = wide_sub(wide_of((double)b), wa);
    wide exact = wide_add(wa, wide_mul(wide_of((double)t), d));
    return fabs(wide_value(wide_sub(wide_of((double)computed), exact)));
}

/* Points, directions and t below 1: each form is right within some roundings of numbers below 2. */
static void test_easy(void)
{
    double at = 0, between = 0, unit = 0;
    size_t interval = 0, depth = 0, n = check_count(100000);
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(1, i, 0);
        vec3 a = random_in_cube(&s, 1), b = random_in_cube(&s, 1);
        real t = random_next(&s), tmin = random_next(&s), tmax = random_next(&s);
        ray r = ray_between(a, b), whole = ray_from(a, b);
        at = check_worse(at, apart(ray_at(r, t), ray_at_fused(r, t)));
        between = check_worse(between, off(ray_at_between(a, b, t).x, a.x, b.x, t));
        interval += r.tmin != 0 || r.tmax != 1 || whole.tmin != 0 || whole.tmax != real_infinity;
        r.tmin = tmin, r.tmax = tmax;
        interval += ray_covers(r, t) != !(t < tmin || t > tmax);
        vec3 eye = vec(0, a.y, 0);
        depth += ray_at(ray_between(eye, vec(b.x, b.y, -1)), 9 * t).z != -(9 * t);
        ray u = first_ray_unit(r), v = ray_unit(r);
        unit = check_worse(unit, apart(u.d, v.d) + apart(u.o, v.o));
        interval += u.tmin != v.tmin || u.tmax != v.tmax;
    }
    check_at_most(at, 4 * eps, "o + t d against the fused step, of %zu", n);
    check_at_most(between, 2 * eps, "(1 - t) a + t b against wide numbers");
    check_at_most(unit, 4 * eps, "first_ray_unit against ray_unit");
    check_equal(depth, 0, "d.z = -1, as in first.c: t is the depth, exactly");
    check_equal(interval, 0, "intervals, of %zu", n);
    ray r = ray_from((vec3){0, 0, 0}, (vec3){1, 0, 0});
    check(ray_covers(r, 0) && ray_covers(r, real_infinity) && !ray_covers(r, (real)NAN),
          "closed at both ends; a NaN is in no interval");
}

/* "(1.1) loses digits as t grows": from |a| = 1e4, ten times t is ten times the error, until it is
 * a factor of 1e4 above that of (1.2). */
static void test_between_fails_far_out(void)
{
    double worst[5], plain[5];
    real t = 1;
    for (int k = 0; k < 5; k++, t *= 10) {
        worst[k] = plain[k] = 0;
        for (uint64_t i = 0; i < 1000; i++) {
            real a = 10000 + random_real(2, i, 0, 0), b = a + random_real(2, i, 1, 0);
            real s = t * (1 + random_real(2, i, 2, 0));
            vec3 p = ray_at_between((vec3){a, 0, 0}, (vec3){b, 0, 0}, s);
            ray r = ray_between((vec3){a, 0, 0}, (vec3){b, 0, 0});
            worst[k] = check_worse(worst[k], off(p.x, a, b, s));
            plain[k] = check_worse(plain[k], off(ray_at(r, s).x, a, b, s));
        }
    }
    for (int k = 2; k < 5; k++)
        check_at_least(worst[k], 5 * worst[k - 1], "t = 1e%d: ten times the error", k);
    check_at_least(worst[4], 1e3 * plain[4], "(1.1) against (1.2) at t = 1e4");
}

/* "far from the origin (1.2) has steps as o has": where neighbouring reals are 8 apart, a ray knows
 * 8 points on a way of 64; its far end is off by up to 4. */
static void test_steps_far_from_the_origin(void)
{
    real far = 8 / real_epsilon;
    ray r = ray_from((vec3){far, far, far}, (vec3){1, 1, 1});
    int points = 0;
    double worst = 0;
    for (int i = 0; i < 64 * 64; i++) {
        real t = (real)i / 64, next = (real)(i + 1) / 64;
        vec3 p = ray_at(r, t);
        points += p.x != ray_at(r, next).x;
        worst = check_worse(worst, fabs((double)(p.x - far - t)));
    }
    check_equal(points, 8, "points on 64 units of the way");
    check_equal(worst, 4, "half a step");
}

/* Defined, if useless: no direction has no unit. */
static void test_degenerate(void)
{
    ray none = first_ray_unit(ray_from((vec3){1, 2, 3}, (vec3){0, 0, 0}));
    check(!vfinite(none.d), "no direction: no unit of it, where ray_unit gives zero");
    check(vzero(ray_unit(ray_from((vec3){1, 2, 3}, (vec3){0, 0, 0})).d), "ray_unit gives zero");
    check(!vfinite(first_ray_unit(ray_from((vec3){1, 2, 3}, (vec3){(real)NAN, 0, 0})).d), "NaN");
}

int main(void)
{
    test_easy();
    test_between_fails_far_out();
    test_steps_far_from_the_origin();
    test_degenerate();
    return check_report("01_first");
}
