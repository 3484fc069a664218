/* brdf.h: how a surface reflects: the BRDF (双向反射分布函数).
 *
 *   f(wi, wo) = dL(wo) / dE(wi),   dE(wi) = L(wi) cos(n, wi) dwi      [1/sr]              (23.1)
 *   L(wo) = integral of f(wi, wo) L(wi) cos(n, wi) dwi    reflection equation (反射方程)  (23.2)
 *   f(wi, wo) = f(wo, wi)                                 reciprocity (互易性)            (23.3)
 *   albedo(wo) = integral of f cos(n, wi) dwi <= 1        energy (能量守恒)               (23.4)
 *
 *   brdf b = brdf_lambert(albedo);                          matte: f = albedo / pi
 *   brdf b = brdf_blinn_phong(diffuse, specular, exponent); blinn_phong.h, over a matte ground;
 *                                                           diffuse + specular <= 1
 *   brdf b = brdf_ggx(f0, roughness);                       microfacet.h, alpha = roughness^2
 *   brdf b = brdf_mirror(f0);                               the limit of roughness 0
 *   Colours in [0,1]; roughness is clamped to [0,1], exponent to [0, 1/epsilon].
 *   brdf b = brdf_of(&m);               of a material (18): its mirror, F0, in facets as wide as
 *                                       alpha, if it is not black; else kd and ks. Glass: black
 *
 *   call (world directions)                    result
 *   brdf_value(&b, n, wi, wo)                  f, 1/sr; a density, no fraction: it may exceed 1
 *   brdf_sample(&b, n, wo, u, v, &wi, &pdf, &weight)   draws wi; pdf per solid angle [1/sr];
 *                                              weight = f cos / pdf, cosine and pdf included
 *   brdf_pdf(&b, n, wi, wo)                    the pdf with which brdf_sample draws wi given wo
 *   brdf_is_delta(&b), brdf_is_black(&b)
 *
 * n, wi, wo have unit length; wi and wo point away from the surface. One that is behind it, or
 * within epsilon^2 of the horizon, gives 0. brdf_sample is then false, as it is for what is black
 * and for a facet that sends wi below the surface: nothing is reflected, no ray is to be traced,
 * and wi, pdf, weight are untouched. (Such a sample counts: its weight is 0.)
 *
 * A mirror is a delta (狄拉克函数): f and brdf_pdf are 0 for all directions that one can name, only
 * brdf_sample finds its wi, with the pdf infinity and the weight F. Ask brdf_is_delta before
 * anything is divided.
 * The same verbs end in _local for directions that are in the frame of the surface.
 */
#ifndef BRDF_H
#define BRDF_H

#include "../18_shade/material.h"
#include "blinn_phong.h"
#include "microfacet.h"
#include "shading_frame.h"

typedef enum { BRDF_BLACK, BRDF_LAMBERT, BRDF_BLINN_PHONG, BRDF_GGX, BRDF_MIRROR } brdf_kind;
typedef struct {
    brdf_kind kind;
    vec3 diffuse;    /* Lambert, Blinn-Phong: albedo of the matte ground */
    vec3 specular;   /* Blinn-Phong: albedo of the highlight at wo = n. GGX, mirror: F0 */
    real alpha;      /* GGX, >= ggx_least_alpha */
    real exponent;   /* Blinn-Phong: e */
    real scale;      /* C of (23.14) */
    real chance;     /* of sampling the highlight: its part of the albedo */
} brdf;

/* ---------------------------------------------------------------------------------------------- */

static inline brdf brdf_lambert(vec3 albedo)
{
    return (brdf){.kind = vzero(albedo) ? BRDF_BLACK : BRDF_LAMBERT, .diffuse = albedo};
}

static inline brdf brdf_mirror(vec3 f0)
{
    return (brdf){.kind = vzero(f0) ? BRDF_BLACK : BRDF_MIRROR, .specular = f0};
}

static inline brdf brdf_facets(vec3 f0, real alpha)
{
    if (!(alpha >= ggx_least_alpha)) return brdf_mirror(f0);
    return (brdf){.kind = vzero(f0) ? BRDF_BLACK : BRDF_GGX, .specular = f0, .alpha = alpha};
}

static inline brdf brdf_ggx(vec3 f0, real roughness)
{
    return brdf_facets(f0, ggx_alpha(roughness));
}

/* Without a highlight: its matte ground alone, of which none is sampled or computed in vain. */
static inline brdf brdf_blinn_phong(vec3 diffuse, vec3 specular, real exponent)
{
    real d = diffuse.x + diffuse.y + diffuse.z, s = specular.x + specular.y + specular.z;
    real e = real_clamp(exponent, 0, 1 / real_epsilon);
    if (!(s > 0)) return brdf_lambert(diffuse);
    return (brdf){.kind = BRDF_BLINN_PHONG, .diffuse = diffuse, .specular = specular,
                  .exponent = e, .scale = blinn_phong_scale(e), .chance = s / (s + d)};
}

static inline brdf brdf_of(const material *m)
{
    if (m->inside.ior > 0) return (brdf){.kind = BRDF_BLACK};
    return vzero(m->mirror) ? brdf_blinn_phong(m->kd, m->ks, m->shine)
                            : brdf_facets(m->mirror, m->alpha);
}

static inline bool brdf_is_delta(const brdf *b) { return b->kind == BRDF_MIRROR; }
static inline bool brdf_is_black(const brdf *b) { return b->kind == BRDF_BLACK; }

/* Not above the horizon, a NaN included. Nearer to it than epsilon^2 a cosine is rounding. */
static inline bool brdf_behind(vec3 w) { return !(w.z > real_epsilon * real_epsilon); }

