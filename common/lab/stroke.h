/* stroke.h: straight lines on top of a picture.
 *
 *   draw_stroke(&im, x0, y0, x1, y1, width, colour);      all in pixels; O(all pixels)
 */
#ifndef STROKE_H
#define STROKE_H

#include "../image.h"

/* ---------------------------------------------------------------------------------------------- */

/* A pixel is covered if its centre lies inside the line, and not at all a pixel further out. */
static inline void draw_stroke(image *im, real x0, real y0, real x1, real y1, real width,
                               vec3 colour)
{
    vec3 a = {x0, y0, 0}, ab = {x1 - x0, y1 - y0, 0};
    real length2 = vdot(ab, ab);
    for (int y = 0; y < im->height; y++)
        for (int x = 0; x < im->width; x++) {
            vec3 p = vsub((vec3){(real)x + (real)0.5, (real)y + (real)0.5, 0}, a);
            real t = length2 > 0 ? real_clamp(vdot(p, ab) / length2, 0, 1) : 0;
            real cover = real_clamp((width + 1) / 2 - vlength(vmadd(p, ab, -t)), 0, 1);
            vec3 under = image_get(im, x, y);
            if (cover > 0) image_set(im, x, y, vmadd(under, vsub(colour, under), cover));
        }
}

#endif
