/* Tests of 20_monte_carlo: errors and their slopes against exact values, importance sampling done
 * well and fatally, and what four times the rays do. Fixed seeds; each random test alarms falsely
 * once in 1e8 seeds, there are fewer than 100. */
#include "../chapters/20_monte_carlo/lab/measure.h"
#include "check.h"

#define alarm 1e-8

/* ---- the exact values, against slower ways to them ---- */

static void test_exact_values(void)
{
    double levels = 0;
    for (int k = 0; k < 30; k++) levels += exp_level(k);
    check_close(levels / exp_variance(0, 1), 1, 1e-13, "levels add up to the variance of e^x");
    check_close(exp_level(0), pow(exp_mean(0, 0.5) - exp_mean(0.5, 0.5), 2) / 4, 1e-15,
                "level 0: two halves");
    double right = (exp(2) - 1) / 2 - (exp(1) - 1) * (exp(1) - 1);
    check_close(exp_variance(0, 1), right, 1e-15, "variance of e^x in [0,1]");
    /* both branches of exp_variance where they meet, and a tiny interval: h^2 / 12 */
    check_close(exp_variance(0, 0.2) / exp_variance(0, 0.2 + 1e-12), 1, 1e-10, "branches meet");
    check_close(exp_variance(1, 1e-8) / (exp(2) * 1e-16 / 12), 1, 1e-7, "a tiny interval");
    check_close(deviation_jittered(1) / deviation_random(SMOOTH, 1), 1, 1e-14, "one cell");
    check_close(deviation_sobol(0) / deviation_random(SMOOTH, 1), 1, 1e-13, "one point is random");
}

/* ---- measured against exact, and slopes ---- */

/* Squared errors have the expectation deviation^2. They are skew; of 480 the mean is near enough to
 * normal for p = 1e-8: alarms come too often by a factor of some ten, not more. */
static void test_variances(void)
{
    convergence *c = convergence_measure(4, 480, 7, 2);
    for (int l = 0; l < c->levels; l++)
        for (int k = 0; k < convergence_methods; k++)
            for (int f = 0; f < integrands; f++) {
                double exact = convergence_exact(k, (integrand)f, l);
                if (isnan(exact)) continue;
                double slack = 1e-7 * exact + (real_is_float ? 1e-7 : 0);  /* float's own steps */
                check_at_least(t_test(c->square[k][l][f], exact * exact, slack * exact), alarm,
                               "%s, N = %d, %s: mean square error", convergence_name(k),
                               (int)convergence_n(l), f ? "edge" : "smooth");
            }
    /* from N = 16 to 1024; a root mean square of 480 is off by 3 % or so: 5 sigma = .05 */
    static const double due[sequence_kinds][integrands] = {
        {-0.5, -0.5}, {-1, -0.75}, {-0.9, -0.7}, {-1.5, -0.75}};
    for (int k = 0; k < sequence_kinds; k++)
        for (int f = 0; f < integrands; f++) {
            if (k == SEQUENCE_HALTON) continue;  /* one set of points: only a bound, below */
            double x[4], measured[4], known[4];
            for (int l = 0; l < 4; l++) {
                x[l] = log(convergence_n(l));
                measured[l] = log(convergence_rms(c, k, (integrand)f, l));
                known[l] = log(convergence_exact(k, (integrand)f, l));
            }
            double slope = fit_line(x, measured, 4).slope, exact = (double)NAN;
            if (!isnan(known[3])) exact = fit_line(x, known, 4).slope;
            if (isnan(exact)) exact = due[k][f];
            check_close(slope, exact, 0.05, "slope of %s, %s", sequence_name[k],
                        f ? "edge" : "smooth");
            check_close(exact, due[k][f], 0.11, "its exact slope, near that for N -> infinity");
        }
    /* Koksma, Hlawka: error at most the variation times the discrepancy, which is at most (2 + 3
     * log2 N + ...) / N or so: here simply log2(N)^2 / N times the variation e^2 - 1 + 2 (e-1) */
    for (int l = 0; l < c->levels; l++) {
        double n = convergence_n(l), bound = log2(n) * log2(n) / n * (exp(2) + 2 * exp(1) - 3);
        check_at_most(convergence_rms(c, SEQUENCE_HALTON, SMOOTH, l), bound, "Halton's, N = %g", n);
    }
    free(c);
}

