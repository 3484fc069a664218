/* sky.h: what is behind everything: a background (背景), which lights nobody, or an environment
 * (环境光照), radiance from infinitely far.
 *
 *   SKY_NONE      the background, which may be black
 *   SKY_CONSTANT  `low` everywhere
 *   SKY_GRADIENT  low + (high - low) (1 + d.up) / 2: from straight below to straight above  (27.9)
 *   SKY_IMAGE     a latitude-longitude picture (经纬度贴图) of 24, times `scale`, its middle along
 *                 `front`: 24's axes are d' = (-d.front, d.up, -d.right), right = front x up (27.7)
 *
 *   vec3 L = sky_radiance(&s, d)     what comes from direction d, of any length > 0
 *   bool sky_lights(&s)              is there an environment that is not black?
 *   sky_draw(&s, n, u, &x)           a direction towards it, as a lit_draw of 24: of a picture by
 *                                    its luminance (24.15), else by the cosine; false: it counts,
 *                                    and is 0
 *   real q = sky_pdf(&s, d, cosine)  the same for any d; cosine = n.d > 0
 *   sky_free(&s)
 *
 * Source: P. Debevec, "Rendering Synthetic Objects into Real Scenes", SIGGRAPH 1998.
 */
#ifndef EFFECTS_SKY_H
#define EFFECTS_SKY_H

#include "../24_direct_light/lights.h"

typedef enum { SKY_NONE, SKY_CONSTANT, SKY_GRADIENT, SKY_IMAGE } sky_kind;
typedef struct {
    sky_kind kind;
    vec3 background;
    vec3 low, high;
    vec3 up, front, right;  /* unit, at right angles */
    real scale;             /* of the picture, > 0 */
    environment picture;    /* owned; not all black */
} effects_sky;

/* ---------------------------------------------------------------------------------------------- */

static inline void sky_free(effects_sky *s)
{
    environment_free(&s->picture);
    *s = (effects_sky){.kind = SKY_NONE};
}

/* (27.7) */
static inline vec3 sky_local(const effects_sky *s, vec3 d)
{
    return (vec3){-vdot(d, s->front), vdot(d, s->up), -vdot(d, s->right)};
}

static inline vec3 sky_radiance(const effects_sky *s, vec3 d)
{
    switch (s->kind) {
    case SKY_NONE: return s->background;
    case SKY_CONSTANT: return s->low;
    case SKY_GRADIENT: {
        real k = (1 + vdot(vunit(d), s->up)) / 2;
        return vmadd(vscale(s->low, 1 - k), s->high, k);
    }
    case SKY_IMAGE: return vscale(environment_radiance(&s->picture, sky_local(s, d)), s->scale);
    }
    return (vec3){0, 0, 0};
}

static inline bool sky_lights(const effects_sky *s)
{
    return s->kind == SKY_IMAGE || (s->kind != SKY_NONE && !(vzero(s->low) && vzero(s->high)));
}

static inline bool sky_draw(const effects_sky *s, vec3 n, point2 u, lit_draw *out)
{
    out->emitter = lit_dark, out->far = true;
    if (s->kind == SKY_IMAGE) {
        vec3 d;
        environment_sample(&s->picture, u, &d, &out->pdf, &out->Le);
        out->wi = vmadd(vmadd(vscale(s->front, -d.x), s->up, d.y), s->right, -d.z);
        out->Le = vscale(out->Le, s->scale), out->per = out->pdf;
        return vdot(n, out->wi) > 0 && out->pdf > 0;
    }
    vec3 d = sample_cosine(u.u, u.v), black = {0, 0, 0};
    out->pdf = out->per = pdf_cosine(d);
    out->wi = to_world(shading_frame_of(n), d);
    out->Le = s->kind == SKY_NONE ? black : sky_radiance(s, out->wi);
    return out->pdf > 0;
}

static inline real sky_pdf(const effects_sky *s, vec3 d, real cosine)
{
    if (s->kind == SKY_IMAGE) return environment_pdf(&s->picture, sky_local(s, d));
    return s->kind == SKY_NONE ? 0 : real_max(cosine, 0) / pi;
}

#endif
