/* slabs.h: the slab test as it is found in books and programs, with one signature, and what each
 * of them loses. aabb_hit of aabb.h is the one to use.
 *
 *                             input where it misses a box that the ray meets
 *   first_aabb_hit (first.h)  flat box: t_enter = t_exit; contact at t = 0; and the next line. It
 *                             knows no interval but [0, infinity]
 *   aabb_hit_closed           axis-parallel ray in a plane of the box: 0/0; d = -0.0
 *   aabb_hit_fmin             the same ray: fmin forgets the NaN and keeps the +-infinity beside it
 *   aabb_hit_pbrt             the same ray, if d = -0.0
 *   aabb_hit_inclusive        none of these; at corners and flat boxes entry and exit are the
 *                             same t and round apart
 *   aabb_hit                  none
 *
 *   aabb_hit_closed_f32       aabb_hit_closed in float, whatever real is: an exhibit
 *
 * t_enter as in aabb.h, but rounded to nearest: it may lie an ulp or two behind the exact one.
 *
 * Sources: L. Yan, GAMES101, lecture 13, 2020 (first); M. Pharr, G. Humphreys, "Physically Based
 * Rendering", 2nd ed., 2010, section 4.2.1 (pbrt; the 3rd edition pads the exit by 2 gamma(3));
 * T. Barnes, "Fast, branchless ray/bounding box intersections, part 3", 2022 (inclusive).
 */
#ifndef SLABS_H
#define SLABS_H

#include "../aabb.h"

/* ---------------------------------------------------------------------------------------------- */

/* first_aabb_hit with <=, and the ray's interval. o = (-5, .5, 0), d = (1, 0, 0) against [0,1]^3:
 * z gives 0/0 = NaN and 1/0 = infinity; with d.y = -0.0 near and far of y change places. */
static inline bool aabb_hit_closed(aabb b, ray r, real *t_enter)
{
    real t0, t1;
    first_slabs(b, r, &t0, &t1);
    if (!(t0 <= t1 && t1 >= r.tmin && t0 <= r.tmax)) return false;
    *t_enter = real_max(t0, r.tmin);
    return true;
}

/* Sorts by fmin and fmax, which need no sign of d; but fmin(NaN, infinity) is infinity, so the ray
 * above enters the slab never. A call of libm each, unless the compiler knows better. */
static inline bool aabb_hit_fmin(aabb b, ray r, real *t_enter)
{
    vec3 i = {1 / r.d.x, 1 / r.d.y, 1 / r.d.z};
    vec3 p = vmul(vsub(b.lo, r.o), i), q = vmul(vsub(b.hi, r.o), i);
    real t0 = fmax(fmax(fmin(p.x, q.x), fmin(p.y, q.y)), fmax(fmin(p.z, q.z), r.tmin));
    real t1 = fmin(fmin(fmax(p.x, q.x), fmax(p.y, q.y)), fmin(fmax(p.z, q.z), r.tmax));
    if (!(t0 <= t1)) return false;
    *t_enter = t0;
    return true;
}

/* Axis by axis; the planes change places if their t are out of order, which a NaN never is. */
static inline bool slab_narrow_pbrt(real lo, real hi, real o, real d, real *t0, real *t1)
{
    real i = 1 / d, near = (lo - o) * i, far = (hi - o) * i;
    if (near > far) { real swap = near; near = far; far = swap; }
    *t0 = near > *t0 ? near : *t0;
    *t1 = far < *t1 ? far : *t1;
    return !(*t0 > *t1);
}

static inline bool aabb_hit_pbrt(aabb b, ray r, real *t_enter)
{
    real t0 = r.tmin, t1 = r.tmax;
    if (!slab_narrow_pbrt(b.lo.x, b.hi.x, r.o.x, r.d.x, &t0, &t1)) return false;
    if (!slab_narrow_pbrt(b.lo.y, b.hi.y, r.o.y, r.d.y, &t0, &t1)) return false;
    if (!slab_narrow_pbrt(b.lo.z, b.hi.z, r.o.z, r.d.z, &t0, &t1)) return false;
    *t_enter = t0;
    return true;
}

/* Needs neither the sign of d nor of 1/d: each plane is compared with what is known so far, and a
 * NaN, always the first argument, leaves it as it is. An empty box (lo > hi) looks full to it. */
static inline void slab_narrow(real lo, real hi, real o, real d, real *t0, real *t1)
{
    real i = 1 / d, a = (lo - o) * i, b = (hi - o) * i;
    real enter = real_min(real_max(a, *t0), real_max(b, *t0));
    *t1 = real_max(real_min(a, *t1), real_min(b, *t1));
    *t0 = enter;
}

static inline bool aabb_hit_inclusive(aabb b, ray r, real *t_enter)
{
    real t0 = r.tmin, t1 = r.tmax;
    slab_narrow(b.lo.x, b.hi.x, r.o.x, r.d.x, &t0, &t1);
    slab_narrow(b.lo.y, b.hi.y, r.o.y, r.d.y, &t0, &t1);
    slab_narrow(b.lo.z, b.hi.z, r.o.z, r.d.z, &t0, &t1);
    if (!(t0 <= t1)) return false;
    *t_enter = t0;
    return true;
}

/* (9.1) to (9.3) with every operation rounded to float. */
static inline bool aabb_hit_closed_f32(aabb b, ray r, real *t_enter)
{
    float t0 = (float)r.tmin, t1 = (float)r.tmax;
    for (int k = 0; k < 3; k++) {
        float o = (float)vaxis(r.o, k), d = (float)vaxis(r.d, k);
        float p = ((float)vaxis(b.lo, k) - o) / d, q = ((float)vaxis(b.hi, k) - o) / d;
        float near = d < 0 ? q : p, far = d < 0 ? p : q;
        t0 = t0 > near ? t0 : near;
        t1 = t1 < far ? t1 : far;
    }
    if (!(t0 <= t1)) return false;
    *t_enter = (real)t0;
    return true;
}

#endif
