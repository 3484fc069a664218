/* convergence.h: how fast errors fall, measured.
 *
 *   convergence *c = convergence_measure(from, levels, runs, seed, threads);  all methods, the
 *                                        levels from `from` to levels - 1; free(c)
 *   convergence_rms(c, method, f, level) root of the mean square error of the runs, N = 16 4^level
 *   convergence_slope(c, method, f)      of its logarithm against log N, with its uncertainty
 *
 * A method is a sequence_kind, or CONVERGENCE_FIRST, the notes' own way.
 *
 * Each run is an estimate with random numbers of its own (its number is the "pixel"). Halton's
 * points have none: all runs are the same, and its error is that of one set of
 * points.
 */
#ifndef MONTE_CARLO_CONVERGENCE_H
#define MONTE_CARLO_CONVERGENCE_H

#include "../../../common/parallel.h"
#include "integrands.h"
#include "../t_test.h"

enum { CONVERGENCE_FIRST = sequence_kinds, convergence_methods };
enum { convergence_levels = 6 };
typedef struct {
    int from, levels, runs;
    uint64_t seed;
    estimate square[convergence_methods][convergence_levels][integrands];   /* of squared errors */
} convergence;

/* ---------------------------------------------------------------------------------------------- */

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

static inline convergence *convergence_measure(int from, int levels, int runs, uint64_t seed,
                                               int threads)
{
    convergence *c = allocate(1, sizeof *c);
    c->from = from, c->levels = levels, c->runs = runs, c->seed = seed;
    parallel_whole((size_t)(levels - from) * convergence_methods, threads, "convergence",
                   convergence_job, c);
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
    if (method == SEQUENCE_JITTERED) return deviation_jittered(f, 4 << level);
    if (method == SEQUENCE_SOBOL && f == SMOOTH) return deviation_sobol(4 + 2 * level);
    return (double)NAN;
}

static inline line_fit convergence_fit(const double *error, int levels)
{
    double x[convergence_levels] = {0}, y[convergence_levels] = {0};
    for (int l = 0; l < levels; l++) x[l] = log(convergence_n(l)), y[l] = log(error[l]);
    return fit_line(x, y, (size_t)levels);
}

static inline line_fit convergence_slope(const convergence *c, int method, integrand f)
{
    double error[convergence_levels] = {0};
    for (int l = 0; l < c->levels; l++) error[l] = convergence_rms(c, method, f, l);
    return convergence_fit(error, c->levels);
}

static inline line_fit convergence_exact_slope(int method, integrand f, int levels)
{
    double error[convergence_levels] = {0};
    for (int l = 0; l < levels; l++) error[l] = convergence_exact(method, f, l);
    return convergence_fit(error, levels);
}

#endif
