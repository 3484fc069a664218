/* patch.h: a polygon cut into triangles (三角剖分), concave ones too.
 *
 *   size_t n = patch_triangles(v, corners, index)     index [3 (corners - 2)]: corners from 0;
 *                                                     corners - 2 triangles, or 0: it cannot
 *
 *        3______2          If corner 0 sees every edge from its left, the fan 0 1 2, 0 2 3, .. is
 *        \     /           right: O(n). Else ears (耳切法) are cut: 0 1 2 is one if it turns left and
 *     4---5   /            holds no other corner; then corner 1 goes. A polygon without holes
 *      \     /             always has two. O(n^3) at the worst, so at most patch_most corners.
 *       0---1
 * "Left" is measured in the plane by Newell's normal (polygon.h). Where rounding leaves no ear, and
 * where edges cross, the triangles cover about what they should: for what must be exact, keep the
 * polygon.
 *
 * Source: G. Meisters, "Polygons have ears", American Mathematical Monthly 82, 1975.
 */
#ifndef EFFECTS_PATCH_H
#define EFFECTS_PATCH_H

#include "../../07_mesh/polygon.h"

enum { patch_most = 256 };

/* ---------------------------------------------------------------------------------------------- */

typedef struct { real x, y; } patch_point;

/* Twice the area of a b c; > 0: turns left. */
static inline real patch_area(patch_point a, patch_point b, patch_point c)
{
    return difference_of_products(b.x - a.x, c.y - a.y, c.x - a.x, b.y - a.y);
}

/* On an edge does not count: a corner that is shared, or that the cut passes. */
static inline bool patch_holds(patch_point a, patch_point b, patch_point c, patch_point p)
{
    return patch_area(a, b, p) > 0 && patch_area(b, c, p) > 0 && patch_area(c, a, p) > 0;
}

/* Without the axis that the normal is longest in; mirrored back if the normal points down it. */
static inline patch_point patch_flat(vec3 v, vec3 n)
{
    int k = vlongest(n), i = k == 2 ? 0 : k + 1, j = i == 2 ? 0 : i + 1;
    return (patch_point){vaxis(v, i), vaxis(n, k) < 0 ? -vaxis(v, j) : vaxis(v, j)};
}

static inline bool patch_fans(const vec3 *v, size_t n, vec3 normal)
{
    patch_point a = patch_flat(v[0], normal);
    for (size_t i = 1; i + 1 < n; i++)
        if (patch_area(a, patch_flat(v[i], normal), patch_flat(v[i + 1], normal)) < 0) return false;
    return true;
}

/* Is corner i of the ring an ear? */
static inline bool patch_ear(const patch_point *p, const uint32_t *ring, size_t n, size_t i,
                             bool strict)
{
    uint32_t a = ring[(i + n - 1) % n], b = ring[i], c = ring[(i + 1) % n];
    if (!(patch_area(p[a], p[b], p[c]) > 0)) return false;
    for (size_t k = 0; strict && k < n; k++)
        if (patch_holds(p[a], p[b], p[c], p[ring[k]])) return false;
    return true;
}

static inline size_t patch_triangles(const vec3 *v, size_t n, uint32_t *index)
{
    vec3 normal = polygon_of(v, n).normal;
    uint32_t ring[patch_most], *out = index;
    patch_point p[patch_most];
    if (n < 3) return 0;
    if (patch_fans(v, n, normal)) {
        for (uint32_t i = 1; i + 1 < n; i++) *out++ = 0, *out++ = i, *out++ = i + 1;
        return n - 2;
    }
    if (n > patch_most) return 0;
    for (uint32_t i = 0; i < n; i++) ring[i] = i, p[i] = patch_flat(v[i], normal);
    for (size_t left = n, i = 0; left > 2; left--) {
        size_t tried = 0;
        for (; tried < 2 * left + 1; tried++, i = (i + 1) % left)  /* second round: less strict */
            if (patch_ear(p, ring, left, i % left, tried < left) || tried == 2 * left) break;
        i %= left;
        *out++ = ring[(i + left - 1) % left], *out++ = ring[i], *out++ = ring[(i + 1) % left];
        memmove(&ring[i], &ring[i + 1], (left - 1 - i) * sizeof *ring);
    }
    return n - 2;
}

#endif
