/* ray.h: a ray (光线) and its interval (光线间隔).
 *
 *        tmin                 tmax          p(t) = o + t d                          (1.2)
 *    o ---[=====================]--->       only hits with tmin <= t <= tmax count  (1.4)
 *    t = 0                      d
 *
 * d need not have unit length. t counts in lengths of d: with d = b - a, t = 0 is a and t = 1 is b;
 * with a unit d, t is a distance. Rescaling d by s divides every t by s, and changes no point.
 *
 *   ray r = ray_between(a, b);           from a to b, d = b - a, interval [0, 1]
 *   ray r = ray_from(o, d);              everything in front of o, interval [0, infinity]
 *   vec3 p = ray_at(r, t);               the point
 *   vec3 p = ray_at_between(a, b, t);    (1 - t) a + t b: exact at both ends, poor far beyond
 *   if (ray_covers(r, t)) ...            the closed interval; a NaN is never in it
 *   ray u = ray_unit(r);                 the same points, d of length 1, t and interval times |d|
 *   ray s = ray_shadow(p, light, eps);   from p to a light without its ends; eps in [0, 1/2)
 *   ray s = ray_shadow_unit(p, light, eps);        the same with a unit d; eps is a distance
 *
 * A search for the closest hit keeps the nearest t found so far in r.tmax: see hit.h.
 *
 * The fields stand in the order of DXR's RayDesc (Origin, TMin, Direction, TMax); in float they are
 * the same 32 bytes.
 *
 * Sources: P. Shirley, I. Wald, T. Akenine-Möller, E. Haines, "What is a Ray?", Ray Tracing Gems,
 * 2019, ch. 2 (2-1), (2-2), (2-3); Microsoft, DirectX Raytracing functional specification,
 * "RayDesc".
 */
#ifndef RAY_H
#define RAY_H

#include "first.h"

/* `ray`, ray_at and what asks for no bound stand in first.h. The bounds:
 *
 *   ray_at          (1.2): each component is off by at most epsilon (|o| + |t d|): half an epsilon
 *                   for the product and half for the sum
 *   ray_at_between  (1.1): exact at t = 0 and at t = 1, where ray_at reaches b only within
 *                   rounding. Beyond b the two products grow with t and cancel: off by up to 3/2
 *                   epsilon (|(1 - t) a| + |t b|), for a far a and a large t worse than (1.2) by
 *                   the factor t
 *   ray_covers      (1.4), with >= and <=, so that a NaN t is outside */

/* ---------------------------------------------------------------------------------------------- */

/* The same points and the same interval with a unit d: t becomes t |d|, a distance (1.3). */
static inline ray ray_unit(ray r)
{
    real length = vlength(r.d);
    return (ray){r.o, r.tmin * length, vunit(r.d), r.tmax * length};
}

/* From p to a light without its ends: [eps, 1 - eps] (1.5). eps is a fraction of the way < 1/2. */
static inline ray ray_shadow(vec3 p, vec3 light, real eps)
{
    return (ray){p, eps, vsub(light, p), 1 - eps};
}

/* The same with a unit d: [eps, |l - p| - eps] (1.6). Now eps is a distance in scene units: the
 * same number leaves out something else. Costs two square roots and a division more. */
static inline ray ray_shadow_unit(vec3 p, vec3 light, real eps)
{
    vec3 d = vsub(light, p);
    return (ray){p, eps, vunit(d), vlength(d) - eps};
}

#endif
