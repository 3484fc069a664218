/* build.h: building the tree of two levels: trees of the meshes, boxes of the instances, a tree of
 * these.
 *
 *   instances_build(&c, how, &x, &f)      false: what f says; *out may still be freed
 *   instances_free(&x)
 *
 *   how.boxes                INSTANCES_CORNERS, _POINTS, _NAIVE: below
 *   how.upper                of the tree over the instances, as in 14; an instance costs far more
 *                            than a triangle: one in a leaf
 *   how.lower                of the trees of the meshes, as in 15
 */
#ifndef INSTANCES_BUILD_H
#define INSTANCES_BUILD_H

#include "../14_bvh/search.h"
#include "../15_wide_bvh/bvh8.h"
#include "placing.h"

typedef enum {
    INSTANCES_CORNERS,   /* boxes by the eight corners of the mesh's box: loose; O(1) an instance */
    INSTANCES_POINTS,    /* by all points of the mesh: tight; O(points) an instance */
    INSTANCES_NAIVE      /* the same, but neither box nor ray pays for rounding: loses hits */
} instances_boxes;

typedef struct {
    instances_boxes boxes;
    bvh_options upper;
    bvh8_options lower;
} instances_options;

#define instances_defaults \
    ((instances_options){INSTANCES_POINTS, bvh_leaves(1, 4), bvh8_defaults})

typedef struct { affine to_object; uint32_t mesh, index; } placed;  /* in the order of the leaves */

typedef struct {
    bvh_tree tree;        /* over boxes of instances */
    placed *place;        /* [tree.items] */
    uint32_t *where;      /* [n] place of each instance; no_shape: it is never hit */
    real by_origin;       /* of (16.3), the largest: what each ray pays for its |O|; -1: naive */
    size_t n, meshes;
    const mesh *mesh;     /* [meshes] the caller's */
    bvh8 *lower;          /* [meshes] */
    aabb *box;            /* [meshes] of what of each can be hit */
    size_t bytes;         /* of both levels, without the meshes themselves */
} instances;

/* ---------------------------------------------------------------------------------------------- */

static inline void instances_free(instances *x)
{
    for (size_t i = 0; i < x->meshes && x->lower; i++) bvh8_free(&x->lower[i]);
    tree_free(&x->tree);
    free(x->lower), free(x->box), free(x->place), free(x->where);
    *x = (instances){0};
}

/* The points of triangles that can be hit, each once; *n of them. */
static inline vec3 *mesh_points(const mesh *m, size_t *n)
{
    const items x = items_of_mesh(m);
    vec3 *p = allocate(m->vertices, sizeof *p);
    bool *used = allocate(m->vertices, sizeof *used);
    for (size_t i = 0; i < m->triangles; i++) {
        aabb box;
        if (!items_bounds(&x, i, &box)) continue;
        for (size_t k = 3 * i; k < 3 * i + 3; k++) used[m->index[k]] = true;
    }
    *n = 0;
    for (size_t i = 0; i < m->vertices; i++)
        if (used[i]) p[(*n)++] = m->v[i];
    free(used);
    return p;
}

/* What the upper tree needs of one instance; false if it is never hit. */
static inline bool instance_item(const instances *x, instances_boxes boxes, const instance *s,
                                 const vec3 *points, size_t n, bvh_box *box, placed *place,
                                 real *by_origin)
{
    const aabb *b = &x->box[s->mesh];
    if (aabb_is_empty(*b) || !instance_inverse(s->to_world, &place->to_object)) return false;
    placing p = placing_of(s->to_world, place->to_object, aabb_reach(*b));
    aabb w = boxes == INSTANCES_CORNERS ? box_of_corners(s->to_world, b)
                                        : box_of_points(s->to_world, points, n);
    *box = boxes == INSTANCES_NAIVE ? box_padded_naive(&w) : box_padded(&w, p.fixed);
    *by_origin = boxes == INSTANCES_NAIVE ? -1 : p.by_origin;
    place->mesh = s->mesh;
    return true;
}

/* Boxes of all instances that can be hit, mesh by mesh, so that the points of one are collected at
 * a time. items[] gets them, all[] what goes with them. */
static inline void instances_items(instances *x, const crowd *c, instances_boxes boxes,
                                   bvh_item *item, placed *all)
{
    size_t n = 0, count = 0;
    x->by_origin = boxes == INSTANCES_NAIVE ? -1 : 0;
    for (size_t k = 0; k < c->meshes; k++) {
        bool tight = boxes != INSTANCES_CORNERS;
        vec3 *points = tight ? mesh_points(&c->mesh[k], &count) : NULL;
        for (size_t i = 0; i < c->n; i++) {
            real by_origin;
            if (c->list[i].mesh != k) continue;
            if (!instance_item(x, boxes, &c->list[i], points, count, &item[n], &all[i],
                               &by_origin)) continue;
            item[n].index = (uint32_t)i;
            n++, x->by_origin = real_max(x->by_origin, by_origin);
        }
        free(points);
    }
    x->tree.items = n;
}

static inline bool crowd_is_usable(const crowd *c, failure *f)
{
    if (c->n >> 31) return failed(f, 2, "%zu instances: fewer than 2^31 fit", c->n);
    for (size_t i = 0; i < c->n; i++)
        if (c->list[i].mesh >= c->meshes)
            return failed(f, 2, "instance %zu: mesh %u; there are %zu meshes, counted from 0", i,
                          (unsigned)c->list[i].mesh, c->meshes);
    return true;
}

/* O(T log T) for T triangles of the meshes, O(n log n) for n instances; tight boxes: and n times
 * the points of a mesh. */
static inline bool instances_build(const crowd *c, instances_options how, instances *out,
                                   failure *f)
{
    *out = (instances){0};
    if (!crowd_is_usable(c, f)) return false;
    out->n = c->n, out->meshes = c->meshes, out->mesh = c->mesh;
    out->lower = allocate(c->meshes, sizeof *out->lower);
    out->box = allocate(c->meshes, sizeof *out->box);
    for (size_t k = 0; k < c->meshes; k++) {
        const items x = items_of_mesh(&c->mesh[k]);
        if (!items_all_bounds(&x, &out->box[k], f)
            || !bvh8_build(&x, how.lower, &out->lower[k], f)) {
            instances_free(out);
            return false;
        }
        out->bytes += out->lower[k].room.bytes;
    }
    bvh_item *item = allocate(c->n, sizeof *item);
    placed *all = allocate(c->n, sizeof *all);
    instances_items(out, c, how.boxes, item, all);
    size_t n = out->tree.items;
    if (!tree_build(item, n, how.upper, &out->tree, f)) {
        free(item), free(all), instances_free(out);
        return false;
    }
    out->place = allocate(n, sizeof *out->place);
    out->where = allocate(c->n, sizeof *out->where);
    for (size_t i = 0; i < c->n; i++) out->where[i] = no_shape;
    for (size_t i = 0; i < n; i++) {
        out->place[i] = all[item[i].index];
        out->place[i].index = item[i].index;
        out->where[item[i].index] = (uint32_t)i;
    }
    out->tree.held.bytes += n * (sizeof *all - sizeof *item) + c->n * sizeof(uint32_t);
    out->bytes += out->tree.held.bytes;
    free(item), free(all);
    return true;
}

#endif
