/* 01's first.h: what ray.h says of the same points. Where both forms of a point fail: 01_ray.c. */
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
    test_degenerate();
    return check_report("01_first");
}
