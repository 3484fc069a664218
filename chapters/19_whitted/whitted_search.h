/* whitted_search.h: how whitted_walk searches a world of 18.
 *
 *   tracer t = {.program = whitted_programs, ..}     what whitted_by_trace needs
 *   whitted_by_trace            closest hits, light and surfaces by trace() of 18; a world of one
 *                               part of shapes by its tree, with what is known here of balls
 *   whitted_on_ball(&b, i, p, &s)                    surface_of_shape of 18, without a root
 *
 * What trace() does not know: on which shape a ray begins. A ball is convex: a ray that leaves it
 * outwards does not meet it again, and 03 would need twice the precision to say so.
 */
#ifndef WHITTED_SEARCH_H
#define WHITTED_SEARCH_H

#include "balls/ball_hit.h"
#include "contact.h"
#include "whitted_branch.h"

/* ---------------------------------------------------------------------------------------------- */

/* surface_of_shape of 18, for balls without a root: p is on the surface but for rounding, so that
 * (p - c) / R is nearly unit. Field by field: a copy of the whole struct would wait for what was
 * just written to it. */
__attribute__((always_inline))
static inline void whitted_on_ball(const sphere *b, uint32_t index, vec3 p, surface *s)
{
    vec3 f = vscale(vsub(p, b->c), 1 / b->r), n = unit_again(f);
    real y = vdot(f, f) - 1;
    if (!(y * y < real_epsilon / 4) || b->r < 0) {
        *s = surface_on_sphere(*b, index, p);
        return;
    }
    s->p = vmadd(b->c, n, b->r), s->n = n, s->ns = n;
    s->error = real_epsilon * (4 * b->r + 2 * surface_reach(s->p)), s->noise = 0, s->shape = index;
}

static inline void whitted_surface(const tracer *t, const ray *r, const trace_hit *x, surface *s)
{
    const world_part *p = &t->w->part[x->part];
    const shape *k = p->m ? NULL : &p->s->shapes[x->h.shape];
    if (!k || k->kind != SHAPE_SPHERE) *s = surface_of_trace(t, *r, *x);
    else whitted_on_ball(&k->sphere, x->h.shape, ray_at(*r, x->h.t), s);
}

static inline void whitted_remember(tracer *t, ray r, trace_hit x, void *payload)
{
    (void)t, (void)r;
    *(trace_hit *)payload = x;
}

/* Glass dims the light, and does not bend it: a shadow ray has no other way to go. */
static inline any_hit_answer whitted_dims(const tracer *t, ray r, trace_hit x, void *payload)
{
    const whitted *w = t->user;
    whitted_material room;
    surface s = surface_of_trace(t, r, x);
    *(real *)payload *= w->material_of(w->context, x, &s, &room)->shadow;
    return *(real *)payload > 0 ? ANY_HIT_IGNORE : ANY_HIT_END;
}

static const ray_program whitted_programs[ray_kinds] = {
    [RAY_CAMERA] = {MASK_SEEN, false, NULL, whitted_remember, NULL},
    [RAY_SHADOW] = {MASK_SHADOW, true, whitted_dims, NULL, NULL},
    [RAY_REFLECTION] = {MASK_SEEN, false, NULL, whitted_remember, NULL},
    [RAY_REFRACTION] = {MASK_SEEN, false, NULL, whitted_remember, NULL},
    [RAY_SIGHT] = {MASK_SEEN, false, contact_any, NULL, NULL},
};

/* A leaf of a tree of shapes. `lit`: of shadow rays, what is left of the light; else NULL. */
typedef struct { tracer *t; const bvh_shapes *b; uint32_t from; ray r; real *lit; } whitted_asking;

/* One shape; a ray that leaves a ball outwards does not meet it again. */
__attribute__((always_inline))
static inline bool whitted_meets(const shape *s, bool leaves, const query *q, hit *h)
{
    if (s->kind != SHAPE_SPHERE) return shape_hit_sheared(s, &q->shear, q->r, h);
    return !(leaves && ball_outwards(&s->sphere, &q->r)) && ball_hit(&s->sphere, &q->r, h);
}

__attribute__((always_inline))
static inline bool whitted_leaf(const void *context, uint32_t first, uint32_t count, query *q,
                                bool any)
{
    const whitted_asking *a = context;
    bool found = false;
    hit h;
    for (uint32_t i = first; i < first + count; i++) {
        uint32_t j = a->b->index[i];
        if (!whitted_meets(&a->b->shapes[j], j == a->from, q, &h)) continue;
        h.shape = j;
        if (!any) found |= query_improves(q, h);
        else if (whitted_dims(a->t, a->r, (trace_hit){h, 0}, a->lit) == ANY_HIT_END) return true;
    }
    return found;
}

/* The tree to be searched by whitted_leaf, or NULL: leave it to trace(). */
static inline const bvh_shapes *whitted_tree(const tracer *t, uint8_t mask)
{
    const world_part *p = t->w->part;
    bool ours = t->w->parts == 1 && p->s && (p->mask & mask) && t->program == whitted_programs;
    return ours ? &p->of_scene : NULL;
}

static inline bool whitted_closest(tracer *t, ray_kind kind, ray r, uint32_t from, trace_hit *x)
{
    const bvh_shapes *b = whitted_tree(t, MASK_SEEN);
    if (!b) return trace(t, kind, r, x);
    whitted_asking a = {t, b, from, r, NULL};
    x->part = 0;
    bool met = tree_search(&b->tree, r, box_ray_of, whitted_leaf, &a, false, &x->h, NULL);
    t->counts.rays[kind]++, t->counts.hits[kind] += met;
    return met;
}

static inline real whitted_lit(tracer *t, ray r, uint32_t from, int k)
{
    const bvh_shapes *b = whitted_tree(t, MASK_SHADOW);
    real lit = 1;
    (void)k;
    if (!b) return trace(t, RAY_SHADOW, r, &lit) ? 0 : lit;
    whitted_asking a = {t, b, from, r, &lit};
    bool met = tree_search(&b->tree, r, box_ray_of, whitted_leaf, &a, true, NULL, NULL);
    t->counts.rays[RAY_SHADOW]++, t->counts.hits[RAY_SHADOW] += met;
    return met ? 0 : lit;
}

static const whitted_search whitted_by_trace = {whitted_closest, whitted_lit, whitted_surface};

#endif
