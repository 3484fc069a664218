/* aabb.h: axis-aligned bounding boxes (轴对齐包围盒), and whether a ray meets one.
 *
 *        |  x slab  |             A slab (对面) is the space between two parallel planes; a box
 *   -----+----------+----- hi.y   is where three of them overlap. On axis k the ray is in its slab
 *        |   box  / |  y slab     for t between
 *   -----+------/---+----- lo.y     (lo_k - o_k) / d_k  and  (hi_k - o_k) / d_k          (9.1)
 *        |    /     |             and in the box where the three intervals overlap:
 *           o                       t_enter = the largest entry, t_exit = the smallest exit (9.2)
 *
 *   bool aabb_hit(aabb b, ray r, real *t_enter)        hit: the closed box and the closed interval
 *                                                      [tmin, tmax] have a point in common (9.4)
 *   aabb_inverse i = aabb_inverse_of(r);               once a ray, for many boxes: same answers;
 *   bool aabb_hit_inverse(const aabb *b, const aabb_inverse *i, ray r, real *t_enter)
 *                                                      r's interval may shrink meanwhile
 *
 *   aabb_empty()           lo = inf, hi = -inf            aabb_is_empty(b)    lo > hi on an axis
 *   aabb_grow_point(b, p)  smallest that holds b and p    aabb_area(b)        surface; empty: 0
 *   aabb_union(a, b)       smallest that holds both       aabb_contains(b, p) faces belong to it
 *   aabb_overlap(a, b)     what they share, or empty      aabb_centre(b)
 *   A NaN coordinate of p does not grow the box. The type, and what is not below, are in first.h.
 *
 * Never a false negative, whatever the rounding: a ray that meets the box in exact arithmetic is
 * reported, with *t_enter <= the exact one (tmin, if the ray starts inside). So a search that skips
 * boxes with *t_enter > tmax loses nothing. A ray that passes the box by some 1e-15 of its distance
 * (1e-6 in float) may be reported too: that costs time, no more. A miss leaves *t_enter untouched.
 * Coordinates and t may be anything up to half the largest real; lo, hi and tmax also infinite (a
 * box without end that the ray runs beside counts as met at t = infinity, if tmax is). Flat boxes
 * are boxes. aabb_empty() is never hit. A NaN in a box, in o or in d: that axis says nothing (so:
 * rather a hit); a NaN in tmin or tmax: no t is in the interval, no hit.
 *
 * Sources: T. Kay, J. Kajiya, "Ray tracing complex scenes", SIGGRAPH 1986, section 2; T. Ize,
 * "Robust BVH ray traversal", JCGT 2(2), 2013; T. Barnes, "Fast, branchless ray/bounding box
 * intersections, part 3: boundaries", 2022.
 */
#ifndef AABB_H
#define AABB_H

#include "../01_ray/ray.h"
#include "first.h"

typedef struct {
    vec3 inverse;             /* 1 / d_k; +-infinity for d_k = +-0; NaN: this axis says nothing */
    int near_x, near_y, near_z;  /* number of the plane that is entered first, of the six reals of
                                    an aabb: 0, 1, 2, or 3, 4, 5 where the inverse is negative */
} aabb_inverse;

_Static_assert(sizeof(aabb) == 6 * sizeof(real), "aabb_hit_inverse reads six reals in a row");

/* ---------------------------------------------------------------------------------------------- */

static inline aabb aabb_overlap(aabb a, aabb b)
{
    aabb c = {vmax(a.lo, b.lo), vmin(a.hi, b.hi)};
    return aabb_is_empty(c) ? aabb_empty() : c;
}

/* Largest coordinate, in amount, of a point in the box. */
static inline real aabb_reach(aabb b) { return vlargest(vmax(vabs(b.hi), vabs(b.lo))); }

static inline vec3 aabb_centre(aabb b) { return vmadd(vscale(b.lo, 0.5), b.hi, 0.5); }

static inline bool aabb_contains(aabb b, vec3 p)
{
    return p.x >= b.lo.x && p.x <= b.hi.x && p.y >= b.lo.y && p.y <= b.hi.y && p.z >= b.lo.z
           && p.z <= b.hi.z;
}

/* 1/d; NaN where 1/d overflows although d is not 0, and where d is infinite. */
static inline real inverse_component(real d)
{
    real i = 1 / d;
    return d == 0 || (isfinite(i) && i != 0) ? i : (real)NAN;
}

/* The sign of the inverse tells near from far: -0.0 < 0 is false, 1/-0.0 < 0 is true. */
static inline aabb_inverse aabb_inverse_of(ray r)
{
    vec3 i = {inverse_component(r.d.x), inverse_component(r.d.y), inverse_component(r.d.z)};
    return (aabb_inverse){i, i.x < 0 ? 3 : 0, i.y < 0 ? 4 : 1, i.z < 0 ? 5 : 2};
}

/* A ray in a plane of the box and parallel to it gives 0 * inf = NaN; real_max(NaN, t0) is t0 and
 * real_min(NaN, t1) is t1: this axis allows every t, which is right.
 *
 * u = epsilon/2. The t of a plane is off by 3 u, relatively: difference, inverse, product; by 6 u
 * if the inverse is below the smallest normal real and so has lost two bits. Entry against exit:
 * twice that, and one more for the product that pads: 13 u < pad = 16 u (9.4). Of the two products
 * the smaller one is the earlier t, on either side of 0. Where a product underflows it is off by
 * less than real_smallest. (Ize widens the exit by 2 ulp = 4 u: that finds every box whose 1/d is
 * normal, but leaves *t_enter where rounding put it.)
 */
static inline bool aabb_hit_inverse(const aabb *b, const aabb_inverse *i, ray r, real *t_enter)
{
    const real *face = &b->lo.x, pad = 8 * real_epsilon;
    real t0 = r.tmin, t1 = r.tmax;
    t0 = real_max((face[i->near_x] - r.o.x) * i->inverse.x, t0);
    t0 = real_max((face[i->near_y] - r.o.y) * i->inverse.y, t0);
    t0 = real_max((face[i->near_z] - r.o.z) * i->inverse.z, t0);
    t1 = real_min((face[3 - i->near_x] - r.o.x) * i->inverse.x, t1);
    t1 = real_min((face[5 - i->near_y] - r.o.y) * i->inverse.y, t1);
    t1 = real_min((face[7 - i->near_z] - r.o.z) * i->inverse.z, t1);
    t0 = real_min(t0 * (1 - pad), t0 * (1 + pad)) - real_smallest;
    if (!(t0 <= t1)) return false;
    *t_enter = t0;
    return true;
}

static inline bool aabb_hit(aabb b, ray r, real *t_enter)
{
    aabb_inverse i = aabb_inverse_of(r);
    return aabb_hit_inverse(&b, &i, r, t_enter);
}

#endif
