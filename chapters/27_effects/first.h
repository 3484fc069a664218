/* first.h: what the lights and materials of a scene call for, decided before the first ray is shot.
 * Wrong where a scene wants what it does not say: with point lights only, light between walls is
 * not traced, and `ambient` stands for it. plan.h says why, price.h what it costs. One lamp. */
#ifndef FIRST_EFFECTS_H
#define FIRST_EFFECTS_H
#include "../19_whitted/first.h"
#include "../24_direct_light/first.h"

enum { first_shadows, first_mirrors, first_glass, first_lamps, first_bounces, first_effects };
static const char *const first_effect_name[first_effects] = {
    "shadow rays", "mirror rays", "glass", "points of a lamp", "bounces"};

typedef struct { bool on[first_effects]; const char *because[first_effects]; } first_plan;

static inline void first_decide(first_plan *p, int effect, bool on, const char *yes, const char *no)
{
    p->on[effect] = on;
    p->because[effect] = on ? yes : no;
}

/* One look at each thing; one line of reason an effect. The eye is taken to be in no ball. */
static inline first_plan first_plan_of(const first_scene *s)
{
    first_plan p;
    const first_thing *y = &s->thing[0];
    bool mirror = false, glass = false, matte = false;
    bool lamp = s->things > 0 && !vzero(y->m.ke) && vlength(y->n) > 0;
    int reflecting = 0;
    for (int i = 0; i < s->things; i++) {
        const first_material *m = &s->thing[i].m;
        if (!vzero(m->mirror)) mirror = true;
        if (m->ior > 0) glass = true;
        if (!vzero(m->kd)) matte = true;
        if (!vzero(m->kd) || !vzero(m->mirror) || m->ior > 0) reflecting++;
    }
    first_decide(&p, first_shadows, s->lights > 0 && s->things > 1,
                 "a point light, and things that may stand before each other",
                 s->lights ? "one convex thing casts no shadow on itself" : "no point light");
    first_decide(&p, first_mirrors, mirror, "a material has a mirror", "no material has a mirror");
    first_decide(&p, first_glass, glass, "a material has an ior", "no material has an ior");
    first_decide(&p, first_lamps, lamp, "thing 0 has ke and an area", "thing 0 is no lamp");
    first_decide(&p, first_bounces, lamp && matte && reflecting > 1,
                 "a lamp, and matte things that others light",
                 !lamp ? "no lamp: ambient stands for it"
                 : matte ? "nothing else reflects" : "nothing is matte");
    return p;
}

static long first_rays[first_effects];  /* shot for each effect */

/* The point lights; a shadow ray only if the plan has them.                             (18.8) */
static inline vec3 first_plan_lights(const first_scene *s, const first_plan *p, first_point x)
{
    vec3 L = vmul(x.kd, s->ambient);
    for (int i = 0; i < s->lights; i++) {
        vec3 d = vsub(s->light[i].p, x.p), l = vunit(d);
        real cosine = vdot(x.n, l);
        if (cosine <= 0) continue;
        if (p->on[first_shadows]) {
            first_rays[first_shadows]++;
            if (first_occluded(s, (ray){x.p, s->eps, d, 1 - s->eps})) continue;
        }
        L = vadd(L, first_reflected(x, l, vscale(s->light[i].intensity, cosine / vdot(d, d))));
    }
    return L;
}

/* What comes back along r, of unit direction: the chapters 18, 19, 24 and 26 in one, each of them
 * only if it is in the plan. `seen`: by the eye, or in mirrors and glass; from a matte wall the
 * lamp is counted already, and `ambient` stands for the sky. What is matte and mirrors, mirrors. */
static inline vec3 first_planned(const first_scene *s, const first_plan *p, ray r, bool seen,
                                 int depth, random_stream *random)
{
    hit h;
    vec3 L = vec(0, 0, 0), weight = L;
    if (!first_scene_hit(s, r, &h)) return seen ? first_background(s, r.d) : L;
    first_point x = first_point_at(s, r, h);
    if (seen) L = first_emitted(x);
    L = vadd(L, first_plan_lights(s, p, x));
    ray next = {x.p, s->eps, first_reflect(r.d, x.n), real_infinity};
    if (p->on[first_lamps]) {
        first_rays[first_lamps]++;
        L = vadd(L, first_direct_by_lamp(s, 0, x, random));
    }

    /* One way on: a coin decides in glass (21), roulette ends the walk between walls (26). */
    seen = true;
    if (p->on[first_glass] && x.m->ior > 0) {
        real n1 = x.inside ? x.m->ior : 1, n2 = x.inside ? 1 : x.m->ior;
        vec3 w;
        if (first_refract(r.d, x.n, n1, n2, &w)
            && random_next(random) >= first_fresnel(-vdot(r.d, x.n), -vdot(w, x.n), n1, n2))
            next.d = w;
        weight = vec(1, 1, 1), first_rays[first_glass]++;
    } else if (p->on[first_mirrors] && !vzero(x.m->mirror)) {
        weight = x.m->mirror, first_rays[first_mirrors]++;
    } else if (p->on[first_bounces] && random_next(random) < 0.8) {
        next = first_bounce(s, x, random), seen = false;
        weight = vscale(x.kd, 1 / 0.8), first_rays[first_bounces]++;
    }
    if (depth > 1 && !vzero(weight))
        L = vadd(L, vmul(weight, first_planned(s, p, next, seen, depth - 1, random)));
    return L;
}
#endif
