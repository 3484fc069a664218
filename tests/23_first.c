/* 23's first.h: the answers of brdf.h and of its reflection equation; and lobes that lose light, or
 * their digits. Fixed seeds; each random test alarms falsely once in 1e8 seeds. */
#include "../common/lab/t_test.h"
#include "../chapters/23_brdf/first.h"
#include "../chapters/23_brdf/lab/reference.h"
#include "check.h"

#define alarm 1e-8
static const double eps = (double)real_epsilon;
static const vec3 black = {0, 0, 0}, white = {1, 1, 1};

static vec3 at_angle(double cosine, double turn)
{
    double s = sqrt((1 - cosine) * (1 + cosine));
    return vec(s * cos(turn), s * sin(turn), cosine);
}

static brdf full_of(first_brdf f) { return brdf_blinn_phong(f.kd, f.ks, f.e); }

/* Each component in [0, most). */
static vec3 colour(random_stream *random, real most)
{
    real r = random_next(random), g = random_next(random);
    return vscale((vec3){r, g, random_next(random)}, most);
}

/* n.h is off by an epsilon or two, its power e times as much. */
static void test_value(void)
{
    double worst = 0, matte = 0, swapped = 0;
    size_t n = check_count(100000);
    for (size_t i = 0; i < n; i++) {
        random_stream random = random_start(2, i, 0);
        vec3 kd = colour(&random, (real)0.5), ks = colour(&random, (real)0.5);
        real e = 100 * random_next(&random) * (i % 3 == 0);
        first_brdf f = {kd, i % 5 ? ks : black, e};
        real u = random_next(&random), v = random_next(&random);
        vec3 wi = first_uniform_direction((1 + 999 * u) / 1000, v);
        u = random_next(&random), v = random_next(&random);
        vec3 wo = first_uniform_direction((1 + 999 * u) / 1000, v);
        brdf b = full_of(f);
        vec3 due = brdf_value_local(&b, wi, wo), is = first_brdf_value(f, wi, wo);
        vec3 back = first_brdf_value(f, wo, wi);
        double off = (double)vlength(vsub(is, due)) / (double)vlength(due);
        if (vzero(f.ks)) matte = check_worse(matte, off);
        worst = check_worse(worst, off / (4 + (double)e));
        swapped = check_worse(swapped, (double)vlength(vsub(is, back)));
    }
    check_at_most(worst, 8 * eps, "value against brdf_value_local, in 4 + e, %zu pairs", n);
    check_at_most(matte, 2 * eps, "and without a highlight");
    check_equal(swapped, 0, "f(wi, wo) = f(wo, wi)");
}

/* (23.4) by the midpoint rule over z and turn, by the full version. */
static double albedo_due(first_brdf f, vec3 wo)
{
    enum { k = 400 };
    brdf b = full_of(f);
    double sum = 0;
    for (int i = 0; i < k * k; i++) {
        vec3 wi = at_angle((i / k + 0.5) / k, 2 * (double)pi * (i % k + 0.5) / k);
        sum += (double)(brdf_value_local(&b, wi, wo).x * wi.z);
    }
    return sum * 2 * (double)pi / (k * k);
}

static estimate albedos(first_brdf f, vec3 wo, uint64_t seed)
{
    estimate e = {0};
    size_t n = check_count(4000);
    for (size_t i = 0; i < n; i++) {
        random_stream random = random_start(seed, i, 0);
        e = estimate_add(e, (double)first_albedo(f, wo, 16, &random).x);
    }
    return e;
}

static void test_albedo(void)
{
    static const double exponent[4] = {0, 2, 10, 50}, cosine[3] = {1, 0.6, 0.1};
    for (int i = 0; i < 12; i++) {
        first_brdf f = {vec(0.3, 0, 0), vec(0.5, 0, 0), (real)exponent[i % 4]};
        vec3 wo = at_angle(cosine[i / 4], i);
        double due = albedo_due(f, wo);
        check_at_least(t_test(albedos(f, wo, 3), due, 1e-4 + 64 * eps), alarm,
                       "albedo by chance, e = %g, cos %g", exponent[i % 4], cosine[i / 4]);
        check_at_most(due, 0.8 + 1e-4, "which is at most kd + ks");
        if (i < 4) check_close(due, 0.8, 1e-4, "and just that head-on, (23.14)");
    }
}

/* Around any normal, against the midpoint rule of reflection.h with the same room. Its cells on the
 * frame of the window leave some 1e-4. */
