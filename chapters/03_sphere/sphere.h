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

/* What rounding took from the sum s = a + b (Knuth): exactly a + b - s. */
static inline real sum_error(real a, real b, real s)
{
    real bb = s - a;
    return (a - (s - bb)) + (b - bb);
}

/* d x f, each component to 1.5 units in its last place. */
static inline vec3 cross_kahan(vec3 d, vec3 f)
{
    return (vec3){difference_of_products(d.y, f.z, d.z, f.y),
                  difference_of_products(d.z, f.x, d.x, f.z),
                  difference_of_products(d.x, f.y, d.y, f.x)};
}

/* |f + e|^2 - R^2 to the last bits, even where the two are nearly equal: its sign tells whether o is
 * outside. Every rounding error on the way is kept and given back. */
static inline real power_of_origin(vec3 f, vec3 e, real R)
{
    real v[4] = {R, f.x, f.y, f.z}, sum = 0, lost = 0;
    for (int i = 0; i < 4; i++) {
        real p = i ? v[i] * v[i] : -(R * R), next = sum + p;
        lost += (i ? fma(v[i], v[i], -p) : -fma(R, R, p)) + sum_error(sum, p, next);
        sum = next;
    }
    return sum + (lost + 2 * vdot(f, e));
}

/* The same problem with d and all lengths scaled by powers of two, which is exact, so that no square
 * overflows or vanishes. Rare, so it may be slow. */
static inline bool sphere_roots_scaled(sphere s, ray r, real *t0, real *t1);

static inline bool sphere_roots_of(sphere s, ray r, bool scaled, real *t0, real *t1)
{
    vec3 f = vsub(r.o, s.c);
    vec3 e = {sum_error(r.o.x, -s.c.x, f.x), sum_error(r.o.y, -s.c.y, f.y),
              sum_error(r.o.z, -s.c.z, f.z)};             /* o - c = f + e exactly */
    vec3 x = vadd(cross_kahan(r.d, f), vcross(r.d, e));
    real a = vdot(r.d, r.d), b = -(vdot(r.d, f) + vdot(r.d, e));
    real rr = s.r * s.r, arr = a * rr, xx = vdot(x, x);
    real least = real_min(real_min(a, rr), arr), sum = a + rr + arr + xx + fabs(b);
    if (!scaled && !(least > real_smallest / (real_epsilon * real_epsilon) && sum < real_largest))
        return sphere_roots_scaled(s, r, t0, t1);

    real D = arr - xx;                                    /* (3.5) */
    if (!(D >= 0)) return false;
    real h = sqrt(D);
    if (fabs(b) > 2 * h) {                                /* o is far: b -+ h cancels little */
        *t0 = (b - h) / a;
        *t1 = (b + h) / a;
        return true;
    }
    real q = b + copysign(h, b), k = power_of_origin(f, e, s.r);
    real far = q / a, near = q == 0 ? 0 : k / q;          /* (3.4); q = 0: o is the tangent point */
    *t0 = real_min(near, far);
    *t1 = real_max(near, far);
    return true;
}

static inline bool sphere_roots_scaled(sphere s, ray r, real *t0, real *t1)
{
    if (!(vfinite(r.o) && vfinite(r.d) && vfinite(s.c) && isfinite(s.r)) || vzero(r.d)) return false;
    int ed, el;
    r.d = vscaled(r.d, &ed);
    vec3 far = vmax(vmax(r.o, vneg(r.o)), vmax(s.c, vneg(s.c)));
    (void)frexp(real_max(fabs(s.r), vaxis(far, vlongest(far))), &el);
    for (int k = 0; k < 1; k++) {
        r.o = (vec3){ldexp(r.o.x, -el), ldexp(r.o.y, -el), ldexp(r.o.z, -el)};
        s.c = (vec3){ldexp(s.c.x, -el), ldexp(s.c.y, -el), ldexp(s.c.z, -el)};
        s.r = ldexp(s.r, -el);
    }
    if (!sphere_roots_of(s, r, true, t0, t1)) return false;
    *t0 = ldexp(*t0, el - ed);
    *t1 = ldexp(*t1, el - ed);
    return true;
}

static inline bool sphere_roots(sphere s, ray r, real *t0, real *t1)
{
    return sphere_roots_of(s, r, false, t0, t1);
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
