/* radiance.h: the light that comes along a ray, from ray casting to path tracing, as one function.
 *
 *   effects_path p = {.r = the eye's ray, .in = bodies that it begins in, .d = dice};
 *   effects_see(e, &p);                                what that meets; of neighbours in a row,
 *                                                      since these take the same ways in the tree
 *   vec3 L = effects_radiance(e, &p, mask, counts)     always inlined
 *
 * `mask` says which effects are simulated. Where the caller writes a constant (special.h), the
 * compiler drops all that belongs to the others.
 *
 *   a hit of weight w          emits + flat + gather (27.8), and goes on as
 *     mirror       w M         along the mirror direction
 *     glossy       w G f cos/p about it (23.13)
 *     indirect     w Kd        anywhere, by the cosine
 *     refraction   w T         through it, bent (19.4) or straight; in total reflection back
 *     rough glass  w M, w T    instead of these: off one facet or through it, as 26 (23.26); gather
 *                              finds lights on both sides of it (23.24)
 *
 *   M, G, T, Kd: appearance.h, times Fresnel's R or 1 - R where the material says so. Added up is
 *   L / n^2, which refraction leaves as it is (19.11): n^2 is asked for where light begins, and at
 *   the eye.
 *
 * All branches are followed, on a stack, no recursion. Which of them: each survives with q = min(1,
 * k max w), and counts for w / q (26.3). k is 2 where integrals are called for (26.4), and 32 for
 * what the eye sees sharply, in mirrors and glass: 1/32 of the light is enough, no noise there.
 * Without integrals k is 128, and a branch that survives brings a step of an 8-bit picture or two.
 * (19 cuts at 1/512: of the light through six plates of glass it loses more than a hundredth.)
 */
#ifndef EFFECTS_RADIANCE_H
#define EFFECTS_RADIANCE_H

#include "gather.h"
#include "../../common/headlight.h"
#include "../26_path_tracer/dielectric.h"
#include "../26_path_tracer/roulette.h"

/* ---------------------------------------------------------------------------------------------- */

/* Is a branch of this weight worth a ray? By chance: then what survives stands for the rest. */
fast_inline bool effects_follows(const gather_hit *h, const unsigned mask, dice_purpose purpose,
                                 vec3 *weight)
{
    vec3 w = *weight;
    if (vzero(w)) return (mask & EFFECTS_SPEND) != 0;
    bool sharp = purpose == DICE_SURVIVES_MIRROR || purpose == DICE_SURVIVES_REFRACTION;
    real q = roulette_within(w, sharp && !h->b->bounced ? h->e->keep_sharp : h->e->keep);
    if (q >= 1) return true;
    if (h->e->cuts || dice_number(h->d, h->b->node, purpose) >= q) return false;
    *weight = vscale(w, 1 / q);
    return true;
}

/* Field by field: a copy of the whole would wait for what was just written (19). Black weight: its
 * depth is the last. */
fast_inline void effects_child(const gather_hit *h, const unsigned mask, int kind, vec3 side,
                               vec3 d, vec3 weight, branch *c)
{
    const branch *b = h->b;
    c->r.o = leave_point(h->s, side, h->more), c->r.tmin = 0, c->r.d = d, c->r.tmax = real_infinity;
    c->weight = weight, c->pdf = real_infinity, c->cosine = 1;
    if (mask & EFFECT_REFRACTION) c->in = b->in;
    c->kind = kind, c->depth = b->depth + 1, c->node = dice_child(b->node, (uint32_t)kind);
    c->bounced = b->bounced, c->passed = 0, c->way = 0;
    c->left = vdot(side, d) > 0 ? h->flat : studio_no_face;
    if ((mask & EFFECTS_SPEND) && vzero(weight)) c->depth = stage_most_depth;
}

/* It goes on as it came: what it meets is weighted as if nothing had been in its way, since nothing
 * is in that of a shadow ray. */
fast_inline void effects_straight_on(const gather_hit *h, branch *c)
{
    c->pdf = h->b->pdf, c->cosine = h->b->cosine;
    c->way = h->b->way + vlength(vsub(h->s.p, h->b->r.o));
}

