/* collapse.h: the wide tree, from a binary one (合并, collapse).
 *
 *   bool bvh8_build(&x, bvh8_defaults, &w, &f)      false: f says why: coordinates too large, too
 *                                                   many items, options out of range
 *
 *   1. Items: their boxes in the tree's frame. What can't be hit is left out.
 *   2. A binary tree: build.h.
 *   3. Collapse. Which of the binary tree's nodes remain? Of a subtree s that may take up to j
 *      places in the node above, the cheapest way costs                                    (15.5)
 *
 *          C(s, 1) = min(area(s) + C(s, 8), area(s) leaf_cost)      one place: a node, or a leaf
 *          C(s, j) = min over k of C(left, k) + C(right, j - k), or C(s, j - 1)
 *
 *      from the leaves up: eight numbers a node, and no better collapse of this tree exists.
 *   4. Nodes and blocks, in the order of the search: depth first.
 *
 * Source: H. Ylitie, T. Karras, S. Laine, "Efficient Incoherent Ray Traversal on GPUs Through
 * Compressed Wide BVHs", HPG 2017, section 3.1.
 */
#ifndef WIDE_COLLAPSE_H
#define WIDE_COLLAPSE_H

#include "build.h"

typedef struct { float cost[8]; } bvh8_costs;

/* ---------------------------------------------------------------------------------------------- */

/* Step 1, a piece of it. */
static inline void bvh8_item_job(size_t piece, void *context)
{
    bvh8_builder *b = context;
    const bvh8 *w = b->w;
    size_t end = (piece + 1) * bvh8_chunk < w->x.n ? (piece + 1) * bvh8_chunk : w->x.n;
    for (size_t i = piece * bvh8_chunk; i < end; i++) {
        aabb box;
        bvh8_bound *out = &b->item[i];
        out->first = no_shape;
        if (!items_bounds(&w->x, i, &box)) continue;
        if (w->x.m) {
            triangle t = mesh_triangle(w->x.m, i);
            if (vzero(triangle_cross(t.a, t.b, t.c))) continue;
        }
        vec3 lo = bvh8_into(w, box.lo), hi = bvh8_into(w, box.hi);
        out->lo[0] = float_below(lo.x), out->minus_hi[0] = float_below(-hi.x);
        out->lo[1] = float_below(lo.y), out->minus_hi[1] = float_below(-hi.y);
        out->lo[2] = float_below(lo.z), out->minus_hi[2] = float_below(-hi.z);
        out->first = (uint32_t)i, out->count = 0;
    }
}

static inline bool bvh8_is_leaf(const bvh8_builder *b, uint32_t at)
{
    return b->node[at].count <= (uint32_t)b->how.leaf;
}

static inline float bvh8_leaf_price(const bvh8_builder *b, const bvh8_bound *n)
{
    if (n->count > 8) return INFINITY;
    double tests = b->w->x.m ? b->how.leaf_cost : b->how.shape_cost * n->count;
    return (float)(bvh8_area(&n->all) * tests);
}

/* (15.5) below `at`. pick[at][j - 1]: the best k; 0: C(s, j - 1), or a leaf. */
static inline bvh8_costs bvh8_price(const bvh8_builder *b, uint32_t at)
{
    const bvh8_bound *n = &b->node[at];
    float leaf = bvh8_leaf_price(b, n);
    uint8_t *pick = b->pick[at];
    bvh8_costs out;
    memset(pick, 0, 8);
    for (int j = 0; j < 8; j++) out.cost[j] = leaf;
    if (bvh8_is_leaf(b, at)) return out;
    bvh8_costs l = bvh8_price(b, n->first), r = bvh8_price(b, n->first + 1);
    for (int j = 2; j <= 8; j++) {
        float best = INFINITY;
        pick[j - 1] = 1;  /* areas that overflowed */
        for (int k = 1; k < j; k++) {
            float c = l.cost[k - 1] + r.cost[j - k - 1];
            if (c < best) best = c, pick[j - 1] = (uint8_t)k;
        }
        out.cost[j - 1] = best;
    }
    out.cost[0] = out.cost[b->how.width - 1] + (float)bvh8_area(&n->all), pick[0] = 1;
    if (leaf <= out.cost[0]) out.cost[0] = leaf, pick[0] = 0;
    for (int j = 1; j < 8; j++)
        if (out.cost[j - 1] <= out.cost[j]) out.cost[j] = out.cost[j - 1], pick[j] = 0;
    return out;
}

