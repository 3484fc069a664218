/* importance.h: importance sampling (重要性采样), well done and fatal, on an integral known exactly.
 *
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
 * Sources: T. Hesterberg, "Weighted average importance sampling and defensive mixture
 * distributions", Technometrics 37(2), 1995; W. Feller, An Introduction to Probability Theory 2,
 * section XVII.5 (sums of infinite variance).
 */
#ifndef MONTE_CARLO_IMPORTANCE_H
#define MONTE_CARLO_IMPORTANCE_H

#include "../../../common/numbers/estimate.h"
#include "../../../common/random.h"
#include "../sampling.h"

/* ---------------------------------------------------------------------------------------------- */

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
