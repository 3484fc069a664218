/* first.h: where a ray meets a plane (平面), and a triangle, by Möller and Trumbore's equations.
 * Wrong at seams: of the rays aimed at edges and corners of a closed mesh 10 to 12 % slip through,
 * since both neighbours round for themselves. triangle.h lets none slip. */
#ifndef FIRST_TRIANGLE_H
#define FIRST_TRIANGLE_H
#include "../01_ray/first.h"

typedef struct { vec3 p, n; } plane;        /* a point p', and a normal of any length but 0 */
typedef struct { vec3 a, b, c; } triangle;  /* three corners, counter-clockwise seen from outside */

static inline bool first_plane_hit(plane s, ray r, hit *out)
{
    /* (p - p') . n = 0, with p = o + t d, gives t = (p' - o) . n / (d . n)          (4.1), (4.4) */
    real across = vdot(r.d, s.n);
    if (across == 0) return false;  /* the ray runs along the plane */
    real t = vdot(vsub(s.p, r.o), s.n) / across;
    if (!ray_covers(r, t)) return false;
    *out = (hit){t, 0, 0, 0};
    return true;
}

/* Any value given at the corners, w a + u b + v c with w = 1 - u - v: u and v are barycentric
 * coordinates (重心坐标). If the values are the corners, the result is the point.         (4.6) */
static inline vec3 barycentric_mix(vec3 a, vec3 b, vec3 c, real u, real v)
{
    return vadd(vadd(vscale(a, 1 - u - v), vscale(b, u)), vscale(c, v));
}

static inline bool first_triangle_hit(triangle tri, ray r, hit *out)
{
    /* o + t d = (1 - u - v) a + u b + v c is three equations for t, u, v:
     *     t (-d) + u e1 + v e2 = s,   e1 = b - a,  e2 = c - a,  s = o - a                 (4.8) */
    vec3 e1 = vsub(tri.b, tri.a), e2 = vsub(tri.c, tri.a), s = vsub(r.o, tri.a);

    /* Cramer's rule (克拉默法则), its determinants written as triple products:
     *     t = s2.e2 / det,  u = s1.s / det,  v = s2.d / det,   s1 = d x e2,  s2 = s x e1 */
    vec3 s1 = vcross(r.d, e2), s2 = vcross(s, e1);
    real det = vdot(s1, e1), inverse = 1 / det;
    real t = vdot(s2, e2) * inverse;
    real u = vdot(s1, s) * inverse;
    real v = vdot(s2, r.d) * inverse;

    /* Inside, if none of the three weights is negative. det = 0, the ray runs along the triangle's
     * plane: t, u, v are infinite or NaN, and each comparison with a NaN is false. */
    if (!(u >= 0 && v >= 0 && u + v <= 1)) return false;
    if (!ray_covers(r, t) || !isfinite(t)) return false;
    *out = (hit){t, u, v, 0};
    return true;
}

static inline vec3 first_triangle_normal(triangle tri)
{
    return vunit(vcross(vsub(tri.b, tri.a), vsub(tri.c, tri.a)));
}
#endif