/* Rays about the mirror direction or anywhere: RAY_GLOSSY, RAY_SCATTERED. */
fast_inline int effects_spread(const gather_hit *h, const unsigned mask, int kind, vec3 colour,
                               branch *c)
{
    vec3 weight = vmul(h->b->weight, colour), wi, part = {1, 1, 1};
    bool glossy = kind == RAY_GLOSSY;
    if (!effects_follows(h, mask, glossy ? DICE_SURVIVES_GLOSSY : DICE_SURVIVES_INDIRECT, &weight))
        return 0;
    shading_frame f = shading_frame_of(h->s.ns);
    point2 u = dice_pair(h->d, h->b->node, h->b->depth, glossy ? DICE_GLOSSY : DICE_INDIRECT);
    real pdf;
    if (glossy) {
        vec3 wo = to_local(f, vneg(h->b->r.d));
        if (!brdf_sample_local(&h->a->lobe, wo, u.u, u.v, &wi, &pdf, &part)) return 0;
    } else wi = sample_cosine(u.u, u.v), pdf = pdf_cosine(wi);
    real cosine = wi.z;
    wi = to_world(f, wi);
    if (!(vdot(h->s.n, wi) > 0) || !(pdf > 0)) return 0;
    effects_child(h, mask, kind, h->s.n, wi, vmul(weight, part), c);
    c->pdf = pdf, c->cosine = cosine;
    if (!glossy) c->bounced = true;
    return 1;
}

/* Through the surface; back where all is reflected. */
fast_inline int effects_through(const gather_hit *h, const unsigned mask, const snell *x,
                                bool bends, branch *c)
{
    vec3 weight = vmul(h->b->weight, h->k->through), on = h->b->r.d, n = h->s.n;
    bool back = bends && x->total;
    if (!effects_follows(h, mask, DICE_SURVIVES_REFRACTION, &weight)) return 0;
    vec3 side = back ? n : vneg(n);
    if (bends) on = lifted(back ? reflect(on, h->s.ns) : snell_refract(x, on, h->s.ns), side);
    effects_child(h, mask, RAY_REFRACTED, side, on, weight, c);
    if (!bends) effects_straight_on(h, c);
    if (h->behind && !back) c->in = *h->behind;
    return 1;
}

/* Rough glass: a facet, and one of its two ways (26), glossy or, where that is simulated, through.
 * Shadow rays find the same, but not the half of an even sky that is behind: there cosine is 0. A
 * call, as bodies_cross. */
__attribute__((noinline))
static int effects_facet(const gather_hit *h, const unsigned mask, branch *c)
{
    random_stream s = dice_stream(h->d, h->b->node);
    vec3 wi, n = h->s.n;
    bool through;
    real power, pdf;
    if (!dielectric_rough(*h->facets, h->s.ns, vneg(h->b->r.d), &s, &wi, &through, &power)
        || (vdot(wi, n) < 0) != through || (through && !(mask & EFFECT_REFRACTION))) return 0;
    vec3 weight = vmul(h->b->weight, vscale(through ? h->a->m.through : h->a->m.mirror, power));
    if (!effects_follows(h, mask, DICE_SURVIVES_GLOSSY, &weight)) return 0;
    effects_child(h, mask, through ? RAY_REFRACTED : RAY_GLOSSY, through ? vneg(n) : n, wi, weight,
                  c);
    if (through && h->behind) c->in = *h->behind;
    gather_facets(h, mask, wi, &pdf);
    if (pdf > 0) c->pdf = pdf, c->cosine = real_max(vdot(h->s.ns, wi), 0);
    return 1;
}

/* The material at this angle: itself, or with Fresnel *k, of which the colours are set (gcc copies
 * the whole word by word). x is set if it bends. */
fast_inline const material *effects_angle(const gather_hit *h, const unsigned mask,
                                          const snell *x, bool bends, material *k)
{
    const material *m = &h->a->m;
    if (!h->a->fresnel) return m;
    real cosine = real_min(1, fabs(vdot(h->s.ns, h->b->r.d)));
    k->kd = m->kd, k->ks = m->ks, k->mirror = m->mirror, k->through = m->through;
    if ((mask & EFFECT_GLOSSY) && m->alpha > 0) {  /* for effects_facet */
        k->mirror = k->through = (vec3){0, 0, 0};
    } else if (vzero(m->through)) {
        vec3 F = fresnel_schlick(h->a->glossy ? m->ks : m->mirror, cosine);
        if (h->a->glossy) k->ks = F;
        else k->mirror = F;
        k->kd = vmul(k->kd, vrest(F));
    } else if (bends || !(mask & EFFECT_REFRACTION)) {  /* left out by --effects: Schlick's R */
        real q = (1 - m->inside.ior) / (1 + m->inside.ior), f0 = q * q;
        real R = bends ? fresnel(x) : fresnel_schlick((vec3){f0, f0, f0}, cosine).x;
        k->mirror = vscale(k->mirror, R), k->ks = vscale(k->ks, R);
        k->through = vscale(k->through, 1 - R), k->kd = vscale(k->kd, 1 - R);
    }
    return k;
}

