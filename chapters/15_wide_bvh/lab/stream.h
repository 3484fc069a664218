/* stream.h: up to eight rays through the tree together: a node is fetched once for all of them, and
 * they wait on one stack, where it is near for any of them. The same hits; in plain C. Does it pay?
 *
 *   bvh8_hit_stream(&w, r, n, hits, &work)    n <= stream_rays; hit_none where nothing is
 *   table_of_streams(o, &s)                   neighbours in the picture, and scattered rays
 *
 * Source: I. Wald, P. Slusallek, C. Benthin, M. Wagner, "Interactive Rendering with Coherent Ray
 * Tracing", Computer Graphics Forum 20(3), 2001: packets of four.
 */
#ifndef WIDE_STREAM_H
#define WIDE_STREAM_H

#include "../../../common/lab/bench.h"
#include "../../../common/lab/report.h"
#include "../../09_aabb/trials/bench.h"
#include "../bvh8.h"

enum { stream_rays = 8 };
typedef struct { size_t fetched, asked; } stream_work;  /* nodes; rays at nodes */
typedef struct { uint32_t child, rays; float enter; } stream_waiting;

/* ---------------------------------------------------------------------------------------------- */

static inline void bvh8_hit_stream(const bvh8 *w, const ray *r, int n, hit *out, stream_work *work)
{
    const bvh8_skip none = bvh8_skip_none;  /* a ray keeps its address */
    stream_waiting stack[bvh8_stack];
    bvh8_ray q[stream_rays];
    unsigned usable = 0;
    int top = 0;
    for (int i = 0; w->nodes > 0 && i < n; i++)
        usable |= (unsigned)bvh8_ray_of(w, &r[i], &none, &q[i]) << i;
    stack[top++] = (stream_waiting){0, usable, 0};
    while (top > 0) {
        stream_waiting now = stack[--top];
        bool leaf = now.child & bvh8_leaf;
        uint32_t at = now.child & ~bvh8_leaf, rays[8] = {0};
        eight near = EIGHT_ALL(INFINITY), enter;
        work->fetched += !leaf && now.rays;
        for (unsigned left = now.rays; left; left &= left - 1) {
            int i = __builtin_ctz(left);
            if (float_max(q[i].limit, 0) < now.enter) continue;  /* enter: not before 0 */
            if (leaf) {
                bvh8_triangles_0(w, &w->block[at], &q[i], false);
                continue;
            }
            eight_set mask = bvh8_boxes_0(&w->node[at], &q[i], &enter);
            near = EIGHT_LOOP(eight_min, near, enter);
            work->asked++;
            for (; mask; mask &= mask - 1) rays[__builtin_ctzll(mask) / 8] |= 1u << i;
        }
        for (int k = 0, base = top; k < 8; k++) {
            if (!rays[k]) continue;
            int j = top++;
            const float t = near[k];
            for (; j > base && stack[j - 1].enter < t; j--) stack[j] = stack[j - 1];
            stack[j] = (stream_waiting){w->node[at].child[k], rays[k], t};
        }
    }
    for (int i = 0; i < n; i++)
        out[i] = usable >> i & 1 && bvh8_settle(w, &q[i]) ? q[i].best : hit_none;
}

typedef struct { const bvh8 *w; const ray_set *rays; int together; size_t hits; stream_work work; }
    stream_pass;

static inline double stream_run(void *context)
{
    stream_pass *p = context;
    hit h[stream_rays];
    p->hits = 0, p->work = (stream_work){0, 0};
    for (size_t i = 0; i < p->rays->n; i += (size_t)p->together) {
        int n = (int)(p->rays->n - i < (size_t)p->together ? p->rays->n - i : (size_t)p->together);
        const ray *r = p->rays->r + i;
        if (n == 1) h[0].shape = bvh8_hit(p->w, *r, h) ? h[0].shape : no_shape;
        else bvh8_hit_stream(p->w, r, n, h, &p->work);
        for (int k = 0; k < n; k++) p->hits += h[k].shape != no_shape;
    }
    return (double)p->hits;
}

static inline void table_of_streams(const options *o, const trial_scene *s)
{
    table t = table_new("Eight rays together: neighbours in a row of pixels, and scattered ones",
                        "rays|together|hits|nodes fetched a ray|nodes asked a ray|time [ns]");
    bvh8 w;
    bvh8_options plain = bvh8_defaults;
    failure f;
    plain.dialect = EIGHT_PLAIN;
    if (!bvh8_build(&s->x, plain, &w, &f)) fail(f);
    for (int k = 0; k < 2; k++) {
        stream_pass p[2];
        bench_candidate c[2];
        for (int i = 0; i < 2; i++) {
            p[i] = (stream_pass){&w, &s->rays[k], i ? stream_rays : 1, 0, {0, 0}};
            c[i] = (bench_candidate){.run = stream_run, .context = &p[i]};
        }
        bench_time(c, 2, o->quick ? 1 : 15);
        search_work one = {0, 0, 0, 0};
        hit h;
        for (size_t i = 0; i < s->rays[k].n; i++)
            bvh8_hit_counted(&w, s->rays[k].r[i], &h, &one);
        p[0].work = (stream_work){one.nodes, one.nodes};
        for (int i = 0; i < 2; i++) {
            table_text(&t, "%s", trial_kind_name[k]), table_count(&t, (size_t)p[i].together);
            table_count(&t, p[i].hits);
            table_number(&t, trial_per((double)p[i].work.fetched, s->rays[k].n));
            table_number(&t, trial_per((double)p[i].work.asked, s->rays[k].n));
            table_number(&t, trial_per(c[i].seconds * 1e9, s->rays[k].n));
        }
    }
    output_extra_table(o, &t);
    bvh8_free(&w);
}

#endif
