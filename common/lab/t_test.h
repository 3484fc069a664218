/* t_test.h: is the true value the one that an estimate says it is?                t-test (t 检验)
 *
 *   t = (mean - truth) / standard error                                                    (20.19)
 *
 * If the mean of n samples is normally distributed (after enough samples it nearly is, if their
 * variance is finite) and its expectation is `truth`, then t has Student's distribution with n - 1
 * degrees of freedom, and p, the probability of so large a |t| or a larger one, is uniform in
 * [0,1].
 *
 *   double p = t_test(e, truth, rounding);   p < 1e-6: it is not; false-alarm rate 1e-6
 *   double p = welch_test(a, b);         the same mean? Variances unknown and different (Welch)
 *   line_fit f = fit_line(x, y, n);      least squares; a slope and its standard error
 *
 *   t_above(t, k)   P(|T| >= |t|)      k: degrees of freedom
 *
 * `rounding`: an error of the mean that is not chance, such as some epsilons. It is forgiven;
 * samples that are all alike have the standard error 0 and must be right to within it. In a family
 * of m tests the chance of any false alarm is at most m times that of each.
 *
 * What it can't see: with an infinite variance the standard error is too small most of the time,
 * and the estimate is "wrong" with confidence (20's integrands.h).
 *
 * Sources: Student, "The probable error of a mean", Biometrika 6, 1908; K. Subr, J. Arvo,
 * "Statistical hypothesis testing for assessing Monte Carlo estimators", Pacific Graphics 2007.
 */
#ifndef T_TEST_H
#define T_TEST_H

#include "../numbers/estimate.h"
#include "../numbers/incomplete.h"

typedef struct { double slope, intercept, slope_error; size_t n; } line_fit;

/* ---------------------------------------------------------------------------------------------- */

static inline double t_above(double t, double k)
{
    if (isinf(t)) return 0;
    return beta_below(k / 2, 0.5, k / (k + t * t), t * t / (k + t * t));
}

static inline double welch_test(estimate a, estimate b)
{
    double va = estimate_variance(a) / (double)a.n, vb = estimate_variance(b) / (double)b.n;
    double k = (va + vb) * (va + vb)
        / (va * va / (double)(a.n - 1) + vb * vb / (double)(b.n - 1));
    if (!(va + vb > 0)) return a.mean == b.mean ? 1 : 0;
    return t_above((a.mean - b.mean) / sqrt(va + vb), k);
}

/* Fewer than two samples prove nothing: p = 1. A NaN: p = 0. */
static inline double t_test(estimate e, double truth, double rounding)
{
    double off = fabs(e.mean - truth);
    if (isnan(off) || isnan(e.squares)) return 0;
    if (off <= rounding || e.n < 2) return 1;
    return t_above((off - rounding) / estimate_error(e), (double)(e.n - 1));
}

/* y = intercept + slope x, the sum of the squared residuals being least; n >= 2 different x. */
static inline line_fit fit_line(const double *x, const double *y, size_t n)
{
    double mx = 0, my = 0, xx = 0, xy = 0, rest = 0;
    for (size_t i = 0; i < n; i++) mx += x[i] / (double)n, my += y[i] / (double)n;
    for (size_t i = 0; i < n; i++) xx += (x[i] - mx) * (x[i] - mx), xy += (x[i] - mx) * (y[i] - my);
    line_fit f = {xy / xx, my - xy / xx * mx, 0, n};
    for (size_t i = 0; i < n; i++) {
        double r = y[i] - f.intercept - f.slope * x[i];
        rest += r * r;
    }
    f.slope_error = n > 2 ? sqrt(rest / (double)(n - 2) / xx) : (double)INFINITY;
    return f;
}

#endif
