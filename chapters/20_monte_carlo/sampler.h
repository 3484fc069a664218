/* sampler.h: the random numbers of one sample of one pixel, by any of four methods.
 *
 *   sampler s = sampler_start(SEQUENCE_SOBOL, seed, pixel, k, n);     sample k [< n] of n
 *   point2 lens  = sampler_pair(&s);      dimensions 0 and 1: for what has two, take a pair
 *   real   time  = sampler_number(&s);    the next pair's first
 *   point2 light = sampler_pair(&s);      ...
 *
 *   sampler_keys of;                      where many samples of a pixel follow: what they share is
 *   sampler_keys_of(kind, seed, pixel, &of);           hashed once; `of` must outlive the sampler
 *   sampler s = sampler_of_keys(&of, k, n);            the same numbers
 *   point2 pair[sampler_row];
 *   sampler_row_of(&of, k, n, pair);      its first pairs; Sobol's side by side
 *   sampler_rows_of(of, k, n, pair);      those of sampler_rows pixels, of[i] into pair[i][..]
 *
 *   SEQUENCE_RANDOM        independent numbers                  error N^-1/2
 *   SEQUENCE_JITTERED      a cell each (jitter.h)               N^-1 smooth, N^-3/4 at an edge
 *   SEQUENCE_HALTON        without scrambling                   N^-1 but for logarithms; not random
 *   SEQUENCE_SOBOL         Sobol's with Owen's scrambling       N^-3/2 smooth, N^-3/4 at an edge
 *
 * All that is returned lies in [0,1) and depends on (kind, seed, pixel, sample, n, dimension)
 * alone. But for SEQUENCE_HALTON, which has no seed, each sample by itself is uniform, so a mean
 * over the n samples is right on average. Powers of two are the best n for Sobol's, products a x b
 * with a = b or b + 1 for jittered.
 *
 * Pair d of Sobol's is always its first pair of dimensions, with other seeds and another order of
 * the points (padding): within a pair all is as good as it can be. Between pairs nothing is gained:
 * what depends on two of them together has 1.6 times the variance of random numbers, the price of
 * an order in which the first 2^m points are a net in every pair. The higher dimensions of the
 * sequence itself have bad pairs until 2^20 points and more. Halton's takes two new bases a pair,
 * and random numbers when all 16 are used up.
 *
 * Sources: T. Kollig, A. Keller, "Efficient multidimensional sampling", Eurographics 2002
 * (padding); Burley, 2020 (sequences.h), section 5 (order by scrambling).
 */
#ifndef MONTE_CARLO_SAMPLER_H
#define MONTE_CARLO_SAMPLER_H

#include "jitter.h"
#include "sequences.h"
#include <stddef.h>

typedef struct { real u, v; } point2;
typedef enum { SEQUENCE_RANDOM, SEQUENCE_JITTERED, SEQUENCE_HALTON, SEQUENCE_SOBOL,
               sequence_kinds } sequence_kind;
static const char *const sequence_name[sequence_kinds] = {"random", "jittered", "Halton",
                                                          "Sobol', Owen"};
enum { sampler_hashed = 8, sampler_row = 4, sampler_rows = 8 };
typedef struct {
    sequence_kind kind;
    uint64_t own, key, pair[sampler_hashed];
    uint32_t axis[2][sampler_hashed];  /* the seeds of both axes of a pair */
} sampler_keys;
typedef struct {
    sequence_kind kind;
    uint32_t sample, samples, pair;  /* pair: the next one */
    uint32_t reversed;               /* Sobol': the bits of sample, as owen_reversed takes them */
    uint64_t key;                    /* what all samples of the pixel share */
    random_stream own;               /* this sample's own numbers */
    const sampler_keys *keys;        /* or NULL */
} sampler;

/* ---------------------------------------------------------------------------------------------- */

static inline sampler sampler_start(sequence_kind kind, uint64_t seed, uint64_t pixel,
                                    uint32_t sample, uint32_t samples)
{
    sampler s = {kind, sample, samples, 0, reversed_bits(sample), 0, {0, 0}, NULL};
    if (kind <= SEQUENCE_HALTON) s.own = random_start(seed, pixel, sample);
    if (kind != SEQUENCE_RANDOM) s.key = random_start(seed, pixel, UINT64_MAX - 1).key;
    return s;
}

static inline uint64_t sampler_key(const sampler *s, uint32_t pair)
{
    if (s->keys && pair < sampler_hashed) return s->keys->pair[pair];
    return random_mix(s->key + random_step * (pair + (uint64_t)1));
}

/* Loops of one operation, of which compilers make vectors. */
static inline void sampler_keys_of(sequence_kind kind, uint64_t seed, uint64_t pixel,
                                   sampler_keys *out)
{
    sampler s = sampler_start(kind, seed, pixel, 0, 1);
    uint64_t pair[sampler_hashed], axes[sampler_hashed];
    for (uint64_t k = 0; k < sampler_hashed; k++)
        pair[k] = random_mix(s.key + random_step * (k + 1));
    for (int k = 0; k < sampler_hashed; k++) axes[k] = random_mix(pair[k] + random_step);
    out->kind = kind, out->own = random_pixel(seed, pixel), out->key = s.key;
    for (int k = 0; k < sampler_hashed; k++) out->pair[k] = pair[k];
    for (int k = 0; k < sampler_hashed; k++) out->axis[0][k] = (uint32_t)axes[k];
    for (int k = 0; k < sampler_hashed; k++) out->axis[1][k] = (uint32_t)(axes[k] >> 32);
}

