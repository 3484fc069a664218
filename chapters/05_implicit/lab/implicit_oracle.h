/* implicit_oracle.h: the roots of f(o + t d) where f is a polynomial: how many, and where, in 32
 * digits.
 *
 *   implicit_poly p = implicit_poly_sphere(R, r, at);     f along the ray r, in powers of t - at
 *   implicit_poly_torus(ring, r, at), implicit_poly_barth(r, at)
 *   implicit_truth truth;
 *   if (implicit_oracle(&p, a, b, at, &truth)) ...        roots in [a, b], and the first of them;
 *                                                         false: 32 digits cannot tell
 *
 * By a Sturm chain (斯图姆序列): p0 = p, p1 = p', p_{k+1} = -(rest of p_{k-1} / p_k). Between a and
 * b there are as many roots, each counted once, as changes of sign that the chain at a has more
 * than the chain at b. Halving isolates the first one. Nothing of this is used by what it judges:
 * no interval, no jet, not f itself.
 *
 * Source: C. Sturm, "Mémoire sur la résolution des équations numériques", 1829; W. Press et al.,
 * "Numerical Recipes in C", 2nd ed., 1992, section 9.5; wide numbers: common/numbers/wide.h.
 */
#ifndef IMPLICIT_ORACLE_H
#define IMPLICIT_ORACLE_H

#include "../../../common/numbers/wide.h"
#include "../scenes/surfaces.h"

enum { implicit_degree = 6 };
typedef struct { int n; wide c[implicit_degree + 1]; } implicit_poly;  /* c[0] + .. + c[n] x^n */
typedef struct { int links; implicit_poly p[implicit_degree + 1]; } implicit_chain;
typedef struct { int roots; double first; } implicit_truth;

/* ---------------------------------------------------------------------------------------------- */

static inline implicit_poly implicit_poly_add(implicit_poly a, implicit_poly b, wide s)  /* a+s b */
{
    implicit_poly sum = {a.n > b.n ? a.n : b.n, {{0, 0}}};
    for (int i = 0; i <= sum.n; i++) {
        wide x = i <= a.n ? a.c[i] : wide_of(0), y = i <= b.n ? b.c[i] : wide_of(0);
        sum.c[i] = wide_add(x, wide_mul(s, y));
    }
    return sum;
}

static inline implicit_poly implicit_poly_mul(implicit_poly a, implicit_poly b)
{
    implicit_poly p = {a.n + b.n, {{0, 0}}};
    for (int i = 0; i <= a.n; i++)
        for (int j = 0; j <= b.n; j++)
            p.c[i + j] = wide_add(p.c[i + j], wide_mul(a.c[i], b.c[j]));
    return p;
}

static inline wide implicit_poly_at(const implicit_poly *p, double x)
{
    wide y = p->c[p->n];
    for (int i = p->n - 1; i >= 0; i--) y = wide_add(wide_mul(y, wide_of(x)), p->c[i]);
    return y;
}

/* The squares of the three coordinates of o + (at + x) d, and their sum. */
static inline void implicit_poly_squares(ray r, double at, implicit_poly q[4])
{
    for (int k = 0; k < 3; k++) {
        double o = (double)vaxis(r.o, k), d = (double)vaxis(r.d, k);
        wide c0 = wide_add(wide_of(o), wide_product(at, d));
        implicit_poly x = {1, {c0, wide_of(d)}};
        q[k] = implicit_poly_mul(x, x);
        q[3] = k ? implicit_poly_add(q[3], q[k], wide_of(1)) : q[0];
    }
}

static inline implicit_poly implicit_poly_sphere(real R, ray r, double at)
{
    implicit_poly q[4];
    implicit_poly_squares(r, at, q);
    q[3].c[0] = wide_sub(q[3].c[0], wide_product((double)R, (double)R));
    return q[3];
}

static inline implicit_poly implicit_poly_torus(implicit_ring k, ray r, double at)
{
    implicit_poly q[4];
    wide RR = wide_product((double)k.R, (double)k.R), rr = wide_product((double)k.r, (double)k.r);
    implicit_poly_squares(r, at, q);
    q[3].c[0] = wide_add(q[3].c[0], wide_sub(RR, rr));
    implicit_poly flat = implicit_poly_add(q[0], q[1], wide_of(1));
    return implicit_poly_add(implicit_poly_mul(q[3], q[3]), flat, wide_mul(wide_of(-4), RR));
}

