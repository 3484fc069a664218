/* first.h: a ray (光线), the points on it, and the interval (光线间隔) in which it counts.
 * Wrong far out: (1.1) loses digits as t grows; both move in steps where o is far from the origin.
 * ray.h says which form to take where, and how shadow rays leave out their ends. */
#ifndef FIRST_RAY_H
#define FIRST_RAY_H
#include "../../common/vec3.h"
#include <stdint.h>

/* The fields stand in the order of DXR's RayDesc (Origin, TMin, Direction, TMax). */
typedef struct {
    vec3 o;     /* origin (原点) */
    real tmin;  /* first t that counts */
    vec3 d;     /* direction (方向): not zero, any length */
    real tmax;  /* last t that counts */
} ray;

typedef struct {
    real t;          /* where on the ray */
    real u, v;       /* where on the shape, if it has coordinates: see the shape; else 0 */
    uint32_t shape;  /* its number in the scene; a single shape leaves it 0 */
} hit;

/* p(t) = (1 - t) a + t b                                                                  (1.1) */
static inline vec3 ray_at_between(vec3 a, vec3 b, real t)
{
    return vadd(vscale(a, 1 - t), vscale(b, t));
}

/* p(t) = o + t d                                                                          (1.2) */
static inline vec3 ray_at(ray r, real t) { return vadd(r.o, vscale(r.d, t)); }

/* All that lies in front of o. */
static inline ray ray_from(vec3 o, vec3 d) { return (ray){o, 0, d, real_infinity}; }

/* From a to b: d = b - a, so that t = 0 is a and t = 1 is b. */
static inline ray ray_between(vec3 a, vec3 b) { return (ray){a, 0, vsub(b, a), 1}; }

/* The same points with a d of length 1: t becomes t |d|, a distance.                      (1.3) */
static inline ray first_ray_unit(ray r)
{
    real length = vlength(r.d);
    return (ray){r.o, r.tmin * length, vscale(r.d, 1 / length), r.tmax * length};
}

/* tmin <= t <= tmax                                                                       (1.4) */
static inline bool ray_covers(ray r, real t) { return t >= r.tmin && t <= r.tmax; }
#endif
