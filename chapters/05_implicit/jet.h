/* jet.h: a number that depends on t, over a whole piece T of the ray: what it may be, and what its
 * derivative (导数) may be. f written once in jets gives f(T) and f'(T) together.
 *
 *   jet x = jet_on_ray(o.x, d.x, T);      o + t d for all t of T; its derivative is d
 *   jet y = jet_mul(x, x);                v = X X, and by the product rule d = X' X + X X'
 *   jet_add, _sub, _mul, _min, _max (a, b)            jet_square, _abs, _neg, _sin, _cos (a)
 *   jet_shift(a, c), jet_scale(a, c)                  a + c, c a
 *   jet_length(x, y, z)                               sqrt(x^2 + y^2 + z^2)
 *
 * Where a function has an edge (abs, min, max, the length of 0) the derivative is the hull of those
 * on both sides: for any two points the slope of the chord between them lies in it, which is all
 * that the mean value theorem (中值定理) is asked for in search.h.
 *
 * Sources: R. Moore, "Methods and Applications of Interval Analysis", 1979, chapter 3; D. Mitchell,
 * "Robust ray intersection with interval arithmetic", Graphics Interface 1990.
 */
#ifndef IMPLICIT_JET_H
#define IMPLICIT_JET_H

#include "interval.h"

typedef struct { interval v, d; } jet;

/* ---------------------------------------------------------------------------------------------- */

static inline jet jet_on_ray(real o, real d, interval T)
{
    interval way = interval_scale(T, (double)d);
    return (jet){interval_add(interval_at((double)o), way), interval_at((double)d)};
}

static inline jet jet_neg(jet a) { return (jet){interval_neg(a.v), interval_neg(a.d)}; }
static inline jet jet_add(jet a, jet b)
{
    return (jet){interval_add(a.v, b.v), interval_add(a.d, b.d)};
}
static inline jet jet_sub(jet a, jet b) { return jet_add(a, jet_neg(b)); }
static inline jet jet_mul(jet a, jet b)
{
    return (jet){interval_mul(a.v, b.v),
                 interval_add(interval_mul(a.d, b.v), interval_mul(a.v, b.d))};
}

/* Not x times x: that [-1, 1] [-1, 1] holds -1 is known better here. 2 X is exact. */
static inline jet jet_square(jet a)
{
    interval twice = {2 * a.v.lo, 2 * a.v.hi};
    return (jet){interval_square(a.v), interval_mul(twice, a.d)};
}

static inline jet jet_shift(jet a, double c)
{
    return (jet){interval_add(a.v, interval_at(c)), a.d};
}
static inline jet jet_scale(jet a, double c)
{
    return (jet){interval_scale(a.v, c), interval_scale(a.d, c)};
}

static inline jet jet_abs(jet a)
{
    interval back = interval_neg(a.d);
    interval d = a.v.lo >= 0 ? a.d : a.v.hi <= 0 ? back : interval_hull(a.d, back);
    return (jet){interval_abs(a.v), d};
}

static inline jet jet_min(jet a, jet b)
{
    interval d = a.v.hi < b.v.lo ? a.d : b.v.hi < a.v.lo ? b.d : interval_hull(a.d, b.d);
    return (jet){interval_min(a.v, b.v), d};
}
static inline jet jet_max(jet a, jet b) { return jet_neg(jet_min(jet_neg(a), jet_neg(b))); }

static inline jet jet_sin(jet a)
{
    return (jet){interval_sin(a.v), interval_mul(interval_cos(a.v), a.d)};
}
static inline jet jet_cos(jet a)
{
    return (jet){interval_cos(a.v), interval_neg(interval_mul(interval_sin(a.v), a.d))};
}

static inline interval interval_length(interval x, interval y, interval z)
{
    interval xx = interval_square(x), yy = interval_square(y), zz = interval_square(z);
    return interval_sqrt(interval_add(interval_add(xx, yy), zz));
}

/* A length changes no faster than its vector moves: |(x, y, z)'|; away from 0 it is known better,
 * (x x' + y y' + z z') / |(x, y, z)|. */
static inline jet jet_length(jet x, jet y, jet z)
{
    interval v = interval_length(x.v, y.v, z.v);
    double most = interval_length(x.d, y.d, z.d).hi;
    interval d = interval_of(-most, most);
    if (v.lo > 0) {
        interval dot = interval_add(interval_add(interval_mul(x.v, x.d), interval_mul(y.v, y.d)),
                                    interval_mul(z.v, z.d));
        d = interval_meet(d, interval_div(dot, v));
    }
    return (jet){v, d};
}

#endif
