/* oracles.h: brute force, which is the oracle, and the structures of first.h, which may be wrong:
 * with the verbs that all structures share (09_aabb/structure.h).
 *
 *   first_items_how(bvh)     brute, grid .. wide: one of them is built
 *
 * The first versions hold triangles only, do not say what they hold, and count tests, not steps.
 */
#ifndef COMPARE_ORACLES_H
#define COMPARE_ORACLES_H

#include "../../07_mesh/scenes/as_first.h"
#include "../../09_aabb/items.h"
#include "../first.h"

typedef struct { size_t most_bytes; } brute_options;
typedef struct { items x; } brute;

typedef struct { int which; size_t most_bytes; } first_items_options;
#define first_items_how(which) ((first_items_options){first_use_##which, 0})
typedef struct { first_mesh m; first_contest c; int which; } first_items;

enum { first_bsp_most = 20000, first_bytes = 2000 };  /* triangles: more take too long; of each */

/* ---------------------------------------------------------------------------------------------- */

static inline bool brute_build(const items *x, brute_options how, brute *out, failure *f)
{
    (void)how, (void)f;
    return *out = (brute){*x}, true;
}

static inline void brute_free(brute *b) { *b = (brute){{NULL, NULL, 0}}; }

/* Any hit: ends at the first item that is hit; that many tests. */
static inline bool brute_search(const brute *b, ray r, bool any, hit *out, search_work *work)
{
    if (!any && work) work->tests += b->x.n;
    if (!any || !work) return any ? items_occluded(&b->x, r) : items_hit(&b->x, r, out);
    query q = query_of(r);
    for (size_t i = 0; i < b->x.n; i++) {
        work->tests++;
        if (query_ask(&q, &b->x, (uint32_t)i, true)) return true;
    }
    return false;
}

STRUCTURE_VERBS(brute)

static inline structure_stats brute_stats(const brute *b)
{
    return (structure_stats){.leaves = 1, .references = b->x.n, .items = b->x.n};
}

static inline bool first_items_build(const items *x, first_items_options how, first_items *out,
                                     failure *f)
{
    *out = (first_items){.which = how.which};
    if (!x->m) return failed(f, 2, "the first versions hold triangles only");
    if (how.which == first_use_bsp && x->n > first_bsp_most)
        return failed(f, 2, "for at most %d triangles", (int)first_bsp_most);
    if (x->n > how.most_bytes / first_bytes || x->n > INT32_MAX / 8)
        return failed(f, 1, "%zu triangles may not fit", x->n);
    out->m = first_mesh_of(x->m);
    out->c.m = &out->m;
    switch (how.which) {
    case first_use_grid: out->c.grid = first_grid_build(&out->m); break;
    case first_use_octree: first_octree_build(&out->m, &out->c.octree); break;
    case first_use_kdtree: first_kdtree_build(&out->m, &out->c.kdtree); break;
    case first_use_bsp: first_bsp_build(&out->m, &out->c.bsp); break;
    case first_use_bvh: out->c.bvh = first_bvh_build(&out->m, true); break;
    case first_use_wide: out->c.wide = first_wide_build(&out->m); break;
    default: break;
    }
    return true;
}

static inline void first_items_free(first_items *s)
{
    first_contest_free(&s->c), first_mesh_free(&s->m);
}

/* The first versions have no search of their own for any hit. */
static inline bool first_items_search(const first_items *s, ray r, bool any, hit *out,
                                      search_work *work)
{
    hit h;
    long before = first_tests;
    bool met = first_contest_hit(&s->c, s->which, r, any ? &h : out);
    if (work) work->tests += (size_t)(first_tests - before);
    return met;
}

STRUCTURE_VERBS(first_items)

static inline structure_stats first_items_stats(const first_items *s)
{
    return (structure_stats){.items = (size_t)s->m.n};
}

#endif
