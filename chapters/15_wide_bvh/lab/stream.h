/* stream.h: up to eight rays through the tree together: a node is fetched once for all of them, and
 * they wait on one stack, where it is near for any of them. The same hits; in plain C. Does it pay?
 *
 *   bvh8_hit_stream(&w, r, n, hits, &work)    n <= stream_rays; hit_none where nothing is
 *   table_of_streams(o, &s)                   neighbours in the picture, and scattered rays
 *   table_of_few(o)                           of few triangles, side by side: packet.h
 *
 * Source: I. Wald, P. Slusallek, C. Benthin, M. Wagner, "Interactive Rendering with Coherent Ray
 * Tracing", Computer Graphics Forum 20(3), 2001: packets of four.
 */
#ifndef WIDE_STREAM_H
#define WIDE_STREAM_H

#include "../../../common/lab/bench.h"
#include "../../../common/lab/report.h"
#include "../../07_mesh/scenes/soup.h"
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
        double ns[2], unit = trial_per(1e9, s->rays[k].n);
        for (int i = 0; i < 2; i++)
            p[i] = (stream_pass){&w, &s->rays[k], i ? stream_rays : 1, 0, {0, 0}};
        bench_each(stream_run, p, sizeof *p, 2, o->quick ? 1 : 15, unit, ns);
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
            table_number(&t, ns[i]);
        }
    }
    output_extra_table(o, &t);
    bvh8_free(&w);
}

/* ---------------------------------------------------------------------------------------------- */

/* A room and boxes in it, of 12 triangles each; the rest are loose. */
static inline mesh few_mesh(size_t n)
{
    mesh m = soup_mesh(n, (real)0.8, (real)0.2, 5);
    for (size_t i = 0; i < n / 12 * 36; i++) {
        static const uint8_t two[6] = {0, 1, 2, 2, 1, 3};  /* corners of a face, two bits each */
        random_stream g = random_start(6, i / 36, 0);
        vec3 at = random_in_cube(&g, (real)0.7), half = random_in_cube(&g, (real)0.3);
        if (i < 36) at = (vec3){0, 0, 0}, half = (vec3){1, 1, 1};
        size_t k = i / 12 % 3, end = i / 6 % 2, corner = two[i % 6];
        vec3 s = vwith((vec3){0, 0, 0}, (int)k, end ? 1 : -1);
        s = vwith(s, (int)(k + 1) % 3, corner & 1 ? 1 : -1);
        s = vwith(s, (int)(k + 2) % 3, corner & 2 ? 1 : -1);
        m.v[i] = vadd(at, vmul(half, s));
    }
    return m;
}

typedef struct { const bvh8 *w; const ray *r; size_t rays, met; bool row, any; } few_pass;

static inline double few_run(void *context)
{
    few_pass *p = context;
    bvh8_query q[64];
    p->met = 0;
    for (size_t i = 0; i < p->rays; i += 64) {
        for (size_t k = 0; k < 64; k++) q[k].r = &p->r[i + k], q[k].skip = bvh8_skip_none;
        for (int k = 0; k < 64 && !p->row; k++)
            q[k].met = bvh8_ask_at(p->w, q[k].r, q[k].skip, p->any ? NULL : &q[k].h, NULL);
        if (p->row) bvh8_ask_row(p->w, q, 64, p->any);
        for (size_t k = 0; k < 64; k++) p->met += q[k].met;
    }
    return (double)p->met;
}

/* Each ray begins where the last one hit, in any direction; shadow rays go to a point. */
static inline void table_of_few(const options *o)
{
    static const size_t list[] = {12, 36, 64, bvh8_few + 1, 0};
    table t = table_new("Few triangles: one by one, and side by side",
                        "triangles|patches|time [ns]|in rows: time [ns]|rays in shadow|"
                        "any hit: time [ns]|any, in rows: time [ns]");
    size_t rays = o->quick ? 640 : 64000;
    ray *r = allocate(2 * rays, sizeof *r);
    for (const size_t *n = list; *n; n++) {
        mesh m = few_mesh(*n);
        items x = items_of_mesh(&m);
        bvh8 w;
        failure f;
        if (!bvh8_build(&x, bvh8_defaults, &w, &f)) fail(f);
        random_stream g = random_start(o->seed, 7, 0);
        vec3 at = {0, 0, (real)0.9};
        for (size_t i = 0; i < rays; i++) {
            hit h = {.t = 0};
            r[i] = ray_from(at, random_in_cube(&g, 1));
            r[rays + i] = ray_shadow(at, (vec3){0, 0, (real)0.9}, (real)1e-3);
            if (bvh8_hit(&w, r[i], &h)) at = ray_at(r[i], h.t * (real)0.999);
        }
        few_pass p[4];
        double ns[4];
        for (int i = 0; i < 4; i++)
            p[i] = (few_pass){&w, i < 2 ? r : r + rays, rays, 0, i % 2 == 1, i >= 2};
        bench_each(few_run, p, sizeof *p, 4, o->quick ? 1 : 15, 1e9 / (double)rays, ns);
        table_count(&t, *n), table_count(&t, w.patches);
        for (int i = 0; i < 4; i++) {
            if (i == 2) table_count(&t, p[2].met);
            table_number(&t, ns[i]);
        }
        bvh8_free(&w), mesh_free(&m);
    }
    output_extra_table(o, &t);
    free(r);
}

#endif