static void test_reflection(void)
{
    size_t n = check_count(8000);
    for (int i = 0; i < 4; i++) {
        random_stream place = random_start(4, (uint64_t)i, 0);
        real u = random_next(&place), v = random_next(&place);
        vec3 normal = directed(vunit(vec(0, 0.4, 0.9)), first_cosine_direction(u / 2, v));
        u = random_next(&place), v = random_next(&place);
        vec3 wo = directed(normal, first_uniform_direction((real)0.1 + u / 2, v));
        first_brdf f = {vec(0.3, 0.2, 0.1), vec(0.5, 0.6, 0.7), i % 2 ? 30 : 4};
        brdf b = full_of(f);
        reflection r = {DIRECTIONS_UNIFORM, false, 0};
        vec3 due = reflection_grid(&r, &b, normal, wo, first_room_light, 700);
        int N = i < 2 ? 16 : 64;
        estimate x = {0}, z = {0};
        for (size_t k = 0; k < n; k++) {
            random_stream random = random_start(5, (uint64_t)i, k);
            vec3 L = first_reflection(f, normal, wo, N, &random);
            x = estimate_add(x, (double)L.x), z = estimate_add(z, (double)L.z);
        }
        double slack = 2e-4 * (double)due.x;
        check_at_least(t_test(x, (double)due.x, slack), alarm, "red, %d directions, point %d", N,
                       i);
        check_at_least(t_test(z, (double)due.z, slack), alarm, "blue");
    }
}

/* Evenly spread directions leave less noise than as many of their own each. */
static void test_even(void)
{
    first_brdf f = {vec(0.5, 0.5, 0.5), black, 1};
    vec3 up = {0, 0, 1};
    estimate even = {0}, loose = {0};
    for (size_t k = 0; k < check_count(1000); k++) {
        random_stream random = random_start(6, k, 0);
        even = estimate_add(even, (double)first_reflection(f, up, up, 256, &random).x);
        double sum = 0;
        for (int i = 0; i < 256; i++)
            sum += (double)first_reflection(f, up, up, 1, &random).x / 256;
        loose = estimate_add(loose, sum);
    }
    check_at_most(estimate_variance(even) / estimate_variance(loose), 0.6, "256 directions");
}

/* ---- as the top of first.h says ---- */

static void test_slant(void)
{
    first_brdf sharp = {black, white, 1000};
    vec3 wo = at_angle(0.5, 0);
    double due = albedo_due(sharp, wo);
    brdf facets = brdf_ggx(white, (real)0.3);
    check_close(due, 0.25, 0.01, "a sharp lobe at 60 degrees keeps cos^2");
    check_at_least(t_test(albedos(sharp, wo, 7), due, 1e-3), alarm, "and first_albedo says so");
    check_at_least((double)brdf_albedo(&facets, (real)0.5).x, 0.95, "microfacets keep it");
    first_brdf both = {vec(0.6, 0, 0), vec(0.6, 0, 0), 10};
    estimate e = albedos(both, at_angle(1, 0), 8);
    check_at_least(t_test(e, 1.2, 1e-4), alarm, "kd + ks = 1.2 gives 1.2 head-on");
    check_at_least(e.mean, 1.1, "more than it gets");
}

/* e = 1e6 in float, and what is as far out in double; as far from the axis as the power is e^-4. */
static void test_digits(void)
{
    real e = (real)(1e6 * (double)FLT_EPSILON / eps);
    double first = 0, full = 0;
    size_t n = check_count(20000);
    for (size_t i = 0; i < n; i++) {
        real s = sqrt(8 / e) * (real)(i + 1) / (real)n;
        vec3 h = {s, 0, sqrt((1 - s) * (1 + s))};
        double due = exp((double)e / 2 * log1p(-(double)s * (double)s));
        first_brdf f = {black, white, e};
        real value = first_brdf_value(f, h, h).x / first_brdf_scale(e);  /* wi = wo = h */
        first = check_worse(first, fabs((double)value / due - 1));
        full = check_worse(full, fabs((double)blinn_phong_power(e, h) / due - 1));
    }
    check_at_least(first, 0.01, "(n.h)^e, e = %g: off by per cents", (double)e);
    check_at_most(full, 64 * eps, "blinn_phong_power");
}

/* Nonsense gives numbers, and no more than N directions are asked for. */
static void test_nonsense(void)
{
    first_brdf f = {white, white, 20};
    vec3 nan = vec((double)NAN, 0, 1), up = {0, 0, 1};
    random_stream random = random_start(9, 0, 0);
    check(vfinite(first_brdf_value(f, up, vneg(up))), "opposite directions have no half vector");
    check(vfinite(first_brdf_value(f, nan, up)), "a NaN direction has none");
    check(vzero(first_reflection(f, up, up, 0, &random)), "no direction, no light");
    check(vzero(first_albedo(f, up, 0, &random)), "nor an albedo");
    check(vfinite(first_reflection(f, up, up, 7, &random)), "7 is no square");
    check_equal(random.dimension, 14, "two numbers a direction");
}

int main(void)
{
    return check_all("23_first", test_value, test_albedo, test_reflection, test_even, test_slant,
                     test_digits, test_nonsense);
}
