/* random.h: random numbers that depend on (seed, pixel, sample, dimension) and on nothing else.
 *
 * A generator with a hidden state hands its numbers out in the order in which threads ask. Here
 * each number is looked up: the same four keys give the same number, on any machine, in any order,
 * with any number of threads, so a picture is the same byte for byte.
 *
 *   uint64_t random_bits(seed, pixel, sample, dimension)     64 random bits
 *   real     random_real(seed, pixel, sample, dimension)     uniform in [0,1), never 1
 *   random_stream s = random_start(seed, pixel, sample);     the same, dimension 0, 1, 2, ...
 *   real     random_next(&s);
 *
 * Bits to real: (bits >> 40) * 2^-24 in float, (bits >> 11) * 2^-53 in double. The short cut
 * (float)u * 2^-32 rounds the 128 largest words up to 1.
 *
 * Source of the mixing function: Steele, Lea, Flood, "Fast splittable pseudorandom number
 * generators", OOPSLA 2014 (SplitMix64), with the constants of D. Stafford's variant 13.
 */
#ifndef RANDOM_H
#define RANDOM_H

#include "vec3.h"
#include <stdint.h>

typedef struct { uint64_t key, dimension; } random_stream;

/* ---------------------------------------------------------------------------------------------- */

/* A bijection of 64-bit words in which every input bit changes each output bit half of the time. */
static inline uint64_t random_mix(uint64_t x)
{
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

static inline random_stream random_start(uint64_t seed, uint64_t pixel, uint64_t sample)
{
    uint64_t golden = 0x9e3779b97f4a7c15u;
    uint64_t key = random_mix(seed + golden);
    key = random_mix(key + golden * (pixel + 1));
    return (random_stream){random_mix(key ^ (golden * (sample + 1))), 0};
}

static inline uint64_t random_next_bits(random_stream *s)
{
    return random_mix(s->key + 0x9e3779b97f4a7c15u * ++s->dimension);
}

static inline float random_float_of(uint64_t bits) { return (float)(bits >> 40) * 0x1p-24f; }
static inline double random_double_of(uint64_t bits) { return (double)(bits >> 11) * 0x1p-53; }

static inline real random_real_of(uint64_t bits)
{
    return real_is_float ? (real)random_float_of(bits) : (real)random_double_of(bits);
}

static inline real random_next(random_stream *s) { return random_real_of(random_next_bits(s)); }

static inline uint64_t random_bits(uint64_t seed, uint64_t pixel, uint64_t sample,
                                   uint64_t dimension)
{
    random_stream s = random_start(seed, pixel, sample);
    s.dimension = dimension;
    return random_next_bits(&s);
}

static inline real random_real(uint64_t seed, uint64_t pixel, uint64_t sample, uint64_t dimension)
{
    return random_real_of(random_bits(seed, pixel, sample, dimension));
}

#endif
