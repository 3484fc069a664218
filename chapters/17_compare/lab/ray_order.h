/* ray_order.h: rays that stay together or not, one core and all: does the verdict change?
 *
 *   order_run(&c)            a table
 *
 * The same primary rays of a teapot in rows (coherent, 相干) and shuffled (the same work in another
 * order), and diffuse ones (incoherent, 非相干); then these on all cores. Times are of processors,
 * all threads together: a core that waits for memory because others use it shows there, and other
 * work of the machine hardly does. Efficiency 1: n idle cores are n times as fast.
 */
#ifndef COMPARE_LAB_RAY_ORDER_H
#define COMPARE_LAB_RAY_ORDER_H

#include "costs.h"
#include "../../07_mesh/scenes/named.h"

/* ---------------------------------------------------------------------------------------------- */

enum { order_chunk = 256, order_rounds = 7, order_sets = 3, order_times = order_sets + 1 };
typedef struct { const compare_entry *e; const ray_set *rays; hit *out; int threads; } order_work;

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

/* The three sets on one thread, and the last on all. */
static inline void order_row(table *t, const compare_entry *e, const ray_set set[order_sets],
                             hit *out, int threads)
{
    order_work work[order_times];
    bench_candidate c[order_times];
    for (int k = 0; k < order_times; k++) {
        bool last = k == order_sets;
        work[k] = (order_work){e, &set[k - last], out, last ? threads : 1};
        c[k] = (bench_candidate){.run = order_search, .context = &work[k]};
    }
    bench_time_by(order_seconds, c, order_times, order_rounds);
    table_text(t, "%s", e->choice->label);
    for (int k = 0; k < order_times; k++)
        table_number(t, per(c[k].seconds * 1e9, work[k].rays->n));
    table_number(t, c[order_sets - 1].seconds / c[order_sets].seconds);
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
    ray_set set[order_sets] = {s.rays[KIND_PRIMARY],
                                order_shuffled(&s.rays[KIND_PRIMARY], o->seed),
                                s.rays[KIND_DIFFUSE]};
    hit *out = allocate(set[0].n + set[2].n + 1, sizeof *out);
    out[0] = hit_none;
    snprintf(title, sizeof title, "Order and cores: %zu triangles, %zu rays of a kind; %d cores",
             w.mesh.triangles, set[0].n, parallel_cores());
    table t = table_new(title, "structure|in rows [ns]|shuffled [ns]|diffuse [ns]|all cores [ns]|"
                               "efficiency");
    for (const compare_entry *e = s.entry; e < s.entry + s.entries; e++) {
        compare_progress("order and cores", "timing", e->choice->label);
        if (e->fits) order_row(&t, e, set, out, o->threads);
    }
    compare_progress("order and cores", NULL, NULL);
    html_table(c->to, &t);
    free(out), rays_free(&set[1]);
    compare_end(&s);
    world_free(&w);
}

#endif
