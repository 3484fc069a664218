/* figure.h: a k-d tree in the plane beside its nodes, and one ray through both.
 *
 *   draw_figure(o)      images/12_kdtree_figure.svg
 *
 * The tree is built by kdtree_build, four cuts deep, by the surface area heuristic, of high walls
 * (09_aabb/trials/plane.h): so high that area stands for the outline of a cell in the plane, and no
 * plane lies across z. The line below shows the parts of the ray in the cells: (12.5), as the
 * search has them.
 */
#ifndef KDTREE_FIGURE_H
#define KDTREE_FIGURE_H

#include "../../09_aabb/trials/plane.h"
#include "../kdtree.h"

typedef struct { kdtree t; plane_tree plane; figure g; int leaf; } kdtree_figure;

/* ---------------------------------------------------------------------------------------------- */

static inline void figure_cells(kdtree_figure *f, uint32_t at, vec3 lo, vec3 hi)
{
    kd_node n = f->t.node[at];
    if (kd_is_leaf(n)) {
        const vec3 q[4] = {lo, {hi.x, lo.y, 0}, hi, {lo.x, hi.y, 0}};
        plane_add(&f->plane, q, 4, kd_count(n) > 0);
        return;
    }
    real cut = (real)n.plane;
    figure_cells(f, kd_lower(n), lo, vwith(hi, kd_axis(n), cut));
    figure_cells(f, kd_lower(n) + 1, vwith(lo, kd_axis(n), cut), hi);
}

static inline bool figure_node_passed(const kdtree_figure *f, int from, int to)
{
    for (int i = from; i < to; i++)
        if (f->plane.cell[i].rank) return true;
    return false;
}

/* The node and all below it; its x. Leaves come in the order of figure_cells. */
static inline double figure_tree(kdtree_figure *f, uint32_t at, int depth)
{
    kd_node n = f->t.node[at];
    double y = -depth, x[2], step = 0.62;
    if (kd_is_leaf(n)) {
        const plane_cell *c = &f->plane.cell[f->leaf];
        double here = step * f->leaf++, r = 0.24;
        const double xy[8] = {here - r, y - r, here + r, y - r, here + r, y + r, here - r, y + r};
        figure_polygon(&f->g, 4, xy, plane_colour(c), c->rank ? c->full ? 0.75 : 0.25 : 0.3,
                       FIGURE_GREY);
        if (c->rank) figure_print(&f->g, here, y, 0, 5, FIGURE_MIDDLE, FIGURE_BLACK, "%d", c->rank);
        return here;
    }
    int begin = f->leaf, middle = 0;
    for (uint32_t k = 0; k < 2; k++) {
        x[k] = figure_tree(f, kd_lower(n) + k, depth + 1);
        if (k == 0) middle = f->leaf;
    }
    double here = (x[0] + x[1]) / 2;
    for (int k = 0; k < 2; k++) {
        bool passed = figure_node_passed(f, k ? middle : begin, k ? f->leaf : middle);
        figure_line(&f->g, here, y - 0.24, x[k], y - 0.76, passed ? FIGURE_RED : FIGURE_GREY,
                    passed ? 2 : 1, FIGURE_WHOLE);
    }
    figure_text(&f->g, here, y, 0, 5, FIGURE_MIDDLE, FIGURE_BLACK, kd_axis(n) ? "_y_" : "_x_");
    return here;
}

/* The parts of the ray in its cells, one behind the other. */
static inline void figure_parts(kdtree_figure *f, double length)
{
    const plane_tree *p = &f->plane;
    figure *g = &f->g;
    double unit = length / (double)p->h.t;
    figure_arrow(g, 0, 0, length + 30, 0, FIGURE_BLACK, 1);
    figure_text(g, length + 36, 0, 0, 5, FIGURE_LEFT, FIGURE_BLACK, "_t_");
    figure_line(g, 0, 0, length, 0, FIGURE_RED, 3, FIGURE_WHOLE);
    for (int i = 0; i < p->cells; i++) {
        if (!p->cell[i].rank) continue;
        double from = unit * (double)p->cell[i].enter, to = length;
        for (int k = 0; k < p->cells; k++)
            if (p->cell[k].rank == p->cell[i].rank + 1) to = unit * (double)p->cell[k].enter;
        figure_line(g, from, -7, from, 7, FIGURE_BLACK, 1, FIGURE_WHOLE);
        figure_print(g, (from + to) / 2, 0, 0, -9, FIGURE_MIDDLE, FIGURE_BLACK, "%d",
                     p->cell[i].rank);
    }
    figure_dot(g, length, 0, 4, FIGURE_BLACK);
    figure_text(g, 0, 0, 0, 24, FIGURE_MIDDLE, FIGURE_BLACK, "_t_~enter~");
    figure_text(g, length, 0, 0, 24, FIGURE_MIDDLE, FIGURE_BLACK, "hit");
}

cold_inline void draw_figure(const options *o)
{
    static kdtree_figure f;
    kdtree_options how = kdtree_defaults;
    failure why;
    mesh m = plane_walls(1000);
    items x = items_of_mesh(&m);
    how.depth = 4, how.item_cost = 2;
    if (!kdtree_build(&x, how, &f.t, &why)) fail(why);
    f.plane.r = plane_ray(1000), f.plane.h = hit_none;
    kdtree_hit(&f.t, f.plane.r, &f.plane.h);
    const kd_box *b = &f.t.box;
    figure_cells(&f, 0, vec(b->lo[0], b->lo[1], 0), vec(b->hi[0], b->hi[1], 0));
    plane_order(&f.plane);
    f.g = figure_begin(o, "12_kdtree_figure.svg", 800, 480);
    figure_origin(&f.g, 10, 400, 40), plane_draw(&f.g, &f.plane, &m);
    figure_origin(&f.g, 452, 60, 43), figure_tree(&f, 0, 0);
    figure_origin(&f.g, 40, 440, 1), figure_parts(&f, 660);
    figure_end(&f.g);
    kdtree_free(&f.t), mesh_free(&m);
}

#endif
