/* regimes.h: where the verdict might change: the order of rays and all cores (ray_order.h), motion.
 *
 *   regimes_run(&c)          tables and a plot; false: a wrong hit
 *
 * Motion (motion.h): a teapot is twisted in 60 frames, and there are four ways to keep its BVH:
 * built anew by the heuristic or by Morton codes, refitted, refitted with rotations
 * (14_bvh/refit.h). In every frame all four are held against each other, ray by ray, before
 * anything is timed. A frame of k rays takes b + k c (17.8), where b is now paid each frame.
 */
#ifndef COMPARE_LAB_REGIMES_H
#define COMPARE_LAB_REGIMES_H

#include "../../07_mesh/scenes/motion.h"
#include "../../14_bvh/refit.h"
#include "ray_order.h"

/* ---------------------------------------------------------------------------------------------- */

typedef enum { KEEP_SAH, KEEP_MORTON, KEEP_REFIT, KEEP_ROTATE, keepings } keeping;
static const char *const keeping_name[keepings] = {
    "anew, heuristic", "anew, Morton codes", "refitted", "refitted, rotated"};
enum { motion_frames = 60, motion_last = 10 };

typedef struct {
    bvh tree;
    size_t wrong;
    search_work work;                                        /* of the last frame */
    double frame[motion_frames], ray[motion_frames];         /* seconds */
    double b, c;                                             /* at last, as in (17.8) */
} kept_tree;

static inline void kept_frame(kept_tree *x, keeping how, const items *now)
{
    bvh_options rules = bvh_defaults;
    failure f;
    if (how == KEEP_MORTON) rules.rule = "morton";
    if (how >= KEEP_REFIT) bvh_mesh_refit(&x->tree.mesh, now->m, how == KEEP_ROTATE);
    else {
        bvh_free(&x->tree);
        if (!bvh_build(now, rules, &x->tree, &f)) fail(f);
    }
}

/* Counts, times and proves the rays of a frame; due: hits of the tree built anew, the first. */
static inline void kept_rays(kept_tree *x, int frame, const ray_set *rays, hit *due, bool first)
{
    hit *h = allocate(rays->n, sizeof *h);
    x->work = (search_work){0, 0, 0, 0};
    for (size_t i = 0; i < rays->n; i++)
        bvh_contender.counted(&x->tree, rays->r[i], false, &h[i], &x->work);
    double start = work_seconds();
    bvh_contender.search(&x->tree, rays->r, rays->n, false, first ? due : h);
    x->ray[frame] = (work_seconds() - start) / (double)rays->n;
    for (size_t i = 0; i < rays->n && !first; i++) x->wrong += !hits_same(h[i], due[i]);
    free(h);
}

/* Work and times of the last frames, and time by rays a frame. */
static inline void motion_print(kept_tree x[keepings], size_t rays, const char *title,
                                html_report *to)
{
    const int last = motion_frames - motion_last;
    table t = table_new(title, "boxes|nodes/ray|tests/ray|a frame [ms]|a ray [ns]");
    plot time = plot_new("A frame and its rays: twist", "rays a frame", "time a frame [ms]",
                         PLOT_LOG_X | PLOT_LOG_Y);
    for (int k = 0; k < keepings; k++) {
        int s = plot_series(&time, keeping_name[k]);
        x[k].b = clock_median(x[k].frame + last, motion_last);
        x[k].c = clock_median(x[k].ray + last, motion_last);
        table_text(&t, "%s", keeping_name[k]);
        table_number(&t, per((double)x[k].work.nodes, rays));
        table_number(&t, per((double)x[k].work.tests, rays));
        table_number(&t, x[k].b * 1e3), table_number(&t, x[k].c * 1e9);
        for (int half = 4; half <= 12; half++) {
            double n = pow(10, half / 2.0);
            plot_add(&time, s, n, (x[k].b + n * x[k].c) * 1e3);
        }
    }
    html_table(to, &t);
    html_plot(to, &time, "17_compare_twist_time.svg");
}

/* Rays from all around, anew each frame, of the kind that meets all of the mesh. */
static inline bool motion_run(const options *o, html_report *to)
{
    mesh rest = motion_mesh(MOTION_TWIST, o->quick ? 2 : 12);
    world w;
    failure f;
    char title[160];
    size_t wrong = 0, n = 0;
    if (!mesh_world(&w, "twist", motion_mesh(MOTION_TWIST, o->quick ? 2 : 12), true, &f)) fail(f);
    items now = items_of_mesh(&w.mesh);
    kept_tree *x = allocate(keepings, sizeof *x);
    for (int k = KEEP_REFIT; k < keepings; k++) kept_frame(&x[k], KEEP_SAH, &now);  /* at rest */
    for (int i = 0; i < motion_frames; i++) {
        motion_frame(MOTION_TWIST, &rest, (real)(i + 1) / motion_frames, &w.mesh);
        ray_set rays = rays_everywhere(&w, o->quick ? 100 : 4000, o->seed + (uint64_t)i);
        hit *due = allocate(n = rays.n, sizeof *due);
        for (keeping k = 0; k < keepings; k++) {
            double start = work_seconds();
            kept_frame(&x[k], k, &now);
            x[k].frame[i] = work_seconds() - start;
        }
        for (keeping k = 0; k < keepings; k++) kept_rays(&x[k], i, &rays, due, k == 0);
        free(due), rays_free(&rays);
    }
    snprintf(title, sizeof title, "Moving, twist: %zu triangles, the last of %d frames",
             rest.triangles, (int)motion_frames);
    motion_print(x, n, title, to);
    for (int k = 0; k < keepings; k++) wrong += x[k].wrong, bvh_free(&x[k].tree);
    html_note(to, "%d frames, %zu rays each: %zu wrong hits", (int)motion_frames, n, wrong);
    printf("\n");
    free(x), mesh_free(&rest), world_free(&w);
    return wrong == 0;
}

static inline bool regimes_run(const compare_settings *c)
{
    html_element(c->to, "h2", "Regimes");
    order_run(c);
    return motion_run(c->o, c->to);
}

#endif
