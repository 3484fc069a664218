/* measure.h: the tables of this chapter but the main one.
 *
 *   measure_slopes(o, c)      slopes, beside the theory
 *   measure_rays(o)           twice, four times the rays: what halves, what quarters
 *   measure_importance(o)     one integral, many pdfs; and its plot
 *   measure_maps(o)           well-spread points through three maps to the disk
 *   measure_scrambles(o)      two hashes for Owen's scrambling against the exact variance
 *   measure_sums(o), measure_variances(o)    what float forgets
 */
#ifndef MEASURE_H
#define MEASURE_H

#include "../../common/output.h"
#include "convergence.h"
#include "importance.h"
#include "sampling_naive.h"
#include "sum.h"

/* ---------------------------------------------------------------------------------------------- */

static inline void measure_slopes(const options *o, const convergence *c)
{
    static const char *const theory[sequence_kinds][integrands] = {
        {"-1/2", "-1/2"}, {"-1", "-3/4"}, {"-1, log", "-"}, {"-1, log", "-3/4"},
        {"-1, log", "-"}, {"-3/2, log", "-3/4"}};
    table t = table_new("Slopes of the error against N, 95 % of the time within -+", "method|f|"
                        "theory|exact, these N|error slope|error -+");
    for (int k = 0; k < sequence_kinds; k++)
        for (int f = 0; f < integrands; f++) {
            line_fit fit = convergence_slope(c, (sequence_kind)k, (integrand)f);
            double exact = convergence_exact_slope((sequence_kind)k, (integrand)f, c->levels).slope;
            table_text(&t, "%s", sequence_name[k]), table_text(&t, "%s", f ? "edge" : "smooth");
            table_text(&t, "%s", theory[k][f]);
            table_text(&t, isnan(exact) ? "-" : "%.3f", exact);
            table_number(&t, fit.slope), table_number(&t, line_interval(fit, 0.95));
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

/* ---- importance sampling ---- */

enum { importance_rows = 8, importance_levels = 5 };
static const struct { const char *name; double n, a; } importance_row[importance_rows] = {
    {"n = 0, uniform", 0, 0}, {"n = 1, cosine", 1, 0}, {"n = 2", 2, 0}, {"n = 4", 4, 0},
    {"n = 8", 8, 0}, {"n = 20", 20, 0}, {"n = 20, mixed", 20, 0.2}, {"cone of 60 degrees", -1, 0}};

typedef struct {
    uint64_t seed;
    int runs;
    double *error[importance_rows][importance_levels];   /* of each run */
    bool *holds[importance_rows];                        /* the interval, of the last level */
    double variance[importance_rows], largest[importance_rows];
} importance_survey;

static inline size_t importance_n(int level) { return (size_t)16 << 2 * level; }

static inline void importance_job(size_t i, void *context)
{
    importance_survey *s = context;
    int row = (int)(i / importance_levels), level = (int)(i % importance_levels);
    estimate all = {0};
    for (int run = 0; run < s->runs; run++) {
        real n = (real)importance_row[row].n, a = (real)importance_row[row].a;
        estimate e = n < 0 ? importance_run_cone(pi / 3, s->seed, (uint64_t)run, importance_n(level))
                           : importance_run(n, a, s->seed, (uint64_t)run, importance_n(level));
        s->error[row][level][run] = fabs(e.mean - (double)pi);
        if (level < importance_levels - 1) continue;
        s->holds[row][run] = t_test(e, (double)pi, 1e-6) >= 0.05;
        all = estimate_add(all, estimate_variance(e));
    }
    if (level == importance_levels - 1) s->variance[row] = all.mean;
}

static inline double importance_holds(const importance_survey *s, int row)
{
    int n = 0;
    for (int run = 0; run < s->runs; run++) n += s->holds[row][run];
    return 100.0 * n / s->runs;
}

static inline double importance_largest(int row)
{
    double n = importance_row[row].n, a = importance_row[row].a;
    if (n < 0) return (double)pi / 2;
    if (n <= 1) return 2 * (double)pi / (n + 1);
    return a > 0 ? (double)pi / a : (double)INFINITY;
}

/* Not for the mixture: finite, but without a simple formula. */
static inline double importance_exact(int row)
{
    double n = importance_row[row].n, p = (double)pi;
    return n >= 0 ? importance_variance(n) : p * p / 48;  /* of pi z, z uniform in [1/2, 1] */
}

static inline void measure_importance(const options *o)
{
    table t = table_new("The irradiance under a white sky, pi, by many pdfs; error: the median, N = 4096",
                        "pdf|largest weight|exact variance|error variance|exact slope|error slope|"
                        "error median|error interval holds pi [%]");
    plot p = plot_new("The irradiance under a white sky", "N", "error, median of the runs",
                      PLOT_LOG_X | PLOT_LOG_Y);
    importance_survey s = {.seed = o->seed, .runs = o->quick ? 40 : 400};
    for (int r = 0; r < importance_rows; r++) {
        s.holds[r] = allocate((size_t)s.runs, sizeof *s.holds[r]);
        for (int l = 0; l < importance_levels; l++)
            s.error[r][l] = allocate((size_t)s.runs, sizeof *s.error[r][l]);
    }
    parallel_for(importance_rows * importance_levels, o->threads, "importance", importance_job, &s);
    for (int r = 0; r < importance_rows; r++) {
        double x[importance_levels], y[importance_levels], median = 0, n = importance_row[r].n;
        bool exact = n == 1;
        plot_series(&p, importance_row[r].name);
        for (int l = 0; l < importance_levels; l++) {
            median = clock_median(s.error[r][l], s.runs);
            x[l] = log((double)importance_n(l)), y[l] = log(median);
            plot_add(&p, r, (double)importance_n(l), median > 1e-6 ? median : 0);
        }
        table_text(&t, "%s", importance_row[r].name);
        table_number(&t, importance_largest(r));
        if (importance_row[r].a > 0) table_text(&t, "-");
        else table_number(&t, importance_exact(r));
        table_number(&t, exact ? 0 : s.variance[r]);
        if (exact) table_text(&t, "-"), table_text(&t, "-");
        else table_number(&t, n < 0 ? 0 : importance_row[r].a > 0 ? -0.5 : importance_slope(n)),
             table_number(&t, fit_line(x, y, importance_levels).slope);
        table_number(&t, exact ? 0 : median), table_number(&t, importance_holds(&s, r));
        for (int l = 0; l < importance_levels; l++) free(s.error[r][l]);
        free(s.holds[r]);
    }
    output_extra_table(o, &t);
    output_plot(o, &p, "20_monte_carlo_importance.svg");
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
    table t = table_new("Hashes for Owen's scrambling: variance of e^(x+y), 1 is right; p of a t-test",
                        "hash|N = 16|p|N = 32|p|N = 64|p|N = 256|p");
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

/* ---- what float forgets ---- */

static inline void measure_sums(const options *o)
{
    table t = table_new("The sum of n ones, and of n tenths: relative error", "n|ones, float|"
                        "ones, float, sum_add|ones, double|tenths, float|tenths, float, sum_add|"
                        "tenths, double");
    for (int m = 12; m <= (o->quick ? 20 : 26); m += o->quick ? 4 : 2) {
        table_count(&t, (size_t)1 << m);
        for (int k = 0; k < 2; k++) {
            float x = k ? 0.1f : 1.0f, naive = 0;
            running_sum_f32 kept = {0, 0};
            double sum = 0, right = ldexp((double)x, m);
            for (int i = 0; i < 1 << m; i++)
                naive = sum_add_naive_f32(naive, x), kept = sum_add_f32(kept, x), sum += (double)x;
            table_number(&t, fabs((double)naive / right - 1));
            table_number(&t, fabs((double)kept.sum / right - 1));
            table_number(&t, fabs(sum / right - 1));
        }
    }
    output_extra_table(o, &t);
}

/* 1000 numbers, uniform about `mean`, deviation 1; steps of 1/1024, which floats of 1e4 have. `out`:
 * the variance three ways, in parts of the true one. */
static inline void variances_of(double mean, uint64_t seed, uint64_t set, double out[3])
{
    enum { n = 1000 };
    moments_f32 m = {0, 0};
    double sum = 0, squares = 0;
    estimate e = {0}, centred = {0};
    for (uint64_t i = 0; i < n; i++) {
        double u = random_double_of(random_bits(seed, set, i, 0));
        double off = floor((2 * u - 1) * sqrt(3.0) * 1024) / 1024, x = mean + off;
        m = moments_add_f32(m, (float)x), sum += x, squares += x * x;
        e = estimate_add(e, x), centred = estimate_add(centred, off);
    }
    double v = estimate_variance(centred);
    out[0] = (double)moments_variance_f32(m, n) / v;
    out[1] = (squares / n - sum / n * (sum / n)) * n / (n - 1) / v;
    out[2] = estimate_variance(e) / v;
}

static inline void measure_variances(const options *o)
{
    static const double means[5] = {1, 100, 1000, 1e4, 1e8};
    int sets = o->quick ? 40 : 1000;
    table t = table_new("Variance of 1000 numbers of deviation 1 by E[x^2] - E[x]^2, and by estimate.h: "
                        "worst relative error", "mean|error float|negative [%]|error double|"
                        "negative [%]|error estimate|negative [%]");
    for (int k = 0; k < 5; k++) {
        double negative[3] = {0}, worst[3] = {0}, v[3];
        for (int set = 0; set < sets; set++) {
            variances_of(means[k], o->seed, (uint64_t)set, v);
            for (int way = 0; way < 3; way++) {
                double off = fabs(v[way] - 1);
                negative[way] += 100.0 * (v[way] < 0) / sets;
                worst[way] = off > worst[way] ? off : worst[way];
            }
        }
        table_number(&t, means[k]);
        for (int way = 0; way < 3; way++) {
            bool known = way > 0 || means[k] < 1e5;  /* beyond, floats lie 8 apart */
            if (known) table_number(&t, worst[way]), table_number(&t, negative[way]);
            else table_text(&t, "-"), table_text(&t, "-");
        }
    }
    output_extra_table(o, &t);
}

#endif
