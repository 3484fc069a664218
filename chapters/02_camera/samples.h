/* samples.h: where to send the rays of one pixel (采样位置).
 *
 *     regular          jittered (抖动)      random
 *   .   .   .   .     .    |   |.  |       . .      .
 *                       .  |.  |  .|            .
 *   .   .   .   .     -----+---+---+        .       .
 *                      .   |  .|.  |         .
 *   .   .   .   .     -----+---+---+           .  .
 *
 *   for (int k = 0; k < n * n; k++) {
 *       samples_place(SAMPLES_JITTERED, k, n, f.radius, &stream, &x, &y);
 *       ... the ray through (pixel centre) + (x, y)
 *   }
 *
 * n x n positions in the square [-radius, radius]^2 around the pixel's centre, one a call. Regular:
 * the middle of each of n x n cells. Jittered: a random point of each cell. Random: anywhere. The
 * last two draw two numbers a call from the stream, the first none.
 *
 * Source: R. Cook, "Stochastic sampling in computer graphics", ACM Transactions on Graphics 5(1),
 * 1986.
 */
#ifndef CAMERA_SAMPLES_H
#define CAMERA_SAMPLES_H

#include "../../common/random.h"

typedef enum { SAMPLES_REGULAR, SAMPLES_JITTERED, SAMPLES_RANDOM } sample_placement;

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

#endif
