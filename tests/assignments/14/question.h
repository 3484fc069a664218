/* What is asked in assignment 14, and what is answered. */
#ifndef QUESTION_14_H
#define QUESTION_14_H
#include "common/random.h"
#include "chapters/14_bvh/first.h"

/* What a search costs: c.box for a node, whatever it holds; and to ask n triangles, c.group for
 * each group of c.lanes of them, the last of which may be incomplete. */
typedef struct { real box, group; int lanes; } sah_costs;

enum { question_most = 48 };
typedef struct {
    triangle tri[question_most];
    int n;
    uint64_t moved;          /* not 0: boxes of the tree were moved; see question_tree */
    ray r;
    int skip;                /* exercise 3 */
    int first, count;        /* 2: triangles first .. first + count */
    aabb box[question_most]; /* 5: n boxes */
    sah_costs costs;
} question;

typedef struct { bool is; int n, axis; hit h[2]; int order[question_most]; } answer;

/* The mesh, and a tree cut at the middle triangle. If `moved` is not 0 some boxes do not hold what
 * they should: they stand somewhere else, or are too small. Then the triangles that a search meets
 * tell which nodes it visits, and in which order: what it finds has one right answer still. */
static inline first_bvh question_tree(const question *q, first_mesh *m)
{
    *m = (first_mesh){allocate((size_t)q->n, sizeof(triangle)), q->n};
    memcpy(m->tri, q->tri, (size_t)q->n * sizeof(triangle));
    first_bvh b = first_bvh_build(m, false);
    random_stream g = random_start(q->moved, 0, 0);
    for (int i = 1; q->moved && i < b.nodes; i++) {
        aabb *box = &b.node[i].box;
        vec3 half = vscale(vsub(box->hi, box->lo), (real)0.5);
        vec3 move = vmul(half, random_in_cube(&g, 2));
        if (random_next(&g) < (real)0.4) continue;
        if (random_next(&g) < (real)0.5) box->hi = vsub(box->hi, half);
        *box = (aabb){vadd(box->lo, move), vadd(box->hi, move)};
    }
    return b;
}

/* Questions do not hold what is due: brute force finds it. */
static inline void question_forget(question *q) { (void)q; }
#endif
