/* first.h: a BSP tree (BSP树): space is cut in two by the planes of the triangles themselves.
 * Wrong far away: from 1e4 sizes in float, 1e13 in double, rounding exceeds the hair that
 * planes are thick. bsp.h mends it, and cuts what crosses a plane. For up to 20,000 triangles. */
#ifndef FIRST_BSP_H
#define FIRST_BSP_H
#include "../07_mesh/first.h"
#include "../09_aabb/first.h"

enum { first_bsp_leaf = 8, first_bsp_tries = 24 };

typedef struct first_bsp_node {
    vec3 n;                         /* the plane n . q = at, n of length 1 */
    real at;
    struct first_bsp_node *child;   /* [2]: back and front; NULL: this is a leaf */
    int *item, count;               /* triangles of a leaf; of others, those in the plane itself */
    int number;                     /* leaves are counted as they are made */
} first_bsp_node;

typedef struct {
    const first_mesh *m;
    real hair;                      /* half the thickness of a plane */
    int depth, leaves;              /* at most `depth` levels */
    first_bsp_node root;
} first_bsp;

/* s(q) = n . q - at: positive in front, negative behind.                                (13.1) */
static inline real first_bsp_side(const first_bsp_node *node, vec3 q)
{
    return vdot(node->n, q) - node->at;
}

/* Where a triangle reaches: bit 0 behind the plane, bit 1 in front of it, 0 if it lies in it. */
static inline int first_bsp_where(const first_bsp *b, const first_bsp_node *node, triangle t)
{
    vec3 s = {first_bsp_side(node, t.a), first_bsp_side(node, t.b), first_bsp_side(node, t.c)};
    bool back = real_min(s.x, real_min(s.y, s.z)) < -b->hair;
    bool front = real_max(s.x, real_max(s.y, s.z)) > b->hair;
    return (back ? 1 : 0) + (front ? 2 : 0);
}

static inline void first_bsp_set_plane(const first_bsp *b, first_bsp_node *node, int i)
{
    node->n = first_triangle_normal(b->m->tri[i]);
    node->at = vdot(node->n, b->m->tri[i].a);
}

/* The plane, of 24 triangles', that leaves the fewest on its fuller side and in itself. Of a round
 * thing all lies behind each of its planes, and long triangles are on both sides of most: false if
 * none leaves less than 95 %, or cuts less than half. */
static inline bool first_bsp_choose(const first_bsp *b, first_bsp_node *node)
{
    int best = node->count, best_item = -1;
    for (int k = 0; k < first_bsp_tries; k++) {
        int item = node->item[(long)node->count * k / first_bsp_tries], side[2] = {0, 0}, in = 0;
        first_bsp_set_plane(b, node, item);
        if (vzero(node->n)) continue;  /* a triangle without area has no plane */
        for (int i = 0; i < node->count; i++) {
            int where = first_bsp_where(b, node, b->m->tri[node->item[i]]);
            side[0] += where & 1, side[1] += where >> 1, in += where == 0;
        }
        int fuller = in + (side[0] > side[1] ? side[0] : side[1]);
        if (side[0] + side[1] > 1.5 * node->count) continue;
        if (fuller < best) best = fuller, best_item = item;
    }
    if (best > 0.95 * node->count) return false;
    first_bsp_set_plane(b, node, best_item);
    return true;
}

static inline void first_bsp_split(first_bsp *b, first_bsp_node *node, int depth)
{
    node->number = b->leaves;
    if (node->count <= first_bsp_leaf || depth >= b->depth || !first_bsp_choose(b, node)) {
        b->leaves++;
        return;
    }
    node->child = allocate(2, sizeof *node->child);
    for (int side = 0; side < 2; side++)
        node->child[side].item = allocate((size_t)node->count, sizeof(int));
    int in_plane = 0;
    for (int i = 0; i < node->count; i++) {
        int item = node->item[i], where = first_bsp_where(b, node, b->m->tri[item]);
        for (int side = 0; side < 2; side++) {
            first_bsp_node *c = &node->child[side];
            if (where >> side & 1) c->item[c->count++] = item;
        }
        if (where == 0) node->item[in_plane++] = item;
    }
    node->count = in_plane;
    first_bsp_split(b, &node->child[0], depth + 1);
    first_bsp_split(b, &node->child[1], depth + 1);
}

/* In place, since the root is part of it: it must not move. */
static inline void first_bsp_build(const first_mesh *m, first_bsp *b)
{
    *b = (first_bsp){.m = m, .depth = (int)(4 + log2(m->n + 1.0))};
    (void)first_triangles_box(m->tri, m->n, &b->hair);
    b->root.item = allocate((size_t)m->n, sizeof(int));
    for (int i = 0; i < m->n; i++) b->root.item[b->root.count++] = i;
    first_bsp_split(b, &b->root, 0);
}

static inline bool first_bsp_visit(const first_bsp *b, const first_bsp_node *node, ray *r, real t0,
                                   real t1, hit *out)
{
    bool found = false;
    for (int i = 0; i < node->count; i++)
        if (first_mesh_test(b->m, node->item[i], r, out)) found = true;
    if (!node->child) return found;

    /* s(o + t d) = a + t c. Going down, c < 0, it is in front until a + t c = -hair, and behind
     * from a + t c = hair on; going up, the other way round: all signs turn. Along the plane,
     * c = 0, both t are infinite, and it stays where it is.                             (13.3) */
    real a = first_bsp_side(node, r->o), c = vdot(node->n, r->d);
    int near = c < 0 ? 1 : 0;
    if (c >= 0) a = -a;
    real until = (a + b->hair) / fabs(c), from = (a - b->hair) / fabs(c);
    if (!(until < t0)
        && first_bsp_visit(b, &node->child[near], r, t0, real_min(until, t1), out)) found = true;
    if (!(from > t1 || from > r->tmax)
        && first_bsp_visit(b, &node->child[1 - near], r, real_max(from, t0), t1, out)) found = true;
    return found;
}

static inline bool first_bsp_hit(const first_bsp *b, ray r, hit *out)
{
    return first_bsp_visit(b, &b->root, &r, r.tmin, r.tmax, out);
}

static inline void first_bsp_node_free(first_bsp_node *node)
{
    for (int c = 0; node->child && c < 2; c++) first_bsp_node_free(&node->child[c]);
    free(node->child), free(node->item);
}

static inline void first_bsp_free(first_bsp *b)
{
    first_bsp_node_free(&b->root);
    *b = (first_bsp){.m = NULL};
}
#endif