/* Black ones (EFFECTS_SPEND) behind the others: they are traced at once and never wait. */
static inline int effects_black_last(branch child[4], int n)
{
    branch black[4];
    int kept = 0, b = 0;
    for (int i = 0; i < n; i++)
        if (vzero(child[i].weight)) black[b++] = child[i];
        else child[kept++] = child[i];
    memcpy(child + kept, black, (size_t)b * sizeof *black);
    return n;
}

/* Its children, the one to be traced first last. */
fast_inline int effects_children(const gather_hit *h, const unsigned mask, const snell *x,
                                 bool bends, branch child[4])
{
    const unsigned calls = mask & EFFECTS_SPEND ? mask : mask & h->a->calls;
    const vec3 black = {0, 0, 0};
    int n = 0;
    if (calls & EFFECT_INDIRECT) n += effects_spread(h, mask, RAY_SCATTERED, h->k->kd, child);
    if ((calls & EFFECT_GLOSSY) && h->facets) n += effects_facet(h, mask, &child[n]);
    else if (calls & EFFECT_GLOSSY)
        n += effects_spread(h, mask, RAY_GLOSSY, h->a->glossy ? h->k->ks : black, &child[n]);
    if (calls & EFFECT_MIRROR) {
        vec3 weight = vmul(h->b->weight, h->k->mirror);
        if (effects_follows(h, mask, DICE_SURVIVES_MIRROR, &weight))
            effects_child(h, mask, RAY_MIRRORED, h->s.n,
                          lifted(reflect(h->b->r.d, h->s.ns), h->s.n), weight, &child[n++]);
    }
    if (calls & EFFECT_REFRACTION) n += effects_through(h, mask, x, bends, &child[n]);
    return mask & EFFECTS_SPEND ? effects_black_last(child, n) : n;
}

/* What a ray has met: place and surface, its material; where it is glass, how much farther away the
 * next ray begins (touch.h), the bodies behind it and whose medium fills them. */
typedef struct {
    studio_hit x;
    uint32_t m, to;
    surface s;
    real more;
} effects_met;

/* Through all faces that lie where glass was met, and the roughest of them gives its material.
 * False: one of them is opaque, and that is what was met. A call, as bodies_cross. */
__attribute__((noinline))
static bool effects_cross(const effects_stage *e, bool always, branch *b, effects_met *met,
                          media_set *after, effects_counts *c)
{
    touch at;
    touch_at(&e->t, e->look, e->near, always, b->r, met->x, &met->s, &at);
    met->more = at.more, c->contacts += at.asked, c->lost += at.full;
    for (const media_face *k = at.faces.face; k < at.faces.face + at.faces.n; k++)
        if (k->in != k->out && e->look[k->body - 1].m.alpha > e->look[met->m].m.alpha)
            met->m = k->body - 1;
    if (at.opaque.h.shape == no_shape)
        return met->to = bodies_cross(e, &at.faces, &b->in, after, c), true;
    at.opaque.h.t = met->x.h.t, met->x = at.opaque, met->s = at.on;
    met->m = studio_hit_material(&e->t, met->x);
    return false;
}

/* One ray, which has found *there or nothing: adds what it brings to *sum; how many children.
 * Structs are read and written field by field: as effects_child. */
