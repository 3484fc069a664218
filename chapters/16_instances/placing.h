/* placing.h: the transform of one instance: its inverse, rays, boxes, and what rounding may move.
 *
 *        object space                          world
 *          mesh, box'     --- M p + m -->       instance, box           (M, m): `to_world`
 *          O' + t D'     <--- A p + a ---       O + t D                 (A, a): `to_object`
 *
 *   O' = A O + a,  D' = A D,  the same t                                                (16.1)
 *
 *   bool instance_inverse(to_world, &to_object)   false: never hit, see below
 *   bool instance_ray(&to_object, r, &inside)     (16.1); false: D' is too short to have digits
 *   placing p = placing_of(to_world, to_object, reach')     what rounding may move     (16.3)
 *   real placing_pad(&p, o)                       how far, for a ray from o
 *   box = box_of_corners(to_world, &box')         the box of the turned box: loose      (16.2)
 *   box = box_of_points(to_world, v, n)           the box of the points themselves: tight
 *   box = box_padded(&box, pad)                   grown, rounded outwards
 *
 * What a hit of an instance is, (16.1) says in the computer's own arithmetic: a hit of the mesh by
 * the ray O', D' as rounded. Such a hit at t need not lie on the instance in the world: O + t D may
 * miss it by a little. How little (|.| is the largest component, or row sum; R = |O|; V = reach',
 * the largest coordinate of box'; K = |M| |A|; k = the same product, component by component):
 *
 *   O' + t D' is off the mesh by             256 eps (|A| R + |a| + V)     node.h of 14, point 2
 *   A (O + t D) + a is off O' + t D' by      2 eps (|A| (2 R + |P|) + |a|)  four roundings
 *   P = M (A P + a) + m - E P - f            E = M A - 1, f = M a + m: what the inverse is off by
 *   the box is off M box' + m by             2 eps (|M| V + |m|)           four roundings
 *
 *   pad = 4/3 (eps (256 K + 4 k) R + 260 eps (|M| (|a| + V) + |m|) + |f| + g (|M| V + |m|))
 *   g   = |E| + 2 eps k                                                                 (16.3)
 *
 * The 4/3 takes in that |P| itself is known up to this pad, if g <= 1/4. E and f are not estimated
 * but computed, in twice the precision. What grows with R, the ray's distance from the origin of
 * the world, is paid by the ray; the rest by the box.
 *
 *   input                                       answer
 *   M singular (det 0), or NaN, infinite        never hit, like what has no area
 *   so flat that g > 1/4: the inverse has no    never hit
 *     digit that is right
 *   mirrored (det < 0)                          as any other; normals: normals.h
 *   D' shorter than real_smallest / eps         not hit by this ray
 *
 * Sources: J. Arvo, "Transforming axis-aligned bounding boxes", Graphics Gems, 1990 (16.2);
 * G. Schulz, "Iterative Berechnung der reziproken Matrix", ZAMM 13, 1933 (Newton's step);
 * N. Higham, "Accuracy and Stability of Numerical Algorithms", 2002, ch. 3, 14 (inverses).
 */
#ifndef INSTANCES_PLACING_H
#define INSTANCES_PLACING_H

#include "../../common/numbers/wide.h"
#include "../01_ray/affine.h"
#include "../07_mesh/mesh.h"
#include "../09_aabb/aabb.h"
#include "../14_bvh/node.h"

typedef struct { affine to_world; uint32_t mesh; } instance;

/* What there is to be seen: meshes, and where they stand. All of it belongs to the caller. */
typedef struct { const mesh *mesh; size_t meshes; const instance *list; size_t n; } crowd;

typedef struct { real by_origin, fixed; } placing;  /* pad = by_origin * |O| + fixed */

/* ---------------------------------------------------------------------------------------------- */

static inline affine affine_abs(affine m)
{
    return (affine){vabs(m.x), vabs(m.y), vabs(m.z), vabs(m.o)};
}

/* Largest row sum of |M|: times the largest component of v, no component of M v exceeds it.
 * Infinite if one is a NaN. */
static inline real affine_norm(affine m)
{
    vec3 sum = vadd(vadd(vabs(m.x), vabs(m.y)), vabs(m.z));
    return vfinite(sum) ? vlargest(sum) : real_infinity;
}

/* M v + m in twice the precision, less `minus`; for columns of M A - 1 put m = 0. */
static inline vec3 affine_residual(affine m, vec3 v, vec3 minus)
{
    wide3 r = {wide_of((double)-minus.x), wide_of((double)-minus.y), wide_of((double)-minus.z)};
    r = wide3_madd(r, wide3_of(m.x), wide_of((double)v.x));
    r = wide3_madd(r, wide3_of(m.y), wide_of((double)v.y));
    r = wide3_madd(r, wide3_of(m.z), wide_of((double)v.z));
    return vec(wide_value(r.x), wide_value(r.y), wide_value(r.z));
}

