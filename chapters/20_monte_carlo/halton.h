/* halton.h: Halton's points: the digits of i, mirrored at the point.
 *
 *   i = d0 + d1 b + d2 b^2 + ...    gives    0.d0 d1 d2 ... in base b                      (20.12)
 *   base 2:  0, 1/2, 1/4, 3/4, 1/8, 5/8 ...    base 3:  0, 1/3, 2/3, 1/9, 4/9, 7/9 ...
 *
 *   real u = radical_inverse(3, i);            [0,1)
 *   real u = radical_inverse_owen(3, i, seed); scrambled: uniform in [0,1) for each i
 *
 * One prime base for each dimension. Pairs of small primes are spread well after 2^a 3^b points; in
 * pairs of large ones, such as 47 and 53, the first points climb a few diagonals together (47 of
 * them before the first digit turns over), which the scrambling breaks up.
 *
 *   call                         error
 *   radical_inverse              none but the last rounding: one division of whole numbers
 *   radical_inverse_naive        a rounding a digit; and in float it may return 1
 *
 * Sources: J. Halton, "On the efficiency of certain quasi-random sequences of points", Numer. Math.
 * 2, 1960; A. Owen, "A randomized Halton algorithm in R", 2017; J. Matousek, "On the L2-discrepancy
 * for anchored boxes", J. Complexity 14, 1998 (a d + c as cheaper permutations).
 */
#ifndef MONTE_CARLO_HALTON_H
#define MONTE_CARLO_HALTON_H

#include "jitter.h"

enum { halton_bases = 16 };
static const uint8_t halton_base[halton_bases] = {2, 3, 5, 7, 11, 13, 17, 19,
                                                  23, 29, 31, 37, 41, 43, 47, 53};

/* ---------------------------------------------------------------------------------------------- */

static inline real radical_inverse_naive(uint32_t base, uint32_t i)
{
    real sum = 0, part = 1 / (real)base, digit = part;
    for (; i > 0; i /= base, digit *= part) sum += (real)(i % base) * digit;
    return sum;
}

/* n / d of whole numbers below 2^53, n < d: the nearest real, but below 1. */
static inline real fraction_below_1(uint64_t n, uint64_t d)
{
    return real_min((real)((double)n / (double)d), 1 - real_epsilon / 2);
}

static inline real radical_inverse(uint32_t base, uint32_t i)
{
    uint64_t mirrored = 0, power = 1;
    for (; i > 0; i /= base, power *= base) mirrored = mirrored * base + i % base;
    return fraction_below_1(mirrored, power);  /* power < 2^32 base: exact in double */
}

/* A random permutation of the digits. In bases 2 and 3 every permutation is d -> a d + c mod b, and
 * that is quicker. In larger bases such maps have the right variance, too, but keep lines straight:
 * pairs of large bases would still show stripes. */
static inline uint32_t halton_digit(uint32_t d, uint32_t base, uint64_t coin)
{
    if (base > 3) return permuted(d, base, coin);
    uint32_t a = 1 + (uint32_t)((coin >> 32) * (base - 1) >> 32);
    return (a * d + (uint32_t)((coin & UINT32_MAX) * base >> 32)) % base;
}

/* A permutation of its own for each digit and every value of the digits before it. The zeros behind
 * the last digit are digits, too: down to 2^-32, and a random rest. */
static inline real radical_inverse_owen(uint32_t base, uint32_t i, uint32_t seed)
{
    uint64_t mirrored = 0, power = 1, before = 0, key = random_mix(seed + random_step), coin;
    while (power <= UINT32_MAX) {
        coin = random_mix(key + random_step * (power + before));  /* power tells lengths apart */
        mirrored = mirrored * base + halton_digit(i % base, base, coin);
        before += i % base * power, power *= base, i /= base;
    }
    coin = random_mix(key + random_step * (power + before));
    double rest = random_double_of(coin);
    return real_min((real)(((double)mirrored + rest) / (double)power), 1 - real_epsilon / 2);
}

#endif
