/* build.h: the wide tree, from a binary one (合并, collapse).
 *
 *   bool bvh8_build(&x, bvh8_defaults, &w, &f)      false: too large, too many, no room, Ctrl-C
 *
 *   1. Items: their boxes in the tree's frame. What can't be hit is left out.
 *   2. A binary tree, by the builder of 14; but a leaf costs as many tests as it has blocks: a cut
 *      into L and R,
 *          area(L) ceil(n(L) / 8) + area(R) ceil(n(R) / 8)                                  (15.4)
 *      Large sets are cut first, by one: the children of a cut before item p are nodes 2 p and
 *      2 p + 1. What is small is a job for whoever comes: from item p on, it takes nodes 2 p + 2,
 *      2 p + 3, .. These places depend on items alone: any number of threads makes the same tree.
 *   3. Collapse. Which of its nodes remain? Those with the least sum of areas, (15.5) of
 *      MEASURED.md: C(s, j) if s takes up to j places in the node above.
 *   4. Nodes and blocks, in the order of the search: depth first.
 *
 * Source: H. Ylitie, T. Karras, S. Laine, "Efficient Incoherent Ray Traversal on GPUs Through
 * Compressed Wide BVHs", HPG 2017, section 3.1 (collapse).
 */
#ifndef WIDE_BUILD_H
#define WIDE_BUILD_H

#include "../../common/parallel.h"
#include "patch.h"

typedef struct { float of[8]; } bvh8_costs;  /* of 1 to 8 places */

typedef struct {
    bvh8 *w;
    int width;
    bvh_item *item;       /* [n] */
    bvh_node *node;       /* [2 n] as in 14 */
    uint8_t (*pick)[8];   /* [2 n] (15.5): best k for j places at j - 1; 0: C(s, j - 1) */
    uint32_t *leaves;     /* [blocks] which becomes that block */
    size_t n;
} bvh8_builder;

/* ---------------------------------------------------------------------------------------------- */

/* 4096 items; `index` of what can't be hit is no_shape. */
static inline void bvh8_items_job(size_t piece, void *context)
{
    const bvh8_builder *b = context;
    const bvh8 *w = b->w;
    for (size_t i = 4096 * piece; i < w->x.n && i < 4096 * (piece + 1); i++) {
        aabb box;
        b->item[i].index = no_shape;
        if (!items_bounds(&w->x, i, &box)) continue;
        triangle t = w->x.m ? mesh_triangle(w->x.m, i) : (triangle){.a = box.lo};
        if (w->x.m && vzero(triangle_cross(t.a, t.b, t.c))) continue;
        b->item[i] = box_between(frame_into(&w->frame, box.lo), frame_into(&w->frame, box.hi));
        b->item[i].index = (uint32_t)i;
    }
}

/* Step 2, of one small set. Its nodes lie side by side: scattered, all took a quarter longer. */
static inline void bvh8_grow_job(size_t i, void *context)
{
    tree_builder own = *(const tree_builder *)context;
    own.tree = &(bvh_tree){.node = own.tree->node, .nodes = 2 * own.job[i].begin + 2};
    own.aside = 0;
    tree_node(&own, own.job[i]);
}

/* Step 2. False: stopped. Near the root, on three levels, size counts. */
static inline bool bvh8_grow(const bvh8_builder *b, int leaf, int threads)
{
    tree_builder t = {.tree = &(bvh_tree){.node = b->node},
                      .rule = &(bvh_rule){.split = split_binned}, .options = {.leaf = leaf},
                      .item = b->item, .split = {.block = 3, .by_size = 3},
                      .aside = b->n / 32 > 1024 ? b->n / 32 : 1024,
                      .job = allocate(b->n, sizeof *t.job)};
    tree_node(&t, (tree_job){0, 0, b->n, 0});
    bool whole = parallel_for(t.jobs, threads, "tree", bvh8_grow_job, &t);
    return free(t.job), whole;
}

/* ---------------------------------------------------------------------------------------------- */

/* (15.5) at `at`. pick[0] is that of the places in the node which it may become; 0: a leaf. */
static inline bvh8_costs bvh8_price(const bvh8_builder *b, uint32_t at)
{
    const bvh_node *s = &b->node[at];
    uint8_t *pick = memset(b->pick[at], 0, sizeof *b->pick);
    bvh8_costs c = {{0}};
    if (s->count) return c;
    bvh8_costs l = bvh8_price(b, s->first), r = bvh8_price(b, s->first + 1);
    for (int j = 1; j < b->width; j++) {
        c.of[j] = INFINITY;
        for (int k = 0; k < j; k++) {
            float sum = l.of[k] + r.of[j - 1 - k];
            if (sum < c.of[j]) c.of[j] = sum, pick[j] = (uint8_t)(k + 1);
        }
    }
    pick[0] = pick[b->width - 1];
    c.of[0] = c.of[b->width - 1] + (float)box_area(s);
    for (int j = 1; j < b->width; j++)
        if (c.of[j - 1] <= c.of[j]) c.of[j] = c.of[j - 1], pick[j] = 0;
    return c;
}

/* The nodes that take the `places` places given to `at`: into list[], and how many. */
static inline int bvh8_spread(const bvh8_builder *b, uint32_t at, int places, uint32_t *list)
{
    const uint8_t *pick = b->pick[at];
    while (places > 1 && !pick[places - 1]) places--;
    if (places == 1) return list[0] = at, 1;
    int left = pick[places - 1], n = bvh8_spread(b, b->node[at].first, left, list);
    return n + bvh8_spread(b, b->node[at].first + 1, places - left, list + n);
}