/* ---------------------------------------------------------------------------------------------- */

/* Adds to list[] the nodes that take the `places` places that (15.5) gave to `at`. */
static inline int bvh8_places(const bvh8_builder *b, uint32_t at, int places, uint32_t *list, int n)
{
    const uint8_t *pick = b->pick[at];
    while (places > 1 && pick[places - 1] == 0) places--;
    if (places == 1) {
        list[n] = at;
        return n + 1;
    }
    uint32_t first = b->node[at].first;
    n = bvh8_places(b, first, pick[places - 1], list, n);
    return bvh8_places(b, first + 1, places - pick[places - 1], list, n);
}

/* The children of the wide node that `at` becomes; of a root that is a leaf, itself alone. */
static inline int bvh8_children(const bvh8_builder *b, uint32_t at, uint32_t *list)
{
    const uint8_t *pick = b->pick[at];
    int places = b->how.width;
    uint32_t first = b->node[at].first;
    list[0] = at;
    if (!pick[0]) return 1;
    while (places > 2 && pick[places - 1] == 0) places--;
    int left = pick[places - 1] ? pick[places - 1] : 1;
    return bvh8_places(b, first + 1, places - left, list, bvh8_places(b, first, left, list, 0));
}

static inline void bvh8_put(bvh8_node *node, int k, const bvh8_bound *box, uint32_t child)
{
    for (int s = 0; s < 3; s++) {
        node->side[s][k] = box ? box->lo[s] : INFINITY;
        node->side[3 + s][k] = box ? -box->minus_hi[s] : -INFINITY;
    }
    node->child[k] = child;
}

/* Step 4 below `at`; returns its number. Without arrays it only counts what they must hold. */
static inline uint32_t bvh8_emit(bvh8_builder *b, uint32_t at, int depth)
{
    bvh8 *w = b->w;
    if (depth > 1 && b->pick[at][0] == 0) {
        if (b->leaf) b->leaf[w->blocks] = at;
        return bvh8_leaf | (uint32_t)w->blocks++;
    }
    uint32_t me = (uint32_t)w->nodes++, list[8];
    int n = bvh8_children(b, at, list);
    if (depth > w->depth) w->depth = depth;
    for (int k = 0; k < 8; k++) {
        uint32_t child = k < n ? bvh8_emit(b, list[k], depth + 1) : 0;
        if (w->node) bvh8_put(&w->node[me], k, k < n ? &b->node[list[k]] : NULL, child);
    }
    return me;
}

/* Is the corner, as a float in the frame, the very corner? Then a block holds what `real` needs. */
static inline bool bvh8_put_corner(const bvh8 *w, vec3 p, eight row[3], uint32_t k)
{
    vec3 q = bvh8_into(w, p);
    float x = (float)q.x, y = (float)q.y, z = (float)q.z;
    vec3 back = bvh8_back(w, x, y, z);
    row[0][k] = x, row[1][k] = y, row[2][k] = z;
    return back.x == p.x && back.y == p.y && back.z == p.z;
}

/* Blocks of triangles, or lists of shapes, a piece of them. */
static inline void bvh8_fill_job(size_t piece, void *context)
{
    bvh8_builder *b = context;
    bvh8 *w = b->w;
    bool exact = true;
    for (size_t i = 256 * piece; i < w->blocks && i < 256 * (piece + 1); i++) {
        uint32_t at = b->leaf[i], count = b->node[at].count;
        uint32_t *index = w->block ? w->block[i].index : w->list[i].index;
        while (!bvh8_is_leaf(b, at)) at = b->node[at].first;
        const bvh8_bound *item = &b->item[b->node[at].first];
        for (uint32_t k = 0; k < 8; k++) {
            index[k] = k < count ? item[k].first : no_shape;
            if (!w->block) continue;
            eight *row = w->block[i].corner;
            triangle t = mesh_triangle(w->x.m, item[k < count ? k : 0].first);
            exact = bvh8_put_corner(w, t.a, row, k) && exact;
            exact = bvh8_put_corner(w, t.b, row + 3, k) && exact;
            exact = bvh8_put_corner(w, t.c, row + 6, k) && exact;
        }
    }
    if (!exact) atomic_store(&b->inexact, true);
}

