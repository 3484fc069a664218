/* refract.h: refraction (折射) by Snell's law, and where it ends: total reflection (全反射).
 *
 *        d   n                n1 sin i = n2 sin t                             (19.2)
 *         \ i|                ct^2 = ((n2 - n1)(n2 + n1) + n1^2 ci^2) / n2^2  (19.3)
 *   n1     v |                w = (n1/n2) d + (n1 - n2)(n1 + n2) / (n2 m) n,
 *     -------p-------             m = n1 ci + n2 ct                           (19.4)
 *   n2       |\
 *            |t\              ci = -n.d, ct: the cosines of i and t
 *            |  w             ct^2 < 0: total reflection, sin i > n2 / n1
 *
 *   snell s;
 *   if (snell_of(d, n, n1, n2, &s))           false: total reflection (then s.total)
 *       w = snell_refract(&s, d, n);          unit
 *   first_refract(d, n, n1, n2, &w)           first.h: ct^2 = 1 - (n1/n2)^2 (1 - ci^2)
 *
 * d and n are unit within some epsilon, n.d <= 0; n1, n2 > 0: refractive indices (折射率) of the side
 * that d comes from, and of the other.
 *
 *   input                         textbooks                        here
 *   ci > 1 by rounding            by the sines: a NaN              a sum of positive numbers
 *   n1 nearly n2, grazing         1 - (nearly 1): noise            n2 - n1 is exact (Sterbenz)
 *   near the critical angle       decided by rounding, in float    in double, d and n taken as the
 *                                 even 1e-7 away from it           directions that they are
 *   w                             off by what d and n are          length 1 + x becomes 1 - 3/2 x^2
 *
 * (19.4): n1/n2 ci - ct cancels if n1 is nearly n2; times m / m it does not, with (19.3).
 *
 * Sources: A. Glassner (ed.), "An Introduction to Ray Tracing", 1989, ch. 4, 5; T. Akenine-Möller
 * et al., "Real-Time Rendering", 4th ed., 2018, section 14.5.2.
 */
#ifndef WHITTED_REFRACT_H
#define WHITTED_REFRACT_H

#include "reflect.h"

typedef struct {
    double n1, n2;  /* refractive indices, here and beyond */
    double ci, ct;  /* cosines with the normal, here and beyond; ct = 0 if total */
    bool total;
} snell;

/* ---------------------------------------------------------------------------------------------- */

static inline double snell_dot(vec3 a, vec3 b)
{
    return (double)a.x * (double)b.x + (double)a.y * (double)b.y + (double)a.z * (double)b.z;
}

/* ci of the directions of d and n, whatever their lengths: n.d / (|n| |d|), |n|^2 |d|^2 = 1 + y, y
 * a few epsilon: 1/sqrt(1 + y) = 1 - y/2 + 3/8 y^2 within y^3. In double, whatever real is. n.d > 0
 * by rounding is a ray along the surface: ci = 0. */
static inline bool snell_of(vec3 d, vec3 n, real n1, real n2, snell *out)
{
    double a = (double)n1, b = (double)n2, y = snell_dot(d, d) * snell_dot(n, n) - 1;
    double c = -snell_dot(n, d) * (1 - y * (0.5 - 0.375 * y)), ci = c < 0 ? 0 : c;
    double k = (b - a) * (b + a) + a * a * (ci * ci);
    *out = (snell){a, b, ci, 0, !(k >= 0)};  /* a NaN: total */
    if (out->total) return false;
    out->ct = sqrt(k) / b;                                                              /* (19.3) */
    return true;
}

static inline vec3 snell_refract(const snell *s, vec3 d, vec3 n)
{
    double m = s->n1 * s->ci + s->n2 * s->ct, eta = s->n1 / s->n2;
    double along = (s->n1 - s->n2) * (s->n1 + s->n2) / (s->n2 * m);                     /* (19.4) */
    if (s->n1 == s->n2) along = 0;  /* also at ci = 0, where it is 0 / 0 */
    return unit_again(vmadd(vscale(d, (real)eta), n, (real)along));
}

#endif
