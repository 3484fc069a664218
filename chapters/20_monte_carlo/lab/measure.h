/* measure.h: tables and plots: errors against N and time; many pdfs.
 *
 *   measure_methods(&o)    error and time of five ways to integrate; with --full their plot
 *   measure_importance(&o) one integral, many pdfs: variance, and how often the interval that the
 *                          samples themselves report holds the truth
 *
 *   convergence *c = convergence_measure(levels, runs, seed, threads);       free(c)
 *   convergence_rms(c, method, f, level) root of the mean square error of the runs, N = 16 4^level
 *
 * A method is a sequence_kind, or CONVERGENCE_FIRST, the notes' own way. Each run is an estimate
 * with random numbers of its own (its number is the "pixel"); Halton's points have none.
 */
#ifndef MONTE_CARLO_MEASURE_H
#define MONTE_CARLO_MEASURE_H

#include "../../../common/lab/bench.h"
#include "../../../common/lab/report.h"
#include "../../../common/lab/t_test.h"
#include "../../../common/parallel.h"
#include "integrands.h"

/* ---- how fast errors fall ---- */

enum { CONVERGENCE_FIRST = sequence_kinds, convergence_methods };
enum { convergence_levels = 6 };
typedef struct {
    int levels, runs;
    uint64_t seed;
    estimate square[convergence_methods][convergence_levels][integrands];   /* of squared errors */
} convergence;

static inline uint32_t convergence_n(int level) { return (uint32_t)16 << 2 * level; }

static inline const char *convergence_name(int method)
{
    return method == CONVERGENCE_FIRST ? "first" : sequence_name[method];
}

static inline void convergence_errors(int method, uint64_t seed, uint64_t run, uint32_t n,
                                      double error[integrands])
{
    if (method == CONVERGENCE_FIRST) first_errors(seed, run, n, error);
    else integrand_errors((sequence_kind)method, seed, run, n, error);
}

/* Pieces of work: the long ones first, so that the threads end together. */
static inline void convergence_job(size_t i, void *context)
{
    convergence *c = context;
    int method = (int)i % convergence_methods, level = c->levels - 1 - (int)i / convergence_methods;
    for (int run = 0; run < c->runs; run++) {
        double error[integrands];
        convergence_errors(method, c->seed, (uint64_t)run, convergence_n(level), error);
        for (int f = 0; f < integrands; f++) {
            estimate *e = &c->square[method][level][f];
            *e = estimate_add(*e, error[f] * error[f]);
        }
    }
}

static inline convergence *convergence_measure(int levels, int runs, uint64_t seed, int threads)
{
    convergence *c = allocate(1, sizeof *c);
    c->levels = levels, c->runs = runs, c->seed = seed;
    parallel_whole((size_t)levels * convergence_methods, threads, "convergence", convergence_job,
                   c);
    return c;
}

static inline double convergence_rms(const convergence *c, int method, integrand f, int level)
{
    return sqrt(c->square[method][level][f].mean);
}

/* The exact one, where integrands.h knows it; otherwise NaN. */
static inline double convergence_exact(int method, integrand f, int level)
{
    if (method == SEQUENCE_RANDOM || method == CONVERGENCE_FIRST)
        return deviation_random(f, convergence_n(level));
    if (f == SMOOTH && method == SEQUENCE_JITTERED) return deviation_jittered(4 << level);
    if (f == SMOOTH && method == SEQUENCE_SOBOL) return deviation_sobol(4 + 2 * level);
    return (double)NAN;
}

/* Of 1024 samples: the time of one hardly depends on their number. */
static inline double run_estimate(void *method)
{
    double error[integrands];
    convergence_errors(*(int *)method, 1, 0, 1024, error);
    return error[SMOOTH] + error[EDGE];
}

static inline void number_or_dash(table *t, double x)
{
    if (isnan(x)) table_text(t, "-");
    else table_number(t, x);
}

