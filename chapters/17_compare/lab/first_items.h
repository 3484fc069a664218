/* first_items.h: the structures of first.h with the verbs that all structures share (items.h of
 * 10): what the notes' own algorithms cost beside the full versions. They may be wrong: compare.h
 * holds them against brute force, marks them, and goes on.
 *
 *   first_items_how(bvh)     brute, grid .. bvh: one of them is built
 *
 * Triangles only; a BSP tree of more than first_bsp_most is not built: it takes too long. They do
 * not say what they hold, and count tests, not steps.
 */
#ifndef COMPARE_FIRST_ITEMS_H
#define COMPARE_FIRST_ITEMS_H

#include "../../07_mesh/scenes/as_first.h"
#include "../../09_aabb/items.h"
#include "../first.h"

typedef struct { int which; size_t most_bytes; } first_items_options;
#define first_items_how(which) ((first_items_options){first_use_##which, 0})
typedef struct { first_mesh m; first_contest c; int which; } first_items;

enum { first_bsp_most = 20000, first_bytes = 2000 };  /* a triangle, at a guess */

/* ---------------------------------------------------------------------------------------------- */

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
    default: break;
    }
    return true;
}

static inline void first_items_free(first_items *s)
{
    switch (s->c.m ? s->which : first_structures) {
    case first_use_grid: first_grid_free(&s->c.grid); break;
    case first_use_octree: first_octree_free(&s->c.octree); break;
    case first_use_kdtree: first_kdtree_free(&s->c.kdtree); break;
    case first_use_bsp: first_bsp_free(&s->c.bsp); break;
    case first_use_bvh: first_bvh_free(&s->c.bvh); break;
    default: break;
    }
    first_mesh_free(&s->m);
    s->c.m = NULL;
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
