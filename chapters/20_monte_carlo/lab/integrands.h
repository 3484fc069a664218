/* integrands.h: functions whose integrals are known, and what error each way to them must make.
 *
 *   smooth   e^(x+y)                       integral (e - 1)^2
 *   edge     1 if x^2 + y^2 < 1, else 0    integral pi / 4: as a pixel that a silhouette crosses
 *                                          (both over the unit square)
 *
 *   integrand_errors(kind, ...)  of the mean of N samples, by a method of sampler.h
 *   first_errors(...)            the notes' way, first.h: one stream, sums of reals
 *                                Exact standard deviations of the mean of N samples:
 *   deviation_random(f, N)       sqrt(V[f] / N)                                             (20.6)
 *   deviation_jittered(k)        smooth, N = k x k cells, one sample each:
 *                                sqrt(sum over the cells of V[f in the cell]) / N           (20.8)
 *   deviation_sobol(m)           smooth, N = 2^m, Owen's scrambling:
 *                                sqrt(sum of gain times variance of a level / N)           (20.20)
 *
 * Scrambled net: split f into parts, one for each size of box 2^-k x 2^-l (as Haar wavelets do).
 * Parts with k + l <= m - 2 are integrated exactly (gain 0), those with k + l = m - 1 have the gain
 * 2, finer ones 1: as good as random.
 *
 * Importance sampling (重要性采样), well done and fatal:
 *   irradiance under a white sky:      integral over the hemisphere of cos theta = pi       (20.9)
 *   directions from the lobe cos^n:    p = (n + 1) / (2 pi) cos^n                     (sampling.h)
 *   weight of a sample (权重):         f / p = 2 pi / (n + 1) cos^(1-n)                      (20.10)
 *   its variance:                      pi^2 (n - 1)^2 / ((n + 1)(3 - n))  if n < 3         (20.16)
 *                                      infinite                           if n >= 3
 *
 * The expectation is pi for all of them; with n > 1 weights have no bound. The mixture (混合) of p
 * with a share `a` of a pdf that covers f has weights <= pi / a (defensive importance sampling).
 *
 *   importance_weight(n, z), importance_weight_mixed(n, a, z)      z = cos theta in (0, 1]
 *   importance_run(n, a, seed, run, N)     N samples; a = 0: the lobe alone
 *
 * Sources: A. Owen, "Monte Carlo variance of scrambled net quadrature", SIAM J. Numer. Anal. 34(5),
 * 1997; T. Hesterberg, "Weighted average importance sampling and defensive mixture distributions",
 * Technometrics 37(2), 1995; W. Feller, An Introduction to Probability Theory 2, section XVII.5
 * (sums of infinite variance).
 */
#ifndef MONTE_CARLO_INTEGRANDS_H
#define MONTE_CARLO_INTEGRANDS_H

#include "../../../common/numbers/estimate.h"
#include "../first.h"
#include "../sampler.h"
#include "../sampling.h"

typedef enum { SMOOTH, EDGE, integrands } integrand;
#define quarter_pi 0.785398163397448310  /* in double, whatever real is */

/* ---------------------------------------------------------------------------------------------- */

static inline double integrand_value(integrand f, point2 p)
{
    double x = (double)p.u, y = (double)p.v;
    return f == SMOOTH ? exp(x + y) : x * x + y * y < 1;
}

static inline double integrand_integral(integrand f)
{
    double g = expm1(1.0);
    return f == SMOOTH ? g * g : quarter_pi;
}

/* error[f]: the mean of f over n samples of `kind`, minus its integral. */
static inline void integrand_errors(sequence_kind kind, uint64_t seed, uint64_t run, uint32_t n,
                                    double error[integrands])
{
    error[SMOOTH] = error[EDGE] = 0;
    for (uint32_t i = 0; i < n; i++) {
        sampler s = sampler_start(kind, seed, run, i, n);
        point2 p = sampler_pair(&s);
        for (int f = 0; f < integrands; f++) error[f] += integrand_value((integrand)f, p);
    }
    for (int f = 0; f < integrands; f++) error[f] = error[f] / n - integrand_integral((integrand)f);
}

