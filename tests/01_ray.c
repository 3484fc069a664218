/* 01_ray: both forms against exact arithmetic, intervals, units of t, transforms, field order. */
#include "../chapters/01_ray/affine.h"
#include "../chapters/01_ray/hit.h"
#include "../chapters/01_ray/lab/points.h"
#include "../common/numbers/wide.h"
#include "../common/random.h"
#include "check.h"

static const double epsilon = (double)real_epsilon;

static real random_power(random_stream *s, real most) { return pow(most, random_next(s)); }

/* |computed - (a + t d)|, exactly, in one coordinate */
static double off(real computed, wide a, wide d, real t)
{
    wide exact = wide_add(a, wide_mul(wide_of((double)t), d));
    return fabs(wide_value(wide_sub(wide_of((double)computed), exact)));
}

/* The bounds that ray.h states, over |o| and t from 1 to 1e8. The worst ratio of error to bound
 * shows that the bound is close, too: a bound that nothing comes near to would be idle. */
static void test_error_bounds(void)
{
    double plain = 0, fused = 0, between = 0;
    for (size_t i = 0; i < check_count(1000000); i++) {
        random_stream s = random_start(1, i, 0);
        vec3 o = random_in_cube(&s, random_power(&s, 100000000)), d = random_in_cube(&s, 1);
        vec3 b = vadd(o, d);
        real t = random_power(&s, 100000000);
        ray r = ray_from(o, d);
        real p = ray_at(r, t).x, f = ray_at_fused(r, t).x, q = ray_at_between(o, b, t).x;
        wide wo = wide_of((double)o.x), wb = wide_of((double)b.x);
        double td = fabs((double)t * (double)d.x), far = fabs((double)o.x);
        plain = check_worse(plain, off(p, wo, wide_of((double)d.x), t) / (epsilon * (far + td)));
        double fused_off = off(f, wo, wide_of((double)d.x), t);
        fused = check_worse(fused, fused_off / (epsilon * fabs((double)f)));
        double size = fabs((1 - (double)t) * far) + fabs((double)t * (double)b.x);
        between = check_worse(between, off(q, wo, wide_sub(wb, wo), t) / (1.5 * epsilon * size));
    }
    /* 1 + 4 eps: second order terms, which the stated bounds leave out */
    check_at_most(plain, 1 + 4 * epsilon, "o + t d is within epsilon (|o| + |t d|)");
    check_at_least(plain, 0.5, "the bound of o + t d is not idle");
    check_at_most(fused, 0.5 + 4 * epsilon, "a fused step is within half an epsilon of |p|");
    check_at_least(fused, 0.25, "the bound of the fused step is not idle");
    check_at_most(between, 1 + 4 * epsilon, "(1-t) a + t b is within its bound");
    check_at_least(between, 0.4, "the bound of (1-t) a + t b is not idle");
}

static void test_ends(void)
{
    size_t missed = 0, wrong_a = 0, wrong_b = 0;
    for (size_t i = 0; i < 1000; i++) {
        random_stream s = random_start(2, i, 0);
        vec3 a = random_in_cube(&s, random_power(&s, 1000)), b = random_in_cube(&s, 1);
        vec3 p = ray_at_between(a, b, 0), q = ray_at_between(a, b, 1);
        vec3 r = ray_at(ray_between(a, b), 1);
        wrong_a += p.x != a.x || p.y != a.y || p.z != a.z;
        wrong_b += q.x != b.x || q.y != b.y || q.z != b.z;
        missed += r.x != b.x || r.y != b.y || r.z != b.z;
    }
    check_equal(wrong_a, 0, "(1-t) a + t b is a at t = 0");
    check_equal(wrong_b, 0, "(1-t) a + t b is b at t = 1");
    check_at_least(missed, 100, "o + t d, d = b - a rounded, misses b in the last bits");
}

/* The lines of the page's table use all digits of a number, so (1.2) rounds at t = 1, too. Where o
 * and d are multiples of 2^-10, as random numbers are of 2^-53, it is exact there, by accident. */
static vec3 on_grid(vec3 a)
{
    return vec(floor(a.x * 1024) / 1024, floor(a.y * 1024) / 1024, floor(a.z * 1024) / 1024);
}

