/* corner.h: rays through a corner of a box, all numbers chosen so that float may be as far off as
 * it can be: what a search in float adds to its boxes must be enough here.
 *
 *   vec3 corner;
 *   ray r = corner_ray(&g, far, &corner);   corner: three floats, D from r.o between 1 and 2
 *
 * far: how far both are from 0. Where far is 0, o is, too: then o + delta is delta, and not rounded
 * up to the next float. t is a little more than 1/2: corner - o, 1 / d and the product lie just
 * above a power of two, where half a last digit is the most that it can be.
 */
#ifndef TESTS_CORNER_H
#define TESTS_CORNER_H

#include "../chapters/01_ray/ray.h"
#include "../common/random.h"

/* ---------------------------------------------------------------------------------------------- */

/* 1 to 1.03 or its negative. */
static inline real corner_side(random_stream *g)
{
    real x = 1 + random_next(g) * (real)0.03;
    return random_next_bits(g) & 1 ? x : -x;
}

static inline ray corner_ray(random_stream *g, real far, vec3 *corner)
{
    vec3 o = random_in_cube(g, far), side = {corner_side(g), corner_side(g), corner_side(g)};
    vec3 c = vadd(o, side);
    real t = (1 + random_next(g) * (real)0.03) / 2;
    *corner = (vec3){(real)(float)c.x, (real)(float)c.y, (real)(float)c.z};
    return ray_from(o, vscale(vsub(*corner, o), 1 / t));
}

#endif
