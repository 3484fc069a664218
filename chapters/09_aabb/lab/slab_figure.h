/* slab_figure.h: the slab test in the plane, as a picture: three rays, and their intervals below.
 *
 *   draw_slabs(o)   a ray that hits, one that misses, one that starts inside
 *
 * Blue: the x slab, and the part of the ray in it. Orange: the y slab, and the part in it. Black:
 * where both parts overlap, so the part in the box. Below, the same parts on an axis of t, with a
 * thin line at t = 0: where they have nothing in common, or only behind 0, there is no hit.
 */
#ifndef SLAB_FIGURE_H
#define SLAB_FIGURE_H

#include "../../../common/output.h"
#include "../../../common/parallel.h"
#include "../aabb.h"

enum { figure_panel = 300, figure_bars = 78, figure_gap = 8, figure_panels = 3 };

typedef struct { real t0, t1; } t_interval;
typedef struct { image *im; ray r[figure_panels]; aabb b; } slab_figure;

/* ---------------------------------------------------------------------------------------------- */

/* (9.1) on one axis, for d not 0. */
static inline t_interval slab_interval(real lo, real hi, real o, real d)
{
    real a = (lo - o) / d, b = (hi - o) / d;
    return (t_interval){real_min(a, b), real_max(a, b)};
}

/* (9.2) */
static inline t_interval t_overlap(t_interval a, t_interval b)
{
    return (t_interval){real_max(a.t0, b.t0), real_min(a.t1, b.t1)};
}

static inline bool t_within(t_interval a, real t) { return t >= a.t0 && t <= a.t1; }

static inline vec3 figure_paint(int i)
{
    static const double c[5][3] = {{1, 1, 1}, {0.02, 0.3, 0.72}, {0.85, 0.35, 0.0},
                                   {0, 0, 0}, {0.55, 0.55, 0.55}};
    return vec(c[i][0], c[i][1], c[i][2]);
}

static inline vec3 figure_mix(vec3 a, vec3 b, real t) { return vmadd(vscale(a, 1 - t), b, t); }

/* A point of the plane [0,10]^2, y up. */
static inline vec3 figure_plane(const slab_figure *f, ray r, real x, real y)
{
    vec3 c = figure_paint(0), p = {x - r.o.x, y - r.o.y, 0};
    bool in_x = x >= f->b.lo.x && x <= f->b.hi.x, in_y = y >= f->b.lo.y && y <= f->b.hi.y;
    t_interval tx = slab_interval(f->b.lo.x, f->b.hi.x, r.o.x, r.d.x);
    t_interval ty = slab_interval(f->b.lo.y, f->b.hi.y, r.o.y, r.d.y);
    real along = p.x * r.d.x + p.y * r.d.y, across = p.x * r.d.y - p.y * r.d.x;
    real eighth = 0.125;
    if (in_x) c = figure_mix(c, figure_paint(1), 0.2);
    if (in_y) c = figure_mix(c, figure_paint(2), 0.2);
    if (fabs(across) <= 2 * eighth) {
        if (across < -eighth / 2 && t_within(tx, along)) c = figure_paint(1);
        if (across > eighth / 2 && t_within(ty, along)) c = figure_paint(2);
    }
    if (fabs(across) < eighth / 3) c = figure_paint(along < 0 ? 4 : 3);
    if (fabs(across) < eighth && t_within(t_overlap(tx, ty), along)) c = figure_paint(3);
    if (p.x * p.x + p.y * p.y < eighth / 2) c = figure_paint(3);
    return c;
}

/* t in [-4, 12] from left to right, row 0 to 3: x slab, y slab, both. */
static inline vec3 figure_bar(const slab_figure *f, ray r, real t, real row)
{
    t_interval tx = slab_interval(f->b.lo.x, f->b.hi.x, r.o.x, r.d.x);
    t_interval ty = slab_interval(f->b.lo.y, f->b.hi.y, r.o.y, r.d.y);
    int k = (int)row;
    t_interval shown = k == 0 ? tx : k == 1 ? ty : t_overlap(tx, ty);
    real off = fabs(row - (real)k - (real)0.5);
    if (off < (real)0.3 && t_within(shown, t)) return figure_paint(k + 1);
    if (fabs(t) < (real)0.03) return figure_paint(3);
    return off < (real)0.03 ? figure_paint(4) : figure_paint(0);
}

static inline void figure_pixel(int x, int y, void *context)
{
    const slab_figure *f = context;
    int panel = x / (figure_panel + figure_gap), left = x - panel * (figure_panel + figure_gap);
    vec3 sum = {0, 0, 0};
    for (int i = 0; i < 16; i++) {
        real u = ((real)left + (real)(1 + 2 * (i % 4)) / 8) / (real)figure_panel;
        real v = ((real)y + (real)(1 + 2 * (i / 4)) / 8) / (real)figure_panel;
        vec3 c = figure_paint(0);
        if (u < 1 && v < 1) c = figure_plane(f, f->r[panel], 10 * u, 10 * (1 - v));
        real row = (v - 1) * (real)figure_panel / (real)figure_bars * 3;
        if (u < 1 && row >= 0 && row < 3) c = figure_bar(f, f->r[panel], 16 * u - 4, row);
        sum = vmadd(sum, c, (real)1 / 16);
    }
    image_set(f->im, x, y, sum);
}

static inline void draw_slabs(const options *o)
{
    image im = image_new(figure_panels * (figure_panel + figure_gap) - figure_gap,
                         figure_panel + figure_bars);
    slab_figure f = {.im = &im, .b = {{4, 4, 0}, {7, 6, 0}}};
    f.r[0] = ray_unit(ray_from(vec(1, 2.5, 0), (vec3){7, 4, 0}));
    f.r[1] = ray_unit(ray_from((vec3){1, 3, 0}, (vec3){5, 6, 0}));
    f.r[2] = ray_unit(ray_from(vec(5, 4.6, 0), (vec3){4, 1, 0}));
    bool whole = parallel_pixels(im.width, im.height, o->threads, "slabs", figure_pixel, &f);
    output_picture(o, &im, "09_aabb_slabs.png", false, whole);
    image_free(&im);
}

#endif
