/* brdf_naive.h: formulas that look right, and the input on which each of them fails.
 *
 *   call                              fails on                                  right one
 *   phong_naive(e, wi, wo)            e = 1: reflects 2.09 times what it gets   brdf_blinn_phong
 *   blinn_phong_pdf_naive(e, wi, wo)  all of it: no 1 / (4 wo.h)                blinn_phong_pdf
 *   ggx_value_naive(a, wi, wo)        grazing: infinite energy; no Smith term   brdf_value
 *   ggx_d_naive(a, m)                 a^2 < epsilon, m = n: infinity            ggx_d
 *   first_brdf_value (first.h)        large e: rounding of n.h, e-fold          blinn_phong_power
 *
 * Directions are local, as in microfacet.h. F is 1.
 */
#ifndef BRDF_NAIVE_H
#define BRDF_NAIVE_H

#include "../brdf.h"

/* ---------------------------------------------------------------------------------------------- */

/* Phong's highlight used as a BRDF, with the specular colour 1. Head-on its albedo is
 *   integral of cos^e cos dw = 2 pi / (e + 2)                                              (23.17)
 * which is above 1 for e < 4.28, and next to nothing for sharp highlights: .06 for e = 100. */
static inline real phong_naive(real e, vec3 wi, vec3 wo)
{
    real c = -wi.x * wo.x - wi.y * wo.y + wi.z * wo.z;  /* wi mirrored at n, dot wo */
    return c > 0 && wi.z > 0 && wo.z > 0 ? pow(c, e) : 0;
}

/* The pdf of h, taken for that of wi. */
static inline real blinn_phong_pdf_naive(real e, vec3 wi, vec3 wo)
{
    return pdf_lobe(e, half_vector(wi, wo));
}

/* D / (4 zi zo): the facets neither hide nor shade each other. */
static inline real ggx_value_naive(real a, vec3 wi, vec3 wo)
{
    if (brdf_behind(wi) || brdf_behind(wo)) return 0;
    return ggx_d(a, half_vector(wi, wo)) / (4 * wi.z * wo.z);
}

/* As it is mostly written. With a^2 < epsilon / 2 the bracket is 0 at m = n. */
static inline real ggx_d_naive(real a, vec3 m)
{
    real k = m.z * m.z * (a * a - 1) + 1;
    return m.z > 0 ? a * a / (pi * k * k) : 0;
}

static inline float ggx_d_naive_f32(float a, float z)
{
    float k = z * z * (a * a - 1) + 1;
    return a * a / (3.14159265f * k * k);
}

#endif
