/* search.h: every root of f(o + t d), by intervals: what is left out is proven to hold none.
 *
 *   T    |---------------|---------------|       f(T) does not hold 0: no root in T          (5.5)
 *   f(T) |::::::::::|    | ::::::::::::: |       f'(T) does not hold 0: at most one, and it
 *   ------------------------------------- 0      lies in N(T) = m - f(m) / f'(T), m in T     (5.6)
 *        |::::::::::|    |               |       neither: halve T, and ask again
 *
 * N is Newton's formula with all slopes at once. If N lies inside T there is exactly one root; else
 * there is none outside of both. Since every operation is rounded outwards, all of it is true of f
 * as written, not only nearly: no root is lost, on any ray.
 *
 *   implicit_search z = implicit_search_begin(&s, r);        r clipped: see surface.h
 *   while (implicit_next(&z, &root)) ...                     from tmin to tmax
 *   int n = implicit_roots(&s, r, root, most);               all of them, into an array
 *   implicit_search_hit(&s, r, &h)                           the first: as implicit_hit
 *
 *   root.single    exactly one root in [lo, hi], proven; a few rounding errors wide
 *   else           double precision cannot tell: f is 0 up to its own rounding in all of [lo, hi].
 *                  It counts as a hit: two roots that nearly meet, one double root, or a miss by
 *                  less than the rounding of f. For a miss by delta, with curvature f'' = 2 q, the
 *                  width is about sqrt((noise - delta) / q): 1e-8 of the size of the scene
 *   t              the middle of [lo, hi], if single; else lo, the first t that is not excluded
 *
 *   input                        answer
 *   o on the surface             a hit at tmin, unless rounding can tell that f(o) is not 0
 *   root at tmin or tmax         a hit; so is one beyond by less than 2 epsilon of t: t is rounded
 *   f not finite, or NaN, there  no surface there
 *   more than 100 000 pieces     what is left counts as one hit that is not proven
 *
 * Sources: Moore 1966 (see interval.h); Mitchell 1990 (see jet.h); E. Hansen, "A globally
 * convergent interval method", BIT 18, 1978; P. Hanrahan, "A survey of ray-surface intersection
 * algorithms", in A. Glassner (ed.), "An Introduction to Ray Tracing", 1989, chapter 3.
 */
#ifndef IMPLICIT_SEARCH_H
#define IMPLICIT_SEARCH_H

#include "surface.h"

enum { implicit_most_depth = 160, implicit_most_pieces = 100000 };
typedef struct { double lo, hi; bool single; } implicit_root;
typedef struct { interval T; bool single; } implicit_piece;
typedef struct {
    const implicit_surface *s;
    ray r;
    interval T;                                /* of r, and its rounding */
    implicit_piece todo[implicit_most_depth];  /* the nearest on top */
    int n;
    size_t pieces;                             /* looked at */
    double done;                               /* all t before are settled */
} implicit_search;

/* ---------------------------------------------------------------------------------------------- */

/* A t that was a hit, rounded to a real, must be one again with tmax = t: so both ends are moved
 * out by two epsilon of themselves. */
static inline implicit_search implicit_search_begin(const implicit_surface *s, ray r)
{
    const double slack = 2 * (double)real_epsilon;
    implicit_search z = {.s = s, .r = r, .done = -HUGE_VAL};
    if (!s->range || !implicit_clip(s, &z.r)) return z;
    z.T.lo = (double)z.r.tmin - slack * fabs((double)z.r.tmin);
    z.T.hi = (double)z.r.tmax + slack * fabs((double)z.r.tmax);
    z.todo[z.n++] = (implicit_piece){z.T, false};
    return z;
}

/* Where to cut: in the middle, but of [1, 1e30] at 1e15, so that it takes six cuts instead of a
 * hundred to get where something is. */
static inline double implicit_middle(interval T)
{
    if (T.lo >= 0 && T.hi > 64 && T.hi > 64 * T.lo) return sqrt(T.lo > 1 ? T.lo : 1) * sqrt(T.hi);
    if (T.hi <= 0 && T.lo < -64 && T.lo < 64 * T.hi)
        return -sqrt(T.hi < -1 ? -T.hi : 1) * sqrt(-T.lo);
    return T.lo / 2 + T.hi / 2;
}

/* A root that T could not prove because it lies at, or next to, its end: tried in three times T.
 * Where T is one number, eight of them: with fewer, less is proven, and nothing wrong.
 * False: proven to lie outside of [tmin, tmax]. */