/* Step 4 below `at`; returns its number. Without arrays it only counts what they must hold. */
static inline uint32_t bvh8_emit(bvh8_builder *b, uint32_t at, int depth)
{
    bvh8 *w = b->w;
    uint32_t first = b->node[at].first, list[8] = {at};
    int left = b->pick[at][0], n = 1;
    if (!left && depth > 1 && !w->x.m) return bvh8_leaf | b->item[first].index;
    if (!left && depth > 1) {
        if (b->leaves) b->leaves[w->blocks] = at;
        return bvh8_leaf | (uint32_t)w->blocks++;
    }
    uint32_t me = (uint32_t)w->nodes++;
    if (left) n = bvh8_spread(b, first, left, list);
    if (left) n += bvh8_spread(b, first + 1, b->width - left, list + n);
    if (depth > w->depth) w->depth = depth;
    for (int k = 0; k < 8; k++) {
        uint32_t child = k < n ? bvh8_emit(b, list[k], depth + 1) : 0;
        if (!w->node) continue;
        bvh_box box = k < n ? b->node[list[k]] : box_empty();
        for (int s = 0; s < 3; s++)
            w->node[me].side[s][k] = box.low[s], w->node[me].side[3 + s][k] = box_high(&box, s);
        w->node[me].child[k] = child;
    }
    return me;
}

/* 256 blocks. */
static inline void bvh8_fill_job(size_t piece, void *context)
{
    const bvh8_builder *b = context;
    const bvh8 *w = b->w;
    const aabb_frame *in = &w->frame;
    for (size_t i = 256 * piece; i < w->blocks && i < 256 * (piece + 1); i++) {
        const bvh_node *leaf = &b->node[b->leaves[i]];
        const bvh_item *item = b->item + leaf->first;
        for (uint32_t k = 0; k < 8; k++) {
            triangle t = mesh_triangle(w->x.m, item[k < leaf->count ? k : 0].index);
            const vec3 p[3] = {frame_into(in, t.a), frame_into(in, t.b), frame_into(in, t.c)};
            EIGHT_UNROLL
            for (int c = 0; c < 3; c++) {
                eight *row = w->block[i].corner + 3 * c;
                row[0][k] = (float)p[c].x, row[1][k] = (float)p[c].y, row[2][k] = (float)p[c].z;
            }
            w->block[i].index[k] = k < leaf->count ? item[k].index : no_shape;
        }
    }
}

/* Are all corners of a mesh floats in the tree's frame? */
static inline bool bvh8_is_exact(const bvh8 *w)
{
    for (size_t i = 0; w->x.m && i < w->x.m->vertices; i++) {
        vec3 p = w->x.m->v[i], q = frame_into(&w->frame, p);
        q = frame_back(&w->frame, vec((float)q.x, (float)q.y, (float)q.z));
        if (p.x != q.x || p.y != q.y || p.z != q.z) return false;
    }
    return w->x.m;
}

static inline void bvh8_free(bvh8 *w)
{
    free(w->node), free(w->block), free(w->patch);
    *w = (bvh8){.nodes = 0};
}

/* Steps 2 to 4, of the items found. False: stopped, or no room. */
static inline bool bvh8_make(bvh8_builder *b, int leaf, int threads)
{
    bvh8 *w = b->w;
    b->node = memory_array(&w->room, 2 * b->n, sizeof *b->node);
    b->pick = memory_array(&w->room, 2 * b->n, sizeof *b->pick);
    if (w->room.full || !bvh8_grow(b, leaf, threads)) return false;
    bvh8_price(b, 0);
    bvh8_emit(b, 0, 1);
    w->node = memory_array(&w->room, w->nodes, sizeof *w->node);
    if (w->x.m) w->block = memory_array(&w->room, w->blocks, sizeof *w->block);
    b->leaves = memory_array(&w->room, w->blocks, sizeof *b->leaves);
    if (w->room.full) return false;
    w->nodes = w->blocks = 0;
    bvh8_emit(b, 0, 1);
    return parallel_for((w->blocks + 255) / 256, threads, "blocks", bvh8_fill_job, b);
}

static inline bool bvh8_build(const items *x, bvh8_options how, bvh8 *w, failure *f)
{
    aabb all;
    *w = (bvh8){.x = *x, .dialect = how.dialect, .room = {.most = how.most_bytes}};
    if (how.leaf < 1 || how.leaf > 8 || how.width < 2 || how.width > 8)
        return failed(f, 2, "bvh8: leaf %d of 1..8, width %d of 2..8", how.leaf, how.width);
    if (!items_all_bounds(x, &all, f)) return false;
    if (x->n >> 30) return failed(f, 2, "%zu items: fewer than 2^30 fit", x->n);
    w->frame = frame_of(all, 8, 0), w->exact = bvh8_is_exact(w);
    bvh8_builder b = {.w = w, .width = how.width};
    b.item = memory_array(&w->room, x->n, sizeof *b.item);
    bool whole = b.item
        && parallel_for((x->n + 4095) / 4096, how.threads, "boxes", bvh8_items_job, &b);
    for (size_t i = 0; whole && i < x->n; i++)
        if (b.item[i].index != no_shape) b.item[b.n++] = b.item[i];
    if (whole && x->m && b.n <= bvh8_few) bvh8_patches_of(w, b.item, b.n);
    whole = whole && (!b.n || bvh8_make(&b, x->m ? how.leaf : 1, how.threads));
    free(b.item), free(b.node), free(b.pick), free(b.leaves);
    w->held = b.n;
    w->room.bytes = w->nodes * sizeof *w->node + (x->m ? w->blocks * sizeof *w->block : 0)
        + w->patches * sizeof *w->patch;
    if (whole) return true;
    bool full = w->room.full;
    bvh8_free(w);
    if (full) return memory_failed(f, "bvh8", x->n, how.most_bytes);
    return failed(f, parallel_stopped(), "stopped");
}

#endif
