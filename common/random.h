/* random.h: random numbers that depend on (seed, pixel, sample, dimension) and on nothing else.
 *
 * So a picture is the same with any number of threads: no hidden state, no order of asking.
 *
 *   real x = random_real(seed, pixel, sample, dimension);    uniform in [0,1), never 1
 *   random_stream s = random_start(seed, pixel, sample);     the same: dimension 0, 1, 2, ...
 *   real y = random_next(&s);                                random_between(&s, lo, hi)
 *   uint64_t key = random_pixel(seed, pixel); s = random_sample(key, sample);    in two steps
 *
 * The short cut (float)u * 2^-32 rounds the 128 largest words up to 1: 24 bits make a float, 53 a
 * double. Streams are pieces of one sequence of 2^64 numbers: of 10^9 some ten pairs overlap.
 *
 * Source: Steele, Lea, Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014
 * (SplitMix64), with the constants of D. Stafford's variant 13.
 */
#ifndef RANDOM_H
#define RANDOM_H
#include "vec3.h"
#include <stdint.h>

#ifndef RANDOM_OFFSET
#define RANDOM_OFFSET 0  /* other numbers everywhere, for tests/soak.sh */
#endif

typedef struct { uint64_t key, dimension; } random_stream;
#define random_step 0x9e3779b97f4a7c15u  /* 2^64 / golden ratio: odd, and without a pattern */

/* ---------------------------------------------------------------------------------------------- */
/* A bijection of 64-bit words in which every input bit changes each output bit half of the time. */
fast_inline uint64_t random_mix(uint64_t x)
{
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

static inline uint64_t random_pixel(uint64_t seed, uint64_t pixel)
{
    return random_mix(random_mix(seed + RANDOM_OFFSET + random_step) + random_step * (pixel + 1));
}

static inline random_stream random_sample(uint64_t pixel_key, uint64_t sample)
{
    return (random_stream){random_mix(pixel_key ^ random_step * (sample + 1)), 0};
}

static inline random_stream random_start(uint64_t seed, uint64_t pixel, uint64_t sample)
{
    return random_sample(random_pixel(seed, pixel), sample);
}

static inline uint64_t random_next_bits(random_stream *s)
{
    return random_mix(s->key + random_step * ++s->dimension);
}

static inline float random_float_of(uint64_t bits) { return (float)(bits >> 40) * 0x1p-24f; }
static inline double random_double_of(uint64_t bits) { return (double)(bits >> 11) * 0x1p-53; }

static inline real random_real_of(uint64_t bits)
{
    return real_is_float ? (real)random_float_of(bits) : (real)random_double_of(bits);
}

static inline real random_next(random_stream *s) { return random_real_of(random_next_bits(s)); }

static inline real random_between(random_stream *s, real lo, real hi)
{
    return lo + (hi - lo) * random_next(s);
}

static inline uint64_t random_bits(uint64_t seed, uint64_t pixel, uint64_t sample, uint64_t number)
{
    random_stream s = random_start(seed, pixel, sample);
    s.dimension = number;
    return random_next_bits(&s);
}

static inline real random_real(uint64_t seed, uint64_t pixel, uint64_t sample, uint64_t dimension)
{
    return random_real_of(random_bits(seed, pixel, sample, dimension));
}

/* A point of the cube [-half, half)^3, each as likely; three numbers of the stream, x first. */
static inline vec3 random_in_cube(random_stream *s, real half)
{
    real x = 2 * random_next(s) - 1, y = 2 * random_next(s) - 1, z = 2 * random_next(s) - 1;
    return vscale((vec3){x, y, z}, half);
}

/* A direction of length 1, each as likely: z, and the angle about it. */
static inline vec3 random_unit(random_stream *s)
{
    real z = 2 * random_next(s) - 1, a = 2 * pi * random_next(s), r = sqrt(real_max(0, 1 - z * z));
    return (vec3){r * cos(a), r * sin(a), z};
}
#endif
