/* clock.h: seconds, and the median of several; lab/bench.h times with it. */
#ifndef CLOCK_H
#define CLOCK_H
#include "posix.h"
#include <stdlib.h>
#include <time.h>

/* ---------------------------------------------------------------------------------------------- */
static inline double clock_of(clockid_t which)  /* seconds */
{
    struct timespec now;
    clock_gettime(which, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Seconds since some fixed moment, never set back. */
static inline double clock_seconds(void) { return clock_of(CLOCK_MONOTONIC); }

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
#endif