/* With the doubles g^2 and 1 + 2 g of surfaces.h. */
static inline implicit_poly implicit_poly_barth(ray r, double at)
{
    const double g = implicit_golden;
    implicit_poly q[4], factor = {0, {{-4, 0}}};
    implicit_poly_squares(r, at, q);
    for (int k = 0; k < 3; k++)
        factor = implicit_poly_mul(factor, implicit_poly_add(q[(k + 1) % 3], q[k],
                                                             wide_of(-(g * g))));
    q[3].c[0] = wide_sub(q[3].c[0], wide_of(1));
    return implicit_poly_add(factor, implicit_poly_mul(q[3], q[3]), wide_of(-(1 + 2 * g)));
}

static inline double implicit_poly_size(const implicit_poly *p)
{
    double most = 0;
    for (int i = 0; i <= p->n; i++) most = fmax(most, fabs(p->c[i].hi));
    return most;
}

/* The rest of a / b, with its sign turned, brought to size 1: only signs count. Its leading terms
 * that are nothing but rounding are dropped; n = -1: nothing is left. */
static inline implicit_poly implicit_poly_rest(implicit_poly a, const implicit_poly *b)
{
    const double noise = 1e-26;
    double size = implicit_poly_size(&a);
    for (int i = a.n; i >= b->n; i--) {
        wide by = wide_div(a.c[i], b->c[b->n]);
        for (int j = 0; j < b->n; j++)
            a.c[i - b->n + j] = wide_sub(a.c[i - b->n + j], wide_mul(by, b->c[j]));
        size = fmax(size, fabs(by.hi) * implicit_poly_size(b));
    }
    a.n = b->n - 1;
    while (a.n >= 0 && fabs(a.c[a.n].hi) <= noise * size) a.n--;
    double most = a.n < 0 ? 1 : implicit_poly_size(&a);
    for (int i = 0; i <= a.n; i++) a.c[i] = wide_neg(wide_div(a.c[i], wide_of(most)));
    return a;
}

/* x scaled so that [-1, 1] is the interval: then no coefficient is large without need. */
static inline implicit_chain implicit_chain_of(const implicit_poly *p, double half)
{
    implicit_chain s = {.links = 2};
    wide power = wide_of(1);
    s.p[0] = *p;
    for (int i = 0; i <= p->n; i++, power = wide_mul(power, wide_of(half)))
        s.p[0].c[i] = wide_mul(p->c[i], power);
    while (s.p[0].n > 1 && fabs(s.p[0].c[s.p[0].n].hi) <= 1e-28 * implicit_poly_size(&s.p[0]))
        s.p[0].n--;
    s.p[1].n = s.p[0].n - 1;
    for (int i = 0; i < s.p[0].n; i++)
        s.p[1].c[i] = wide_mul(wide_of(i + 1), s.p[0].c[i + 1]);
    while (s.p[s.links - 1].n > 0) {
        implicit_poly rest = implicit_poly_rest(s.p[s.links - 2], &s.p[s.links - 1]);
        if (rest.n < 0) break;
        s.p[s.links++] = rest;
    }
    return s;
}

static inline int implicit_changes(const implicit_chain *s, double x)
{
    int changes = 0, last = 0;
    for (int i = 0; i < s->links; i++) {
        int sign = wide_sign(implicit_poly_at(&s->p[i], x));
        if (sign != 0 && last != 0 && sign != last) changes++;
        if (sign != 0) last = sign;
    }
    return changes;
}

/* Roots in [a, b]; p in powers of t - at, and at in the middle of [a, b] or near it. False: p has,
 * as far as 32 digits tell, a double root. */
static inline bool implicit_oracle(const implicit_poly *p, double a, double b, double at,
                                   implicit_truth *out)
{
    double half = fmax(fabs(a - at), fabs(b - at)), lo = (a - at) / half, hi = (b - at) / half;
    implicit_chain s = implicit_chain_of(p, half);
    if (s.p[s.links - 1].n > 0) return false;
    int before = implicit_changes(&s, lo), n = before - implicit_changes(&s, hi);
    *out = (implicit_truth){n, 0};
    for (int k = 0; k < 100 && n > 0; k++) {
        double m = (lo + hi) / 2;
        if (!(m > lo && m < hi)) break;
        if (implicit_changes(&s, m) < before) hi = m;
        else lo = m;
    }
    out->first = at + half * hi;
    return true;
}

#endif
