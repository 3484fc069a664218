/* pixel.h: one pixel's ray, all of it: the boxes that it enters, passes and leaves, the triangles
 * that it asks, its hit and how far that is off. In words, lines with the number of their equation.
 *
 *   pixel_explain(&o, &m, how, z_up, "320,200")   that pixel's middle, columns and rows from 0
 *
 * The walk here is tree_search (search.h) as a recursion, so that it can speak; that both do the
 * same is tested each time: the same hit, as many boxes, as many triangles. The error of t is
 * against the triangle's plane in 30 digits.
 */
#ifndef BVH_PIXEL_H
#define BVH_PIXEL_H

#include "../../../common/lab/explain.h"
#include "../../../common/numbers/wide.h"
#include "../../09_aabb/trials/pictures.h"
#include "../bvh_mesh.h"

typedef struct { const bvh_mesh *b; box_ray ray; query q; search_work work; } pixel_walk;

/* ---------------------------------------------------------------------------------------------- */

/* Tests the box of a node; true if the ray meets it before the best hit so far. */
static inline bool pixel_box(pixel_walk *w, uint32_t node, int depth, float *enter)
{
    const bvh_node *n = &w->b->tree.node[node];
    double t = 1 / (double)w->ray.scale;
    float exit, limit = box_ray_limit(&w->ray, w->q.r.tmax);
    *enter = box_enter(n, &w->ray, INFINITY, &exit);
    if (*enter > exit)
        return explain_line(depth, "(9.5)", "box %u: missed, and all that is in it", node), false;
    if (*enter > limit)
        return explain_line(depth, "(7.1)", "box %u: begins at t = %.6g, behind the hit", node,
                            (double)*enter * t), false;
    explain_line(depth, "(14.2)", "box %u%s: the ray is in it from t = %.6g to %.6g", node,
                 n->count ? ", a leaf" : "", (double)*enter * t, (double)exit * t);
    return true;
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
    bool in[2] = {pixel_box(w, n->first, depth, &enter[0]),
                  pixel_box(w, n->first + 1, depth, &enter[1])};
    uint32_t near = in[0] && in[1] && enter[1] < enter[0];  /* that is first */
    for (uint32_t k = 0; k < 2; k++) {
        uint32_t child = k ^ near;
        if (!in[child]) continue;
        if (k && enter[child] > box_ray_limit(&w->ray, w->q.r.tmax)) {
            explain_line(depth, "(7.1)", "box %u: not opened, the hit lies before it",
                         n->first + child);
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

static inline void pixel_explain(const options *o, const mesh *m, bvh_options how, bool z_up,
                                 const char *text)
{
    int xy[2];
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
    pixel_walk w = {.b = &b, .q = query_of(r)};

    printf("# The ray of pixel %d, %d of %d x %d, %zu triangles\n", xy[0], xy[1], o->width,
           o->height, m->triangles);
    explain_line(0, "(2.5)", "o = (%.6g, %.6g, %.6g), d = (%.6g, %.6g, %.6g)", (double)r.o.x,
                 (double)r.o.y, (double)r.o.z, (double)r.d.x, (double)r.d.y, (double)r.d.z);
    explain_line(0, "(1.2), (1.4)", "p(t) = o + t d, t from %g to %g", (double)r.tmin,
                 (double)r.tmax);
    if (b.tree.items) w.ray = box_ray_of(r, b.tree.node, NULL);
    if (b.tree.items && pixel_box(&w, 0, 0, &enter)) pixel_visit(&w, 0, 1);

    bool found = bvh_mesh_hit_counted(&b, r, &h, &work);
    hit best = w.q.best;
    if ((found ? h.shape : no_shape) != best.shape || (found && h.t != best.t)
        || work.nodes != w.work.nodes || work.tests != w.work.tests)
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
    bvh_mesh_free(&b);
}

#endif
