/* ambient_occlusion.h: how much of an even sky a point sees: light that no lamp sends directly.
 *
 *     .  . sky .  .          open = 1/pi integral over the hemisphere of V(w) (n.w) dw       (21.7)
 *    .   \  | /    . |       one sample: V of one ray, w with the pdf (n.w) / pi
 *   .     \ |/ ......|       L = kd La open
 *   --------p--------|wall
 *
 *   bool ambient_ray(s, u, reach, &r)      false: w is below the geometric surface: closed, and no
 *                                          ray is called for; else one of kind RAY_SIGHT (18)
 *
 * 18 adds kd La everywhere, as if nothing were in the way: in a corner that is far too much. This
 * is the mend of its time; it is exact if the sky is La in all directions and all that hides it is
 * black. reach [scene units, > 0, infinity]: what is farther away hides nothing. In a closed room
 * everything is hidden, and only a finite reach leaves any light: then it is a way of drawing, and
 * no measure of light.
 *
 * Known (21.8): under a disk of radius R at height h, open = h^2 / (R^2 + h^2); under a ball at
 * distance d, 1 - R^2 / d^2; at a wall of height H at distance x, (1 + x / sqrt(x^2 + H^2)) / 2; in
 * a corner of two walls without end, 1/4.
 *
 * Sources: S. Zhukov, A. Iones, G. Kronin, "An ambient light illumination model", EGRW 1998; H.
 * Landis, "Production-ready global illumination", SIGGRAPH course 2002; RTR, 4th ed., section 26.1
 * (ray casting for occlusion).
 */
#ifndef DISTRIBUTED_AMBIENT_OCCLUSION_H
#define DISTRIBUTED_AMBIENT_OCCLUSION_H

#include "../18_shade/shade.h"
#include "../20_monte_carlo/sampler.h"
#include "../20_monte_carlo/sampling.h"

/* ---------------------------------------------------------------------------------------------- */

/* w has length 1 within 8 epsilon, so t is a distance. */
static inline bool ambient_ray(surface s, point2 u, real reach, ray *out)
{
    vec3 w = directed(s.ns, sample_cosine(u.u, u.v));
    *out = leave(s, w);
    out->tmax = reach;
    return vdot(w, s.n) > 0;
}

#endif