static void test_error_at_one(void)
{
    ray_line l[100], coarse[100];
    const real far[] = {1, 10000, 100000000};
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < 100; i++) {
            l[i] = ray_line_at(1, (uint64_t)i, far[k]);
            vec3 o = l[i].o, d = l[i].d;
            coarse[i] = l[i];
            coarse[i].o = on_grid(o), coarse[i].d = on_grid(d);
            check_close(vlength(o) / far[k], 1, 4 * epsilon, "|o| = %g", (double)far[k]);
            check_close(vlength(d), 1, 4 * epsilon, "|d| = 1");
        }
        double e = ray_error_rms(l, 100, 1, RAY_FIRST, 1);
        check_at_least(e, 0.05 * epsilon * (double)far[k], "(1.2) rounds at t = 1");
        check_at_most(e, epsilon * (double)far[k], "by less than an epsilon of |o|");
        check_equal(ray_error_rms(l, 100, 1, RAY_BETWEEN, 1), 0, "(1.1) is exact there");
        if (k == 0) check_equal(ray_error_rms(coarse, 100, 1, RAY_FIRST, 1), 0, "by accident");
    }
}

/* Far behind b the two products of (1.1) are t |a| and cancel: the error grows with t and |a|, that
 * of (1.2) with the larger of them. */
static void test_form_far_out(void)
{
    vec3 a = {10000.3, 0, 0}, b = vadd(a, vec(0.7, 0, 0));
    wide wa = wide_of((double)a.x), d = wide_sub(wide_of((double)b.x), wa);
    real t = 12345;
    double naive = 0, robust = 0;
    for (int i = 0; i < 100; i++, t += (real)7.3) {
        naive = check_worse(naive, off(ray_at_between(a, b, t).x, wa, d, t));
        robust = check_worse(robust, off(ray_at(ray_between(a, b), t).x, wa, d, t));
    }
    /* each product is off by up to epsilon/2 t |A|: of a hundred the worst by a fifth of that */
    check_at_least(naive, 0.1 * epsilon * 12345 * 10000, "(1-t) a + t b loses a factor of t or so");
    check_at_most(robust, epsilon * 2e4, "o + t d stays within epsilon (|o| + |t d|)");
}

static void test_float_staircase(void)
{
    size_t distinct = 0;
    for (int i = 0; i < 64; i++)
        distinct += at_f32(1e8f, 1, (float)i) != at_f32(1e8f, 1, (float)(i + 1));
    check_equal(distinct, 8, "from 1e8 to 1e8 + 64 float knows 8 steps of 8");
    check_equal(at_f32(16777216, 1, 1), 16777216.0f, "2^24 + 1 is no float: the ray stands still");
    float u = 1 + FLT_EPSILON;  /* u u = 1 + 2 eps + eps^2: float drops the last term */
    check_equal(at_f32(-1 - 2 * FLT_EPSILON, u, u), 0.0f, "product and sum are rounded one by one");
    size_t missed = 0;
    for (uint64_t i = 0; i < 1000; i++) {
        float a = 1000 * random_float_of(random_bits(5, i, 0, 0));
        float b = random_float_of(random_bits(5, i, 0, 1));
        missed += between_f32(a, b, 1) != b;
    }
    check_equal(missed, 0, "(1.1) reaches b in float");
}

static void test_interval(void)
{
    ray r = {{0, 0, 0}, 0.5, {1, 0, 0}, 2};
    check(ray_covers(r, 0.5) && ray_covers(r, 2), "the interval is closed at both ends");
    check(!ray_covers(r, (real)0.5 - (real)epsilon) && !ray_covers(r, 2 + 4 * (real)epsilon),
          "the next number outside is outside");
    check(!ray_covers(r, (real)NAN), "a NaN is in no interval");
    r.tmin = 3;
    check(!ray_covers(r, 2.5), "an empty interval covers nothing");
    ray segment = ray_between((vec3){1, 2, 3}, (vec3){2, 2, 3});
    check(segment.tmin == 0 && segment.tmax == 1, "from a to b: [0, 1]");
    ray all = ray_from((vec3){1, 2, 3}, (vec3){0, 0, 5});
    check(ray_covers(all, 0) && ray_covers(all, real_infinity) && !ray_covers(all, -real_smallest),
          "[0, infinity] begins at the origin and has no end");
}

