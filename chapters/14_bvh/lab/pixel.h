/* pixel.h: one pixel's ray, all of it: the boxes that it enters, passes and leaves, the triangles
 * that it asks, its hit and how far that is off. In words, lines with the number of their equation,
 * and as a drawing along t.
 *
 *   bvh_explain(&o, &m, how, z_up, "320,200")     that pixel's middle, columns and rows from 0;
 *                                                 the drawing goes to build/14_bvh_pixel.svg
 *
 * The walk here is tree_search (search.h) as a recursion, so that it can speak; that both do the
 * same is tested each time: the same hit, as many boxes, as many triangles. The error of t is
 * against the triangle's plane in 30 digits.
 */
#ifndef BVH_PIXEL_H
#define BVH_PIXEL_H

#include "../../../common/lab/explain.h"
#include "../../../common/lab/figure.h"
#include "../../../common/numbers/wide.h"
#include "../../09_aabb/trials/pictures.h"
#include "../bvh_mesh.h"

typedef enum { PIXEL_MISSED, PIXEL_DROPPED, PIXEL_ENTERED, PIXEL_LEAF } pixel_fate;
typedef struct { uint32_t node; int depth; double enter, exit; pixel_fate fate; } pixel_row;

enum { pixel_most_rows = 400 };
typedef struct {
    const bvh_mesh *b;
    box_ray ray;
    query q;
    search_work work;
    pixel_row row[pixel_most_rows];  /* boxes in the order in which they are tested */
    int rows;
} pixel_walk;

/* ---------------------------------------------------------------------------------------------- */

/* Tests the box of a node; true if the ray meets it before the best hit so far. */
static inline bool pixel_box(pixel_walk *w, uint32_t node, int depth, float *enter)
{
    const bvh_node *n = &w->b->tree.node[node];
    double t = 1 / (double)w->ray.scale;
    float exit, limit = box_ray_limit(&w->ray, w->q.r.tmax);
    *enter = box_enter(n, &w->ray, INFINITY, &exit);
    pixel_row row = {node, depth, (double)*enter * t, (double)exit * t,
                     *enter > exit ? PIXEL_MISSED : *enter > limit ? PIXEL_DROPPED
                     : n->count ? PIXEL_LEAF : PIXEL_ENTERED};
    if (w->rows < pixel_most_rows) w->row[w->rows++] = row;
    if (row.fate == PIXEL_MISSED)
        explain_line(depth, "(9.5)", "box %u: missed, and all that is in it", node);
    else if (row.fate == PIXEL_DROPPED)
        explain_line(depth, "(7.1)", "box %u: begins at t = %.6g, behind the hit", node, row.enter);
    else explain_line(depth, "(14.2)", "box %u%s: the ray is in it from t = %.6g to %.6g", node,
                      n->count ? ", a leaf" : "", row.enter, row.exit);
    return row.fate >= PIXEL_ENTERED;
}

static inline void pixel_leaf(pixel_walk *w, const bvh_node *n, int depth)
{
    w->work.leaves++;
    for (uint32_t i = n->first; i < n->first + n->count; i++) {
        uint32_t index = w->b->triangle[i].index;
        hit before = w->q.best;
        w->work.tests++;
        if (!bvh_mesh_leaf(w->b, i, 1, &w->q, false) || !hit_before(w->q.best, before))
            explain_line(depth, "", "triangle %u: no", index);
        else explain_line(depth, "(4.8)", "triangle %u: hit at t = %.6g, u = %.4g, v = %.4g", index,
                          (double)w->q.best.t, (double)w->q.best.u, (double)w->q.best.v);
    }
}

static inline void pixel_visit(pixel_walk *w, uint32_t node, int depth)
{
    const bvh_node *n = &w->b->tree.node[node];
    float enter[2];
    if (n->count) {
        pixel_leaf(w, n, depth);
        return;
    }
    w->work.nodes++;
    int row = w->rows;
    bool in[2] = {pixel_box(w, n->first, depth, &enter[0]),
                  pixel_box(w, n->first + 1, depth, &enter[1])};
    uint32_t near = in[0] && in[1] && enter[1] < enter[0];  /* that is first */
    for (uint32_t k = 0; k < 2; k++) {
        uint32_t child = k ^ near;
        if (!in[child]) continue;
        if (k && enter[child] > box_ray_limit(&w->ray, w->q.r.tmax)) {
            explain_line(depth, "(7.1)", "box %u: not opened, the hit lies before it",
                         n->first + child);
            if (row + (int)child < w->rows) w->row[row + (int)child].fate = PIXEL_DROPPED;
            continue;
        }
        if (in[0] && in[1])
            explain_line(depth, k ? "" : "(14.1)", "box %u %s", n->first + child,
                         k ? "after it" : "first: the ray enters it first");
        pixel_visit(w, n->first + child, depth + 1);
    }
}

/* t of the triangle's plane, (a - o) . n / (d . n), to 30 digits. */
static inline double pixel_exact_t(triangle tri, ray r)
{
    wide3 a = wide3_of(tri.a), e = wide3_sub(wide3_of(tri.b), a), f = wide3_sub(wide3_of(tri.c), a);
    wide3 n = wide3_cross(e, f);
    return wide_value(wide_div(wide3_dot(wide3_sub(a, wide3_of(r.o)), n),
                               wide3_dot(wide3_of(r.d), n)));
}

