/* sum.h: what rounding takes from a sum.
 *
 *   sum_error(a, b, s)        exactly a + b - s, of s = a + b
 *
 * Source: D. Knuth, The Art of Computer Programming 2, section 4.2.2, theorem B.
 */
#ifndef SUM_H
#define SUM_H

#include "../vec3.h"

/* ---------------------------------------------------------------------------------------------- */

/* Whichever of the two is larger (needs rounding as IEEE 754 has it, so neither -ffast-math nor
 * contraction). */
static inline real sum_error(real a, real b, real s)
{
    real b_used = s - a;
    return (a - (s - b_used)) + (b - b_used);
}

#endif
