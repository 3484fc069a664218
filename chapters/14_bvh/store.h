/* store.h: the tree as it lies in memory, whoever builds it.
 *
 *              0                 node 0 is the root; number 1 is not used, so that every pair of
 *           /     \              siblings begins at an even number: one line of the cache
 *          2       3
 *         / \     [items 4..7]   a leaf names its items as a range; the items are reordered so that
 *        4   5                   they lie in the order of the leaves, from left to right
 *   [0..1]   [2..3]
 *
 *   tree_takes(&t, bytes), tree_gives(&t, bytes)   keep count of what is held
 *   tree_room(&t, n)                               an empty tree with places for n nodes
 *   tree_pair(&t)                                  two more places in use, wherever they come from
 *   tree_trim(&t)                                  gives back the places that are not in use
 *   tree_free(&t)                                  a zeroed tree may be freed
 */
#ifndef BVH_STORE_H
#define BVH_STORE_H

#include "split.h"

enum { bvh_most_depth = 64 };

typedef struct { bvh_strategy strategy; int leaf; double item_cost; } bvh_options;

typedef struct {
    bvh_node *node;
    size_t nodes;        /* places in use, 1 included */
    size_t room;         /* places there are */
    size_t items;        /* in leaves */
    int depth;           /* of the deepest leaf [0..64] */
    size_t bytes, peak;  /* held now, and the most ever held */
} bvh_tree;

/* ---------------------------------------------------------------------------------------------- */

static inline void tree_takes(bvh_tree *t, size_t bytes)
{
    t->bytes += bytes;
    if (t->bytes > t->peak) t->peak = t->bytes;
}

static inline void tree_gives(bvh_tree *t, size_t bytes) { t->bytes -= bytes; }

static inline void tree_free(bvh_tree *t)
{
    free(t->node);
    *t = (bvh_tree){0};
}

/* Nodes from the beginning of a line of the cache. */
static inline bvh_node *tree_nodes(bvh_tree *t, size_t n)
{
    size_t bytes = (n + n % 2) * sizeof(bvh_node);
    void *p = n > SIZE_MAX / 64 ? NULL : aligned_alloc(64, bytes);
    if (!p) die(1, "no memory for %zu nodes", n);
    tree_takes(t, bytes);
    return p;
}

static inline void tree_room(bvh_tree *t, size_t n)
{
    t->room = n + n % 2;
    t->node = tree_nodes(t, t->room);
    t->node[0] = t->node[1] = (bvh_node){box_empty(), 0, 0};
    t->nodes = 2;
}

/* Two more places in use; the array becomes twice as large if they are not there. */
static inline void tree_pair(bvh_tree *t)
{
    t->nodes += 2;
    if (t->nodes <= t->room) return;
    bvh_node *all = t->node;
    size_t room = t->room;
    t->room *= 2;
    t->node = tree_nodes(t, t->room);
    memcpy(t->node, all, (t->nodes - 2) * sizeof *all);
    free(all);
    tree_gives(t, room * sizeof *all);
}

/* Nodes into an array of the right size, if that saves half. */
static inline void tree_trim(bvh_tree *t)
{
    if (2 * t->nodes > t->room) return;
    bvh_node *all = t->node;
    size_t room = t->room;
    t->room = t->nodes + t->nodes % 2;
    t->node = tree_nodes(t, t->room);
    memcpy(t->node, all, t->nodes * sizeof *all);
    free(all);
    tree_gives(t, room * sizeof *all);
}

/* The smallest e with 2^e >= n. */
static inline int log2_above(size_t n)
{
    int e = 0;
    while (((size_t)1 << e) < n) e++;
    return e;
}

#endif
