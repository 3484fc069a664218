/* overlap.h: which cells does an item touch? (判断格子与图元是否相交)
 *
 *        +-----+-----+       The cheap answer: those that the item's bounds overlap. But a slanted
 *        |    /|     |       triangle leaves most of them empty, and who passes them asks it in
 *        |   / | no  |       vain. The exact answer: two convex bodies are apart if and only if
 *        |  /  |     |       they are apart when projected on one of these axes (分离轴):
 *        +-/---+-----+         the normals of both, and the cross products of their edges;
 *        |/ yes|  no |         for a triangle and a box 3 + 1 + 9.                        (10.2)
 *
 *   overlap_plan p;
 *   if (overlap_plan_of(&x, i, &p)) ...       once an item; false: it can never be hit
 *   bool overlap_box(&p, cell)                for many cells; the cell is closed
 *   bool items_overlap_box(&x, i, cell)       both at once
 *
 * Never "no" when they touch, whatever the rounding: the margin is argued below. "Yes" may be wrong
 * where a gap is smaller than 8 epsilon times the largest coordinate of the item; and for
 *   polygons   beyond 8 corners only their plane is asked; concave ones count as their convex hull
 *   cones      the silhouettes along x, y and z, and the ends; what is inside a hollow cone counts
 *   others     all of their box counts
 * Spheres are exact, and hollow: a cell that lies wholly inside is not touched.
 *
 * Sources: S. Gottschalk, M. Lin, D. Manocha, "OBBTree", SIGGRAPH 1996 (separating axes);
 * T. Akenine-Möller, "Fast 3D Triangle-Box Overlap Testing", JGT 6(1), 2001; M. Schwarz, H.-P.
 * Seidel, "Fast Parallel Surface and Solid Voxelization on GPUs", SIGGRAPH Asia 2010 (prepare the
 * triangle once); J. Arvo, "A Simple Method for Box-Sphere Intersection Testing", Graphics Gems,
 * 1990.
 */
#ifndef AABB_OVERLAP_H
#define AABB_OVERLAP_H

#include "items.h"

enum { overlap_corners = 8, overlap_most_axes = 1 + 3 * overlap_corners };

typedef struct { vec3 a; real lo, hi; } overlap_axis;  /* the item has lo <= a.p <= hi */

typedef struct {
    aabb box;       /* bounds of the item */
    bool is_sphere;
    sphere ball;    /* if it is one */
    int axes;
    overlap_axis axis[overlap_most_axes];
} overlap_plan;

/* ---------------------------------------------------------------------------------------------- */

/* Adds the axis a; the item is the convex hull of n points, each with a ball of radius r about it.
 *
 * The axis is exact, whatever rounding made it: every direction is a good witness that two things
 * are apart. Only the projections are off: three products, two sums, so by 3/2 epsilon |a|1 S for a
 * point, S = the largest coordinate, |a|1 = |ax| + |ay| + |az|; the same for a corner of the box,
 * which overlap_box has cut to the bounds of the item. Widening by this margin rounds once more, by
 * epsilon/2 |a|1 S: 7/2 epsilon in all < 4. What underflows is less than real_smallest. A ball's
 * reach is off by 9/4 epsilon of itself, and at -+ more by epsilon/2 |a|1 S: with 8 epsilon of it
 * the margin need not pay for any of that, and a cell that is named in vain costs nothing. */
static inline void overlap_add(overlap_plan *p, vec3 a, const vec3 *v, const real *r, uint32_t n)
{
    real one = fabs(a.x) + fabs(a.y) + fabs(a.z);
    real margin = 4 * real_epsilon * one * aabb_reach(p->box) + real_smallest;
    overlap_axis x = {a, real_infinity, -real_infinity};
    if (vzero(a)) return;  /* says nothing */
    for (uint32_t i = 0; i < n; i++) {
        real at = vdot(a, v[i]), more = r ? r[i] * vlength(a) * (1 + 8 * real_epsilon) : 0;
        x.lo = real_min(at - more, x.lo);
        x.hi = real_max(at + more, x.hi);
    }
    x.lo -= margin, x.hi += margin;
    p->axis[p->axes++] = x;
}

