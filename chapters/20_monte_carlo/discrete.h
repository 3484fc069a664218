/* discrete.h: one of n things, each with a probability in proportion to its weight (离散分布).
 *
 *    1 |            ______     cumulative sums (累积分布): P_k = (w_0 + ... + w_k) / sum
 *      |      _____|           inversion: the first k with u < P_k                         (20.13)
 *    u |- - -|->               Steps of height 0, things of weight 0, are never met.
 *      |_____|_____|______ k
 *
 *   choice c;
 *   if (!choice_build(weight, n, &c)) ...       no weight > 0, or one negative, infinite, NaN
 *   size_t k = choice_sample(&c, u, &p, &rest); p > 0: probability of k; rest: a new u in [0,1)
 *   real p = choice_probability(&c, k);         the same for a k found otherwise
 *   choice_free(&c);
 *
 * O(log n) a choice, O(n) to build. `rest` is how far u went into the step: as uniform as u was,
 * and as well spread, but with log2(1/p) digits fewer.
 */
#ifndef MONTE_CARLO_DISCRETE_H
#define MONTE_CARLO_DISCRETE_H

#include "../../common/file.h"
#include "../../common/vec3.h"

typedef struct { double *before; size_t n; } choice;  /* n + 1 sums: those of the weights below k */

/* ---------------------------------------------------------------------------------------------- */

static inline void choice_free(choice *c)
{
    free(c->before);
    *c = (choice){0};
}

/* False: nothing can be chosen, and *c is empty. Sums in double, with what each addition lost. */
static inline bool choice_build(const real *weight, size_t n, choice *c)
{
    double sum = 0, lost = 0;
    *c = (choice){allocate(n + 1, sizeof *c->before), n};
    bool ok = true;
    for (size_t k = 0; k < n; k++) {
        double x = (double)weight[k] + lost, next = sum + x;
        ok = ok && weight[k] >= 0;                     /* false for a NaN */
        if (weight[k] > 0) lost = x - (next - sum), sum = next;
        c->before[k + 1] = sum;
    }
    if (ok && sum > 0 && isfinite(sum)) return true;
    choice_free(c);
    return false;
}

static inline real choice_probability(const choice *c, size_t k)
{
    return (real)((c->before[k + 1] - c->before[k]) / c->before[c->n]);
}

/* u is at most 1 - 2^-53, and 2^-53 of the whole is half a step of double or more: x < whole after
 * rounding, too, unless the whole is below 1e-307 and rounds more coarsely. So before[lo] <= x <
 * before[hi] all the time, and in the end hi = lo + 1, a step of height above 0. A weight of 1e-300
 * beside one of 1e300 is met if u = 0; its p must not round to 0. */
static inline size_t choice_sample(const choice *c, real u, real *p, real *rest)
{
    double whole = c->before[c->n], x = (double)u * whole;
    size_t lo = 0, hi = c->n;
    if (!(x < whole)) x = nextafter(whole, 0.0);
    while (hi - lo > 1) {
        size_t middle = lo + (hi - lo) / 2;
        if (c->before[middle] <= x) lo = middle;
        else hi = middle;
    }
    double step = c->before[hi] - c->before[lo];
    *p = real_max((real)(step / whole), real_smallest);
    *rest = real_min((real)((x - c->before[lo]) / step), 1 - real_epsilon / 2);
    return lo;
}

#endif
