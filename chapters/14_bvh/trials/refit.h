/* refit.h: a mesh that moves keeps its tree: the boxes are made anew, the tree stays (重新拟合, refit);
 * and rotations (树旋转) mend what that costs.
 *
 *   bvh_mesh_refit(&b, &m, false)     m: the mesh of bvh_mesh_build, its corners elsewhere. O(n),
 *                                     no memory; hits are the very ones of a tree built anew
 *   n = bvh_mesh_refit(&b, &m, true)  rotates, too; how often. Never at a higher cost than without
 *
 * What was near when the tree was built may be far apart now: boxes grow, and overlap. A rotation
 * lets a child and a child of its sibling change places, where that makes the sibling smaller:
 *
 *          node                  node          only Q's box changes: it was around A and B, and is
 *         /    \                /    \         now around A and C. By the surface area heuristic
 *        C      Q      ->      B      Q        (14.7) the tree costs less by
 *              / \                   / \
 *             A   B                 A   C         area(A and B) - area(A and C)            (14.12)
 *
 * There are four such pairs at a node; the best is taken, if it gains anything. One pass from the
 * leaves up, at each refit; where much moves, the next frame goes on. C comes to lie deeper: not
 * where a leaf would then be deeper than 64, the stack of a search.
 *
 *   input                                       answer
 *   corners that are no longer finite           the triangle is not hit, and widens no box
 *   not finite when the tree was built          not in the tree, whatever it is now: build anew
 *   cut by the rule "spatial"                   right; but parts are whole triangles again
 *
 * Sources: A. Kensler, "Tree Rotations for Improving Bounding Volume Hierarchies", IEEE Symposium
 * on Interactive Ray Tracing 2008; D. Kopta, T. Ize, J. Spjut, E. Brunvand, A. Davis, A. Kensler,
 * "Fast, Effective BVH Updates for Animated Scenes", I3D 2012 (rotations while refitting).
 */
#ifndef BVH_REFIT_H
#define BVH_REFIT_H

#include "../bvh_mesh.h"

typedef struct { bvh_mesh *b; const mesh *m; bool rotate; size_t rotations; } bvh_refit;
typedef struct { int all, of[2]; } refit_height;  /* levels below a node, and below its children */

/* ---------------------------------------------------------------------------------------------- */

static inline int refit_higher(int a, int b) { return a > b ? a : b; }

/* A leaf: the corners of today, and the box around them. */
static inline void refit_leaf(bvh_refit *x, const bvh_node *n, bvh_box *box)
{
    for (uint32_t k = n->first; k < n->first + n->count; k++) {
        bvh_triangle *t = &x->b->triangle[k];
        bvh_item item;
        triangle now = mesh_triangle(x->m, t->index);
        t->corner[0] = now.a, t->corner[1] = now.b, t->corner[2] = now.c;
        if (triangle_item(x->m, t->index, &item)) box_add(box, &item);
    }
}

/* (14.12): by how much the sibling of child[c] shrinks if child[c] goes there, and the sibling's
 * own child number k comes up. */
static inline double refit_gain(const bvh_node *node, const bvh_node *child, int c, int k)
{
    const bvh_node *q = &child[1 - c];
    if (q->count) return 0;
    bvh_box both = node[q->first + (uint32_t)(1 - k)];
    box_add(&both, &child[c]);
    return box_area(q) - box_area(&both);
}

/* The best of the four, if any gains. at: the depth of the node; h: of its children. */
static inline void refit_rotate(bvh_refit *x, bvh_node *child, int at, refit_height h[2])
{
    bvh_node *node = x->b->tree.node;
    double best = 0;
    int down = 0, up = 0;
    for (int c = 0; c < 2; c++)
        for (int k = 0; k < 2; k++) {
            double gain = refit_gain(node, child, c, k);
            if (!(gain > best) || at + 2 + h[c].all > bvh_most_depth) continue;
            best = gain, down = c, up = k;
        }
    if (best <= 0) return;
    bvh_node *q = &child[1 - down], *pair = node + q->first, lower = child[down];
    child[down] = pair[up], pair[up] = lower;
    bvh_box both = pair[0];
    box_add(&both, &pair[1]);
    *q = box_numbered(&both, q->first, 0);
    int deep = h[down].all;
    h[down].all = h[1 - down].of[up], h[1 - down].of[up] = deep;
    h[1 - down].all = 1 + refit_higher(h[1 - down].of[0], h[1 - down].of[1]);
    x->rotations++;
}

/* Children first: a box is made of theirs. */
static inline refit_height refit_node(bvh_refit *x, uint32_t i, int depth)
{
    bvh_node *n = &x->b->tree.node[i], *child = x->b->tree.node + n->first;
    bvh_box box = box_empty();
    refit_height h[2] = {{0, {0, 0}}, {0, {0, 0}}};
    if (n->count) refit_leaf(x, n, &box);
    for (uint32_t k = 0; k < 2 && !n->count; k++) {
        h[k] = refit_node(x, n->first + k, depth + 1);
        box_add(&box, &child[k]);
    }
    *n = box_numbered(&box, n->first, n->count);
    if (n->count) return h[0];
    if (x->rotate) refit_rotate(x, child, depth, h);
    return (refit_height){1 + refit_higher(h[0].all, h[1].all), {h[0].all, h[1].all}};
}

static inline size_t bvh_mesh_refit(bvh_mesh *b, const mesh *m, bool rotate)
{
    bvh_refit x = {b, m, rotate, 0};
    if (b->tree.items) b->tree.depth = refit_node(&x, 0, 0).all;
    return x.rotations;
}

#endif
