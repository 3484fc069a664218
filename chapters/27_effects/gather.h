/* gather.h: light that reaches a surface straight from lights, lamps and sky: by shadow rays, or
 * because a ray runs into it.
 *
 *   vec3 L = gather(&hit, mask)                       hit: a gather_hit, of radiance.h
 *   vec3 L = gather_emitted(e, mask, b, a, x, &s)     of the face that ray b has met
 *   vec3 L = gather_nothing(e, mask, b)               of what is behind everything, as L / n^2
 *   real nn = gather_square(e, mask, &in)             n^2 of what fills the place (19.11)
 *
 *   hard shadows   each point light and sun, as 24 has them: L = f cos Le w / per          (27.8)
 *   soft shadows   one point of one lamp, likewise
 *   environment    one direction of the sky, likewise; for a highlight one of its lobe beside it
 *
 * A lamp can be found by a shadow ray, and met by a ray that goes on. Where both are sent they
 * share each direction by the power heuristic (24.9); where not, w = 1. A highlight is a lobe, too
 * (23.13), but of lights alone: w = 1.
 *
 *   the ray comes from             and what it meets counts
 *   the eye, a mirror, glass       fully: no shadow ray could have found it
 *   a lobe, rough glass            by (24.9), if there are shadow rays, too; else fully
 *   a matte surface                by (24.9), if there are shadow rays; else not at all: lamps
 *                                  and sky light surfaces only where that effect is simulated
 *
 * No shadow ray to a light that is behind the surface, black, or of which nothing is reflected.
 * What lies in a body gets what its medium leaves of the light: (19.9), as 26.
 */
#ifndef EFFECTS_GATHER_H
#define EFFECTS_GATHER_H

#include "bodies.h"
#include "../24_direct_light/mis.h"
#include "../26_path_tracer/dielectric.h"
#include "dice.h"

/* A ray in hand: where it is, what it counts for, how it came to be. */
typedef struct {
    ray r;              /* d is unit */
    vec3 weight;
    media_set in;
    real pdf;           /* of r.d, if light samples could have found what it meets; else infinite */
    real cosine;        /* with the normal where it began */
    real way;           /* how far before r.o that was: through what is clear */
    int kind, depth;
    int passed;         /* faces with one medium on both sides, since it last changed its way */
    studio_face left;   /* it can't meet it: studio_tree.h */
    uint32_t node;      /* dice.h */
    bool bounced;       /* a matte surface lies behind it: what it meets is no picture, but light */
} branch;

/* A ray, the surface that it has met, facing it, and what that does with light, by part. */
typedef struct {
    const effects_stage *e;
    const branch *b;
    const dice *d;
    effects_counts *c;
    surface s;
    studio_face flat;   /* that s is of */
    real more;          /* touch.h */
    const appearance *a;        /* its material, */
    const material *k;          /* and what that is at this angle, by Fresnel */
    const rough_glass *facets;  /* of rough glass; NULL: of none */
    const media_set *behind;    /* what is in there */
} gather_hit;

/* ---------------------------------------------------------------------------------------------- */

/* What the medium that fills the place leaves of the light. */
static inline vec3 gather_left(const effects_stage *e, const media_set *in, real way)
{
    return absorbed(e->media[media_fills(e->media, in)].absorb, way);                  /* (19.9) */
}

/* n^2 of what fills the place: without refraction nobody knows what `in` is. */
fast_inline real gather_square(const effects_stage *e, const unsigned mask, const media_set *in)
{
    real n = mask & EFFECT_REFRACTION ? e->media[media_fills(e->media, in)].ior : 1;
    return n * n;
}

/* The bodies on the side of the surface that d leads to: in front, or behind rough glass. */
fast_inline const media_set *gather_in(const gather_hit *h, vec3 d)
{
    return h->facets && h->behind && vdot(h->s.n, d) < 0 ? h->behind : &h->b->in;
}

/* What of the light comes through where nothing bends it; bodies are crossed as by other rays, but
 * for the face of one that stands where the ray begins: `in` has it already. */
