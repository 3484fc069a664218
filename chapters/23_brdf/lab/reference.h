/* reference.h: the reflection equation (23.2) and the albedo (23.4): the truth for the tables.
 *
 *   vec3 lo = reflection_reference(&b, n, wo, incident);     of GGX
 *   vec3 lo = reflection_grid(&r, &b, n, wo, incident, k);   k x k directions, evenly spread
 *   vec3 a = brdf_albedo(&b, cos)                            (23.4) for wo at this cosine, within
 *                                                            2e-4; the mean of 4181 samples
 */
#ifndef BRDF_REFERENCE_H
#define BRDF_REFERENCE_H

#include "../../../common/numbers/fibonacci.h"
#include "../reflection.h"

/* ---------------------------------------------------------------------------------------------- */

/* For GGX, whatever its alpha: over half vectors, spread as D is, on a lattice.
 *   D z dm = du dv,  z^2 = (1 - u) / (1 + (a^2 - 1) u),  dwi = 4 (wo.m) dm                 (23.20)
 * Shares no direction and no pdf with brdf_sample. */
static inline vec3 reflection_reference(const brdf *b, vec3 n, vec3 wo, incident_light *incident)
{
    shading_frame f = shading_frame_of(n);
    vec3 sum = {0, 0, 0}, o = to_local(f, wo);
    real a = b->alpha, whole = 0;
    for (int i = 0; i < fibonacci_large.n; i++) {
        square_point p = fibonacci_point(fibonacci_large, i);
        real q = 1 - p.u + a * a * p.u, z = sqrt((1 - p.u) / q);
        vec3 m = sample_turn(a * sqrt(p.u / q), z, p.v), wi = mirrored(o, m);
        real c = vdot(o, m);
        whole += p.area;
        if (brdf_behind(wi) || c <= 0) continue;
        vec3 fl = vmul(brdf_value_local(b, wi, o), incident(to_world(f, wi)));
        sum = vmadd(sum, fl, 4 * c * wi.z / (ggx_d(a, m) * z) * p.area);
    }
    return vscale(sum, 1 / whole);
}

/* The midpoint rule: k rings of equal solid angle, k directions in each. */
static inline vec3 reflection_grid(reflection *r, const brdf *b, vec3 n, vec3 wo,
                                   incident_light *incident, int k)
{
    shading_frame f = shading_frame_of(n);
    vec3 sum = {0, 0, 0}, local = to_local(f, wo);
    reflection uniform = {DIRECTIONS_UNIFORM, r->ask_all, 0};
    for (int i = 0; i < k * k; i++) {
        point2 p = {((real)(i / k) + (real)0.5) / (real)k, ((real)(i % k) + (real)0.5) / (real)k};
        sum = vadd(sum, reflection_term(&uniform, b, f, local, incident, p));
    }
    r->asked += uniform.asked;
    return vscale(sum, 1 / ((real)k * (real)k));
}

/* The mean weight: it is bounded, whatever the lobe.                                     (23.21) */
static inline vec3 brdf_albedo_specular(const brdf *b, vec3 wo)
{
    vec3 sum = {0, 0, 0}, wi, weight;
    real pdf, whole = 0;
    for (int i = 0; i < fibonacci_small.n; i++) {
        square_point p = fibonacci_point(fibonacci_small, i);
        whole += p.area;
        if (brdf_sample_local(b, wo, p.u, p.v, &wi, &pdf, &weight))
            sum = vmadd(sum, weight, p.area);
    }
    return vscale(sum, 1 / whole);
}

static inline vec3 brdf_albedo(const brdf *b, real cosine)
{
    real c = real_clamp(cosine, 0, 1);
    vec3 wo = {sqrt((1 - c) * (1 + c)), 0, c};
    if (brdf_behind(wo)) return (vec3){0, 0, 0};
    if (b->kind == BRDF_LAMBERT) return b->diffuse;
    if (b->kind == BRDF_MIRROR) return fresnel_schlick(b->specular, c);
    brdf gloss = *b;
    gloss.diffuse = (vec3){0, 0, 0}, gloss.chance = 1;
    return vadd(b->diffuse, brdf_albedo_specular(&gloss, wo));
}

#endif
