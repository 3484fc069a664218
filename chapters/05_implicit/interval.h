/* interval.h: arithmetic on intervals (区间算术), rounded outwards: what f may be, over a whole piece
 * of space at once.
 *
 *   [1, 2] + [-1, 3] = [0, 5]        x in X and y in Y: then x + y is in X + Y, x y in X Y, ..
 *   [-1, 3]^2        = [0, 9]        with every rounding on the safe side
 *
 *   interval X = interval_of(lo, hi);             interval_at(x) is [x, x]
 *   interval_add, _sub, _mul, _div (X, Y)        interval_neg, _square, _sqrt, _sin, _cos, _abs (X)
 *   interval_min(X, Y)                            interval_scale(X, s)
 *   interval_hull(X, Y)                           the smallest that holds both
 *   interval_meet(X, Y)                           what both hold; may be empty
 *   interval_has(X, x), interval_is_empty(X), interval_is_bounded(X), interval_width(X)
 *   interval_size(X)                              the largest |x| in X
 *
 *   f                                 answer
 *   overflows; 1 / X, X holds 0       an end is infinite, [-inf, inf] in the worst case: all is
 *                                     possible, and nothing is proven
 *   nowhere defined: sqrt of X < 0    empty: both ends NaN, and so is all that is computed from it
 *   defined in part: sqrt of [-1, 4]  of the part where it is: [0, 2]
 *
 * How to round outwards without switching the processor's rounding: a result c is off by half a
 * unit in its last place at most, which is no more than 2^-53 |c|, or 2^-1075 where that is smaller
 * still. (5.8): c - (2^-53 (1 + 2^-52) |c| + 2^-1074), computed as it stands, is below the true
 * value, and never more than two numbers below c. Always double, whatever real is.
 *
 * Sources: R. Moore, "Interval Analysis", 1966; S. Rump, P. Zimmermann, S. Boldo, G. Melquiond,
 * "Computing predecessor and successor in rounding to nearest", BIT 49, 2009 (5.8); IEEE 1788-2015
 * (empty, and functions defined in part).
 */
#ifndef IMPLICIT_INTERVAL_H
#define IMPLICIT_INTERVAL_H

#include "../../common/vec3.h"

typedef struct { double lo, hi; } interval;

#define interval_all ((interval){-HUGE_VAL, HUGE_VAL})
#define interval_empty ((interval){(double)NAN, (double)NAN})

/* ---------------------------------------------------------------------------------------------- */

static inline interval interval_of(double lo, double hi) { return (interval){lo, hi}; }
static inline interval interval_at(double x) { return (interval){x, x}; }
static inline bool interval_has(interval a, double x) { return a.lo <= x && x <= a.hi; }
static inline bool interval_is_empty(interval a) { return !(a.lo <= a.hi); }
static inline bool interval_is_bounded(interval a) { return a.hi - a.lo <= DBL_MAX; }
static inline double interval_width(interval a) { return a.hi - a.lo; }

/* (5.8) A lower end that overflowed counts as the largest double; a NaN stays one. */
static inline double interval_down(double c)
{
    c = DBL_MAX < c ? DBL_MAX : c;
    return c - (0x1.0000000000001p-53 * fabs(c) + 0x1p-1074);
}
static inline double interval_up(double c) { return -interval_down(-c); }
static inline interval interval_out(double lo, double hi)
{
    return (interval){interval_down(lo), interval_up(hi)};
}

static inline double interval_least(double a, double b) { return a < b ? a : b; }
static inline double interval_most(double a, double b) { return a > b ? a : b; }

static inline double interval_size(interval a) { return interval_most(fabs(a.lo), fabs(a.hi)); }

static inline interval interval_neg(interval a) { return (interval){-a.hi, -a.lo}; }
static inline interval interval_add(interval a, interval b)
{
    return interval_out(a.lo + b.lo, a.hi + b.hi);
}
static inline interval interval_sub(interval a, interval b)
{
    return interval_add(a, interval_neg(b));
}

/* inf * 0, a NaN, is not empty: anything may come out. The sum of the four finds it. */
static inline interval interval_mul(interval a, interval b)
{
    double p = a.lo * b.lo, q = a.lo * b.hi, r = a.hi * b.lo, s = a.hi * b.hi;
    if (!(fabs(p + q + r + s) <= DBL_MAX)) {
        if (interval_is_empty(a) || interval_is_empty(b)) return interval_empty;
        if (!(fabs(p) + fabs(q) + fabs(r) + fabs(s) <= HUGE_VAL)) return interval_all;
    }
    return interval_out(interval_least(interval_least(p, q), interval_least(r, s)),
                        interval_most(interval_most(p, q), interval_most(r, s)));
}