static inline vec3 gather_clear(const effects_stage *e, media_set in, ray r, bool absorbs,
                                effects_counts *c)
{
    vec3 left = {1, 1, 1}, end = ray_at(r, r.tmax);
    media_set after = in;
    for (int k = 0; k < stage_most_faces; k++, in = after) {
        studio_hit x;
        touch at = {.opaque.h.shape = no_shape};
        if (!studio_tree_hit(&e->t, r, &x))
            return absorbs ? vmul(left, gather_left(e, &in, r.tmax * vlength(r.d))) : left;
        const appearance *a = &e->look[studio_hit_material(&e->t, x)];
        surface s = studio_surface(&e->t, r, x);
        bool body = appearance_body(a), stands = false;
        if (body) touch_at(&e->t, e->look, e->near, false, r, x, &s, &at);
        if (at.opaque.h.shape != no_shape) stands = fabs(vdot(s.n, vsub(r.o, s.p))) <= at.more;
        if (body && !stands) c->lost += at.full, bodies_cross(e, &at.faces, &in, &after, c);
        if (absorbs) left = vmul(left, gather_left(e, &in, x.h.t * vlength(r.d)));
        uint32_t inside = media_fills(e->media, &in), to = media_fills(e->media, &after);
        if (vzero(a->m.through) || stage_bends(e, a, body, inside, to)) break;
        if (!body || inside != to) left = vmul(left, a->m.through);
        vec3 o = leave_point(s, r.d, at.more);
        if (r.tmax == real_infinity) r.o = o;
        else r = ray_between(o, end);
        if (vdot(vsub(end, o), s.n) * vdot(r.d, s.n) < 0) return left;  /* past the end */
        if (at.opaque.h.shape != no_shape && !stands) break;
    }
    return (vec3){0, 0, 0};
}

/* Does what begins or ends at p, near s, keep to one side of it? d: from p on. */
fast_inline bool gather_aside(const surface *s, vec3 p, vec3 d)
{
    return vdot(s->n, vsub(p, s->p)) * vdot(s->n, d) > 0;
}

/* Not `from` and the lamp, where leave_between (18) has both ends on the sides that see each
 * other. */
fast_inline world_but gather_but(const gather_hit *h, int kind, const lit_draw *x, ray r)
{
    studio_face from = studio_no_face, to = studio_no_face;
    if (gather_aside(&h->s, r.o, r.d)) from = h->flat;
    if (kind == RAY_TO_LAMP && gather_aside(&x->s, vadd(r.o, r.d), vneg(r.d)))
        to = h->e->lamp.lies_in[x->emitter];
    return studio_but(from, to);
}

/* False: nothing arrives. */
fast_inline bool gather_passes(const gather_hit *h, const unsigned mask, const lit_draw *x,
                               int kind, vec3 *left)
{
    ray r = lit_draw_ray(&h->s, x);
    bool absorbs = (mask & EFFECT_ABSORPTION) && (mask & EFFECT_REFRACTION);
    h->c->rays[kind]++;
    *left = (vec3){1, 1, 1};
    if ((mask & EFFECT_REFRACTION) && h->e->clear)
        return *left = gather_clear(h->e, *gather_in(h, r.d), r, absorbs, h->c), !vzero(*left);
    if (studio_tree_occluded_but(&h->e->t, &r, gather_but(h, kind, x, r))) return false;
    const media_set *in = gather_in(h, r.d);
    if (absorbs && in->n)  /* all the way in one medium */
        *left = gather_left(h->e, in, r.tmax * vlength(r.d));
    return true;
}

/* f cos w of all parts, for light from wi that was drawn with this pdf; another draw finds it for
 * the highlight with pdf q. */
fast_inline vec3 gather_reflects(const gather_hit *h, const unsigned mask, vec3 wi, real pdf,
                                 real q)
{
    const material *k = h->k;
    real c = vdot(h->s.ns, wi);
    real w = mask & EFFECT_INDIRECT ? mis_power(pdf, c / pi) : 1;
    vec3 sum = vscale(k->kd, c / pi * w);
    if (!vzero(k->ks)) {
        const brdf *lobe = &h->a->lobe;
        shading_frame f = shading_frame_of(h->s.ns);
        vec3 i = to_local(f, wi), o = to_local(f, vneg(h->b->r.d));
        real share = 0;
        if (h->a->glossy)
            share = mask & EFFECT_GLOSSY ? mis_power(pdf, brdf_pdf_local(lobe, i, o)) : 1;
        else if (vzero(k->mirror) || !(pdf < real_infinity)) share = mis_power(pdf, q);
        sum = vmadd(sum, vmul(vscale(k->ks, share), brdf_value_local(lobe, i, o)), c);
    }
    return sum;
}

