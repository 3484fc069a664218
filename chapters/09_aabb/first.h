/* first.h: the axis-aligned box (轴对齐包围盒) and the slab test, as the notes have it.
 * Wrong: (9.3) loses flat boxes, whose t_enter = t_exit; in a face, where 0/0 is no number, every
 * third ray along an axis; all with d = -0.0. aabb.h loses none; 10 to 14 add a hair to boxes. */
#ifndef FIRST_AABB_H
#define FIRST_AABB_H
#include "../04_triangle/first.h"

typedef struct { vec3 lo, hi; } aabb;  /* lo <= hi; empty: lo = infinity, hi = -infinity */

static inline aabb aabb_empty(void)
{
    real inf = real_infinity;
    return (aabb){{inf, inf, inf}, {-inf, -inf, -inf}};
}

/* The smallest box that holds b and p, or a and b. */
static inline aabb aabb_grow_point(aabb b, vec3 p) { return (aabb){vmin(p, b.lo), vmax(p, b.hi)}; }
static inline aabb aabb_union(aabb a, aabb b) { return (aabb){vmin(b.lo, a.lo), vmax(b.hi, a.hi)}; }

static inline bool aabb_is_empty(aabb b)
{
    return b.lo.x > b.hi.x || b.lo.y > b.hi.y || b.lo.z > b.hi.z;
}

static inline real aabb_area(aabb b)
{
    vec3 e = vsub(b.hi, b.lo);
    return aabb_is_empty(b) ? 0 : 2 * (e.x * e.y + e.y * e.z + e.z * e.x);
}

static inline aabb first_triangle_box(triangle t)
{
    return (aabb){vmin(t.a, vmin(t.b, t.c)), vmax(t.a, vmax(t.b, t.c))};
}

/* The same box, larger by `hair` on all sides. */
static inline aabb first_aabb_pad(aabb b, real hair)
{
    return (aabb){vsub(b.lo, (vec3){hair, hair, hair}), vadd(b.hi, (vec3){hair, hair, hair})};
}

/* The box of n triangles; *hair is 1e-5 of their farthest coordinate: much more than rounding does
 * to a hit point near them, and so little that it costs nothing. */
static inline aabb first_triangles_box(const triangle *tri, int n, real *hair)
{
    aabb b = aabb_empty();
    for (int i = 0; i < n; i++) b = aabb_union(b, first_triangle_box(tri[i]));
    vec3 far = n ? vmax(vmax(b.hi, vneg(b.hi)), vmax(b.lo, vneg(b.lo))) : vec(0, 0, 0);
    *hair = 1e-5 * real_max(far.x, real_max(far.y, far.z));
    return first_aabb_pad(b, *hair);
}

static inline bool first_aabb_overlap(aabb a, aabb b)
{
    return a.lo.x <= b.hi.x && b.lo.x <= a.hi.x && a.lo.y <= b.hi.y && b.lo.y <= a.hi.y
        && a.lo.z <= b.hi.z && b.lo.z <= a.hi.z;
}

/* A slab (对面) is what lies between two facing planes. The ray is in the slab of axis k from
 * (lo_k - o_k) / d_k to (hi_k - o_k) / d_k; if it goes down the axis, the other way round. (9.1) */
static inline void first_slab(real lo, real hi, real o, real d, real *t_min, real *t_max)
{
    real a = (lo - o) / d, b = (hi - o) / d;
    *t_min = d < 0 ? b : a;
    *t_max = d < 0 ? a : b;
}

/* In the box it is while it is in all three slabs.                                        (9.2) */
static inline void first_slabs(aabb b, ray r, real *t_enter, real *t_exit)
{
    vec3 t_min, t_max;
    first_slab(b.lo.x, b.hi.x, r.o.x, r.d.x, &t_min.x, &t_max.x);
    first_slab(b.lo.y, b.hi.y, r.o.y, r.d.y, &t_min.y, &t_max.y);
    first_slab(b.lo.z, b.hi.z, r.o.z, r.d.z, &t_min.z, &t_max.z);
    *t_enter = real_max(real_max(t_min.x, t_min.y), t_min.z);
    *t_exit = real_min(real_min(t_max.x, t_max.y), t_max.z);
}

/* The notes: hit if t_enter < t_exit and t_exit > 0. Whether the box lies in the ray's interval is
 * left to the caller; t_enter is negative where the ray begins inside.                   (9.3) */
static inline bool first_aabb_hit(aabb b, ray r, real *t_enter)
{
    real t0, t1;
    first_slabs(b, r, &t0, &t1);
    if (!(t0 < t1 && t1 > 0)) return false;
    *t_enter = t0;
    return true;
}
#endif
