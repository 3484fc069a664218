/* 20's first.h: the answers of estimate.h and of closed forms; a variance that is noise; the sky by
 * its directions, whose densities 20_sampling.c asks for. Fixed seeds; each random test alarms falsely once in 1e8 seeds. */
#include "../chapters/20_monte_carlo/lab/chance_figure.h"
#include "../chapters/20_monte_carlo/lab/pictures.h"
#include "../chapters/20_monte_carlo/first.h"
#include "../chapters/20_monte_carlo/sampling.h"
#include "../common/lab/t_test.h"
#include "check.h"

#define alarm 1e-8
static const double eps = (double)real_epsilon;

typedef struct { first_samples first; estimate full, centred; } sums;

/* n numbers about `mean` of deviation 1; `centred` sees them as offsets, which lose no digit. */
static sums sums_of(real mean, uint64_t set, int n)
{
    sums s = {{0, 0, 0}, {0}, {0}};
    random_stream random = random_start(1, set, 0);
    for (int i = 0; i < n; i++) {
        real x = mean + (2 * random_next(&random) - 1) * sqrt((real)3);
        first_sample(&s.first, x);
        s.full = estimate_add(s.full, (double)x);
        s.centred = estimate_add(s.centred, (double)x - (double)mean);
    }
    return s;
}

/* Sums of n numbers are off by n/2 epsilon at most, the difference by that of mean^2. */
static void test_samples(void)
{
    size_t n = check_count(10000);
    double mean = 0, variance = 0, error = 0;
    for (size_t set = 0; set < n; set++) {
        int size = 2 + (int)(set % 99);
        double centre = (double)(set % 41) / 10 - 2;
        sums s = sums_of((real)centre, set, size);
        double v = estimate_variance(s.full), scale = size * eps * (1 + 4 / v);
        mean = check_worse(mean, fabs((double)first_mean(s.first) - s.full.mean) / (size * eps));
        variance = check_worse(variance, fabs((double)first_variance(s.first) / v - 1) / scale);
        double e = (double)first_error(s.first) / estimate_error(s.full) - 1;
        if (scale < 0.1) error = check_worse(error, fabs(e) / scale);
    }
    check_at_most(mean, 4, "mean against estimate.h, in n epsilon, %zu sets", n);
    check_at_most(variance, 4, "variance, in n epsilon (1 + mean^2 / variance), %zu sets", n);
    check_at_most(error, 4, "standard error, in the same, %zu sets", n);
}

/* In float a mean of 1000; in double the one that lies as far out: 2.3e7. */
static void test_far_mean(void)
{
    enum { size = 1000, most = 1000 };
    const real mean = 1000 * sqrt((real)FLT_EPSILON / real_epsilon);
    int sets = (int)check_sample(most, 100), negative = 0, bad = 0;
    double full = 0, near = 0;
    for (int set = 0; set < sets; set++) {
        sums s = sums_of(mean, (uint64_t)set, size);
        double v = estimate_variance(s.centred), first = (double)first_variance(s.first);
        negative += first < 0, bad += fabs(first / v - 1) > 0.1;
        full = check_worse(full, fabs(estimate_variance(s.full) / v - 1));
        sums easy = sums_of(1, (uint64_t)set, size);
        double e = estimate_variance(easy.full);
        near = check_worse(near, fabs((double)first_variance(easy.first) / e - 1));
    }
    check_at_most(full, size * (double)mean * DBL_EPSILON, "estimate.h at a mean of %g",
                  (double)mean);
    check_at_most(near, 4 * size * eps, "first_variance at a mean of 1");
    check_at_least(bad, 0.8 * sets, "not one digit of first_variance, of %d", sets);
    check_at_least(negative, 0.05 * sets, "first_variance below 0, of %d", sets);
}

