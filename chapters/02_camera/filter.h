/* filter.h: one pixel from several rays: their weighted mean (加权平均).
 *
 *   box                tent               Gaussian           weight w(x) w(y) of a ray that leaves
 *    ______              /\                  _               the pixel's centre by (x, y) pixels
 *   |      |            /  \               /   \
 *   |      |           /    \            /       \           pixel = sum w_k c_k / sum w_k  (2.10)
 *  -.5    .5         -1      1        -2   (.5)   2
 *
 *   filter_sum s = {0};
 *   for each ray: s = filter_add(s, filter_weight(f, x, y), colour);
 *   vec3 pixel = filter_mean(s);
 *
 * filter_box, filter_tent, filter_gaussian: the three above. w is not normalised; it is 0 outside
 * [-radius, radius]. Rays may be spread over that square in any way that is even (see samples.h).
 *
 * Without any weight the pixel is black.
 *
 * Sources: T. Akenine-Möller et al., "Real-Time Rendering", 4th ed., 2018, online chapter 26,
 * section 26.1 (weighted mean of several rays); M. Pharr, W. Jakob, G. Humphreys, "Physically Based
 * Rendering", 3rd ed., 2016, section 7.8.
 */
#ifndef CAMERA_FILTER_H
#define CAMERA_FILTER_H

#include "../../common/vec3.h"

typedef enum { FILTER_BOX, FILTER_TENT, FILTER_GAUSSIAN } filter_kind;
typedef struct {
    filter_kind kind;
    real radius;  /* half the width of the square that it covers [pixels] */
    real sigma;   /* Gaussian: standard deviation [pixels] */
} filter;
typedef struct { vec3 colour; real weight; } filter_sum;

#define filter_box ((filter){FILTER_BOX, 0.5, 0})
#define filter_tent ((filter){FILTER_TENT, 1, 0})
#define filter_gaussian ((filter){FILTER_GAUSSIAN, 2, 0.5})

/* ---------------------------------------------------------------------------------------------- */

/* The factor of one axis. Written so that a NaN has no weight. */
static inline real filter_weight_1d(filter f, real x)
{
    if (!(fabs(x) <= f.radius)) return 0;
    switch (f.kind) {
    case FILTER_BOX: return 1;
    case FILTER_TENT: return 1 - fabs(x) / f.radius;
    case FILTER_GAUSSIAN: return exp(-x * x / (2 * f.sigma * f.sigma));
    }
    return 0;
}

static inline real filter_weight(filter f, real x, real y)
{
    return filter_weight_1d(f, x) * filter_weight_1d(f, y);
}

static inline filter_sum filter_add(filter_sum s, real w, vec3 colour)
{
    return (filter_sum){vmadd(s.colour, colour, w), s.weight + w};
}

/* Divides by the sum of these very weights: a wall of one colour keeps it within rounding. (By what
 * they sum to on average, four jittered rays under a tent may see a wall of 1 as .5 or as 1.5.) */
static inline vec3 filter_mean(filter_sum s)
{
    return s.weight > 0 ? vscale(s.colour, 1 / s.weight) : (vec3){0, 0, 0};
}

#endif
