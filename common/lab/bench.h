/* bench.h: candidates timed side by side, on a machine that has other things to do.
 *
 *   bench_candidate c[] = {{.name = "naive", .run = run_naive, .context = &data}, ...};
 *   bench_time(c, 2, 7);           7 rounds A B A B .., after one that only warms up
 *   c[0].seconds                   the median of its rounds
 *   c[0].spread                    half the way between its quartiles, over the median: 0.02 is a
 *                                  calm machine; two that differ by less than that don't differ
 *                                  With BENCH_ONCE in the environment one round, cold: for a test
 *                                  that reads all but the times
 *   bench_each(work, x, sizeof *x, n, 7, 1e9, ns)   x[n] the contexts of one function, timed so;
 *                                  ns[k]: their medians, times 1e9
 *   bench_time_by(now, c, 2, 7)    the same by another clock than clock_seconds
 *   bench_once(&c[0])              one run that nothing has warmed up, seconds alone
 *   bench_slope(x, y, n)           of y over x, by least squares; of logarithms: the exponent
 *
 * Compare within one run, never the seconds of two.
 */
#ifndef COMMON_BENCH_H
#define COMMON_BENCH_H

#include "../clock.h"
#include "../file.h"

typedef struct {
    const char *name;
    double (*run)(void *context);  /* does the work; returns something that depends on all of it */
    void *context;
    double seconds, spread;        /* out */
    void (*warm)(void *context);   /* before each turn, untimed: caches as warm for all; or NULL */
} bench_candidate;

/* ---------------------------------------------------------------------------------------------- */

static inline double bench_once(const bench_candidate *c)
{
    double start = clock_seconds();
    clock_kept = c->run(c->context);
    return clock_seconds() - start;
}

/* Of n >= 1 times, which it sorts: the median; *spread as above. */
static inline double bench_median(double *x, int n, double *spread)
{
    double median = clock_median(x, n), quartiles = x[n - 1 - n / 4] - x[n / 4];
    *spread = median > 0 ? quartiles / 2 / median : 0;
    return median;
}

/* Any number of candidates and rounds, both at least 1. now: a clock [s]. */
static inline void bench_time_by(double (*now)(void), bench_candidate *c, int n, int rounds)
{
    int warm = getenv("BENCH_ONCE") ? 0 : 1;
    if (!warm) rounds = 1;
    double *all = allocate((size_t)n * (size_t)rounds, sizeof *all);
    for (int i = -warm; i < rounds; i++)
        for (int k = 0; k < n; k++) {
            if (warm && c[k].warm) c[k].warm(c[k].context);
            double start = now();
            clock_kept = c[k].run(c[k].context);
            if (i >= 0) all[k * rounds + i] = now() - start;
        }
    for (int k = 0; k < n; k++)
        c[k].seconds = bench_median(all + k * rounds, rounds, &c[k].spread);
    free(all);
}

static inline void bench_time(bench_candidate *c, int n, int rounds)
{
    bench_time_by(clock_seconds, c, n, rounds);
}

static inline void bench_each(double (*work)(void *), void *contexts, size_t size, int n,
                              int rounds, double unit, double *times)
{
    bench_candidate *c = allocate((size_t)n, sizeof *c);
    for (int k = 0; k < n; k++)
        c[k] = (bench_candidate){.run = work, .context = (char *)contexts + (size_t)k * size};
    bench_time(c, n, rounds);
    for (int k = 0; k < n; k++) times[k] = c[k].seconds * unit;
    free(c);
}

static inline double bench_slope(const double *x, const double *y, int n)
{
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (int i = 0; i < n; i++) sx += x[i], sy += y[i], sxx += x[i] * x[i], sxy += x[i] * y[i];
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

#endif
