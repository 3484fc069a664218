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
    bvh_mesh tree;
    size_t rays, wrong;
    search_work work;                                        /* of the last frame */
    double frame[motion_frames], ray[motion_frames];         /* seconds */
    double b, c;                                             /* at last, as in (17.8) */
} kept_tree;

static inline void kept_frame(kept_tree *x, keeping how, const mesh *m)
{
    bvh_options rules = bvh_defaults;
    failure f;
    if (how == KEEP_MORTON) rules.rule = "morton";
    if (how >= KEEP_REFIT) bvh_mesh_refit(&x->tree, m, how == KEEP_ROTATE);
    else {
        bvh_mesh_free(&x->tree);
        if (!bvh_mesh_build(m, rules, &x->tree, &f)) fail(f);
    }
}

/* Proves, counts and times the rays of a frame; due: hits of the tree built anew. */
static inline void kept_rays(kept_tree *x, int frame, const ray_set *rays, hit *due, bool first)
{
    x->work = (search_work){0, 0, 0, 0};
    for (size_t i = 0; i < rays->n; i++) {
        hit h = hit_none;
        bvh_mesh_hit_counted(&x->tree, rays->r[i], &h, &x->work);
        if (first) due[i] = h;
        x->wrong += !hits_same(h, due[i]);
    }
    size_t hits = 0;
    double start = work_seconds();
    for (size_t i = 0; i < rays->n; i++) {
        hit h;
        hits += bvh_mesh_hit(&x->tree, rays->r[i], &h);
    }
    x->ray[frame] = (work_seconds() - start) / (double)rays->n;
    clock_kept = (double)hits;
    x->rays = rays->n;
}

/* How long building and a ray take at last. */
static inline void kept_times(kept_tree *x)
{
    x->b = clock_median(x->frame + motion_frames - motion_last, motion_last);
    x->c = clock_median(x->ray + motion_frames - motion_last, motion_last);
}

/* Work and times of the last frames, and time by rays a frame. */
static inline void motion_print(const kept_tree x[keepings], const char *title, html_report *to)
{
    table t = table_new(title, "boxes|nodes/ray|tests/ray|a frame [ms]|a ray [ns]");
    plot time = plot_new("A frame and its rays: twist", "rays a frame", "time a frame [ms]",
                         PLOT_LOG_X | PLOT_LOG_Y);
    for (int k = 0; k < keepings; k++) {
        int s = plot_series(&time, keeping_name[k]);
        table_text(&t, "%s", keeping_name[k]);
        table_number(&t, per((double)x[k].work.nodes, x[k].rays));
        table_number(&t, per((double)x[k].work.tests, x[k].rays));
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
    int fine = o->quick ? 2 : 12;
    mesh rest = motion_mesh(MOTION_TWIST, fine);
    world w;
    failure f;
    char title[160];
    size_t wrong = 0;
    if (!mesh_world(&w, "twist", motion_mesh(MOTION_TWIST, fine), true, &f)) fail(f);
    kept_tree *x = allocate(keepings, sizeof *x);
    memset(x, 0, keepings * sizeof *x);
    for (int k = KEEP_REFIT; k < keepings; k++)
        if (!bvh_mesh_build(&rest, bvh_defaults, &x[k].tree, &f)) fail(f);
    for (int i = 0; i < motion_frames; i++) {
        motion_frame(MOTION_TWIST, &rest, (real)(i + 1) / motion_frames, &w.mesh);
        ray_set rays = rays_everywhere(&w, o->quick ? 100 : 4000, o->seed + (uint64_t)i);
        hit *due = allocate(rays.n, sizeof *due);
        for (int k = 0; k < keepings; k++) {
            double start = work_seconds();
            kept_frame(&x[k], (keeping)k, &w.mesh);
            x[k].frame[i] = work_seconds() - start;
        }
        for (int k = 0; k < keepings; k++) kept_rays(&x[k], i, &rays, due, k == 0);
        free(due), rays_free(&rays);
    }
    snprintf(title, sizeof title, "Moving, twist: %zu triangles, the last of %d frames",
             rest.triangles, (int)motion_frames);
    for (int k = 0; k < keepings; k++) kept_times(&x[k]);
    motion_print(x, title, to);
    for (int k = 0; k < keepings; k++) wrong += x[k].wrong, bvh_mesh_free(&x[k].tree);
    html_note(to, "%d frames, %zu rays each: %zu wrong hits", (int)motion_frames, x[0].rays, wrong);
    printf("\n");
    free(x), mesh_free(&rest), world_free(&w);
    return wrong == 0;
}

static inline bool regimes_run(const compare_settings *c)
{
    html_heading(c->to, "Regimes");
    order_run(c);
    return motion_run(c->o, c->to);
}

#endif