static inline void first_errors(uint64_t seed, uint64_t run, uint32_t n, double error[integrands])
{
    random_stream random = random_start(seed, run, n);
    first_samples s[integrands] = {{0, 0, 0}, {0, 0, 0}};
    for (uint32_t i = 0; i < n; i++) {
        real u = random_next(&random), v = random_next(&random);
        for (int f = 0; f < integrands; f++)
            first_sample(&s[f], (real)integrand_value((integrand)f, (point2){u, v}));
    }
    for (int f = 0; f < integrands; f++)
        error[f] = (double)first_mean(s[f]) - integrand_integral((integrand)f);
}

/* The mean of e^x over [a, a+h], and its variance there, as a part of e^(2a): with t = h/2 the mean
 * is e^(a+t) sinh t / t, and so on; for small t by its series, since the difference cancels. */
static inline double exp_mean(double a, double h) { return exp(a) * expm1(h) / h; }

static inline double exp_variance(double a, double h)
{
    double t = h / 2, part = sinh(t) / t;
    double v = t > 0.1 ? sinh(2 * t) / (2 * t) - part * part
                       : t * t * (1.0 / 3 + t * t * (4.0 / 45 + t * t * (1.0 / 105
                                                     + t * t * (8.0 / 14175))));
    return exp(2 * a + h) * v;
}

static inline double deviation_random(integrand f, double n)
{
    double mean = exp_mean(0, 1), v = exp_variance(0, 1), p = quarter_pi;
    return sqrt((f == SMOOTH ? v * (v + 2 * mean * mean) : p * (1 - p)) / n);
}

/* Of the smooth one. */
static inline double deviation_jittered(int k)
{
    double h = 1.0 / k, v = 0, square = 0;  /* of e^x, summed over all steps */
    for (int i = 0; i < k; i++)
        v += exp_variance(i * h, h), square += pow(exp_mean(i * h, h), 2);
    return sqrt(v * (v + 2 * square)) / ((double)k * k);
}

/* Variance of e^x that lies between steps of width 2^-k and steps of half that width: a quarter of
 * the squared difference of the means of both halves. A geometric sum over the 2^k steps. */
static inline double exp_level(int k)
{
    double h = ldexp(1, -k), half = exp_mean(0, h / 2) * expm1(h / 2) / 2;
    return half * half * expm1(2.0) / expm1(2 * h) * h;
}

static inline double deviation_sobol(int m)
{
    enum { deepest = 26 };  /* finer levels add less than 4^-26 of the whole */
    double mean = exp_mean(0, 1), sum = 0;
    for (int k = m; k < m + deepest; k++) sum += 2 * mean * mean * exp_level(k);
    for (int k = 0; k < m + deepest; k++)
        for (int l = k >= m - 1 ? 0 : m - 1 - k; l < m + deepest; l++)
            sum += (k + l == m - 1 ? 2 : 1) * exp_level(k) * exp_level(l);
    return sqrt(sum / ldexp(1, m));
}

/* ---- one integral, many pdfs ---- */

static inline double importance_variance(double n)
{
    double p = (double)pi;
    return n < 3 ? p * p * (n - 1) * (n - 1) / ((n + 1) * (3 - n)) : (double)INFINITY;
}

static inline double importance_weight(real n, real z)
{
    return 2 * (double)pi / ((double)n + 1) * pow((double)z, 1 - (double)n);
}

/* f / ((1-a) p_n + a p_1), with p_1 = cos/pi = f/pi. */
static inline double importance_weight_mixed(real n, real a, real z)
{
    double share = (double)a;
    return 1 / ((1 - share) / importance_weight(n, z) + share / (double)pi);
}

/* A share `a` of the samples comes from the cosine, chosen by a third number. */
static inline estimate importance_run(real n, real a, uint64_t seed, uint64_t run, size_t samples)
{
    estimate e = {0};
    for (size_t i = 0; i < samples; i++) {
        random_stream s = random_start(seed, run, i);
        real u = random_next(&s), v = random_next(&s);
        bool cosine = a > 0 && random_next(&s) < a;
        real z = sample_lobe(cosine ? 1 : n, u, v).z;
        e = estimate_add(e, importance_weight_mixed(n, a, z));
    }
    return e;
}

#endif
