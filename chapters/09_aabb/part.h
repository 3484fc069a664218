/* part.h: the box of what a polygon has between two planes across an axis: clipping (裁剪) where
 * only the bounds of the part are asked for.
 *
 *              |     . c             Its extreme points are the corners in there, and the points
 *          .---x--y '  |             where edges cross the planes. So edges come in any order, and
 *      a '     |   `---z-- b         the polygon may be concave.
 *             lo      hi
 *
 *   part_box p = part_nothing;
 *   part_edge(&p, a, b, axis, lo, hi)    for each edge a b [3]; lo <= hi, maybe infinite. Then
 *                                        p.lo, p.hi are the bounds of the part; nothing: lo > hi
 *   part_crossing(a, b, axis, at, q)     q [3]: the point of a b in the plane; a and b are on
 *                                        different sides of it, or one of them in it
 *
 * In double, whatever real is. A crossing is off its place by at most 5.5 2^-52 of the largest
 * coordinate (14_bvh/bvh_mesh.h counts it): the caller's box is larger than p by that, or by a
 * float. Depends on the order of a and b: where neighbours must meet to the last bit, see
 * 08_object_order/raster_clip.h; planes of any direction, 13_bsp/side.h.
 *
 * Source: I. Sutherland, G. Hodgman, "Reentrant Polygon Clipping", CACM 17(1), 1974.
 */
#ifndef AABB_PART_H
#define AABB_PART_H

#include <math.h>

typedef struct { double lo[3], hi[3]; } part_box;

#define part_nothing ((part_box){{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}})

/* ---------------------------------------------------------------------------------------------- */

static inline void part_point(part_box *p, const double q[3])
{
    for (int k = 0; k < 3; k++) {
        p->lo[k] = q[k] < p->lo[k] ? q[k] : p->lo[k];
        p->hi[k] = q[k] > p->hi[k] ? q[k] : p->hi[k];
    }
}

static inline void part_crossing(const double a[3], const double b[3], int axis, double at,
                                 double q[3])
{
    double s = (at - a[axis]) / (b[axis] - a[axis]);
    for (int k = 0; k < 3; k++) q[k] = a[k] + s * (b[k] - a[k]);
    q[axis] = at;
}

/* Corner a of the edge, and its crossings; b is the next edge's. */
static inline void part_edge(part_box *p, const double a[3], const double b[3], int axis, double lo,
                             double hi)
{
    const double side[2] = {lo, hi};
    double x = a[axis], y = b[axis], q[3];
    if (x >= lo && x <= hi) part_point(p, a);
    for (int k = 0; k < 2; k++) {
        if (!((x < side[k] && y > side[k]) || (x > side[k] && y < side[k]))) continue;
        part_crossing(a, b, axis, side[k], q);
        part_point(p, q);
    }
}

#endif
