/* dielectric.h: what a smooth boundary of glass or water does with light. dielectric (电介质)
 *
 *       wo   n   wr         eta = index where light comes from / index behind the boundary
 *         \  |  /           cos^2 t = (1 - eta)(1 + eta) + eta^2 c^2, c = n.wo              (26.1)
 *    ______\ | /_____       refraction (折射): wt = (eta c - cos t) n - eta wo              (26.2)
 *             \             rs = -(1 - eta)(1 + eta) / (eta c + cos t)^2                    (26.3)
 *              \ wt         rp = (1 - eta)(1 + eta)((1 + eta^2) c^2 - eta^2) / (c + eta cos t)^2
 *                           F = (rs^2 + rp^2) / 2, or 1 if cos^2 t <= 0                     (26.4)
 *
 * F is what Fresnel's equations (菲涅耳方程) send back of unpolarised light; the rest goes through.
 * Where cos^2 t <= 0 all is reflected: total internal reflection (全内反射). In the textbook's form,
 * (eta c - cos t) / (eta c + cos t), rs loses all its digits as eta nears 1.
 *
 *   real F = dielectric_fresnel(eta, c, &cos_t)      c in [0,1]; cos_t: 0 if F = 1 by totality
 *   vec3 wi = dielectric_scatter(n, wo, eta, u, &through)
 *       one of the two directions: through with probability 1 - F, by u in [0,1). Weight: 1, since
 *       F / F = 1; but what crosses is squeezed into a smaller solid angle, and radiance (not
 *       power) is multiplied by dielectric_squeeze(eta) = eta^2, there and back again by 1 / eta^2
 *   vec3 a = dielectric_absorb(sigma, t)             exp(-sigma t), Beer's law (比尔定律)   (26.5)
 *
 * n, wo: unit, n.wo >= 0; wi: unit. Source: E. Hecht, Optics, 4th ed., 2002, section 4.6.
 */
#ifndef DIELECTRIC_H
#define DIELECTRIC_H

#include "../../common/vec3.h"

/* ---------------------------------------------------------------------------------------------- */

static inline real dielectric_fresnel(real eta, real c, real *cos_t)
{
    real k = (1 - eta) * (1 + eta), square = k + eta * eta * c * c;                       /* (26.1) */
    *cos_t = square > 0 ? sqrt(square) : 0;
    if (!(square > 0)) return 1;
    real s = eta * c + *cos_t, p = c + eta * *cos_t;
    real rs = k / (s * s), rp = k * ((1 + eta * eta) * c * c - eta * eta) / (p * p);       /* (26.3) */
    return (rs * rs + rp * rp) / 2;
}

static inline vec3 dielectric_scatter(vec3 n, vec3 wo, real eta, real u, bool *through)
{
    real c = real_clamp(vdot(n, wo), 0, 1), cos_t;
    *through = u >= dielectric_fresnel(eta, c, &cos_t);
    if (!*through) return vunit(vsub(vscale(n, 2 * c), wo));
    return vunit(vsub(vscale(n, eta * c - cos_t), vscale(wo, eta)));                       /* (26.2) */
}

static inline real dielectric_squeeze(real eta) { return eta * eta; }

static inline vec3 dielectric_absorb(vec3 sigma, real t)
{
    return (vec3){exp(-sigma.x * t), exp(-sigma.y * t), exp(-sigma.z * t)};
}

#endif