/* The same of rough glass, by (23.24), from either side; *pdf: with which effects_facet would go
 * there, 0: it can't, or is not asked. A call, as bodies_cross. */
__attribute__((noinline))
static vec3 gather_facets(const gather_hit *h, const unsigned mask, vec3 wi, real *pdf)
{
    const rough_glass *g = h->facets;
    shading_frame f = shading_frame_of(h->s.ns);
    vec3 i = to_local(f, wi), o = to_local(f, vneg(h->b->r.d)), none = {0, 0, 0};
    bool through = i.z < 0;
    *pdf = 0;
    if ((vdot(h->s.n, wi) < 0) != through || (through && !(mask & EFFECT_REFRACTION))) return none;
    *pdf = rough_glass_pdf(g, i, o);
    real k = rough_glass_value(g, i, o) * fabs(i.z);
    return vscale(through ? h->a->m.through : h->a->m.mirror, k);
}

/* (27.8), of a light, a lamp or the sky. */
fast_inline vec3 gather_sample(const gather_hit *h, const unsigned mask, int kind,
                               const lit_draw *x, real q)
{
    vec3 v = {0, 0, 0}, left;
    if ((mask & EFFECT_GLOSSY) && h->facets) {
        real pdf;
        v = vmul(gather_facets(h, mask, x->wi, &pdf), x->Le);
        v = vscale(v, mis_power(x->pdf, pdf));
    } else if (vdot(h->s.ns, x->wi) > 0 && vdot(h->s.n, x->wi) > 0)
        v = vmul(gather_reflects(h, mask, x->wi, x->pdf, q), x->Le);
    if (vzero(v) && !(mask & EFFECTS_SPEND)) return v;
    bool passes = gather_passes(h, mask, x, kind, &left);
    if (!passes || vzero(v)) return (vec3){0, 0, 0};
    return vscale(vmul(v, left), 1 / x->per);
}

/* The highlight of a sky by a direction of its own lobe: one that is narrow no other draw of the
 * sky would find. A call, as bodies_cross. */
__attribute__((noinline))
static vec3 gather_highlight(const gather_hit *h, const unsigned mask)
{
    const effects_sky *sky = &h->e->s->sky;
    point2 u = dice_pair(h->d, h->b->node, h->b->depth, DICE_GLOSSY);  /* it has no such branch */
    gather_hit alone = *h;
    lit_draw x = {.far = true, .emitter = lit_dark};
    vec3 part, none = {0, 0, 0};
    const material k = {.ks = h->k->ks};
    alone.k = &k;
    if (!brdf_sample(&h->a->lobe, h->s.ns, vneg(h->b->r.d), u.u, u.v, &x.wi, &x.pdf, &part))
        return none;
    x.per = x.pdf, x.Le = sky->kind == SKY_NONE ? none : sky_radiance(sky, x.wi);
    return gather_sample(&alone, mask, RAY_TO_SKY, &x, sky_pdf(sky, x.wi, vdot(h->s.ns, x.wi)));
}

/* Light i, a point of a lamp, a direction of the sky; *q: the pdf of gather_highlight for that. */
fast_inline bool gather_draw(const gather_hit *h, const unsigned mask, int kind, size_t i,
                             bool shines, lit_draw *x, real *q)
{
    const studio *s = h->e->s;
    if (kind == RAY_TO_LIGHT) return lit_draw_light(&s->light[i].light, 1, h->s.p, x);
    point2 u = dice_pair(h->d, h->b->node, h->b->depth, kind == RAY_TO_LAMP ? DICE_LAMP : DICE_SKY);
    if (kind == RAY_TO_LAMP) return lamps_sample(&h->e->lamp, h->s.p, h->s.n, u, x);
    bool seen = sky_draw(&s->sky, h->s.ns, u, x);
    if ((mask & EFFECT_GLOSSY) && h->facets && !seen)  /* of a picture: what is behind */
        seen = s->sky.kind == SKY_IMAGE && sky_draw(&s->sky, vneg(h->s.ns), u, x);
    if (shines && seen) *q = brdf_pdf(&h->a->lobe, h->s.ns, x->wi, vneg(h->b->r.d));
    return seen;
}