/* (1.3): with a unit d, differences of t are distances; else they are |d| times less. */
static void test_unit(void)
{
    double worst = 0;
    for (size_t i = 0; i < check_count(100000); i++) {
        random_stream s = random_start(3, i, 0);
        vec3 d = random_in_cube(&s, random_power(&s, 1000)), o = random_in_cube(&s, 1);
        ray r = ray_from(o, d);
        ray u = ray_unit(r);
        real t1 = random_next(&s), t2 = random_next(&s), length = vlength(r.d);
        real distance = vlength(vsub(ray_at(u, t1), ray_at(u, t2)));
        worst = check_worse(worst, fabs((double)(distance - fabs(t1 - t2))));
        vec3 same = vsub(ray_at(r, t1), ray_at(u, t1 * length));
        worst = check_worse(worst, (double)(vlength(same) / (1 + length)));
    }
    /* points of size 2: each is off by 2 epsilon in each of three coordinates, D by 2 epsilon */
    check_at_most(worst, 16 * epsilon, "|p(t1) - p(t2)| = |t1 - t2|, and t |d| is the same point");
    ray r = {{0, 0, 0}, 1, {0, 3, 4}, 2}, u = ray_unit(r);
    check_equal(u.tmin, 5, "the interval is rescaled by |d|");
    check_equal(u.tmax, 10, "the interval is rescaled by |d|");
}

/* [eps, 1 - eps] leaves out a fraction of the way, [eps, |L - P| - eps] a distance. */
static void test_shadow(void)
{
    vec3 p = {0, 0, 0}, light = {0, 100, 0};
    real eps = 0.0078125;
    ray r = ray_shadow(p, light, eps), u = ray_shadow_unit(p, light, eps);
    check_equal(ray_at(r, r.tmin).y, 100 * eps, "not normalised: eps of the way");
    check_equal(ray_at(u, u.tmin).y, eps, "normalised: the distance eps");
    check_close(ray_at(r, r.tmax).y, 100 - 100 * (double)eps, 200 * epsilon, "at the light");
    check_close(ray_at(u, u.tmax).y, 100 - (double)eps, 200 * epsilon, "the same at the light");
    real blocker = 0.5;  /* half a unit above p: 0.005 of the way */
    check(!ray_covers(r, blocker / 100) && ray_covers(u, blocker),
          "the same eps loses an occluder in one form and keeps it in the other");
}

static bool plane_x(real x, ray r, hit *out)  /* x = const, the simplest of shapes */
{
    real t = (x - r.o.x) / r.d.x;
    if (!ray_covers(r, t)) return false;
    *out = (hit){t, 0, 0, 0};
    return true;
}

static void test_closest(void)
{
    const real plane[] = {7, 3, 9, 3, -1, 5};
    for (int order = 0; order < 2; order++) {
        ray r = ray_from((vec3){0, 0, 0}, (vec3){1, 0, 0});
        hit best = hit_none, h;
        for (uint32_t k = 0; k < 6; k++) {
            uint32_t i = order ? 5 - k : k;
            if (!plane_x(plane[i], r, &h)) continue;
            h.shape = i;
            if (!hit_before(h, best)) continue;
            best = h;
            r.tmax = h.t;
        }
        check_equal(best.t, 3, "the nearest plane in front");
        check_equal(best.shape, 1, "of two at the same t the lower index, in either order");
    }
    hit h = {1, 2, 3, 4};
    check(!plane_x(-1, ray_from((vec3){0, 0, 0}, (vec3){1, 0, 0}), &h) && h.t == 1 && h.shape == 4,
          "a miss leaves *out alone");
    check(!hit_before((hit){(real)NAN, 0, 0, 0}, hit_none), "a NaN comes before nothing");
    check(!hit_before(hit_none, hit_none), "no hit does not come before no hit");
}

static vec3 along(affine m, ray r, real t) { return affine_point(m, ray_at(r, t)); }

