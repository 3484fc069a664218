/* instances.h: one mesh, many places (实例化): a tree of two levels (两级加速结构).
 *
 *   upper tree (14): boxes in the world      (A, a)_i         lower trees (15): one a mesh
 *           0                                    O' = A O + a
 *         /   \          leaf: instance i  ---   D' = A D       --->      0
 *       [i]   [j]                                same t                  / \  triangles
 *
 *   crowd c = {meshes, number_of_meshes, list, number_of_instances};
 *   instances x;
 *   failure f;
 *   if (!instances_build(&c, instances_defaults, &x, &f)) fail(f);    the meshes must outlive x,
 *   instance_hit h;                                                   the list need not
 *   bool instances_hit(&x, r, &h)         closest hit: h.h.shape is the triangle of the mesh of
 *                                         instance h.instance, h.h.t the t of r
 *   bool instances_occluded(&x, r)        is there any?
 *   vec3 instances_normal(&x, h)          unit shading normal in the world (normals.h)
 *   instances_free(&x);                   a zeroed one may be freed
 *
 * What is right: instance i is hit as mesh_hit of 07 says of its mesh and the ray (16.1); of all
 * instances the smallest t counts, at equal t the lowest instance, then the lowest triangle; the
 * interval is closed. `crowd_hit` of lab/flattened.h says just that, and every hit here equals it
 * bit for bit: boxes are grown by what rounding can move (16.3), pruned only where t_enter > tmax.
 *
 *   input                                             answer
 *   no instances, no meshes, an empty mesh            never hit
 *   a transform that is singular, not finite          never hit: see placing.h
 *   instance.mesh out of range; 2^31 instances;       false, f says so; *out is zeroed
 *     a mesh beyond items_most (09)
 *
 * Memory: 104 bytes an instance (float: 56) and 4 to find it again, up to 64 for its nodes; the
 * meshes and their trees once. An instance of instances is not offered: its leaf would search a
 * tree of this kind, and nothing here would change but the stack of a search.
 */
#ifndef INSTANCES_H
#define INSTANCES_H

#include "build.h"
#include "normals.h"

typedef struct { hit h; uint32_t instance; } instance_hit;

typedef struct { search_work upper, lower; } instances_work;  /* upper.tests: instances */

/* ---------------------------------------------------------------------------------------------- */
typedef struct {
    const instances *x;
    uint32_t *triangle;     /* of the best hit so far */
    search_work *lower;     /* NULL: does not count */
    bool naive;             /* normalises */
} instances_context;

/* With what (16.3) asks of a ray from here. */
fast_inline box_ray instances_box_ray(ray r, const bvh_box *root, const void *context)
{
    const instances *x = ((const instances_context *)context)->x;
    if (x->by_origin < 0) return box_ray_naive(r, root, NULL);
    return box_ray_owing(r, root, x->by_origin * vlargest(r.o));
}

fast_inline bool instances_leaf(const void *context, uint32_t first, uint32_t count, query *q,
                                bool any)
{
    const instances_context *c = context;
    bool found = false;
    for (const placed *p = c->x->place + first, *end = p + count; p < end; p++) {
        ray r;
        hit h;
        if (!instance_ray(&p->to_object, q->r, &r)) continue;
        if (c->naive) r.d = vunit(r.d);
        if (!bvh8_ask(&c->x->lower[p->mesh], r, bvh8_skip_none, any ? NULL : &h, c->lower))
            continue;
        if (any) return true;
        uint32_t k = h.shape;
        h.shape = p->index;  /* at equal t the lowest instance */
        if (!query_improves(q, h)) continue;
        *c->triangle = k;
        found = true;
    }
    return found;
}

fast_inline bool instances_walk(const instances *x, ray r, bool any, bool naive, instance_hit *out,
                                instances_work *work)
{
    uint32_t k = no_shape;
    hit h;
    const instances_context c = {x, &k, work ? &work->lower : NULL, naive};
    if (!tree_search(&x->tree, r, instances_box_ray, instances_leaf, &c, any, &h,
                     work ? &work->upper : NULL)) return false;
    if (any) return true;
    out->instance = h.shape;
    h.shape = k;
    out->h = h;
    return true;
}

fast_inline bool instances_search(const instances *x, ray r, bool any, instance_hit *out,
                                  instances_work *work)
{
    return instances_walk(x, r, any, false, out, work);
}

STRUCTURE_VERBS_OF(instances, instance_hit, instances_work)

/* Of the point that h says, by its u and v; (0,0,0) if a triangle has no area. */
static inline vec3 instances_normal(const instances *x, instance_hit h)
{
    const placed *p = &x->place[x->where[h.instance]];
    return normal_to_world(&p->to_object, mesh_normal(&x->mesh[p->mesh], h.h.shape, h.h.u, h.h.v));
}

#endif
