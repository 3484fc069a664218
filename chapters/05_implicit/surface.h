/* surface.h: an implicit surface (隐式曲面): a function, what is known about it, and where it counts.
 *
 *   implicit_surface s = {.f = f, .gradient = g, .range = r, .lipschitz = L, .ball = b, .data = x};
 *
 *   f          f(data, p): negative on one side of the surface, 0 on it, positive on the other
 *   gradient   grad f at p                          NULL: by differences, 6 calls of f
 *   range      f and f' over a piece of a ray, in jets: for search.h, which misses nothing
 *              NULL: nothing can be proven
 *   lipschitz  |f(p) - f(q)| <= L |p - q| for all p, q of the ball (Lipschitz bound, 利普希茨界):
 *              for tracing.h; 0: none is known
 *   ball       only what is in it counts: it bounds the surface, or cuts it; .r = infinity: no ball
 *
 *   implicit_value(&s, p)      f                    implicit_gradient(&s, p)     grad f
 *   implicit_normal(&s, p)     unit length, outwards where f is negative inside; 0 where the
 *                              gradient is 0, infinite or NaN, as at the tip of a cone
 *   implicit_clip(&s, &r)      narrows the interval of r to the ball; false: nothing is left
 *
 *   input                      answer
 *   d = 0, a NaN in the ray    nothing is left: a miss
 *   no ball                    what lies beyond 1e30 does not count: f may overflow there
 *
 * Sources: J. Hart, "Sphere tracing: a geometric method for the antialiased ray tracing of implicit
 * surfaces", The Visual Computer 12, 1996 (the bound); central differences: any text on numerics.
 */
#ifndef IMPLICIT_SURFACE_H
#define IMPLICIT_SURFACE_H

#include "../03_sphere/sphere.h"
#include "jet.h"

typedef struct {
    real (*f)(const void *data, vec3 p);
    vec3 (*gradient)(const void *data, vec3 p);
    jet (*range)(const void *data, jet x, jet y, jet z);
    real lipschitz;
    sphere ball;
    const void *data;
} implicit_surface;

/* ---------------------------------------------------------------------------------------------- */

static inline real implicit_value(const implicit_surface *s, vec3 p) { return s->f(s->data, p); }

/* The error of a difference over h grows with h^2, that of rounding f with 1 / h, so the best h is
 * the third root of epsilon, of the size of what is moved. */
static inline vec3 implicit_differences(const implicit_surface *s, vec3 p)
{
    real h = cbrt(real_epsilon) * real_max(vlargest(p), 1);
    vec3 g = {0, 0, 0};
    for (int k = 0; k < 3; k++) {
        vec3 on = vwith(p, k, vaxis(p, k) + h), before = vwith(p, k, vaxis(p, k) - h);
        real apart = vaxis(on, k) - vaxis(before, k);  /* 2 h, as it came out */
        g = vwith(g, k, (implicit_value(s, on) - implicit_value(s, before)) / apart);
    }
    return g;
}

static inline vec3 implicit_gradient(const implicit_surface *s, vec3 p)
{
    return s->gradient ? s->gradient(s->data, p) : implicit_differences(s, p);
}

static inline vec3 implicit_normal(const implicit_surface *s, vec3 p)
{
    return vunit(implicit_gradient(s, p));
}

/* f and f' for all t of T. */
static inline jet implicit_range(const implicit_surface *s, ray r, interval T)
{
    return s->range(s->data, jet_on_ray(r.o.x, r.d.x, T), jet_on_ray(r.o.y, r.d.y, T),
                    jet_on_ray(r.o.z, r.d.z, T));
}

static inline bool implicit_clip(const implicit_surface *s, ray *r)
{
    const sphere all = {{0, 0, 0}, (real)1e30};
    real t0, t1;
    if (!sphere_roots(s->ball.r == real_infinity ? all : s->ball, *r, &t0, &t1)) return false;
    t0 = real_max(t0, -real_largest), t1 = real_min(t1, real_largest);  /* d may be tiny */
    if (t0 > r->tmin) r->tmin = t0;
    if (t1 < r->tmax) r->tmax = t1;
    return r->tmin <= r->tmax;
}

#endif
