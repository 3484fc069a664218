/* whitted_place.h: where a ray of the tree ends: on what, inside of which bodies, in what light.
 *
 *   tracer t = {.w = &world, .program = whitted_programs, .user = &w};    w: a `whitted`
 *   whitted_find(&t, &b, &p)        the next face that matters. False: none, it ends in the sky
 *   vec3 L = whitted_sky(&w, &b)    what is seen there, as L / n^2
 *   vec3 L = whitted_shade(&t, &b, &p)     (18.8), where glass dims shadow rays, as L / n^2
 *   real nn = whitted_square(&w, &in)      n^2 of what fills the place
 *
 * Light that goes into glass is squeezed into a smaller solid angle, and its radiance becomes
 * n2^2 / n1^2 of what it was; on the way out it becomes less again. So L / n^2, the basic radiance
 * (基本辐亮度), is what refraction leaves as it is, and what the tree of rays adds up: n^2 is asked for
 * only where light begins, and at the eye.                                                (19.11)
 *
 * More bodies than media.h holds end the program: exit 2, a message.
 *
 * A face with the same medium on both sides is none: whitted_find goes on through it. All that it
 * knows of glass that touches glass is in contact.h, all of nested bodies in media.h; p.left is
 * what the media on the way did not absorb (19.9).
 */
#ifndef WHITTED_PLACE_H
#define WHITTED_PLACE_H

#include "contact.h"

/* One ray of the tree. */
typedef struct {
    ray r;              /* d is unit */
    vec3 weight;        /* what its light is worth at the eye; */
    vec3 share;         /* at the hit that it came from */
    media_set in;       /* the bodies that it begins in; where it ends, as far as that tells */
    int depth;
    ray_kind kind;
    world_face left;    /* it can't meet it */
    int number;         /* of this ray, for the log; before that, of the one that it came from */
} whitted_branch;

typedef struct {
    surface s;                  /* faces the ray */
    const whitted_look *m;  /* perhaps `room` */
    whitted_look room;
    uint32_t inside, beyond;    /* bodies that fill the place before and behind */
    media_set after;            /* of glass: what is refracted is in there */
    real more;                  /* contact.h */
    world_face face;            /* that s is of, if what leaves it can't meet it again */
    vec3 left;                  /* share that the way here let through */
} whitted_place;

/* ---------------------------------------------------------------------------------------------- */

/* Glass dims the light, and does not bend it: a shadow ray has no other way to go. */
static inline any_hit_answer whitted_dims(const tracer *t, ray r, trace_hit x, void *payload)
{
    const whitted *w = t->user;
    whitted_look room;
    surface s = surface_of_trace(t, r, x);
    *(real *)payload *= w->material_of(w->context, &x, &s, &room)->shadow;
    return *(real *)payload > 0 ? ANY_HIT_IGNORE : ANY_HIT_END;
}

static const ray_program whitted_programs[ray_kinds] = {
    [RAY_CAMERA] = {MASK_SEEN, false, NULL, NULL, NULL},
    [RAY_SHADOW] = {MASK_SHADOW, true, whitted_dims, NULL, NULL},
    [RAY_REFLECTION] = {MASK_SEEN, false, NULL, NULL, NULL},
    [RAY_REFRACTION] = {MASK_SEEN, false, NULL, NULL, NULL},
    [RAY_SIGHT] = {MASK_SEEN, false, contact_any, NULL, NULL},
};

static inline real whitted_square(const whitted *w, const media_set *in)
{
    real n = w->media[media_fills(w->media, in)].ior;
    return n * n;
}

/* Through an endless medium: what it does not absorb. */
static inline vec3 whitted_sky(const whitted *w, const whitted_branch *b)
{
    vec3 sky = w->sky ? w->sky(w->context, b->r.d) : w->background;
    vec3 left = absorbed(w->media[media_fills(w->media, &b->in)].absorb, real_infinity);
    return vscale(vmul(left, sky), 1 / whitted_square(w, &b->in));
}

