/* reflection.h: the reflection equation (反射方程) at one point, three ways.
 *
 *   L(wo) = integral over the hemisphere of f(wi, wo) L(wi) cos(n, wi) dwi                  (23.2)
 *         ~ 1/N sum of f(wi, wo) L(wi) cos(n, wi) / pdf(wi),   wi drawn with this pdf      (23.19)
 *
 *   reflection r = {DIRECTIONS_BRDF, false, 0};
 *   vec3 lo = reflection_estimate(&r, &b, n, wo, incident, kind, seed, pixel, N);   kind: sampler.h
 *
 *   choice                pdf
 *   DIRECTIONS_UNIFORM    1 / (2 pi)       all directions alike
 *   DIRECTIONS_COSINE     cos / pi         those that bring more, more often
 *   DIRECTIONS_BRDF       brdf_pdf         those that the surface asks for
 *
 * incident(wi): radiance that arrives from the unit direction wi (world). It is asked only where
 * f cos > 0; r.asked counts how often. With r.ask_all it is asked always, and the answer is the
 * same.
 */
#ifndef BRDF_REFLECTION_H
#define BRDF_REFLECTION_H

#include "../20_monte_carlo/sampler.h"
#include "brdf.h"
#include <stddef.h>

typedef vec3 incident_light(vec3 wi);
typedef enum { DIRECTIONS_UNIFORM, DIRECTIONS_COSINE, DIRECTIONS_BRDF } direction_choice;
typedef struct { direction_choice choice; bool ask_all; size_t asked; } reflection;

/* ---------------------------------------------------------------------------------------------- */

/* One direction and its f cos / pdf; false if that is 0. A mirror's is found by DIRECTIONS_BRDF
 * alone. */
static inline bool reflection_direction(direction_choice how, const brdf *b, shading_frame f,
                                        vec3 wo, point2 p, vec3 *wi, vec3 *weight)
{
    vec3 w = {0, 0, 1};
    real pdf;
    *weight = (vec3){0, 0, 0};
    if (how == DIRECTIONS_BRDF) {
        bool some = brdf_sample_local(b, wo, p.u, p.v, &w, &pdf, weight);
        *wi = to_world(f, w);
        return some;
    }
    bool cosine = how == DIRECTIONS_COSINE;
    w = cosine ? sample_cosine(p.u, p.v) : sample_hemisphere(p.u, p.v);
    pdf = cosine ? pdf_cosine(w) : pdf_hemisphere(w);
    *wi = to_world(f, w);
    *weight = vscale(brdf_value_local(b, w, wo), w.z / pdf);
    return !vzero(*weight);
}

static inline vec3 reflection_term(reflection *r, const brdf *b, shading_frame f, vec3 wo,
                                   incident_light *incident, point2 p)
{
    vec3 wi, weight;
    bool some = reflection_direction(r->choice, b, f, wo, p, &wi, &weight);
    if (!some && !r->ask_all) return (vec3){0, 0, 0};
    r->asked++;
    return vmul(weight, incident(wi));
}

static inline vec3 reflection_estimate(reflection *r, const brdf *b, vec3 n, vec3 wo,
                                       incident_light *incident, sequence_kind kind, uint64_t seed,
                                       uint64_t pixel, uint32_t samples)
{
    shading_frame f = shading_frame_of(n);
    vec3 sum = {0, 0, 0}, local = to_local(f, wo);
    for (uint32_t k = 0; k < samples; k++) {
        sampler s = sampler_start(kind, seed, pixel, k, samples);
        sum = vadd(sum, reflection_term(r, b, f, local, incident, sampler_pair(&s)));
    }
    return vscale(sum, 1 / (real)samples);
}

#endif
