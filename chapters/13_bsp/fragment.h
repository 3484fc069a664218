/* fragment.h: what a builder of BSP trees knows of the items in a cell: the part of each that is in
 * it.
 *
 *   bool fragment_of(&w, i, &f)          item i as a fragment on top of the store; false: never hit
 *   plane_side fragment_side(&w, p, &f)        where it lies (13.1)
 *   fragment_half(&w, p, sign, f)       its part with sign * s <= e, on top of the store
 *   bool fragment_plane(&w, &f, edge, &p)   its own plane (edge = 3) or one through an edge [0..2]
 *
 *   a triangle         a convex polygon, cut as the cells are cut
 *   any other shape    cannot be cut: its box, cut by planes across the axes. It may be named by
 *                      cells that only its box touches: that costs time, no more.
 *
 * Coordinates: q = (p - middle) / scale, the middle of all and a power of two: |q_k| <= size <= 1.
 */
#ifndef BSP_FRAGMENT_H
#define BSP_FRAGMENT_H

#include "../09_aabb/items.h"
#include "cell.h"

/* Which rule places what is near a plane: side.h, and two that lose hits. */
typedef enum {
    BSP_SIDES_SAFE,    /* e = 192 eps size; what is on the plane goes to one side */
    BSP_SIDES_STRICT,  /* naive: e = 0; all s < 0 or all s > 0, else cut: coplanar ones get lost */
    BSP_SIDES_FIXED    /* naive: e = 1e-4 scene units: what sticks out by that much gets lost */
} bsp_sides;

typedef struct {
    uint32_t item, corner;  /* first corner in the store */
    uint16_t corners;       /* 0: a box, corners lo and hi */
    bool used;              /* its own plane was taken, or it lies in a plane that was */
} fragment;

typedef struct {
    const items *x;
    vec3 middle;
    real scale, size, e;
    bsp_sides sides;
    vec3 *corner;  /* a stack, as the cells are */
    fragment *f;
    size_t corners, fragments, corner_room, fragment_room;
} workshop;

/* ---------------------------------------------------------------------------------------------- */

static inline vec3 workshop_place(const workshop *w, vec3 p)
{
    return vscale(vsub(p, w->middle), 1 / w->scale);
}

static inline void workshop_reserve(workshop *w, size_t corners)
{
    w->corner = grown_by(w->corner, w->corners, corners, &w->corner_room, sizeof *w->corner);
}

static inline fragment *workshop_push(workshop *w, fragment f)
{
    w->f = grown(w->f, w->fragments, &w->fragment_room, sizeof *w->f);
    w->f[w->fragments] = f;
    return &w->f[w->fragments++];
}

static inline bool fragment_of(workshop *w, uint32_t i, fragment *out)
{
    aabb b;
    triangle t;
    if (!items_bounds(w->x, i, &b)) return false;
    workshop_reserve(w, 3);
    vec3 *q = w->corner + w->corners;
    *out = (fragment){i, (uint32_t)w->corners, 0, false};
    if (items_triangle(w->x, i, &t)) {
        q[0] = workshop_place(w, t.a), q[1] = workshop_place(w, t.b), q[2] = workshop_place(w, t.c);
        out->corners = 3;
    } else {
        q[0] = workshop_place(w, b.lo), q[1] = workshop_place(w, b.hi);
        out->used = true;
    }
    w->corners += out->corners ? out->corners : 2;
    return true;
}

static inline void fragment_range(const workshop *w, const split_plane *p, const fragment *f,
                                  real *lo, real *hi)
{
    const vec3 *q = w->corner + f->corner;
    if (f->corners || p->axis < 3) {
        side_range(p, q, f->corners ? f->corners : 2, lo, hi);
        return;
    }
    vec3 half = vscale(vsub(q[1], q[0]), 0.5);
    real s = side_of(p, vadd(q[0], half)), reach = vdot(vabs(p->n), half);
    *lo = s - reach, *hi = s + reach;
}

static inline plane_side fragment_side(const workshop *w, const split_plane *p, const fragment *f)
{
    real lo, hi;
    fragment_range(w, p, f, &lo, &hi);
    return side_of_range(lo, hi, w->e);
}

/* The naive ones cut at the plane itself. */
static inline void fragment_half(workshop *w, const split_plane *p, real sign, fragment f)
{
    real level = w->sides == BSP_SIDES_SAFE ? w->e : 0;
    fragment part = f;
    workshop_reserve(w, 2 * (size_t)f.corners + 2);
    const vec3 *q = w->corner + f.corner;
    vec3 *out = w->corner + w->corners;
    part.corner = (uint32_t)w->corners;
    if (f.corners) part.corners = (uint16_t)clip(p, sign, level, q, f.corners, out);
    else {
        out[0] = q[0], out[1] = q[1];
        if (p->axis < 3 && sign > 0)
            ((real *)&out[1])[p->axis] = real_min(vaxis(q[1], p->axis), p->at + level);
        if (p->axis < 3 && sign < 0)
            ((real *)&out[0])[p->axis] = real_max(vaxis(q[0], p->axis), p->at - level);
    }
    if (f.corners && part.corners == 0) return;
    w->corners += f.corners ? part.corners : 2;
    workshop_push(w, part);
}

/* Of the whole triangle, not of what is left of it: a small fragment has a poor plane. */
static inline bool fragment_plane(const workshop *w, const fragment *f, int edge, split_plane *out)
{
    triangle t;
    if (!items_triangle(w->x, f->item, &t)) return false;
    vec3 q[3] = {workshop_place(w, t.a), workshop_place(w, t.b), workshop_place(w, t.c)};
    *out = plane_of_triangle(q[0], q[1], q[2]);
    if (edge < 3 && !vzero(out->n)) *out = plane_of_edge(q[edge], q[(edge + 1) % 3], out->n);
    return !vzero(out->n);
}

#endif
