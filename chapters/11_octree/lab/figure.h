/* figure.h: the quadtree (四叉树), the flat picture of the octree, with a ray and its cells numbered.
 *
 *   draw_quadtree(o)         images/11_octree_quadtree.svg
 *
 * Not a second structure: an octree of walls that stand on the plane z = 0, so low that only its
 * lowest layer of cells holds anything. In the plane it is a quadtree. Blue cells hold walls, white
 * ones none; numbers: the leaves in the order in which octree_hit asks them.
 */
#ifndef OCTREE_FIGURE_H
#define OCTREE_FIGURE_H

#include "../../../common/output.h"
#include "../octree.h"

static inline mesh figure_walls(void);           /* mesh_free */
static inline void draw_quadtree(const options *o);

/* ---------------------------------------------------------------------------------------------- */

enum { figure_side = 640, figure_walls_n = 240 };

/* Segments of curves from (x, y) to (x', y'), each a triangle that stands on it, 2^-12 high. */
static inline mesh figure_walls(void)
{
    mesh m = {.vertices = 3 * figure_walls_n, .triangles = figure_walls_n};
    m.v = allocate(m.vertices, sizeof *m.v);
    m.index = allocate(m.vertices, sizeof *m.index);
    for (int i = 0; i < figure_walls_n; i++) {
        vec3 p[2];
        for (int k = 0; k < 2; k++) {
            real a = (real)(i + k) / 80;  /* a ring and a wave */
            if (i < 80) p[k] = (vec3){(real)0.76 + (real)0.15 * cos(2 * pi * a),
                                      (real)0.68 + (real)0.15 * sin(2 * pi * a), 0};
            else p[k] = (vec3){(real)0.1 + (real)0.36 * (a - 1),
                                           (real)0.31 - (real)0.24 * cos(4 * (a - 1)), 0};
        }
        m.v[3 * i] = p[0], m.v[3 * i + 1] = p[1];
        m.v[3 * i + 2] = vadd(p[0], (vec3){0, 0, 0x1p-12});
        for (int k = 0; k < 3; k++) m.index[3 * i + k] = (uint32_t)(3 * i + k);
    }
    return m;
}

/* Place of p on the page: the cube of t fills it. */
static inline vec3 figure_place(const octree *t, vec3 p)
{
    real s = (real)figure_side / t->size;
    return (vec3){s * (p.x - t->lo.x), (real)figure_side - s * (p.y - t->lo.y), 0};
}

static inline void figure_line(FILE *out, const octree *t, vec3 p, vec3 q, const char *style)
{
    vec3 a = figure_place(t, p), b = figure_place(t, q);
    fprintf(out, "<path d=\"M%.2f,%.2fL%.2f,%.2f\" %s/>\n", (double)a.x, (double)a.y, (double)b.x,
            (double)b.y, style);
}

/* The leaves of the lowest layer; those on the trail with their place in it. */
static inline void figure_cells(FILE *out, const octree *t, uint32_t node, octree_cell c,
                                const octree_trail *trail)
{
    octree_node n = t->node[node];
    int place = 0;
    if (n.kind && !(n.kind & octree_is_leaf)) {
        for (unsigned k = 0; k < 4; k++)
            figure_cells(out, t, n.first + k, octree_child_cell(c, k), trail);
        return;
    }
    aabb b = octree_cell_box(t, c);
    vec3 low = figure_place(t, b.lo), high = figure_place(t, b.hi);
    double x = (double)low.x, y = (double)high.y, w = (double)(high.x - low.x);
    for (int i = 0; i < trail->n; i++)
        if (trail->node[i] == node) place = i + 1;
    fprintf(out, "<rect x=\"%.2f\" y=\"%.2f\" width=\"%.2f\" height=\"%.2f\" fill=\"%s\" "
            "stroke=\"#888\" stroke-width=\"0.7\"/>\n", x, y, w, w,
            place ? "#ffd9a0" : n.kind ? "#dceaf6" : "white");
    if (place)
        fprintf(out, "<text x=\"%.2f\" y=\"%.2f\" font-size=\"%.1f\" fill=\"#333\">%d</text>\n",
                x + 3, y + w - 4, w < 30 ? 0.6 * w : 17.0, place);
}

static inline void draw_quadtree(const options *o)
{
    mesh m = figure_walls();
    items x = items_of_mesh(&m);
    octree t;
    octree_trail trail = {{0}, 0};
    failure f;
    file_writer w;
    char room[512];
    hit h = hit_none;
    const char *path = output_path(o, "11_octree_quadtree.svg", false, room);
    if (!path) { mesh_free(&m); return; }
    if (!octree_build(&x, (octree_options){4, 5, true, true, (size_t)1 << 20}, &t, &f)) fail(f);
    ray r = ray_from(vec(0.425, 0.6, 0), vec(0.4, -1, 0));
    bool found = octree_walk(&t, r, false, 1, &h, NULL, &trail);
    if (!file_begin(&w, path, &f)) fail(f);
    fprintf(w.stream, "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-4 -4 %d %d\" "
            "width=\"%d\" height=\"%d\" "
            "font-family=\"sans-serif\">\n<rect x=\"-4\" y=\"-4\" width=\"%d\" height=\"%d\" "
            "fill=\"white\"/>\n", figure_side + 8, figure_side + 8, figure_side + 8,
            figure_side + 8, figure_side + 8, figure_side + 8);
    figure_cells(w.stream, &t, 0, (octree_cell){0, 0, 0, 0}, &trail);
    for (size_t i = 0; i < m.triangles; i++)
        figure_line(w.stream, &t, m.v[3 * i], m.v[3 * i + 1],
                    "stroke=\"#0072b2\" stroke-width=\"2.5\"");
    figure_line(w.stream, &t, r.o, ray_at(r, found ? h.t : 1),
                "stroke=\"#d55e00\" stroke-width=\"2\"");
    fprintf(w.stream, "</svg>\n");
    if (!file_commit(&w, &f)) fail(f);
    octree_free(&t);
    mesh_free(&m);
}

#endif
