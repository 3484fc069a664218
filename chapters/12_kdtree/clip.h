/* clip.h: how much of a triangle lies in a cell: "perfect splits".
 *
 *            +-----------+         The box of a triangle reaches into cells that the triangle does
 *            |       . ' |\        not touch. So where a plane cuts it, the part on each side gets
 *            |   . '  |  | \       the box of that part (12.5): the triangle is cut by the six
 *            +-'------+--+--\      sides of its present box, and then by the plane.
 *          .'     plane     .'
 *
 *   kd_polygon g = kd_polygon_in(corner, &box)    what is left of a triangle inside a box
 *   kd_cut(&g, axis, plane, &below, &above)       boxes of the two parts; an empty part: lo > hi
 *   kd_bounds(lo, hi, thick)                      rounded outwards to floats
 *
 * The present box is that of the part of the triangle in its cell, so what the box keeps of the
 * triangle is what the cell keeps: the six sides of the box serve for those of the cell.
 *
 * All in double: a corner of the cut lies on its edge within 4 of 2^-53 of the edge's length, and
 * boxes are rounded outwards by 2^-24. A point of the triangle that rounding leaves out of both
 * parts would have to be farther from both than that.
 *
 * Sources: I. Sutherland, G. Hodgman, "Reentrant Polygon Clipping", CACM 17(1), 1974; V. Havran,
 * J. Bittner, "On Improving KD-Trees for Ray Shooting", WSCG 2002 (split clipping).
 */
#ifndef KDTREE_CLIP_H
#define KDTREE_CLIP_H

#include "node.h"

enum { kd_most_corners = 9 };  /* three, and one more for each of six planes */
typedef struct { int n; double p[kd_most_corners][3]; } kd_polygon;

#define kd_nothing ((kd_box){{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}})

/* ---------------------------------------------------------------------------------------------- */

/* The last float below x, by two; thick or not, never above x. */
static inline float kd_below(double x, bool thick)
{
    float f = (float)x;
    if (!thick && (double)f <= x) return f;
    return f - (fabs(f) * FLT_EPSILON + 0x1p-149f);
}

static inline float kd_above(double x, bool thick) { return -kd_below(-x, thick); }

/* thick: at least one float to spare, so that what is flat is not, and no plane is quite its own. */
static inline kd_box kd_bounds(const double lo[3], const double hi[3], bool thick)
{
    kd_box b;
    for (int k = 0; k < 3; k++)
        b.lo[k] = kd_below(lo[k], thick), b.hi[k] = kd_above(hi[k], thick);
    return b;
}

/* The point of the edge a b in the plane; a and b are on different sides, or in it. */
static inline void kd_crossing(const double a[3], const double b[3], int axis, double plane,
                               double out[3])
{
    double s = (plane - a[axis]) / (b[axis] - a[axis]);
    for (int k = 0; k < 3; k++) out[k] = a[k] + s * (b[k] - a[k]);
    out[axis] = plane;
}

/* Keeps what has sign * x <= sign * plane: corners in the plane stay. */
static inline void kd_clip(kd_polygon *g, int axis, double plane, double sign)
{
    kd_polygon out = {0, {{0}}};
    for (int i = 0; i < g->n; i++) {
        const double *a = g->p[i], *b = g->p[i + 1 < g->n ? i + 1 : 0];
        bool a_in = sign * a[axis] <= sign * plane, b_in = sign * b[axis] <= sign * plane;
        if (a_in && out.n < kd_most_corners) memcpy(out.p[out.n++], a, sizeof out.p[0]);
        if (a_in != b_in && out.n < kd_most_corners)
            kd_crossing(a, b, axis, plane, out.p[out.n++]);
    }
    *g = out;
}

static inline void kd_polygon_bounds(const kd_polygon *g, double lo[3], double hi[3])
{
    for (int k = 0; k < 3; k++) lo[k] = HUGE_VAL, hi[k] = -HUGE_VAL;
    for (int i = 0; i < g->n; i++)
        for (int k = 0; k < 3; k++) {
            double x = g->p[i][k];
            lo[k] = x < lo[k] ? x : lo[k], hi[k] = x > hi[k] ? x : hi[k];
        }
}

static inline kd_polygon kd_polygon_in(double corner[3][3], const kd_box *box)
{
    kd_polygon g = {3, {{0}}};
    double lo[3], hi[3];
    memcpy(g.p, corner, 3 * sizeof g.p[0]);
    kd_polygon_bounds(&g, lo, hi);
    for (int k = 0; k < 3; k++) {
        if (lo[k] < (double)box->lo[k]) kd_clip(&g, k, (double)box->lo[k], -1);
        if (hi[k] > (double)box->hi[k]) kd_clip(&g, k, (double)box->hi[k], 1);
    }
    return g;
}

/* Adds a point to the bounds of the side it is on; one in the plane to both. */
static inline void kd_cut_point(const double p[3], int axis, double plane, double lo[2][3],
                                double hi[2][3])
{
    for (int side = 0; side < 2; side++) {
        if (side ? p[axis] < plane : p[axis] > plane) continue;
        for (int k = 0; k < 3; k++) {
            lo[side][k] = p[k] < lo[side][k] ? p[k] : lo[side][k];
            hi[side][k] = p[k] > hi[side][k] ? p[k] : hi[side][k];
        }
    }
}

/* Box of what the plane leaves on one side: the bounds found, but not beyond the present box. */
static inline kd_box kd_cut_box(const double lo[3], const double hi[3], const kd_box *now,
                                bool thick)
{
    if (!(lo[0] <= hi[0])) return kd_nothing;
    kd_box b = kd_bounds(lo, hi, thick);
    for (int k = 0; k < 3; k++)
        b.lo[k] = kd_max(b.lo[k], now->lo[k]), b.hi[k] = kd_min(b.hi[k], now->hi[k]);
    return b;
}

/* (12.5). `below` and `above` hold the present box when this begins. Walks the edges of any
 * polygon, also of one that is not convex: its bounds need no order of corners. */
static inline void kd_cut_corners(const double (*p)[3], int n, int axis, double plane, bool thick,
                                  kd_box *below, kd_box *above)
{
    double lo[2][3], hi[2][3], q[3];
    for (int k = 0; k < 3; k++) lo[0][k] = lo[1][k] = HUGE_VAL, hi[0][k] = hi[1][k] = -HUGE_VAL;
    for (int i = 0; i < n; i++) {
        const double *a = p[i], *b = p[i + 1 < n ? i + 1 : 0];
        kd_cut_point(a, axis, plane, lo, hi);
        if ((a[axis] < plane && b[axis] > plane) || (a[axis] > plane && b[axis] < plane)) {
            kd_crossing(a, b, axis, plane, q);
            kd_cut_point(q, axis, plane, lo, hi);
        }
    }
    *below = kd_cut_box(lo[0], hi[0], below, thick);
    *above = kd_cut_box(lo[1], hi[1], above, thick);
    below->hi[axis] = kd_min((float)plane, below->hi[axis]);
    above->lo[axis] = kd_max((float)plane, above->lo[axis]);
}

#endif
