/* quadtree.h: the quadtree (四叉树), the octree in the plane, with a ray and its cells numbered.
 *
 *   draw_quadtree(o)         images/11_octree_quadtree.svg
 *
 * Not a second structure: an octree of walls that stand on the plane z = 0, so low that only its
 * lowest layer of cells holds anything. In the plane it is a quadtree. Blue cells hold walls, white
 * ones none; numbers: the leaves in the order in which octree_hit asks them.
 */
#ifndef OCTREE_QUADTREE_H
#define OCTREE_QUADTREE_H

#include "../../../common/lab/figure.h"
#include "../../07_mesh/scenes/soup.h"
#include "../octree.h"

enum { quadtree_side = 640, quadtree_walls = 240 };

/* ---------------------------------------------------------------------------------------------- */

/* Segments of a ring and of a wave, each a triangle that stands on it, 2^-12 high. */
static inline mesh quadtree_mesh(void)
{
    mesh m = mesh_room(quadtree_walls);
    for (int i = 0; i < quadtree_walls; i++) {
        vec3 *p = m.v + 3 * i;
        for (int k = 0; k < 2; k++) {
            real a = (real)(i + k) / 80;
            if (i < 80) p[k] = (vec3){(real)0.76 + (real)0.15 * cos(2 * pi * a),
                                      (real)0.68 + (real)0.15 * sin(2 * pi * a), 0};
            else p[k] = (vec3){(real)0.1 + (real)0.36 * (a - 1),
                               (real)0.31 - (real)0.24 * cos(4 * (a - 1)), 0};
        }
        p[2] = vadd(p[0], (vec3){0, 0, 0x1p-12});
    }
    return m;
}

/* The leaves of the lowest layer; or, to lie upon the curves, the places of those on the trail. */
static inline void quadtree_cells(figure *g, const octree *t, uint32_t node, octree_cell c,
                                  const octree_trail *trail, bool places)
{
    octree_node n = t->node[node];
    int place = 0;
    if (n.kind && !(n.kind & octree_is_leaf)) {
        for (unsigned k = 0; k < 4; k++)
            quadtree_cells(g, t, n.first + k, octree_child_cell(c, k), trail, places);
        return;
    }
    aabb b = octree_cell_box(t, c);
    double x = (double)b.lo.x, y = (double)b.lo.y, X = (double)b.hi.x, Y = (double)b.hi.y;
    for (int i = 0; i < trail->n; i++)
        if (trail->node[i] == node) place = i + 1;
    if (places && place) figure_print(g, x, y, 2, -4, FIGURE_LEFT, FIGURE_BLACK, "*%d*", place);
    if (places) return;
    figure_polygon(g, 4, (double[8]){x, y, X, y, X, Y, x, Y}, place ? FIGURE_SKY : FIGURE_GREY,
                   place ? 0.75 : n.kind ? 0.2 : 0, FIGURE_GREY);
}

static inline void quadtree_line(figure *g, vec3 a, vec3 b, const char *colour, double width)
{
    figure_line(g, (double)a.x, (double)a.y, (double)b.x, (double)b.y, colour, width,
                FIGURE_WHOLE);
}

cold_inline void draw_quadtree(const options *o)
{
    static const char *const legend[3] = {"an empty leaf", "a leaf with curves in it",
                                          "asked by the ray, in this order"};
    static const double opacity[3] = {0, 0.2, 0.75};
    mesh m = quadtree_mesh();
    items x = items_of_mesh(&m);
    octree t;
    octree_trail trail = {{0}, 0};
    failure f;
    hit h = hit_none;
    if (!octree_build(&x, (octree_options){4, 5, true, true, (size_t)1 << 20}, &t, &f)) fail(f);
    ray r = ray_from(vec(0.425, 0.6, 0), vec(0.4, -1, 0));
    octree_walk(&t, r, false, 1, &h, NULL, &trail);
    figure g = figure_begin(o, "11_octree_quadtree.svg", quadtree_side + 20, quadtree_side + 50);
    figure_origin(&g, 10, 15, 1);
    for (int k = 0; k < 3; k++) {
        double at = (double[3]){0, 145, 355}[k];
        figure_polygon(&g, 4, (double[8]){at, 0, at + 16, 0, at + 16, -16, at, -16},
                       k == 2 ? FIGURE_SKY : FIGURE_GREY, opacity[k], FIGURE_GREY);
        figure_text(&g, at, 0, 24, 14, FIGURE_LEFT, FIGURE_BLACK, legend[k]);
    }
    double unit = quadtree_side / (double)t.size;
    figure_origin(&g, 10 - unit * (double)t.lo.x, 40 + quadtree_side + unit * (double)t.lo.y, unit);
    quadtree_cells(&g, &t, 0, (octree_cell){0, 0, 0, 0}, &trail, false);
    for (size_t i = 0; i < m.triangles; i++)
        quadtree_line(&g, m.v[3 * i], m.v[3 * i + 1], FIGURE_BLACK, 2.5);
    vec3 end = ray_at(r, h.t);
    quadtree_line(&g, r.o, end, FIGURE_RED, 2);
    quadtree_cells(&g, &t, 0, (octree_cell){0, 0, 0, 0}, &trail, true);
    figure_dot(&g, (double)r.o.x, (double)r.o.y, 4, FIGURE_RED);
    figure_text(&g, (double)r.o.x, (double)r.o.y, 8, -4, FIGURE_LEFT, FIGURE_RED, "*o*");
    figure_dot(&g, (double)end.x, (double)end.y, 4, FIGURE_BLACK);
    figure_text(&g, (double)end.x, (double)end.y, 10, 0, FIGURE_LEFT, FIGURE_BLACK, "hit");
    figure_end(&g);
    octree_free(&t), mesh_free(&m);
}

#endif
