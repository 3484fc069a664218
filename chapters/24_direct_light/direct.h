/* direct.h: the light that reaches a point straight from the lights (直接光照), and leaves to wo.
 *
 *   L(wo) = integral over the hemisphere of f(wi, wo) Le(first hit along wi) cos(n, wi) dwi (24.1)
 *
 *   by directions:  f cos Le / pdf(wi), one ray along wi; most of them miss a small light   (24.2)
 *   by lights:      x on a light, f cos Le V / pdf(x), one shadow ray; V is 1 if p sees x   (24.4)
 *   by both:        each of the two times its weight, see mis.h; two rays                   (24.7)
 *
 *   direct d = {.s = &scene, .way = DIRECT_POWER, .lights = &l, .work = &w};
 *   lit_lights l; lit_lights_of(&scene, NULL, LIGHTS_ALL, &l); .. lit_lights_free(&l);
 *   vec3 L = direct_light(&d, &h, wo, &sampler);     h from lit_trace, wo unit, away from h.s
 *
 *   way               draws wi by                  does well                  does badly
 *   DIRECT_UNIFORM    1 / (2 pi)                   light all around           all else
 *   DIRECT_COSINE     cos / pi                     matte, light all around    small lights
 *   DIRECT_BRDF       brdf_pdf                     glossy, large lights       small lights
 *   DIRECT_AREA       a point of the light, 24.4   small, far lights          lights that touch
 *   DIRECT_ANGLE      its solid angle, 24.5        lights near and far        glossy, large lights
 *   DIRECT_BALANCE    both BRDF and ANGLE, 24.8    all of it
 *   DIRECT_POWER      both BRDF and ANGLE, 24.9    all of it
 *   DIRECT_HALF       both, each counts half: naive. The worse one's noise stays
 *
 * Which lights (lights.h): LIGHTS_ALL, a point on each; or one of them with the probability P(k),
 * and what it brings divided by P(k): LIGHTS_UNIFORM, LIGHTS_FLUX.                          (24.10)
 *
 * Called for: no shadow ray where n.wi <= 0, where f is 0 (black, mirror), to a light's back; no
 * ray at all without emitters, no light drawn for a mirror. w.shadow, w.direction count the rays.
 * d.spend_all traces them all the same: the result has the same bits. The random numbers of a
 * sample are, from where s stands, pair 0: direction; then, if one of several lights is chosen,
 * 1: which, 2: its point; if all, 1 ...: a point of each. What nobody asks for is not computed.
 *
 * A mirror has f = 0 but for one direction: only BRDF, and both with it, find that.
 * A background of the scene is seen by directions only.
 */
#ifndef DIRECT_H
#define DIRECT_H

#include "../23_brdf/reflection.h"
#include "lights.h"
#include "mis.h"

typedef enum { DIRECT_UNIFORM, DIRECT_COSINE, DIRECT_BRDF, DIRECT_AREA, DIRECT_ANGLE,
               DIRECT_BALANCE, DIRECT_POWER, DIRECT_HALF, direct_ways } direct_way;
static const char *const direct_name[direct_ways] = {
    "uniform directions", "cosine", "BRDF", "light by area", "light by angle", "balance heuristic",
    "power heuristic", "half and half"};

typedef struct { size_t samples, direction, shadow; } direct_work;

typedef struct {
    const lit_scene *s;
    direct_way way;
    const lit_lights *lights;
    direct_work *work;     /* a thread's own */
    bool spend_all;
} direct;

/* ---------------------------------------------------------------------------------------------- */

/* What all samples at a point share. wo is local. */
typedef struct { const lit_hit *h; shading_frame frame; vec3 wo; } direct_point;

static inline bool direct_both(direct_way w) { return w >= DIRECT_BALANCE; }

/* The weight of the way whose pdf is `own` (24.8), (24.9). */
static inline real direct_weight(direct_way way, real own, real other)
{
    switch (way) {
    case DIRECT_BALANCE: return mis_balance(own, other);
    case DIRECT_POWER: return mis_power(own, other);
    case DIRECT_HALF: return 0.5;
    default: return 1;
    }
}

