/* dice.h: random numbers with a name: what is not called for shifts nothing.
 *
 *   number = f(seed, pixel, sample, node, purpose)
 *
 *   dice_pixel p; dice_pixel_of(seed, pixel, pairs, &p);    hashed once, and outlives; where no
 *                                                     dice_pair will be asked for, pairs false
 *                                                     spares the hashing of these
 *   dice d = dice_sample(&p, k)                       sample k of the pixel
 *   point2 u = dice_pair(&d, node, depth, DICE_LAMP)  [0,1)^2; the same whenever it is asked for
 *   real u = dice_number(&d, node, purpose)           one, independent of all others
 *   random_stream s = dice_stream(&d, node)           a row of such numbers
 *   node = dice_child(node, kind)                     of a ray of kind 0 .. 15; the eye's is 0
 *
 * Of a stream of numbers, one after the other, a shadow ray left out would hand its own on to the
 * next ray. Two nodes may meet in one number, once in 2^29: they are not independent then. Samples
 * k and k + 1 belong to halves that share nothing, as in 26. Down to depth dice_depth pairs are
 * Sobol's, further ones are independent.
 */
#ifndef EFFECTS_DICE_H
#define EFFECTS_DICE_H

#include "../20_monte_carlo/sampler.h"
#include "effect.h"

typedef enum {
    DICE_LAMP, DICE_SKY, DICE_GLOSSY, DICE_INDIRECT, DICE_SURVIVES_MIRROR, DICE_SURVIVES_GLOSSY,
    DICE_SURVIVES_INDIRECT, DICE_SURVIVES_REFRACTION, dice_purposes
} dice_purpose;

enum { DICE_PIXEL, DICE_LENS, dice_of_eye };  /* its pairs: where in the pixel, on the lens */
typedef struct { sampler_keys pairs[2]; uint64_t own[2]; } dice_pixel;  /* of each half */
typedef struct { sampler pairs; uint64_t own; } dice;
enum { dice_depth = 3, dice_row = 32 };  /* dice_row: number of a stream; others are below */

/* ---------------------------------------------------------------------------------------------- */

static inline void dice_pixel_of(uint64_t seed, uint64_t pixel, bool pairs, dice_pixel *out)
{
    for (uint64_t k = 0; k < 2; k++) {
        if (pairs) sampler_keys_of(SEQUENCE_SOBOL, seed, 2 * pixel + k, &out->pairs[k]);
        else out->pairs[k] = (sampler_keys){.kind = SEQUENCE_SOBOL};
        out->own[k] = random_pixel(seed, 2 * pixel + k);
    }
}

static inline dice dice_sample(const dice_pixel *p, uint32_t k)
{
    return (dice){sampler_of_keys(&p->pairs[k % 2], k / 2, 1u << 31),
                  random_sample(p->own[k % 2], k / 2).key};
}

/* Mixed: 16 node + kind alone would forget the first ray after eight, and of ten bounces in a row
 * the last would all be one node. */
static inline uint32_t dice_child(uint32_t node, uint32_t kind)
{
    return (uint32_t)(random_mix(16 * (uint64_t)node + kind + 1) >> 32);
}

fast_inline uint64_t dice_bits(const dice *d, uint32_t node, uint32_t number)
{
    return random_mix(d->own ^ random_mix(random_step * (node * (uint64_t)64 + number + 1)));
}

fast_inline real dice_number(const dice *d, uint32_t node, dice_purpose purpose)
{
    return random_real_of(dice_bits(d, node, purpose));
}

static inline random_stream dice_stream(const dice *d, uint32_t node)
{
    return (random_stream){dice_bits(d, node, dice_row), 0};
}

fast_inline point2 dice_pair(const dice *d, uint32_t node, int depth, dice_purpose purpose)
{
    if (depth > dice_depth) {
        real u = random_real_of(dice_bits(d, node, dice_purposes + 2 * (uint32_t)purpose));
        real v = random_real_of(dice_bits(d, node, dice_purposes + 2 * (uint32_t)purpose + 1));
        return (point2){u, v};
    }
    return sampler_sobol(&d->pairs, node * dice_purposes + (uint32_t)purpose + dice_of_eye);
}

#endif