fast_inline int effects_step(const effects_stage *e, const unsigned mask, branch *b, bool found,
                             const studio_hit *there, vec3 *sum, branch child[4], const dice *d,
                             effects_counts *c)
{
    const hit *t = &there->h;
    studio_hit x = {{t->t, t->u, t->v, t->shape}, there->place};
    c->rays[b->kind]++;
    if (!found) {
        *sum = vadd(*sum, vmul(b->weight, gather_nothing(e, mask, b)));
        return 0;
    }
    uint32_t m = studio_hit_material(&e->t, x), inside = 0, to = 0;
    surface s = studio_surface(&e->t, b->r, x);
    real more = 0;
    media_set after;
    bool body = (mask & EFFECT_REFRACTION) && appearance_body(&e->look[m]);
    if (body) {
        effects_met met = {x, m, to, surface_copy(&s), 0};
        body = effects_cross(e, (mask & EFFECTS_SPEND) != 0, b, &met, &after, c);
        x = met.x, m = met.m, to = met.to, s = surface_copy(&met.s), more = met.more;
    }
    const appearance *a = &e->look[m];
    gather_hit h;
    h.e = e, h.b = b, h.d = d, h.c = c, h.a = a, h.more = more;
    h.s = surface_copy(&s);
    if (mask & EFFECT_REFRACTION) inside = media_fills(e->media, &b->in);
    if ((mask & EFFECT_ABSORPTION) && ((mask & EFFECTS_SPEND) || !vzero(e->media[inside].absorb))) {
        c->rays[RAY_ABSORBED]++;
        real way = x.h.t - b->r.tmin;  /* nothing before that: `hither` */
        b->weight = vmul(b->weight, absorbed(e->media[inside].absorb, way));           /* (19.9) */
    }
    const real n1 = e->media[inside].ior;  /* of air, 1, where nobody knows */
    const vec3 basic = vscale(b->weight, 1 / (n1 * n1));
    real turn = vdot(h.s.n, b->r.d) > 0 ? -1 : 1;  /* surface_facing */
    h.s.n = vscale(h.s.n, turn), h.s.ns = vscale(h.s.ns, turn);
    h.flat = studio_flat_face(&e->t, x);
    snell at = {1, 1, 1, 1, false};
    bool bends = body && stage_bends(e, a, body, inside, to);
    if (bends) snell_of(b->r.d, h.s.ns, e->media[inside].ior, e->media[to].ior, &at);
    vec3 L = gather_emitted(e, mask, b, a, x, &h.s);
    if (body && to == inside) {  /* one medium on both sides: no surface, but it may shine */
        *sum = vadd(*sum, vmul(basic, L));
        if (b->passed == stage_most_faces) return 0;
        effects_child(&h, mask, b->kind, vneg(h.s.n), b->r.d, b->weight, child);
        if (!bends) effects_straight_on(&h, child);
        child->in = after, child->depth = b->depth, child->passed = b->passed + 1;
        return 1;
    }
    material angle;
    h.k = effects_angle(&h, mask, &at, bends, &angle);
    rough_glass facets;
    h.facets = NULL, h.behind = body ? &after : NULL;
    if ((mask & EFFECT_GLOSSY) && a->m.alpha > 0) {
        facets = (rough_glass){a->m.alpha, bends ? e->media[inside].ior : 1,
                               bends ? e->media[to].ior : a->m.inside.ior};
        h.facets = &facets;
        h.s.error += h.more, h.more = 0;  /* for shadow rays, too */
    }
    if (!b->bounced) {
        L = vadd(L, a->flat);
        if (e->headlight)
            L = vadd(L, vmul(vadd(h.k->kd, h.k->ks), headlight(h.s.ns, b->r.d)));
    }
    /* Its children before its shadow rays: how they end is a toss, and while a processor makes good
     * a wrong guess, what is needed next is there already. */
    int n = 0;
    if ((mask & (EFFECTS_WHITTED | EFFECT_GLOSSY | EFFECT_INDIRECT)) && b->depth < e->depth)
        n = effects_children(&h, mask, &at, bends, child);
    if (mask & EFFECTS_LIT) L = vadd(L, gather(&h, mask));
    *sum = vadd(*sum, vmul(basic, L));
    return n;
}

/* A path: its ray in hand, and what that has met; the bodies that it began in. */
typedef struct {
    ray r;
    studio_hit x;
    bool met;
    media_set in;
    dice d;
} effects_path;

static inline void effects_see(const effects_stage *e, effects_path *p)
{
    p->r = ray_unit(p->r);
    p->met = studio_tree_hit_but(&e->t, &p->r, world_but_none, &p->x);
}

/* The children of a hit are written beside it, so that the next is at hand without being copied. Of
 * each level at most three wait, and all together weigh, on average, no more than the eye's ray:
 * what would be one too many is dropped. */
fast_inline vec3 effects_radiance(const effects_stage *e, effects_path *p, const unsigned mask,
                                  effects_counts *c)
{
    branch stack[stage_most_waiting], slot[2][4], *b = &slot[0][0];
    vec3 sum = {0, 0, 0};
    int top = 0, other = 1;
    b->r = p->r, b->weight = (vec3){1, 1, 1}, b->in = p->in, b->pdf = real_infinity;
    b->cosine = 1, b->way = 0, b->kind = RAY_OF_EYE, b->depth = 1, b->passed = 0, b->node = 0;
    b->left = studio_no_face, b->bounced = false;
    for (;;) {
        int n = effects_step(e, mask, b, p->met, &p->x, &sum, slot[other], &p->d, c);
        for (int i = 0; i + 1 < n && top < stage_most_waiting; i++)
            stack[top++] = slot[other][i];
        if (n + top == 0) return vscale(sum, gather_square(e, mask, &p->in));
        b = n ? &slot[other][n - 1] : &stack[--top];
        other ^= n > 0;
        p->met = studio_tree_hit_but(&e->t, &b->r, studio_but(b->left, studio_no_face), &p->x);
    }
}

#endif
