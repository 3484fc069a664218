/* lights.h: one of a scene's lights, the brighter the more often, and a point of it.
 *
 *   path_lights l;
 *   path_lights_of(&scene, sky, &l);                       sky: NULL, or an environment
 *   path_lights_sample(&l, p, u, &x)                       false: this sample brings nothing
 *   real q = path_lights_pdf(&l, emitter, p, t, cosine)   of drawing a point of it, t away
 *   real q = path_lights_pdf_sky(&l, d)                    ... of drawing d, which meets nothing
 *   path_lights_free(&l)
 *
 *   P(light) ~ area x radiance: the power that it gives off, but for a factor pi           (26.10)
 *   pdf(wi) = P(light) pdf of the point seen from p (24.4), (24.5)                          [1/sr]
 *
 * The sky gets one half if there are emitters, too: how much it brings depends on the place. One
 * light: nothing is chosen, no random digits are used up. Otherwise u.u chooses, and what is left
 * of it is used for the point. Triangles and rectangles are drawn by area, spheres by angle.
 *
 * A constant background is no light here: BRDF directions find it at no cost.
 */
#ifndef PATH_LIGHTS_H
#define PATH_LIGHTS_H

#include "../20_monte_carlo/sampling.h"
#include "../18_shade/leave.h"
#include "../24_direct_light/lit_scene.h"
#include "environment.h"

typedef struct {
    const lit_scene *scene;
    const environment *sky;
    choice of;              /* emitters by power; empty if there is one or none */
    real emitters, skies;   /* probability of either kind */
} path_lights;

typedef struct {
    vec3 wi, Le;
    real pdf;
    uint32_t emitter;       /* lit_dark: the sky */
    surface s;              /* on the emitter */
} light_draw;

/* ---------------------------------------------------------------------------------------------- */

static inline void path_lights_free(path_lights *l) { choice_free(&l->of); }

static inline void path_lights_of(const lit_scene *s, const environment *sky, path_lights *out)
{
    size_t n = s->emitters;
    *out = (path_lights){.scene = s, .sky = sky};
    out->emitters = n == 0 ? 0 : sky ? (real)0.5 : 1;
    out->skies = sky ? 1 - out->emitters : 0;
    if (n < 2) return;
    real *power = allocate(n, sizeof *power);
    for (size_t i = 0; i < n; i++) power[i] = emitter_power(&s->emitter[i]);
    if (!choice_build(power, n, &out->of)) out->emitters = 0, out->skies = sky ? 1 : 0;
    free(power);
}

static inline bool path_lights_some(const path_lights *l) { return l->emitters + l->skies > 0; }

static inline real path_lights_chance(const path_lights *l, uint32_t i)
{
    return l->of.n ? l->emitters * choice_probability(&l->of, i) : l->emitters;
}

__attribute__((always_inline))
static inline bool path_lights_sample(const path_lights *l, vec3 p, point2 u, light_draw *out)
{
    emitter_point x;
    out->emitter = 0;
    real chance = l->emitters;
    if (l->skies > 0) {
        real largest = 1 - real_epsilon / 2;
        if (u.u >= l->emitters) {
            u.u = real_min((u.u - l->emitters) / l->skies, largest);
            environment_sample(l->sky, u, &out->wi, &out->pdf, &out->Le);
            out->pdf *= l->skies, out->emitter = lit_dark;
            return true;
        }
        u.u = real_min(u.u / l->emitters, largest);
    }
    if (l->of.n) {
        real q;
        out->emitter = (uint32_t)choice_sample(&l->of, u.u, &q, &u.u);
        chance *= q;
    }
    const emitter *e = &l->scene->emitter[out->emitter];
    bool seen = e->kind == EMITTER_SPHERE ? emitter_by_angle(e, p, u, &x)
                                          : emitter_by_area(e, p, u, &x);
    if (!seen) return false;
    out->wi = x.wi, out->pdf = x.pdf * chance, out->Le = e->Le, out->s = x.s;
    return true;
}

/* Of x, at distance t from p, where the emitter is met at this cosine [> 0]. */
__attribute__((always_inline))
static inline real path_lights_pdf(const path_lights *l, uint32_t i, vec3 p, real t, real cosine)
{
    const emitter *e = &l->scene->emitter[i];
    real pdf = e->kind == EMITTER_SPHERE ? emitter_pdf_angle(e, p) : t * t / (e->area * cosine);
    return path_lights_chance(l, i) * pdf;
}

static inline real path_lights_pdf_sky(const path_lights *l, vec3 d)
{
    return l->skies > 0 ? l->skies * environment_pdf(l->sky, d) : 0;
}

#endif
