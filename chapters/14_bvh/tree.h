/* tree.h: building the tree of boxes (层次包围盒, bounding volume hierarchy) over items of any kind.
 *
 *   tree_build(item, n, how, &t)          reorders item[n]; O(n log n); n < 2^31
 *   tree_free(&t)                         a zeroed tree may be freed: store.h, with the layout
 *
 *   how.strategy        BVH_CYCLE .. BVH_SAH_SWEEP: split.h; BVH_MORTON: morton.h
 *   how.leaf            most items in a leaf [1..255]; a set that the heuristic would rather not
 *                       cut becomes a leaf earlier, never later
 *   how.item_cost       of testing an item, where testing a pair of boxes costs 1 (> 0)
 *
 * Depth. Cuts by planes may peel off one item each: n items 1, 2, 4, 8 ... apart make a tree n
 * deep. So a set of n items at depth d is halved by number as soon as d + log2(n) reaches 64.
 * Halving keeps that sum, so no leaf is deeper than 64, and a search needs to remember 64 siblings
 * at most: a stack of fixed size that no input overflows.
 *
 * Memory. 28 bytes an item while it is built, 64 for nodes: 2 n + 2 of them are the most there can
 * be. The sweep takes 20 more, Morton codes 16. What is not used is given back. t.peak is the most
 * held at any time.
 */
#ifndef BVH_TREE_H
#define BVH_TREE_H

#include "morton.h"
#include "spatial.h"

/* By measurement: eight in a leaf, and a test that costs 0.3 of a pair of boxes. Most tests end at
 * the first comparison of signs. */
#define bvh_defaults ((bvh_options){BVH_SAH, 8, 0.3})

/* ---------------------------------------------------------------------------------------------- */

typedef struct {
    bvh_tree *tree;
    bvh_item *item;
    bvh_options options;
    splitter split;
} tree_builder;

/* How many of the n items go left, or 0: they make a leaf. */
static inline size_t tree_split(tree_builder *b, bvh_item *item, size_t n, int depth)
{
    splitter *s = &b->split;
    bool fits = n <= (size_t)b->options.leaf,
         by_cost = s->strategy == BVH_SAH || s->strategy == BVH_SAH_SWEEP;
    bool deep = depth + log2_above(n) >= bvh_most_depth;
    if (n == 1 || (fits && (deep || !by_cost))) return 0;
    if (deep) return split_by_number(item, n, box_longest(&s->centres));
    size_t left = split_items(s, item, n, depth);
    return fits && s->cost >= (double)n * s->item_cost ? 0 : left;
}

static inline void tree_node(tree_builder *b, size_t at, size_t begin, size_t n, int depth)
{
    bvh_tree *t = b->tree;
    if (depth > t->depth) t->depth = depth;
    split_measure(&b->split, b->item + begin, n);
    t->node[at] = (bvh_node){b->split.box, (uint32_t)begin, (uint32_t)n};
    size_t left = tree_split(b, b->item + begin, n, depth), first = t->nodes;
    if (left == 0) return;
    t->node[at].first = (uint32_t)first, t->node[at].count = 0;
    t->nodes += 2;
    tree_node(b, first, begin, left, depth + 1);
    tree_node(b, first + 1, begin + left, n - left, depth + 1);
}

/* From the root down, by the cuts of split.h. */
static inline void tree_by_cuts(bvh_item *item, size_t n, bvh_options how, bvh_tree *out)
{
    bool sweep = how.strategy == BVH_SAH_SWEEP;
    size_t extra = sweep ? n * (2 * sizeof(radix_pair) + sizeof(float)) : 0;
    tree_takes(out, extra);
    tree_room(out, 2 * n + 2);
    tree_builder b = {out, item, how, {.strategy = how.strategy, .item_cost = how.item_cost}};
    if (sweep) {
        b.split.pairs = allocate(n, sizeof *b.split.pairs);
        b.split.spare = allocate(n, sizeof *b.split.spare);
        b.split.areas = allocate(n, sizeof *b.split.areas);
    }
    if (n) tree_node(&b, 0, 0, n, 0);
    free(b.split.pairs), free(b.split.spare), free(b.split.areas);
    tree_gives(out, extra);
}

static inline void tree_build(bvh_item *item, size_t n, bvh_options how, bvh_tree *out)
{
    *out = (bvh_tree){.items = n};
    tree_takes(out, n * sizeof *item);
    if (how.strategy == BVH_SPATIAL) how.strategy = BVH_SAH;  /* boxes alone cannot be cut */
    switch (how.strategy) {
    case BVH_MORTON: tree_morton(item, n, how, out); break;
    default: tree_by_cuts(item, n, how, out); break;
    }
    tree_trim(out);
}

#endif
