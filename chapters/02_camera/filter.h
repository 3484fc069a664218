/* filter.h: one pixel from several rays: where they go (采样位置), and their weighted mean (加权平均).
 *
 *     regular          jittered (抖动)      random          n x n places in the square
 *   .   .   .   .     .    |   |.  |       . .      .       [-radius, radius]^2 round the middle of
 *                       .  |.  |  .|            .           the pixel. Regular: in the middle of
 *   .   .   .   .     -----+---+---+        .       .       each of n x n cells. Jittered: anywhere
 *                      .   |  .|.  |         .              in each. Random: anywhere. These draw
 *   .   .   .   .     -----+---+---+           .  .         two numbers each from the stream.
 *
 *   box                tent               Gaussian           weight w(x) w(y) of a ray that leaves
 *    ______              /\                  _               the pixel's centre by (x, y) pixels
 *   |      |            /  \               /   \
 *   |      |           /    \            /       \           pixel = sum w_k c_k / sum w_k  (2.10)
 *  -.5    .5         -1      1        -2   (.5)   2
 *
 *   filter_sum s = {0};
 *   for (int k = 0; k < n * n; k++) {
 *       samples_place(SAMPLES_JITTERED, k, n, f.radius, &stream, &x, &y);
 *       s = filter_add(s, filter_weight(f, x, y), colour of the ray through middle + (x, y));
 *   }
 *   vec3 pixel = filter_mean(s);                        without any weight: black
 *
 * filter_box, filter_tent, filter_gaussian: the three above. w is not normalised; it is 0 outside
 * [-radius, radius].
 *
 * Sources: T. Akenine-Möller et al., "Real-Time Rendering", 4th ed., 2018, online chapter 26,
 * section 26.1 (weighted mean of several rays); M. Pharr, W. Jakob, G. Humphreys, "Physically Based
 * Rendering", 3rd ed., 2016, section 7.8; R. Cook, "Stochastic sampling in computer graphics", ACM
 * Transactions on Graphics 5(1), 1986.
 */
#ifndef CAMERA_FILTER_H
#define CAMERA_FILTER_H

#include "../../common/random.h"

typedef enum { SAMPLES_REGULAR, SAMPLES_JITTERED, SAMPLES_RANDOM } sample_placement;
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

static inline void samples_place(sample_placement how, int k, int n, real radius, random_stream *s,
                                 real *x, real *y)
{
    real i = (real)(k % n), j = (real)(k / n), cells = (real)n;
    real a = 0.5, b = 0.5;
    if (how != SAMPLES_REGULAR) {
        a = random_next(s);
        b = random_next(s);
    }
    if (how == SAMPLES_RANDOM) {  /* one cell: the whole square */
        i = j = 0;
        cells = 1;
    }
    *x = radius * (2 * (i + a) / cells - 1);
    *y = radius * (2 * (j + b) / cells - 1);
}

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
