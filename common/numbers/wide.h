/* wide.h: numbers of twice the precision of double, the oracle that errors are measured against.
 *
 * A wide is the unevaluated sum hi + lo of two doubles, |lo| <= ulp(hi)/2: some 32 decimal digits
 * with the range of double. Every real is a wide without error, so an input is known exactly,
 * whatever real is. Each operation is off by less than 1e-31 relatively, as long as the numbers and
 * their products stay between 1e-290 and 1e290; ten to twenty times the cost of double.
 *
 *   wide x = wide_of(0.1);               x exactly the double nearest to 0.1
 *   x = wide_mul(x, wide_sub(y, z));     wide_add, wide_sub, wide_mul, wide_div, wide_sqrt
 *   int s = wide_sign(x);                -1, 0 or 1
 *   double d = wide_value(x);            the nearest double
 *   wide p = wide_product(a, b);         a b of two doubles, exactly; wide_sum(a, b) likewise
 *
 * wide3 is a vector of three: wide3_of(vec3), _sub, _madd (a + s b), _dot, _cross, _length.
 *
 * Needs -ffp-contract=off: a contracted product would change the error terms. Sources: Dekker, "A
 * floating-point technique for extending the available precision", Numer. Math. 18, 1971; Joldes,
 * Muller, Popescu, "Tight and rigorous error bounds for basic building blocks of double-word
 * arithmetic", ACM TOMS 44(2), 2017: wide_add is algorithm 6, wide_mul is algorithm 10 and adds the
 * product of the low parts, too; Hida, Li, Bailey, "Algorithms for quad-double precision floating
 * point arithmetic", ARITH-15, 2001: wide_div.
 */
#ifndef WIDE_H
#define WIDE_H

#include "../vec3.h"

typedef struct { double hi, lo; } wide;
typedef struct { wide x, y, z; } wide3;

/* ---------------------------------------------------------------------------------------------- */

static inline wide wide_of(double x) { return (wide){x, 0}; }
static inline double wide_value(wide a) { return a.hi + a.lo; }
static inline wide wide_neg(wide a) { return (wide){-a.hi, -a.lo}; }

/* a + b exactly, if |a| >= |b| or a = 0. */
static inline wide wide_fast_sum(double a, double b)
{
    double s = a + b;
    return (wide){s, b - (s - a)};
}

/* a + b exactly (Knuth). */
static inline wide wide_sum(double a, double b)
{
    double s = a + b, bb = s - a;
    return (wide){s, (a - (s - bb)) + (b - bb)};
}

/* a b exactly, unless it underflows. */
static inline wide wide_product(double a, double b)
{
    double p = a * b;
    return (wide){p, fma(a, b, -p)};
}

static inline wide wide_add(wide a, wide b)
{
    wide s = wide_sum(a.hi, b.hi), t = wide_sum(a.lo, b.lo);
    s = wide_fast_sum(s.hi, s.lo + t.hi);
    return wide_fast_sum(s.hi, s.lo + t.lo);
}

static inline wide wide_sub(wide a, wide b) { return wide_add(a, wide_neg(b)); }

static inline wide wide_mul(wide a, wide b)
{
    wide p = wide_product(a.hi, b.hi);
    return wide_fast_sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi) + a.lo * b.lo);
}

/* Three steps of long division. */
static inline wide wide_div(wide a, wide b)
{
    double q1 = a.hi / b.hi;
    wide r = wide_sub(a, wide_mul(b, wide_of(q1)));
    double q2 = r.hi / b.hi;
    r = wide_sub(r, wide_mul(b, wide_of(q2)));
    wide q = wide_fast_sum(q1, q2);
    return wide_add(q, wide_of(r.hi / b.hi));
}

/* One Newton step from the double root; 0 for a <= 0. */
static inline wide wide_sqrt(wide a)
{
    if (!(a.hi > 0)) return wide_of(0);
    double s = sqrt(a.hi);
    wide rest = wide_sub(a, wide_product(s, s));
    return wide_add(wide_of(s), wide_of(rest.hi / (2 * s)));
}

/* -1, 0 or 1; the sign of hi is that of the sum, for |lo| <= ulp(hi)/2. */
static inline int wide_sign(wide a) { return (a.hi > 0) - (a.hi < 0); }

static inline wide3 wide3_of(vec3 a)
{
    return (wide3){wide_of((double)a.x), wide_of((double)a.y), wide_of((double)a.z)};
}

static inline wide3 wide3_sub(wide3 a, wide3 b)
{
    return (wide3){wide_sub(a.x, b.x), wide_sub(a.y, b.y), wide_sub(a.z, b.z)};
}

/* a + s b */
static inline wide3 wide3_madd(wide3 a, wide3 b, wide s)
{
    return (wide3){wide_add(a.x, wide_mul(s, b.x)), wide_add(a.y, wide_mul(s, b.y)),
                   wide_add(a.z, wide_mul(s, b.z))};
}

static inline wide wide3_dot(wide3 a, wide3 b)
{
    return wide_add(wide_add(wide_mul(a.x, b.x), wide_mul(a.y, b.y)), wide_mul(a.z, b.z));
}

static inline wide3 wide3_cross(wide3 a, wide3 b)
{
    return (wide3){wide_sub(wide_mul(a.y, b.z), wide_mul(a.z, b.y)),
                   wide_sub(wide_mul(a.z, b.x), wide_mul(a.x, b.z)),
                   wide_sub(wide_mul(a.x, b.y), wide_mul(a.y, b.x))};
}

static inline wide wide3_length(wide3 a) { return wide_sqrt(wide3_dot(a, a)); }

#endif
