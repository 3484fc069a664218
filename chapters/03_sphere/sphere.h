/* sphere.h: where a ray meets a sphere (球), whatever the distance and the size.
 *
 *             . - ~ - .             |o + t d - c|^2 = R^2,  f = o - c,  a = d.d               (3.1)
 *   o ->--x'- - -|- - -'x-->        t_ca = -d.f / a        where the ray is nearest to c      (3.4)
 *      entry    q|    exit          D = a R^2 - |d x f|^2,  |d x f| = |d| q                   (3.5)
 *       t0  ' .  c  . '  t1         t = t_ca -+ t_hc,  t_hc = sqrt(D) / a: half the chord     (3.6)
 *
 * D is a quarter of the textbook's b^2 - 4ac (3.3), which is noise far from the sphere: two huge
 * numbers that nearly cancel. Here the terms are of the size of what is asked for, R and q. Where D
 * still is smaller than its own rounding error could be, it is computed again in twice the
 * precision: few rays in 1e9 from 1e6 R.
 *
 *   sphere_hit(s, r, &h)         the first root in [tmin, tmax]; from inside that is the exit
 *   sphere_hit_if_clear(..)      SPHERE_HIT or SPHERE_MISS where one look tells; else SPHERE_DOUBT
 *   sphere_roots(s, r, &t0, &t1) both roots, entry t0 <= exit t1, behind o, too
 *   first_sphere_hit, first_sphere_roots    the textbook, of first.h; `sphere` is from there, too
 *   sphere_point(s, p)           p moved to the surface, along the line from the centre
 *   sphere_normal(s, p)          unit normal at p
 *
 *   input                        answer
 *   d of any length but zero     t counts in lengths of d
 *   tangent ray                  a hit, t0 = t1; right to some 1e-30 of the distance
 *   R < 0                        the same points; the normal points inwards (seen from inside)
 *   R = 0                        the point c: hit by a ray exactly through it; normal 0
 *   d = 0, a NaN, an infinity    a miss
 *   extreme sizes                right as long as the points and t can be written as reals, and
 *                                no component of d, or of o - c, but 0 is 1e-200 of another
 *
 * Sources: A. Glassner (ed.), "An Introduction to Ray Tracing", 1989, ch. 2; E. Haines et al.,
 * "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems, 2019, ch. 7; J. Shewchuk,
 * "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates", Discrete &
 * Computational Geometry 18, 1997: do cheaply what is clear, and again exactly what is not.
 */
#ifndef SPHERE_H
#define SPHERE_H

#include "../01_ray/hit.h"
#include "../../common/numbers/wide.h"
#include "first.h"
#include <stddef.h>

/* ---------------------------------------------------------------------------------------------- */

/* The first of the two roots that the interval covers. A root beyond the largest real is no hit. */
static inline bool sphere_first(ray r, real t0, real t1, hit *out)
{
    r.tmax = real_min(real_largest, r.tmax);   /* in this order a NaN stays one: a miss */
    r.tmin = real_max(-real_largest, r.tmin);
    if (!ray_covers(r, t0)) t0 = t1;
    if (!ray_covers(r, t0)) return false;
    *out = (hit){t0, 0, 0, 0};
    return true;
}

/* k = |f|^2 - R^2: its sign tells on which side of the surface o = c + f lies. */
static inline wide sphere_power(wide3 f, double R)
{
    return wide_sub(wide3_dot(f, f), wide_product(R, R));
}

/* a 2^e; in two steps, since 2^e itself may be no double. */
static inline wide3 wide3_ldexp(wide3 a, int e)
{
    double p = ldexp(1, e / 2), q = ldexp(1, e - e / 2);
    return (wide3){{a.x.hi * p * q, a.x.lo * p * q}, {a.y.hi * p * q, a.y.lo * p * q},
                   {a.z.hi * p * q, a.z.lo * p * q}};
}

/* a times the power of two that brings its longest component, or `beside` if that is larger, into
 * [1/2, 1): exact, and squares stay in range. *exponent undoes it. */
