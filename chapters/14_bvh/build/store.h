/* store.h: the tree as it lies in memory, whoever builds it.
 *
 *              0                 node 0 is the root; number 1 is not used, so that every pair of
 *           /     \              siblings begins at an even number: one line of the cache
 *          2       3
 *         / \     [items 4..7]   a leaf names its items as a range; the items are reordered so that
 *        4   5                   they lie in the order of the leaves, from left to right
 *   [0..1]   [2..3]
 *
 *   tree_array(&t, n, size)     for the time of building; counted, as all is: t.held (09)
 *   tree_begin(&t, n)           the root, empty, with places for n nodes
 *   tree_pair(&t)               two more places in use, wherever they come from
 *   tree_trim(&t)               gives back the places that are not in use
 *   tree_free(&t)               a zeroed tree may be freed
 *
 * Where something does not fit, t.held.full is set, and building ends with false.
 */
#ifndef BVH_STORE_H
#define BVH_STORE_H

#include "split.h"

enum { bvh_most_depth = 64 };

typedef struct {
    const char *rule;    /* of bvh_rules: tree.h */
    int leaf;            /* most items in a leaf [1..255]; a set that the heuristic would rather not
                          * cut becomes a leaf earlier, never later */
    double item_cost;    /* of testing an item, where testing a pair of boxes costs 1 (> 0) */
    size_t most_bytes;   /* held while it is built; if that is not enough, nothing is built */
} bvh_options;

typedef struct {
    bvh_node *node;
    size_t nodes;        /* places in use, 1 included */
    size_t room;         /* places there are */
    size_t items;        /* in leaves */
    int depth;           /* of the deepest leaf [0..64] */
    memory held;         /* held.full: this is no tree */
} bvh_tree;

/* Box of what of the item is in its own box and in the slab [lo, hi]; false if that is nothing. It
 * may be too large, never too small: a search must find every point of the item. */
typedef bool bvh_clip(const void *context, const bvh_item *item, int axis, float lo, float hi,
                      bvh_box *out);

/* item[room], of which n are filled. clip NULL: items that cannot be cut, and room = n. */
typedef struct {
    bvh_item *item;
    size_t n, room;
    bvh_clip *clip;
    const void *context;
} bvh_input;

enum { bvh_most_cuts = 8 };  /* references an item, on average, where items are cut: the room */

/* ---------------------------------------------------------------------------------------------- */

/* All zero, padding, too; for memory_drop(&t.held, p, n, size). NULL: no room. */
static inline void *tree_array(bvh_tree *t, size_t n, size_t size)
{
    void *p = memory_array(&t->held, n, size);
    return p ? memset(p, 0, n * size) : NULL;
}

static inline void tree_free(bvh_tree *t)
{
    free(t->node);
    *t = (bvh_tree){0};
}

static inline bool tree_nodes(bvh_tree *t, size_t room)
{
    return memory_fit(&t->held, &t->node, t->nodes, room + room % 2, &t->room, sizeof(bvh_node));
}

static inline bool tree_begin(bvh_tree *t, size_t room)
{
    if (!tree_nodes(t, room)) return false;
    bvh_box none = box_empty();
    t->node[0] = t->node[1] = box_numbered(&none, 0, 0);
    t->nodes = 2;
    return true;
}

/* Two more places in use; the array becomes twice as large if they are not there. */
static inline bool tree_pair(bvh_tree *t)
{
    if (t->nodes + 2 > t->room && !tree_nodes(t, 2 * t->room)) return false;
    t->nodes += 2;
    return true;
}

/* Nodes into an array of the right size, if that saves half and there is room for both. */
static inline void tree_trim(bvh_tree *t)
{
    if (2 * t->nodes <= t->room) (void)tree_nodes(t, t->nodes);
    t->held.full = false;  /* without it there is a tree all the same */
}

/* The smallest e with 2^e >= n. */
static inline int log2_above(size_t n)
{
    int e = 0;
    while (((size_t)1 << e) < n) e++;
    return e;
}

#endif
