/* blinn_phong.h: the highlight of Blinn and Phong, made a BRDF that keeps to the energy it gets.
 *
 *   f = C (n.h)^e,   h = (wi + wo) / |wi + wo|                                           (23.13)
 *   C = (e + 2) (e + 4) / (8 pi (e + 2^(-e/2)))                                          (23.14)
 *   pdf(wi) = (e + 1) / (2 pi) (n.h)^e / (4 wo.h)                                        (23.15)
 *   f zi / pdf = 4 C (wo.h) zi 2 pi / (e + 1) <= (e+2)(e+4) / ((e + 2^(-e/2)) (e + 1))   (23.16)
 *
 * C makes the albedo 1 when wo = n; at all other angles it is less. e = 0 is Lambert's 1/pi. The
 * factor 1 / (4 wo.h) is dh/dwi: h turns half as fast as wi, in both of its angles.
 *
 * Directions are local and of unit length, e >= 0.
 *
 *   blinn_phong_power(e, h)             (n.h)^e
 *   blinn_phong_value(e, wi, wo)        f, 1/sr
 *   blinn_phong_pdf(e, wi, wo)          of wi given wo, 1/sr; includes wi below the surface
 *   blinn_phong_normal(e, u, v)         h by its part of the pdf; wi = mirrored(wo, h)
 *
 * Sources: J. Blinn, "Models of light reflection for computer synthesized pictures", SIGGRAPH 1977;
 * F. Giesen, "Derivation of the Phong and Blinn-Phong normalization factors", 2009 (C); E.
 * Lafortune, Y. Willems, "Using the modified Phong reflectance model", report CW 197, 1994.
 */
#ifndef BLINN_PHONG_H
#define BLINN_PHONG_H

#include "../20_monte_carlo/sampling.h"

/* ---------------------------------------------------------------------------------------------- */

static inline vec3 half_vector(vec3 wi, vec3 wo) { return vunit(vadd(wi, wo)); }

/* wo on the other side of m, at the same angle. */
static inline vec3 mirrored(vec3 wo, vec3 m) { return vsub(vscale(m, 2 * vdot(wo, m)), wo); }

/* From the sine: for large e the base is 1 but for its last bits (pow(h.z, e), e = 1e6 in float, is
 * off by 6 %). Once z < 1/2 it has no such trouble. */
static inline real blinn_phong_power(real e, vec3 h)
{
    if (h.z <= (real)0.5) return h.z > 0 ? pow(h.z, e) : 0;
    return exp(e / 2 * log1p(-(h.x * h.x + h.y * h.y)));
}

static inline real blinn_phong_scale(real e)
{
    return (e + 2) / (8 * pi) * ((e + 4) / (e + exp2(-e / 2)));
}

static inline real blinn_phong_value(real e, vec3 wi, vec3 wo)
{
    return blinn_phong_scale(e) * blinn_phong_power(e, half_vector(wi, wo));
}

static inline real blinn_phong_pdf(real e, vec3 wi, vec3 wo)
{
    vec3 h = half_vector(wi, wo);
    return (e + 1) / (2 * pi) * blinn_phong_power(e, h) / (4 * vdot(wo, h));
}

static inline vec3 blinn_phong_normal(real e, real u, real v) { return sample_lobe(e, u, v); }

#endif
