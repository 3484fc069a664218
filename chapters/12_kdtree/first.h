/* first.h: a k-d tree (KD树): a box is cut in two, across its longest side, in the middle.
 * Wrong far away: from 1e4 sizes in float, 1e13 in double, the plane's t is off by more than a
 * hair, and hits are lost. kdtree.h mends it, and cuts where it pays. 1e6 triangles are fine. */
#ifndef FIRST_KDTREE_H
#define FIRST_KDTREE_H
#include "../07_mesh/first.h"
#include "../09_aabb/first.h"

enum { first_kd_leaf = 8 };

typedef struct first_kd_node {
    int axis;                      /* an inner node is cut at x_axis = plane; a leaf has -1 */
    real plane;
    struct first_kd_node *child;   /* [2]: below and above the plane */
    int *item, n;                  /* the triangles of a leaf */
    int number;                    /* leaves are counted as they are made */
} first_kd_node;

typedef struct {
    const first_mesh *m;
    aabb box;
    real hair;
    int depth, leaves;             /* at most `depth` levels */
    first_kd_node root;
} first_kdtree;

/* The point p, moved along the axis to x. */
static inline vec3 first_kd_moved(vec3 p, int axis, real x)
{
    return (vec3){axis == 0 ? x : p.x, axis == 1 ? x : p.y, axis == 2 ? x : p.z};
}

static inline void first_kd_split(first_kdtree *t, first_kd_node *node, aabb box, int depth)
{
    node->axis = -1, node->number = t->leaves;
    if (node->n <= first_kd_leaf || depth >= t->depth) {
        t->leaves++;
        return;
    }

    /* Which triangles reach below the plane, which above: those that it cuts are in both. */
    int axis = vlongest(vsub(box.hi, box.lo));
    real cut = (vaxis(box.lo, axis) + vaxis(box.hi, axis)) / 2;
    first_kd_node *child = allocate(2, sizeof *child);
    for (int side = 0; side < 2; side++) {
        child[side].item = allocate((size_t)node->n, sizeof(int));
        for (int i = 0; i < node->n; i++) {
            aabb b = first_aabb_pad(first_triangle_box(t->m->tri[node->item[i]]), t->hair);
            bool in = side == 0 ? vaxis(b.lo, axis) <= cut : vaxis(b.hi, axis) >= cut;
            if (in) child[side].item[child[side].n++] = node->item[i];
        }
    }

    /* If most triangles are cut, cutting helps nobody. */
    if (child[0].n + child[1].n > 1.5 * node->n) {
        free(child[0].item), free(child[1].item), free(child);
        t->leaves++;
        return;
    }
    free(node->item);
    node->item = NULL, node->child = child, node->axis = axis, node->plane = cut;
    aabb below = {box.lo, first_kd_moved(box.hi, axis, cut)};
    aabb above = {first_kd_moved(box.lo, axis, cut), box.hi};
    first_kd_split(t, &child[0], below, depth + 1);
    first_kd_split(t, &child[1], above, depth + 1);
}

/* In place, since the root is part of it: it must not move. Depth: 8 + 1.3 log2 n.       (12.2) */
static inline void first_kdtree_build(const first_mesh *m, first_kdtree *t)
{
    *t = (first_kdtree){.m = m, .depth = (int)(8 + 1.3 * log2(m->n + 1.0))};
    t->box = first_triangles_box(m->tri, m->n, &t->hair);
    t->root.item = allocate((size_t)m->n, sizeof(int));
    for (int i = 0; i < m->n; i++) t->root.item[t->root.n++] = i;
    first_kd_split(t, &t->root, t->box, 0);
}

/* The ray is in the box of this node for t in [t0, t1]. */
static inline bool first_kd_visit(const first_kdtree *t, const first_kd_node *node, ray *r, real t0,
                                  real t1, hit *out)
{
    bool found = false;
    if (node->axis < 0) {
        for (int i = 0; i < node->n; i++)
            if (first_mesh_test(t->m, node->item[i], r, out)) found = true;
        return found;
    }
    real o = vaxis(r->o, node->axis), d = vaxis(r->d, node->axis);

    /* A ray along the plane stays on its side. Any other is below first, or above first. */
    if (d == 0) return first_kd_visit(t, &node->child[o > node->plane], r, t0, t1, out);
    int near = d > 0 ? 0 : 1;

    /* It crosses at t = (plane - o) / d: near in [t0, t], far in [t, t1].               (12.5) */
    real cross = (node->plane - o) / d;
    if (t0 <= cross
        && first_kd_visit(t, &node->child[near], r, t0, real_min(cross, t1), out)) found = true;

    /* A hit before the plane is final: nothing beyond it can be closer. (It shortened the ray.) */
    if (cross <= t1 && cross <= r->tmax
        && first_kd_visit(t, &node->child[1 - near], r, real_max(cross, t0), t1, out)) found = true;
    return found;
}

static inline bool first_kdtree_hit(const first_kdtree *t, ray r, hit *out)
{
    real t0, t1;
    if (t->m->n == 0) return false;
    r.d = vadd(r.d, vec(0, 0, 0));  /* -0.0 + 0 is 0, which (9.1) can take */
    first_slabs(t->box, r, &t0, &t1);
    t0 = real_max(t0, r.tmin), t1 = real_min(t1, r.tmax);
    return t0 <= t1 && first_kd_visit(t, &t->root, &r, t0, t1, out);
}

static inline void first_kd_node_free(first_kd_node *node)
{
    for (int c = 0; node->child && c < 2; c++) first_kd_node_free(&node->child[c]);
    free(node->child), free(node->item);
}

static inline void first_kdtree_free(first_kdtree *t)
{
    first_kd_node_free(&t->root);
    *t = (first_kdtree){.m = NULL};
}
#endif