/* ---- local directions ---- */

static inline vec3 brdf_value_local(const brdf *b, vec3 wi, vec3 wo)
{
    vec3 black = {0, 0, 0}, matte = vscale(b->diffuse, 1 / pi);
    if (brdf_behind(wi) || brdf_behind(wo)) return black;
    switch (b->kind) {
    case BRDF_LAMBERT: return matte;
    case BRDF_BLINN_PHONG: {
        real power = blinn_phong_power(b->exponent, half_vector(wi, wo));
        return vmadd(matte, b->specular, b->scale * power);                            /* (23.13) */
    }
    case BRDF_GGX: {
        vec3 m = half_vector(wi, wo);
        real shadow = wo.z * ggx_s(b->alpha, wi) + wi.z * ggx_s(b->alpha, wo);
        return vscale(fresnel_schlick(b->specular, vdot(wo, m)),
                      ggx_d(b->alpha, m) / (2 * shadow));                               /* (23.9) */
    }
    case BRDF_BLACK: case BRDF_MIRROR: break;
    }
    return black;
}

static inline real brdf_pdf_local(const brdf *b, vec3 wi, vec3 wo)
{
    if (brdf_behind(wi) || brdf_behind(wo)) return 0;
    switch (b->kind) {
    case BRDF_LAMBERT: return pdf_cosine(wi);
    case BRDF_BLINN_PHONG:
        return (1 - b->chance) * pdf_cosine(wi)
             + b->chance * blinn_phong_pdf(b->exponent, wi, wo);
    case BRDF_GGX:
        return ggx_d(b->alpha, half_vector(wi, wo)) / (2 * (wo.z + ggx_s(b->alpha, wo)));
    case BRDF_BLACK: case BRDF_MIRROR: break;
    }
    return 0;
}

/* Matte ground or highlight, by a coin that u throws; what is left of u is as random as before. The
 * weight is that of both together, so it is bounded by the larger of their own bounds. */
static inline bool brdf_sample_blinn_phong(const brdf *b, vec3 wo, real u, real v, vec3 *wi,
                                           real *pdf, vec3 *weight)
{
    real p = b->chance, e = b->exponent;
    vec3 h, w;  /* u / p is below 1, rounding included: a float below p is p (1 - epsilon / 2) */
    if (u < p) h = sample_lobe(e, u / p, v), w = mirrored(wo, h);
    else w = sample_cosine((u - p) / (1 - p), v), h = half_vector(w, wo);
    if (brdf_behind(w)) return false;
    real power = blinn_phong_power(e, h);  /* once: it is most of the work */
    vec3 f = vmadd(vscale(b->diffuse, 1 / pi), b->specular, b->scale * power);
    *wi = w, *pdf = (1 - p) * pdf_cosine(w) + p * blinn_phong_pdf_at(e, power, half_angle(w, wo));
    *weight = vscale(f, w.z / *pdf);
    return true;
}

static inline bool brdf_sample_ggx(const brdf *b, vec3 wo, real u, real v, vec3 *wi, real *pdf,
                                   vec3 *weight)
{
    vec3 m = ggx_visible(b->alpha, wo, u, v), w = mirrored(wo, m);
    if (brdf_behind(w)) return false;
    real si = ggx_s(b->alpha, w), so = ggx_s(b->alpha, wo);
    *wi = w, *pdf = ggx_d(b->alpha, m) / (2 * (wo.z + so));                            /* (23.11) */
    *weight = vscale(fresnel_schlick(b->specular, vdot(wo, m)),
                     w.z * (wo.z + so) / (wo.z * si + w.z * so));                      /* (23.12) */
    return true;
}

static inline bool brdf_sample_local(const brdf *b, vec3 wo, real u, real v, vec3 *wi, real *pdf,
                                     vec3 *weight)
{
    if (brdf_behind(wo)) return false;
    switch (b->kind) {
    case BRDF_LAMBERT: {
        vec3 w = sample_cosine(u, v);
        if (brdf_behind(w)) return false;
        *wi = w, *pdf = pdf_cosine(w), *weight = b->diffuse;
        return true;
    }
    case BRDF_BLINN_PHONG: return brdf_sample_blinn_phong(b, wo, u, v, wi, pdf, weight);
    case BRDF_GGX: return brdf_sample_ggx(b, wo, u, v, wi, pdf, weight);
    case BRDF_MIRROR:
        *wi = (vec3){-wo.x, -wo.y, wo.z}, *pdf = real_infinity;
        *weight = fresnel_schlick(b->specular, wo.z);
        return true;
    case BRDF_BLACK: break;
    }
    return false;
}

/* ---- world directions ---- */

fast_inline vec3 brdf_value(const brdf *b, vec3 n, vec3 wi, vec3 wo)
{
    shading_frame f = shading_frame_of(n);
    return brdf_value_local(b, to_local(f, wi), to_local(f, wo));
}

fast_inline real brdf_pdf(const brdf *b, vec3 n, vec3 wi, vec3 wo)
{
    shading_frame f = shading_frame_of(n);
    return brdf_pdf_local(b, to_local(f, wi), to_local(f, wo));
}

fast_inline bool brdf_sample(const brdf *b, vec3 n, vec3 wo, real u, real v, vec3 *wi, real *pdf,
                             vec3 *weight)
{
    shading_frame f = shading_frame_of(n);
    if (!brdf_sample_local(b, to_local(f, wo), u, v, wi, pdf, weight)) return false;
    *wi = to_world(f, *wi);
    return true;
}

#endif
