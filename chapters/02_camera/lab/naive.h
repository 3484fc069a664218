/* naive.h: what texts print, and where it fails: camera.h and filter.h have the forms that do not.
 *
 *   half_tangent_naive(phi)              tan(phi / 2), phi in degrees: loses digits near 180
 *   camera_ray_naive(c, x, y, w, h)      the ray as e + t (s - e): loses digits far from 0
 *   filter_mean_naive(sum, f, n)         divides by what n weights sum to on average: a white wall
 *                                        is not white
 *   filter_volume(f)                     that of the filter, over the plane
 *
 * Source: S. Marschner, P. Shirley, "Fundamentals of Computer Graphics", 4th ed., 2015, sections
 * 4.1 to 4.3.
 */
#ifndef CAMERA_LAB_NAIVE_H
#define CAMERA_LAB_NAIVE_H

#include "../camera.h"
#include "../filter.h"

/* ---------------------------------------------------------------------------------------------- */

/* At phi = 179.99 in float it is off by 1e-3: it rounds an angle close to a right angle, whose
 * tangent depends on what is missing to it. */
static inline real half_tangent_naive(real phi) { return tan(phi * pi / 360); }

/* |e| = 1e6, d = 0.035, in float: the floats near e are 1/16 apart, so s = e + D lands on a lattice
 * coarser than the whole image plane, and s - e has the errors of s: epsilon |e| / d in direction.
 * FCG introduces the ray in this way, as e + t (s - e), and then computes it as camera_ray does. */
static inline ray camera_ray_naive(camera c, real x, real y, int w, int h)
{
    vec3 in_plane = camera_in_plane(c, camera_u(c, x, w), camera_v(c, y, h));
    if (c.kind == CAMERA_PARALLEL) return ray_from(vadd(c.e, in_plane), c.direction);
    vec3 through = vadd(c.e, vmadd(in_plane, c.w, -c.d));
    return ray_from(c.e, vsub(through, c.e));
}

/* The integral of filter_weight over the plane: 1, radius^2, or about 2 pi sigma^2. */
static inline real filter_volume(filter f)
{
    real side = f.kind == FILTER_BOX ? 2 * f.radius
              : f.kind == FILTER_TENT ? f.radius
              : f.sigma * sqrt(2 * pi) * erf(f.radius / (f.sigma * sqrt((real)2)));
    return side * side;
}

/* n positions that cover the square of area (2 radius)^2 evenly have weights that sum to about
 * n volume / area, and this divides by that number. It is right on average, but not for the n rays
 * at hand: four jittered rays under a tent may see a wall of brightness 1 as .5 or as 1.5. */
static inline vec3 filter_mean_naive(filter_sum sum, filter f, int n)
{
    return vscale(sum.colour, 4 * f.radius * f.radius / (filter_volume(f) * (real)n));
}

#endif
