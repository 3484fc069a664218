/* slabs.h: other slab tests, with the signature of aabb_hit, and what each of them loses.
 *
 *                             input where it misses a box that the ray meets
 *   first_aabb_hit (first.h)  flat box: t_enter = t_exit; contact at t = 0; and the next line. It
 *                             knows no interval but [0, infinity]
 *   aabb_hit_kept             as first_aabb_hit, but with products n (1/d) for quotients n/d: equal
 *                             quotients stay equal when rounded, such products need not
 *   aabb_hit_closed           axis-parallel ray in a plane of the box: 0/0; d = -0.0
 *   aabb_hit_ize              none but at t < 0: it widens the exit by 2 ulp = 4 u, u = epsilon/2
 *
 * Their t_enter is rounded to nearest, so it may lie an ulp or two behind the exact one.
 *
 *   X_with(&b, &i, r, &t_enter)    the same with i = aabb_plain_inverse(r), once a ray, of kept and
 *                                  ize; the others divide
 *   aabb_hit_lanes                 aabb8_hit of one box, with this signature
 *
 * Sources: L. Yan, GAMES101, lecture 13, 2020 (first); T. Ize, "Robust BVH ray traversal", JCGT
 * 2(2), 2013 (ize).
 */
#ifndef AABB_SLABS_H
#define AABB_SLABS_H

#include "lanes.h"
#include "mine.h"

typedef bool aabb_test(aabb b, ray r, real *t_enter);

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

/* As it comes, without the care of aabb_inverse_of for tiny and huge d. */
static inline aabb_inverse aabb_plain_inverse(ray r)
{
    vec3 i = {1 / r.d.x, 1 / r.d.y, 1 / r.d.z};
    return (aabb_inverse){i, i.x < 0 ? 3 : 0, i.y < 0 ? 4 : 1, i.z < 0 ? 5 : 2};
}
#define AABB_UNPREPARED(name)                                                                  \
    static inline bool name(aabb b, ray r, real *t_enter)                                      \
    {                                                                                          \
        aabb_inverse i = aabb_plain_inverse(r);                                                \
        return name##_with(&b, &i, r, t_enter);                                                \
    }

/* first_aabb_hit with 1/d kept for all boxes of a ray; still the sign of d tells near from far. */
static inline void slab_kept(real lo, real hi, real o, real d, real i, real *t_min, real *t_max)
{
    real a = (lo - o) * i, b = (hi - o) * i;
    *t_min = d < 0 ? b : a;
    *t_max = d < 0 ? a : b;
}

static inline bool aabb_hit_kept_with(const aabb *b, const aabb_inverse *i, ray r, real *t_enter)
{
    vec3 t_min, t_max;
    slab_kept(b->lo.x, b->hi.x, r.o.x, r.d.x, i->inverse.x, &t_min.x, &t_max.x);
    slab_kept(b->lo.y, b->hi.y, r.o.y, r.d.y, i->inverse.y, &t_min.y, &t_max.y);
    slab_kept(b->lo.z, b->hi.z, r.o.z, r.d.z, i->inverse.z, &t_min.z, &t_max.z);
    real t0 = real_max(real_max(t_min.x, t_min.y), t_min.z);
    real t1 = real_min(real_min(t_max.x, t_max.y), t_max.z);
    if (!(t0 < t1 && t1 > 0)) return false;
    *t_enter = t0;
    return true;
}
AABB_UNPREPARED(aabb_hit_kept)

/* As aabb_hit_inverse, but padded at the other end. */
static inline bool aabb_hit_ize_with(const aabb *b, const aabb_inverse *i, ray r, real *t_enter)
{
    const real *face = &b->lo.x;
    real t0 = r.tmin, t1 = r.tmax;
    t0 = real_max((face[i->near_x] - r.o.x) * i->inverse.x, t0);
    t0 = real_max((face[i->near_y] - r.o.y) * i->inverse.y, t0);
    t0 = real_max((face[i->near_z] - r.o.z) * i->inverse.z, t0);
    t1 = real_min((face[3 - i->near_x] - r.o.x) * i->inverse.x, t1);
    t1 = real_min((face[5 - i->near_y] - r.o.y) * i->inverse.y, t1);
    t1 = real_min((face[7 - i->near_z] - r.o.z) * i->inverse.z, t1);
    if (!(t0 <= t1 * (1 + 2 * real_epsilon))) return false;
    *t_enter = t0;
    return true;
}
AABB_UNPREPARED(aabb_hit_ize)

/* One box of eight; the others are empty. */
static inline bool aabb_hit_lanes(aabb b, ray r, real *t_enter)
{
    aabb8 group;
    aabb_lanes l = aabb_lanes_of(r);
    float t[8];
    lanes_empty(group.side[0], 8), lanes_put(group.side[0], 8, 5, b);
    if (!(aabb8_hit(&group, &l, t) & 32)) return false;
    *t_enter = (real)t[5];
    return true;
}

#endif