static inline bool implicit_prove(implicit_search *z, implicit_root *root)
{
    double w = root->hi - root->lo + 0x1p-51 * (fabs(root->lo) + fabs(root->hi)) + 0x1p-1000;
    interval X = {root->lo - w, root->hi + w};
    double m = X.lo / 2 + X.hi / 2;
    interval slope = implicit_range(z->s, z->r, X).d;
    z->pieces++;
    if (!interval_is_bounded(slope) || interval_has(slope, 0)) return true;
    interval F = implicit_range(z->s, z->r, interval_at(m)).v;
    interval N = interval_sub(interval_at(m), interval_div(F, slope));                  /* (5.6) */
    if (!(N.lo > X.lo && N.hi < X.hi)) return true;
    *root = (implicit_root){N.lo, N.hi, true};
    z->done = X.hi;  /* the only one in X */
    return N.hi >= z->T.lo && N.lo <= z->T.hi;
}

static inline bool implicit_found(implicit_search *z, implicit_piece p, implicit_root *out)
{
    *out = (implicit_root){p.T.lo, p.T.hi, p.single};
    z->done = p.T.hi;
    if (!p.single && !implicit_prove(z, out)) return false;
    out->lo = interval_most(out->lo, z->T.lo), out->hi = interval_least(out->hi, z->T.hi);
    return true;
}

static inline void implicit_halve(implicit_search *z, interval T, double m)
{
    z->todo[z->n++] = (implicit_piece){{m, T.hi}, false};
    z->todo[z->n++] = (implicit_piece){{T.lo, m}, false};
}

/* A piece: left out, cut down, halved, or a root: only then true. */
static inline bool implicit_settle(implicit_search *z, implicit_piece p, implicit_root *out)
{
    interval T = p.T;
    jet J = implicit_range(z->s, z->r, T);
    if (!interval_has(J.v, 0)) return false;                                            /* (5.5) */
    double m = implicit_middle(T);
    bool least = !(m > T.lo && m < T.hi) || z->n + 2 > implicit_most_depth;
    interval spread = interval_mul(J.d, interval_sub(T, interval_at(m)));
    bool rises = !interval_has(J.d, 0);
    if (!rises && !least && interval_width(spread) >= 2 * interval_size(J.v))
        return implicit_halve(z, T, m), false;  /* whatever f(m) is, it would decide nothing */
    interval F = implicit_range(z->s, z->r, interval_at(m)).v;
    if (!interval_is_bounded(J.d) || !interval_is_bounded(F)) {  /* a pole; an infinite slope */
        if (!least) return implicit_halve(z, T, m), false;
        return interval_is_bounded(J.v) && implicit_found(z, p, out);
    }
    if (!interval_has(interval_add(F, spread), 0)) return false;
    if (rises) {
        interval N = interval_sub(interval_at(m), interval_div(F, J.d));                /* (5.6) */
        interval rest = interval_meet(N, T);
        p.single = p.single || (N.lo > T.lo && N.hi < T.hi);
        if (interval_is_empty(rest)) return false;
        p.T = rest;
        if (interval_width(rest) > interval_width(T) / 2 || least)
            return implicit_found(z, p, out);
        z->todo[z->n++] = p;
        return false;
    }
    /* Halving will not help where the rounding of f hides all of its change over T. */
    bool hidden = interval_has(F, 0) && interval_width(spread) <= 2 * interval_width(F);
    if (least || hidden) return implicit_found(z, p, out);
    return implicit_halve(z, T, m), false;
}

static inline bool implicit_next(implicit_search *z, implicit_root *out)
{
    while (z->n > 0) {
        implicit_piece p = z->todo[--z->n];
        p.T.lo = interval_most(p.T.lo, z->done);
        if (p.T.lo > p.T.hi || (p.T.lo == z->done && p.T.lo == p.T.hi)) continue;
        if (z->pieces++ < implicit_most_pieces) {
            if (implicit_settle(z, p, out)) return true;
        } else {
            *out = (implicit_root){p.T.lo, z->T.hi, false};
            z->n = 0;
            return true;
        }
    }
    return false;
}

/* At most `most` of them; those that touch and are not proven are one. */
static inline int implicit_roots(const implicit_surface *s, ray r, implicit_root *root, int most)
{
    implicit_search z = implicit_search_begin(s, r);
    implicit_root next;
    int n = 0;
    while (implicit_next(&z, &next)) {
        implicit_root *last = n ? &root[n - 1] : NULL;
        if (last && !last->single && !next.single && next.lo <= last->hi) last->hi = next.hi;
        else if (n == most) break;
        else root[n++] = next;
    }
    return n;
}

static inline bool implicit_search_hit(const implicit_surface *s, ray r, hit *out)
{
    implicit_search z = implicit_search_begin(s, r);
    implicit_root root;
    if (!implicit_next(&z, &root)) return false;
    real t = (real)(root.single ? root.lo / 2 + root.hi / 2 : root.lo);
    *out = (hit){real_clamp(t, z.r.tmin, z.r.tmax), 0, 0, 0};
    return true;
}

#endif
