/* first.h: a bounding volume hierarchy (层次包围盒, BVH): not space is cut, but the set of triangles.
 * Wrong far away: from 1e4 sizes in float, 1e13 in double, rounding exceeds the hair by which
 * boxes are larger, and hits are lost. bvh.h mends it. 1e6 triangles take seconds. */
#ifndef FIRST_BVH_H
#define FIRST_BVH_H
#include "../07_mesh/first.h"
#include "../09_aabb/first.h"

enum { first_bvh_leaf = 4 };

typedef struct {
    aabb box;         /* of all triangles below, and a hair more */
    int first, n;     /* they are order[first .. first + n) */
    int left, right;  /* the two children; 0: this is a leaf */
} first_bvh_node;     /*                                                                  (14.1) */

typedef struct {
    const first_mesh *m;
    int *order;       /* [m->n] numbers of the triangles: those of a node stand side by side */
    first_bvh_node *node;
    int nodes;
    real hair;
} first_bvh;

/* Where the i-th triangle in order is along an axis: the sum of its corners, thrice its centre. */
static inline real first_bvh_centre(const first_bvh *b, int i, int axis)
{
    triangle t = b->m->tri[b->order[i]];
    return vaxis(t.a, axis) + vaxis(t.b, axis) + vaxis(t.c, axis);
}

static inline void first_bvh_swap(first_bvh *b, int i, int j)
{
    int o = b->order[i];
    b->order[i] = b->order[j], b->order[j] = o;
}

/* Moves the triangle with the k-th lowest centre to place k, lower ones before it, in O(n): like
 * quicksort, but only the part that holds k is gone on with (快速选择). */
static inline void first_bvh_select(first_bvh *b, int lo, int hi, int k, int axis)
{
    while (lo < hi) {
        real pivot = first_bvh_centre(b, (lo + hi) / 2, axis);
        int i = lo, j = hi;
        while (i <= j) {
            while (first_bvh_centre(b, i, axis) < pivot) i++;
            while (first_bvh_centre(b, j, axis) > pivot) j--;
            if (i <= j) first_bvh_swap(b, i++, j--);
        }
        if (k <= j) hi = j;
        else if (k >= i) lo = i;
        else return;
    }
}

/* The surface area heuristic (表面积启发式): a line that meets the box meets a part of it with the
 * probability area(part) / area(box) (14.5), so a cut costs
 *     area(L) n(L) + area(R) n(R)                                                        (14.6)
 * and the cheapest of 15 planes on each axis is taken. Returns n(L), or 0: all centres are one. */
static inline int first_bvh_sah(first_bvh *b, int first, int n)
{
    real best = real_infinity, best_cut = 0;
    int best_axis = 0, left = 0;
    for (int axis = 0; axis < 3; axis++) {
        real lo = real_infinity, hi = -real_infinity;
        for (int i = first; i < first + n; i++) {
            lo = real_min(lo, first_bvh_centre(b, i, axis));
            hi = real_max(hi, first_bvh_centre(b, i, axis));
        }
        for (int k = 1; k < 16; k++) {
            real cut = lo + (hi - lo) * k / 16;
            aabb box[2] = {aabb_empty(), aabb_empty()};
            int count[2] = {0, 0};
            for (int i = first; i < first + n; i++) {
                int side = first_bvh_centre(b, i, axis) < cut ? 0 : 1;
                box[side] = aabb_union(box[side], first_triangle_box(b->m->tri[b->order[i]]));
                count[side]++;
            }
            real cost = aabb_area(box[0]) * count[0] + aabb_area(box[1]) * count[1];
            if (!count[0] || !count[1] || !(cost < best)) continue;
            best = cost, best_cut = cut, best_axis = axis;
        }
    }
    for (int i = first; best < real_infinity && i < first + n; i++)
        if (first_bvh_centre(b, i, best_axis) < best_cut) first_bvh_swap(b, i, first + left++);
    return left;
}

/* The node for order[first .. first + n), and all below it, of which `sah` levels, no more, by the
 * heuristic: it may cut off one triangle at a time. Returns the node's number. */
static inline int first_bvh_split(first_bvh *b, int first, int n, int sah)
{
    int me = b->nodes++, left = 0;
    aabb box = aabb_empty();
    for (int i = first; i < first + n; i++)
        box = aabb_union(box, first_triangle_box(b->m->tri[b->order[i]]));
    b->node[me] = (first_bvh_node){first_aabb_pad(box, b->hair), first, n, 0, 0};
    if (n <= first_bvh_leaf) return me;

    /* By the heuristic; or across the longest axis, by the triangle in the middle. */
    if (sah-- > 0) left = first_bvh_sah(b, first, n);
    if (left == 0) {
        left = n / 2;
        first_bvh_select(b, first, first + n - 1, first + left, vlongest(vsub(box.hi, box.lo)));
    }
    b->node[me].left = first_bvh_split(b, first, left, sah);
    b->node[me].right = first_bvh_split(b, first + left, n - left, sah);
    return me;
}

static inline first_bvh first_bvh_build(const first_mesh *m, bool sah)
{
    first_bvh b = {.m = m, .order = allocate((size_t)m->n, sizeof(int)),
                   .node = allocate(2 * (size_t)m->n + 1, sizeof(first_bvh_node))};
    (void)first_triangles_box(m->tri, m->n, &b.hair);
    for (int i = 0; i < m->n; i++) b.order[i] = i;
    first_bvh_split(&b, 0, m->n, sah ? 100 : 0);
    return b;
}

/* A ray that misses the box misses everything in it.                                      (9.5) */
static inline bool first_bvh_visit(const first_bvh *b, int i, ray *r, hit *out)
{
    const first_bvh_node *node = &b->node[i];
    real t_enter;
    bool found = false;
    if (!first_aabb_hit(node->box, *r, &t_enter) || t_enter > r->tmax) return false;
    if (node->left == 0) {
        for (int k = node->first; k < node->first + node->n; k++)
            if (first_mesh_test(b->m, b->order[k], r, out)) found = true;
        return found;
    }
    if (first_bvh_visit(b, node->left, r, out)) found = true;
    if (first_bvh_visit(b, node->right, r, out)) found = true;
    return found;
}

static inline bool first_bvh_hit(const first_bvh *b, ray r, hit *out)
{
    r.d = vadd(r.d, vec(0, 0, 0));  /* -0.0 + 0 is 0, which (9.1) can take */
    return first_bvh_visit(b, 0, &r, out);
}

static inline void first_bvh_free(first_bvh *b)
{
    free(b->order), free(b->node);
    *b = (first_bvh){.m = NULL};
}
#endif
