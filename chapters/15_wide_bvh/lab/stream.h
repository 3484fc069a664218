/* stream.h: up to eight rays through the tree together: a node is fetched once for all of them, and
 * they wait on one stack, where it is near for any of them. The same hits. Does it pay?
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

#define EIGHT_FILE "../../chapters/15_wide_bvh/lab/stream_walk.h"
#include "../../../common/numbers/dialects.h"

/* ---------------------------------------------------------------------------------------------- */

static inline void bvh8_hit_stream(const bvh8 *w, const ray *r, int n, hit *out, stream_work *work)
{
    EIGHT_CALL(w->dialect, bvh8_stream, w, r, n, out, work);
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
    failure f;
    if (!bvh8_build(&s->x, bvh8_defaults, &w, &f)) fail(f);
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
