/* 19_optics_naive.h: Snell's law and Fresnel's as they are often written, to be compared with.
 *
 *   snell_of_naive(d, n, n1, n2, &s)  by the sines: sin t = n1/n2 sqrt(1 - ci^2)
 *   real R = schlick(&s)              R0 + (1 - R0)(1 - c)^5,  R0 = ((n1-n2)/(n1+n2))^2  (19.7)
 *                                     c: the cosine on the thinner side, n1 > n2 ? ct : ci
 *
 * Source: C. Schlick, "An Inexpensive BRDF Model for Physically-based Rendering", EG 1994.
 */
#ifndef WHITTED_OPTICS_NAIVE_H
#define WHITTED_OPTICS_NAIVE_H

#include "../chapters/19_whitted/refract.h"

/* Fails for: d = -n where n.n > 1 by rounding, as for a quarter of all normals: a NaN, where
 * first_refract has none. Both, n1 = 1, n2 = 1 + epsilon at a grazing angle: ct is off by all of
 * itself. */
static inline bool snell_of_naive(vec3 d, vec3 n, real n1, real n2, snell *out)
{
    real eta = n1 / n2, ci = -vdot(n, d), sine = eta * sqrt(1 - ci * ci);
    *out = (snell){(double)n1, (double)n2, (double)ci, 0, sine > 1};
    if (out->total) return false;
    out->ct = (double)sqrt(1 - sine * sine);
    return true;
}

static inline real schlick(const snell *s)
{
    double r = (s->n1 - s->n2) / (s->n1 + s->n2), R0 = r * r;
    double m = 1 - (s->n1 > s->n2 ? s->ct : s->ci), mm = m * m;
    return (real)(s->total ? 1 : R0 + (1 - R0) * (mm * mm * m));                        /* (19.7) */
}

#endif
