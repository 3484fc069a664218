/* bvh_mesh.h: the bounding volume hierarchy of the triangles of a mesh, and of nothing else: a
 * program that has only triangles need not know cones and polygons.
 *
 *   bvh_mesh b;
 *   bool bvh_mesh_build(&m, bvh_defaults, &b, &f)   the tree copies what it needs of the mesh
 *   bool bvh_mesh_hit(&b, r, &h), ..                the verbs of structure.h (09)
 *
 *   input                                      answer
 *   no triangles                               never hit
 *   a corner with NaN or infinity              never hit, as in 04; not in the tree, spoils no box
 *   no area                                    never hit, as in 04
 *   a million triangles on one place           depth 20, the lowest index wins
 *
 * Leaves copy the corners, 80 bytes a triangle (40 in float), in the order of the leaves. Indices
 * into the mesh would take 16, but where the mesh is larger than the cache each corner is then
 * waited for: a million triangles take a quarter longer to search. Nodes: some 14 bytes a triangle.
 */
#ifndef BVH_MESH_H
#define BVH_MESH_H

#include "../07_mesh/mesh.h"
#include "../09_aabb/part.h"
#include "search.h"

typedef struct { vec3 corner[3]; uint32_t index; } bvh_triangle;
typedef struct { bvh_tree tree; bvh_triangle *triangle; } bvh_mesh;

/* ---------------------------------------------------------------------------------------------- */

/* False for a triangle that cannot be hit because a corner is not finite. */
static inline bool triangle_item(const mesh *m, size_t i, bvh_item *out)
{
    triangle t = mesh_triangle(m, i);
    if (!vfinite(t.a) || !vfinite(t.b) || !vfinite(t.c)) return false;
    *out = box_between(vmin(vmin(t.a, t.b), t.c), vmax(vmax(t.a, t.b), t.c));
    out->index = (uint32_t)i;
    return true;
}

/* For spatial.h. |b - a| <= 2 M, M the largest coordinate. In part_crossing b - a, the three
 * roundings of s and the product are off by 5 eps / 2 of 2 M, the sum by eps / 2 of M: 5.5 eps M.
 * The box gets 6 eps M more all round. Where b - a might overflow, it stays what it was. */
static inline bool triangle_clip(const void *context, const bvh_item *item, int axis, float lo,
                                 float hi, bvh_box *out)
{
    triangle t = mesh_triangle(context, item->index);
    vec3 all = vmax(vmax(vmax(t.a, t.b), t.c), vneg(vmin(vmin(t.a, t.b), t.c)));
    real far = vaxis(all, vlongest(all)), more = 6 * real_epsilon * far;  /* far: M */
    const double p[3][3] = {{(double)t.a.x, (double)t.a.y, (double)t.a.z},
                            {(double)t.b.x, (double)t.b.y, (double)t.b.z},
                            {(double)t.c.x, (double)t.c.y, (double)t.c.z}};
    part_box in = part_nothing;
    *out = *item;
    if (far > real_largest / 4) return true;
    for (int i = 0; i < 3; i++)
        part_edge(&in, p[i], p[i < 2 ? i + 1 : 0], axis, (double)lo, (double)hi);
    vec3 least = {(real)in.lo[0], (real)in.lo[1], (real)in.lo[2]};
    vec3 most = {(real)in.hi[0], (real)in.hi[1], (real)in.hi[2]}, pad = {more, more, more};
    bvh_box part = box_between(vsub(least, pad), vadd(most, pad));
    part.low[axis] = float_max(part.low[axis], lo);
    part.minus_high[axis] = float_max(part.minus_high[axis], -hi);
    bool some = box_shared(&part, item, &part);
    *out = box_numbered(&part, item->index, 0);
    return some;
}

static inline void bvh_mesh_free(bvh_mesh *b)
{
    tree_free(&b->tree);
    free(b->triangle);
    b->triangle = NULL;
}

/* The items' boxes become the records of the leaves. */
static inline bool bvh_mesh_take(const mesh *m, bvh_options how, bvh_input *in, bvh_mesh *out,
                                 failure *f)
{
    for (size_t i = 0; i < m->triangles; i++) in->n += triangle_item(m, i, &in->item[in->n]);
    if (!tree_build_input(in, how, &out->tree, f)) return false;
    size_t n = out->tree.items;
    out->triangle = tree_array(&out->tree, n, sizeof *out->triangle);
    if (!out->triangle) return memory_failed(f, "BVH", n, how.most_bytes);
    for (size_t i = 0; i < n; i++) {
        triangle t = mesh_triangle(m, in->item[i].index);
        out->triangle[i] = (bvh_triangle){{t.a, t.b, t.c}, in->item[i].index};
    }
    memory_gives(&out->tree.held, in->room, sizeof *in->item);
    return true;
}

/* False, and f says why, if it needs more than how.most_bytes or than there are, and for 2^31
 * triangles (2^28 where they are cut): places and nodes are counted in 32 bits. O(n log n). */
static inline bool bvh_mesh_build(const mesh *m, bvh_options how, bvh_mesh *out, failure *f)
{
    const bvh_rule *rule = bvh_rule_find(how.rule);
    bvh_input in = {.clip = triangle_clip, .context = m};
    *out = (bvh_mesh){.triangle = NULL};
    in.room = rule && rule->through ? bvh_most_cuts * m->triangles : m->triangles;
    in.item = memory_array(&(memory){.most = how.most_bytes}, in.room, sizeof *in.item);
    if (!in.item) return memory_failed(f, "BVH", in.room, how.most_bytes);
    bool built = bvh_mesh_take(m, how, &in, out, f);
    free(in.item);
    if (!built) bvh_mesh_free(out);
    return built;
}

fast_inline bool bvh_mesh_leaf(const void *context, uint32_t first, uint32_t count, query *q,
                               bool any)
{
    const bvh_mesh *b = context;
    const bvh_triangle *t = b->triangle + first, *end = t + count;
    bool found = false;
    hit h;
    for (; t < end; t++) {
        const vec3 *c = t->corner;
        if (!triangle_hit_corners(&c[0], &c[1], &c[2], &q->shear, q->r, &h)) continue;
        if (any) return true;
        h.shape = t->index;
        found |= query_improves(q, h);
    }
    return found;
}

fast_inline bool bvh_mesh_search(const bvh_mesh *b, ray r, bool any, hit *out,
                                 search_work *work)
{
    return tree_search(&b->tree, r, box_ray_of, bvh_mesh_leaf, b, any, out, work);
}

STRUCTURE_VERBS(bvh_mesh)

#endif
