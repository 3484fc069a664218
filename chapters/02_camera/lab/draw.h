/* draw.h: a picture, pixel by pixel: rays out, what they see back, their weighted mean. And
 * something to look at: the corner of a room, with blocks, out of flat rectangles.
 *
 *   for each pixel, for each position (dx, dy) around its centre
 *       r = aim(view, x + dx, y + dy)         camera_ray, or a variant of it
 *       c = see(view, r)                      the colour that this ray meets
 *   pixel = sum w(dx, dy) c / sum w(dx, dy)   (2.10)
 *
 *   camera_view v = {.c = c, .scene = &scene, .f = filter_box, .n = 4, .how = SAMPLES_JITTERED};
 *   pixels_draw(&im, 1, threads, "drawing", camera_colour, &v);
 *   camera_draw_panels(&o, v, g, name, is_main);   views, one a panel of shape g, as a file
 *
 * The random numbers of a pixel depend on (seed, pixel) alone.
 *
 *   z                 Each rectangle lies across one axis k: all of it has the same x, or y, or z.
 *   |  ____           So the ray meets its plane at t = (at - o_k) / d_k, and two comparisons tell
 *   | /   /|          whether it is met inside.
 *   |/___/ |__ y
 *   |    |/           camera_room s = room_corner()      floor z = 0, walls x = 0, y = 0, blocks
 *   |____|            vec3 colour = room_colour(&s, r)   of what the ray meets first
 *   x
 */
#ifndef CAMERA_LAB_DRAW_H
#define CAMERA_LAB_DRAW_H

#include "../../../common/headlight.h"
#include "../../../common/lab/panels.h"
#include "../../01_ray/hit.h"
#include "../camera.h"
#include "../filter.h"

typedef struct {
    real at;             /* where on the axis that it lies across */
    vec3 low, high;      /* its extent on the two others */
    vec3 colour, check;  /* of the squares, in turn */
    real cell;           /* side of a square */
} camera_rectangle;

typedef struct { camera_rectangle r[3][8]; int n[3]; } camera_room;  /* those across x, y, z */

typedef struct camera_view camera_view;
struct camera_view {
    camera c;
    const camera_room *scene;
    filter f;
    int n;                                         /* n x n rays a pixel */
    sample_placement how;
    uint64_t seed;
    ray (*aim)(const camera_view *v, real x, real y);     /* NULL: camera_ray */
    vec3 (*see)(const camera_view *v, ray r);             /* NULL: room_colour */
    const void *own;                               /* for aim and see */
    const char *tag;                               /* a name, drawn into a panel */
    int nx, ny;                                    /* pixels */
};

/* ---------------------------------------------------------------------------------------------- */

/* ---- the room ---- */

static inline vec3 room_colour(const camera_room *s, ray r)
{
    static const vec3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const camera_rectangle *first = NULL;
    int axis = 0;
    for (int c = 0; c < 3; c++) {
        const int k = (c + 2) % 3, i = c, j = (c + 1) % 3;
        const real o = vaxis(r.o, k), inverse = 1 / vaxis(r.d, k);
        const real oi = vaxis(r.o, i), di = vaxis(r.d, i), oj = vaxis(r.o, j), dj = vaxis(r.d, j);
        for (const camera_rectangle *q = s->r[k]; q < s->r[k] + s->n[k]; q++) {
            real t = (q->at - o) * inverse, x = oi + t * di, y = oj + t * dj;
            if (!ray_covers(r, t) || isinf(t)) continue;  /* parallel: t is infinite or NaN */
            bool in = x >= vaxis(q->low, i) && x <= vaxis(q->high, i) && y >= vaxis(q->low, j)
                   && y <= vaxis(q->high, j);
            if (in && (t < r.tmax || !first)) first = q, axis = k, r.tmax = t;
        }
    }
    if (!first) return vec(0.86, 0.89, 0.93);
    vec3 p = vsub(ray_at(r, r.tmax), first->low);
    int a = (axis + 1) % 3, b = (axis + 2) % 3;
    long squares = (long)floor(vaxis(p, a) / first->cell) + (long)floor(vaxis(p, b) / first->cell);
    return vmul(squares % 2 ? first->check : first->colour, headlight(axes[axis], r.d));
}

/* Six faces, painted darker on the sides, so that edges show where the headlight shows none. */
static inline void room_block(camera_room *s, vec3 low, vec3 high, vec3 colour, real cell)
{
    static const real paint[] = {0.55, 0.8, 1};
    for (int k = 0; k < 3; k++) {
        vec3 a = vscale(colour, paint[k]), b = vscale(a, 0.8);
        s->r[k][s->n[k]++] = (camera_rectangle){vaxis(low, k), low, high, a, b, cell};
        s->r[k][s->n[k]++] = (camera_rectangle){vaxis(high, k), low, high, a, b, cell};
    }
}

static inline camera_room room_corner(void)
{
    const vec3 o = {0, 0, 0}, end = {4, 4, 4}, size = {0.8, 0.8, 0.8};
    camera_room s = {.n = {1, 1, 1}};
    s.r[2][0] = (camera_rectangle){0, o, end, vec(0.85, 0.8, 0.7), vec(0.42, 0.36, 0.3), 0.5};
    s.r[0][0] = (camera_rectangle){0, o, end, vec(0.3, 0.48, 0.75), vec(0.17, 0.3, 0.55), 0.5};
    s.r[1][0] = (camera_rectangle){0, o, end, vec(0.5, 0.72, 0.62), vec(0.3, 0.52, 0.43), 0.5};
    for (int i = 0; i < 3; i++) {  /* three blocks of one size, one behind the other */
        vec3 low = {2, (real)0.5 + (real)1.2 * (real)i, 0};
        room_block(&s, low, vadd(low, size), vec(1, 0.5, 0.08), 0.4);
    }
    return s;
}

/* ---- its pictures ---- */

static inline vec3 camera_view_pixel(const camera_view *v, int x, int y)
{
    random_stream s = random_start(v->seed, (uint64_t)y * (uint64_t)v->nx + (uint64_t)x, 0);
    filter_sum sum = {{0, 0, 0}, 0};
    for (int k = 0; k < v->n * v->n; k++) {
        real dx, dy;
        samples_place(v->how, k, v->n, v->f.radius, &s, &dx, &dy);
        real px = (real)x + (real)0.5 + dx, py = (real)y + (real)0.5 + dy;
        ray r = v->aim ? v->aim(v, px, py) : camera_ray(v->c, px, py, v->nx, v->ny);
        vec3 seen = v->see ? v->see(v, r) : room_colour(v->scene, r);
        sum = filter_add(sum, filter_weight(v->f, dx, dy), seen);
    }
    return filter_mean(sum);
}

static vec3 camera_colour(const void *view, real x, real y)
{
    return camera_view_pixel(view, (int)x, (int)y);
}

static inline void camera_draw_panels(const options *o, camera_view *v, panels_shape g,
                                      const char *name, bool is_main)
{
    panel p[panels_most];
    for (int k = 0; k < g.columns * g.rows; k++) {
        v[k].nx = panels_wide(g), v[k].ny = panels_high(g);
        p[k] = (panel){v[k].tag, &v[k]};
    }
    panels_draw(o, name, is_main, g, camera_colour, p);
}

#endif
