/* Asks the functions of assignment 19. */
#ifndef SOLVE_19_H
#define SOLVE_19_H
#include "3_pane.h"
#include "4_through.h"
#include "5_weight.h"

static answer solve(int exercise, const question *q)
{
    const vec3 none = {-77, -77, -77};
    answer a = {false, -77, -77, none, none, -77};
    ray out = {none, 0, none, 0};
    switch (exercise) {
    case 1:
        a.v = first_reflect(q->d, q->n);
        a.is = first_refract(q->d, q->n, q->n1, q->n2, &a.w);
        break;
    case 2: a.x = first_fresnel(q->ci, q->ct, q->n1, q->n2); break;
    case 3: a.x = glass_pane(q->ci, q->n2, q->T, &a.y); break;
    case 4:
        a.is = through_glass_ball(q->ball, q->n1, q->n2, q->r, &out);
        a.v = out.o, a.w = out.d;
        break;
    case 5:
        a.rays = 0, a.v = whitted_by_weight(&q->s, q->r, vec(1, 1, 1), q->least, &a.rays);
        break;
    }
    return a;
}
#endif
