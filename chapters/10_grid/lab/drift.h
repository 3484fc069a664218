/* drift.h: how far a walk goes astray, measured against whole numbers.
 *
 * Cells of size 1, a ray from (1/2, 1/2, 1/2) with a direction of whole numbers a, b, c: wall j of
 * axis k is met at t = (2 j + 1) / (2 d_k). Which of two walls comes first is a comparison of
 * products of whole numbers, so the cell after any number of steps is known exactly.
 *
 *   drift d = drift_after(walk_step, steps, walks, seed)
 *   d.missed    the share of the walks that never are in a cell that their ray passes
 *   d.error     how far the walls that they are about to pass are from where they think; the
 *               largest of all [cells]
 *   drift_margin(cells)       what lists allow for, with so many cells in a row [cells]
 */
#ifndef GRID_DRIFT_H
#define GRID_DRIFT_H

#include "../../../common/random.h"
#include "naive.h"

typedef struct { double missed, error; } drift;
typedef struct { int64_t d[3], j[3]; } whole_walk;  /* direction; walls passed on each axis */

/* ---------------------------------------------------------------------------------------------- */

/* Over the nearest wall; of several at the same t the first axis, as walk_step. True: there were
 * several, and to be in the cell beyond another one is as right. */
static inline bool whole_step(whole_walk *w)
{
    int k = 0;
    bool tie = false;
    for (int i = 1; i < 3; i++) {  /* (2 j_i + 1) / d_i < (2 j_k + 1) / d_k */
        int64_t a = (2 * w->j[i] + 1) * w->d[k], b = (2 * w->j[k] + 1) * w->d[i];
        tie = a == b || (tie && a > b);
        if (a < b) k = i;
    }
    w->j[k]++;
    return tie;
}

/* Past an edge of a cell, before so many steps are made, by 1 / (2 M) of a cell: where walls x and
 * y are met in the wrong order, a cell is missed. */
static inline whole_walk whole_walk_aimed(uint64_t seed, uint64_t i, size_t steps)
{
    const int64_t M = real_is_float ? 4 : 1000000000;  /* so that d is exact */
    random_stream g = random_start(seed, i, 3);
    whole_walk w = {{0, 0, 0}, {0, 0, 0}};
    for (int k = 0; k < 3; k++) {
        uint64_t walls = steps / 6 + random_next_bits(&g) % (steps / 6);
        w.d[k] = (2 * (int64_t)walls + 1) * M;
    }
    w.d[1] += i % 2 ? 1 : -1;
    return w;
}

static inline bool whole_same(const whole_walk *w, const grid_walk *a)
{
    return (int64_t)a->j.x == w->j[0] && (int64_t)a->j.y == w->j[1] && (int64_t)a->j.z == w->j[2];
}

/* Distance, along axis k, of the next wall from where t says that it is [cells]. */
static inline double whole_error(vec3 d, const grid_walk *a)
{
    double worst = 0;
    for (int k = 0; k < 3; k++) {
        double wall = (double)vaxis(a->j, k) + 0.5;
        worst = fmax(worst, fabs((double)vaxis(a->t, k) * (double)vaxis(d, k) - wall));
    }
    return worst;
}

fast_inline drift drift_after(grid_step *step, size_t steps, size_t walks, uint64_t seed)
{
    enum { side = 1 << 20 };  /* of the lattice; cells of size 1 */
    lattice l = lattice_of((aabb){{0, 0, 0}, {side, side, side}}, (int[3]){side, side, side});
    drift out = {0, 0};
    size_t missed = 0;
    for (size_t i = 0; i < walks; i++) {
        whole_walk exact = whole_walk_aimed(seed, i, steps);
        vec3 d = vec(exact.d[0], exact.d[1], exact.d[2]);
        grid_line a = line_of(ray_from(vec(0.5, 0.5, 0.5), d));
        grid_walk w = walk_from(&l, &a, 0);
        bool astray = false;
        for (size_t s = 0; s < steps; s++) {
            step(&w, walk_next_t(&w));
            bool tie = whole_step(&exact);
            astray |= !tie && !whole_same(&exact, &w);
        }
        missed += astray;
        out.error = fmax(out.error, whole_error(a.d, &w));
    }
    out.missed = (double)missed / (double)walks;
    return out;
}

/* As grid_bounds: for rays from grid_reach sizes away. */
static inline double drift_margin(size_t cells)
{
    return (double)(512 * real_epsilon * grid_reach) * (double)cells;
}

#endif
