/* bvh.h: the bounding volume hierarchy (层次包围盒, BVH): the set of items is cut in two, and each part
 * again; each part has a box, and a ray that misses the box misses everything in it.
 *
 *   bvh b;
 *   bool bvh_build(&x, bvh_defaults, &b, &f)    false: f says why; x as for all structures: items.h
 *   bool bvh_hit(&b, r, &h)                     the very hit of items_hit
 *   bool bvh_occluded(&b, r)                    is there any?
 *   bvh_hit_counted(&b, r, &h, &w), bvh_occluded_counted(&b, r, &w)
 *   structure_stats s = bvh_stats(&b)
 *   bvh_free(&b)                                a zeroed one may be freed
 *
 * Not space is cut but the set: each item is in one leaf. Its boxes may overlap; what is in one
 * leaf may lie in the boxes of others, and a ray may have to look into several boxes at the same
 * place. (The rule "spatial" does cut: there a triangle may be in several leaves.)
 *
 * how: tree.h, with the rules by which it is cut. Of a mesh it is a bvh_mesh, of a scene of shapes
 * a bvh_shapes; who knows which takes that, and a program of triangles alone is spared the rest.
 */
#ifndef BVH_H
#define BVH_H

#include "../09_aabb/items.h"
#include "bvh_mesh.h"
#include "bvh_shapes.h"

typedef struct { items x; bvh_mesh mesh; bvh_shapes shapes; } bvh;  /* one of the two, as x says */

/* ---------------------------------------------------------------------------------------------- */

static inline const bvh_tree *bvh_tree_of(const bvh *b)
{
    return b->x.m ? &b->mesh.tree : &b->shapes.tree;
}

static inline bool bvh_build(const items *x, bvh_options how, bvh *out, failure *f)
{
    *out = (bvh){.x = *x};
    return x->m ? bvh_mesh_build(x->m, how, &out->mesh, f)
                : bvh_shapes_build(x->s, how, &out->shapes, f);
}

static inline void bvh_free(bvh *b)
{
    bvh_mesh_free(&b->mesh);
    bvh_shapes_free(&b->shapes);
    *b = (bvh){.x = {NULL, NULL, 0}};
}

__attribute__((always_inline))
static inline bool bvh_search(const bvh *b, ray r, bool any, hit *out, search_work *work)
{
    return b->x.m ? bvh_mesh_search(&b->mesh, r, any, out, work)
                  : bvh_shapes_search(&b->shapes, r, any, out, work);
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
