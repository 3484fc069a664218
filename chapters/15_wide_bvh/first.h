/* first.h: the tree of 14, four wide: a node has four children, whose boxes are tested in one loop.
 * Wrong far away, as 14's: from 1e4 sizes in float, 1e13 in double, hits are lost. And not fast:
 * it recurses, and tests triangles one by one. bvh8.h is right and quick, and eight wide. */
#ifndef FIRST_WIDE_H
#define FIRST_WIDE_H
#include "../14_bvh/first.h"

enum { first_width = 4 };
typedef struct {
    real lo[3][first_width], hi[3][first_width];  /* rows: the low x of all children, ..       */
    int child[first_width];  /* a node; ~i: a leaf, node i of the binary tree; 0: none */
} first_wide_node;

typedef struct {
    first_bvh binary;
    first_wide_node *node;
    int nodes;
} first_wide;

/* The children of a wide node: begin with the binary node; as long as there is room, replace the
 * largest that has children by them. A large box is met often: its step is the best to save.
 *     the one of them with the largest area                                               (15.1) */
static inline int first_wide_gather(const first_bvh *b, int root, int *list)
{
    int n = 1;
    list[0] = root;
    while (n < first_width) {
        int best = -1;
        for (int i = 0; i < n; i++)
            if (b->node[list[i]].left != 0 && (best < 0 ||
                aabb_area(b->node[list[i]].box) > aabb_area(b->node[list[best]].box))) best = i;
        if (best < 0) break;
        const first_bvh_node *open = &b->node[list[best]];
        list[best] = open->left;
        list[n++] = open->right;
    }
    return n;
}

/* Makes the wide node for a binary one, and all below it. Returns its number. */
static inline int first_wide_collapse(first_wide *w, int root)
{
    int me = w->nodes++, list[first_width];
    int n = first_wide_gather(&w->binary, root, list);
    for (int i = 0; i < first_width; i++) {
        const first_bvh_node *from = &w->binary.node[list[i < n ? i : 0]];
        aabb box = i < n ? from->box : aabb_empty();
        for (int k = 0; k < 3; k++) {
            w->node[me].lo[k][i] = vaxis(box.lo, k);
            w->node[me].hi[k][i] = vaxis(box.hi, k);
        }
        w->node[me].child[i] = i < n ? ~list[i] : 0;
        if (i < n && from->left != 0) {
            int child = first_wide_collapse(w, list[i]);
            w->node[me].child[i] = child;
        }
    }
    return me;
}

static inline first_wide first_wide_build(const first_mesh *m)
{
    first_wide w = {.binary = first_bvh_build(m, false)};
    w.node = allocate((size_t)w.binary.nodes, sizeof *w.node);
    first_wide_collapse(&w, 0);
    return w;
}

/* One slab for four boxes: the loop along the rows is what a processor does at once.      (15.2) */
static inline void first_wide_slab(const real *near, const real *far, real o, real d,
                                   real *enter, real *exit)
{
    for (int i = 0; i < first_width; i++) {
        enter[i] = real_max((near[i] - o) / d, enter[i]);
        exit[i] = real_min((far[i] - o) / d, exit[i]);
    }
}

static inline bool first_wide_leaf(const first_wide *w, int i, ray *r, hit *out)
{
    const first_bvh_node *leaf = &w->binary.node[i];
    bool found = false;
    for (int k = leaf->first; k < leaf->first + leaf->n; k++)
        if (first_mesh_test(w->binary.m, w->binary.order[k], r, out)) found = true;
    return found;
}

static inline bool first_wide_visit(const first_wide *w, int at, ray *r, hit *out)
{
    const first_wide_node *node = &w->node[at];
    real enter[first_width], exit[first_width];
    bool found = false;
    for (int i = 0; i < first_width; i++) enter[i] = 0, exit[i] = real_infinity;
    for (int k = 0; k < 3; k++) {
        bool down = vaxis(r->d, k) < 0;
        first_wide_slab(down ? node->hi[k] : node->lo[k], down ? node->lo[k] : node->hi[k],
                        vaxis(r->o, k), vaxis(r->d, k), enter, exit);
    }
    /* The nearest first: a hit in it shortens the ray, and may spare the others.          (15.3) */
    for (int turn = 0; turn < first_width; turn++) {
        int best = 0;
        for (int i = 1; i < first_width; i++)
            if (enter[i] < enter[best]) best = i;
        int child = node->child[best];
        if (enter[best] > r->tmax) break;
        bool met = enter[best] < exit[best];
        if (met && child < 0 && first_wide_leaf(w, ~child, r, out)) found = true;
        if (met && child > 0 && first_wide_visit(w, child, r, out)) found = true;
        enter[best] = real_infinity;
    }
    return found;
}

static inline bool first_wide_hit(const first_wide *w, ray r, hit *out)
{
    r.d = vadd(r.d, vec(0, 0, 0));  /* -0.0 + 0 is 0, which (9.1) can take */
    return first_wide_visit(w, 0, &r, out);
}

static inline void first_wide_free(first_wide *w)
{
    first_bvh_free(&w->binary), free(w->node);
    w->node = NULL;
}
#endif
