/* lights.h: the lights of a scene as one: which of them, a point of it, and with what pdf.
 *
 *   lit_lights l;
 *   lit_lights_of(&scene, sky, LIGHTS_FLUX, &l);           sky: NULL, or an environment
 *   lit_lights_sample(&l, points, p, u, &x)                one light, and a point of it as seen
 *                                                          from p; false: it brings nothing
 *   real q = lit_lights_pdf(&l, points, k, p, t, cosine)   of drawing a point of emitter k, t away
 *   real q = lit_lights_pdf_sky(&l, d)                     ... of drawing d, which meets nothing
 *   size_t k = lit_lights_choose(&l, u, &chance, &rest)    only which emitter
 *   real q = lit_lights_chance(&l, k)                      P(k), as lit_lights_choose draws
 *   L += f cos x.Le w / x.per                              if lit_draw_ray(&s, &x) meets nothing
 *   lit_lights_free(&l)
 *   lit_lights_list(e, n, sky, rule, &l)                   of emitters that are in no scene
 *   lit_draw_of(e, points, chance, p, u, &x), lit_draw_light(&light, chance, p, &x)    of one alone
 *
 *   which       LIGHTS_ALL      none is chosen: ask for a point of each                  P(k) = 1
 *               LIGHTS_UNIFORM  one, each as likely                                      1 / n
 *               LIGHTS_FLUX     one, the brighter the more often: P(k) ~ area x radiance,
 *                               the power that it gives off, but for a factor pi         (24.10)
 *   points      POINTS_BY_AREA  (24.4);   POINTS_BY_ANGLE  (24.5);
 *               POINTS_CHEAP    triangles and rectangles by area, spheres by angle
 *
 *   pdf(wi) = P(k) pdf of the point seen from p                                            [1/sr]
 *
 * Light without size (18), which no list holds, comes along one direction: pdf is infinite, so that
 * w = 1 (24.9): nothing else finds it. Le is its irradiance across wi, and x.per = `chance`. Of all
 * others per = pdf.
 *
 * The sky gets one half if there are emitters, too: how much it brings depends on the place. One
 * light: nothing is chosen, no random digits are used up. Otherwise u.u chooses, and what is left
 * of it is used for the point. A constant background is no light here: directions find it at no
 * cost.
 */
#ifndef DIRECT_LIGHTS_H
#define DIRECT_LIGHTS_H

#include "../18_shade/leave.h"
#include "../18_shade/light.h"
#include "../20_monte_carlo/sampling.h"
#include "environment.h"
#include "lit_scene.h"

typedef enum { LIGHTS_ALL, LIGHTS_UNIFORM, LIGHTS_FLUX } lit_lights_rule;
typedef enum { POINTS_BY_AREA, POINTS_BY_ANGLE, POINTS_CHEAP } lit_points;

typedef struct {
    const emitter *emitter;
    size_t n;
    const environment *sky;
    lit_lights_rule rule;
    choice of;              /* LIGHTS_FLUX: emitters by power; empty if there is one or none */
    real emitters, skies;   /* probability of either kind */
} lit_lights;

typedef struct {
    vec3 wi, Le;
    real pdf, per;
    uint32_t emitter;       /* lit_dark: the sky */
    bool far;               /* sky or sun: from infinitely far, s says nothing */
    surface s;              /* on the emitter; a point light: where it is, n = 0 */
} lit_draw;

/* ---------------------------------------------------------------------------------------------- */

static inline void lit_lights_free(lit_lights *l) { choice_free(&l->of); }

static inline void lit_lights_list(const emitter *e, size_t n, const environment *sky,
                                   lit_lights_rule rule, lit_lights *out)
{
    *out = (lit_lights){.emitter = e, .n = n, .sky = sky, .rule = rule};
    out->emitters = n == 0 ? 0 : sky ? (real)0.5 : 1;
    out->skies = sky ? 1 - out->emitters : 0;
    if (n < 2 || rule != LIGHTS_FLUX) return;
    real *power = allocate(n, sizeof *power);
    for (size_t i = 0; i < n; i++) power[i] = emitter_power(&e[i]);
    if (!choice_build(power, n, &out->of)) out->emitters = 0, out->skies = sky ? 1 : 0;
    free(power);
}

static inline void lit_lights_of(const lit_scene *s, const environment *sky, lit_lights_rule rule,
                                 lit_lights *out)
{
    lit_lights_list(s->emitter, s->emitters, sky, rule, out);
}

