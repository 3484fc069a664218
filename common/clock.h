/* clock.h: how long something takes, on a machine that has other things to do.
 *
 * So the variants of an experiment run in turn, A B C A B C ..., and each gets the median of its
 * times. Compare ratios within one run, never seconds of two runs.
 *
 *   clock_variant v[] = {{"naive", run_naive, &data, 0}, {"robust", run_robust, &data, 0}};
 *   clock_compare(v, 2, 7);                  7 rounds; v[k].seconds is then the median
 */
#ifndef CLOCK_H
#define CLOCK_H
#include "posix.h"
#if defined __GLIBC__ && !defined __USE_XOPEN2K8
#error "a header of the C library came first: include this project's headers before it"
#endif
#include <stdlib.h>
#include <time.h>

typedef struct {
    const char *name;
    double (*run)(void *context);  /* does the work; returns something that depends on all of it */
    void *context;
    double seconds;                /* out: median over the rounds */
} clock_variant;

/* ---------------------------------------------------------------------------------------------- */
/* Seconds since some fixed moment, never set back. */
static inline double clock_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static inline int clock_order(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The middle value of n numbers [n >= 1], of an even n the mean of the middle two; sorts them. */
static inline double clock_median(double *x, int n)
{
    qsort(x, (size_t)n, sizeof *x, clock_order);
    return n % 2 ? x[n / 2] : (x[n / 2 - 1] + x[n / 2]) / 2;
}

static volatile double clock_kept;  /* a result written here counts as used */

/* Runs n variants [1..16] in turn, `rounds` times [1..99], after one round that only warms up. */
static inline void clock_compare(clock_variant *v, int n, int rounds)
{
    double seconds[16][99];
    if (n > 16 || rounds < 1 || rounds > 99) abort();
    for (int i = -1; i < rounds; i++)
        for (int k = 0; k < n; k++) {
            double start = clock_seconds();
            clock_kept = v[k].run(v[k].context);
            if (i >= 0) seconds[k][i] = clock_seconds() - start;
        }
    for (int k = 0; k < n; k++) v[k].seconds = clock_median(seconds[k], rounds);
}
#endif
