/* frame.h: coordinates of a structure's own, in which a float is fine enough for all that it holds.
 *
 *   aabb_frame f = frame_of(all, away, e)  of what lies in all, which is not empty
 *   q = frame_into(&f, p)                  scale (p - centre)
 *   p = frame_back(&f, q)                  and back
 *
 * Far from 0 floats are too coarse, and beyond 1e38 there are none. So the middle of all is moved
 * to 0, unless it lies within `away` half sizes of it: then coordinates that were floats stay so.
 * The scale is a power of two, which rounds nothing: it makes the largest coordinate 1/2 to 1,
 * where that was not between 2^-e and 2^e.
 */
#ifndef AABB_FRAME_H
#define AABB_FRAME_H

#include "aabb.h"

typedef struct { vec3 centre; real scale; } aabb_frame;

/* ---------------------------------------------------------------------------------------------- */

static inline aabb_frame frame_of(aabb all, real away, int most)
{
    vec3 centre = aabb_centre(all), half = vsub(all.hi, centre);
    real size = vlargest(half), far = vlargest(centre);
    int e, end = real_is_float ? 100 : 1000;
    if (far <= away * size) centre = (vec3){0, 0, 0}, size += far;
    (void)frexp(size, &e);
    if (!(size > 0) || (e >= -most && e <= most)) e = 0;
    return (aabb_frame){centre, ldexp((real)1, e > end ? -end : e < -end ? end : -e)};
}

static inline vec3 frame_into(const aabb_frame *f, vec3 p)
{
    return vscale(vsub(p, f->centre), f->scale);
}

static inline vec3 frame_back(const aabb_frame *f, vec3 p)
{
    return vadd(vscale(p, 1 / f->scale), f->centre);
}

#endif
