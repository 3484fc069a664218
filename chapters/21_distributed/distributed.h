/* distributed.h: one more ray for nothing: the samples of a pixel are spread over all its effects.
 *
 * Whitted's pixel asks one question: one ray through its middle, one to the middle of the light,
 * one in the mirror direction. Each is the middle of an integral: over the pixel, the lens, the
 * light, the lobe, the sky. A pixel needs several rays anyway, for its edges: let sample k of n
 * take the k-th point of *each* of these domains: the same n rays integrate them all.      (21.11)
 *
 *   pair of random numbers      a hit          decides on            and is drawn
 *   0   PAIR_FILM               1              where in the pixel    always
 *   1   PAIR_LENS               1              where on the lens     if its radius is not 0
 *   far behind: PAIR_TIME       the sample     when                  if anything moves
 *   2.. PAIR_HIT, light i       1 a light      where on the light    if it has a size
 *       behind the lights       1              where in the sky      if ambient light can be hidden
 *       behind that             1              where in the lobe     if the surface is not a mirror
 *   and so on for the next hit: a fixed place each, so what is not drawn changes no other.
 *
 *   distributed how = {.light = lights, .n = 1, .material_of = .., .depth = 5, ..};
 *   distributor d = distributor_of(&world, &how);       one a thread: it counts rays and pairs
 *   distributed_sample q = {SEQUENCE_SOBOL, seed, pixel, k, n};
 *   vec3 L = distributed_ray(&d, r, q);                 what one ray sees
 *                                                       (pairs 0 and 1: who draws, lab/view.h)
 *
 * Each hit: emission, ambient light where the sky is open, each light by one shadow ray; then one
 * ray into the lobe of ks, with shine as its exponent, until `depth` rays have been cast (the eye
 * ray is the first). A chain, no tree: a loop.
 *
 * Only what is called for: nothing is drawn or sent for a lens, a light, a lobe of no size; nothing
 * for what is black, behind, or below. `spend_all` does it all the same: the same picture to the
 * last bit.
 *
 * Source: R. Cook, T. Porter, L. Carpenter, "Distributed Ray Tracing", SIGGRAPH 1984.
 */
#ifndef DISTRIBUTED_H
#define DISTRIBUTED_H

#include "ambient_occlusion.h"
#include "area_light.h"
#include "glossy.h"
#include "lens.h"
#include "motion.h"

typedef struct {
    const area_light *light;
    int n;                    /* lights */
    const moving *moving;     /* or NULL */
    int movers;
    material (*material_of)(const void *context, trace_hit x, const surface *s);
    const void *context;
    vec3 background, ambient; /* what a ray sees that meets nothing; La of ambient_occlusion.h */
    real reach;               /* 0: nothing hides ambient light, no ray asks */
    int depth;                /* >= 1 */
    bool spend_all;
} distributed;

typedef struct { sequence_kind kind; uint64_t seed, pixel; uint32_t k, n; } distributed_sample;
enum { PAIR_FILM, PAIR_LENS, PAIR_HIT, PAIR_TIME = INT32_MAX };
typedef enum { DRAWN_FILM, DRAWN_LENS, DRAWN_LIGHT, DRAWN_SKY, DRAWN_LOBE, DRAWN_TIME,
               drawn_kinds } drawn_kind;

typedef struct {
    tracer t;
    const distributed *how;
    size_t drawn[drawn_kinds];
    real time;                /* [0,1) of the sample; read only if anything moves */
} distributor;

static inline vec3 distributed_ray(distributor *d, ray r, distributed_sample q);

/* ---------------------------------------------------------------------------------------------- */

typedef struct { bool met; real t; surface s; material m; } distributed_met;  /* payload */

static inline void distributed_closest_hit(tracer *t, ray r, trace_hit x, void *payload)
{
    const distributed *how = t->user;
    surface s = surface_facing(surface_of_trace(t, r, x), r.d);
    *(distributed_met *)payload =
        (distributed_met){true, x.h.t, s, how->material_of(how->context, x, &s)};
}

static const ray_program distributed_programs[ray_kinds] = {
    [RAY_CAMERA] = {MASK_SEEN, false, NULL, distributed_closest_hit, NULL},
    [RAY_REFLECTION] = {MASK_SEEN, false, NULL, distributed_closest_hit, NULL},
    [RAY_SHADOW] = {MASK_SHADOW, true, NULL, NULL, shade_nothing_between},
    [RAY_SIGHT] = {MASK_SIGHT, true, NULL, NULL, shade_nothing_between},
};

