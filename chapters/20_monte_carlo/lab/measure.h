/* measure.h: tables about points and rays.
 *
 *   measure_slopes(o, c)      slopes, beside the theory
 *   measure_rays(o)           twice, four times the rays: what halves, what quarters
 *   measure_maps(o)           well-spread points through three maps to the disk
 *   measure_scrambles(o)      two hashes for Owen's scrambling against the exact variance
 */
#ifndef MEASURE_H
#define MEASURE_H

#include "../../../common/lab/report.h"
#include "convergence.h"
#include "sampling_naive.h"

/* ---------------------------------------------------------------------------------------------- */

static inline void measure_slopes(const options *o, const convergence *c)
{
    static const char *const theory[sequence_kinds][integrands] = {
        {"-1/2", "-1/2"}, {"-1", "-3/4"}, {"-1, log", "-"}, {"-1, log", "-"},
        {"-1, log", "-"}, {"-3/2, log", "-3/4"}};
    table t = table_new("Slopes of the error against N, 95 % of the time within -+", "method|f|"
                        "theory|exact, these N|error slope|error -+");
    for (int k = 0; k < sequence_kinds; k++)
        for (int f = 0; f < integrands; f++) {
            line_fit fit = convergence_slope(c, k, (integrand)f);
            double exact = convergence_exact_slope(k, (integrand)f, c->levels).slope;
            table_text(&t, "%s", sequence_name[k]), table_text(&t, "%s", f ? "edge" : "smooth");
            table_text(&t, "%s", theory[k][f]);
            table_text(&t, isnan(exact) ? "-" : "%.3f", exact);
            table_number(&t, fit.slope), table_number(&t, slope_interval(fit, 0.95));
        }
    output_extra_table(o, &t);
}

/* A pixel that a silhouette crosses, by random samples: variance over many runs. */
static inline estimate rays_variance(uint64_t seed, uint32_t n, int runs)
{
    estimate e = {0};
    for (int run = 0; run < runs; run++) {
        double error[integrands];
        integrand_errors(SEQUENCE_RANDOM, seed, (uint64_t)run, n, error);
        e = estimate_add(e, error[EDGE]);
    }
    return e;
}

static inline void measure_rays(const options *o)
{
    enum { n = 64 };
    int runs = o->quick ? 1000 : 8000;
    estimate one = rays_variance(o->seed, n, runs);
    table t = table_new("What more rays do to a pixel at a silhouette", "rays|error variance|"
                        "of the first|error deviation|of the first|p, variance halved|"
                        "p, variance as 1/rays");
    for (uint32_t times = 1; times <= 4; times *= 2) {
        estimate e = times == 1 ? one : rays_variance(o->seed + times, n * times, runs);
        double v = estimate_variance(e), v1 = estimate_variance(one);
        table_count(&t, n * times);
        table_number(&t, v), table_number(&t, v / v1);
        table_number(&t, sqrt(v)), table_number(&t, sqrt(v / v1));
        if (times == 1) table_text(&t, "-"), table_text(&t, "-");
        else table_number(&t, variance_ratio_test(one, e, 0.5)),
             table_number(&t, variance_ratio_test(one, e, 1.0 / times));
    }
    output_extra_table(o, &t);
}

/* ---- maps, hashes ---- */

typedef vec3 disk_map(real u, real v);

/* The mean of x^2 over the disk is 1/4. */
static inline double map_error(disk_map *map, uint64_t seed, uint64_t run, uint32_t n)
{
    double sum = 0;
    for (uint32_t i = 0; i < n; i++) {
        sampler s = sampler_start(SEQUENCE_SOBOL, seed, run, i, n);
        point2 p = sampler_pair(&s);
        double x = (double)map(p.u, p.v).x;
        sum += x * x;
    }
    return sum / n - 0.25;
}

static inline void measure_maps(const options *o)
{
    static const struct { const char *name; disk_map *map; } row[3] = {
        {"sample_disk", sample_disk}, {"sample_disk_polar", sample_disk_polar},
        {"sample_disk_rejection", sample_disk_rejection}};
    table t = table_new("The mean of x^2 over a disk by Sobol' points (Owen) through three maps",
                        "map|error N = 64|error N = 1024|error slope");
    for (int k = 0; k < 3; k++) {
        double rms[2];
        for (int l = 0; l < 2; l++) {
            estimate e = {0};
            for (uint64_t run = 0; run < (o->quick ? 30 : 300); run++) {
                double x = map_error(row[k].map, o->seed, run, l ? 1024 : 64);
                e = estimate_add(e, x * x);
            }
            rms[l] = sqrt(e.mean);
        }
        table_text(&t, "%s", row[k].name), table_number(&t, rms[0]), table_number(&t, rms[1]);
        table_number(&t, log(rms[1] / rms[0]) / log(16.0));
    }
    output_extra_table(o, &t);
}

typedef uint32_t scramble(uint32_t x, uint32_t seed);

/* The squared error of e^(x+y) over 2^m points, scrambled by `how`. */
static inline estimate scramble_squares(scramble *how, uint64_t seed, int m, int runs)
{
    estimate e = {0};
    for (int run = 0; run < runs; run++) {
        uint64_t axes = random_bits(seed, (uint64_t)run, 0, 0);
        uint32_t a = (uint32_t)axes, b = (uint32_t)(axes >> 32);
        double sum = 0, n = ldexp(1, m);
        for (uint32_t i = 0; i < (uint32_t)1 << m; i++) {
            uint32_t x = how(sobol_x(i), a), y = how(sobol_y(i), b);
            point2 p = {real_of_fraction(x, a), real_of_fraction(y, b)};
            sum += integrand_value(SMOOTH, p);
        }
        double error = sum / n - integrand_integral(SMOOTH);
        e = estimate_add(e, error * error);
    }
    return e;
}

static inline void measure_scrambles(const options *o)
{
    static const struct { const char *name; scramble *how; } row[3] = {
        {"owen_scramble_exact", owen_scramble_exact}, {"owen_scramble_2020", owen_scramble_2020},
        {"owen_scramble", owen_scramble}};
    table t = table_new("Hashes for Owen's scrambling: variance of e^(x+y), 1 is right; p of a "
                        "t-test", "hash|N = 16|p|N = 32|p|N = 64|p|N = 256|p");
    for (int k = 0; k < 3; k++) {
        table_text(&t, "%s", row[k].name);
        for (int m = 4; m <= 8; m += m < 6 ? 1 : 2) {
            double exact = deviation_sobol(m) * deviation_sobol(m);
            estimate e = scramble_squares(row[k].how, o->seed, m, o->quick ? 100 : 2000);
            table_number(&t, e.mean / exact), table_number(&t, t_test(e, exact, 0));
        }
    }
    output_extra_table(o, &t);
}

#endif
