/* fresnel.h: how much of the light a smooth surface of glass or water reflects (菲涅耳方程).
 *
 *   F                          p = n1 ci,  q = n2 ct,  u = n2 ci,  v = n1 ct
 *   1 |             |
 *     |             |          rs = (p - q) / (p + q),   rp = (u - v) / (u + v)         (19.5)
 *     |            .'          R = (rs^2 + rp^2) / 2     light that is not polarised
 *     |          .'            T = 2 n1 n2 ci ct (1/(p + q)^2 + 1/(u + v)^2)            (19.6)
 *   0 |-------''               R + T = 1; R = 1 in total reflection
 *     0     i      90
 *   real R = fresnel(&s)              exact, for the cosines of refract.h
 *
 * (p - q) and (u - v) cancel if n1 is nearly n2. With (19.3), p^2 - q^2 = (n1-n2)(n1+n2), and
 *   rs = (n1-n2)(n1+n2) / (p+q)^2,
 *   rp = (n2-n1)(n2+n1) ((n1^2+n2^2) ci^2 - n1^2) / (n2^2 (u+v)^2)                       (19.8)
 * The bracket is 0 at Brewster's angle, tan i = n2/n1: there one polarisation has no R.
 *
 * Sources: M. Born, E. Wolf, "Principles of Optics", 7th ed., 1999, section 1.5.2.
 */
#ifndef WHITTED_FRESNEL_H
#define WHITTED_FRESNEL_H

#include "refract.h"

/* ---------------------------------------------------------------------------------------------- */

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
