/* bvh_shapes.h: the same tree over a scene of shapes of any kind (07): spheres, cones, polygons ...
 *
 *   bvh_shapes b;
 *   bool bvh_shapes_build(&s, bvh_defaults, &b, &f)   the shapes must outlive the tree
 *   bool bvh_shapes_hit(&b, r, &h)                    the very hit that scene_hit gives
 *   bool bvh_shapes_occluded(&b, r)
 *   bvh_shapes_free(&b);
 */
#ifndef BVH_SHAPES_H
#define BVH_SHAPES_H

#include "../07_mesh/closest.h"
#include "search.h"

typedef struct { bvh_tree tree; uint32_t *index; const shape *shapes; } bvh_shapes;

/* ---------------------------------------------------------------------------------------------- */

static inline void bvh_shapes_free(bvh_shapes *b)
{
    tree_free(&b->tree);
    free(b->index);
    b->index = NULL, b->shapes = NULL;
}

static inline bool bvh_shapes_take(const scene *s, bvh_options how, bvh_item *item,
                                   bvh_shapes *out, failure *f)
{
    size_t n = 0;
    for (size_t i = 0; i < s->n; i++) {
        vec3 lo, hi;
        shape_bounds(s->shapes[i], &lo, &hi);
        item[n] = (bvh_item){box_between(lo, hi), (uint32_t)i};
        n += lo.x <= hi.x && lo.y <= hi.y && lo.z <= hi.z;
    }
    if (!tree_build(item, n, how, &out->tree, f)) return false;
    out->shapes = s->shapes;
    out->index = tree_array(&out->tree, n, sizeof *out->index);
    if (!out->index) return failed(f, 1, "BVH: no memory for %zu shapes", n);
    for (size_t i = 0; i < n; i++) out->index[i] = item[i].index;
    memory_gives(&out->tree.held, n, sizeof *item);
    return true;
}

/* A shape whose box is not a number is never hit. */
static inline bool bvh_shapes_build(const scene *s, bvh_options how, bvh_shapes *out, failure *f)
{
    *out = (bvh_shapes){.index = NULL};
    bvh_item *item = s->n <= how.most_bytes / sizeof *item ? calloc(s->n + 1, sizeof *item) : NULL;
    if (!item) return failed(f, 1, "BVH: no memory for %zu items", s->n);
    bool built = bvh_shapes_take(s, how, item, out, f);
    free(item);
    if (!built) bvh_shapes_free(out);
    return built;
}

__attribute__((always_inline))
static inline bool bvh_shapes_leaf(const void *context, uint32_t first, uint32_t count,
                                   query *q, bool any)
{
    const bvh_shapes *b = context;
    bool found = false;
    hit h;
    for (uint32_t i = first; i < first + count; i++) {
        if (!shape_hit_sheared(&b->shapes[b->index[i]], &q->shear, q->r, &h)) continue;
        if (any) return true;
        h.shape = b->index[i];
        found |= query_improves(q, h);
    }
    return found;
}

__attribute__((always_inline))
static inline bool bvh_shapes_search(const bvh_shapes *b, ray r, bool any, hit *out,
                                     search_work *work)
{
    return tree_search(&b->tree, r, box_ray_of, bvh_shapes_leaf, b, any, out, work);
}

STRUCTURE_VERBS(bvh_shapes)

#endif