/* Half the work, where one is a number that is neither 0 nor infinite. */
static inline interval interval_scale(interval a, double s)
{
    if (s > 0 && s <= DBL_MAX) return interval_out(a.lo * s, a.hi * s);
    if (s < 0 && s >= -DBL_MAX) return interval_out(a.hi * s, a.lo * s);
    return interval_mul(a, interval_at(s));
}

static inline interval interval_square(interval a)
{
    double p = a.lo * a.lo, q = a.hi * a.hi;
    if (a.lo <= 0 && a.hi >= 0) return (interval){0, interval_up(interval_most(p, q))};
    return a.lo > 0 ? interval_out(p, q) : interval_out(q, p);
}

static inline interval interval_div(interval a, interval b)
{
    if (interval_is_empty(a) || interval_is_empty(b)) return interval_empty;
    if (interval_has(b, 0)) return b.lo == 0 && b.hi == 0 ? interval_empty : interval_all;
    double p = a.lo / b.lo, q = a.lo / b.hi, r = a.hi / b.lo, s = a.hi / b.hi;
    if (!(fabs(p) + fabs(q) + fabs(r) + fabs(s) <= HUGE_VAL)) return interval_all;  /* inf / inf */
    return interval_out(interval_least(interval_least(p, q), interval_least(r, s)),
                        interval_most(interval_most(p, q), interval_most(r, s)));
}

/* sqrt is rounded as well as + is. */
static inline interval interval_sqrt(interval a)
{
    if (!(a.hi >= 0)) return interval_empty;
    double lo = a.lo > 0 ? interval_down(sqrt(a.lo)) : 0;
    return (interval){interval_most(lo, 0), interval_up(sqrt(a.hi))};
}

static inline interval interval_abs(interval a)
{
    if (a.lo >= 0 || interval_is_empty(a)) return a;
    return a.hi <= 0 ? interval_neg(a) : (interval){0, interval_most(-a.lo, a.hi)};
}

/* An empty argument makes the result empty: a comparison with a NaN is false. */
static inline interval interval_min(interval a, interval b)
{
    if (interval_is_empty(a)) return a;
    return (interval){a.lo < b.lo ? a.lo : b.lo, a.hi < b.hi ? a.hi : b.hi};
}

static inline interval interval_hull(interval a, interval b)
{
    if (interval_is_empty(a) || interval_is_empty(b)) return interval_is_empty(a) ? b : a;
    return (interval){interval_least(a.lo, b.lo), interval_most(a.hi, b.hi)};
}
static inline interval interval_meet(interval a, interval b)
{
    if (interval_is_empty(a) || interval_is_empty(b)) return interval_empty;
    return (interval){interval_most(a.lo, b.lo), interval_least(a.hi, b.hi)};
}

/* Of sine and cosine: the ends, and 1 or -1 where a crest or a trough lies between them. `quarter`
 * crests lie at pi/2 + 2 pi k, or, for the cosine, at 2 pi k. Where rounding leaves it open whether
 * one does, it counts as in. The libraries' sine is off by an ulp: here 2^-50 is allowed for. */
static inline interval interval_wave(interval a, double (*wave)(double), double first)
{
    const double turn = 6.283185307179586, near = 1e-14;  /* 2 pi */
    if (interval_is_empty(a)) return interval_empty;
    double slack = near * (1 + interval_size(a)), w = a.hi - a.lo;
    if (!(w < 6.28 && slack < 0.01)) return (interval){-1, 1};
    double p = wave(a.lo), q = wave(a.hi);
    double lo = interval_least(p, q) - 0x1p-50, hi = interval_most(p, q) + 0x1p-50;
    double crest = (a.lo - slack - first) / turn, trough = crest - 0.5;
    if (first + turn * ceil(crest) <= a.hi + slack) hi = 1;
    if (first + turn * (ceil(trough) + 0.5) <= a.hi + slack) lo = -1;
    return (interval){interval_most(lo, -1), interval_least(hi, 1)};
}
static inline double interval_sine(double x) { return sin(x); }
static inline double interval_cosine(double x) { return cos(x); }
static inline interval interval_sin(interval a)
{
    return interval_wave(a, interval_sine, 1.5707963267948966);
}
static inline interval interval_cos(interval a) { return interval_wave(a, interval_cosine, 0); }

#endif