/* One number: nothing is known of the spread, and nothing breaks. */
static void test_few(void)
{
    first_samples s = {0, 0, 0};
    check(!(first_variance(s) >= 0), "the variance of nothing");
    first_sample(&s, 7);
    check_equal(first_mean(s), 7, "one number is its mean");
    check(!isfinite(first_variance(s)), "its variance is not known");
    first_sample(&s, 9);
    check_equal(first_variance(s), 2, "(1 + 1) / (2 - 1)");
    check_equal(first_error(s), 1, "root of 2 / 2");
    first_sample(&s, (real)NAN);
    check(isnan(first_mean(s)) && isnan(first_error(s)), "a NaN stays");
}

/* ---- three ways to pi ---- */

enum { ways = 3 };
static const char *const way_name[ways] = {"darts", "uniform", "importance"};
static double way_value(int way, real u, real v)
{
    return (double)(way == 0 ? first_pi_darts(u, v)
                  : way == 1 ? first_pi_uniform(u) : first_pi_importance(u));
}

static const double true_pi = 3.14159265358979324;
static double way_variance(int way)
{
    return way == 0 ? true_pi * (4 - true_pi)
         : way == 1 ? 32.0 / 3 - true_pi * true_pi : 60 - 72 * log(2) - true_pi * true_pi;
}

static void test_pi_by_chance(void)
{
    static const double said[ways] = {2.70, 0.80, 0.22};  /* in the comments of first.h */
    size_t n = check_count(200000);
    for (int way = 0; way < ways; way++) {
        estimate x = {0}, square = {0};
        for (size_t i = 0; i < n; i++) {
            random_stream random = random_start(2, i, (uint64_t)way);
            real u = random_next(&random), v = random_next(&random);
            double f = way_value(way, u, v), d = f - true_pi;
            x = estimate_add(x, f), square = estimate_add(square, d * d);
        }
        check_at_least(t_test(x, true_pi, 8 * eps), alarm, "pi by %s", way_name[way]);
        check_close(way_variance(way), said[way], 0.005, "as first.h has it");
        check_at_least(t_test(square, way_variance(way), 32 * eps), alarm, "variance of %s",
                       way_name[way]);
    }
}

/* P, as the drawing has it, gives u back (20.7), and its slope is the density. */
static void test_inversion(void)
{
    size_t n = check_count(10000);
    double back = 0, slope = 0;
    for (size_t k = 0; k < n; k++) {
        double u = ((double)k + 0.5) / (double)n, x = (double)first_pi_inversion((real)u), h = 1e-4;
        back = check_worse(back, fabs(chance_below(x) - u));
        double p = (chance_below(x + h) - chance_below(x - h)) / (2 * h);
        slope = check_worse(slope, fabs((double)first_pi_density((real)x) - p));
    }
    check_at_most(back, 8 * eps, "P(first_pi_inversion(u)) is u");
    check_at_most(slope, 4 * eps + 1e-11, "first_pi_density is the slope of P");
}

/* Places of the ball and the floor: what the directions of the picture say of the sky that a place
 * sees, and what is known. */
static void test_dome(void)
{
    static const int at[5][2] = {{200, 100}, {150, 160}, {200, 225}, {60, 200}, {250, 270}};
    size_t n = check_count(20000);
    for (int k = 0; k < 5; k++)
        for (int way = 0; way < 2; way++) {
            dome_place place = dome_seen(at[k][0], at[k][1]);
            estimate e = {0};
            for (size_t i = 0; i < n; i++) {
                point2 q = {random_real(9, i, (uint64_t)k, 0), random_real(9, i, (uint64_t)k, 1)};
                e = estimate_add(e, dome_sample(way, place, q));
            }
            check(!place.sky && place.ball == (k < 3), "where place %d lies", k);
            check_at_least(t_test(e, dome_truth(place), 64 * eps), alarm, "sky, place %d by %d", k,
                           way);
        }
}

int main(void)
{
    return check_all("20_first", test_samples, test_far_mean, test_few, test_pi_by_chance,
                     test_inversion, test_dome);
}
