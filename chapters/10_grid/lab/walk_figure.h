/* walk_figure.h: a walk in the plane, drawn with the code of this chapter: cells of one layer,
 * triangles seen edge-on; below, the t at which the ray meets the walls of x and of y.
 *
 *   draw_walk(o)       images/10_grid_walk.svg
 *
 * d_x is 1, so each wall's t stands below the place where the ray meets it.
 */
#ifndef GRID_WALK_FIGURE_H
#define GRID_WALK_FIGURE_H

#include "../../../common/lab/figure.h"
#include "../../07_mesh/scenes/soup.h"
#include "naive.h"

enum { walk_wide = 13, walk_high = 6, walk_unit = 62, walk_most = 40 };

typedef struct { double t; int axis; size_t cell; } walk_wall;  /* the cell that ends there */

/* ---------------------------------------------------------------------------------------------- */

static const real walk_lines[][4] = {  /* x, y from and to; the first is a, the second b */
    {9.3, 1.2, 12.3, 3.35}, {11.3, 2.72, 11.3, 3.45}, {3.2, 4.6, 5.7, 5.6}, {5.7, 5.6, 6.6, 3.7},
    {6.6, 3.7, 4.3, 3.4}, {4.3, 3.4, 3.2, 4.6}, {1.4, 1.8, 4.6, 2.35}, {12.3, 3.35, 12.6, 5.4}};
enum { walk_segments = sizeof walk_lines / sizeof *walk_lines };

/* One triangle a segment, standing on it: within the layer 0 <= z <= 1. */
static inline mesh walk_mesh(void)
{
    mesh m = mesh_room(walk_segments);
    for (size_t i = 0; i < walk_segments; i++) {
        const real *s = walk_lines[i];
        m.v[3 * i] = (vec3){s[0], s[1], -9}, m.v[3 * i + 1] = (vec3){s[2], s[3], -9};
        m.v[3 * i + 2] = (vec3){(s[0] + s[2]) / 2, (s[1] + s[3]) / 2, 9000};
    }
    return m;
}

static inline void walk_square(figure *g, double x, double y, double side, const char *colour,
                               double opacity, const char *outline)
{
    figure_polygon(g, 4, (double[8]){x, y, x + side, y, x + side, y + side, x, y + side}, colour,
                   opacity, outline);
}

/* The cells that an item touches, and, paler, those that only its bounds overlap. */
static inline void walk_marks(figure *g, const items *x, const lattice *l)
{
    for (int exact = 0; exact < 2; exact++)
        for (int c = 0; c < walk_wide * walk_high; c++) {
            const int at[3] = {c % walk_wide, c / walk_wide, 0};
            aabb cell = lattice_box(l, at, at, (real)1e-4);
            bool marked = false;
            for (size_t i = 0; i < x->n; i++)
                marked |= exact ? items_overlap_box(x, i, cell) : items_overlap_bounds(x, i, cell);
            if (marked) walk_square(g, at[0], at[1], 1, FIGURE_GREY, exact ? 0.35 : 0.12, NULL);
        }
}

/* Walls of x are black, those of y white. */
static inline void walk_crossing(figure *g, double x, double y, int axis)
{
    figure_dot(g, x, y, 5, FIGURE_BLACK);
    if (axis == 1) figure_dot(g, x, y, 3.5, "white");
}

/* One axis of t: its walls, and the way between two of them. */
static inline void walk_t_axis(figure *g, const walk_wall *wall, int n, int axis, double o,
                               double end)
{
    static const char *const name[2] = {"walls of _x_", "walls of _y_"};
    static const char *const step[2] = {"_step_~x~", "_step_~y~"};
    double y = axis ? -1.3 : -0.75, x[walk_most];
    int walls = 0, shown = axis ? 0 : 2;
    for (int i = 0; i < n; i++)
        if (wall[i].axis == axis) x[walls++] = o + wall[i].t;
    figure_arrow(g, o, y, end, y, FIGURE_GREY, 1);
    figure_text(g, end, y, 8, 5, FIGURE_LEFT, FIGURE_BLACK, name[axis]);
    figure_line(g, x[shown], y, x[shown + 1], y, FIGURE_RED, 3, FIGURE_WHOLE);
    figure_text(g, (x[shown] + x[shown + 1]) / 2, y, 0, -8, FIGURE_MIDDLE, FIGURE_RED, step[axis]);
    for (int i = 0; i < walls; i++) walk_crossing(g, x[i], y, axis);
}

