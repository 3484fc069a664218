/* room.h: something to look at: the corner of a room, with blocks, out of flat rectangles.
 *
 *   z                 Each rectangle lies across one axis: all of it has the same x, or y, or z. So
 *   |  ____           the ray meets its plane at t = (at - o.x) / d.x, and two comparisons tell
 *   | /   /|          whether it is met inside.
 *   |/___/ |__ y
 *   |    |/           camera_room s = room_corner()      floor z = 0, walls x = 0, y = 0, blocks
 *   |____|            vec3 colour = room_colour(&s, r)   of what the ray meets first
 *   x
 */
#ifndef CAMERA_LAB_ROOM_H
#define CAMERA_LAB_ROOM_H

#include "../../01_ray/hit.h"
#include "../../../common/headlight.h"
#include <stddef.h>

typedef struct {
    int axis;            /* 0, 1, 2: the one that it lies across */
    real at;             /* where on that axis */
    vec3 low, high;      /* its extent on the two others */
    vec3 colour, check;  /* of the squares, in turn */
    real cell;           /* side of a square */
} camera_rectangle;

typedef struct { camera_rectangle r[24]; int n; } camera_room;

/* ---------------------------------------------------------------------------------------------- */

static inline bool room_rectangle_hit(const camera_rectangle *q, ray r, real *t)
{
    real tq = (q->at - vaxis(r.o, q->axis)) / vaxis(r.d, q->axis);
    if (!ray_covers(r, tq) || isinf(tq)) return false;  /* parallel: tq is infinite or NaN */
    vec3 p = ray_at(r, tq);
    for (int k = 0; k < 3; k++)
        if (k != q->axis && !(vaxis(p, k) >= vaxis(q->low, k) && vaxis(p, k) <= vaxis(q->high, k)))
            return false;
    *t = tq;
    return true;
}

static inline vec3 room_colour(const camera_room *s, ray r)
{
    static const vec3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const camera_rectangle *first = NULL;
    for (int i = 0; i < s->n; i++) {
        real t;
        if (room_rectangle_hit(&s->r[i], r, &t) && (t < r.tmax || !first))
            first = &s->r[i], r.tmax = t;
    }
    if (!first) return vec(0.86, 0.89, 0.93);
    vec3 p = vsub(ray_at(r, r.tmax), first->low);
    int a = (first->axis + 1) % 3, b = (first->axis + 2) % 3;
    long squares = (long)floor(vaxis(p, a) / first->cell) + (long)floor(vaxis(p, b) / first->cell);
    return vmul(squares % 2 ? first->check : first->colour, headlight(axes[first->axis], r.d));
}

/* Six faces, painted darker on the sides, so that edges show where the headlight shows none. */
static inline void room_block(camera_room *s, vec3 low, vec3 high, vec3 colour, real cell)
{
    static const real paint[] = {0.55, 0.8, 1};
    for (int k = 0; k < 3; k++) {
        vec3 a = vscale(colour, paint[k]), b = vscale(a, 0.8);
        s->r[s->n++] = (camera_rectangle){k, vaxis(low, k), low, high, a, b, cell};
        s->r[s->n++] = (camera_rectangle){k, vaxis(high, k), low, high, a, b, cell};
    }
}

static inline camera_room room_corner(void)
{
    const vec3 o = {0, 0, 0}, end = {4, 4, 4}, size = {0.8, 0.8, 0.8};
    camera_room s = {{{2, 0, o, end, {0.85, 0.8, 0.7}, {0.42, 0.36, 0.3}, 0.5},
                      {0, 0, o, end, {0.3, 0.48, 0.75}, {0.17, 0.3, 0.55}, 0.5},
                      {1, 0, o, end, {0.5, 0.72, 0.62}, {0.3, 0.52, 0.43}, 0.5}}, 3};
    for (int i = 0; i < 3; i++) {  /* three blocks of one size, one behind the other */
        vec3 low = {2, (real)0.5 + (real)1.2 * (real)i, 0};
        room_block(&s, low, vadd(low, size), vec(1, 0.5, 0.08), 0.4);
    }
    return s;
}

#endif
