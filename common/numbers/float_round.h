/* float_round.h: a real as a float that is never too large, or never too small (定向舍入, directed
 * rounding); and floats as whole numbers in the same order.
 *
 *   float_below(x)   the largest float <= x         float_above(x)   the smallest float >= x
 *   float_beyond(x)  some float > x, for an x that was rounded itself
 *   float_min(a, b), float_max(a, b)   b if one of them is NaN
 *   float_bits(x)    its 32 bits, as they are
 *   float_key(x)     a uint32_t: float_key(a) < float_key(b) exactly if a < b; -0 counts as 0
 *   float_of_key(k)  the float whose key k is
 *
 * A tree may keep its boxes in float, half the memory of double, if what was in the box still is:
 * its low sides are rounded down, its high sides up. Rounded to the nearest, 1 - 2^-30 would become
 * 1, and a low side of 1 leaves it outside.
 *
 *   x             float_below         float_above
 *   0.1           0.0999999940        0.100000001
 *   1e39          FLT_MAX             infinity         (the largest float is 3.4e38)
 *   -1e-50        -2^-149             -0
 *   NaN           NaN                 NaN
 *
 * The keys are sorted by their digits (基数排序, radix sort), without comparing floats.
 *
 * Sources: IEEE 754-2019, sections 3.4 (the bits of a float, as a number without its sign, ascend
 * as the floats do) and 4.3 (directed rounding); M. Herf, "Radix Tricks", 2001 (the key).
 */
#ifndef FLOAT_ROUND_H
#define FLOAT_ROUND_H

#include "../vec3.h"
#include <stdint.h>
#include <string.h>

/* ---------------------------------------------------------------------------------------------- */

static inline uint32_t float_bits(float x)
{
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

/* The nearest float, or where that is above x the one before it: its bits, as a number, less one,
 * or one more if it is negative. (FLT_MAX comes before infinity, and -2^-149 before -0. Bits of +0
 * are never above x: a negative x that becomes 0 becomes -0.) Which of the two is a coin toss: a
 * branch would be guessed wrong every other time, and make building a tree a third slower. */
static inline float float_below(real x)
{
    float f = (float)x;
    uint32_t bits = float_bits(f), above = (real)f > x;
    bits += 2 * (bits >> 31 & above) - above;
    memcpy(&f, &bits, sizeof f);
    return f;
}

static inline float float_above(real x) { return -float_below(-x); }

/* By at least the error of the last operation that made x: x + |x| 2^-24. Below all floats it is a
 * NaN, which loses every comparison. */
static inline float float_beyond(real x)
{
    float f = (float)x;
    return f + (fabs(f) * FLT_EPSILON + 0x1p-149f);
}

static inline float float_min(float a, float b) { return a < b ? a : b; }
static inline float float_max(float a, float b) { return a > b ? a : b; }

/* All bits of a negative float are turned over, of others the sign. A NaN comes before or after all
 * numbers, by its sign. */
static inline uint32_t float_key(float x)
{
    uint32_t bits = float_bits(x + 0.0f);  /* -0 becomes 0 */
    return bits & 0x80000000u ? ~bits : bits | 0x80000000u;
}

static inline float float_of_key(uint32_t key)
{
    float x;
    key = key & 0x80000000u ? key & 0x7fffffffu : ~key;
    memcpy(&x, &key, sizeof x);
    return x;
}

#endif
