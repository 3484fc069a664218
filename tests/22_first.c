/* 22's first.h: the answers of solid_angle.h and sphere_irradiance.h, by formula and by directions;
 * and small caps and sunk balls, where it has none. Fixed seeds; each random test alarms falsely
 * once in 1e8 seeds. */
#include "../common/lab/t_test.h"
#include "../chapters/22_radiometry/lab/oracle.h"
#include "../chapters/22_radiometry/lab/sphere_irradiance.h"
#include "22_inputs.h"
#include "check.h"

#define alarm 1e-8

static vec3 any_direction(random_stream *s)
{
    real u = random_next(s), v = random_next(s);
    return sample_sphere(u, v);
}

/* a <= 1/sqrt 2 of sqrt(epsilon): a^2 / 2 is a quarter of epsilon, half the step below 1. */
static void test_small_cap(void)
{
    const real limit = real_is_float ? (real)2e-4 : (real)1e-8;
    size_t n = check_count(20000), nothing = 0;
    double worst = 0;
    for (size_t i = 0; i < n; i++) {
        real a = limit * (real)(i + 1) / (real)n;
        nothing += first_cap_solid_angle(a) == 0;
        worst = check_worse(worst, fabs((double)(cap_solid_angle(a) / (pi * a * a)) - 1));
    }
    check_equal(nothing, n, "caps below %g that are nothing", (double)limit);
    check_at_most(worst, 16 * eps, "cap_solid_angle has all digits: pi a^2");
    check_close(first_cap_solid_angle(2 * pi / 3), 3 * (double)pi, 16 * eps, "but large ones are");
}

/* From 1.01 to 10 radii. The arc sine's slope is 7 at most. */
static void test_sphere(void)
{
    size_t n = check_count(100000);
    double worst = 0;
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(1, i, 0);
        vec3 c = any_direction(&s), d = any_direction(&s);
        sphere b = {vscale(c, 3 * random_next(&s)), random_between(&s, 0.1, 3)};
        vec3 p = vmadd(b.c, d, b.r * random_between(&s, 1.01, 10));
        double is = (double)first_sphere_solid_angle(b, p), due = (double)sphere_solid_angle(b, p);
        /* p is known to an epsilon of its size, 33 at most: to as much of R, divided by it */
        double known = eps * (1 + (double)(vlength(p) / b.r));
        worst = check_worse(worst, fabs(is - due) / known);
    }
    check_at_most(worst, 32, "balls against sphere_solid_angle, %zu", n);
    sphere far = {{0, 0, 0}, 1};
    real d = 1 / (real_is_float ? (real)2e-4 : (real)1e-8);
    check_equal(first_sphere_solid_angle(far, (vec3){2 * d, 0, 0}), 0, "a far ball is nothing");
    check(sphere_solid_angle(far, (vec3){2 * d, 0, 0}) > 0, "and is something");
}

/* A ball over the plane of p, at least its radius high; p and n anywhere. */
static sphere ball_over(random_stream *s, vec3 *p, vec3 *n, real least)
{
    vec3 x, y;
    *n = any_direction(s), *p = vscale(any_direction(s), 2);
    vbasis(*n, &x, &y);
    real R = random_between(s, 0.2, 1.5), turn = random_between(s, 0, 6.28);
    real h = R * (least + random_between(s, 0.05, 3)), a = R * random_between(s, 0, 4);
    vec3 c = vmadd(vmadd(vmadd(*p, x, a * cos(turn)), y, a * sin(turn)), *n, h);
    return (sphere){c, R};
}

static void test_irradiance(void)
{
    size_t n = check_count(100000);
    double worst = 0;
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(2, i, 0);
        vec3 p, up;
        sphere b = ball_over(&s, &p, &up, 1);
        real L = random_between(&s, 0.5, 8);
        double due = (double)(L * sphere_irradiance(b, p, up));
        worst = check_worse(worst, fabs((double)first_sphere_irradiance(b, L, p, up) / due - 1));
    }
    /* c - p is off by an epsilon or two of |c|, 12 at most, beside a height of 0.2 at least */
    check_at_most(worst, 256 * eps, "above the horizon, against sphere_irradiance, %zu", n);
}

