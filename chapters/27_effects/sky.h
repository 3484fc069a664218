/* sky.h: what is behind everything: a background (背景), which lights nobody, or an environment
 * (环境光照), radiance from infinitely far.
 *
 *   SKY_NONE      the background, which may be black
 *   SKY_CONSTANT  `low` everywhere
 *   SKY_GRADIENT  low + (high - low) (1 + d.up) / 2: from straight below to straight above  (27.9)
 *   SKY_IMAGE     a latitude-longitude picture (经纬度贴图), its middle along `front`; right = front x
 *                 up; x = w (1/2 + atan2(d.right, d.front) / 2 pi), y = h acos(d.up) / pi; (27.10)
 *                 nearest pixel, no filter, times `scale`
 *
 *   vec3 L = sky_radiance(&s, d)     what comes from direction d, of any length > 0
 *   bool sky_lights(&s)              is there an environment that is not black? O(pixels)
 *   sky_free(&s)
 *
 *   sky_light l;                     directions towards it, drawn so that little noise is left:
 *   if (!sky_light_build(&s, &l, &f)) fail(f);         of a picture as its luminance (24.15), by
 *                                    24, whose axes are d' = (-d.front, d.up, -d.right) (27.7);
 *                                    else as the cosine. s must outlive it
 *   sky_light_sample(&l, n, u, &x)   a lit_draw of 24; false: it counts, and is 0
 *   real q = sky_light_pdf(&l, d, cosine)              the same for any d; cosine = n.d > 0
 *   sky_light_free(&l)
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
    real scale;             /* of the picture */
    image picture;          /* owned; rgb is finite and not negative */
} effects_sky;

typedef struct { const effects_sky *s; environment picture; bool by_picture; } sky_light;

/* ---------------------------------------------------------------------------------------------- */

static inline void sky_free(effects_sky *s)
{
    image_free(&s->picture);
    *s = (effects_sky){.kind = SKY_NONE};
}

/* (27.10). The comparisons come before the conversion, and a NaN becomes pixel 0. */
static inline vec3 sky_pixel(const effects_sky *s, vec3 d)
{
    const image *im = &s->picture;
    d = vunit(d);
    real x = (real)0.5 + atan2(vdot(d, s->right), vdot(d, s->front)) / (2 * pi);
    real y = acos(real_clamp(vdot(d, s->up), -1, 1)) / pi;
    x *= (real)im->width, y *= (real)im->height;
    int i = x > 0 ? (x < (real)im->width ? (int)x : im->width - 1) : 0;
    int j = y > 0 ? (y < (real)im->height ? (int)y : im->height - 1) : 0;
    return image_get(im, i, j);
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
    case SKY_IMAGE: return vscale(sky_pixel(s, d), s->scale);
    }
    return (vec3){0, 0, 0};
}

/* Black or not: of a picture, whether any pixel is. O(pixels). */
static inline bool sky_lights(const effects_sky *s)
{
    size_t n = 3 * (size_t)s->picture.width * (size_t)s->picture.height;
    switch (s->kind) {
    case SKY_NONE: return false;
    case SKY_CONSTANT: return !vzero(s->low);
    case SKY_GRADIENT: return !vzero(s->low) || !vzero(s->high);
    case SKY_IMAGE:
        for (size_t i = 0; i < n && s->scale > 0; i++)
            if (s->picture.rgb[i] > 0) return true;
    }
    return false;
}

/* ---- as a light ---- */

static inline void sky_light_free(sky_light *l)
{
    if (l->by_picture) environment_free(&l->picture);
    *l = (sky_light){.s = NULL};
}

static inline bool sky_light_build(const effects_sky *s, sky_light *out, failure *f)
{
    *out = (sky_light){.s = s, .by_picture = s->kind == SKY_IMAGE && sky_lights(s)};
    if (!out->by_picture || environment_of_image(&s->picture, &out->picture, f)) return true;
    out->by_picture = false;
    return false;
}

/* (27.7) */
static inline vec3 sky_light_local(const effects_sky *s, vec3 d)
{
    return (vec3){-vdot(d, s->front), vdot(d, s->up), -vdot(d, s->right)};
}

static inline bool sky_light_sample(const sky_light *l, vec3 n, point2 u, lit_draw *out)
{
    const effects_sky *s = l->s;
    out->emitter = lit_dark, out->far = true;
    if (l->by_picture) {
        vec3 d;
        environment_sample(&l->picture, u, &d, &out->pdf, &out->Le);
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

static inline real sky_light_pdf(const sky_light *l, vec3 d, real cosine)
{
    if (l->by_picture) return environment_pdf(&l->picture, sky_light_local(l->s, d));
    return l->s->kind == SKY_NONE ? 0 : real_max(cosine, 0) / pi;
}

#endif
