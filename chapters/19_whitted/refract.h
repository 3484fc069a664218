/* refract.h: refraction (折射) by Snell's law, where it ends (total reflection, 全反射), and how much.
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
 * How much is reflected, Fresnel's share (菲涅耳方程), and how much goes through:
 *
 *   F                          p = n1 ci,  q = n2 ct,  u = n2 ci,  v = n1 ct
 *   1 |             |
 *     |             |          rs = (p - q) / (p + q),   rp = (u - v) / (u + v)         (19.5)
 *     |            .'          R = (rs^2 + rp^2) / 2     light that is not polarised
 *     |          .'            T = 2 n1 n2 ci ct (1/(p + q)^2 + 1/(u + v)^2)            (19.6)
 *   0 |-------''               R + T = 1; R = 1 in total reflection
 *     0     i      90
 *   real R = fresnel(&s)
 *
 * (p - q) and (u - v) cancel if n1 is nearly n2. With (19.3), p^2 - q^2 = (n1-n2)(n1+n2), and
 *   rs = (n1-n2)(n1+n2) / (p+q)^2,
 *   rp = (n2-n1)(n2+n1) ((n1^2+n2^2) ci^2 - n1^2) / (n2^2 (u+v)^2)                       (19.8)
 * The bracket is 0 at Brewster's angle, tan i = n2/n1: there one polarisation has no R.
 *
 * Sources: A. Glassner (ed.), "An Introduction to Ray Tracing", 1989, ch. 4, 5; T. Akenine-Möller
 * et al., "Real-Time Rendering", 4th ed., 2018, section 14.5.2; M. Born, E. Wolf, "Principles of
 * Optics", 7th ed., 1999, section 1.5.2 (Fresnel).
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

/* One division for both: with a = (p + q)^2, b = n2^2 (u + v)^2, rs = x / a and rp = x y / b,
 * R = ((x b)^2 + (x y a)^2) / (2 (a b)^2). */
static inline real fresnel(const snell *s)
{
    double n1 = s->n1, n2 = s->n2, ci = s->ci, ct = s->ct;
    if (s->total) return 1;
    if (n1 == n2) return 0;  /* also at ci = 0, where (19.8) is 0 / 0 */
    double x = (n1 - n2) * (n1 + n2), y = (n1 * n1 + n2 * n2) * (ci * ci) - n1 * n1;
    double pq = n1 * ci + n2 * ct, uv = n2 * (n2 * ci + n1 * ct), a = pq * pq, b = uv * uv;
    double k = x / (a * b), ks = k * b, kp = k * y * a;                                 /* (19.8) */
    double R = (ks * ks + kp * kp) / 2;
    return (real)(R < 1 ? R : 1);  /* at a grazing angle rounding may bring it past 1 */
}

#endif
