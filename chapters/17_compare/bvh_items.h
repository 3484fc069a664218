/* bvh_items.h: the tree of 14 with the verbs that all structures share (09_aabb/structure.h): one
 * type for a mesh and for a scene of shapes.
 *
 *   bvh_items b;
 *   bvh_items_build(&x, how, &b, &f)    how.tree: options of 14; how.most_bytes: what it may hold
 *
 * The rest as items.h has it. nodes: pairs of boxes tested; a leaf is never empty. References are
 * more than items where cuts go through items (BVH_SPATIAL).
 */
#ifndef COMPARE_BVH_ITEMS_H
#define COMPARE_BVH_ITEMS_H

#include "../09_aabb/items.h"
#include "../14_bvh/bvh.h"
#include "../14_bvh/bvh_shapes.h"
#include "../14_bvh/stats.h"

typedef struct { bvh_options tree; size_t most_bytes; } bvh_items_options;
typedef struct { items x; bool of_mesh; bvh mesh; bvh_shapes shapes; } bvh_items;

/* ---------------------------------------------------------------------------------------------- */

static inline const bvh_tree *bvh_items_tree(const bvh_items *b)
{
    return b->of_mesh ? &b->mesh.tree : &b->shapes.tree;
}

/* While it is built an item takes 28 bytes (16 more to sort Morton codes), a copy in the order of
 * the leaves, and two nodes of 32 at most. */
static inline bool bvh_items_build(const items *x, bvh_items_options how, bvh_items *out,
                                   failure *f)
{
    size_t copy = x->m ? sizeof(bvh_triangle) : sizeof(uint32_t);
    size_t most = x->n * (28 + 16 + copy + 2 * sizeof(bvh_node));
    if (how.tree.strategy == BVH_SPATIAL) most *= spatial_most;
    *out = (bvh_items){.x = *x, .of_mesh = x->m != NULL};
    if (x->n >> 31) return failed(f, 2, "%zu items: fewer than 2^31 fit", x->n);
    if (most > how.most_bytes)
        return failed(f, 1, "may need %zu MB of %zu", most >> 20, how.most_bytes >> 20);
    if (x->m) bvh_build(x->m, how.tree, &out->mesh);
    else bvh_shapes_build(x->s, how.tree, &out->shapes);
    return true;
}

static inline void bvh_items_free(bvh_items *b)
{
    bvh_free(&b->mesh);
    bvh_shapes_free(&b->shapes);
    *b = (bvh_items){0};
}

static inline bool bvh_items_hit(const bvh_items *b, ray r, hit *out)
{
    return b->of_mesh ? bvh_hit(&b->mesh, r, out) : bvh_shapes_hit(&b->shapes, r, out);
}

static inline bool bvh_items_occluded(const bvh_items *b, ray r)
{
    return b->of_mesh ? bvh_occluded(&b->mesh, r) : bvh_shapes_occluded(&b->shapes, r);
}

static inline bool bvh_items_counted(const bvh_items *b, ray r, bool any, hit *out, search_work *w)
{
    bvh_work k = {0, 0, 0, 0, 0};
    bool found = b->of_mesh
        ? tree_search(&b->mesh.tree, r, box_ray_of, bvh_leaf, &b->mesh, any, out, &k)
        : tree_search(&b->shapes.tree, r, box_ray_of, bvh_shapes_leaf, &b->shapes, any, out, &k);
    w->nodes += k.nodes, w->leaves += k.leaves, w->tests += k.tests;
    return found;
}

static inline bool bvh_items_hit_counted(const bvh_items *b, ray r, hit *out, search_work *w)
{
    return bvh_items_counted(b, r, false, out, w);
}

static inline bool bvh_items_occluded_counted(const bvh_items *b, ray r, search_work *w)
{
    return bvh_items_counted(b, r, true, NULL, w);
}

static inline structure_stats bvh_items_stats(const bvh_items *b)
{
    bvh_stats s = bvh_stats_of(bvh_items_tree(b));
    structure_stats out = {.inner = s.inner, .leaves = s.leaves, .references = s.items,
                           .depth = s.depth, .bytes = s.bytes, .peak = s.peak};
    aabb box;
    for (size_t i = 0; i < b->x.n; i++) out.items += items_bounds(&b->x, i, &box);
    return out;
}

#endif