/* Runs of 256 directions: their mean, and what they say of their own error. */
static void test_directions(void)
{
    enum { N = 256 };
    size_t n = check_count(4000);
    for (uint64_t i = 0; i < 12; i++) {
        random_stream place = random_start(3, i, 0);
        vec3 p, up;
        sphere b = ball_over(&place, &p, &up, i % 2 ? 1 : -1);  /* every other one partly sunk */
        double due = 3 * (double)sphere_irradiance(b, p, up), omega = 2 * (double)pi;
        estimate mean = {0}, spread = {0};
        for (size_t k = 0; k < n; k++) {
            random_stream random = random_start(4, i, k);
            first_samples E = first_irradiance_by_directions(b, 3, p, up, N, &random);
            mean = estimate_add(mean, (double)first_mean(E));
            spread = estimate_add(spread, (double)first_variance(E));
        }
        check_at_least(t_test(mean, due, 256 * eps), alarm, "ball %d, by directions", (int)i);
        /* the variance of a mean is that of one sample / N; of n numbers it is off by sqrt(2/n) */
        double ratio = estimate_variance(mean) * N / spread.mean;
        check_close(ratio, 1, 8 * sqrt(2 / (double)n) + 8 / sqrt((double)n), "its variance");
        check(spread.mean > 0 && spread.mean < 3 * omega * due, "at most largest times mean");
    }
}

/* A ball that lies half below: (22.10) takes away the lower part, or says nothing at all. */
static void test_sunk(void)
{
    vec3 o = {0, 0, 0}, up = {0, 0, 1};
    size_t n = check_count(10000), more = 0, none = 0;
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(5, i, 0);
        sphere b = {{random_between(&s, 1.5, 6), 0, random_between(&s, -0.9, 0.1)}, 1};
        double due = sphere_irradiance_exact(1, (double)b.c.x, (double)b.c.z);
        double is = (double)first_sphere_irradiance(b, 1, o, up);
        more += is > 0.6 * due, none += is == 0;
    }
    check_equal(more, 0, "of balls whose middle is below 0.1 R, as much as 0.6 of the light");
    check_at_least((double)none, 0.8 * (double)n, "most of them are dark");
    sphere low = {{2, 0, (real)0.5}, 1};
    double above = sphere_irradiance_exact(1, 2, 0.5), below = sphere_irradiance_exact(1, 2, -0.5);
    check_close(first_sphere_irradiance(low, 1, o, up), above - below, 64 * eps,
                "(22.10) is what is above minus what is below");
}

/* Nonsense ends: within the ball there is no cap; a direction of no length meets nothing. */
static void test_nonsense(void)
{
    sphere b = {{0, 0, 0}, 1};
    vec3 o = {0, 0, 0}, up = {0, 0, 1}, nan = {(real)NAN, 0, 0};
    random_stream random = random_start(6, 0, 0);
    check(isnan(first_sphere_solid_angle(b, (vec3){(real)0.5, 0, 0})), "from inside: no cap");
    check(isnan(first_sphere_irradiance(b, 1, o, up)), "from its centre: no direction");
    check_equal(first_irradiance_sample(b, 1, (vec3){0, 0, 3}, up, 0, 0), 0, "missed");
    check_equal(first_irradiance_sample(b, 1, nan, up, (real)0.5, 0), 0, "from nowhere: missed");
    check_equal(first_irradiance_sample(b, 1, (vec3){0, 0, 3}, nan, (real)0.5, 0), 0, "no normal");
    check_equal(first_irradiance_by_directions(b, 1, o, up, 0, &random).n, 0, "no direction");
}

int main(void)
{
    return check_all("22_first", test_small_cap, test_sphere, test_irradiance,
                     test_directions, test_sunk, test_nonsense);
}