static inline wide3 wide3_scaled(wide3 a, double beside, int *exponent)
{
    double xy = fmax(fabs(a.x.hi), fabs(a.y.hi)), most = fmax(xy, fabs(a.z.hi));
    (void)frexp(fmax(most, fabs(beside)), exponent);
    return wide3_ldexp(a, -*exponent);
}

/* How many rays of this thread took the slow way: for whoever wants to count. */
static _Thread_local size_t sphere_doubts;

/* The roots in numbers of twice the precision of double, for the few rays that sphere_roots cannot
 * tell. Scaling d, all lengths, and then what D is made of, is exact. Without the last step the
 * squares of R and d x f vanish for: R = 0 at (1,0,0), a ray along x that passes it at 1e-170. */
__attribute__((noinline, cold))
static bool sphere_roots_in_doubt(sphere s, ray r, real *t0, real *t1)
{
    sphere_doubts++;
    if (!vfinite(r.o) || !vfinite(s.c) || !isfinite(s.r)) return false;
    if (!vfinite(r.d) || vzero(r.d)) return false;
    vec3 most = vmax(vabs(r.o), vabs(s.c));
    int ed, el, ex, down = vaxis(most, vlongest(most)) > real_largest / 8 ? 3 : 0;
    wide3 o = wide3_of(r.o), c = wide3_of(s.c), d = wide3_scaled(wide3_of(r.d), 0, &ed);
    if (down) o = wide3_ldexp(o, -down), c = wide3_ldexp(c, -down);  /* else o - c may overflow */
    wide3 f = wide3_scaled(wide3_sub(o, c), ldexp((double)s.r, -down), &el);
    el += down;
    double R = ldexp((double)s.r, -el);

    wide3 x = wide3_scaled(wide3_cross(d, f), R, &ex);
    double Rx = ldexp(R, -ex);
    wide a = wide3_dot(d, d), ca = wide_neg(wide3_dot(d, f)), k = sphere_power(f, R);
    wide D = wide_sub(wide_mul(a, wide_product(Rx, Rx)), wide3_dot(x, x));               /* (3.5) */
    if (wide_sign(D) < 0) return false;
    wide hc = wide_mul(wide_sqrt(D), wide_of(ldexp(1, ex)));
    wide q = wide_sign(ca) < 0 ? wide_sub(ca, hc) : wide_add(ca, hc);
    real far = (real)ldexp(wide_value(wide_div(q, a)), el - ed);                         /* (3.6) */
    real near = (real)ldexp(wide_value(wide_div(k, q)), el - ed);                        /* (3.7) */
    *t0 = real_min(near, far);  /* if o is the tangent point, near is 0 / 0, and far, 0, wins */
    *t1 = real_max(near, far);
    return true;
}

/* What (3.5) and (3.6) are made of, all but D. In double, whatever real is: in float far too many
 * rays would be in doubt. fair: no square that matters has vanished; false for a NaN, too. */
typedef struct { double dx, dy, dz, fx, fy, fz, a, ca, ff, rr; bool fair; } sphere_terms;

static inline sphere_terms sphere_terms_of(sphere s, ray r)
{
    const double tiny = DBL_MIN / (DBL_EPSILON * DBL_EPSILON);
    double dx = (double)r.d.x, fx = (double)r.o.x - (double)s.c.x, R = (double)s.r;
    double dy = (double)r.d.y, fy = (double)r.o.y - (double)s.c.y;
    double dz = (double)r.d.z, fz = (double)r.o.z - (double)s.c.z;
    double a = dx * dx + dy * dy + dz * dz, ca = -(dx * fx + dy * fy + dz * fz);  /* (3.4) */
    double ff = fx * fx + fy * fy + fz * fz, rr = R * R;
    return (sphere_terms){dx, dy, dz, fx, fy, fz, a, ca, ff, rr, a > tiny && ff + rr > tiny};
}

/* The rounding errors of D stay below 5.4 epsilon sqrt((a R^2 + |x|^2) a (|f|^2 + R^2)), see
 * MEASURED.md, and climbing meets 2.1; 6 is asked. sure: the sign of D is. */
typedef struct { double a, ca, ff, rr, D; bool sure; } sphere_look;

