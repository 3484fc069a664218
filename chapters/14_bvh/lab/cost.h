/* cost.h: what the heuristic says a tree costs.
 *
 *   tree_cost c = tree_cost_of(&t);
 *   c.nodes, c.tests    pairs of boxes and items that a random line through the root tests, if
 *                       no hit ends the search                                            (14.7)
 *
 *      nodes   = sum over inner nodes of  area(node) / area(root)
 *      tests   = sum over leaves of       area(leaf) / area(root) * items in it
 *
 * "A random line": uniformly distributed, that is, the origin uniform on the surface of the root's
 * box, the direction by the cosine law. Rays from a camera are none, and hits end them early.
 *
 * Source: L. Santaló, "Integral Geometry and Geometric Probability", 1976, ch. 14 (lines that
 * meet convex bodies).
 */
#ifndef BVH_COST_H
#define BVH_COST_H

#include "../search.h"

typedef struct { double nodes, tests; } tree_cost;

/* ---------------------------------------------------------------------------------------------- */

static inline tree_cost tree_cost_of(const bvh_tree *t)
{
    tree_cost c = {0, 0};
    double root = t->items ? box_area(&t->node[0]) : 1;
    for (size_t i = 0; t->items && i < t->nodes; i++) {
        const bvh_node *n = &t->node[i];
        if (i == 1) continue;
        double part = box_area(n) / root;
        if (n->count) c.tests += part * n->count;
        else c.nodes += part;
    }
    return c;
}

#endif