static inline void methods_plot(const options *o, const convergence *c, const double *ns)
{
    plot p = plot_new("Error of a smooth integral, and time", "time of an estimate [us]", "error",
                      PLOT_LOG_X | PLOT_LOG_Y);
    for (int k = 0; k < convergence_methods; k++) {
        int series = plot_series(&p, convergence_name(k));
        for (int l = 0; l < c->levels; l++)
            plot_add(&p, series, convergence_n(l) * ns[k] / 1000, convergence_rms(c, k, SMOOTH, l));
    }
    plot_slope(&p, -0.5, "slope -1/2");
    output_plot(o, &p, "20_monte_carlo_time.svg");
}

static inline void measure_methods(const options *o)
{
    double ns[convergence_methods];
    int method[convergence_methods] = {0, 1, 2, 3, 4};
    convergence *c = convergence_measure(o->full ? 6 : 4, o->quick ? 48 : 480, o->seed, o->threads);
    table t = table_new("Root mean square error of two integrals by 1024 samples, its exact "
                        "value, and time",
                        "method|exact smooth|error smooth|exact edge|error edge|time [us]");
    bench_each(run_estimate, method, sizeof *method, convergence_methods,
               o->full ? 99 : o->quick ? 5 : 31, 1e9 / 1024, ns);
    for (int k = 0; k < convergence_methods; k++) {
        table_text(&t, "%s", convergence_name(k));
        for (int f = 0; f < integrands; f++) {
            number_or_dash(&t, convergence_exact(k, (integrand)f, 3));
            table_number(&t, convergence_rms(c, k, (integrand)f, 3));
        }
        table_number(&t, convergence_n(3) * ns[k] / 1000);
    }
    output_table(o, &t);
    if (o->full) methods_plot(o, c, ns);
    free(c);
}

/* ---- one integral, many pdfs ---- */

enum { importance_rows = 6, importance_n = 4096 };
static const struct { const char *name; double n, a; } importance_row[importance_rows] = {
    {"n = 0, uniform", 0, 0}, {"n = 1, cosine", 1, 0}, {"n = 2", 2, 0},
    {"n = 8", 8, 0}, {"n = 20", 20, 0}, {"n = 20, mixed", 20, 0.2}};

typedef struct {
    uint64_t seed;
    int runs, holds[importance_rows];   /* runs whose interval holds the truth */
    estimate variance[importance_rows];
} importance_survey;

static inline void importance_job(size_t row, void *context)
{
    importance_survey *s = context;
    for (int run = 0; run < s->runs; run++) {
        estimate e = importance_run((real)importance_row[row].n, (real)importance_row[row].a,
                                    s->seed, (uint64_t)run, importance_n);
        s->holds[row] += t_test(e, (double)pi, 1e-6) >= 0.05;
        s->variance[row] = estimate_add(s->variance[row], estimate_variance(e));
    }
}

static inline void measure_importance(const options *o)
{
    table t = table_new("The irradiance under a white sky, pi, by many pdfs, N = 4096",
                        "pdf|largest weight|exact variance|error variance|"
                        "error interval holds pi [%]");
    importance_survey s = {.seed = o->seed, .runs = o->quick ? 40 : 400};
    parallel_whole(importance_rows, o->threads, "importance", importance_job, &s);
    for (int r = 0; r < importance_rows; r++) {
        double n = importance_row[r].n, a = importance_row[r].a, p = (double)pi;
        table_text(&t, "%s", importance_row[r].name);
        table_number(&t, a > 0 ? p / a : n <= 1 ? 2 * p / (n + 1) : (double)INFINITY);
        number_or_dash(&t, a > 0 ? (double)NAN : importance_variance(n));
        table_number(&t, n == 1 ? 0 : s.variance[r].mean);  /* 0 but for roundings */
        table_number(&t, 100.0 * s.holds[r] / s.runs);
    }
    output_extra_table(o, &t);
}

#endif
