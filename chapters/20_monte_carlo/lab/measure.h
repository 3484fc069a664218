/* measure.h: tables and plots: errors against N and time; more rays.
 *
 *   measure_methods(&o)    error and time of five ways to integrate; with --full a plot against
 *                          time, and slopes beside the theory
 *   measure_rays(&o)       twice, four times the rays: what halves, what quarters
 *   measure_importance(&o) one integral, many pdfs: variance, and how often the interval that the
 *                          samples themselves report holds the truth
 */
#ifndef MONTE_CARLO_MEASURE_H
#define MONTE_CARLO_MEASURE_H

#include "../../../common/lab/bench.h"
#include "../../../common/lab/report.h"
#include "../importance.h"
#include "convergence.h"

/* ---- five ways ------------------------------------------------------------------------------ */

typedef struct { int method; uint64_t seed; uint32_t n; } monte_carlo_timed;

static inline double run_estimate(void *context)
{
    const monte_carlo_timed *e = context;
    double error[integrands];
    convergence_errors(e->method, e->seed, 0, e->n, error);
    return error[SMOOTH] + error[EDGE];
}

static inline void number_or_dash(table *t, double x)
{
    if (isnan(x)) table_text(t, "-");
    else table_number(t, x);
}

/* ns a sample, at 1024 samples: it hardly depends on their number. */
static inline void measure_time(const options *o, double ns[convergence_methods])
{
    monte_carlo_timed e[convergence_methods];
    for (int k = 0; k < convergence_methods; k++) e[k] = (monte_carlo_timed){k, o->seed, 1024};
    bench_each(run_estimate, e, sizeof *e, convergence_methods, o->full ? 99 : o->quick ? 5 : 31,
               1e9 / 1024, ns);
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

static inline void measure_slopes(const options *o, const convergence *c)
{
    static const char *const theory[sequence_kinds][integrands] = {
        {"-1/2", "-1/2"}, {"-1", "-3/4"}, {"-1, log", "-"}, {"-3/2, log", "-3/4"}};
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

static inline void measure_methods(const options *o)
{
    double ns[convergence_methods];
    convergence *c = convergence_measure(o->full ? 0 : 3, o->full ? 6 : 4, o->quick ? 48 : 480,
                                         o->seed, o->threads);
    table t = table_new("Root mean square error of two integrals by 1024 samples, its exact "
                        "value, and time",
                        "method|N|exact smooth|error smooth|exact edge|error edge|time [us]");
    measure_time(o, ns);
    for (int k = 0; k < convergence_methods; k++) {
        table_text(&t, "%s", convergence_name(k)), table_count(&t, convergence_n(3));
        for (int f = 0; f < integrands; f++) {
            number_or_dash(&t, convergence_exact(k, (integrand)f, 3));
            table_number(&t, convergence_rms(c, k, (integrand)f, 3));
        }
        table_number(&t, convergence_n(3) * ns[k] / 1000);
    }
    output_table(o, &t);
    if (o->full) {
        methods_plot(o, c, ns);
        measure_slopes(o, c);
    }
    free(c);
}

/* ---- more rays ------------------------------------------------------------------------------- */

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
    enum { n = 64, runs = 8000 };
    estimate one = rays_variance(o->seed, n, runs);
    table t = table_new("What more rays do to a pixel at a silhouette", "rays|error variance|"
                        "of the first|error deviation|of the first");
    for (uint32_t times = 1; times <= 4; times *= 2) {
        estimate e = times == 1 ? one : rays_variance(o->seed + times, n * times, runs);
        double v = estimate_variance(e), v1 = estimate_variance(one);
        table_count(&t, n * times);
        table_number(&t, v), table_number(&t, v / v1);
        table_number(&t, sqrt(v)), table_number(&t, sqrt(v / v1));
    }
    output_extra_table(o, &t);
}

/* ---- one integral, many pdfs ----------------------------------------------------------------- */

enum { importance_rows = 6, importance_n = 4096, importance_most_runs = 400 };
static const struct { const char *name; double n, a; } importance_row[importance_rows] = {
    {"n = 0, uniform", 0, 0}, {"n = 1, cosine", 1, 0}, {"n = 2", 2, 0},
    {"n = 8", 8, 0}, {"n = 20", 20, 0}, {"n = 20, mixed", 20, 0.2}};

typedef struct {
    uint64_t seed;
    int runs, holds[importance_rows];   /* runs whose interval holds the truth */
    double error[importance_rows][importance_most_runs];
    estimate variance[importance_rows];
} importance_survey;

static inline void importance_job(size_t row, void *context)
{
    importance_survey *s = context;
    for (int run = 0; run < s->runs; run++) {
        estimate e = importance_run((real)importance_row[row].n, (real)importance_row[row].a,
                                    s->seed, (uint64_t)run, importance_n);
        s->error[row][run] = fabs(e.mean - (double)pi);
        s->holds[row] += t_test(e, (double)pi, 1e-6) >= 0.05;
        s->variance[row] = estimate_add(s->variance[row], estimate_variance(e));
    }
}

static inline void measure_importance(const options *o)
{
    table t = table_new("The irradiance under a white sky, pi, by many pdfs, N = 4096",
                        "pdf|largest weight|exact variance|error variance|error median|"
                        "error interval holds pi [%]");
    importance_survey *s = allocate(1, sizeof *s);
    s->seed = o->seed, s->runs = o->quick ? 40 : importance_most_runs;
    parallel_whole(importance_rows, o->threads, "importance", importance_job, s);
    for (int r = 0; r < importance_rows; r++) {
        double n = importance_row[r].n, a = importance_row[r].a, p = (double)pi;
        bool exact = n == 1;  /* but for roundings */
        table_text(&t, "%s", importance_row[r].name);
        table_number(&t, a > 0 ? p / a : n <= 1 ? 2 * p / (n + 1) : (double)INFINITY);
        number_or_dash(&t, a > 0 ? (double)NAN : importance_variance(n));
        table_number(&t, exact ? 0 : s->variance[r].mean);
        table_number(&t, exact ? 0 : clock_median(s->error[r], s->runs));
        table_number(&t, 100.0 * s->holds[r] / s->runs);
    }
    free(s);
    output_extra_table(o, &t);
}

#endif
