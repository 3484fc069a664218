/* balls_search.h: rays against the lists of balls.h, as a search for whitted_walk.
 *
 *   balls_scene s = {.w = w, .b = b, .shadow = keep};      tracer.user = &s
 *   vec3 colour = balls_ray(&t, r, x, y)   as whitted_ray; (x, y): where the eye ray passes the
 *                                          picture that balls_view was told of
 *   bool balls_hit(&b, r, from, inside, &h)     closest hit of a ray that begins on ball `from`
 *   real balls_light(&b, r, k, from, keep)      part of light k that arrives
 *
 * No ball is asked that a list leaves out; whether one is hit decides 03, but for two clear cases:
 * the ball lies behind the ray, and the far side of the ball that the ray is in.
 */
#ifndef BALLS_SEARCH_H
#define BALLS_SEARCH_H

#include "balls.h"

/* ---------------------------------------------------------------------------------------------- */

/* True only if the ray, d unit, certainly passes: the ball lies behind it, o outside. */
__attribute__((always_inline))
static inline bool ball_behind(const sphere *s, const ray *r)
{
    vec3 f = vsub(r->o, s->c);
    real ff = vdot(f, f), rr = s->r * s->r;
    return vdot(f, r->d) >= 0 && ff - rr > 16 * real_epsilon * (ff + rr);
}

/* Of a ray that leaves ball s outwards, or begins inside and is to leave it. */
__attribute__((always_inline))
static inline bool ball_outwards(const sphere *s, const ray *r)
{
    return vdot(vsub(r->o, s->c), r->d) > 0;
}

/* The far root alone, from inside: t1 of 03, by (3.5) and (3.3). */
__attribute__((always_inline))
static inline bool ball_exit(sphere s, ray r, hit *out)
{
    double dx = (double)r.d.x, fx = (double)r.o.x - (double)s.c.x, R = (double)s.r;
    double dy = (double)r.d.y, fy = (double)r.o.y - (double)s.c.y;
    double dz = (double)r.d.z, fz = (double)r.o.z - (double)s.c.z;
    double x = dy * fz - dz * fy, y = dz * fx - dx * fz, z = dx * fy - dy * fx;
    double a = dx * dx + dy * dy + dz * dz, b = -(dx * fx + dy * fy + dz * fz);
    double arr = a * (R * R), D = arr - (x * x + y * y + z * z);
    if (!(b >= 0 && D > arr * 0x1p-26)) return sphere_hit(s, r, out);
    *out = (hit){(real)((b + sqrt(D)) / a), 0, 0, 0};
    return true;
}

typedef struct { const balls *b; uint32_t from; } balls_asking;  /* from: left outwards */

__attribute__((always_inline))
static inline bool balls_leaf(const void *context, uint32_t first, uint32_t count, query *q,
                              bool any)
{
    const balls_asking *a = context;
    const balls *b = a->b;
    bool found = false;
    hit h;
    for (uint32_t i = first; i < first + count; i++) {
        if (b->leaf[i].index == a->from || ball_behind(&b->leaf[i].s, &q->r)) continue;
        if (!sphere_hit(b->leaf[i].s, q->r, &h)) continue;
        if (any) return true;
        h.shape = b->leaf[i].index;
        found |= query_improves(q, h);
    }
    return found;
}

/* Of eye rays: k is the tile. The list is sorted by the nearest point of each ball. */
__attribute__((always_inline))
static inline bool balls_seen(const balls *b, ray r, size_t k, hit *best)
{
    hit h;
    *best = hit_none;
    for (uint32_t i = b->eye.first[k]; i < b->eye.first[k + 1]; i++) {
        uint32_t j = b->eye.item[i];
        if (b->near[j] > r.tmax) break;
        if (!sphere_hit(b->s[j], r, &h) || (h.shape = j, !hit_before(h, *best))) continue;
        *best = h, r.tmax = h.t;
    }
    return best->shape != no_shape;
}