/* One loop, so that gather_sample is compiled once: it is long. */
fast_inline vec3 gather(const gather_hit *h, const unsigned mask)
{
    vec3 sum = {0, 0, 0};
    lit_draw x = {.far = false};
    if (!(h->a->calls & EFFECTS_LIT) && !(mask & EFFECTS_SPEND)) return sum;
    size_t lights = mask & EFFECT_HARD_SHADOWS ? h->e->s->lights : 0;
    size_t lamp = lights + ((mask & EFFECT_SOFT_SHADOWS) && h->e->lamp.n);
    size_t sky = lamp + ((mask & EFFECT_ENVIRONMENT) != 0);
    bool shines = !h->a->glossy && !vzero(h->k->ks) && vzero(h->k->mirror);
    for (size_t i = 0; i < sky; i++) {
        int kind = i < lights ? RAY_TO_LIGHT : i < lamp ? RAY_TO_LAMP : RAY_TO_SKY;
        real q = 0;
        if (gather_draw(h, mask, kind, i, shines, &x, &q))
            sum = vadd(sum, gather_sample(h, mask, kind, &x, q));
    }
    if ((mask & EFFECT_ENVIRONMENT) && shines) sum = vadd(sum, gather_highlight(h, mask));
    return sum;
}

/* ---- what the ray itself has met ---- */

/* Light that the ray itself has met; q: the pdf with which a shadow ray would have. `by`: the
 * effect whose shadow rays these are. */
fast_inline real gather_found(const unsigned mask, const branch *b, unsigned by, real q)
{
    if (!(b->pdf < real_infinity)) return 1;
    if (b->kind == RAY_SCATTERED && !(mask & by)) return 0;
    return mask & by ? mis_power(b->pdf, q) : 1;
}

/* Nothing is met. A background is for the eye, also in mirrors: it lights nobody. */
fast_inline vec3 gather_nothing(const effects_stage *e, const unsigned mask, const branch *b)
{
    const effects_sky *s = &e->s->sky;
    vec3 L = sky_radiance(s, b->r.d);
    if (s->kind == SKY_NONE) {
        if (b->bounced) return (vec3){0, 0, 0};
    } else if (mask & (EFFECT_INDIRECT | EFFECT_GLOSSY))
        L = vscale(L, gather_found(mask, b, EFFECT_ENVIRONMENT, b->pdf < real_infinity
                                        ? sky_pdf(s, b->r.d, b->cosine) : 0));
    /* An endless way through what absorbs; without refraction nobody knows what `in` is. */
    if ((mask & EFFECT_ABSORPTION) && (mask & EFFECT_REFRACTION))
        L = vmul(L, gather_left(e, &b->in, real_infinity));
    return vscale(L, 1 / gather_square(e, mask, &b->in));
}

fast_inline vec3 gather_emitted(const effects_stage *e, const unsigned mask, const branch *b,
                                const appearance *a, studio_hit x, const surface *s)
{
    vec3 L = a->m.ke;
    if (vzero(L) || !(mask & (EFFECT_INDIRECT | EFFECT_GLOSSY)) || !(b->pdf < real_infinity))
        return L;
    const shape *of = x.place == no_shape ? &e->s->shape[x.h.shape] : NULL;
    real q = lamps_pdf(&e->lamp, L, of, vmadd(b->r.o, b->r.d, -b->way), b->r.d, b->way + x.h.t,
                       fabs(vdot(s->n, b->r.d)));
    return vscale(L, gather_found(mask, b, EFFECT_SOFT_SHADOWS, q));
}

#endif
