/* contenders.h: the structures that are compared. A new one is one line below, if it has the verbs
 * of 09_aabb/structure.h, and one in the list.
 *
 *   CONTENDER(id, "name", X, options, most, explain)     makes id_contender:
 *      id        several may share a structure
 *      "name"    in tables and for --only; those from `usual` on in the list run only if asked for
 *      X         prefix of its verbs and name of its type
 *      options   X_options; most_bytes is set from outside
 *      most      shapes, beyond which building takes long
 *      explain   why a hit is lost: explain.h; or NULL
 *
 *   const contender *c = contender_find("octree");     NULL: no such name
 *   void *s = contender_build(c, &x, most_bytes, &f);  NULL: it does not fit, f says so
 *   c->hit(s, r, &h) ...                               the verbs
 *   c->search(s, r, n, any, hits)                      all rays in a loop, the structure's search
 *                                                      inlined; returns the number of hits. any:
 *                                                      hits[i] has t = 0, shape 0 where occluded
 *   contender_free(c, s)
 */
#ifndef COMPARE_CONTENDERS_H
#define COMPARE_CONTENDERS_H

#include "../14_bvh/bvh.h"
#include "brute.h"
#include "explain_cells.h"
#include "first_items.h"

typedef struct {
    const char *name;
    size_t size;
    size_t most;  /* shapes, for which building takes a second or so: more only with --full */
    bool (*build)(const items *x, size_t most_bytes, void *out, failure *f);
    bool (*hit)(const void *s, ray r, hit *out);
    bool (*occluded)(const void *s, ray r);
    bool (*hit_counted)(const void *s, ray r, hit *out, search_work *w);
    bool (*occluded_counted)(const void *s, ray r, search_work *w);
    size_t (*search)(const void *s, const ray *r, size_t n, bool any, hit *out);
    structure_stats (*stats)(const void *s);
    void (*free)(void *s);
    explainer *explain;  /* NULL: has none */
} contender;

/* ---------------------------------------------------------------------------------------------- */

/* The defaults are tuned to triangles, whose test mostly ends at the first comparison. That of a
 * sphere, a cone or a polygon costs some four times as much against a step: trees are then cut
 * finer. Measured on balls, gears, mount, rings and tree: rays take up to half the time less. */
enum { shape_cost = 4 };

static inline octree_options octree_how_for(const items *x)
{
    octree_options how = octree_defaults;
    if (x->s) how.leaf /= shape_cost;
    return how;
}

static inline kdtree_options kdtree_how_for(const items *x)
{
    kdtree_options how = kdtree_defaults;
    if (x->s) how.item_cost *= shape_cost;
    return how;
}

static inline bsp_options bsp_how_for(const items *x)
{
    bsp_options how = bsp_defaults;
    if (x->s) how.axis_cost /= shape_cost, how.slanted_cost /= shape_cost;
    return how;
}

static inline bvh_options bvh_how_for(const items *x, const char *rule)
{
    bvh_options how = bvh_defaults;
    how.rule = rule;
    if (x->s) how.item_cost *= shape_cost;
    return how;
}

