/* microfacet.h: a surface of many tiny mirrors (微表面), after Trowbridge and Reitz (GGX).
 *
 *   D(m) = 1 / (pi a^2 (x^2/a^2 + y^2/a^2 + z^2)^2)      density of normals m = (x,y,z)   (23.6)
 *   G1(w) = 2 z / (z + S),  S = sqrt(z^2 + a^2 (x^2 + y^2))   part of them seen from w    (23.7)
 *   G2(wi, wo) = 2 zi zo / (zo Si + zi So)               seen from both: Smith's shadowing and
 *                                                        masking, heights correlated      (23.8)
 *   f = F D G2 / (4 zi zo) = F D / (2 (zo Si + zi So))   no cosine is left to divide by   (23.9)
 *   pdf(m) = G1(wo) (wo.m) D(m) / zo                     the normals that wo sees         (23.10)
 *   pdf(wi) = pdf(m) / (4 wo.m) = D / (2 (zo + So))      mirrored, 1/sr                   (23.11)
 *   f zi / pdf(wi) = F G2 / G1(wo) = F zi (zo + So) / (zo Si + zi So) <= F                (23.12)
 *
 * All directions are local (+z is the normal, shading_frame.h) and of unit length; a = alpha > 0 is
 * the slope of a typical facet: 1 rough, 0 a mirror. F (fresnel_schlick) is how much of the light a
 * facet reflects:
 *
 *   F = F0 + (1 - F0) (1 - wo.m)^5                                                        (23.5)
 *
 * with F0 the reflectance head-on. F0 = 0 stands for no boundary at all, and F is 0 for it; the
 * formula alone would still give 1 at grazing angles.
 *
 *   call                       result                               domain
 *   ggx_alpha(roughness)       its square, in [0, 1]                any roughness
 *   ggx_d(a, m)                D, 1/sr; 0 for z <= 0                a >= ggx_least_alpha
 *   ggx_s(a, w)                S                                    the same
 *   ggx_g1, ggx_g2             0 .. 1                               z > 0
 *   ggx_visible(a, wo, u, v)   a normal m with pdf (23.10)          u, v in [0,1), zo > 0
 *
 * Below ggx_least_alpha = sqrt(epsilon) a direction's own rounding, epsilon, is more than the same
 * part sqrt(epsilon) of the lobe's width: there the lobe is a mirror for all that we can tell.
 *
 * Sources: B. Walter, S. Marschner, H. Li, K. Torrance, "Microfacet models for refraction through
 * rough surfaces", EGSR 2007; E. Heitz, "Understanding the masking-shadowing function", JCGT 3(2),
 * 2014, eq. 99 (G2), and "Sampling the GGX distribution of visible normals", JCGT 7(4), 2018
 * (23.10); J. Dupuy, A. Benyoub, "Sampling visible GGX normals with spherical caps", Computer
 * Graphics Forum 42(8), 2023 (ggx_visible); C. Schlick, "An inexpensive BRDF model for
 * physically-based rendering", Eurographics 1994.
 */
#ifndef BRDF_MICROFACET_H
#define BRDF_MICROFACET_H

#include "../20_monte_carlo/sampling.h"
#include "shading_frame.h"

#define ggx_least_alpha sqrt(real_epsilon)  /* 1.5e-8, or 3.5e-4 in float */

/* ---------------------------------------------------------------------------------------------- */

static inline real ggx_alpha(real roughness)
{
    real r = real_clamp(roughness, 0, 1);
    return r * r;
}

fast_inline vec3 fresnel_schlick(vec3 f0, real c)
{
    real q = 1 - real_clamp(c, 0, 1), q5 = q * q * q * q * q;
    if (vzero(f0)) return f0;
    return vmadd(f0, vsub((vec3){1, 1, 1}, f0), q5);
}

/* A sum of squares, where the textbook's z^2 (a^2 - 1) + 1 is a difference (ggx_d_naive). */
fast_inline real ggx_d(real a, vec3 m)
{
    real x = m.x / a, y = m.y / a, k = x * x + y * y + m.z * m.z;
    return m.z > 0 ? 1 / (pi * a * a * k * k) : 0;
}

fast_inline real ggx_s(real a, vec3 w)
{
    return sqrt(w.z * w.z + a * a * (w.x * w.x + w.y * w.y));
}

static inline real ggx_g1(real a, vec3 w) { return 2 * w.z / (w.z + ggx_s(a, w)); }

static inline real ggx_g2(real a, vec3 wi, vec3 wo)
{
    return 2 * wi.z * wo.z / (wo.z * ggx_s(a, wi) + wi.z * ggx_s(a, wo));
}

/* Stretched by 1/a the facets are a hemisphere of mirrors, and what it reflects of a beam from w is
 * uniform: c, on the part of the unit sphere above z = -w.z. m is half way, and stretched back.
 * h.z is written without the difference c.z + w.z, and 1 - c.z^2 as a product. */
static inline vec3 ggx_visible(real a, vec3 wo, real u, real v)
{
    vec3 w = unit_of((vec3){a * wo.x, a * wo.y, wo.z});
    real q = v * (1 + w.z);  /* 1 - c.z, below 2: w.z is at most 1, as z * (1 / z) is, rounded */
    vec3 c = sample_turn(sqrt(q * (2 - q)), 1 - q, u);
    return unit_of((vec3){a * (c.x + w.x), a * (c.y + w.y), (1 - v) * (1 + w.z)});
}

#endif
