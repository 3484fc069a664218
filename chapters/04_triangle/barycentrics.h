/* barycentrics.h: where a point lies in a triangle, as three weights (重心坐标).
 *
 *             c            p = w a + u b + v c,  w + u + v = 1                            (4.6)
 *            /|\
 *           / | \          Each weight is the signed area opposite its corner, over the whole:
 *          / u|  \             u = area(c, a, p) / area(a, b, c)                          (4.11)
 *         / _-p-_ \        measured along the normal n of the triangle, so that the sign tells on
 *        a---------b       which side of the edge p lies (v belongs to a b, w to b c, u to c a).
 *
 *   barycentrics k = barycentrics_of(tri, p);   three areas; p off the plane: of its foot
 *   if (barycentrics_inside(k)) ...             no weight is negative
 *   vec3 p = triangle_at(tri, u, v);            the point: on the triangle within some epsilon,
 *                                               however far away the origin of the ray was
 *   vec3 n = barycentric_mix(na, nb, nc, u, v); any value given at the corners: a colour, a normal;
 *                                               in first.h
 *
 * That the weights sum to one is no test of anything: it is so for every point of the plane, by the
 * way they are computed. The signs are the test.
 *
 * A triangle without area has no such weights: NaN, and barycentrics_inside says no.
 *
 * Source: S. Marschner, P. Shirley, "Fundamentals of Computer Graphics", 4th ed., 2015, 2.7.
 */
#ifndef TRIANGLE_BARYCENTRICS_H
#define TRIANGLE_BARYCENTRICS_H

#include "triangle.h"

typedef struct { real w, u, v; } barycentrics;  /* of a, b, c */

/* ---------------------------------------------------------------------------------------------- */

static inline barycentrics barycentrics_of(triangle tri, vec3 p)
{
    vec3 n = vcross(vsub(tri.b, tri.a), vsub(tri.c, tri.a));
    real whole = vdot(n, n);
    return (barycentrics){vdot(n, vcross(vsub(tri.c, tri.b), vsub(p, tri.b))) / whole,
                          vdot(n, vcross(vsub(tri.a, tri.c), vsub(p, tri.c))) / whole,
                          vdot(n, vcross(vsub(tri.b, tri.a), vsub(p, tri.a))) / whole};
}

static inline bool barycentrics_inside(barycentrics k)  /* a NaN is not inside */
{
    return k.w >= 0 && k.u >= 0 && k.v >= 0;
}

/* The sum of the three weights: 1 for every point. Here to be looked at, not to be tested. */
static inline real barycentrics_sum(barycentrics k) { return k.w + k.u + k.v; }

/* a + u (b - a) + v (c - a) would miss b at u = 1 by a rounding; this form meets all corners. */
static inline vec3 triangle_at(triangle tri, real u, real v)
{
    return barycentric_mix(tri.a, tri.b, tri.c, u, v);
}

#endif
