/* depth_format.h: how a depth buffer (深度缓冲) writes down how far something is, in 32 bits.
 *
 * Seen through a camera a plane has 1/z linear across the picture, z itself not (8.4). So what is
 * mixed is 1/z, and what is stored is a number made of it:
 *
 *   DEPTH_REVERSED   near / z in float         1 at the near plane, 0 at infinity; the default
 *   DEPTH_FLOAT      1 - near / z in float     0 at the near plane, 1 at infinity: what far things
 *                                              differ by is lost beside the 1
 *   DEPTH_24         1 - near / z in 24 bits   the same steps everywhere from 0 to 1
 *   DEPTH_LINEAR     z / near in float         needs a division a pixel
 *
 *   uint32_t k = depth_key(format, near * 1/z)     the smaller the nearer, whatever the format
 *
 * Floats are dense near 0, and there near / z crowds what is far. Sources: E. Lapidous, G. Jiao,
 * "Optimal Depth Buffer for Low-Cost Graphics Hardware", Graphics Hardware 1999; N. Reed, "Depth
 * Precision Visualized", 2015.
 */
#ifndef DEPTH_FORMAT_H
#define DEPTH_FORMAT_H

#include "../../common/vec3.h"
#include <stdint.h>
#include <string.h>

typedef enum { DEPTH_REVERSED, DEPTH_FLOAT, DEPTH_24, DEPTH_LINEAR, depth_formats } depth_format;

static const char *const depth_name[depth_formats] = {
    "near/z, float", "1 - near/z, float", "1 - near/z, 24 bits", "z, float"};

#define depth_farthest UINT32_MAX  /* a pixel that has seen nothing */

/* ---------------------------------------------------------------------------------------------- */

/* The bits of a float >= 0 are in the order of the floats. */
static inline uint32_t depth_bits(float x)
{
    uint32_t k;
    memcpy(&k, &x, sizeof k);
    return k;
}

/* x = near / z, in [0, 1] but for rounding. */
static inline uint32_t depth_key(depth_format f, real x)
{
    switch (f) {
    case DEPTH_FLOAT: return depth_bits((float)real_max(1 - x, 0));
    case DEPTH_24: return (uint32_t)lrint((double)real_clamp(1 - x, 0, 1) * 0xffffff);
    case DEPTH_LINEAR: return depth_bits((float)(1 / x));
    default: return depth_farthest - 1 - depth_bits((float)real_max(x, 0));
    }
}

#endif