/* M A - 1 and M a + m. */
static inline affine inverse_residual(affine m, affine a)
{
    return (affine){affine_residual(m, a.x, (vec3){1, 0, 0}),
                    affine_residual(m, a.y, (vec3){0, 1, 0}),
                    affine_residual(m, a.z, (vec3){0, 0, 1}),
                    affine_residual(m, a.o, vneg(m.o))};
}

/* k of (16.3): by how much rounding of 1 in the inverse can grow on the way back. */
static inline real affine_growth(affine m, affine a)
{
    return affine_norm(affine_then(affine_abs(a), affine_abs(m)));
}

/* g of (16.3). */
static inline real inverse_doubt(affine m, affine a)
{
    return affine_norm(inverse_residual(m, a)) + 2 * real_epsilon * affine_growth(m, a);
}

/* A - A (M A - 1), a - A (M a + m): Newton's step, which squares the error. Of a wire, 1 long and s
 * thick, turned, Cramer's rule leaves eps / s^2, as its columns are all but parallel; this leaves
 * some eps / s (16.6). An exact inverse stays as it is. */
static inline affine inverse_refined(affine m, affine a)
{
    affine e = inverse_residual(m, a);
    return (affine){vsub(a.x, affine_vector(a, e.x)), vsub(a.y, affine_vector(a, e.y)),
                    vsub(a.z, affine_vector(a, e.z)), vsub(a.o, affine_vector(a, e.o))};
}

/* Refined twice: what two steps do not mend is not to be trusted. */
static inline bool instance_inverse(affine to_world, affine *to_object)
{
    affine a;
    if (!affine_inverse(to_world, &a)) return false;
    a = inverse_refined(to_world, inverse_refined(to_world, a));
    if (!(inverse_doubt(to_world, a) <= (real)0.25)) return false;
    *to_object = a;
    return true;
}

/* Not normalised: t must stay the t of the world. */
fast_inline bool instance_ray(const affine *to_object, ray r, ray *inside)
{
    *inside = affine_ray(*to_object, r);
    return vlargest(inside->d) >= real_smallest / real_epsilon;
}

static inline placing placing_of(affine m, affine a, real reach)
{
    affine off = inverse_residual(m, a);
    real M = affine_norm(m), K = M * affine_norm(a), k = affine_growth(m, a);
    real far = M * reach + vlargest(m.o), third = (real)4 / 3, eps = real_epsilon;
    real fixed = 260 * eps * (M * vlargest(a.o) + far) + vlargest(off.o)
        + (affine_norm(off) + 2 * eps * k) * far + 16 * real_smallest * M;  /* what underflows */
    return (placing){third * eps * (256 * K + 4 * k), third * fixed};
}

static inline real placing_pad(const placing *p, vec3 o)
{
    return p->by_origin * vlargest(o) + p->fixed;
}

/* One axis of the turned box: of each of its three edges, the end that lies lower and higher. */
static inline void corner_range(vec3 row, real at, const aabb *b, real *lo, real *hi)
{
    *lo = *hi = at;
    for (int j = 0; j < 3; j++) {
        real x = vaxis(row, j) * vaxis(b->lo, j), y = vaxis(row, j) * vaxis(b->hi, j);
        *lo += real_min(x, y), *hi += real_max(x, y);
    }
}

/* (16.2): lo_i = m_i + sum_j min(M_ij lo'_j, M_ij hi'_j): the box of the eight corners, without
 * going through them. */
static inline aabb box_of_corners(affine m, const aabb *b)
{
    aabb w;
    corner_range((vec3){m.x.x, m.y.x, m.z.x}, m.o.x, b, &w.lo.x, &w.hi.x);
    corner_range((vec3){m.x.y, m.y.y, m.z.y}, m.o.y, b, &w.lo.y, &w.hi.y);
    corner_range((vec3){m.x.z, m.y.z, m.z.z}, m.o.z, b, &w.lo.z, &w.hi.z);
    return w;
}

__attribute__((noinline, hot, unused))  /* called once, it would be made small: ten times as slow */
static aabb box_of_points(affine m, const vec3 *v, size_t n)
{
    aabb w = aabb_empty();
    for (size_t i = 0; i < n; i++) w = aabb_grow_point(w, affine_point(m, v[i]));
    return w;
}

/* What overflowed is everywhere: each ray looks into it. */
static inline bvh_box box_padded(const aabb *w, real pad)
{
    aabb b = first_aabb_pad(*w, pad);
    if (vfinite(b.lo) && vfinite(b.hi)) return box_between(b.lo, b.hi);
    return (bvh_box){.all = EIGHT_ALL(-INFINITY)};
}

/* The same without all this care: the nearest floats, and nothing paid. An instance at 1e6, where
 * floats are 1/16 apart, loses what sticks out of them. */
static inline bvh_box box_padded_naive(const aabb *w)
{
    return (bvh_box){.low = {(float)w->lo.x, (float)w->lo.y, (float)w->lo.z},
                     .minus_high = {-(float)w->hi.x, -(float)w->hi.y, -(float)w->hi.z}};
}

#endif
