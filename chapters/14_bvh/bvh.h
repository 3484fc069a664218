/* bvh.h: the bounding volume hierarchy (层次包围盒, BVH) of a mesh, and of a scene of shapes.
 *
 *   bvh b;
 *   bvh_build(&m, bvh_defaults, &b);       the tree copies what it needs of the mesh
 *   bool bvh_hit(&b, r, &h)                the very hit (t, u, v, shape) that mesh_hit of 07 gives
 *   bool bvh_occluded(&b, r)               is there any? the answer that mesh_occluded gives
 *   bvh_stats s = bvh_stats_of(&b.tree)    size, depth, cost by the heuristic, overlap: stats.h
 *   bvh_free(&b);                          a zeroed bvh may be freed
 *   bvh_hit_naive(&b, r, &h)               without the care of node.h: loses hits
 *   bvh_hit_counted(&b, r, &h, &work)      the same hits; adds what they took to `work`
 *
 * The tree does not cut space but the set of triangles: each triangle is in one leaf. Its boxes may
 * overlap; what is in one leaf may lie in the boxes of others, and a ray may have to look into
 * several boxes at the same place. (BVH_SPATIAL does cut: there a triangle may be in several.)
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
#ifndef BVH_H
#define BVH_H

#include "../07_mesh/mesh.h"
#include "search.h"

typedef struct { vec3 corner[3]; uint32_t index; } bvh_triangle;
typedef struct { bvh_tree tree; bvh_triangle *triangle; } bvh;

/* ---------------------------------------------------------------------------------------------- */

/* False for a triangle that cannot be hit because a corner is not finite. */
static inline bool triangle_item(const mesh *m, size_t i, bvh_item *out)
{
    triangle t = mesh_triangle(m, i);
    if (!vfinite(t.a) || !vfinite(t.b) || !vfinite(t.c)) return false;
    out->box = box_between(vmin(vmin(t.a, t.b), t.c), vmax(vmax(t.a, t.b), t.c));
    out->index = (uint32_t)i;
    return true;
}

/* For tree_spatial. The triangle's part in a slab: its corners there, and the points a + (b - a) s
 * where its edges cross the two sides. |b - a| <= 2 M, M the largest coordinate. b - a, the three
 * roundings of s and the product are off by 5 eps / 2 of 2 M, the sum by eps / 2 of M: 5.5 eps M.
 * The box gets 6 eps M more all round. Where b - a might overflow, it stays what it was. */
static inline bool triangle_clip(const void *context, const bvh_item *item, int axis, float lo,
                                 float hi, bvh_box *out)
{
    triangle t = mesh_triangle(context, item->index);
    vec3 p[3] = {t.a, t.b, t.c}, most = {-real_infinity, -real_infinity, -real_infinity};
    vec3 least = vneg(most), all = vmax(vmax(vmax(t.a, t.b), t.c), vneg(vmin(vmin(t.a, t.b), t.c)));
    real side[2] = {(real)lo, (real)hi}, far = vaxis(all, vlongest(all));  /* M */
    *out = item->box;
    if (far > real_largest / 4) return true;
    for (int i = 0; i < 3; i++) {
        vec3 a = p[i], b = p[i < 2 ? i + 1 : 0];
        real from = vaxis(a, axis), to = vaxis(b, axis);
        if (from >= side[0] && from <= side[1]) least = vmin(a, least), most = vmax(a, most);
        for (int j = 0; j < 2; j++) {
            if ((from < side[j]) == (to < side[j])) continue;
            vec3 c = vmadd(a, vsub(b, a), (side[j] - from) / (to - from));
            least = vmin(c, least), most = vmax(c, most);
        }
    }
    real more = 6 * real_epsilon * far;
    vec3 pad = {more, more, more};
    bvh_box part = box_between(vsub(least, pad), vadd(most, pad));
    part.side[axis] = float_max(part.side[axis], lo);
    part.side[3 + axis] = float_min(part.side[3 + axis], hi);
    return box_shared(&part, &item->box, out);
}

static inline void bvh_free(bvh *b)
{
    tree_free(&b->tree);
    free(b->triangle);
    b->triangle = NULL;
}

/* The program ends if there is no memory, and if there are 2^31 triangles, with BVH_SPATIAL 2^28:
 * places and nodes are counted in 32 bits. O(n log n). */
static inline void bvh_build(const mesh *m, bvh_options how, bvh *out)
{
    bool cuts = how.strategy == BVH_SPATIAL;
    int most = cuts ? 28 : 31;
    if (m->triangles >> most)
        die(2, "%zu triangles: fewer than 2^%d fit", m->triangles, most);
    size_t n = 0, room = cuts ? spatial_most * m->triangles : m->triangles;
    bvh_item *item = allocate(room, sizeof *item);
    for (size_t i = 0; i < m->triangles; i++) n += triangle_item(m, i, &item[n]);
    if (cuts) tree_spatial(item, n, room, how, triangle_clip, m, &out->tree);
    else tree_build(item, n, how, &out->tree);
    n = out->tree.items;
    out->triangle = allocate(n, sizeof *out->triangle);
    tree_takes(&out->tree, n * sizeof *out->triangle);
    for (size_t i = 0; i < n; i++) {
        triangle t = mesh_triangle(m, item[i].index);
        out->triangle[i] = (bvh_triangle){{t.a, t.b, t.c}, item[i].index};
    }
    free(item);
    tree_gives(&out->tree, room * sizeof *item);
}

__attribute__((always_inline))
static inline bool bvh_leaf(const void *context, uint32_t first, uint32_t count, query *q,
                            bool any)
{
    const bvh *b = context;
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

static inline bool bvh_hit(const bvh *b, ray r, hit *out)
{
    return tree_search(&b->tree, r, box_ray_of, bvh_leaf, b, false, out, NULL);
}

/* With boxes tested as they come: see box_ray_naive. */
static inline bool bvh_hit_naive(const bvh *b, ray r, hit *out)
{
    return tree_search(&b->tree, r, box_ray_naive, bvh_leaf, b, false, out, NULL);
}

static inline bool bvh_occluded(const bvh *b, ray r)
{
    return tree_search(&b->tree, r, box_ray_of, bvh_leaf, b, true, NULL, NULL);
}

static inline bool bvh_hit_counted(const bvh *b, ray r, hit *out, bvh_work *work)
{
    return tree_search(&b->tree, r, box_ray_of, bvh_leaf, b, false, out, work);
}

static inline bool bvh_occluded_counted(const bvh *b, ray r, bvh_work *work)
{
    return tree_search(&b->tree, r, box_ray_of, bvh_leaf, b, true, NULL, work);
}

#endif