/* A row a box, from where to where the ray is in it; the hit as a line down through all of them. */
static inline void pixel_draw(const options *o, const pixel_walk *w, const char *title)
{
    static const char *const colour[] = {FIGURE_GREY, FIGURE_ORANGE, FIGURE_SKY, FIGURE_GREEN};
    static const char *const says[] = {"missed", "behind the hit", "entered", "a leaf, asked"};
    char room[512];
    double from = real_largest, to = 0, step = 17;
    for (int i = 0; i < w->rows; i++) {
        if (w->row[i].fate == PIXEL_MISSED) continue;
        from = fmin(from, w->row[i].enter), to = fmax(to, w->row[i].exit);
    }
    if (!(to > from)) return;
    double scale = 560 / (to - from);
    figure g = figure_at(output_path(o, "14_bvh_pixel.svg", true, room), 960,
                         (int)(step * w->rows) + 100);
    figure_origin(&g, 20, 24, 1);
    figure_text(&g, 0, 0, 0, 0, FIGURE_LEFT, FIGURE_BLACK, title);
    for (int k = 0; k < 4; k++)
        figure_text(&g, 320 + 150 * k, 0, 0, 22, FIGURE_LEFT, colour[k], says[k]);
    for (int i = 0; i < w->rows; i++) {
        const pixel_row *row = &w->row[i];
        double y = -44 - step * i, x0 = 350 + scale * (row->enter - from);
        double x1 = 350 + scale * (row->exit - from);
        double bar[8] = {x0, y - 4, x1, y - 4, x1, y + 8, x0, y + 8};
        figure_print(&g, 10 * row->depth, y, 0, 4, FIGURE_LEFT, colour[row->fate], "box %u",
                     row->node);
        if (row->fate != PIXEL_MISSED) figure_polygon(&g, 4, bar, colour[row->fate], 0.7, NULL);
    }
    double x = 350 + scale * ((double)w->q.best.t - from), end = -50 - step * w->rows;
    if (w->q.best.shape != no_shape) {
        figure_line(&g, x, -36, x, end, FIGURE_RED, 1.5, FIGURE_WHOLE);
        figure_print(&g, x, end, 0, 18, FIGURE_MIDDLE, FIGURE_RED, "_t_ = %.6g",
                     (double)w->q.best.t);
    }
    figure_end(&g);
}

cold_inline void bvh_explain(const options *o, const mesh *m, bvh_options how, bool z_up,
                             const char *text)
{
    int xy[2];
    char title[80];
    vec3 lo, hi;
    bvh_mesh b;
    failure f;
    hit h = hit_none;
    float enter;
    search_work work = {0, 0, 0, 0};
    explain_pixel(text, o->width, o->height, xy);
    if (!bvh_mesh_build(m, how, &b, &f)) fail(f);
    mesh_bounds(m, &lo, &hi);
    camera c = camera_of(lo, hi, z_up, (real)o->width / (real)o->height);
    ray r = camera_ray(c, (real)xy[0] + (real)0.5, (real)xy[1] + (real)0.5, o->width, o->height);
    snprintf(title, sizeof title, "Pixel %d, %d of %d x %d: its ray along _t_", xy[0], xy[1],
             o->width, o->height);
    pixel_walk *w = allocate(1, sizeof *w);
    w->b = &b, w->q = query_of(r);

    printf("# The ray of pixel %d, %d of %d x %d, %zu triangles\n", xy[0], xy[1], o->width,
           o->height, m->triangles);
    explain_line(0, "(2.5)", "o = (%.6g, %.6g, %.6g), d = (%.6g, %.6g, %.6g)", (double)r.o.x,
                 (double)r.o.y, (double)r.o.z, (double)r.d.x, (double)r.d.y, (double)r.d.z);
    explain_line(0, "(1.2), (1.4)", "p(t) = o + t d, t from %g to %g", (double)r.tmin,
                 (double)r.tmax);
    if (b.tree.items) w->ray = box_ray_of(r, b.tree.node, NULL);
    if (b.tree.items && pixel_box(w, 0, 0, &enter)) pixel_visit(w, 0, 1);

    bool found = bvh_mesh_hit_counted(&b, r, &h, &work);
    hit best = w->q.best;
    if ((found ? h.shape : no_shape) != best.shape || (found && h.t != best.t)
        || work.nodes != w->work.nodes || work.tests != w->work.tests)
        die(1, "--pixel: this walk is not that of search.h");
    if (found) {
        vec3 p = ray_at(r, h.t);
        double t = pixel_exact_t(mesh_triangle(m, h.shape), r);
        explain_line(0, "(7.1)", "hit: triangle %u at t = %.17g, p = (%.6g, %.6g, %.6g)", h.shape,
                     (double)h.t, (double)p.x, (double)p.y, (double)p.z);
        explain_line(0, "", "off by %.2g of t, by the plane in 30 digits",
                     fabs((double)h.t - t) / t);
    } else printf("no hit\n");
    printf("%zu pairs of boxes and %zu triangles, of %zu\n", work.nodes, work.tests, m->triangles);
    pixel_draw(o, w, title);
    bvh_mesh_free(&b);
    free(w);
}

#endif