/* `options` may depend on x. */
#define CONTENDER(id, text, X, options, most, explain_it)                                        \
    static bool id##_c_build(const items *x, size_t most_bytes, void *out, failure *f)           \
    {                                                                                            \
        X##_options how = options;                                                                \
        how.most_bytes = most_bytes;                                                             \
        return X##_build(x, how, out, f);                                                        \
    }                                                                                            \
    static bool id##_c_hit(const void *s, ray r, hit *out) { return X##_hit(s, r, out); }        \
    static bool id##_c_occluded(const void *s, ray r) { return X##_occluded(s, r); }             \
    static bool id##_c_hit_counted(const void *s, ray r, hit *out, search_work *w)               \
    {                                                                                            \
        return X##_hit_counted(s, r, out, w);                                                    \
    }                                                                                            \
    static bool id##_c_occluded_counted(const void *s, ray r, search_work *w)                    \
    {                                                                                            \
        return X##_occluded_counted(s, r, w);                                                    \
    }                                                                                            \
    static size_t id##_c_search(const void *s, const ray *r, size_t n, bool any, hit *out)       \
    {                                                                                            \
        size_t hits = 0;                                                                         \
        for (size_t i = 0; i < n; i++) out[i] = hit_none;                                        \
        for (size_t i = 0; any && i < n; i++)                                                    \
            if (X##_occluded(s, r[i])) out[i] = (hit){0, 0, 0, 0}, hits++;                       \
        for (size_t i = 0; !any && i < n; i++) hits += X##_hit(s, r[i], &out[i]);                \
        return hits;                                                                             \
    }                                                                                            \
    static structure_stats id##_c_stats(const void *s) { return X##_stats(s); }                  \
    static void id##_c_free(void *s) { X##_free(s); }                                            \
    static const contender id##_contender = {                                                    \
        text, sizeof(X), most, id##_c_build, id##_c_hit, id##_c_occluded, id##_c_hit_counted,    \
        id##_c_occluded_counted, id##_c_search, id##_c_stats, id##_c_free, explain_it};

CONTENDER(brute, "brute", brute, ((brute_options){0}), SIZE_MAX, NULL)
CONTENDER(grid, "grid", grid, grid_defaults, SIZE_MAX, explain_grid)
CONTENDER(nested, "nested", nested, nested_defaults, SIZE_MAX, explain_nested)
CONTENDER(octree, "octree", octree, octree_how_for(x), SIZE_MAX, explain_octree)
CONTENDER(kdtree, "kdtree", kdtree, kdtree_how_for(x), SIZE_MAX, explain_kdtree)
CONTENDER(bsp, "bsp", bsp, bsp_how_for(x), 70000, explain_bsp)
CONTENDER(bvh, "bvh", bvh, bvh_how_for(x, "sah"), SIZE_MAX, explain_bvh)
CONTENDER(bvh_morton, "bvh-morton", bvh, bvh_how_for(x, "morton"), SIZE_MAX, explain_bvh)
CONTENDER(bvh_spatial, "bvh-spatial", bvh, bvh_how_for(x, "spatial"), SIZE_MAX, explain_bvh)

/* As in the published results of the SPD: so many cells an item, so deep. */
CONTENDER(grid_1, "grid-1", grid, ((grid_options){1, true, true, 0}), SIZE_MAX, explain_grid)
CONTENDER(grid_10, "grid-10", grid, ((grid_options){10, true, true, 0}), SIZE_MAX, explain_grid)
CONTENDER(octree_7, "octree-7", octree, ((octree_options){16, 7, true, true, 0}), SIZE_MAX,
          explain_octree)

/* Of the short book: they may be wrong (compare.h). */
CONTENDER(first_grid, "first-grid", first_items, ((first_items_options){first_use_grid, 0}),
          SIZE_MAX, NULL)
CONTENDER(first_octree, "first-octree", first_items, ((first_items_options){first_use_octree, 0}),
          SIZE_MAX, NULL)
CONTENDER(first_kdtree, "first-kdtree", first_items, ((first_items_options){first_use_kdtree, 0}),
          SIZE_MAX, NULL)
CONTENDER(first_bsp, "first-bsp", first_items, ((first_items_options){first_use_bsp, 0}),
          first_bsp_most, NULL)
CONTENDER(first_bvh, "first-bvh", first_items, ((first_items_options){first_use_bvh, 0}),
          SIZE_MAX, NULL)

static const contender *const contender_list[] = {
    &brute_contender,      &grid_contender,        &nested_contender, &octree_contender,
    &kdtree_contender,     &bsp_contender,         &bvh_contender,    &bvh_morton_contender,
    &bvh_spatial_contender, &grid_1_contender,     &grid_10_contender, &octree_7_contender,
    &first_grid_contender, &first_octree_contender, &first_kdtree_contender, &first_bsp_contender,
    &first_bvh_contender};
enum { usual_contenders = 9, full_contenders = 12,
       contenders = sizeof contender_list / sizeof *contender_list };

static inline const contender *contender_find(const char *name)
{
    for (int k = 0; k < contenders; k++)
        if (strcmp(contender_list[k]->name, name) == 0) return contender_list[k];
    return NULL;
}

static inline int contender_number(const contender *c)  /* in the list */
{
    int k = 0;
    while (contender_list[k] != c) k++;
    return k;
}

static inline bool contender_is_first(const contender *c)  /* it may be wrong */
{
    return contender_number(c) >= full_contenders;
}

static inline void contender_free(const contender *c, void *s)
{
    if (s) c->free(s);
    free(s);
}

static inline void *contender_build(const contender *c, const items *x, size_t most_bytes,
                                    failure *f)
{
    void *s = allocate(1, c->size);
    if (c->build(x, most_bytes, s, f)) return s;
    contender_free(c, s);
    return NULL;
}

#endif