static inline bool lit_lights_some(const lit_lights *l) { return l->emitters + l->skies > 0; }

static inline real lit_lights_chance(const lit_lights *l, size_t k)
{
    if (l->rule == LIGHTS_ALL) return 1;
    if (l->rule == LIGHTS_UNIFORM) return l->emitters / (real)l->n;
    return l->of.n ? l->emitters * choice_probability(&l->of, k) : l->emitters;
}

/* [emitters > 0, and not LIGHTS_ALL] *rest: what is left of u, uniform in [0,1) again. */
static inline size_t lit_lights_choose(const lit_lights *l, real u, real *chance, real *rest)
{
    size_t n = l->n, k = 0;
    *chance = l->emitters, *rest = u;
    if (l->of.n) {
        real q;
        k = choice_sample(&l->of, u, &q, rest);
        *chance *= q;
    } else if (n > 1) {
        real x = u * (real)n;
        k = (size_t)x < n ? (size_t)x : n - 1;
        *chance /= (real)n, *rest = real_min(x - (real)k, 1 - real_epsilon / 2);
    }
    return k;
}

/* (18.1), (18.2); false: at p itself, or as near as that. */
static inline bool lit_draw_light(const light *L, real chance, vec3 p, lit_draw *out)
{
    real square;
    out->wi = light_towards(L, p, &square), out->Le = vscale(L->colour, 1 / square);
    out->pdf = real_infinity, out->per = chance, out->far = L->kind == LIGHT_DIRECTIONAL;
    out->s = (surface){.p = L->at, .shape = no_shape};
    return square > 0 && vfinite(out->Le);
}

static inline bool lit_points_angle(lit_points points, const emitter *e)
{
    return points == POINTS_BY_ANGLE || (points == POINTS_CHEAP && e->kind == EMITTER_SPHERE);
}

/* True: the point x of e, which was chosen by `chance`. */
fast_inline bool lit_drawn(const emitter *e, const emitter_point *x, real chance, lit_draw *out)
{
    out->wi = x->wi, out->pdf = out->per = x->pdf * chance, out->Le = e->Le, out->far = false;
    out->s = surface_copy(&x->s);
    return true;
}

fast_inline bool lit_draw_of(const emitter *e, lit_points points, real chance, vec3 p, point2 u,
                             lit_draw *out)
{
    emitter_point x;
    bool seen = lit_points_angle(points, e) ? emitter_by_angle(e, p, u, &x)
                                            : emitter_by_area(e, p, u, &x);
    return seen && lit_drawn(e, &x, chance, out);
}

/* The shadow ray. */
fast_inline ray lit_draw_ray(const surface *from, const lit_draw *x)
{
    return x->far ? leave(surface_copy(from), x->wi)
                  : leave_between(surface_copy(from), surface_copy(&x->s));
}

fast_inline bool lit_lights_sample(const lit_lights *l, lit_points points, vec3 p, point2 u,
                                   lit_draw *out)
{
    real chance;
    if (l->skies > 0) {
        real largest = 1 - real_epsilon / 2;
        if (u.u >= l->emitters) {
            u.u = real_min((u.u - l->emitters) / l->skies, largest);
            environment_sample(l->sky, u, &out->wi, &out->pdf, &out->Le);
            out->pdf *= l->skies, out->per = out->pdf, out->emitter = lit_dark, out->far = true;
            out->s = (surface){.shape = no_shape};
            return true;
        }
        u.u = real_min(u.u / l->emitters, largest);
    }
    size_t k = lit_lights_choose(l, u.u, &chance, &u.u);
    out->emitter = (uint32_t)k;
    return lit_draw_of(&l->emitter[k], points, chance, p, u, out);
}

/* Of x, at distance t from p, where the emitter is met at this cosine [> 0]. */
fast_inline real lit_lights_pdf(const lit_lights *l, lit_points points, uint32_t k, vec3 p,
                                real t, real cosine)
{
    const emitter *e = &l->emitter[k];
    real pdf = lit_points_angle(points, e) ? emitter_pdf_angle(e, p) : t * t / (e->area * cosine);
    return lit_lights_chance(l, k) * pdf;
}

static inline real lit_lights_pdf_sky(const lit_lights *l, vec3 d)
{
    return l->skies > 0 ? l->skies * environment_pdf(l->sky, d) : 0;
}

#endif
