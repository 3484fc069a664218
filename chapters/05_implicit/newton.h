/* newton.h: roots of f(o + t d) by Newton's method (牛顿法), kept between two ends.
 *
 *         f |\                     t  <-  t - f(t) / f'(t)                                   (5.7)
 *           | \  tangent           doubles the number of right digits with each step, near a root;
 *         --+--\-.-----            far from one it may run off. So it stays between a and b, where
 *           a   \  ` . b           f has changed its sign: where it would leave, halve instead.
 *
 *   implicit_newton_hit(&s, r, steps, &h)    n steps as in first.h; in each of them
 *       f changes its sign                   a root: Newton, some 5 evaluations instead of 50
 *       it does not, but f comes nearer to   a turning point of f lies between: it is looked for,
 *       0 at a, and goes from it at b        until f has changed its sign there, or cannot
 *
 * Finds pairs of roots that n steps alone would miss; still misses what does more than one turn in
 * a step, and a double root (重根) whose f does not go below 0 in rounded numbers.
 *
 * Source: W. Press et al., "Numerical Recipes in C", 2nd ed., 1992, section 9.4.
 */
#ifndef IMPLICIT_NEWTON_H
#define IMPLICIT_NEWTON_H

#include "../01_ray/hit.h"
#include "surface.h"

typedef struct { real t, f, slope; } implicit_end;  /* of a step; f' = grad f . d */

/* ---------------------------------------------------------------------------------------------- */

static inline implicit_end implicit_end_at(const implicit_surface *s, ray r, real t)
{
    vec3 p = ray_at(r, t);
    return (implicit_end){t, implicit_value(s, p), vdot(implicit_gradient(s, p), r.d)};
}

/* f < 0 at one of a, b and not at the other: where it changes, to the last bit or two of t. */
static inline real implicit_polish(const implicit_surface *s, ray r, implicit_end a, implicit_end b)
{
    implicit_end c = fabs(a.f) < fabs(b.f) ? a : b;
    for (int k = 0; k < 100 && c.f != 0; k++) {
        real before = c.t, t = c.t - c.f / c.slope;                                     /* (5.7) */
        if (!(t > a.t && t < b.t) || k % 4 == 3) t = a.t / 2 + b.t / 2;  /* a NaN comes here too */
        if (!(t > a.t && t < b.t)) break;
        c = implicit_end_at(s, r, t);
        if ((c.f < 0) == (a.f < 0)) a = c;
        else b = c;
        if (fabs(c.t - before) <= real_epsilon * fabs(c.t)) break;
    }
    return c.t;
}

/* f has one sign at a and b, and comes nearer to 0 behind a and before b: halves the step, keeping
 * the half with the turn. True, and b where f has changed its sign, if it does. */
static inline bool implicit_turn(const implicit_surface *s, ray r, implicit_end a, implicit_end *b)
{
    for (;;) {
        implicit_end m = implicit_end_at(s, r, a.t / 2 + b->t / 2);
        if (!(m.t > a.t && m.t < b->t)) return false;
        bool changed = m.f == 0 || (m.f < 0) != (a.f < 0), falls = a.f * m.slope < 0;
        if (changed || !falls) *b = m;
        else a = m;
        if (changed) return true;
    }
}

static inline bool implicit_newton_hit(const implicit_surface *s, ray r, int steps, hit *out)
{
    if (!implicit_clip(s, &r)) return false;
    implicit_end a = implicit_end_at(s, r, r.tmin);
    for (int k = 1; k <= steps && a.f != 0; k++) {
        real t = r.tmin + (r.tmax - r.tmin) * ((real)k / (real)steps);
        implicit_end b = implicit_end_at(s, r, real_min(t, r.tmax)), c = b;
        bool changed = b.f == 0 || (a.f < 0) != (b.f < 0);
        bool turns = !changed && a.f * a.slope < 0 && b.f * b.slope > 0;
        if (isnan(a.f) || isnan(b.f)) changed = turns = false;
        if (changed || (turns && implicit_turn(s, r, a, &c))) {
            *out = (hit){implicit_polish(s, r, a, c), 0, 0, 0};
            return true;
        }
        a = b;
    }
    if (a.f == 0) *out = (hit){a.t, 0, 0, 0};
    return a.f == 0;
}

#endif
