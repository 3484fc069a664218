/* first.h: where a ray meets a sphere (球), by the quadratic formula.
 * Wrong far away: from 3000 radii in float, 7e7 in double, b^2 - 4ac is the noise of two huge
 * numbers, and the sphere falls apart. sphere.h holds it together. */
#ifndef FIRST_SPHERE_H
#define FIRST_SPHERE_H
#include "../01_ray/first.h"

typedef struct { vec3 c; real r; } sphere;  /* centre and radius */

/* |o + t d - c|^2 - R^2 = 0                                                               (3.1)
 * is a quadratic in t, a t^2 + b t + c = 0                                                (3.2) */
static inline bool first_sphere_roots(sphere s, ray r, real *t0, real *t1)
{
    vec3 f = vsub(r.o, s.c);
    real a = vdot(r.d, r.d);
    real b = 2 * vdot(r.d, f);
    real c = vdot(f, f) - s.r * s.r;

    /* t = (-b -+ sqrt(b^2 - 4 a c)) / 2a; no real root: the ray passes beside the sphere  (3.3) */
    real disc = b * b - 4 * a * c;  /* the discriminant (判别式) */
    if (!(disc >= 0)) return false;
    *t0 = (-b - sqrt(disc)) / (2 * a);
    *t1 = (-b + sqrt(disc)) / (2 * a);
    return true;
}

/* The entry, or, for a ray that begins inside, the exit. */
static inline bool first_sphere_hit(sphere s, ray r, hit *out)
{
    real t0, t1;
    if (!first_sphere_roots(s, r, &t0, &t1)) return false;
    real t = ray_covers(r, t0) ? t0 : t1;
    if (!ray_covers(r, t)) return false;
    *out = (hit){t, 0, 0, 0};
    return true;
}

/* The normal (法线) at p points away from the centre. */
static inline vec3 first_sphere_normal(sphere s, vec3 p)
{
    return vscale(vsub(p, s.c), 1 / s.r);
}
#endif