/* from: the ball on which the ray begins, or no_shape; inside: it goes into it. */
__attribute__((always_inline))
static inline bool balls_hit(const balls *b, ray r, uint32_t from, bool inside, hit *best)
{
    *best = hit_none;
    if (inside && b->lone[from]) {
        if (!ball_exit(b->s[from], r, best)) return false;
        best->shape = from;
        return true;
    }
    if (b->lanes.n) return ball_lanes_hit(&b->lanes, b->s, r, inside ? no_shape : from, best);
    balls_asking a = {b, inside ? no_shape : from};
    return tree_search(&b->tree, r, box_ray_of, balls_leaf, &a, false, best, NULL);
}

__attribute__((always_inline))
static inline size_t beam_cell(const ball_beam *m, vec3 p)
{
    real u = real_clamp((vdot(p, m->u) - m->u0) * m->per_u, 0, balls_cells - 1);
    real v = real_clamp((vdot(p, m->v) - m->v0) * m->per_v, 0, balls_cells - 1);
    return (size_t)v * balls_cells + (size_t)u;
}

/* shadow[j]: part of the light that ball j lets pass. */
__attribute__((always_inline))
static inline real balls_light(const balls *b, ray r, int k, uint32_t from, const real *shadow)
{
    const ball_lists *m = &b->beam[k].lists;
    size_t cell = beam_cell(&b->beam[k], r.o);
    real lit = 1, at = vdot(r.o, b->beam[k].l), slack = 32 * real_epsilon * surface_reach(r.o);
    hit h;
    for (uint32_t i = m->first[cell]; i < m->first[cell + 1]; i++) {
        uint32_t j = m->item[i];
        const sphere *s = &b->s[j];
        if (b->beam[k].end[j] < at - slack) break;  /* sorted: all others, too, lie below */
        if ((j == from && ball_outwards(s, &r)) || ball_behind(s, &r)) continue;
        if (sphere_hit(*s, r, &h) && !((lit *= shadow[j]) > 0)) return 0;
    }
    return lit;
}

/* ---- as a search for whitted_walk: tracer.user is a balls_scene ------------------------------ */

typedef struct {
    whitted w;           /* first: where whitted_walk looks for it */
    balls b;
    const real *shadow;  /* [b.n] */
} balls_scene;

__attribute__((always_inline))
static inline bool balls_closest(tracer *t, ray_kind kind, ray r, uint32_t inside, uint32_t from,
                                 trace_hit *x)
{
    const balls_scene *s = t->user;
    (void)inside;
    t->counts.rays[kind]++;
    x->part = 0;
    bool met = kind == RAY_CAMERA
        ? balls_seen(&s->b, r, from, &x->h)
        : balls_hit(&s->b, r, from, !ball_outwards(&s->b.s[from], &r), &x->h);
    t->counts.hits[kind] += met;
    return met;
}

__attribute__((always_inline))
static inline real balls_lit(tracer *t, ray r, uint32_t from, int k)
{
    const balls_scene *s = t->user;
    t->counts.rays[RAY_SHADOW]++;
    real lit = balls_light(&s->b, r, k, from, s->shadow);
    t->counts.hits[RAY_SHADOW] += lit == 0;
    return lit;
}

__attribute__((always_inline))
static inline surface balls_surface(const tracer *t, ray r, trace_hit x)
{
    const balls_scene *s = t->user;
    return whitted_on_ball(s->b.s[x.h.shape], x.h.shape, ray_at(r, x.h.t));
}

static const whitted_search whitted_by_balls = {balls_closest, balls_lit, balls_surface};

/* The colour along the eye ray through (x, y) of the picture that balls_view was told of. */
static inline vec3 balls_ray(tracer *t, ray r, real x, real y)
{
    const balls_scene *s = t->user;
    uint32_t tile = (uint32_t)y / balls_tile * (uint32_t)s->b.across + (uint32_t)x / balls_tile;
    return whitted_walk(t, r, (media_set){0}, tile, &whitted_by_balls, NULL);
}

#endif