/* ---------------------------------------------------------------------------------------------- */

/* Its centre is 0 unless the items lie far from there: then floats stay what they are. */
static inline void bvh8_frame(bvh8 *w, aabb all)
{
    vec3 centre = aabb_centre(all), half = vsub(all.hi, centre);
    real size = vaxis(half, vlongest(half)), far = fabs(vaxis(centre, vlongest(centre)));
    int e, most = real_is_float ? 100 : 1000;
    w->centre = far <= 8 * size ? (vec3){0, 0, 0} : centre;
    if (far <= 8 * size) size += far;
    (void)frexp(size, &e);
    e = e > most ? most : e < -most ? -most : e;
    w->scale = size > 0 ? ldexp((real)1, -e) : 1;
}

static inline void *bvh8_aligned(size_t n, size_t size)
{
    void *p = aligned_alloc(64, (n * size + 63) / 64 * 64);
    if (!p) die(1, "no memory for %zu times %zu bytes", n, size);
    return p;
}

static inline void *bvh8_room(bvh8 *w, size_t n, size_t size)
{
    w->bytes += n * size;
    return bvh8_aligned(n, size);
}

static inline void bvh8_layout(bvh8_builder *b)
{
    bvh8 *w = b->w;
    bvh8_emit(b, 0, 1);
    w->node = bvh8_room(w, w->nodes, sizeof *w->node);
    if (w->x.m) w->block = bvh8_room(w, w->blocks, sizeof *w->block);
    else w->list = bvh8_room(w, w->blocks, sizeof *w->list);
    b->leaf = allocate(w->blocks, sizeof *b->leaf);
    w->nodes = w->blocks = 0;
    bvh8_emit(b, 0, 1);
    parallel_for((w->blocks + 255) / 256, b->how.threads, "blocks", bvh8_fill_job, b);
    w->exact = !atomic_load(&b->inexact);
    w->peak += w->bytes;
    free(b->leaf);
}

static inline bool bvh8_build(const items *x, bvh8_options how, bvh8 *w, failure *f)
{
    aabb all;
    *w = (bvh8){.x = *x, .scale = 1, .dialect = how.dialect};
    if (how.leaf < 1 || how.leaf > 8 || how.width < 2 || how.width > 8 || how.bins < 4
        || how.bins > bvh8_most_bins)
        return failed(f, 2, "bvh8: leaf %d of 1..8, width %d of 2..8, bins %d of 4..%d", how.leaf,
                      how.width, how.bins, bvh8_most_bins);
    if (!items_all_bounds(x, &all, f)) return false;
    if (x->n >> 30) return failed(f, 2, "%zu items: fewer than 2^30 fit", x->n);
    if (aabb_is_empty(all)) return true;
    bvh8_frame(w, all);
    size_t need = x->n * (3 * sizeof(bvh8_bound) + 16 + 64);
    if (need > how.most_bytes)
        return failed(f, 1, "%zu items: more than the %zu bytes allowed", x->n, how.most_bytes);
    bvh8_builder b = {.w = w, .how = how, .item = bvh8_aligned(x->n, sizeof *b.item)};
    parallel_for((x->n + bvh8_chunk - 1) / bvh8_chunk, how.threads, "items", bvh8_item_job, &b);
    for (size_t i = 0; i < x->n; i++)
        if (b.item[i].first != no_shape) b.item[b.n++] = b.item[i];
    w->held = b.n;
    if (b.n) {
        b.node = bvh8_aligned(2 * b.n, sizeof *b.node), b.pick = allocate(2 * b.n, sizeof *b.pick);
        bvh8_grow_all(&b);
        bvh8_costs costs = bvh8_price(&b, 0);
        w->peak = (x->n + 2 * b.n) * sizeof *b.item + 2 * b.n * sizeof *b.pick;
        w->cost = (double)costs.cost[0] / bvh8_area(&b.node[0].all);
        bvh8_layout(&b);
    }
    free(b.item), free(b.node), free(b.pick);
    return true;
}

#endif
