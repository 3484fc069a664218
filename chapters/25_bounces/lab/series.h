/* series.h: the sum of the bounces in a furnace (白炉), in closed form.
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
 */
#ifndef BOUNCES_SERIES_H
#define BOUNCES_SERIES_H

#include "../../../common/vec3.h"

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

#endif
