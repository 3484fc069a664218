/* sphere.h: where a ray meets a sphere (球), whatever the distance and the size.
 *
 *                  . - ~ - .              |o + t d - c|^2 = R^2                               (3.1)
 *       o ---->--x'- - - - -'x-->         a t^2 - 2 b t + k = 0,                              (3.2)
 *               entry  c  exit              f = o - c,  a = d.d,  b = -d.f,  k = f.f - R^2
 *                t0 ' . _ . ' t1          t = (b -+ sqrt(D)) / a,  D = b^2 - a k              (3.3)
 *                                           D = a R^2 - |d x f|^2                             (3.5)
 *
 * (3.3) as it stands is the textbook: far from the sphere b^2 and a k are huge and nearly equal, and
 * their difference is noise. (3.5) is the same number by Lagrange's identity; its terms are of the size
 * of R whatever the distance, so it is right to some 4 epsilon of a R^2 if d x f is.
 *
 *   sphere_hit(s, r, &h)         the first root in [tmin, tmax]; a ray that starts inside finds the exit
 *   sphere_roots(s, r, &t0, &t1) both roots, entry t0 <= exit t1, whatever the interval, behind o too
 *   sphere_hit_naive, sphere_roots_naive    the textbook, to compare
 *   sphere_point(s, p)           p moved to the surface, along the line from the centre
 *   sphere_normal(s, p)          unit normal at p
 *
 *   input                        answer
 *   d of any length but zero     t counts in lengths of d
 *   tangent ray                  a hit, t0 = t1, as well as rounding can tell
 *   R < 0                        the same points; the normal points inwards (seen from inside)
 *   R = 0                        the point c: hit only by a ray that runs through it exactly; normal 0
 *   d = 0, a NaN, an infinity    a miss
 *   extreme sizes                right as long as the points and t can be written as reals
 *
 * Sources: A. Glassner (ed.), "An Introduction to Ray Tracing", 1989, ch. 2; E. Haines et al.,
 * "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems, 2019, ch. 7.
 */
#ifndef SPHERE_H
#define SPHERE_H

#include "../01_ray/hit.h"
#include "../01_ray/wide.h"

typedef struct { vec3 c; real r; } sphere;  /* centre and radius */

static inline bool sphere_roots_naive(sphere s, ray r, real *t0, real *t1);
static inline bool sphere_hit_naive(sphere s, ray r, hit *out);
static inline bool sphere_roots(sphere s, ray r, real *t0, real *t1);
static inline bool sphere_hit(sphere s, ray r, hit *out);
static inline vec3 sphere_point(sphere s, vec3 p);
static inline vec3 sphere_normal(sphere s, vec3 p);

/* ------------------------------------------------------------------------------------------------ */

/* The first of the two roots that the interval covers. A root beyond the largest real is no hit. */
static inline bool sphere_first(ray r, real t0, real t1, hit *out)
{
    r.tmax = real_min(real_largest, r.tmax);  /* in this order a NaN stays one: a miss */
    if (!ray_covers(r, t0)) t0 = t1;
    if (!ray_covers(r, t0)) return false;
    *out = (hit){t0, 0, 0, 0};
    return true;
}

/* Fails for: R = 1 seen from 1e4 in float, or a ray from 1e6 that passes at 1.0001 R in double. */
static inline bool sphere_roots_naive(sphere s, ray r, real *t0, real *t1)
{
    vec3 f = vsub(r.o, s.c);
    real a = vdot(r.d, r.d), b = 2 * vdot(r.d, f), k = vdot(f, f) - s.r * s.r;
    real D = b * b - 4 * a * k;
    if (!(D >= 0)) return false;
    *t0 = (-b - sqrt(D)) / (2 * a);
    *t1 = (-b + sqrt(D)) / (2 * a);
    return true;
}

static inline bool sphere_hit_naive(sphere s, ray r, hit *out)
{
    real t0, t1;
    return sphere_roots_naive(s, r, &t0, &t1) && sphere_first(r, t0, t1, out);
}

/* k = |o - c|^2 - R^2, right to the last bit: its sign tells on which side of the surface o lies. */
static inline real sphere_power(sphere s, vec3 o)
{
    wide3 f = wide3_sub(wide3_of(o), wide3_of(s.c));
    return (real)wide_value(wide_sub(wide3_dot(f, f), wide_product((double)s.r, (double)s.r)));
}

/* The roots in numbers of twice the precision of double, for the few rays that sphere_roots cannot
 * tell. Scaling d, and all lengths, by powers of two is exact, and keeps every square in range. */
__attribute__((cold))
static inline bool sphere_roots_in_doubt(sphere s, ray r, real *t0, real *t1)
{
    if (!vfinite(r.o) || !vfinite(r.d) || !vfinite(s.c) || !isfinite(s.r) || vzero(r.d)) return false;
    vec3 most = vmax(vmax(r.o, vneg(r.o)), vmax(s.c, vneg(s.c)));
    int ed, el;
    r.d = vscaled(r.d, &ed);
    (void)frexp(real_max(fabs(s.r), vaxis(most, vlongest(most))), &el);
    r.o = (vec3){ldexp(r.o.x, -el), ldexp(r.o.y, -el), ldexp(r.o.z, -el)};
    s.c = (vec3){ldexp(s.c.x, -el), ldexp(s.c.y, -el), ldexp(s.c.z, -el)};
    s.r = ldexp(s.r, -el);

    wide3 d = wide3_of(r.d), f = wide3_sub(wide3_of(r.o), wide3_of(s.c)), x = wide3_cross(d, f);
    wide a = wide3_dot(d, d), b = wide_neg(wide3_dot(d, f)), k = wide_of((double)sphere_power(s, r.o));
    wide D = wide_sub(wide_mul(a, wide_product((double)s.r, (double)s.r)), wide3_dot(x, x)); /* (3.5) */
    if (wide_sign(D) < 0) return false;
    wide h = wide_sqrt(D), q = wide_sign(b) < 0 ? wide_sub(b, h) : wide_add(b, h);           /* (3.4) */
    if (wide_sign(q) == 0) return *t0 = *t1 = 0, true;            /* o is the tangent point: not 0/0 */
    real far = ldexp((real)wide_value(wide_div(q, a)), el - ed);
    real near = ldexp((real)wide_value(wide_div(k, q)), el - ed);
    *t0 = real_min(near, far);
    *t1 = real_max(near, far);
    return true;
}

static inline bool sphere_roots(sphere s, ray r, real *t0, real *t1)
{
    const real noise = 10 * real_epsilon, tiny = real_smallest / (real_epsilon * real_epsilon);
    vec3 f = vsub(r.o, s.c), x = vcross(r.d, f);
    real a = vdot(r.d, r.d), b = -vdot(r.d, f), ff = vdot(f, f), rr = s.r * s.r;
    real arr = a * rr, xx = vdot(x, x), D = arr - xx, size = ff + rr;                        /* (3.5) */
    if (!(real_min(a, size) > tiny && D * D > noise * noise * (arr + xx) * (a * size)))
        return sphere_roots_in_doubt(s, r, t0, t1);
    if (D < 0) return false;
    real h = sqrt(D), k = ff - rr;
    *t0 = (b - h) / a;
    *t1 = (b + h) / a;
    if (fabs(k) < noise * size) {
        k = sphere_power(s, r.o);
        if (b < 0) *t1 = k / (b - h);
        else *t0 = k / (b + h);
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

static inline vec3 sphere_point(sphere s, vec3 p)
{
    return vmadd(s.c, vunit(vsub(p, s.c)), fabs(s.r));
}

#endif
