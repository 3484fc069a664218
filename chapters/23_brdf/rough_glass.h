/* rough_glass.h: glass whose surface is made of facets: what is seen through it is blurred.
 *
 *    wo \  | / wr      each facet of microfacet.h is smooth glass: it reflects the share F of what
 *  n1    \ |/          meets it, by Fresnel (19.8) at its own angle, and refracts the rest:
 *   ~^~v~^~v~^~v~      m: its normal, on the side of wo
 *  n2       \ wt       wt: on the other side, wt.z < 0
 *
 *   reflected   f = F D G2 / (4 zi zo)                  as (23.9)
 *   refracted   m = -+ (n1 wo + n2 wi), unit            half vector of the refraction   (23.22)
 *               J = n2^2 |wi.m| / (n1 wo.m + n2 wi.m)^2                                 (23.23)
 *               f = (n1/n2)^2 (1 - F) D G1(wo) G1(wi) (wo.m) J / (zo |zi|)              (23.24)
 *   pdf(wi) = F pdf(m) / (4 wo.m)  or  (1 - F) pdf(m) J,  pdf(m) by (23.10)             (23.25)
 *   f |zi| / pdf = G2 / G1(wo)     or  (n1/n2)^2 G1(wi)                                 (23.26)
 *
 * J = dm / dwi: how the solid angle of the normals goes with that of the directions.
 * (n1/n2)^2: radiance is squeezed into a smaller solid angle in glass (26.10); so reciprocity reads
 * f(wi, wo) / n1^2 = f(wo, wi) / n2^2 with sides swapped, and energy: reflected + (n2/n1)^2
 * refracted is at most 1. What a facet hides is lost, more of it the rougher the surface.
 *
 *   rough_glass g = {alpha, n1, n2};      n1: refractive index where wo is; alpha > 0 [23.6]
 *   real f = rough_glass_value(&g, wi, wo)         1/sr; wi.z > 0: reflected, < 0: refracted
 *   real p = rough_glass_pdf(&g, wi, wo)           1/sr, over the whole sphere
 *   bool some = rough_glass_sample(&g, wo, u, v, coin, &wi, &weight)     u, v, coin in [0,1)
 *        weight: (23.26), cosine and pdf are in it; false: the facet sends it to the wrong side, or
 *        wo does not see the surface: its weight is 0
 *
 * Directions are local, unit, away from the surface; wo.z > 0. alpha below ggx_least_alpha: that;
 * n1 = n2: no boundary, wi = -wo, and no density can name it: f = pdf = 0.
 *
 * Source: Walter et al., 2007, equations 13 to 21, 38 to 41; Heitz, 2014 (G2): microfacet.h.
 */
#ifndef BRDF_ROUGH_GLASS_H
#define BRDF_ROUGH_GLASS_H

#include "../19_whitted/refract.h"
#include "microfacet.h"

typedef struct { real alpha, n1, n2; } rough_glass;

/* ---------------------------------------------------------------------------------------------- */

/* What a facet m reflects of wo: F, and how the rest of it goes on. */
static inline real rough_glass_fresnel(const rough_glass *g, vec3 wo, vec3 m, snell *s)
{
    snell_of(vneg(wo), m, g->n1, g->n2, s);
    return fresnel(s);
}

static inline real rough_glass_alpha(const rough_glass *g)
{
    return real_max(g->alpha, ggx_least_alpha);
}

/* The facet that brings wi to wo, on the side of wo, and J; false: none does. Of those that refract
 * wo.m > 0 and wi.m < 0: light does not go through a facet's back. */
static inline bool rough_glass_facet(const rough_glass *g, vec3 wi, vec3 wo, vec3 *m, real *J)
{
    if (wi.z > 0) {
        *m = half_vector(wi, wo);
        real c = vdot(wo, *m);
        *J = 1 / (4 * c);
        return c > 0;
    }
    vec3 sum = vmadd(vscale(wo, g->n1), wi, g->n2);
    if (g->n1 == g->n2 || vzero(sum)) return false;
    *m = unit_of(sum);
    if (m->z < 0) *m = vneg(*m);
    real co = vdot(wo, *m), ci = vdot(wi, *m), k = g->n1 * co + g->n2 * ci;
    *J = g->n2 * g->n2 * -ci / (k * k);                                               /* (23.23) */
    return co > 0 && ci < 0 && m->z > 0;
}

static inline real rough_glass_value(const rough_glass *g, vec3 wi, vec3 wo)
{
    real a = rough_glass_alpha(g), J;
    vec3 m, up = {wi.x, wi.y, fabs(wi.z)};
    snell s;
    if (!(wo.z > 0) || wi.z == 0 || !rough_glass_facet(g, wi, wo, &m, &J)) return 0;
    real F = rough_glass_fresnel(g, wo, m, &s), D = ggx_d(a, m);
    if (wi.z > 0) return F * D * ggx_g2(a, wi, wo) / (4 * wi.z * wo.z);
    real squeeze = g->n1 / g->n2 * (g->n1 / g->n2);
    return squeeze * (1 - F) * D * ggx_g1(a, wo) * ggx_g1(a, up) * vdot(wo, m) * J
         / (wo.z * up.z);                                                             /* (23.24) */
}

static inline real rough_glass_pdf(const rough_glass *g, vec3 wi, vec3 wo)
{
    real a = rough_glass_alpha(g), J;
    vec3 m;
    snell s;
    if (!(wo.z > 0) || wi.z == 0 || !rough_glass_facet(g, wi, wo, &m, &J)) return 0;
    real F = rough_glass_fresnel(g, wo, m, &s);
    real facets = ggx_g1(a, wo) * vdot(wo, m) * ggx_d(a, m) / wo.z;                    /* (23.10) */
    return (wi.z > 0 ? F : 1 - F) * facets * J;
}

/* F cancels: it is the chance of the one, 1 - F that of the other. */
static inline bool rough_glass_sample(const rough_glass *g, vec3 wo, real u, real v, real coin,
                                      vec3 *wi, real *weight)
{
    real a = rough_glass_alpha(g), eta = g->n1 / g->n2;
    if (!(wo.z > 0)) return false;
    if (g->n1 == g->n2) return *wi = vneg(wo), *weight = 1, true;
    vec3 m = ggx_visible(a, wo, u, v), w;
    snell s;
    if (coin < rough_glass_fresnel(g, wo, m, &s)) {
        w = mirrored(wo, m);
        if (!(w.z > 0)) return false;
        return *wi = w, *weight = ggx_g2(a, w, wo) / ggx_g1(a, wo), true;
    }
    w = snell_refract(&s, vneg(wo), m);
    if (!(w.z < 0)) return false;
    return *wi = w, *weight = eta * eta * ggx_g1(a, (vec3){w.x, w.y, -w.z}), true;    /* (23.26) */
}

#endif
