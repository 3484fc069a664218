/* side.h: on which side of a plane a point, and a convex polygon, lies: what a BSP tree is made of.
 *
 *        front, s > 0            s(q) = n . q - at,  |n| = 1: the distance from the plane   (13.1)
 *     ----------------- s = 0
 *        back,  s < 0
 *
 *   split_plane p = plane_of_triangle(a, b, c)     the plane of a, b, c; n = 0 if they have no area
 *   split_plane p = plane_of_edge(a, b, n)         holds the edge a b and the direction n
 *   split_plane p = plane_of_axis(k, at)           q_k = at
 *   real s = side_of(p, q)
 *   side_range(p, q, n, &lo, &hi)                  smallest and largest s of n corners
 *   plane_side s = side_of_range(lo, hi, e)              SIDE_ON if all |s| <= e, else SIDE_BACK,
 *                                                  SIDE_FRONT, or SIDE_BOTH: the plane cuts it
 *   real k = power_above(x)                        a power of two > x, and 1 / k is finite
 *   m = clip(p, sign, level, q, n, out)            the part with sign * s <= level; out has room
 *                                                  for 2 n corners; m = 0: nothing is left
 *
 * The plane of a triangle does not hold its corners: n, at and s are rounded. So a sign alone tells
 * nothing about a corner near the plane, and the plane gets a width e instead: what sticks out by
 * no more than e does not count. How wide? Corners are |q_k| <= size, eps is from 1 to the next
 * real, a rounding is off by eps / 2:
 *
 *   1. s itself: three products and two sums, each of sum |n_k q_k| <= sqrt 3 size at most, and a
 *      difference of twice that: 4.4 eps size. q was rounded from the corner of the item: moved by
 *      0.9 eps size. Together less than 6 eps size.                                         (13.7)
 *   2. A corner made by clip is on the edge a b up to the rounding of a + w (b - a), w <= 1/2: each
 *      coordinate within 1.5 eps size, so 2.6 eps size in space. Where along the edge, w tells only
 *      as well as s: within 6 eps size of the level, measured from the plane. After 64 clips a
 *      fragment has moved by r <= 167 eps size.
 *   3. So the part of an item behind a plane is held by what clip leaves at level e, if
 *      e >= r + 6 eps size: 192 eps size is taken.                                          (13.8)
 *
 * The search pays for it: see bsp.h. Sources: H. Fuchs, Z. Kedem, B. Naylor, "On Visible Surface
 * Generation by A Priori Tree Structures", SIGGRAPH 1980; I. Sutherland, G. Hodgman, "Reentrant
 * Polygon Clipping", CACM 17(1), 1974 (clip); C.-P. Jeannerod et al. 2013 (see vec3.h).
 */
#ifndef BSP_SIDE_H
#define BSP_SIDE_H

#include "../04_triangle/triangle.h"
#include <stddef.h>

typedef struct { vec3 n; real at; int axis; } split_plane;  /* axis: n = e_axis [0..2]; else 3 */
typedef enum { SIDE_ON = 0, SIDE_BACK = 1, SIDE_FRONT = 2, SIDE_BOTH = 3 } plane_side;

#define side_width (192 * real_epsilon)  /* times size (13.8) */

/* ---------------------------------------------------------------------------------------------- */

/* To scale by without rounding. At least 2^-1000 (2^-100 in float), so that 1 / k is finite. */
static inline real power_above(real x)
{
    int e = 0, least = real_is_float ? -100 : -1000;
    (void)frexp(x, &e);
    return ldexp((real)1, e > least ? e : least);
}

static inline split_plane plane_of_axis(int axis, real at)
{
    return (split_plane){{axis == 0, axis == 1, axis == 2}, at, axis};
}

/* Corners within 6 eps size, whatever the shape: an edge that is off by eps / 2 of its length turns
 * n, but about the other edge, and by no more than moves a corner so far. */
static inline split_plane plane_of_triangle(vec3 a, vec3 b, vec3 c)
{
    vec3 n = vunit(vcross_accurate(vsub(b, a), vsub(c, a)));
    return (split_plane){n, vdot(n, a), 3};
}

static inline split_plane plane_of_edge(vec3 a, vec3 b, vec3 along)
{
    vec3 n = vunit(vcross_accurate(along, vsub(b, a)));
    return (split_plane){n, vdot(n, a), 3};
}

static inline real side_of(const split_plane *p, vec3 q)
{
    return p->axis < 3 ? vaxis(q, p->axis) - p->at : vdot(p->n, q) - p->at;
}

static inline void side_range(const split_plane *p, const vec3 *q, size_t n, real *lo, real *hi)
{
    real a = real_infinity, b = -real_infinity;
    for (size_t i = 0; i < n; i++) {
        real s = side_of(p, q[i]);
        a = real_min(s, a), b = real_max(s, b);
    }
    *lo = a, *hi = b;
}

static inline plane_side side_of_range(real lo, real hi, real e)
{
    return (plane_side)((lo < -e ? SIDE_BACK : 0) | (hi > e ? SIDE_FRONT : 0));
}

/* The point of a b with s = level; it starts from the end that is nearer to the level. */
static inline vec3 clip_point(vec3 a, vec3 b, real sa, real sb)
{
    real w = sa / (sa - sb);
    return w <= (real)0.5 ? vmadd(a, vsub(b, a), w) : vmadd(b, vsub(a, b), sb / (sb - sa));
}

/* Sutherland & Hodgman. Not raster_clip (08), whose cut starts at the end in front: proof 2 above
 * needs w <= 1/2. */
static inline size_t clip(const split_plane *p, real sign, real level, const vec3 *q, size_t n,
                          vec3 *out)
{
    size_t m = 0;
    if (n == 0) return 0;
    vec3 a = q[n - 1];
    real sa = sign * side_of(p, a) - level;
    for (size_t i = 0; i < n; i++) {
        vec3 b = q[i];
        real sb = sign * side_of(p, b) - level;
        if ((sa < 0 && sb > 0) || (sa > 0 && sb < 0)) out[m++] = clip_point(a, b, sa, sb);
        if (sb <= 0) out[m++] = b;
        a = b, sa = sb;
    }
    return m;
}

#endif