/* The variance of e^(x+y) over 2^m points is (20.20), for odd m, too. The hash published for it in
 * 2020, whose coins depend on each other, has half of that at m = 5. */
static void test_hash(void)
{
    int runs = (int)check_sample(2000, 500);
    for (int m = 5; m <= 7; m += 2) {
        double exact = deviation_sobol(m) * deviation_sobol(m), error[integrands];
        estimate e = {0};
        for (int run = 0; run < runs; run++) {
            integrand_errors(SEQUENCE_SOBOL, 5, (uint64_t)run, (uint32_t)1 << m, error);
            e = estimate_add(e, error[SMOOTH] * error[SMOOTH]);
        }
        check_at_least(t_test(e, exact, 1e-7 * exact), alarm, "owen_reversed, 2^%d", m);
    }
}

/* A pixel that a silhouette crosses, by random samples: the variance of the mean of n. */
static double rays_variance(uint64_t seed, uint32_t n, int runs)
{
    estimate e = {0};
    for (int run = 0; run < runs; run++) {
        double error[integrands];
        integrand_errors(SEQUENCE_RANDOM, seed, (uint64_t)run, n, error);
        e = estimate_add(e, error[EDGE]);
    }
    return estimate_variance(e);
}

/* "To halve the variance, four times the rays": four times the rays quarter it. */
static void test_four_times_the_rays(void)
{
    int runs = (int)check_sample(4000, 1000);
    double v = rays_variance(11, 64, runs);
    /* a variance of n samples that are nearly normal is off by sqrt(2 / n) of itself, a ratio by
     * sqrt 2 times that: six of these */
    double most = 6 * 2 / sqrt((double)runs);
    check_close(rays_variance(12, 128, runs) / v * 2, 1, most, "twice the rays halve the variance");
    check_close(rays_variance(13, 256, runs) / v * 4, 1, most, "four times quarter it");
}

/* ---- importance sampling ---- */

static void test_importance(void)
{
    size_t n = check_count(100000);
    for (int k = 0; k <= 4; k++) {  /* n = 0, 1/2, 1, 3/2, 2 */
        double lobe = k / 2.0, rounding = 20 * (double)real_epsilon;
        estimate e = importance_run((real)lobe, 0, 1, (uint64_t)k, n);
        check_at_least(t_test(e, (double)pi, rounding), alarm, "n = %g: the integral is pi", lobe);
        /* the variance is an estimate, too, one of finite variance if the fourth power of a weight
         * has an expectation: 4 (1 - n) + n > -1, n < 5/3 */
        estimate square = {0};
        for (uint64_t i = 0; i < n && lobe < 5.0 / 3; i++) {
            real z = sample_lobe((real)lobe, random_real(2, i, 0, 0), 0).z;
            double d = importance_weight((real)lobe, z) - (double)pi;
            square = estimate_add(square, d * d);
        }
        check_at_least(t_test(square, importance_variance(lobe), 40 * (double)real_epsilon), alarm,
                       "n = %g: its variance", lobe);
    }
    estimate e = importance_run(1, 0, 3, 0, 1000);
    check_at_most(e.squares, 1e-20, "p = f / pi: no variance at all");
    check(isinf(importance_variance(3)) && isfinite(importance_variance(2.9)), "finite below 3");
}

/* Weights: bounded where they should be, for every u; and without bound where p falls faster than
 * f. */
static void test_weights(void)
{
    double most[4] = {0};
    for (uint64_t i = 0; i < check_count(100000); i++) {
        real u = random_real(4, i, 0, 0);
        if (i < 4) u = 1 - real_epsilon / 2 * (real)(i + 1);  /* the most grazing that there are */
        vec3 flat = sample_lobe(0, u, 0), steep = sample_lobe(20, u, 0);
        vec3 cosine = sample_cosine(u, u);
        most[0] = check_worse(most[0], importance_weight(0, flat.z));
        most[1] = check_worse(most[1], (double)(cosine.z / pdf_cosine(cosine)));
        most[2] = check_worse(most[2], importance_weight_mixed(20, 0.2, steep.z));
        most[3] = check_worse(most[3], importance_weight(20, steep.z));
    }
    double p = (double)pi, slack = 1 + 16 * (double)real_epsilon;
    check_at_most(most[0], 2 * p * slack, "uniform: at most 2 pi");
    check_at_most(most[1], p * slack, "cosine: always pi");
    check_at_most(most[2], p / 0.2 * slack, "mixed with a fifth of cosine: at most 5 pi");
    check_at_least(most[3], 1000, "cos^20 alone: no bound");
    vec3 w = {0.8, 0, 0.6};
    double density = 0.75 * (double)pdf_lobe(4, w) + 0.25 * (double)pdf_cosine(w);
    check_close(importance_weight_mixed(4, 0.25, w.z) * density, 0.6,
                16 * (double)real_epsilon, "f / p, p being a mixture");
    check_close(importance_weight_mixed(20, 0, 0.5), importance_weight(20, 0.5), 1e-9,
                "nothing mixed in");
}

