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
 * Source: V. Havran, J. Bittner, "On Improving KD-Trees for Ray Shooting", WSCG 2002.
 */
#ifndef KDTREE_CLIP_H
#define KDTREE_CLIP_H

#include "../09_aabb/part.h"
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

/* Keeps what has sign * x <= sign * at: corners in the plane stay. In double whatever real is, and
 * a cut corner lies in its plane exactly: the clips of 08 and 13 promise neither. */
static inline void kd_clip(kd_polygon *g, int axis, double at, double sign)
{
    kd_polygon out = {0, {{0}}};
    for (int i = 0; i < g->n; i++) {
        const double *a = g->p[i], *b = g->p[i + 1 < g->n ? i + 1 : 0];
        bool a_in = sign * a[axis] <= sign * at, b_in = sign * b[axis] <= sign * at;
        if (a_in && out.n < kd_most_corners) memcpy(out.p[out.n++], a, sizeof out.p[0]);
        if (a_in != b_in && out.n < kd_most_corners)
            part_crossing(a, b, axis, at, out.p[out.n++]);
    }
    *g = out;
}

static inline kd_polygon kd_polygon_in(double corner[3][3], const kd_box *box)
{
    kd_polygon g = {3, {{0}}};
    part_box all = part_nothing;
    memcpy(g.p, corner, 3 * sizeof g.p[0]);
    for (int i = 0; i < 3; i++) part_point(&all, corner[i]);
    for (int k = 0; k < 3; k++) {
        if (all.lo[k] < (double)box->lo[k]) kd_clip(&g, k, (double)box->lo[k], -1);
        if (all.hi[k] > (double)box->hi[k]) kd_clip(&g, k, (double)box->hi[k], 1);
    }
    return g;
}

/* The bounds of the two parts of a polygon, edge by edge, in any order: it may be concave. */
typedef struct { int axis; double at; part_box part[2]; } kd_cut;

static inline kd_cut kd_cut_begin(int axis, float at)
{
    return (kd_cut){axis, (double)at, {part_nothing, part_nothing}};
}

static inline void kd_cut_edge(kd_cut *c, const double a[3], const double b[3])
{
    part_edge(&c->part[0], a, b, c->axis, -HUGE_VAL, c->at);
    part_edge(&c->part[1], a, b, c->axis, c->at, HUGE_VAL);
}

/* Box of what the plane leaves on one side: the bounds found, but not beyond the present box. */
static inline kd_box kd_cut_box(const part_box *p, const kd_box *now, bool thick)
{
    if (!(p->lo[0] <= p->hi[0])) return kd_nothing;
    kd_box b = kd_bounds(p->lo, p->hi, thick);
    for (int k = 0; k < 3; k++)
        b.lo[k] = float_max(b.lo[k], now->lo[k]), b.hi[k] = float_min(b.hi[k], now->hi[k]);
    return b;
}

/* (12.3). `below` and `above` hold the present box when this begins. */
static inline void kd_cut_end(const kd_cut *c, bool thick, kd_box *below, kd_box *above)
{
    int k = c->axis;
    *below = kd_cut_box(&c->part[0], below, thick);
    *above = kd_cut_box(&c->part[1], above, thick);
    below->hi[k] = float_min((float)c->at, below->hi[k]);
    above->lo[k] = float_max((float)c->at, above->lo[k]);
}

#endif
