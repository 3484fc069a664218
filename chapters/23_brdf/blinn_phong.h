/* blinn_phong.h: the highlight of Blinn and Phong, made a BRDF that keeps to the energy it gets.
 *
 *   f = C (n.h)^e,   h = (wi + wo) / |wi + wo|                                           (23.13)
 *   C = (e + 2) (e + 4) / (8 pi (e + 2^(-e/2)))                                          (23.14)
 *   pdf(wi) = (e + 1) / (2 pi) (n.h)^e / (4 wo.h)                                        (23.15)
 *   f zi / pdf = 4 C (wo.h) zi 2 pi / (e + 1) <= (e+2)(e+4) / ((e + 2^(-e/2)) (e + 1))   (23.16)
 *
 * C makes the albedo 1 when wo = n; at all other angles it is less, but for e = 0, which is
 * Lambert's 1/pi. The factor 1 / (4 wo.h) is dh/dwi: while wi turns by an angle, h turns by half of
 * it in the plane of wi and wo, and by 1 / (2 wo.h) of it across.
 *
 * Directions are local and of unit length, e >= 0.
 *
 *   blinn_phong_scale(e)                C, 1/sr
 *   blinn_phong_power(e, h)             (n.h)^e
 *   blinn_phong_pdf(e, wi, wo)          of wi given wo, 1/sr; includes wi below the surface
 *   blinn_phong_pdf_at(e, power, c)     the same where (n.h)^e = power, wo.h = c are known
 *   sample_lobe(e, u, v)                h by its part of the pdf (20); wi = mirrored(wo, h)
 *
 * Sources: J. Blinn, "Models of light reflection for computer synthesized pictures", SIGGRAPH 1977;
 * F. Giesen, "Derivation of the Phong and Blinn-Phong normalization factors", 2009 (C); E.
 * Lafortune, Y. Willems, "Using the modified Phong reflectance model", report CW 197, 1994.
 */
#ifndef BRDF_BLINN_PHONG_H
#define BRDF_BLINN_PHONG_H

#include "../20_monte_carlo/sampling.h"
#include "shading_frame.h"

/* ---------------------------------------------------------------------------------------------- */

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

static inline real blinn_phong_pdf_at(real e, real power, real c)
{
    return (e + 1) / (8 * pi) * power / c;
}

static inline real blinn_phong_pdf(real e, vec3 wi, vec3 wo)
{
    return blinn_phong_pdf_at(e, blinn_phong_power(e, half_vector(wi, wo)), half_angle(wi, wo));
}

#endif
