/* terms.h: E, K E, K^2 E, ... each by itself: light by the number of its bounces.
 *
 *   vec3 term[depth + 1];
 *   bounce_terms_lit(&p, eye, &s, term, &counts);   term[k]: a sample of K^k E, as by
 *                                                   naive_terms, with far less noise
 *
 * K^k E = K^(k-1) (K E), and K E is direct light, of which 24 knows where it comes from: so the
 * path takes k - 1 bounces, and the last K is a point x of a light, uniform on its area (24's cheap
 * way), and a ray of sight to it:
 *
 *   term[k] = w_0 ... w_(k-2)  f cos E(x) / pdf,  0 if something is between                (25.10)
 *
 * Two ways to the same numbers that share nothing but the walk: tests hold one against the other.
 * A mirror's K finds no point of a light: there what the path meets is counted, as in naive_path.h.
 * counts->direct.shadow counts rays of sight: none without emitters, to lights behind the surface,
 * or from what is black.
 */
#ifndef BOUNCES_TERMS_H
#define BOUNCES_TERMS_H

#include "../24_direct_light/direct.h"
#include "naive_path.h"

typedef struct { naive_counts walk; direct_work direct; } bounce_counts;

/* ---------------------------------------------------------------------------------------------- */

/* K E at x towards wo: one of the lights, each as likely as the others. */
static inline vec3 bounce_direct(const direct *d, const lit_hit *x, vec3 wo, sampler *s)
{
    vec3 black = {0, 0, 0};
    real chance, which = sampler_number(s);
    point2 u = sampler_pair(s);
    if (!lit_lights_some(d->lights) || brdf_is_delta(x->f)) return black;
    shading_frame f = shading_frame_of(x->s.ns);
    direct_point at = {x, f, to_local(f, wo)};
    size_t k = lit_lights_choose(d->lights, which, &chance, &which);
    return direct_from(d, &at, k, chance, u);
}

/* A hit of bounce k gives term[k + 1] by its light; what it shines itself is term[k] only if that
 * was not asked for at the hit before: seen by the eye, or in a mirror. */
static inline void bounce_terms_lit(const naive_path *p, ray eye, sampler *s, vec3 *term,
                                    bounce_counts *c)
{
    vec3 through = {1, 1, 1}, wo = vneg(vunit(eye.d)), weight;
    bool count_it = true, met;
    lit_hit x;
    lit_lights lamps;
    direct d = {p->scene, DIRECT_AREA, &lamps, &c->direct, false};
    lit_lights_of(p->scene, NULL, LIGHTS_UNIFORM, &lamps);  /* nothing to be freed */
    for (int k = 0; k <= p->depth; k++) term[k] = (vec3){0, 0, 0};
    if (naive_dark(p->scene)) return;
    for (int k = 0;; k++) {
        vec3 Le = naive_find(p, eye, k, &x, &met, &c->walk);
        if (count_it || !met) term[k] = vadd(term[k], vmul(through, Le));
        if (!met || k == p->depth) return;
        if (naive_black(&x)) { c->walk.black++; return; }
        term[k + 1] = vadd(term[k + 1], vmul(through, bounce_direct(&d, &x, wo, s)));
        if (k + 1 == p->depth && !brdf_is_delta(x.f) && vzero(p->scene->background)) return;
        if (!naive_direction(p, &x, wo, sampler_pair(s), &eye, &weight)) return;
        through = naive_through(through, weight);
        if (vzero(through)) return;
        wo = vneg(eye.d), count_it = brdf_is_delta(x.f);
    }
}

#endif