/* e x the x, y and z axis: what the item's edge e and an edge of the box are both square to. */
static inline void overlap_add_edge(overlap_plan *p, vec3 e, const vec3 *v, const real *r,
                                    uint32_t n)
{
    overlap_add(p, (vec3){0, e.z, -e.y}, v, r, n);
    overlap_add(p, (vec3){-e.z, 0, e.x}, v, r, n);
    overlap_add(p, (vec3){e.y, -e.x, 0}, v, r, n);
}

static inline void overlap_add_polygon(overlap_plan *p, vec3 normal, const vec3 *v, uint32_t n)
{
    overlap_add(p, normal, v, NULL, n);
    if (n > overlap_corners) return;
    for (uint32_t i = 0; i < n; i++)
        overlap_add_edge(p, vsub(v[i + 1 < n ? i + 1 : 0], v[i]), v, NULL, n);
}

/* An end is a disk square to w: along w it has no reach but by the rounding of w; on axes square to
 * w it reaches as far as a ball. */
static inline void overlap_add_cone(overlap_plan *p, cone c)
{
    const vec3 v[2] = {c.a, c.b}, w = vsub(c.b, c.a);
    const real r[2] = {fabs(c.ra), fabs(c.rb)};
    const real tilt[2] = {2 * real_epsilon * r[0], 2 * real_epsilon * r[1]};
    overlap_add(p, w, v, tilt, 2);
    overlap_add_edge(p, w, v, r, 2);
}

static inline bool overlap_plan_of(const items *x, size_t i, overlap_plan *p)
{
    p->axes = 0, p->is_sphere = false;
    if (!items_bounds(x, i, &p->box)) return false;
    triangle t;
    if (items_triangle(x, i, &t)) {
        const vec3 v[3] = {t.a, t.b, t.c};
        overlap_add_polygon(p, vcross(vsub(t.b, t.a), vsub(t.c, t.a)), v, 3);
        return true;
    }
    const shape *s = &x->s->shapes[i];
    switch (s->kind) {
    case SHAPE_SPHERE: p->is_sphere = true, p->ball = s->sphere; break;
    case SHAPE_CONE: overlap_add_cone(p, s->cone); break;
    case SHAPE_POLYGON:
        overlap_add_polygon(p, s->polygon.normal, s->polygon.v, s->polygon.n);
        break;
    case SHAPE_TRIANGLE:
    case SHAPE_OTHER: break;  /* its box is all that is known */
    }
    return true;
}

/* Nearest and farthest point of the box from the centre: the surface lies between. A square of a
 * distance is right within 5 roundings, r^2 within 1, and the product rounds: 7/2 epsilon < 4. */
static inline bool sphere_overlap_box(sphere s, aabb b)
{
    vec3 below = vsub(b.lo, s.c), above = vsub(s.c, b.hi), zero = {0, 0, 0};
    vec3 near = vmax(vmax(below, above), zero), far = vmax(vneg(below), vneg(above));
    real rr = s.r * s.r, pad = 4 * real_epsilon;
    return !(vdot(near, near) * (1 - pad) > rr + real_smallest)  /* a NaN is a yes */
           && !(vdot(far, far) * (1 + pad) < rr - real_smallest);
}

/* What of the cell lies outside the item's bounds cannot matter: cut away, exactly, it leaves
 * corners that are as near as the item itself, and the margin of overlap_add suffices. */
static inline bool overlap_box(const overlap_plan *p, aabb cell)
{
    aabb b = {vmax(cell.lo, p->box.lo), vmin(cell.hi, p->box.hi)};
    if (aabb_is_empty(b)) return false;
    if (p->is_sphere) return sphere_overlap_box(p->ball, b);
    for (const overlap_axis *x = p->axis, *end = x + p->axes; x < end; x++) {
        vec3 u = vmul(x->a, b.lo), v = vmul(x->a, b.hi), lo = vmin(u, v), hi = vmax(u, v);
        if (lo.x + lo.y + lo.z > x->hi || hi.x + hi.y + hi.z < x->lo) return false;
    }
    return true;
}

static inline bool items_overlap_box(const items *x, size_t i, aabb cell)
{
    overlap_plan p;
    return overlap_plan_of(x, i, &p) && overlap_box(&p, cell);
}

#endif
