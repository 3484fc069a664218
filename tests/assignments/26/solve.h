/* Asks the functions of assignment 26, with random numbers of their own for each sample. */
#ifndef SOLVE_26_H
#define SOLVE_26_H
#include "3_roulette.h"
#include "4_ball.h"

static answer solve(int exercise, const question *q)
{
    answer a = {.mean = {0, 0, 0}};
    first_point x = q->x;
    x.m = &q->s.thing[0].m;
    for (int i = 0; i < q->samples; i++) {
        random_stream random = random_start(q->seed, (uint64_t)i, 0);
        vec3 L = vec(0, 0, 0);
        int hits = 0;
        switch (exercise) {
        case 1: L = first_direct_by_lamp(&q->s, 0, x, &random); break;
        case 2: L = first_path(&q->s, q->r, &random); break;
        case 3: L = path_roulette(&q->s, q->r, q->rule, &random, &hits); break;
        case 4: L = direct_by_ball(&q->s, 0, x, &random); break;
        }
        a.mean = vadd(a.mean, L), a.square = vadd(a.square, vmul(L, L));
        if (hits >= 0) a.length[hits < answer_lengths ? hits : answer_lengths - 1]++;
    }
    a.mean = vscale(a.mean, 1 / (real)q->samples),
    a.square = vscale(a.square, 1 / (real)q->samples);
    return a;
}
#endif
