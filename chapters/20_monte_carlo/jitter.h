/* jitter.h: one random point in each of so many equal cells: jittered, stratified (抖动, 分层).
 *
 *   | .  |   .|  . |      n points in n cells of the line, or in a x b >= n cells of the square
 *   |    |.   |    |      (a = the root of n, rounded up; if a x b > n, then random n of them).
 *   +----+----+----+
 *   |  . |    |.   |      jitter_line(i, n, key, &s), jitter_square(i, n, key, &s, &u, &v)
 *   |    |  . |    |      i [0..n-1]: which point; key: the same for all n; s: its own numbers
 *                         n [1 .. 2^31] is how many
 *
 *   uint32_t j = permuted(i, n, key);          a permutation of 0 .. n-1, without memory
 *
 * Cells are taken in an order that depends on the key. Two sets that are used together, say one for
 * the lens and one for the light, need different keys: in the same order the upper left of the lens
 * would always see the upper left of the light. n must be known beforehand.
 *
 * Sources: R. Cook, "Stochastic sampling in computer graphics", ACM Trans. Graphics 5(1), 1986;
 * A. Kensler, "Correlated multi-jittered sampling", Pixar 13-01, 2013 (permuting by hash and walk).
 */
#ifndef MONTE_CARLO_JITTER_H
#define MONTE_CARLO_JITTER_H

#include "../../common/random.h"

/* ---------------------------------------------------------------------------------------------- */

/* Odd factors, additions and shifts to the right permute the words of k bits; a word of n or more
 * is sent round again until it is below n, on average less than two times. Eight rounds: with five,
 * pairs of places are not all alike likely for n = 4 and 16. The last addition makes it so for
 * single places, exactly. [n >= 1, i < n] */
static inline uint32_t permuted(uint32_t i, uint32_t n, uint64_t key)
{
    enum { rounds = 8 };
    uint32_t w = n - 1, half = 1;
    for (int k = 1; k < 32; k *= 2) w |= w >> k;  /* the k bits */
    while ((w >> half) >> half) half++;
    do {
        uint64_t h = key;
        for (int r = 0; r < rounds; r++) {
            h = random_mix(h + random_step);
            i = (i * ((uint32_t)h | 1) + (uint32_t)(h >> 32)) & w;
            i ^= i >> half;
        }
    } while (i >= n);
    return (uint32_t)((i + (random_mix(key) >> 32)) % n);
}

/* (cell + a) / cells, below 1 although the sum may round up. */
static inline real jitter_place(uint32_t cell, uint32_t cells, real a)
{
    return real_min(((real)cell + a) / (real)cells, 1 - real_epsilon / 2);
}

static inline real jitter_line(uint32_t i, uint32_t n, uint64_t key, random_stream *s)
{
    return jitter_place(permuted(i, n, key), n, random_next(s));
}

static inline uint32_t jitter_columns(uint32_t n)
{
    uint32_t a = (uint32_t)sqrt((double)n);
    return (uint64_t)a * a < n ? a + 1 : a;
}

static inline void jitter_square(uint32_t i, uint32_t n, uint64_t key, random_stream *s, real *u,
                                 real *v)
{
    uint32_t a = jitter_columns(n), b = (n + a - 1) / a, cell = permuted(i, a * b, key);
    *u = jitter_place(cell % a, a, random_next(s));
    *v = jitter_place(cell / a, b, random_next(s));
}

#endif
