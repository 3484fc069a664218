/* measure_importance.h: one integral, many pdfs.
 *
 *   measure_importance(o)   table and plot: variance, slope of the error, and how often the
 *                           interval that the samples themselves report holds the truth
 */
#ifndef MONTE_CARLO_MEASURE_IMPORTANCE_H
#define MONTE_CARLO_MEASURE_IMPORTANCE_H

#include "../../../common/lab/report.h"
#include "../importance.h"
#include "../t_test.h"

/* ---------------------------------------------------------------------------------------------- */

enum { importance_rows = 8, importance_levels = 5, importance_most_runs = 400 };
static const struct { const char *name; double n, a; } importance_row[importance_rows] = {
    {"n = 0, uniform", 0, 0}, {"n = 1, cosine", 1, 0}, {"n = 2", 2, 0}, {"n = 4", 4, 0},
    {"n = 8", 8, 0}, {"n = 20", 20, 0}, {"n = 20, mixed", 20, 0.2}, {"cone of 60 degrees", -1, 0}};

typedef struct {
    uint64_t seed;
    int runs;
    double error[importance_rows][importance_levels][importance_most_runs];
    int holds[importance_rows];         /* runs whose interval holds the truth, of the last level */
    double variance[importance_rows];
} importance_survey;

static inline size_t importance_n(int level) { return (size_t)16 << 2 * level; }

static inline void importance_job(size_t i, void *context)
{
    importance_survey *s = context;
    int row = (int)(i / importance_levels), level = (int)(i % importance_levels);
    estimate all = {0};
    for (int run = 0; run < s->runs; run++) {
        real n = (real)importance_row[row].n, a = (real)importance_row[row].a;
        uint64_t r = (uint64_t)run;
        estimate e = n < 0 ? importance_run_cone(pi / 3, s->seed, r, importance_n(level))
                           : importance_run(n, a, s->seed, r, importance_n(level));
        s->error[row][level][run] = fabs(e.mean - (double)pi);
        if (level < importance_levels - 1) continue;
        s->holds[row] += t_test(e, (double)pi, 1e-6) >= 0.05;
        all = estimate_add(all, estimate_variance(e));
    }
    if (level == importance_levels - 1) s->variance[row] = all.mean;
}

static inline double importance_largest(int row)
{
    double n = importance_row[row].n, a = importance_row[row].a;
    if (n < 0) return (double)pi;  /* pi z, z in [1/2, 1] */
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
    table t = table_new("The irradiance under a white sky, pi, by many pdfs; median error at "
                        "N = 4096", "pdf|largest weight|exact variance|error variance|exact slope|"
                        "error slope|error median|error interval holds pi [%]");
    plot p = plot_new("The irradiance under a white sky", "N", "error, median of the runs",
                      PLOT_LOG_X | PLOT_LOG_Y);
    importance_survey *s = allocate(1, sizeof *s);
    s->seed = o->seed, s->runs = o->quick ? 40 : importance_most_runs;
    parallel_whole(importance_rows * importance_levels, o->threads, "importance", importance_job,
                   s);
    for (int r = 0; r < importance_rows; r++) {
        double x[importance_levels], y[importance_levels], median = 0, n = importance_row[r].n;
        bool exact = n == 1;
        plot_series(&p, importance_row[r].name);
        for (int l = 0; l < importance_levels; l++) {
            median = clock_median(s->error[r][l], s->runs);
            x[l] = log((double)importance_n(l)), y[l] = log(median);
            plot_add(&p, r, (double)importance_n(l), median > 1e-6 ? median : 0);
        }
        table_text(&t, "%s", importance_row[r].name);
        table_number(&t, importance_largest(r));
        if (importance_row[r].a > 0) table_text(&t, "-");
        else table_number(&t, importance_exact(r));
        table_number(&t, exact ? 0 : s->variance[r]);
        if (exact) table_text(&t, "-"), table_text(&t, "-");
        else table_number(&t, n < 0 ? 0 : importance_row[r].a > 0 ? -0.5 : importance_slope(n)),
             table_number(&t, fit_line(x, y, importance_levels).slope);
        table_number(&t, exact ? 0 : median), table_number(&t, 100.0 * s->holds[r] / s->runs);
    }
    free(s);
    output_extra_table(o, &t);
    output_plot(o, &p, "20_monte_carlo_importance.svg");
}

#endif
