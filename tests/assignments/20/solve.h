/* Asks the functions of assignment 20. */
#ifndef SOLVE_20_H
#define SOLVE_20_H
#include "3_linear.h"
#include "4_choose.h"
#include "5_control.h"

static answer solve(int exercise, const question *q)
{
    answer a = {-77, -77, -77, -77, {-77, -77, -77}};
    first_samples s = {0, 0, 0};
    switch (exercise) {
    case 1:
        for (int i = 0; i < q->n; i++) first_sample(&s, q->f[i]);
        a.x = first_mean(s), a.p = first_variance(s), a.error = first_error(s);
        break;
    case 2:
        a.d = q->cosine ? first_cosine_direction(q->u, q->v) : first_uniform_direction(q->u, q->v);
        break;
    case 3: a.x = sample_linear(q->a, q->b, q->u, &a.p); break;
    case 4: a.i = sample_choice(q->f, q->n, q->u, &a.p, &a.x); break;
    case 5: a.x = control_mean(q->f, q->g, q->n, q->G, &a.error); break;
    }
    return a;
}
#endif
