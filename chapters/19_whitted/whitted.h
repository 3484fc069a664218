/* whitted.h: Whitted's ray tracing: trace and shade of 18, and shade traces on.
 *
 *   depth 1            eye ray                     What a ray brings back:
 *            \                                       L = shade (18.8) + M L(reflected)
 *   depth 2   o--- shadow rays                                 opaque: M, at every angle
 *            / \                                     L = e^(-a s) (R M L(reflected)
 *   depth 3 o   o   reflected, refracted                 + (1 - R) T L(refracted))  glass  (19.10)
 *          / \   \                                 R: fresnel.h; a, s: absorb.h
 *
 * Ray depth (光线深度) as the notes count it: the eye ray has depth 1, what it gives rise to 2, ...
 * Shadow rays have none. (19.10) is a recursion, and ends at a depth, or where a branch can no
 * longer contribute: each carries its weight, the product of the factors above it. Written as a
 * loop: a stack holds the branches still to be traced, at most one a level.
 *
 *   whitted w = {.lights = L, .n = 2, .material_of = f, .context = c, .media = m, .depth = 8};
 *   tracer t = {.w = &world, .program = whitted_programs, .user = &w};
 *   vec3 colour = whitted_ray(&t, r, in)      in: the bodies that the ray's origin is in
 *   t.counts.rays[RAY_REFLECTION] ..          what it took, by kind; RAY_SIGHT: contact.h
 *
 *   depth     at most so many rays behind one another [1..256]; what lies deeper is black
 *   least     a branch whose weight is nowhere more than this is cut [>= 0]: 0 cuts only those that
 *             are exactly 0
 *   apart     true: no glass touches or overlaps anything: then no contact rays are needed
 *   spend_all traces what cannot contribute, too: the same picture, to the last bit
 *
 * Only what is called for: no reflection ray from a black mirror or below least, no refraction ray
 * into what is opaque or in total reflection, no shadow ray to a light behind the surface (18).
 *
 * whitted_walk takes the search as an argument: whoever knows more of a scene than a tree does can
 * be faster and keep all the rest.
 *
 * Sources: T. Whitted, "An Improved Illumination Model for Shaded Display", CACM 23(6), 1980; R.
 * Hall, D. Greenberg, "A Testbed for Realistic Image Synthesis", IEEE CG&A 3(8), 1983 (adaptive
 * depth); T. Akenine-Möller et al., "Real-Time Rendering", 4th ed., 2018, section 26.1.
 */
#ifndef WHITTED_H
#define WHITTED_H

#include "whitted_search.h"

static inline vec3 whitted_ray(tracer *t, ray r, media_set in);

/* ---------------------------------------------------------------------------------------------- */

/* surface_facing of 18 without a branch: which side is seen is anybody's guess. */
__attribute__((always_inline))
static inline void whitted_face(surface *s, vec3 d)
{
    real side = vdot(s->n, d) > 0 ? -1 : 1;
    s->n = vscale(s->n, side), s->ns = vscale(s->ns, side);
}

/* light_reaches of 18; of a sun without the square root that makes its direction unit. */
__attribute__((always_inline))
static inline bool whitted_reaches(const light *L, const surface *s, light_sample *x)
{
    if (L->kind == LIGHT_POINT) return light_reaches(L, s->p, s->n, s->ns, x);
    real c = vdot(s->ns, L->at);
    *x = (light_sample){L->at, vscale(L->colour, real_max(c, 0))};
    return c > 0 && vdot(s->n, L->at) > 0 && !vzero(L->colour);
}

/* (18.8) with what glass lets through. s faces the eye; v unit, towards it. */
__attribute__((always_inline))
static inline vec3 whitted_shade(tracer *t, const whitted *w, const whitted_search *search,
                                 const surface *s, const material *m, vec3 v, whitted_log *log,
                                 const whitted_branch *b)
{
    vec3 colour = vmadd(m->ke, vmul(w->ambient, m->kd), 1);
    bool shiny = !vzero(m->ks), reflects = shiny || !vzero(m->kd);
    for (int i = 0; i < w->n && (reflects || w->spend_all); i++) {
        const light *L = &w->lights[i];
        light_sample x;
        bool counts = reflects && whitted_reaches(L, s, &x);
        if (!counts && !w->spend_all) continue;
        ray r = L->kind == LIGHT_POINT ? leave_to(*s, L->at) : leave(*s, L->at);
        real lit = search->lit(t, r, s->shape, i);
        if (log) log->add(log, RAY_SHADOW, b->number, b->depth, r, r.tmax, b->weight, lit);
        if (!counts || !(lit > 0)) continue;
        vec3 c = vscale(vmul(x.E, m->kd), 1 / pi);
        if (shiny) c = blinn_phong(m, s->ns, x.l, v, x.E);
        colour = vmadd(colour, c, lit);
    }
    return colour;
}

/* Where a branch ends. */
typedef struct {
    surface s;                  /* faces the ray */
    const whitted_material *m;  /* perhaps `room` */
    whitted_material room;
    uint32_t inside, to;        /* bodies that fill the place before and behind */
    media_set after;            /* of glass: what is refracted is in there */
    real more;                  /* contact.h */
} whitted_place;

/* p->s is there, and turned to the ray here. Which side of a body is asked of the geometric normal,
 * before it is turned. */
