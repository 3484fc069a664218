/* bvh.h: the bounding volume hierarchy (层次包围盒, BVH): the set of items is cut in two, and each part
 * again; each part has a box, and a ray that misses the box misses everything in it.
 *
 *   bvh b;
 *   bool bvh_build(&x, bvh_defaults, &b, &f)    false: f says why; x as for all structures: items.h
 *   bool bvh_hit(&b, r, &h), ..                 the verbs of structure.h (09)
 *
 * Not space is cut but the set: each item is in one leaf. Its boxes may overlap; what is in one
 * leaf may lie in the boxes of others, and a ray may have to look into several boxes at the same
 * place. (The rule "spatial" does cut: there a triangle may be in several leaves.)
 *
 * how: tree.h, with the rules by which it is cut. Of a mesh it is a bvh_mesh: a program of
 * triangles alone takes that, and is spared the rest.
 */
#ifndef BVH_H
#define BVH_H

#include "../09_aabb/items.h"
#include "bvh_mesh.h"

typedef struct {
    items x;          /* says which of the two it is: */
    bvh_mesh mesh;    /* of a mesh; or */
    bvh_tree shapes;  /* of the shapes of a scene: */
    uint32_t *index;  /* [shapes.items] their numbers, in the order of the leaves */
} bvh;

/* ---------------------------------------------------------------------------------------------- */

static inline const bvh_tree *bvh_tree_of(const bvh *b)
{
    return b->x.m ? &b->mesh.tree : &b->shapes;
}

static inline void bvh_free(bvh *b)
{
    bvh_mesh_free(&b->mesh), tree_free(&b->shapes);
    free(b->index);
    *b = (bvh){.x = {NULL, NULL, 0}};
}

/* A shape whose box is not a number is never hit. */
static inline bool bvh_take_shapes(bvh_options how, bvh_item *item, bvh *out, failure *f)
{
    size_t n = 0;
    for (size_t i = 0; i < out->x.n; i++) {
        aabb box;
        if (!items_bounds(&out->x, i, &box)) continue;
        item[n] = box_between(box.lo, box.hi);
        item[n++].index = (uint32_t)i;
    }
    if (!tree_build(item, n, how, &out->shapes, f)) return false;
    out->index = tree_array(&out->shapes, n, sizeof *out->index);
    if (!out->index) return memory_failed(f, "BVH", n, how.most_bytes);
    for (size_t i = 0; i < n; i++) out->index[i] = item[i].index;
    memory_gives(&out->shapes.held, n, sizeof *item);
    return true;
}

static inline bool bvh_build(const items *x, bvh_options how, bvh *out, failure *f)
{
    *out = (bvh){.x = *x};
    if (x->m) return bvh_mesh_build(x->m, how, &out->mesh, f);
    bvh_item *item = memory_array(&(memory){.most = how.most_bytes}, x->n, sizeof *item);
    if (!item) return memory_failed(f, "BVH", x->n, how.most_bytes);
    bool built = bvh_take_shapes(how, item, out, f);
    free(item);
    if (!built) bvh_free(out);
    return built;
}

fast_inline bool bvh_shapes_leaf(const void *context, uint32_t first, uint32_t count, query *q,
                                 bool any)
{
    const bvh *b = context;
    bool found = false;
    hit h;
    for (const uint32_t *i = b->index + first, *end = i + count; i < end; i++) {
        if (!shape_hit_sheared(&b->x.s->shapes[*i], &q->shear, q->r, &h)) continue;
        if (any) return true;
        h.shape = *i;
        found |= query_improves(q, h);
    }
    return found;
}

fast_inline bool bvh_search(const bvh *b, ray r, bool any, hit *out, search_work *work)
{
    return b->x.m ? bvh_mesh_search(&b->mesh, r, any, out, work)
                  : tree_search(&b->shapes, r, box_ray_of, bvh_shapes_leaf, b, any, out, work);
}

STRUCTURE_VERBS(bvh)

/* A leaf is never empty. References are more than items where cuts go through items. */
static inline structure_stats bvh_stats(const bvh *b)
{
    structure_stats s = tree_stats(bvh_tree_of(b));
    aabb box;
    s.items = 0;
    for (size_t i = 0; i < b->x.n; i++) s.items += items_bounds(&b->x, i, &box);
    return s;
}

#endif
