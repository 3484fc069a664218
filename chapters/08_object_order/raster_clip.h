/* raster_clip.h: clipping (裁剪): the part of a triangle that lies in front of some planes.
 *
 *            a                     corner behind the plane: the two edges that cross it are cut,
 *           / \                    and a triangle may become a quadrilateral. Each plane adds one
 *     -----x---y----- plane        corner at most.
 *         /     \     | n
 *        b ----- c    v
 *
 *   raster_corner p[raster_most_corners];  three corners, in the world
 *   int n = raster_clip(p, 3, plane);      the part where (p - p') . n >= 0; n = 0: nothing is left
 *
 * u and v, the barycentrics of b and c, are 0 or 1 at the corners and linear along edges: a new
 * corner gets its share. The neighbour across an edge meets the same two ends and computes the same
 * new corner to the last bit, since the cut always starts at the end in front: no cracks. (Chapter
 * 13's clip starts at the nearer end, for the smaller error.)
 *
 * Source: I. Sutherland, G. Hodgman, "Reentrant Polygon Clipping", CACM 17(1), 1974.
 */
#ifndef RASTER_CLIP_H
#define RASTER_CLIP_H

#include "../04_triangle/plane.h"

enum { raster_most_planes = 6, raster_most_corners = 3 + raster_most_planes };
typedef struct { vec3 p; real u, v; } raster_corner;

/* ---------------------------------------------------------------------------------------------- */

/* The point of edge `in` `out` where the height above the plane is 0: heights h > 0 > g.  (8.7) */
static inline raster_corner raster_cut(raster_corner in, raster_corner out, real h, real g)
{
    real s = h / (h - g);
    return (raster_corner){vmadd(in.p, vsub(out.p, in.p), s), in.u + s * (out.u - in.u),
                           in.v + s * (out.v - in.v)};
}

/* A height that is NaN counts as behind. */
static inline int raster_clip(raster_corner *p, int n, plane s)
{
    raster_corner kept[raster_most_corners];
    real h[raster_most_corners];
    int m = 0, front = 0;
    for (int i = 0; i < n; i++) h[i] = vdot(vsub(p[i].p, s.p), s.n), front += h[i] >= 0;
    if (front == n || front == 0) return front;
    for (int i = 0; i < n; i++) {
        int j = i + 1 < n ? i + 1 : 0;
        if (h[i] >= 0) kept[m++] = p[i];
        if (h[i] > 0 && h[j] < 0) kept[m++] = raster_cut(p[i], p[j], h[i], h[j]);
        if (h[i] < 0 && h[j] > 0) kept[m++] = raster_cut(p[j], p[i], h[j], h[i]);
    }
    for (int i = 0; i < m; i++) p[i] = kept[i];
    return m;
}

#endif
