/* first.h: an octree (八叉树): a box with too many triangles is cut into eight, and so on.
 * Wrong far away: from 1e4 sizes in float, 1e13 in double, rounding exceeds the hair by which
 * cells overlap, and hits are lost. octree.h mends it. 12 levels; 1e6 triangles are fine. */
#ifndef FIRST_OCTREE_H
#define FIRST_OCTREE_H
#include "../07_mesh/first.h"
#include "../09_aabb/first.h"

enum { first_octree_leaf = 8, first_octree_depth = 12 };

typedef struct first_octree_node {
    aabb box;
    struct first_octree_node *child;  /* [8], or NULL: this is a leaf */
    int *item, n;                     /* the triangles of a leaf */
    int number;                       /* leaves are counted as they are made */
} first_octree_node;

typedef struct {
    const first_mesh *m;
    real hair;
    int leaves;
    first_octree_node root;
} first_octree;

/* The c-th of eight: bit k of c says on which side of the middle it lies on axis k. */
static inline aabb first_octant(aabb b, int c)
{
    vec3 middle = vscale(vadd(b.lo, b.hi), 0.5);
    if (c & 1) b.lo.x = middle.x; else b.hi.x = middle.x;
    if (c & 2) b.lo.y = middle.y; else b.hi.y = middle.y;
    if (c & 4) b.lo.z = middle.z; else b.hi.z = middle.z;
    return b;
}

static inline void first_octree_split(first_octree *t, first_octree_node *node, int depth)
{
    node->number = t->leaves;
    if (node->n <= first_octree_leaf || depth == first_octree_depth) {
        t->leaves++;
        return;
    }

    /* Each child gets the triangles whose boxes reach into it; a triangle may be in several. */
    first_octree_node *child = allocate(8, sizeof *child);
    int sum = 0;
    for (int c = 0; c < 8; c++) {
        child[c].box = first_aabb_pad(first_octant(node->box, c), t->hair);
        child[c].item = allocate((size_t)node->n, sizeof(int));
        for (int i = 0; i < node->n; i++) {
            aabb b = first_triangle_box(t->m->tri[node->item[i]]);
            if (first_aabb_overlap(b, child[c].box)) child[c].item[child[c].n++] = node->item[i];
        }
        sum += child[c].n;
    }

    /* If most triangles are in several children, cutting helps nobody. */
    if (sum > 2 * node->n) {
        for (int c = 0; c < 8; c++) free(child[c].item);
        free(child);
        t->leaves++;
        return;
    }
    free(node->item);
    node->item = NULL, node->child = child;
    for (int c = 0; c < 8; c++) first_octree_split(t, &child[c], depth + 1);
}

/* In place, since the root is part of it: it must not move. */
static inline void first_octree_build(const first_mesh *m, first_octree *t)
{
    *t = (first_octree){.m = m};
    t->root.box = first_triangles_box(m->tri, m->n, &t->hair);
    t->root.item = allocate((size_t)m->n, sizeof(int));
    for (int i = 0; i < m->n; i++) t->root.item[t->root.n++] = i;
    first_octree_split(t, &t->root, 0);
}

static inline bool first_octree_visit(const first_octree *t, const first_octree_node *node, ray *r,
                                      hit *out)
{
    real t_enter;
    bool found = false;
    if (!first_aabb_hit(node->box, *r, &t_enter) || t_enter > r->tmax) return false;
    if (!node->child) {
        for (int i = 0; i < node->n; i++)
            if (first_mesh_test(t->m, node->item[i], r, out)) found = true;
        return found;
    }

    /* Nearest first: a ray that goes down an axis meets the upper half first.            (11.4) */
    int flip = (r->d.x < 0 ? 1 : 0) + (r->d.y < 0 ? 2 : 0) + (r->d.z < 0 ? 4 : 0);
    for (int c = 0; c < 8; c++)
        if (first_octree_visit(t, &node->child[c ^ flip], r, out)) found = true;
    return found;
}

static inline bool first_octree_hit(const first_octree *t, ray r, hit *out)
{
    r.d = vadd(r.d, vec(0, 0, 0));  /* -0.0 + 0 is 0, which (9.1) can take */
    return first_octree_visit(t, &t->root, &r, out);
}

static inline void first_octree_node_free(first_octree_node *node)
{
    for (int c = 0; node->child && c < 8; c++) first_octree_node_free(&node->child[c]);
    free(node->child), free(node->item);
}

static inline void first_octree_free(first_octree *t)
{
    first_octree_node_free(&t->root);
    *t = (first_octree){.m = NULL};
}
#endif