static void test_affine(void)
{
    double worst = 0, undo = 0;
    for (size_t i = 0; i < check_count(100000); i++) {
        random_stream s = random_start(4, i, 0);
        vec3 axis = vunit(random_in_cube(&s, 1));
        vec3 size = vadd((vec3){2, 2, 2}, random_in_cube(&s, 1));
        size.x = -size.x;  /* mirrored */
        affine m = affine_then(affine_scaling(size), affine_rotation(axis, 6 * random_next(&s)));
        m = affine_then(m, affine_translation(random_in_cube(&s, 10)));
        vec3 d = random_in_cube(&s, 1);
        ray r = ray_from(random_in_cube(&s, 10), d);
        real t = 10 * random_next(&s);
        vec3 p = ray_at(affine_ray(m, r), t), q = along(m, r, t);
        worst = check_worse(worst, (double)vlength(vsub(p, q)));
        affine back;
        if (!affine_inverse(m, &back)) { undo = HUGE_VAL; continue; }
        undo = check_worse(undo, (double)vlength(vsub(affine_point(back, q), ray_at(r, t))));
    }
    /* numbers up to 3 * 20 + 10, some ten roundings each; undoing multiplies by the condition, 3 */
    check_at_most(worst, 10 * 70 * epsilon, "the transformed ray at t: the transformed point at t");
    check_at_most(undo, 4 * 10 * 70 * epsilon, "the inverse takes the point back");
    affine out = affine_scaling((vec3){7, 7, 7});
    check(!affine_inverse(affine_scaling((vec3){1, 0, 1}), &out), "a flat one has no inverse");
    check(!affine_inverse(affine_scaling(vec(1, NAN, 1)), &out), "nor has a NaN");
    check(!affine_inverse(affine_translation((vec3){real_infinity, 0, 0}), &out), "nor infinity");
    check(!affine_inverse(affine_scaling((vec3){real_infinity, 1, 1}), &out), "nor infinite axes");
    check_equal(out.x.x, 7, "a failed inverse leaves *out alone");
    check(!affine_inverse(affine_scaling((vec3){real_smallest / 8, 1, 1}), &out),
          "nor what only an infinite number would undo");
    for (int k = -1; k <= 1; k++) {  /* their cubes over- and underflow */
        real s = ldexp((real)1, k * (real_is_float ? 100 : 900));
        affine m = affine_then(affine_scaling((vec3){s, 2 * s, 1 / s}),
                             affine_translation((vec3){s, s, 0}));
        bool is = affine_inverse(m, &out);
        check(is && out.x.x == 1 / s && out.y.y == 1 / (2 * s) && out.z.z == s,
              "a scaling by %g is undone, exactly", (double)s);
        check(is && out.o.x == -1 && out.o.y == (real)-0.5 && out.o.z == 0, "and its translation");
        is = affine_inverse(affine_scaling((vec3){s, s, s}), &out);
        check(is && out.x.x == 1 / s && out.y.y == 1 / s && out.z.z == 1 / s, "all axes alike");
    }
}

/* The same plane hit in world space and, by the transformed ray, in object space: the same t. With
 * D normalised in between t is another. */
static void test_instance_keeps_t(void)
{
    affine scaled = affine_scaling((vec3){4, 1, 1}), to_object;
    affine to_world = affine_then(scaled, affine_translation((vec3){3, 0, 0}));
    check(affine_inverse(to_world, &to_object), "the instance can be inverted");
    ray r = ray_from((vec3){-5, 1, 2}, (vec3){2, 1, 0});
    hit world = hit_none, object = hit_none, unit = hit_none;
    plane_x(11, r, &world);  /* x = 2 in object space is x = 4 * 2 + 3 */
    plane_x(2, affine_ray(to_object, r), &object);
    plane_x(2, ray_unit(affine_ray(to_object, r)), &unit);
    check_equal(object.t, world.t, "t is the same in both spaces (powers of two: exactly)");
    check(unit.t != world.t && unit.t > 0, "not so if the direction is normalised in between");
}

static void test_layout(void)
{
    check_equal(offsetof(ray, o), 0, "RayDesc: Origin first");
    check_equal(offsetof(ray, tmin), 3 * sizeof(real), "then TMin");
    check_equal(offsetof(ray, d), 4 * sizeof(real), "then Direction");
    check_equal(offsetof(ray, tmax), 7 * sizeof(real), "then TMax");
    check_equal(sizeof(ray), 8 * sizeof(real), "no padding: 32 bytes in float, as RayDesc");
}

/* first.h's against ray_unit, which gives no direction none. */
static void test_first_unit(void)
{
    double unit = 0;
    size_t interval = 0, n = check_count(100000);
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(1, i, 0);
        real tmin = random_next(&s), tmax = random_next(&s);
        ray r = {random_in_cube(&s, 1), tmin, random_in_cube(&s, 1), tmax};
        ray u = first_ray_unit(r), v = ray_unit(r);
        unit = check_worse(unit, (double)(vlength(vsub(u.d, v.d)) + vlength(vsub(u.o, v.o))));
        interval += u.tmin != v.tmin || u.tmax != v.tmax;
    }
    check_at_most(unit, 4 * epsilon, "first_ray_unit against ray_unit");
    check_equal(interval, 0, "intervals, of %zu", n);
    ray none = ray_from((vec3){1, 2, 3}, (vec3){0, 0, 0});
    check(!vfinite(first_ray_unit(none).d) && vzero(ray_unit(none).d), "no direction: no unit");
}

int main(void)
{
    return check_all("01_ray", test_first_unit, test_error_bounds, test_ends,
                     test_error_at_one, test_form_far_out, test_float_staircase, test_interval,
                     test_unit, test_shadow, test_closest, test_affine, test_instance_keeps_t,
                     test_layout);
}
