/* triangle_variants.h: other ways to meet a triangle, to be measured beside triangle.h, whose
 * signature they have.
 *
 *   triangle_hit_moller_trumbore       (4.8) as a good programmer writes it: nothing is divided
 *                                      before the signs are known
 *   triangle_hit_tolerant              the same with the edges moved out by 1e-5: no slips, but a
 *                                      ray at an edge hits both neighbours, at a vertex all of them
 *   triangle_hit_planes                three planes computed beforehand (4.13): few operations, but
 *                                      96 bytes a triangle, and absolute coordinates
 *   triangle_hit_triple                signs of the triple products d . (b x a) (4.12): the volumes
 *                                      by which Pluecker coordinates tell left from right
 *
 * tests/04_triangle.c and tests/04_watertight.c keep each of them failing.
 *
 * Sources: J. Havel, A. Herout, "Yet Faster Ray-Triangle Intersection (Using SSE4)", IEEE TVCG
 * 16(3), 2010; J. Amanatides, K. Choi, "Ray Tracing Triangular Meshes", Western Computer Graphics
 * Symposium, 1997.
 */
#ifndef TRIANGLE_VARIANTS_H
#define TRIANGLE_VARIANTS_H

#include "../triangle.h"

/* ---------------------------------------------------------------------------------------------- */

/* Inside, if t is in the interval; of det = 0 it is infinite or NaN. */
fast_inline bool triangle_met(ray r, real t, real u, real v, hit *out)
{
    if (!ray_covers(r, t) || !isfinite(t)) return false;
    *out = (hit){t, u, v, 0};
    return true;
}

/* u and v are compared as numerators, with |det| instead of 1, in one branch. margin: of the
 * weights. */
fast_inline bool triangle_hit_patched(triangle tri, ray r, real margin, hit *out)
{
    vec3 e1 = vsub(tri.b, tri.a), e2 = vsub(tri.c, tri.a), s = vsub(r.o, tri.a);
    vec3 s1 = vcross(r.d, e2), s2 = vcross(s, e1);
    real det = vdot(s1, e1), size = fabs(det), sign = copysign((real)1, det);
    real u = sign * vdot(s1, s), v = sign * vdot(s2, r.d), w = size - u - v;
    if (!(real_min(real_min(u, v), w) >= -margin * size)) return false;
    return triangle_met(r, vdot(s2, e2) / det, u / size, v / size, out);
}

static inline bool triangle_hit_moller_trumbore(triangle tri, ray r, hit *out)
{
    return triangle_hit_patched(tri, r, 0, out);
}

static inline bool triangle_hit_tolerant(triangle tri, ray r, hit *out)
{
    return triangle_hit_patched(tri, r, (real)1e-5, out);  /* a hundred float roundings */
}

/* x . n + d is 0 in the triangle's plane; u and v of x, if it lies there, are x . n + d of the
 * other two: planes through the triangle's edge c a, and through a b. */
typedef struct { plane_equation plane, u, v; } triangle_planes;

static inline triangle_planes triangle_planes_of(triangle tri)
{
    vec3 e1 = vsub(tri.b, tri.a), e2 = vsub(tri.c, tri.a), n = vcross(e1, e2);
    real nn = vdot(n, n);
    return (triangle_planes){plane_equation_of((plane){tri.a, n}),
                             plane_equation_of((plane){tri.a, vscale(vcross(e2, n), 1 / nn)}),
                             plane_equation_of((plane){tri.a, vscale(vcross(n, e1), 1 / nn)})};
}

static inline bool triangle_hit_planes_of(const triangle_planes *k, ray r, hit *out)
{
    vec3 n = {k->plane.a, k->plane.b, k->plane.c};
    real det = vdot(r.d, n), above = -(vdot(r.o, n) + k->plane.d);
    vec3 p = vadd(vscale(r.o, det), vscale(r.d, above));  /* det times the point of the plane */
    real size = fabs(det), sign = copysign((real)1, det);
    real u = sign * (vdot(p, (vec3){k->u.a, k->u.b, k->u.c}) + det * k->u.d);
    real v = sign * (vdot(p, (vec3){k->v.a, k->v.b, k->v.c}) + det * k->v.d);
    if (!(real_min(real_min(u, v), size - u - v) >= 0)) return false;
    return triangle_met(r, above / det, u / size, v / size, out);
}

static inline bool triangle_hit_planes(triangle tri, ray r, hit *out)
{
    triangle_planes k = triangle_planes_of(tri);
    return triangle_hit_planes_of(&k, r, out);
}

/* With a, b, c as seen from o, d . (b x a) is six times the volume of o, d, b, a. The neighbour
 * computes exactly the negative; but a sum of three rounded products may have the wrong sign: all
 * round a vertex may say no. */
static inline bool triangle_hit_triple(triangle tri, ray r, hit *out)
{
    vec3 a = vsub(tri.a, r.o), b = vsub(tri.b, r.o), c = vsub(tri.c, r.o), cb = vcross(c, b);
    real w = vdot(r.d, cb), u = vdot(r.d, vcross(a, c)), v = vdot(r.d, vcross(b, a));
    if (signs_differ(w, u, v)) return false;
    real det = w + u + v;
    return triangle_met(r, vdot(a, cb) / det, u / det, v / det, out);
}

#endif
