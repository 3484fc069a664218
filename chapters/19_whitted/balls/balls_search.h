/* balls_search.h: rays against the lists of balls.h, as a search for whitted_walk.
 *
 *   balls_scene s = {.w = w, .b = b, .shadow = keep};      tracer.user = &s
 *   vec3 colour = balls_ray(&t, r, x, y)   as whitted_ray; (x, y): where the eye ray passes the
 *                                          picture that balls_view was told of
 *   bool balls_hit(&b, r, from, inside, &h)     closest hit of a ray that begins on ball `from`
 *   real balls_light(&b, r, k, from, keep)      part of light k that arrives
 *
 * No ball is asked that a list leaves out; whether one is hit decides 03, through ball_hit.h.
 * Towards a sun every ball is a disc: what is clear there needs no root.
 */
#ifndef WHITTED_BALLS_SEARCH_H
#define WHITTED_BALLS_SEARCH_H

#include "balls.h"

/* ---------------------------------------------------------------------------------------------- */

/* Of eye rays: k is the tile. The list is sorted by the nearest point of each ball. */
__attribute__((always_inline))
static inline bool balls_seen(const balls *b, ray r, size_t k, hit *best)
{
    hit h;
    *best = hit_none;
    for (uint32_t i = b->eye.first[k]; i < b->eye.first[k + 1]; i++) {
        uint32_t j = b->eye.item[i];
        if (b->near[j] > r.tmax) break;
        if (!ball_hit(&b->s[j], &r, &h) || (h.shape = j, !hit_before(h, *best))) continue;
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
        if (!ball_exit(&b->s[from], &r, best)) return false;
        best->shape = from;
        return true;
    }
    if (inside) from = no_shape;
    return ball_lanes_hit(&b->lanes, b->s, r, from, best);
}

/* Does the ray from p to the sun meet this disc? Across, p lies D = R^2 - u^2 - v^2 inside; along,
 * h above the centre: below it the ball is met if D > 0, above only from inside, D > h^2.
 *      1: yes; 0: no; -1: as near as rounding, ask 03
 * u, v, h are off by 8 epsilon S at most, S the size of all coordinates; so D and D - h^2 are by
 * 64 epsilon S^2. */
__attribute__((always_inline))
static inline int disc_shades(const ball_disc *m, real u, real v, real h, real reach)
{
    real S = m->size + reach, noise = 64 * real_epsilon * S * S;
    u -= m->u, v -= m->v, h -= m->l;
    real D = m->rr - (u * u + v * v), deep = h < 0 ? D : D - h * h;
    if (D < -noise || deep < -noise) return 0;
    return deep > noise ? 1 : -1;
}

/* Part of light k that arrives; shadow[j]: what ball j lets pass. */
__attribute__((always_inline))
static inline real balls_light(const balls *b, ray r, int k, uint32_t from, const real *shadow)
{
    const ball_beam *m = &b->beam[k];
    real u = vdot(r.o, m->u), v = vdot(r.o, m->v), at = vdot(r.o, m->l), lit = 1;
    real reach = surface_reach(r.o), slack = 32 * real_epsilon * reach;
    size_t x = (size_t)real_clamp((u - m->u0) * m->per_u, 0, balls_cells - 1);
    size_t y = (size_t)real_clamp((v - m->v0) * m->per_v, 0, balls_cells - 1);
    const uint32_t *list = &m->lists.first[y * balls_cells + x];
    hit h;
    if (!ball_outwards(&b->s[from], &r) && ball_hit(&b->s[from], &r, &h)) lit = shadow[from];
    for (uint32_t i = list[0]; i < list[1] && lit > 0; i++) {
        uint32_t j = m->lists.item[i];
        if (m->disc[j].end < at - slack) break;  /* sorted: all others, too, lie below */
        if (j == from) continue;
        int meets = disc_shades(&m->disc[j], u, v, at, reach);
        if (meets == 0 || (meets < 0 && !ball_hit(&b->s[j], &r, &h))) continue;
        lit *= shadow[j];
    }
    return lit > 0 ? lit : 0;
}

/* ---- as a search for whitted_walk: tracer.user is a balls_scene ------------------------------ */

typedef struct {
    whitted w;           /* first: where whitted_walk looks for it */
    balls b;
    const real *shadow;  /* [b.n] */
} balls_scene;

__attribute__((always_inline))
static inline bool balls_closest(tracer *t, ray_kind kind, ray r, uint32_t from, trace_hit *x)
{
    const balls_scene *s = t->user;
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
static inline void balls_surface(const tracer *t, const ray *r, const trace_hit *x, surface *s)
{
    const balls_scene *k = t->user;
    whitted_on_ball(&k->b.s[x->h.shape], x->h.shape, ray_at(*r, x->h.t), s);
}

static const whitted_search whitted_by_balls = {balls_closest, balls_lit, balls_surface};

static inline uint32_t balls_tile_of(const balls *b, real x, real y)
{
    return (uint32_t)y / balls_tile * (uint32_t)b->across + (uint32_t)x / balls_tile;
}

/* The colour along the eye ray through (x, y) of the picture that balls_view was told of. */
static inline vec3 balls_ray(tracer *t, ray r, real x, real y)
{
    const balls_scene *s = t->user;
    uint32_t tile = balls_tile_of(&s->b, x, y);
    return whitted_walk(t, r, (media_set){0}, tile, &whitted_by_balls, NULL);
}

#endif
