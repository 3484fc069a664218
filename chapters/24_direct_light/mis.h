/* mis.h: two ways to draw the same direction, and how much to believe each.
 *                                                       multiple importance sampling (多重重要性采样)
 *   F = integral of f = sum over ways i of the mean of w_i(x) f(x) / p_i(x), x drawn by way i,
 *   as long as the weights of all ways add up to 1 wherever f is not 0                     (24.7)
 *
 *   mis_balance(a, b) = a / (a + b)                 balance heuristic (平衡启发式)          (24.8)
 *   mis_power(a, b)   = a^2 / (a^2 + b^2)           power heuristic (幂启发式)              (24.9)
 *
 *   a: pdf with which this way draws x, times the number of its samples; b: that of the other way.
 *   Both per the same measure (all of this chapter: per solid angle), in [0, infinity].
 *
 *   input                 weight of a       why
 *   b = 0                 1                 nobody else finds x: all of it is counted here
 *   a infinite (mirror)   1                 and of the other way 0
 *   a = 0, or a NaN       0                 this way did not draw x
 *   both infinite         1/2
 *
 * Whatever f is: no weights >= 0 have a variance smaller than the balance heuristic's by more than
 * F^2 (1/least n - 1/sum of n), n the number of samples of each way. The power heuristic is better
 * where one way alone would do well. mis_power_naive squares before it divides: a pdf of 1e20
 * overflows in float, and the weight is a NaN.
 *
 * Source: E. Veach, L. Guibas, "Optimally Combining Sampling Techniques for Monte Carlo Rendering",
 * SIGGRAPH 1995, sections 3.2 and 3.3.
 */
#ifndef DIRECT_MIS_H
#define DIRECT_MIS_H

#include "../../common/vec3.h"

/* ---------------------------------------------------------------------------------------------- */

static inline real mis_power_naive(real a, real b) { return a * a / (a * a + b * b); }

/* 1 / (1 + q), q = b / a: whatever overflows is an infinity that belongs there. */
static inline real mis_balance(real a, real b)
{
    if (!(a > 0)) return 0;
    if (a > real_largest && b > real_largest) return 0.5;
    return 1 / (1 + b / a);
}

static inline real mis_power(real a, real b)
{
    if (!(a > 0)) return 0;
    if (a > real_largest && b > real_largest) return 0.5;
    real q = b / a;
    return 1 / (1 + q * q);
}

#endif
