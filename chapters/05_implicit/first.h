/* first.h: where a ray meets f(p) = 0, an implicit surface (隐式表面): fixed steps, then halving.
 * Wrong where f touches 0 between two steps, or crosses it twice: thin parts, rims, tangent rays.
 * search.h proves where there is no root; tracing.h takes steps that cannot pass one. */
#ifndef FIRST_IMPLICIT_H
#define FIRST_IMPLICIT_H
#include "../01_ray/first.h"

/* The surface is where f is 0; on one side f is negative, on the other positive. */
typedef real first_implicit(vec3 p);

/* f(o + t d) = 0                                                                          (5.1)
 * Walk along the ray in n equal steps, until the sign of f changes; then halve the step that it
 * changed in, always keeping the half with the change, until no number lies between its ends.
 *     t_k = tmin + k (tmax - tmin) / n                                                    (5.2)
 * tmax is finite. */
static inline bool first_implicit_hit(first_implicit *f, ray r, int n, hit *out)
{
    real a = r.tmin;
    bool inside = f(ray_at(r, a)) < 0;
    for (int k = 1; k <= n; k++) {
        real b = r.tmin + k * (r.tmax - r.tmin) / n;
        if ((f(ray_at(r, b)) < 0) == inside) { a = b; continue; }
        for (real m = (a + b) / 2; m > a && m < b; m = (a + b) / 2)  /* bisection (二分法) */
            if ((f(ray_at(r, m)) < 0) == inside) a = m;
            else b = m;
        *out = (hit){b, 0, 0, 0};
        return true;
    }
    return false;
}

/* n = grad f / |grad f|, and each component of the gradient (梯度) is nearly the difference of f a
 * little further on and a little before, over the distance 2 h between them.              (5.3) */
static inline vec3 first_implicit_normal(first_implicit *f, vec3 p, real h)
{
    vec3 x = vec(h, 0, 0), y = vec(0, h, 0), z = vec(0, 0, h);
    return vunit(vec(f(vadd(p, x)) - f(vsub(p, x)), f(vadd(p, y)) - f(vsub(p, y)),
                     f(vadd(p, z)) - f(vsub(p, z))));
}
#endif
