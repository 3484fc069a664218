/* Asks the functions of assignment 14. */
#ifndef SOLVE_14_H
#define SOLVE_14_H
#include "3_any.h"
#include "4_two.h"
#include "5_sweep.h"

static answer solve(int exercise, const question *q)
{
    const hit none = {-77, -77, -77, 77};
    answer a = {.n = -77, .axis = -77, .h = {none, none}};
    first_mesh m;
    if (exercise == 5) {
        for (int i = 0; i < q->n; i++) a.order[i] = -77;
        a.n = sah_sweep(q->box, q->n, q->costs, a.order, &a.axis);
        return a;
    }
    first_bvh b = question_tree(q, &m);
    switch (exercise) {
    case 1: a.is = first_bvh_hit(&b, q->r, &a.h[0]); break;
    case 2: a.n = first_bvh_sah(&b, q->first, q->count, &a.axis); break;
    case 3: a.n = bvh_any(&b, q->r, q->skip); break;
    case 4: a.n = bvh_two(&b, q->r, a.h); break;
    }
    for (int i = 0; i < q->n; i++) a.order[i] = b.order[i];
    first_bvh_free(&b), first_mesh_free(&m);
    return a;
}
#endif
