/* implicit_oracle.h: the roots of f(o + t d) where f is a polynomial: how many, and where, in 32
 * digits.
 *
 *   implicit_poly p = implicit_poly_sphere(R, r, at);     f along the ray r, in powers of t - at
 *   implicit_poly_torus(ring, r, at), implicit_poly_barth(r, at)
 *   implicit_truth truth;
 *   if (implicit_oracle(&p, a, b, at, &truth)) ...        roots in [a, b], and the first of them;
 *                                                         false: 32 digits cannot tell
 *
 * Between two neighbouring roots of its derivative a polynomial rises or falls, so it crosses 0 at
 * most once there: two signs tell, and halving finds the place. The derivative's roots are found in
 * the same way, down to a constant. Nothing of this is used by what it judges: no interval, no jet,
 * not f itself. Wide numbers: common/numbers/wide.h.
 */
#ifndef IMPLICIT_ORACLE_H
#define IMPLICIT_ORACLE_H

#include "../../../common/numbers/wide.h"
#include "../scenes/surfaces.h"

enum { implicit_degree = 6 };
typedef struct { int n; wide c[implicit_degree + 1]; } implicit_poly;  /* c[0] + .. + c[n] x^n */
typedef struct { int roots; double first; } implicit_truth;

/* ---------------------------------------------------------------------------------------------- */

static inline implicit_poly implicit_poly_number(wide c) { return (implicit_poly){0, {c}}; }

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
    implicit_poly q[4], RR = implicit_poly_number(wide_product((double)R, (double)R));
    implicit_poly_squares(r, at, q);
    return implicit_poly_add(q[3], RR, wide_of(-1));
}

static inline implicit_poly implicit_poly_torus(implicit_ring k, ray r, double at)
{
    implicit_poly q[4];
    wide RR = wide_product((double)k.R, (double)k.R), rr = wide_product((double)k.r, (double)k.r);
    implicit_poly_squares(r, at, q);
    implicit_poly flat = implicit_poly_add(q[0], q[1], wide_of(1));
    implicit_poly number = implicit_poly_number(wide_sub(RR, rr));
    implicit_poly u = implicit_poly_add(q[3], number, wide_of(1));
    return implicit_poly_add(implicit_poly_mul(u, u), flat, wide_mul(wide_of(-4), RR));
}

/* With the doubles g^2 and 1 + 2 g of surfaces.h. */
static inline implicit_poly implicit_poly_barth(ray r, double at)
{
    const double g = implicit_golden, a = g * g, last = 1 + 2 * g;
    implicit_poly q[4], factor = implicit_poly_number(wide_of(4));
    implicit_poly_squares(r, at, q);
    for (int k = 0; k < 3; k++) {
        implicit_poly big = implicit_poly_mul(q[k], implicit_poly_number(wide_of(a)));
        factor = implicit_poly_mul(factor, implicit_poly_add(big, q[(k + 1) % 3], wide_of(-1)));
    }
    implicit_poly s = implicit_poly_add(q[3], implicit_poly_number(wide_of(1)), wide_of(-1));
    return implicit_poly_add(factor, implicit_poly_mul(s, s), wide_of(-last));
}

static inline double implicit_poly_size(const implicit_poly *p)
{
    double most = 0;
    for (int i = 0; i <= p->n; i++) most = fmax(most, fabs(p->c[i].hi));
    return most;
}

/* The places in [-1, 1] where p changes its sign, rising. *sure turns false if p comes so near to 0
 * at an end, or where it turns, that 32 digits cannot tell. */
static inline int implicit_poly_roots(const implicit_poly *p, double *root, bool *sure)
{
    double at[implicit_degree + 1], noise = 1e-27 * implicit_poly_size(p);
    implicit_poly slope = {p->n - 1, {{0, 0}}};
    bool any = true;
    if (p->n < 1) return 0;
    for (int i = 0; i < p->n; i++) slope.c[i] = wide_mul(wide_of(i + 1), p->c[i + 1]);
    int turns = implicit_poly_roots(&slope, at + 1, &any), n = 0;
    at[0] = -1, at[turns + 1] = 1;
    for (int k = 0; k <= turns; k++) {
        double lo = at[k], hi = at[k + 1];
        wide from = implicit_poly_at(p, lo), to = implicit_poly_at(p, hi);
        *sure = *sure && fabs(from.hi) > noise && fabs(to.hi) > noise;
        if (wide_sign(from) * wide_sign(to) >= 0) continue;
        for (int i = 0; i < 100; i++) {
            double m = (lo + hi) / 2;
            if (!(m > lo && m < hi)) break;
            if (wide_sign(implicit_poly_at(p, m)) == wide_sign(from)) lo = m;
            else hi = m;
        }
        root[n++] = hi;
    }
    return n;
}

/* Roots in [a, b]; p in powers of t - at, and at in the middle of [a, b] or near it. False: p has,
 * as far as 32 digits tell, a double root. */
static inline bool implicit_oracle(const implicit_poly *p, double a, double b, double at,
                                   implicit_truth *out)
{
    double half = fmax(fabs(a - at), fabs(b - at)), root[implicit_degree];
    implicit_poly scaled = *p;  /* to [-1, 1]: then no coefficient is large without need */
    wide power = wide_of(1);
    bool sure = true;
    for (int i = 0; i <= p->n; i++, power = wide_mul(power, wide_of(half)))
        scaled.c[i] = wide_mul(p->c[i], power);
    *out = (implicit_truth){0, 0};
    int n = implicit_poly_roots(&scaled, root, &sure);
    for (int k = n - 1; k >= 0; k--) {
        double t = at + half * root[k];
        if (t >= a && t <= b) *out = (implicit_truth){out->roots + 1, t};
    }
    return sure;
}

#endif
