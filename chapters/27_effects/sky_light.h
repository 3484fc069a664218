/* sky_light.h: directions towards an environment, drawn so that little noise is left.
 *
 *   sky_light l;
 *   if (!sky_light_build(&s.sky, &l, &f)) fail(f);     the sky must outlive it
 *   sky_light_sample(&l, n, u, &x)      x.wi, x.pdf [1/sr], x.L; false: it counts, and is 0
 *   real q = sky_light_pdf(&l, d, cosine)    the same for any d; cosine = n.d > 0
 *   sky_light_free(&l)
 *
 *   one colour, gradient   as the cosine: pdf = n.wi / pi
 *   picture                as its luminance (24.15), by that of 24, whose pole is +y and whose
 *                          first column looks along +x: d' = (-d.front, d.up, -d.right)    (27.7)
 */
#ifndef EFFECTS_SKY_LIGHT_H
#define EFFECTS_SKY_LIGHT_H

#include "../23_brdf/shading_frame.h"
#include "../24_direct_light/environment.h"
#include "sky.h"

typedef struct { const effects_sky *s; environment picture; bool by_picture; } sky_light;
typedef struct { vec3 wi, L; real pdf; } sky_draw;

/* ---------------------------------------------------------------------------------------------- */

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

static inline bool sky_light_sample(const sky_light *l, vec3 n, point2 u, sky_draw *out)
{
    const effects_sky *s = l->s;
    if (l->by_picture) {
        vec3 d;
        environment_sample(&l->picture, u, &d, &out->pdf, &out->L);
        out->wi = vmadd(vmadd(vscale(s->front, -d.x), s->up, d.y), s->right, -d.z);
        out->L = vscale(out->L, s->scale);
        return vdot(n, out->wi) > 0 && out->pdf > 0;
    }
    vec3 d = sample_cosine(u.u, u.v), black = {0, 0, 0};
    out->pdf = pdf_cosine(d);
    out->wi = to_world(shading_frame_of(n), d);
    out->L = s->kind == SKY_NONE ? black : sky_radiance(s, out->wi);
    return out->pdf > 0;
}

static inline real sky_light_pdf(const sky_light *l, vec3 d, real cosine)
{
    if (l->by_picture) return environment_pdf(&l->picture, sky_light_local(l->s, d));
    return l->s->kind == SKY_NONE ? 0 : real_max(cosine, 0) / pi;
}

#endif
