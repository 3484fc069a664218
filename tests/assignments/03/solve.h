/* Asks the functions of assignment 03. */
#ifndef SOLVE_03_H
#define SOLVE_03_H
#include "3_ellipsoid.h"
#include "4_meeting.h"
#include "5_capsule.h"

static answer solve(int exercise, const question *q)
{
    answer a = {false, -77, -77, {-77, -77, -77}};
    hit h = {-77, -77, -77, 77};
    switch (exercise) {
    case 1: a.is = first_sphere_roots(q->s, q->r, &a.t0, &a.t1); break;
    case 2:
        a.is = first_sphere_hit(q->s, q->r, &h), a.t0 = h.t;
        if (a.is) a.n = first_sphere_normal(q->s, ray_at(q->r, h.t));
        break;
    case 3: a.is = ellipsoid_hit(q->s.c, q->radii, q->r, &a.t0, &a.n); break;
    case 4: a.is = spheres_meet(q->s, q->v, q->other, q->w, &a.t0); break;
    case 5: a.is = capsule_hit(q->a, q->b, q->s.r, q->r, &a.t0); break;
    }
    return a;
}
#endif
