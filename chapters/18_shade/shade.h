/* shade.h: the three functions of the notes, written as programs of trace.h.
 *
 *   rayTraceImage()                                for each pixel: shade_ray
 *     trace(RAY_CAMERA, eye ray, &seen)
 *       miss         -> seen.colour = background
 *       closest_hit  -> shade(): for each light that can contribute                       (18.8)
 *                         trace(RAY_SHADOW, leave_to(s, light), &lit)    any hit will do
 *                         lit ? colour += kd/pi E + ks (n.h)^s E : nothing
 *
 * Only what is called for: no shadow ray where the light is behind the surface (n.l <= 0), where
 * light or material is black, for parts that cast no shadow (mask). `spend_all` sends them all the
 * same: more rays, and the same picture to the last bit; a test holds that.
 *
 *   shading s = {lights, 2, material_of, context, background, ambient, false};
 *   tracer t = {&world, shade_programs, &s};
 *   vec3 c = shade_ray(&t, camera_ray(..));
 *   t.counts.rays[RAY_SHADOW]                      what it took
 *   bool seen = sight(&t, a, b);                   can two points see each other?
 *
 * Programs that need more than a `shading` point tracer.user to a struct of their own that begins
 * with one: then shade_miss still finds it, and shade() is given it in any case.
 */
#ifndef SHADE_H
#define SHADE_H

#include "leave.h"
#include "light.h"
#include "material.h"
#include "trace.h"

typedef struct {
    const light *lights;
    int n;               /* how many */
    material (*material_of)(const void *context, trace_hit x, const surface *s);
    const void *context;
    vec3 background, ambient;
    bool spend_all;
    surface (*surface_of)(const tracer *t, ray r, trace_hit x);  /* NULL: surface_of_trace */
    ray (*leave)(surface s, vec3 w);                             /* NULL: leave */
} shading;

typedef struct { vec3 colour; real t; trace_hit x; } shade_seen;  /* payload of a camera ray */
typedef struct { bool lit; } shade_lit;                            /* payload of a shadow ray */

/* ---------------------------------------------------------------------------------------------- */

/* To the light, without it; the sun is at infinity. A variant that leaves along w gets w = L - p,
 * and ends at the light, too. */
static inline ray shade_shadow_ray(const shading *how, surface s, const light *L)
{
    if (L->kind == LIGHT_DIRECTIONAL) return how->leave ? how->leave(s, L->at) : leave(s, L->at);
    if (!how->leave) return leave_to(s, L->at);
    ray r = how->leave(s, vsub(L->at, s.p));
    return (ray){r.o, r.tmin, vsub(L->at, r.o), 1};
}

/* (18.8). What cannot contribute has E = 0 or reflects nothing: if it is traced all the same,
 * exactly 0 is added. v: unit, towards the eye; s faces it. */
static inline vec3 shade(tracer *t, const shading *how, surface s, const material *m, vec3 v)
{
    vec3 colour = vmadd(m->ke, vmul(how->ambient, m->kd), 1);
    for (int i = 0; i < how->n; i++) {
        light_sample x;
        bool counts = light_reaches(&how->lights[i], s.p, s.n, s.ns, &x) && material_reflects(m);
        if (!counts && !how->spend_all) continue;
        shade_lit answer = {false};
        trace(t, RAY_SHADOW, shade_shadow_ray(how, s, &how->lights[i]), &answer);
        if (answer.lit) colour = vadd(colour, blinn_phong(m, s.ns, x.l, v, x.E));
    }
    return colour;
}

static inline void shade_closest_hit(tracer *t, ray r, trace_hit x, void *payload)
{
    const shading *how = t->user;
    shade_seen *seen = payload;
    surface s = how->surface_of ? how->surface_of(t, r, x) : surface_of_trace(t, r, x);
    s = surface_facing(s, r.d);
    material m = how->material_of(how->context, x, &s);
    *seen = (shade_seen){shade(t, how, s, &m, vneg(vunit(r.d))), x.h.t, x};
}

static inline void shade_miss(tracer *t, ray r, void *payload)
{
    (void)r;
    ((shade_seen *)payload)->colour = ((const shading *)t->user)->background;
}

static inline void shade_nothing_between(tracer *t, ray r, void *payload)
{
    (void)t, (void)r;
    ((shade_lit *)payload)->lit = true;
}

static const ray_program shade_programs[ray_kinds] = {
    [RAY_CAMERA] = {MASK_SEEN, false, NULL, shade_closest_hit, shade_miss},
    [RAY_SHADOW] = {MASK_SHADOW, true, NULL, NULL, shade_nothing_between},
    [RAY_SIGHT] = {MASK_SIGHT, true, NULL, NULL, shade_nothing_between},
};

static inline vec3 shade_ray(tracer *t, ray r)
{
    shade_seen seen = {{0, 0, 0}, real_infinity, {hit_none, 0}};
    trace(t, RAY_CAMERA, r, &seen);
    return seen.colour;
}

/* Ray casting (光线投射) that draws nothing: who sees whom in a game, antennas, view factors, guards.
 * No ray where a surface itself is in between. The same answer for b, a: one ray serves both. */
static inline bool sight(tracer *t, surface a, surface b)
{
    vec3 ab = vsub(b.p, a.p);
    shade_lit answer = {false};
    if (!(vdot(a.n, ab) > 0 && vdot(b.n, ab) < 0)) return false;
    trace(t, RAY_SIGHT, leave_between(a, b), &answer);
    return answer.lit;
}

#endif
