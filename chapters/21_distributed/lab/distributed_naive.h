/* distributed_naive.h: a soft shadow and a glossy reflection as they are often made.
 *
 *   area_light_naive(&L, p, ng, ns, u, &x)      x.E as of the centre
 *   glossy_ray_naive(s, d, shine, u, &r)        what leads below the surface is sent into the body
 */
#ifndef DISTRIBUTED_NAIVE_H
#define DISTRIBUTED_NAIVE_H

#include "../area_light.h"
#include "../glossy.h"

/* ---------------------------------------------------------------------------------------------- */

/* The soft shadow as it is often made: the light of the centre, times the share of the shadow rays
 * that get through. Without occluders there is no noise, and E is wrong near a large light: below a
 * square of side 2 at height 1 it is 2.3 times what it should be. */
static inline bool area_light_naive(const area_light *L, vec3 p, vec3 ng, vec3 ns, point2 u,
                                    area_sample *out)
{
    area_light centre = *L;
    area_sample x;
    bool any = area_light_reaches(L, p, ng, ns, u, out);
    centre.a = centre.b = (vec3){0, 0, 0}, centre.r = 0;
    any = area_light_reaches(&centre, p, ng, ns, u, &x) && any;
    out->E = any ? x.E : (vec3){0, 0, 0};
    return any;
}

/* Under a thin floor it sees the sky below: the floor shines in the dark. */
static inline bool glossy_ray_naive(surface s, vec3 d, real shine, point2 u, ray *out)
{
    *out = leave(s, glossy_direction(s, d, shine, u));
    return true;
}

#endif
