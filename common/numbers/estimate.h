/* estimate.h: from samples (样本) of a random variable (随机变量) to its expectation (期望), and how
 * far to trust the result.
 *
 *   E[X] ~ mean = (y_1 + ... + y_n) / n             (20.3)  an estimator (估计量)
 *   V[X] ~ s^2  = sum (y_k - mean)^2 / (n - 1)      (20.5)  variance (方差)
 *   error of the mean ~ s / sqrt n                  (20.6)  standard error (标准误差)
 *
 *   estimate e = {0};
 *   for each sample: e = estimate_add(e, y);      mean and variance after every sample, in one pass
 *   e.mean, estimate_variance(e), estimate_error(e)
 *   e = estimate_merge(a, b);                     as if one had seen the samples of both
 *
 *   call                  cannot do                                        so
 *   estimate_variance(e)  fewer than two samples: nothing is known         infinity
 *   first_variance(s)     subtracts nearly equal numbers (20's)            may be negative
 *
 * An estimate counts in double whatever real is: 2^24 samples are nothing here, and a float that
 * has reached 2^24 no longer grows by ones (sum.h). A sample that is NaN or infinite spoils the
 * mean, as it should. The variance is that of one sample, the error that of the mean.
 *
 * Sources: B. Welford, "Note on a method for calculating corrected sums of squares and products",
 * Technometrics 4(3), 1962; T. Chan, G. Golub, R. LeVeque, "Algorithms for computing the sample
 * variance", The American Statistician 37(3), 1983 (merging, and how the naive form fails).
 */
#ifndef ESTIMATE_H
#define ESTIMATE_H

#include "../vec3.h"
#include <stddef.h>

typedef struct { size_t n; double mean, squares; } estimate;  /* squares: sum of (y_k - mean)^2 */

/* ---------------------------------------------------------------------------------------------- */

/* mean' = mean + d/n, squares' = squares + d (y - mean'), d = y - mean                    (20.11)
 * d and y - mean' never have opposite signs: mean + d/n rounds to something between mean and y,
 * both of which are numbers that double has. So squares never falls. */
static inline estimate estimate_add(estimate e, double y)
{
    double d = y - e.mean;
    e.n++;
    e.mean += d / (double)e.n;
    e.squares += d * (y - e.mean);
    return e;
}

static inline estimate estimate_merge(estimate a, estimate b)
{
    if (a.n == 0) return b;
    if (b.n == 0) return a;
    double d = b.mean - a.mean, part = (double)b.n / (double)(a.n + b.n);
    return (estimate){a.n + b.n, a.mean + d * part,
                      a.squares + b.squares + d * d * (double)a.n * part};
}

static inline double estimate_variance(estimate e)
{
    return e.n < 2 ? (double)INFINITY : e.squares / (double)(e.n - 1);
}

static inline double estimate_error(estimate e)
{
    return sqrt(estimate_variance(e) / (double)(e.n ? e.n : 1));
}

#endif
