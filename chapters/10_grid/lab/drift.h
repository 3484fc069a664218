/* drift.h: how far a walk goes astray, measured against whole numbers.
 *
 * Cells of size 1, a ray from (1/2, 1/2, 1/2) with a direction of whole numbers a, b, c: wall j of
 * axis k is met at t = (2 j + 1) / (2 d_k). Which of two walls comes first is a comparison of
 * products of whole numbers, so the cell after any number of steps is known exactly.
 *
 *   drift d = drift_after(DRIFT_COUNTED, steps, walks, seed)
 *   d.wrong     share of the walks that are in a wrong cell after so many steps
 *   d.error     how far the walls that they are about to pass are from where they think; the
 *               largest of all [cells]
 */
#ifndef GRID_DRIFT_H
#define GRID_DRIFT_H

#include "../../../common/random.h"
#include "../walk.h"

typedef enum { DRIFT_F32, DRIFT_ADDED, DRIFT_COUNTED, drift_kinds } drift_kind;
static const char *const drift_name[drift_kinds] = {"t added up, float", "t added up",
                                                    "walls counted"};

typedef struct { double wrong, error; } drift;
typedef struct { int64_t d[3], j[3]; } whole_walk;  /* direction; walls passed on each axis */

/* ---------------------------------------------------------------------------------------------- */

/* Over the nearest wall; of several at the same t the first axis, as walk_step. */
static inline void whole_step(whole_walk *w)
{
    int k = 0;
    for (int i = 1; i < 3; i++)  /* (2 j_i + 1) / d_i < (2 j_k + 1) / d_k */
        if ((2 * w->j[i] + 1) * w->d[k] < (2 * w->j[k] + 1) * w->d[i]) k = i;
    w->j[k]++;
}

static inline lattice whole_lattice(void)
{
    const real side = 1 << 20;
    return lattice_of((aabb){{0, 0, 0}, {side, side, side}}, (int[3]){1 << 20, 1 << 20, 1 << 20});
}

static inline whole_walk whole_walk_of(uint64_t seed, uint64_t i)
{
    random_stream g = random_start(seed, i, 3);
    whole_walk w = {{0, 0, 0}, {0, 0, 0}};
    for (int k = 0; k < 3; k++) w.d[k] = 1 + (int64_t)(random_next_bits(&g) % 1000);
    return w;
}

static inline ray whole_ray(const whole_walk *w)
{
    const real half = 0.5;
    return ray_from((vec3){half, half, half}, vec(w->d[0], w->d[1], w->d[2]));
}

/* Distance, along axis k, of the next wall from where t says that it is [cells]. */
static inline double whole_error(const whole_walk *w, const grid_walk *a)
{
    double worst = 0;
    for (int k = 0; k < 3; k++) {
        double wall = (double)vaxis(a->j, k) + 0.5;
        double e = fabs((double)vaxis(a->t, k) * (double)w->d[k] - wall);
        worst = e > worst ? e : worst;
    }
    return worst;
}

static inline drift drift_after(drift_kind kind, size_t steps, size_t walks, uint64_t seed)
{
    lattice l = whole_lattice();
    drift out = {0, 0};
    size_t wrong = 0;
    for (size_t i = 0; i < walks; i++) {
        whole_walk exact = whole_walk_of(seed, i);
        grid_line a = line_of(whole_ray(&exact));
        grid_walk w = walk_from(&l, &a, 0);
        for (size_t s = 0; s < steps; s++) {
            real t = walk_next_t(&w);
            if (kind == DRIFT_F32) walk_step_f32(&w, t);
            else if (kind == DRIFT_ADDED) walk_step_naive(&w, t);
            else walk_step(&w, t);
            whole_step(&exact);
        }
        bool same = true;
        for (int k = 0; k < 3; k++) same &= (int64_t)vaxis(w.j, k) == exact.j[k];
        wrong += !same;
        double e = whole_error(&exact, &w);
        out.error = e > out.error ? e : out.error;
    }
    out.wrong = (double)wrong / (double)walks;
    return out;
}

#endif