/* (18.8), as shade() of 18; v is unit. */
static inline vec3 whitted_shade(tracer *t, const whitted_branch *b, const whitted_place *p)
{
    const whitted *w = t->user;
    const material *m = &p->m->base;
    const surface *s = &p->s;
    vec3 colour = vmadd(m->ke, vmul(w->ambient, m->kd), 1);
    bool reflects = material_reflects(m);
    vec3 from = leave_side(s, s->n, 0);  /* a light that counts is in front */
    for (int i = 0; i < w->n && (reflects || w->spend_all); i++) {
        const light *L = &w->lights[i];
        light_sample x = {{0, 0, 0}, {0, 0, 0}};
        bool counts = reflects && light_reaches(L, s->p, s->n, s->ns, &x);
        if (!counts && !w->spend_all) continue;
        ray r = L->kind == LIGHT_POINT ? ray_between(from, L->at) : ray_from(from, L->at);
        real lit = 1;
        trace_hit any;
        world_but but = world_left(counts ? p->face : world_no_face);
        if (trace_find(t, RAY_SHADOW, but, &r, &lit, &any)) lit = 0;
        if (w->log)
            w->log->add(w->log, RAY_SHADOW, b->number, b->depth, r, r.tmax, b->weight, lit);
        if (counts && lit > 0)
            colour = vmadd(colour, blinn_phong(m, s->ns, x.l, vneg(b->r.d), x.E), lit);
    }
    return vscale(colour, 1 / whitted_square(w, &b->in));
}

/* The face that x is on, and all that lie there with it. Which side of a body the ray comes from is
 * asked of the geometric normal, before it is turned to the ray. */
static inline void whitted_arrive(tracer *t, whitted_branch *b, const trace_hit *x,
                                  whitted_place *p)
{
    const whitted *w = t->user;
    surface s = surface_of_trace(t, b->r, *x);
    p->m = w->material_of(w->context, x, &s, &p->room);
    p->more = 0;
    if (p->m->body) {
        media_crossing c = {0};
        media_crossing_add(&c, p->m->body, vdot(s.n, b->r.d) < 0 ? 1 : -1);
        if (!w->apart) p->more = contact_find(t, b->r, *x, &s, &p->m, &p->room, &c);
        if (p->m->body) {
            bool room = media_begin(&b->in, &c);
            p->after = b->in;
            if (!room || !media_cross(&p->after, &c))
                die(2, "more than %d bodies of glass lie around one another", media_most);
            p->beyond = media_fills(w->media, &p->after);
        }
    }
    p->inside = media_fills(w->media, &b->in);
    p->s = surface_facing(surface_copy(&s), b->r.d);
    p->face = p->more > 0 || trace_may_return(t, x, &p->s) ? world_no_face
                                                           : world_face_of(t->w, x);
}

static inline bool whitted_find(tracer *t, whitted_branch *b, whitted_place *p)
{
    const whitted *w = t->user;
    const real end = b->r.tmax;
    for (p->left = (vec3){1, 1, 1};;) {
        trace_hit x;
        bool met = trace_find(t, b->kind, world_left(b->left), &b->r, NULL, &x);
        b->r.tmax = end;
        if (w->log) b->number = w->log->add(w->log, b->kind, b->number, b->depth, b->r,
                                            met ? x.h.t : real_infinity,
                                            vmul(b->weight, p->left), 0);
        if (!met) return false;
        whitted_arrive(t, b, &x, p);
        vec3 sigma = w->media[p->inside].absorb;
        if (!vzero(sigma)) p->left = vmul(p->left, absorbed(sigma, x.h.t));             /* (19.9) */
        if (!p->m->body || p->beyond != p->inside) return true;
        b->r.o = leave_side(&p->s, vneg(p->s.n), p->more), b->in = p->after;  /* no interface */
    }
}

#endif
