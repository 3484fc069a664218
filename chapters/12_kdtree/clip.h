/* clip.h: how much of a triangle lies in a cell: "perfect splits".
 *
 *            +-----------+         The box of a triangle reaches into cells that the triangle does
 *            |       . ' |\        not touch. So where a plane cuts it, the part on each side gets
 *            |   . '  |  | \       the box of that part (12.3): the triangle is cut by the six
 *            +-'------+--+--\      sides of its present box, and then by the plane.
 *          .'     plane     .'
 *
 *   kd_polygon g = kd_polygon_in(corner, &box)    what is left of a triangle inside a box
 *   kd_cut c = kd_cut_begin(axis, plane)          then, for each edge a b of a polygon,
 *   kd_cut_edge(&c, a, b)
 *   kd_cut_end(&c, thick, &below, &above)         boxes of the two parts; an empty part: lo > hi
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

/* thick: at least one float to spare, so that nothing is flat, and lies in a plane of its own. */
static inline kd_box kd_bounds(const double lo[3], const double hi[3], bool thick)
{
    kd_box b;
    for (int k = 0; k < 3; k++)
        b.lo[k] = kd_below(lo[k], thick), b.hi[k] = kd_above(hi[k], thick);
    return b;
}

/* The point of the edge a b in the plane `at`; a and b are on different sides, or in it. */
static inline void kd_crossing(const double a[3], const double b[3], int axis, double at,
                               double out[3])
{
    double s = (at - a[axis]) / (b[axis] - a[axis]);
    for (int k = 0; k < 3; k++) out[k] = a[k] + s * (b[k] - a[k]);
    out[axis] = at;
}

/* Keeps what has sign * x <= sign * at: corners in the plane stay. */
static inline void kd_clip(kd_polygon *g, int axis, double at, double sign)
{
    kd_polygon out = {0, {{0}}};
    for (int i = 0; i < g->n; i++) {
        const double *a = g->p[i], *b = g->p[i + 1 < g->n ? i + 1 : 0];
        bool a_in = sign * a[axis] <= sign * at, b_in = sign * b[axis] <= sign * at;
        if (a_in && out.n < kd_most_corners) memcpy(out.p[out.n++], a, sizeof out.p[0]);
        if (a_in != b_in && out.n < kd_most_corners)
            kd_crossing(a, b, axis, at, out.p[out.n++]);
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

/* The bounds of the two parts of a polygon, edge by edge, in any order: it may be concave. */
typedef struct { int axis; double at, lo[2][3], hi[2][3]; } kd_cut;

static inline kd_cut kd_cut_begin(int axis, float at)
{
    kd_cut c = {.axis = axis, .at = (double)at};
    for (int k = 0; k < 3; k++)
        c.lo[0][k] = c.lo[1][k] = HUGE_VAL, c.hi[0][k] = c.hi[1][k] = -HUGE_VAL;
    return c;
}

/* Adds a point to the side it is on; one in the plane to both. */
static inline void kd_cut_point(kd_cut *c, const double p[3])
{
    for (int side = 0; side < 2; side++) {
        if (side ? p[c->axis] < c->at : p[c->axis] > c->at) continue;
        for (int k = 0; k < 3; k++) {
            c->lo[side][k] = p[k] < c->lo[side][k] ? p[k] : c->lo[side][k];
            c->hi[side][k] = p[k] > c->hi[side][k] ? p[k] : c->hi[side][k];
        }
    }
}

static inline void kd_cut_edge(kd_cut *c, const double a[3], const double b[3])
{
    double q[3], x = a[c->axis], y = b[c->axis];
    kd_cut_point(c, a);
    if (!((x < c->at && y > c->at) || (x > c->at && y < c->at))) return;
    kd_crossing(a, b, c->axis, c->at, q);
    kd_cut_point(c, q);
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

/* (12.3). `below` and `above` hold the present box when this begins. */
static inline void kd_cut_end(const kd_cut *c, bool thick, kd_box *below, kd_box *above)
{
    int k = c->axis;
    *below = kd_cut_box(c->lo[0], c->hi[0], below, thick);
    *above = kd_cut_box(c->lo[1], c->hi[1], above, thick);
    below->hi[k] = kd_min((float)c->at, below->hi[k]);
    above->lo[k] = kd_max((float)c->at, above->lo[k]);
}

#endif
