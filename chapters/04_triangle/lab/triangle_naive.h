/* triangle_naive.h: what programs do all the same, to be seen failing. Signatures as in triangle.h.
 *
 *   triangle_hit_plane_f32             (4.7) in float
 *   triangle_hit_moller_trumbore_f32   (4.8) in float
 *   triangle_hit_one_branch            (4.8) as in first.h, the same hits to the last bit, but with
 *                                      one branch for u and v: nobody can predict three
 *   triangle_hit_absolute              (4.8) refusing |det| < 1e-8: loses small triangles, because
 *                                      det = -d . (e1 x e2) is an area, in squares of the unit
 *   triangle_hit_tolerant              (4.8) with the edges moved out by 1e-5: no slips, but a ray
 *                                      at an edge hits both neighbours, at a vertex all of them
 *
 * Of the rays aimed at edges or vertices of a sphere of 5120 triangles round the origin 7 to 12 %
 * slip through, in float and in double: more digits make the cracks narrower, not fewer for who
 * aims at them.
 * tests/04_triangle.c and tests/04_watertight.c keep each of them failing.
 *
 * gcc 12 at -O2 needs -fno-tree-slp-vectorize here: its vectoriser leaves double digits in floats.
 */
#ifndef TRIANGLE_NAIVE_H
#define TRIANGLE_NAIVE_H

#include "../../../common/lab/vec3_f32.h"
#include "../triangle.h"

/* ---------------------------------------------------------------------------------------------- */

static inline bool triangle_hit_plane_f32(triangle tri, ray r, hit *out)
{
    vec3_f32 a = f32_of(tri.a), b = f32_of(tri.b), c = f32_of(tri.c);
    vec3_f32 o = f32_of(r.o), d = f32_of(r.d);
    vec3_f32 n = f32_cross(f32_sub(b, a), f32_sub(c, a));
    float t = f32_dot(f32_sub(a, o), n) / f32_dot(d, n);
    if (!isfinite(t) || !ray_covers(r, (real)t)) return false;
    vec3_f32 p = {o.x + t * d.x, o.y + t * d.y, o.z + t * d.z};
    float wa = f32_dot(n, f32_cross(f32_sub(c, b), f32_sub(p, b)));
    float wb = f32_dot(n, f32_cross(f32_sub(a, c), f32_sub(p, c)));
    float wc = f32_dot(n, f32_cross(f32_sub(b, a), f32_sub(p, a)));
    float least = wa < wb ? wa : wb;
    if (!(least >= 0 && wc >= 0)) return false;
    *out = (hit){(real)t, (real)(wb / f32_dot(n, n)), (real)(wc / f32_dot(n, n)), 0};
    return true;
}

static inline bool triangle_hit_moller_trumbore_f32(triangle tri, ray r, hit *out)
{
    vec3_f32 a = f32_of(tri.a), d = f32_of(r.d), s = f32_sub(f32_of(r.o), a);
    vec3_f32 e1 = f32_sub(f32_of(tri.b), a), e2 = f32_sub(f32_of(tri.c), a);
    vec3_f32 p = f32_cross(d, e2), q = f32_cross(s, e1);
    float det = f32_dot(e1, p), inverse = 1 / det;
    float u = f32_dot(s, p) * inverse, v = f32_dot(d, q) * inverse, t = f32_dot(e2, q) * inverse;
    float least = u < v ? u : v;
    if (!(least >= 0 && u + v <= 1)) return false;
    if (!isfinite(t) || !ray_covers(r, (real)t)) return false;
    *out = (hit){(real)t, (real)u, (real)v, 0};
    return true;
}

static inline bool triangle_hit_one_branch(triangle tri, ray r, hit *out)
{
    vec3 e1 = vsub(tri.b, tri.a), e2 = vsub(tri.c, tri.a), s = vsub(r.o, tri.a);
    vec3 p = vcross(r.d, e2), q = vcross(s, e1);
    real det = vdot(e1, p), inverse = 1 / det;
    real u = vdot(s, p) * inverse, v = vdot(r.d, q) * inverse, t = vdot(e2, q) * inverse;
    if (!(real_min(u, v) >= 0 && u + v <= 1)) return false;  /* det = 0: u + v infinite or NaN */
    if (!ray_covers(r, t) || !isfinite(t)) return false;
    *out = (hit){t, u, v, 0};
    return true;
}

/* (4.8) with what people add to it: a margin round the triangle, a least determinant. */
static inline bool triangle_hit_patched(triangle tri, ray r, real margin, real least, hit *out)
{
    vec3 e1 = vsub(tri.b, tri.a), e2 = vsub(tri.c, tri.a), s = vsub(r.o, tri.a);
    vec3 p = vcross(r.d, e2), q = vcross(s, e1);
    real det = vdot(e1, p), u = vdot(s, p) / det, v = vdot(r.d, q) / det, t = vdot(e2, q) / det;
    if (!(real_min(u, v) >= -margin && u + v <= 1 + margin)) return false;
    if (fabs(det) < least) return false;
    if (!ray_covers(r, t) || !isfinite(t)) return false;
    *out = (hit){t, u, v, 0};
    return true;
}

static inline bool triangle_hit_tolerant(triangle tri, ray r, hit *out)
{
    const real margin = 1e-5;  /* of the barycentrics: a hundred float roundings */
    return triangle_hit_patched(tri, r, margin, 0, out);
}

static inline bool triangle_hit_absolute(triangle tri, ray r, hit *out)
{
    const real least = 1e-8;  /* square scene units: nobody knows how large a scene is */
    return triangle_hit_patched(tri, r, 0, least, out);
}

#endif