__attribute__((always_inline))
static inline void whitted_arrive(tracer *t, whitted_branch *b, const trace_hit *x,
                                  whitted_place *p)
{
    const whitted *w = t->user;
    p->m = w->material_of(w->context, *x, &p->s, &p->room);
    p->more = 0;
    if (p->m->body) {
        media_crossing c = {0};
        media_crossing_add(&c, p->m->body, vdot(p->s.n, b->r.d) < 0 ? 1 : -1);
        if (!w->apart) p->more = contact_find(t, b->r, *x, &p->s, &p->m, &p->room, &c);
        if (p->m->body) {
            b->in = media_before(b->in, &c), p->after = media_after(b->in, &c);
            p->to = media_fills(w->media, &p->after);
        }
    }
    p->inside = media_fills(w->media, &b->in);
    if (!vzero(w->media[p->inside].absorb))                                             /* (19.9) */
        b->weight = vmul(b->weight, absorbed(w->media[p->inside].absorb, x->h.t));
    whitted_face(&p->s, b->r.d);
}

/* A face between two places of the same medium is none: the ray goes on, no deeper. */
static inline bool whitted_passes(const whitted_place *p)
{
    return p->m->body && p->to == p->inside;
}

/* Is there anything for lights to do? */
static inline bool whitted_is_lit(const whitted *w, const whitted_place *p)
{
    const material *m = &p->m->base;
    if (whitted_passes(p)) return false;
    return material_reflects(m) || !vzero(m->ke) || (w->spend_all && !p->m->body);
}

/* What follows: 0 to 2 children; the last is traced first. */
__attribute__((always_inline))
static inline int whitted_follow(const whitted *w, const whitted_branch *b, const whitted_place *p,
                                 whitted_branch child[2])
{
    if (whitted_passes(p)) {
        whitted_child(b, &p->s, b->kind, vneg(p->s.n), b->r.d, b->weight, p->more, child);
        child->in = p->after, child->depth--;
        return whitted_follows(w, child->weight);
    }
    if (b->depth >= w->depth || b->depth >= whitted_most_depth) return 0;
    if (!p->m->body) return whitted_opaque(w, b, &p->s, p->m, child);
    return whitted_glass(w, b, &p->s, p->m, w->media[p->inside].ior, w->media[p->to].ior,
                         &p->after, p->more, child);
}

/* One branch: what it brings, into *colour, and its children. */
__attribute__((always_inline))
static inline int whitted_step(tracer *t, const whitted_search *search, whitted_branch *b,
                               vec3 *colour, whitted_branch child[2], whitted_log *log)
{
    const whitted *w = t->user;
    whitted_place p;
    trace_hit x;
    bool met = search->closest(t, b->kind, b->r, b->from, &x);
    if (log) b->number = log->add(log, b->kind, b->number, b->depth, b->r,
                                  met ? x.h.t : real_infinity, b->weight, 0);
    *colour = met ? (vec3){0, 0, 0} : whitted_nothing(w, b);
    if (!met) return 0;
    search->surface_of(t, &b->r, &x, &p.s);
    whitted_arrive(t, b, &x, &p);
    if (whitted_is_lit(w, &p))
        *colour = vmul(b->weight, whitted_shade(t, w, search, &p.s, &p.m->base, vneg(b->r.d), log,
                                                b));
    return whitted_follow(w, b, &p, child);
}

/* ray_unit of 01, without its second root where there is no interval to scale. */
__attribute__((always_inline))
static inline ray whitted_unit(ray r)
{
    real dd = vdot(r.d, r.d);
    if (r.tmin != 0 || r.tmax != real_infinity || !square_is_safe(dd)) return ray_unit(r);
    return (ray){r.o, 0, vscale(r.d, 1 / sqrt(dd)), r.tmax};
}

__attribute__((always_inline))
static inline void whitted_eye(ray r, const media_set *in, uint32_t from, whitted_branch *b)
{
    b->r = whitted_unit(r), b->weight = (vec3){1, 1, 1}, b->in = *in;
    b->depth = 1, b->kind = RAY_CAMERA, b->from = from, b->number = -1;
}

/* Summed level by level, as a search that traces one level after the other would. A face that is
 * none makes no new level. */
__attribute__((always_inline))
static inline vec3 whitted_walk(tracer *t, ray r, media_set in, uint32_t from,
                                const whitted_search *search, whitted_log *log)
{
    whitted_branch stack[whitted_most_depth + 2], slot[2][2], *b = &slot[0][0];
    vec3 level[whitted_most_depth + 1], c;
    int top = 0, other = 1, levels = 0;
    whitted_eye(r, &in, from, b);
    for (;;) {
        int n = whitted_step(t, search, b, &c, slot[other], log);
        if (b->depth > levels) level[levels++] = c;
        else level[b->depth - 1] = vadd(level[b->depth - 1], c);
        if (n == 2) stack[top++] = slot[other][0];
        if (n + top == 0) break;
        b = n ? &slot[other][n - 1] : &stack[--top];
        other ^= n > 0;
    }
    c = level[0];
    for (int k = 1; k < levels; k++) c = vadd(c, level[k]);
    return c;
}

static inline vec3 whitted_ray(tracer *t, ray r, media_set in)
{
    return whitted_walk(t, r, in, no_shape, &whitted_by_trace, NULL);
}

#endif
