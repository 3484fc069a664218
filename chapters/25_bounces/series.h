/* series.h: the sum of the bounces in a furnace (白炉), in closed form and number by number.
 *
 *   In a closed room whose walls all emit E and have the albedo rho, every wall sees the same
 *   radiance all around: K is the number rho, and K^k E = rho^k E.
 *
 *   E + K E + ... + K^n E = E (1 - rho^(n+1)) / (1 - rho)    = E (n + 1) if rho = 1         (25.5)
 *   L = E / (1 - rho)                                        rho < 1                        (25.6)
 *
 *   series_sum(E, rho, n)         (25.5), E, rho >= 0, n >= 0
 *   series_sum_naive(E, rho, n)   (25.5) as it is written
 *   series_whole(E, rho)          (25.6); rho >= 1: infinity, the series diverges (发散)
 *
 *   case                              naive                       so here
 *   rho = 1                           0/0                         n + 1
 *   rho = 1 - 1e-9, n = 10            half of the digits: what    expm1((n+1) log rho)
 *                                     1 - rho^11 is beyond its
 *                                     first term is rounded away
 *
 * The same sum as a path computes it, in float, each way one loop: at rho = .999 a thousand bounces
 * count, and so do their roundings.
 *
 *   way                              what is rounded
 *   bounces_forward_f32              b = rho b, sum += b: both
 *   bounces_forward_kahan_f32        b alone; the sum is that of sum.h (20)
 *   bounces_forward_double           b is a float, the sum a double
 *   bounces_backward_f32             L = E + rho L, as the notes' recursion returns
 */
#ifndef BOUNCES_SERIES_H
#define BOUNCES_SERIES_H

#include "../../common/numbers/sum.h"

/* ---------------------------------------------------------------------------------------------- */

static inline real series_sum_naive(real E, real rho, real n)
{
    return E * (1 - pow(rho, n + 1)) / (1 - rho);
}

/* 1 - rho is exact for rho in [.5, 2]; below .5 log rho may be off, but rho^(n+1) is then small. */
static inline real series_sum(real E, real rho, real n)
{
    real kept = 1 - rho;
    if (kept == 0) return E * (n + 1);
    return E * (-expm1((n + 1) * log1p(-kept)) / kept);
}

static inline real series_whole(real E, real rho)
{
    return rho < 1 ? E / (1 - rho) : E > 0 ? real_infinity : 0;
}

/* ---- in float, bounce by bounce ---- */

static inline float bounces_forward_f32(float E, float rho, int n)
{
    float b = E, sum = 0;
    for (int k = 0; k <= n; k++, b *= rho) sum = sum_add_naive_f32(sum, b);
    return sum;
}

static inline float bounces_forward_kahan_f32(float E, float rho, int n)
{
    float b = E;
    running_sum_f32 sum = {0, 0};
    for (int k = 0; k <= n; k++, b *= rho) sum = sum_add_f32(sum, b);
    return sum.sum;
}

static inline double bounces_forward_double(float E, float rho, int n)
{
    float b = E;
    double sum = 0;
    for (int k = 0; k <= n; k++, b *= rho) sum += (double)b;
    return sum;
}

static inline float bounces_backward_f32(float E, float rho, int n)
{
    float L = E;
    for (int k = 0; k < n; k++) L = E + rho * L;
    return L;
}

#endif
