/* What is asked in assignment 12, and what is answered. */
#ifndef QUESTION_12_H
#define QUESTION_12_H
#include "common/random.h"
#include "chapters/12_kdtree/first.h"

/* Prices for (12.1): of a step, of a test; and what a cut with nothing on one side saves [0, 1). */
typedef struct { real step, test, bonus; } kd_costs;

enum { question_most = 160, question_leaves = 96 };
typedef struct {
    triangle tri[question_most];
    int n;
    uint64_t moved;          /* not 0: planes of the tree were moved; see question_tree */
    bool whole;              /* all planes are at whole numbers */
    ray r;
    int most;                /* exercise 2 */
    aabb cell, box[question_most]; /* 4: n boxes within the cell */
    kd_costs costs;
} question;

typedef struct {
    bool is, left;
    int n, axis, leaf[question_leaves];
    real t, plane, exit[question_leaves];
    hit h;
} answer;

static inline void question_move(const question *q, first_kd_node *node, random_stream *g)
{
    if (!node->child) return;
    if (q->moved && random_next(g) < (real)0.6) node->plane += 4 * random_next(g) - 2;
    if (q->whole) node->plane = floor(node->plane);
    question_move(q, &node->child[0], g), question_move(q, &node->child[1], g);
}

/* The mesh, and its tree in *t. If planes were moved, leaves do not hold what they should: then the
 * triangles that a search meets tell which leaves it visits, and what it finds has one right answer
 * still. */
static inline void question_tree(const question *q, first_mesh *m, first_kdtree *t)
{
    *m = (first_mesh){allocate((size_t)q->n, sizeof(triangle)), q->n};
    memcpy(m->tri, q->tri, (size_t)q->n * sizeof(triangle));
    first_kdtree_build(m, t);
    random_stream g = random_start(q->moved, 0, 0);
    question_move(q, &t->root, &g);
}

/* Questions do not hold what is due: brute force finds it. */
static inline void question_forget(question *q) { (void)q; }
#endif
