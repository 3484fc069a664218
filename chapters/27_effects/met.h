/* met.h: light that a ray itself runs into: a lamp, the sky, the background.
 *
 *   vec3 L = effects_emitted(e, mask, b, a, x, &s)     of the face it has met
 *   vec3 L = effects_nothing(e, mask, b)               of what is behind everything
 *
 *   the ray comes from             and what it meets counts
 *   the eye, a mirror, glass       fully: no shadow ray could have found it
 *   a lobe                         by (24.9), if there are shadow rays, too; else fully
 *   a matte surface                by (24.9), if there are shadow rays; else not at all: lamps
 *                                  and sky light surfaces only where that effect is simulated
 *
 * A background is for the eye, also in mirrors; after a matte bounce it is black: it lights nobody.
 */
#ifndef EFFECTS_MET_H
#define EFFECTS_MET_H

#include "gather.h"

/* ---------------------------------------------------------------------------------------------- */

/* Light that the ray itself has met; q: the pdf with which a shadow ray would have. `by`: the
 * effect whose shadow rays these are. */
__attribute__((always_inline))
static inline real effects_found(const unsigned mask, const branch *b, unsigned by, real q)
{
    if (!(b->pdf < real_infinity)) return 1;
    if (b->kind == RAY_SCATTERED && !(mask & by)) return 0;
    return mask & by ? mis_power(b->pdf, q) : 1;
}

/* Nothing is met. After a bounce a background is no light. */
__attribute__((always_inline))
static inline vec3 effects_nothing(const effects_stage *e, const unsigned mask, const branch *b)
{
    const effects_sky *s = e->sky.s;
    vec3 L = sky_radiance(s, b->r.d);
    if (s->kind == SKY_NONE) {
        if (b->bounced) return (vec3){0, 0, 0};
    } else if (mask & (EFFECT_INDIRECT | EFFECT_GLOSSY))
        L = vscale(L, effects_found(mask, b, EFFECT_ENVIRONMENT,
                                    b->pdf < real_infinity
                                        ? sky_light_pdf(&e->sky, b->r.d, b->cosine) : 0));
    if (mask & EFFECT_ABSORPTION)  /* an endless way through what absorbs */
        L = vmul(L, absorbed(e->media[media_fills(e->media, &b->in)].absorb, real_infinity));
    return L;
}

__attribute__((always_inline))
static inline vec3 effects_emitted(const effects_stage *e, const unsigned mask, const branch *b,
                                   const appearance *a, studio_hit x, const surface *s)
{
    vec3 L = a->emits;
    if (vzero(L) || !(mask & (EFFECT_INDIRECT | EFFECT_GLOSSY)) || !(b->pdf < real_infinity))
        return L;
    const shape *of = x.place == no_shape ? &e->s->shape[x.h.shape] : NULL;
    real q = lamps_pdf(&e->lamp, L, of, vmadd(b->r.o, b->r.d, -b->way), b->r.d, b->way + x.h.t,
                       fabs(vdot(s->n, b->r.d)));
    return vscale(L, effects_found(mask, b, EFFECT_SOFT_SHADOWS, q));
}

#endif
