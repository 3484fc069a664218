/* halton.h: Halton's points: the digits of i, mirrored at the point.
 *
 *   i = d0 + d1 b + d2 b^2 + ...    gives    0.d0 d1 d2 ... in base b                      (20.12)
 *   base 2:  0, 1/2, 1/4, 3/4, 1/8, 5/8 ...    base 3:  0, 1/3, 2/3, 1/9, 4/9, 7/9 ...
 *
 *   real u = radical_inverse(3, i);            [0,1)
 *
 * One prime base for each dimension. Pairs of small primes are spread well after 2^a 3^b points; in
 * pairs of large ones, such as 47 and 53, the first points climb a few diagonals together (47 of
 * them before the first digit turns over). No error but the last rounding: one division of whole
 * numbers.
 *
 * Sources: J. Halton, "On the efficiency of certain quasi-random sequences of points", Numer. Math.
 * 2, 1960.
 */
#ifndef MONTE_CARLO_HALTON_H
#define MONTE_CARLO_HALTON_H

#include "../../common/vec3.h"
#include <stdint.h>

enum { halton_bases = 16 };
static const uint8_t halton_base[halton_bases] = {2, 3, 5, 7, 11, 13, 17, 19,
                                                  23, 29, 31, 37, 41, 43, 47, 53};

/* ---------------------------------------------------------------------------------------------- */

static inline real radical_inverse(uint32_t base, uint32_t i)
{
    uint64_t mirrored = 0, power = 1;
    for (; i > 0; i /= base, power *= base) mirrored = mirrored * base + i % base;
    /* power < 2^32 base: both are exact in double */
    return real_min((real)((double)mirrored / (double)power), 1 - real_epsilon / 2);
}

#endif
