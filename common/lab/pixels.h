/* pixels.h: a picture from a function of the place: the loop over pixels.
 *
 *   vec3 colour(const void *context, real x, real y)       at (x, y), in pixels from the upper left
 *   bool whole = pixels_draw(&im, 2, threads, "picture", colour, &context);
 *   int side = pixels_side(samples)     the largest whole number whose square is not more [>= 1]
 *
 * Each pixel is the mean of side x side places, in the middles of as many equal squares. False:
 * stopped by Ctrl-C, and the picture holds what there was; see parallel.h.
 */
#ifndef PIXELS_H
#define PIXELS_H

#include "../image.h"
#include "../parallel.h"

typedef vec3 pixels_colour(const void *context, real x, real y);

/* ---------------------------------------------------------------------------------------------- */

typedef struct { image *im; int side; pixels_colour *colour; const void *context; } pixels_job;

static inline void pixels_one(int x, int y, void *job)
{
    const pixels_job *p = job;
    vec3 sum = {0, 0, 0};
    int n = p->side;
    for (int k = 0; k < n * n; k++)
        sum = vadd(sum, p->colour(p->context, (real)x + ((real)(k % n) + (real)0.5) / (real)n,
                                  (real)y + ((real)(k / n) + (real)0.5) / (real)n));
    image_set(p->im, x, y, vscale(sum, 1 / (real)(n * n)));
}

static inline int pixels_side(int samples) { return samples > 1 ? (int)sqrt(samples) : 1; }

static inline bool pixels_draw(image *im, int side, int threads, const char *what,
                               pixels_colour *colour, const void *context)
{
    pixels_job job = {im, side, colour, context};
    return parallel_pixels(im->width, im->height, threads, what, pixels_one, &job);
}

#endif