/* (24.4): light k, drawn with the probability `chance`. */
static inline vec3 direct_from(const direct *d, const direct_point *x, size_t k, real chance,
                               point2 u)
{
    const vec3 none = {0, 0, 0};
    const brdf *b = x->h->f;
    lit_points points = d->way == DIRECT_AREA ? POINTS_BY_AREA : POINTS_BY_ANGLE;
    lit_draw y = {.emitter = (uint32_t)k};
    if (!lit_draw_of(&d->lights->emitter[k], points, chance, x->h->s.p, u, &y)) return none;
    vec3 wi = to_local(x->frame, y.wi), f = brdf_value_local(b, wi, x->wo);
    if (!(vdot(x->h->s.n, y.wi) > 0)) f = none;
    if (vzero(f) && !d->spend_all) return none;
    d->work->shadow++;
    if (lit_occluded_from(d->s, lit_draw_ray(&x->h->s, &y), x->h->s.shape, (uint32_t)k))
        return none;
    if (vzero(f)) return none;
    real w = 1;
    if (direct_both(d->way)) w = direct_weight(d->way, y.pdf, brdf_pdf_local(b, wi, x->wo));
    return vscale(vmul(f, y.Le), w * wi.z / y.pdf);
}

/* (24.2): what is seen along a direction. When both ways are used, the light's own way would have
 * found it, too, with the pdf (24.5). */
static inline vec3 direct_along(const direct *d, const direct_point *x, point2 u)
{
    vec3 w = {0, 0, 1}, wi = x->h->s.n, weight = {0, 0, 0};
    bool both = direct_both(d->way);
    const brdf *b = x->h->f;
    real pdf = 0, share = 1;
    if (both) {
        if (brdf_sample_local(b, x->wo, u.u, u.v, &w, &pdf, &weight)) wi = to_world(x->frame, w);
    } else reflection_direction((direction_choice)d->way, b, x->frame, x->wo, u, &wi, &weight);
    if (!(vdot(x->h->s.n, wi) > 0)) weight = (vec3){0, 0, 0};
    if (vzero(weight) && !d->spend_all) return weight;
    lit_hit y;
    d->work->direction++;
    if (!lit_trace_from(d->s, leave(x->h->s, wi), x->h->s.shape, &y))
        return vmul(weight, d->s->background);
    vec3 Le = lit_emitted(&y);
    if (vzero(Le) || vzero(weight)) return (vec3){0, 0, 0};
    if (both) {
        real other = lit_lights_pdf(d->lights, POINTS_BY_ANGLE, y.emitter, x->h->s.p, y.t, 1);
        share = direct_weight(d->way, pdf, other);
    }
    return vmul(vscale(weight, share), Le);
}

static inline vec3 direct_by_lights(const direct *d, const direct_point *x, sampler *s)
{
    vec3 sum = {0, 0, 0};
    if (brdf_is_delta(x->h->f) && !d->spend_all) return sum;
    if (d->lights->rule != LIGHTS_ALL) {
        real chance, rest;
        real u = d->s->emitters > 1 ? sampler_number(s) : 0;
        size_t k = lit_lights_choose(d->lights, u, &chance, &rest);
        return direct_from(d, x, k, chance, sampler_pair(s));
    }
    for (size_t k = 0; k < d->s->emitters; k++)
        sum = vadd(sum, direct_from(d, x, k, 1, sampler_pair(s)));
    return sum;
}

/* Radiance from h towards wo, without what h emits itself. */
static inline vec3 direct_light(const direct *d, const lit_hit *h, vec3 wo, sampler *s)
{
    vec3 sum = {0, 0, 0};
    const brdf *b = h->f;
    bool dark = d->s->emitters == 0 && vzero(d->s->background);
    d->work->samples++;
    if ((dark || brdf_is_black(b)) && !d->spend_all) return sum;
    shading_frame frame = shading_frame_of(h->s.ns);
    direct_point x = {h, frame, to_local(frame, wo)};
    if (brdf_behind(x.wo) && !d->spend_all) return sum;
    sampler lamp = *s;
    lamp.pair += 1;
    if (d->way <= DIRECT_BRDF || direct_both(d->way)) sum = direct_along(d, &x, sampler_pair(s));
    if (d->way >= DIRECT_AREA && d->s->emitters) sum = vadd(sum, direct_by_lights(d, &x, &lamp));
    s->pair = lamp.pair;
    return sum;
}

#endif