/* The fatal one. Its expectation is pi; yet most estimates of 1000 samples are too low, most
 * intervals miss pi, and the t-test, which would alarm once in 1e8 runs, alarms often. The mixture
 * does not. */
static void test_fatal(void)
{
    size_t runs = check_sample(200, 100), low = 0, missed = 0, alarms = 0;
    size_t mixed_alarms = 0, mixed_missed = 0;
    for (uint64_t run = 0; run < runs; run++) {
        estimate e = importance_run(20, 0, 5, run, 1000);
        estimate m = importance_run(20, 0.2, 6, run, 1000);
        low += e.mean < (double)pi;
        missed += t_test(e, (double)pi, 0) < 0.05;
        alarms += t_test(e, (double)pi, 0) < alarm;
        mixed_missed += t_test(m, (double)pi, 0) < 0.05;
        mixed_alarms += t_test(m, (double)pi, 0) < alarm;
    }
    /* expected 90 % low, 70 % missed; a fair interval misses 5 %: 30 % of 100 is beyond 1e-16 */
    check_at_least(low, runs * 7 / 10, "cos^20: runs that are too low, of %zu", runs);
    check_at_least(missed, runs * 4 / 10, "cos^20: 95 %% intervals that miss pi, of %zu", runs);
    check_at_least(alarms, runs / 50, "cos^20: t-tests that alarm, of %zu", runs);
    check_at_most(mixed_missed, runs * 2 / 10, "mixed: intervals that miss pi, of %zu", runs);
    check_equal(mixed_alarms, 0, "mixed: t-tests that alarm");
    /* p = 0 where f > 0: the interval is small and wrong; z > 1/2 holds 3/4 of the integral */
    estimate cut = {0};
    direction_cone c = cone_of_angle(pi / 3);
    for (size_t i = 0; i < check_count(100000); i++) {
        random_stream s = random_start(7, 0, i);
        real u = random_next(&s), v = random_next(&s);
        vec3 w = sample_cone(c, u, v);
        cut = estimate_add(cut, (double)w.z / (double)pdf_cone(c, w));
    }
    check_at_most(t_test(cut, (double)pi, 0), alarm, "a cone of 60 degrees misses a part");
    check_at_least(t_test(cut, 0.75 * (double)pi, 1e-5), alarm, "and finds three quarters");
}

/* Medians of the error fall as N^(-2/(n+1)). From N = 16 to 1024 sixty other seeds gave slopes with
 * a sigma of .011 for n = 8, .0053 for n = 20, and 30,000 runs -.217 and -.095: within .006 of the
 * limit. The bounds are that and 5.7 sigma; 0 is 12 sigma outside of n = 20. */
static void test_slopes_of_importance(void)
{
    enum { runs = 400 };
    for (int k = 0; k < 2; k++) {
        real lobe = k ? 20 : 8;
        double median[2], error[runs];
        for (int l = 0; l < 2; l++) {
            for (int run = 0; run < runs; run++)
                error[run] = fabs(importance_run(lobe, 0, 8, (uint64_t)run, l ? 1024 : 16).mean
                                  - (double)pi);
            median[l] = clock_median(error, runs);
        }
        check_close(log(median[1] / median[0]) / log(64.0), -2 / ((double)lobe + 1),
                    k ? 0.031 : 0.069, "slope for n = %g", (double)lobe);
    }
}

int main(void)
{
    return check_all("20_monte_carlo", test_exact_values, test_variances, test_hash,
                     test_four_times_the_rays, test_importance, test_weights, test_fatal,
                     test_slopes_of_importance);
}
