/* sphere.h: where a ray meets a sphere (球), whatever the distance and the size.
 *
 *                  . - ~ - .              |o + t d - c|^2 = R^2                               (3.1)
 *       o ---->--x'- - - - -'x-->         a t^2 - 2 b t + k = 0,                              (3.2)
 *               entry  c  exit              f = o - c,  a = d.d,  b = -d.f,  k = f.f - R^2
 *                t0 ' . _ . ' t1          t = (b -+ sqrt(D)) / a,  D = b^2 - a k              (3.3)
 *                                           D = a R^2 - |d x f|^2                             (3.5)
 *
 * (3.3) as it stands is the textbook: far from the sphere b^2 and a k are huge and nearly equal,
 * and their difference is noise: R = 1 seen from 1e4 in float, or a ray from 1e6 that passes at
 * 1.0001 R in double. (3.5) is the same number by Lagrange's identity, with terms of the
 * size of what is asked for: R, and how far the ray passes from c. Where D still is smaller than
 * its own rounding error could be, it is computed again in twice the precision: few rays in 1e9
 * from 1e6 R.
 *
 *   sphere_hit(s, r, &h)         the first root in [tmin, tmax]; from inside that is the exit
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
 *   extreme sizes                right as long as the points and t can be written as reals
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

static inline bool sphere_roots(sphere s, ray r, real *t0, real *t1);
static inline bool sphere_hit(sphere s, ray r, hit *out);
static inline vec3 sphere_point(sphere s, vec3 p);
static inline vec3 sphere_normal(sphere s, vec3 p);

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

static inline wide3 wide3_ldexp(vec3 a, int e)
{
    double x = ldexp((double)a.x, e), y = ldexp((double)a.y, e), z = ldexp((double)a.z, e);
    return (wide3){wide_of(x), wide_of(y), wide_of(z)};
}

/* The roots in numbers of twice the precision of double, for the few rays that sphere_roots cannot
 * tell. Scaling d, and all lengths, by powers of two is exact, and keeps every square in range. */
__attribute__((noinline, cold))
static bool sphere_roots_in_doubt(sphere s, ray r, real *t0, real *t1)
{
    if (!vfinite(r.o) || !vfinite(s.c) || !isfinite(s.r)) return false;
    if (!vfinite(r.d) || vzero(r.d)) return false;
    vec3 most = vmax(vmax(r.o, vneg(r.o)), vmax(s.c, vneg(s.c)));
    int ed, el;
    (void)frexp(vaxis(r.d, vlongest(r.d)), &ed);
    (void)frexp(real_max(fabs(s.r), vaxis(most, vlongest(most))), &el);
    wide3 d = wide3_ldexp(r.d, -ed), f = wide3_sub(wide3_ldexp(r.o, -el), wide3_ldexp(s.c, -el));
    double R = ldexp((double)s.r, -el);

    wide3 x = wide3_cross(d, f);
    wide a = wide3_dot(d, d), b = wide_neg(wide3_dot(d, f)), k = sphere_power(f, R);
    wide D = wide_sub(wide_mul(a, wide_product(R, R)), wide3_dot(x, x));                 /* (3.5) */
    if (wide_sign(D) < 0) return false;
    wide h = wide_sqrt(D), q = wide_sign(b) < 0 ? wide_sub(b, h) : wide_add(b, h);       /* (3.4) */
    real far = (real)ldexp(wide_value(wide_div(q, a)), el - ed);
    real near = (real)ldexp(wide_value(wide_div(k, q)), el - ed);
    *t0 = real_min(near, far);  /* if o is the tangent point, near is 0 / 0, and far, 0, wins */
    *t1 = real_max(near, far);
    return true;
}

/* In double, whatever real is: in float far too many rays would be in doubt. The rounding errors of
 * D stay below 6 epsilon sqrt((a R^2 + |x|^2) a (|f|^2 + R^2)), see README; noise leaves room. */
static inline bool sphere_roots(sphere s, ray r, real *t0, real *t1)
{
    const double noise = 10 * DBL_EPSILON, tiny = DBL_MIN / (DBL_EPSILON * DBL_EPSILON);
    double dx = (double)r.d.x, fx = (double)r.o.x - (double)s.c.x, R = (double)s.r;
    double dy = (double)r.d.y, fy = (double)r.o.y - (double)s.c.y;
    double dz = (double)r.d.z, fz = (double)r.o.z - (double)s.c.z;
    double x = dy * fz - dz * fy, y = dz * fx - dx * fz, z = dx * fy - dy * fx;
    double a = dx * dx + dy * dy + dz * dz, b = -(dx * fx + dy * fy + dz * fz);
    double ff = fx * fx + fy * fy + fz * fz, rr = R * R, size = ff + rr;
    double arr = a * rr, xx = x * x + y * y + z * z, D = arr - xx;                       /* (3.5) */
    if (!(a > tiny && size > tiny && D * D > noise * noise * (arr + xx) * (a * size)))
        return sphere_roots_in_doubt(s, r, t0, t1);                       /* a NaN comes here too */
    if (D < 0) return false;
    double h = sqrt(D), near = b - h, far = b + h;
    *t0 = (real)(near / a);                                                              /* (3.3) */
    *t1 = (real)(far / a);
    if (fabs(ff - rr) < noise * size) {  /* o is on the surface: near or far is mere rounding */
        wide3 f = wide3_sub(wide3_of(r.o), wide3_of(s.c));
        double k = wide_value(sphere_power(f, R));
        if (b < 0) *t1 = (real)(k / near);                                               /* (3.4) */
        else *t0 = (real)(k / far);
    }
    return true;
}

static inline bool sphere_hit(sphere s, ray r, hit *out)
{
    real t0, t1;
    return sphere_roots(s, r, &t0, &t1) && sphere_first(r, t0, t1, out);
}

static inline vec3 sphere_normal(sphere s, vec3 p)
{
    return vscale(vunit(vsub(p, s.c)), s.r < 0 ? (real)-1 : (real)1);
}

/* c + |R| (p - c) / |p - c| (3.6): off by 4 epsilon of R, and by the rounding of the result. */
static inline vec3 sphere_point(sphere s, vec3 p)
{
    return vmadd(s.c, vunit(vsub(p, s.c)), fabs(s.r));
}

#endif
