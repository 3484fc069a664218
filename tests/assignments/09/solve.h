/* Asks the functions of assignment 09. */
#ifndef SOLVE_09_H
#define SOLVE_09_H
#include "3_entry.h"
#include "4_turned.h"
#include "5_sweep.h"

static answer solve(int exercise, const question *q)
{
    answer a = {false, -77, -77, -77, {-77, -77, -77}};
    switch (exercise) {
    case 1: first_slabs(q->b, q->r, &a.t0, &a.t1); break;
    case 2: a.is = first_aabb_hit(q->b, q->r, &a.t0); break;
    case 3: a.is = aabb_entry(q->b, q->r, &a.t0, &a.face); break;
    case 4: a.is = turned_box_hit(q->box, q->r, &a.t0, &a.n); break;
    case 5: a.is = aabb_sweep(q->a, q->move, q->b, &a.t0, &a.t1); break;
    }
    return a;
}
#endif
