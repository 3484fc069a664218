/* sequences.h: points that lie more evenly than chance would have them: Halton's, Sobol's.
 *
 * Halton: the digits of i, mirrored at the point.
 *
 *   i = d0 + d1 b + d2 b^2 + ...    gives    0.d0 d1 d2 ... in base b                      (20.12)
 *   base 2:  0, 1/2, 1/4, 3/4, 1/8, 5/8 ...    base 3:  0, 1/3, 2/3, 1/9, 4/9, 7/9 ...
 *
 *   real u = radical_inverse(3, i);            [0,1)
 *
 * One prime base for each dimension. Pairs of small primes are spread well after 2^a 3^b points; in
 * pairs of large ones, such as 47 and 53, the first points climb a few diagonals together (47 of
 * them before the first digit turns over). No error but the last rounding.
 *
 * Sobol's points (Sobol' 序列) in the unit square, and Owen's scrambling (Owen 扰乱):
 *
 *   .   |     |  .  |        Cut the square into 2^a x 2^b equal boxes, a + b = m, in any of the
 *  -----+-----+-----+--      m + 1 ways: each box holds exactly one of the first 2^m points, and of
 *       |  .  |     | .      every later block of 2^m. That is a (0,m,2)-net (网): rows, columns
 *                            and all between them are stratified at once.
 *
 *   uint32_t x = i, y = sobol_index_of_y(i);      point i, as fractions of 2^32, bits reversed
 *   x = owen_reversed(x, seed_x)                  scrambled: random, and still a net
 *   real u = real_of_fraction(reversed_bits(x), seed_x);      [0,1), in double with random digits
 *                                                 below 2^-32
 *
 * Coordinates: x reverses the bits of i (van der Corput). y reads i as a polynomial over {0,1}, bit
 * k being that of X^k, and puts X + 1 for X; then as x.
 *
 * Unscrambled, the points are always the same: no error estimate, and the first one is (0,0).
 * Owen's scrambling flips each bit or not, by a coin of its own for every value of the bits above:
 * each point is then uniform in the square, so that estimates are right on average (unbiased 无偏),
 * and errors in boxes of the same size are independent and average out: N^-3/2 for smooth
 * functions; one coin a level for all points (a digital shift, xor) makes N^-1.
 *
 * owen_reversed does so by a hash of a few operations. Seeds must be well mixed (random_mix): it
 * does little to a seed of few bits.
 *
 * Sources: J. Halton, "On the efficiency of certain quasi-random sequences of points", Numer. Math.
 * 2, 1960; I. Sobol', "On the distribution of points in a cube ...", 1967; A. Owen, "Randomly
 * permuted (t,m,s)-nets", 1995, and "Scrambled net variance for integrals of smooth functions",
 * Ann. Stat. 25(4), 1997; S. Laine, T. Karras, "Stratified sampling for stochastic transparency",
 * EGSR 2011; B. Burley, "Practical hash-based Owen scrambling", JCGT 10(1), 2020;
 * N. Vegdahl, "Building a better LK hash", 2021 (owen_reversed).
 */
#ifndef MONTE_CARLO_SEQUENCES_H
#define MONTE_CARLO_SEQUENCES_H

#include "../../common/random.h"

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

static inline uint32_t reversed_bits(uint32_t x)
{
    x = __builtin_bswap32(x);
    x = (x >> 4 & 0x0f0f0f0f) | (x & 0x0f0f0f0f) << 4;
    x = (x >> 2 & 0x33333333) | (x & 0x33333333) << 2;
    return (x >> 1 & 0x55555555) | (x & 0x55555555) << 1;
}

/* f(X) = A(X) + X^16 B(X) gives f(X+1) = (A+B)(X+1) + X^16 B(X+1), since X^16 becomes (X+1)^16 =
 * X^16 + 1 where 1 + 1 = 0. So: add the upper half to the lower, then the same in each half. */
static inline uint32_t sobol_index_of_y(uint32_t i)
{
    i ^= i >> 16;
    i ^= i >> 8 & 0x00ff00ff;
    i ^= i >> 4 & 0x0f0f0f0f;
    i ^= i >> 2 & 0x33333333;
    return i ^ (i >> 1 & 0x55555555);
}

/* On the reversed word additions and products carry upwards only, so a bit depends on itself and on
 * those below it: on those above it, once reversed back. x ^= x * even never changes the lowest bit
 * by itself: x * even has a 0 there. */
static inline uint32_t owen_reversed(uint32_t x, uint32_t seed)
{
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= seed >> 16 | 1;
    x ^= x * 0x05526c56u;
    return x ^ x * 0x53a22864u;
}

/* Each fraction stands for an interval of length 2^-32: a random point of it, of the 2^53 that
 * double has. A float takes the upper 24 bits. */
static inline real real_of_fraction(uint32_t x, uint32_t seed)
{
    uint64_t below = random_mix(((uint64_t)seed << 32 | x) + random_step) >> 32;
    return random_real_of((uint64_t)x << 32 | below);
}

#endif