static inline distributor distributor_of(const trace_world *w, const distributed *how)
{
    return (distributor){{.w = w, .program = distributed_programs, .user = how}, how, {0}, 0};
}

/* Whichever were drawn before. */
static inline point2 distributed_pair(distributor *d, distributed_sample q, drawn_kind what,
                                      uint32_t pair)
{
    sampler s = sampler_start(q.kind, q.seed, q.pixel, q.k, q.n);
    s.pair = pair;
    d->drawn[what]++;
    return sampler_pair(&s);
}

/* Does the ray get through, past all that rests and all that moves? */
static inline bool distributed_passes(distributor *d, ray_kind kind, ray r)
{
    return !motion_any(&d->t, d->how->moving, d->how->movers, d->time, kind, r);
}

static inline uint32_t distributed_pairs_a_hit(const distributed *how)
{
    return (uint32_t)how->n + 2;
}

/* Lambert's share of light i. */
static inline vec3 distributed_direct(distributor *d, const surface *s, const material *m, int i,
                                      distributed_sample q, uint32_t pair)
{
    const distributed *how = d->how;
    const area_light *L = &how->light[i];
    bool black = vzero(m->kd) || vzero(L->colour), lit = false;
    point2 u = {0, 0};
    area_sample x;
    if (black && !how->spend_all) return (vec3){0, 0, 0};
    if (area_light_has_size(L) || how->spend_all) u = distributed_pair(d, q, DRAWN_LIGHT, pair);
    bool counts = area_light_reaches(L, s->p, s->n, s->ns, u, &x) && !black;
    if (counts || how->spend_all) lit = distributed_passes(d, RAY_SHADOW, leave_to(*s, x.to));
    return counts && lit ? vmul(x.E, vscale(m->kd, 1 / pi)) : (vec3){0, 0, 0};
}

static inline vec3 distributed_sky(distributor *d, const surface *s, const material *m,
                                   distributed_sample q, uint32_t pair)
{
    const distributed *how = d->how;
    vec3 all = vmul(how->ambient, m->kd);
    bool asked = how->reach > 0 && !vzero(all);
    if (!asked && !how->spend_all) return all;
    ray r;
    point2 u = distributed_pair(d, q, DRAWN_SKY, pair);
    bool open = ambient_ray(*s, u, how->reach, &r) && distributed_passes(d, RAY_SIGHT, r);
    return asked && !open ? (vec3){0, 0, 0} : all;
}

/* False: the chain ends. */
static inline bool distributed_next(distributor *d, const surface *s, const material *m, vec3 beta,
                                    distributed_sample q, uint32_t pair, ray *r)
{
    bool black = vzero(vmul(beta, m->ks)), mirror = isinf(m->shine);
    point2 u = {0, 0};
    if (black && !d->how->spend_all) return false;
    if (!mirror || d->how->spend_all) u = distributed_pair(d, q, DRAWN_LOBE, pair);
    return glossy_ray(*s, r->d, m->shine, u, r);
}

/* In the order of shade() (18), so that without any extent the two agree to the last bit. */
static inline vec3 distributed_ray(distributor *d, ray r, distributed_sample q)
{
    const distributed *how = d->how;
    if (how->movers > 0 || how->spend_all)
        d->time = distributed_pair(d, q, DRAWN_TIME, PAIR_TIME).u;
    vec3 L = {0, 0, 0}, beta = {1, 1, 1};
    uint32_t pair = PAIR_HIT;
    for (int depth = 1;; depth++, pair += distributed_pairs_a_hit(how)) {
        distributed_met x = {.met = false};
        vec3 by;
        motion_closest(&d->t, how->moving, how->movers, d->time,
                       depth == 1 ? RAY_CAMERA : RAY_REFLECTION, r, &x, &x.t, &by);
        x.s = motion_surface(x.s, by);
        if (!x.met) return vadd(L, vmul(beta, how->background));
        uint32_t sky = pair + (uint32_t)how->n;
        vec3 here = vadd(x.m.ke, distributed_sky(d, &x.s, &x.m, q, sky));
        for (int i = 0; i < how->n; i++)
            here = vadd(here, distributed_direct(d, &x.s, &x.m, i, q, pair + (uint32_t)i));
        L = vadd(L, vmul(beta, here));
        if (depth >= how->depth) return L;
        if (!distributed_next(d, &x.s, &x.m, beta, q, sky + 1, &r)) return L;
        beta = vmul(beta, x.m.ks);
    }
}

#endif