static inline sampler sampler_of_keys(const sampler_keys *k, uint32_t sample, uint32_t samples)
{
    random_stream own = {0, 0};
    if (k->kind <= SEQUENCE_HALTON) own = random_sample(k->own, sample);
    return (sampler){k->kind, sample, samples, 0, reversed_bits(sample), k->key, own, k};
}

/* Both coordinates of pair d: two seeds for the axes, one for the order of the points. The order of
 * a scrambled index keeps aligned blocks of 2^m together, so that the first 2^m are a net in any
 * pair. Pair 0 keeps its own order: only where two pairs meet does it matter. Scrambling reverses
 * the bits, works, and reverses them back; so do coordinates of a point: once is enough. */
static inline point2 sampler_sobol(const sampler *s, uint32_t pair)
{
    uint64_t key = sampler_key(s, pair);
    uint32_t a, b, x = s->sample;
    if (s->keys && pair < sampler_hashed) {
        a = s->keys->axis[0][pair], b = s->keys->axis[1][pair];
    } else {
        uint64_t axes = random_mix(key + random_step);
        a = (uint32_t)axes, b = (uint32_t)(axes >> 32);
    }
    if (pair > 0) x = reversed_bits(owen_reversed(s->reversed, (uint32_t)key));
    uint32_t y = sobol_index_of_y(x);
    x = reversed_bits(owen_reversed(x, a)), y = reversed_bits(owen_reversed(y, b));
    return (point2){real_of_fraction(x, a), real_of_fraction(y, b)};
}

static inline point2 sampler_random(sampler *s)
{
    real u = random_next(&s->own), v = random_next(&s->own);
    return (point2){u, v};
}

static inline point2 sampler_halton(sampler *s)
{
    uint32_t d = 2 * s->pair, i = s->sample;
    if (d >= halton_bases) return sampler_random(s);
    return (point2){radical_inverse(halton_base[d], i), radical_inverse(halton_base[d + 1], i)};
}

static inline point2 sampler_pair(sampler *s)
{
    point2 p = {0, 0};
    s->own.dimension = 2 * (uint64_t)s->pair;
    switch (s->kind) {
    case SEQUENCE_RANDOM: p = sampler_random(s); break;
    case SEQUENCE_JITTERED:
        jitter_square(s->sample, s->samples, sampler_key(s, s->pair), &s->own, &p.u, &p.v);
        break;
    case SEQUENCE_HALTON: p = sampler_halton(s); break;
    case SEQUENCE_SOBOL: p = sampler_sobol(s, s->pair); break;
    case sequence_kinds: break;
    }
    s->pair++;
    return p;
}

static inline real sampler_number(sampler *s)
{
    if (s->kind != SEQUENCE_JITTERED) return sampler_pair(s).u;
    uint64_t key = sampler_key(s, s->pair);
    s->own.dimension = 2 * (uint64_t)s->pair++;
    return jitter_line(s->sample, s->samples, key, &s->own);
}

/* The first pairs of m pixels [1..sampler_rows], all by sampler_sobol, step by step, each step
 * vectors. */
fast_inline void sampler_sobol_rows(const sampler_keys *const *of, int m, uint32_t sample,
                                    point2 *const *pair)
{
    enum { row = sampler_row, most = sampler_rows * row };
    const uint32_t reversed = reversed_bits(sample);
    uint32_t key[most], a[most], b[most], x[most], y[most];
    real u[most], v[most];
    for (int i = 0; i < m; i++)
        for (int k = 0; k < row; k++) {
            key[row * i + k] = (uint32_t)of[i]->pair[k];
            a[row * i + k] = of[i]->axis[0][k], b[row * i + k] = of[i]->axis[1][k];
        }
    const int n = m * row;
    for (int k = 0; k < n; k++) x[k] = reversed_bits(owen_reversed(reversed, key[k]));
    for (int k = 0; k < n; k += row) x[k] = sample;
    for (int k = 0; k < n; k++)
        y[k] = reversed_bits(owen_reversed(sobol_index_of_y(x[k]), b[k]));
    for (int k = 0; k < n; k++) x[k] = reversed_bits(owen_reversed(x[k], a[k]));
    for (int k = 0; k < n; k++) u[k] = real_of_fraction(x[k], a[k]);
    for (int k = 0; k < n; k++) v[k] = real_of_fraction(y[k], b[k]);
    for (int k = 0; k < n; k++) pair[k / row][k % row] = (point2){u[k], v[k]};
}

static inline void sampler_row_of(const sampler_keys *of, uint32_t sample, uint32_t samples,
                                  point2 *pair)
{
    if (of->kind == SEQUENCE_SOBOL) {
        sampler_sobol_rows(&of, 1, sample, &pair);
        return;
    }
    sampler s = sampler_of_keys(of, sample, samples);
    for (int k = 0; k < sampler_row; k++) pair[k] = sampler_pair(&s);
}

/* Of sampler_rows pixels, by one kind of sequence. */
static inline void sampler_rows_of(const sampler_keys *const *of, uint32_t sample,
                                   uint32_t samples, point2 *const *pair)
{
    if (of[0]->kind == SEQUENCE_SOBOL) {
        sampler_sobol_rows(of, sampler_rows, sample, pair);
        return;
    }
    for (int i = 0; i < sampler_rows; i++) sampler_row_of(of[i], sample, samples, pair[i]);
}

#endif
