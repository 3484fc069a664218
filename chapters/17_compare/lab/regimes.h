/* regimes.h: where the verdict might change: the order of rays, all cores, motion.
 *
 *   regimes_run(&c)          tables and a plot; false: a wrong hit
 *
 * Order: the same primary rays of a teapot in rows (coherent, 相干) and shuffled, and diffuse ones
 * (incoherent, 非相干); then these on all cores. Times are of processors, all threads together: a core
 * that waits for memory because others use it shows there, and other work of the machine hardly
 * does. Efficiency 1: n idle cores are n times as fast.
 *
 * Motion (motion.h): a teapot is twisted in 60 frames, and there are four ways to keep its BVH:
 * built anew by the heuristic or by Morton codes, refitted, refitted with rotations
 * (14_bvh/trials/refit.h). In every frame all four are held against each other, ray by ray, before
 * anything is timed. A frame of k rays takes b + k c (17.8), where b is now paid each frame.
 */
#ifndef COMPARE_LAB_REGIMES_H
#define COMPARE_LAB_REGIMES_H

#include "../../07_mesh/scenes/motion.h"
#include "../../07_mesh/scenes/named.h"
#include "../../14_bvh/trials/refit.h"
#include "costs.h"

enum { order_chunk = 256, order_rounds = 7, order_times = 4, motion_frames = 60, motion_last = 10 };
typedef struct { const compare_entry *e; const ray_set *rays; hit *out; int threads; } order_work;

typedef enum { KEEP_SAH, KEEP_MORTON, KEEP_REFIT, KEEP_ROTATE, keepings } keeping;
static const char *const keeping_name[keepings] = {
    "anew, heuristic", "anew, Morton codes", "refitted", "refitted, rotated"};
typedef struct {
    bvh tree;
    size_t wrong;
    search_work work;                                        /* of the last frame */
    double frame[motion_frames], ray[motion_frames];         /* seconds */
} kept_tree;

/* ---------------------------------------------------------------------------------------------- */

static inline void order_job(size_t i, void *context)
{
    const order_work *x = context;
    size_t first = i * order_chunk, left = x->rays->n - first;
    x->e->c->search(x->e->s, x->rays->r + first, left < order_chunk ? left : order_chunk, false,
                    x->out + first);
}

/* Of all processors together. */
static inline double order_seconds(void) { return clock_of(CLOCK_PROCESS_CPUTIME_ID); }

static inline double order_search(void *context)
{
    order_work *x = context;
    parallel_whole((x->rays->n + order_chunk - 1) / order_chunk, x->threads, "rays", order_job, x);
    return (double)x->out[0].t;
}

static inline ray_set order_shuffled(const ray_set *all, uint64_t seed)
{
    ray_set s = rays_some(all, all->n);
    random_stream g = random_start(seed, 0, 3);
    for (size_t i = s.n; i > 1; i--) {
        size_t k = random_below(&g, i);
        ray r = s.r[i - 1];
        s.r[i - 1] = s.r[k], s.r[k] = r;
    }
    return s;
}

/* The sets, of which the last is asked on so many threads, the others on one. */
static inline void order_row(table *t, const compare_entry *e, const ray_set *set[order_times],
                             hit *out, int threads)
{
    order_work work[order_times];
    bench_candidate c[order_times];
    for (int k = 0; k < order_times; k++) {
        work[k] = (order_work){e, set[k], out, k + 1 < order_times ? 1 : threads};
        c[k] = (bench_candidate){.run = order_search, .context = &work[k]};
    }
    bench_time_by(order_seconds, c, order_times, order_rounds);
    table_text(t, "%s", e->choice->label);
    for (int k = 0; k < order_times; k++) table_number(t, per(c[k].seconds * 1e9, set[k]->n));
    table_number(t, c[order_times - 2].seconds / c[order_times - 1].seconds);
}

static inline void order_run(const compare_settings *c)
{
    world w;
    comparison s;
    failure f;
    char title[120];
    const options *o = c->o;
    line_up some = choose_counting(&c->chosen);
    if (!mesh_world(&w, "teapot", teapot_mesh(o->quick ? 3 : 32), true, &f)) fail(f);
    compare_begin(&s, &w, &some, c->most_bytes, 1);
    compare_rays(&s, o->quick ? 200 : compare_usual_rays, o->seed);
    const ray_set *rows = &s.rays[KIND_PRIMARY], *diffuse = &s.rays[KIND_DIFFUSE];
    ray_set shuffled = order_shuffled(rows, o->seed);
    hit *out = allocate(rows->n + diffuse->n + 1, sizeof *out);
    out[0] = hit_none;
    snprintf(title, sizeof title, "Order and cores: %zu triangles, %zu rays of a kind; %d cores",
             w.mesh.triangles, rows->n, parallel_cores());
    table t = table_new(title, "structure|in rows [ns]|shuffled [ns]|diffuse [ns]|all cores [ns]|"
                               "efficiency");
    for (const compare_entry *e = s.entry; e < s.entry + s.entries; e++) {
        compare_progress("order and cores", "timing", e->choice->label);
        if (e->fits)
            order_row(&t, e, (const ray_set *[]){rows, &shuffled, diffuse, diffuse}, out,
                      o->threads);
    }
    compare_progress("order and cores", NULL, NULL);
    html_table(c->to, &t);
    free(out), rays_free(&shuffled);
    compare_end(&s);
    world_free(&w);
}

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
    hit *h = first ? due : allocate(rays->n, sizeof *h);
    const compare_entry e = {.c = &bvh_contender, .s = &x->tree};
    x->work = (search_work){0, 0, 0, 0};
    entry_work(&e, rays, false, &x->work);
    double start = work_seconds();
    e.c->search(e.s, rays->r, rays->n, false, h);
    x->ray[frame] = (work_seconds() - start) / (double)rays->n;
    for (size_t i = 0; i < rays->n; i++) x->wrong += !hits_same(h[i], due[i]);
    if (!first) free(h);
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
        double b = clock_median(x[k].frame + last, motion_last);
        double c = clock_median(x[k].ray + last, motion_last);
        const double cell[] = {per((double)x[k].work.nodes, rays),
                               per((double)x[k].work.tests, rays), b * 1e3, c * 1e9};
        table_text(&t, "%s", keeping_name[k]);
        for (int i = 0; i < 4; i++) table_number(&t, cell[i]);
        for (int half = 4; half <= 12; half++)
            plot_add(&time, s, pow(10, half / 2.0), (b + pow(10, half / 2.0) * c) * 1e3);
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
