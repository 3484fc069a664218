/* Asks the functions of assignment 12. */
#ifndef SOLVE_12_H
#define SOLVE_12_H
#include "2_leaves.h"
#include "3_count.h"
#include "4_cut.h"

static answer solve(int exercise, const question *q)
{
    answer a = {.n = -77, .axis = -77, .t = -77, .plane = -77, .h = {-77, -77, -77, 77}};
    first_mesh m;
    first_kdtree t;
    if (exercise == 4) {
        a.is = kd_cut(q->cell, q->box, q->n, q->costs, &a.axis, &a.plane, &a.left);
        return a;
    }
    for (int i = 0; i < question_leaves; i++) a.leaf[i] = -77, a.exit[i] = -77;
    question_tree(q, &m, &t);
    switch (exercise) {
    case 1: a.is = first_kdtree_hit(&t, q->r, &a.h); break;
    case 2: a.n = kd_leaves(&t, q->r, q->most, a.leaf, a.exit); break;
    case 3: a.n = kd_count(&t, q->r, &a.t); break;
    }
    first_kdtree_free(&t), first_mesh_free(&m);
    return a;
}
#endif
