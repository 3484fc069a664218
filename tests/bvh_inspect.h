/* bvh_inspect.h: a BVH of a mesh, built, and all of it looked at.
 *
 *   bvh_mesh b = made(&m, how);                    or the program ends
 *   inspection x = inspect(&b, &m, leaf, cut);     leaf: how many triangles one may have; cut:
 *                                                  by "spatial", boxes hold parts of triangles
 *   tree_cost c = tree_cost_of(&t);                pairs of boxes and items that a random line
 *                                                  through the root tests, if no hit ends the
 *                                                  search: sums of areas (14.7)
 */
#ifndef TESTS_BVH_INSPECT_H
#define TESTS_BVH_INSPECT_H

#include "../chapters/14_bvh/bvh_mesh.h"

typedef struct {
    size_t missed, unused;   /* triangles in no leaf, or uncut in two; nodes not reached once */
    size_t outside;          /* boxes that do not hold their children, or triangles */
    size_t overfull, odd;    /* leaves; pairs out of place, corners that are not the mesh's */
    int deepest;
} inspection;
typedef struct { double nodes, tests; } tree_cost;
typedef struct {
    const bvh_mesh *b;
    const mesh *m;
    unsigned char *seen, *node_seen;
    size_t leaf;
    bool cut;
    inspection found;
} inspector;

/* ---------------------------------------------------------------------------------------------- */

static inline bvh_mesh made(const mesh *m, bvh_options how)
{
    bvh_mesh b;
    if (!bvh_mesh_build(m, how, &b, NULL)) abort();
    return b;
}

static inline void inspect_node(inspector *x, size_t at, int depth)
{
    const bvh_node *node = x->b->tree.node, *n = &node[at];
    inspection *f = &x->found;
    if (depth > f->deepest) f->deepest = depth;
    x->node_seen[at]++;
    if (n->count == 0) {
        f->odd += n->first % 2 != 0 || n->first < 2 || n->first + 1 >= x->b->tree.nodes;
        for (size_t c = n->first; c < n->first + 2; c++) {
            for (int k = 0; k < 3; k++)
                f->outside += !(n->low[k] <= node[c].low[k]
                                && box_high(&node[c], k) <= box_high(n, k));
            inspect_node(x, c, depth + 1);
        }
        return;
    }
    f->overfull += n->count > x->leaf;
    for (size_t i = n->first; i < n->first + n->count; i++) {
        uint32_t index = x->b->triangle[i].index;
        triangle t = mesh_triangle(x->m, index);
        const vec3 own[3] = {t.a, t.b, t.c};
        x->seen[index]++;
        for (int c = 0; c < 9; c++) {
            real p = vaxis(x->b->triangle[i].corner[c / 3], c % 3);
            f->odd += p != vaxis(own[c / 3], c % 3);
            f->outside += !x->cut && !((real)n->low[c % 3] <= p && p <= (real)box_high(n, c % 3));
        }
    }
}

static inline inspection inspect(const bvh_mesh *b, const mesh *m, size_t leaf, bool cut)
{
    inspector x = {b, m, allocate(m->triangles, 1), allocate(b->tree.nodes, 1), leaf, cut, {0}};
    inspect_node(&x, 0, 0);
    for (size_t i = 0; i < m->triangles; i++)
        x.found.missed += cut ? x.seen[i] < 1 : x.seen[i] != 1;
    for (size_t i = 0; i < b->tree.nodes; i++) x.found.unused += x.node_seen[i] != (i != 1);
    free(x.seen), free(x.node_seen);
    return x.found;
}

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