static inline sphere_look sphere_look_at(const sphere_terms *q)
{
    const double noise = 6 * DBL_EPSILON;
    double x = q->dy * q->fz - q->dz * q->fy, y = q->dz * q->fx - q->dx * q->fz;
    double z = q->dx * q->fy - q->dy * q->fx;
    double arr = q->a * q->rr, xx = x * x + y * y + z * z, D = arr - xx;                 /* (3.5) */
    bool sure = D * D > noise * noise * (arr + xx) * (q->a * (q->ff + q->rr));
    return (sphere_look){q->a, q->ca, q->ff, q->rr, D, q->fair && sure};
}

static inline bool sphere_roots(sphere s, ray r, real *t0, real *t1)
{
    sphere_terms terms = sphere_terms_of(s, r);
    sphere_look q = sphere_look_at(&terms);
    if (!q.sure) return sphere_roots_in_doubt(s, r, t0, t1);
    if (q.D < 0) return false;
    double hc = sqrt(q.D), near = q.ca - hc, far = q.ca + hc;          /* each times a    (3.6) */
    *t0 = (real)(near / q.a);
    *t1 = (real)(far / q.a);
    if (fabs(q.ff - q.rr) < 8 * DBL_EPSILON * (q.ff + q.rr)) {  /* near or far is mere rounding */
        wide3 f = wide3_sub(wide3_of(r.o), wide3_of(s.c));
        double k = wide_value(sphere_power(f, (double)s.r));
        if (q.ca < 0) *t1 = (real)(k / near);                                            /* (3.7) */
        else *t0 = (real)(k / far);
    }
    return true;
}

typedef enum { SPHERE_MISS, SPHERE_HIT, SPHERE_DOUBT } sphere_answer;

/* The first root alone, where it is clear which one that is. f is off by epsilon / 2 of itself,
 * its squares, their sums and R^2 are rounded: k = ff - rr is off by less than 2.5 epsilon
 * (ff + rr). So beyond 3 its sign is sure: outside with the centre behind, both roots are behind.
 * (Should only rounding put it there, true ca is below 4 epsilon |d| |f|, and D = ca^2 - a k < 0:
 * no root.) Then D is not needed; rays that leave this sphere are of that kind. Inside, far is the
 * one. All else as above, to the last bit. */
static inline sphere_answer sphere_hit_if_clear(sphere s, ray r, hit *out)
{
    sphere_terms terms = sphere_terms_of(s, r);
    double k = terms.ff - terms.rr, off = DBL_EPSILON * (terms.ff + terms.rr);
    if (terms.fair && r.tmin == 0 && k > 3 * off && terms.ca < 0) return SPHERE_MISS;
    sphere_look q = sphere_look_at(&terms);
    bool sure = q.sure && r.tmin == 0, inside = k < 0 && q.ca >= 0;
    if (sure && q.D < 0) return SPHERE_MISS;
    if (!sure || !(fabs(k) > (inside ? 3 : 8) * off)) return SPHERE_DOUBT;
    double hc = sqrt(q.D), near = q.ca - hc;
    real t = (real)((!inside && near >= 0 ? near : q.ca + hc) / q.a);                    /* (3.6) */
    if (!(t >= 0 && t <= real_min(real_largest, r.tmax))) return SPHERE_MISS;
    *out = (hit){t, 0, 0, 0};
    return SPHERE_HIT;
}

static inline bool sphere_hit(sphere s, ray r, hit *out)
{
    sphere_answer answer = sphere_hit_if_clear(s, r, out);
    real t0, t1;
    if (answer != SPHERE_DOUBT) return answer == SPHERE_HIT;
    return sphere_roots(s, r, &t0, &t1) && sphere_first(r, t0, t1, out);
}

static inline vec3 sphere_normal(sphere s, vec3 p)
{
    return vscale(vunit(vsub(p, s.c)), s.r < 0 ? (real)-1 : (real)1);
}

/* c + |R| (p - c) / |p - c| (3.8): off by 4 epsilon of R, and by the rounding of the result. */
static inline vec3 sphere_point(sphere s, vec3 p)
{
    return vmadd(s.c, vunit(vsub(p, s.c)), fabs(s.r));
}

#endif
