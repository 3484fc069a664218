/* walk_figure.h: a walk in the plane, drawn with the code of this chapter: cells of one layer,
 * triangles seen edge-on.
 *
 *   orange        cells that an item touches; pale: those that only its bounds overlap
 *   blue          cells that the ray passes
 *   dots          where it meets the walls: black of x, white of y; the large one: the hit
 */
#ifndef GRID_WALK_FIGURE_H
#define GRID_WALK_FIGURE_H

#include "pictures.h"

enum { figure_x = 13, figure_y = 6, figure_scale = 66, figure_most = 40 };

typedef struct {
    lattice cells;
    cell_lists touched, bounds;
    const mesh *m;
    bool passed[figure_x * figure_y];
    ray r;
    hit h;
    struct { vec3 p; int axis; } wall[figure_most];
    int walls;
} grid_figure;

/* ---------------------------------------------------------------------------------------------- */

static const real figure_lines[][4] = {  /* x, y from and to */
    {3.2, 4.6, 5.7, 5.6}, {5.7, 5.6, 6.6, 3.7},
    {6.6, 3.7, 4.3, 3.4}, {4.3, 3.4, 3.2, 4.6},
    {8.2, 0.4, 11.8, 3.4}, {1.4, 0.7, 4.6, 1.3},
    {11.8, 3.4, 12.4, 5.6}};
enum { figure_segments = sizeof figure_lines / sizeof *figure_lines };

/* One triangle a segment, standing on it: within the layer 0 <= z <= 1. */
static inline mesh figure_mesh(void)
{
    mesh m = grid_soup(figure_segments, 1);
    for (size_t i = 0; i < figure_segments; i++) {
        const real *s = figure_lines[i];
        m.v[3 * i] = (vec3){s[0], s[1], -9}, m.v[3 * i + 1] = (vec3){s[2], s[3], -9};
        m.v[3 * i + 2] = (vec3){(s[0] + s[2]) / 2, (s[1] + s[3]) / 2, 9000};
    }
    return m;
}

static inline void figure_mark(const grid_figure *f, const items *x, bool exact, cell_lists *l)
{
    marking mark = {x, f->cells, 1e-4, exact};
    failure why;
    if (!lists_begin(lattice_cells(&f->cells), (size_t)1 << 20, l, &why)) fail(why);
    for (size_t i = 0; i < x->n; i++)
        if (!lists_count(l, &mark, i, 0, &why)) fail(why);
    lists_sum(l);
    for (size_t i = x->n; i-- > 0;) lists_enter(l, &mark, i, 0);
    lists_finish(l);
}

static inline void figure_walk(grid_figure *f)
{
    grid_line a = line_of(f->r);
    grid_walk w = walk_from(&f->cells, &a, 0);
    for (real t = 0; f->walls < figure_most;) {
        f->passed[w.cell] = true;
        t = walk_next_t(&w);
        if (!(t <= f->h.t)) break;
        f->wall[f->walls].p = ray_at(f->r, t), f->wall[f->walls++].axis = w.t.x == t ? 0 : 1;
        walk_step(&w, t);
    }
}

static inline real figure_distance(real x, real y, real x0, real y0, real x1, real y1)
{
    real dx = x1 - x0, dy = y1 - y0;
    real u = real_clamp(((x - x0) * dx + (y - y0) * dy) / (dx * dx + dy * dy), 0, 1);
    return sqrt((x - x0 - u * dx) * (x - x0 - u * dx) + (y - y0 - u * dy) * (y - y0 - u * dy));
}

static inline vec3 grid_mix(vec3 a, vec3 b, real t) { return vmadd(vscale(a, 1 - t), b, t); }

/* Colour c over what is there, where the distance [cells] is below half the width [pixels]. */
static inline void figure_ink(vec3 *at, real distance, double width, vec3 c)
{
    real cover = (real)(0.5 * width + 0.5) - distance * figure_scale;
    *at = grid_mix(*at, c, real_clamp(cover, 0, 1));
}

static inline vec3 figure_colour(const void *figure, real px, real py)
{
    const grid_figure *f = figure;
    real x = px / figure_scale, y = figure_y - py / figure_scale;
    size_t cell = (size_t)x + figure_x * (size_t)y;
    vec3 c = cell_marked(&f->touched, cell)  ? vec(1, 0.68, 0.25)
             : cell_marked(&f->bounds, cell) ? vec(1, 0.93, 0.75)
                                             : vec(1, 1, 1);
    if (f->passed[cell]) c = grid_mix(c, vec(0.1, 0.4, 0.9), 0.35);
    real wall = real_min(fabs(x - floor(x + (real)0.5)), fabs(y - floor(y + (real)0.5)));
    figure_ink(&c, wall, 1, vec(0.45, 0.45, 0.45));
    for (int i = 0; i < figure_segments; i++) {
        const real *s = figure_lines[i];
        figure_ink(&c, figure_distance(x, y, s[0], s[1], s[2], s[3]), 4, vec(0.1, 0.08, 0.05));
    }
    vec3 o = f->r.o, e = ray_at(f->r, f->h.t);
    figure_ink(&c, figure_distance(x, y, o.x, o.y, e.x, e.y), 3, vec(0.02, 0.12, 0.6));
    for (int i = 0; i <= f->walls; i++) {
        vec3 p = i < f->walls ? f->wall[i].p : e;
        real d = sqrt((x - p.x) * (x - p.x) + (y - p.y) * (y - p.y));
        bool is_hit = i == f->walls, white = !is_hit && f->wall[i].axis == 1;
        figure_ink(&c, d, is_hit ? 15 : 9, is_hit ? vec(0.8, 0.05, 0.02) : vec(0, 0, 0));
        if (white) figure_ink(&c, d, 6, vec(1, 1, 1));
    }
    return c;
}

static inline void draw_walk(const options *o)
{
    mesh m = figure_mesh();
    items x = items_of_mesh(&m);
    image im = image_new(figure_x * figure_scale, figure_y * figure_scale);
    grid_figure f = {.m = &m, .h = hit_none};
    aabb layer = {{0, 0, 0}, {figure_x, figure_y, 1}};
    f.cells = lattice_of(layer, (int[3]){figure_x, figure_y, 1});
    f.r = ray_from(vec(0.3, 1.75, 0.5), vec(1, 0.105, 0));
    figure_mark(&f, &x, true, &f.touched), figure_mark(&f, &x, false, &f.bounds);
    items_hit(&x, f.r, &f.h);
    figure_walk(&f);
    bool whole = pixels_draw(&im, 1, o->threads, "walk", figure_colour, &f);
    output_picture(o, &im, "10_grid_walk.png", false, whole);
    lists_free(&f.touched), lists_free(&f.bounds), mesh_free(&m), image_free(&im);
}

#endif