static inline void walk_legend(figure *g)
{
    static const char *const text[3] = {"touched by a shape", "only by the box around it",
                                        "passed by the ray, in this order"};
    static const double opacity[3] = {0.35, 0.12, 0.45};
    for (int k = 0; k < 3; k++) {
        double x = 4.1 * k, y = walk_high + 0.25;
        walk_square(g, x, y, 0.3, k == 2 ? FIGURE_SKY : FIGURE_GREY, opacity[k], FIGURE_GREY);
        figure_text(g, x + 0.4, y, 0, -4, FIGURE_LEFT, FIGURE_BLACK, text[k]);
    }
}

cold_inline void draw_walk(const options *o)
{
    figure g = figure_begin(o, "10_grid_walk.svg", walk_wide * walk_unit + 120,
                            walk_high * walk_unit + 165);
    mesh m = walk_mesh();
    items all = items_of_mesh(&m);
    lattice l = lattice_of((aabb){{0, 0, 0}, {walk_wide, walk_high, 1}},
                           (int[3]){walk_wide, walk_high, 1});
    ray r = ray_from(vec(0.3, 0.45, 0.5), vec(1, 0.22, 0));
    walk_wall wall[walk_most];
    int n = 0;
    hit h = hit_none;
    items_hit(&all, r, &h);
    vec3 e = ray_at(r, h.t);
    grid_line a = line_of(r);
    for (grid_walk w = walk_from(&l, &a, 0); n < walk_most; n++) {
        real t = walk_next_t(&w);
        wall[n] = (walk_wall){(double)(t / a.scale), w.t.x == t ? 0 : 1, (size_t)w.cell};
        if (!(t <= h.t * a.scale)) break;
        walk_step(&w, t);
    }

    figure_origin(&g, 12, walk_high * walk_unit + 50, walk_unit);
    walk_legend(&g);
    walk_marks(&g, &all, &l);
    for (int i = 0; i <= n; i++) {
        double x = (double)(wall[i].cell % walk_wide), y = (double)(wall[i].cell / walk_wide);
        walk_square(&g, x, y, 1, FIGURE_SKY, 0.45, NULL);
        double middle = i ? (wall[i - 1].t + fmin(wall[i].t, (double)h.t)) / 2 : wall[i].t / 2;
        bool high = (double)ray_at(r, (real)middle).y > y + 0.5;  /* the ray: keep off it */
        figure_print(&g, high ? x : x + 1, high ? y : y + 1, high ? 5 : -5, high ? -6 : 17,
                     high ? FIGURE_LEFT : FIGURE_RIGHT, FIGURE_BLACK, "%d", i + 1);
    }
    for (int i = 0; i <= walk_wide; i++)
        figure_line(&g, i, 0, i, walk_high, FIGURE_GREY, 0.6, FIGURE_WHOLE);
    for (int i = 0; i <= walk_high; i++)
        figure_line(&g, 0, i, walk_wide, i, FIGURE_GREY, 0.6, FIGURE_WHOLE);
    for (int i = 0; i < walk_segments; i++) {
        const real *s = walk_lines[i];
        figure_line(&g, (double)s[0], (double)s[1], (double)s[2], (double)s[3], FIGURE_BLACK, 3,
                    FIGURE_WHOLE);
    }
    double ox = (double)r.o.x, oy = (double)r.o.y, ex = (double)e.x, ey = (double)e.y;
    figure_line(&g, ox, oy, ex, ey, FIGURE_RED, 2, FIGURE_WHOLE);
    for (int i = 0; i < n; i++) {
        vec3 p = ray_at(r, (real)wall[i].t);
        walk_crossing(&g, (double)p.x, (double)p.y, wall[i].axis);
    }
    figure_dot(&g, ox, oy, 4, FIGURE_RED), figure_dot(&g, ex, ey, 6, FIGURE_GREEN);
    figure_text(&g, ox, oy, -4, -10, FIGURE_LEFT, FIGURE_RED, "*o*");
    figure_text(&g, 9.9, 1.5, 8, 4, FIGURE_LEFT, FIGURE_BLACK, "a");
    figure_text(&g, 11.3, 3.45, -4, -4, FIGURE_RIGHT, FIGURE_BLACK, "b");
    figure_line(&g, ex, ey, ex, -1.5, FIGURE_GREEN, 1, FIGURE_DASHED);
    figure_text(&g, ex, -1.5, 0, 15, FIGURE_MIDDLE, FIGURE_GREEN, "_t_ of the hit");
    for (int axis = 0; axis < 2; axis++) walk_t_axis(&g, wall, n, axis, ox, 12.3);
    figure_end(&g);
    mesh_free(&m);
}

#endif
