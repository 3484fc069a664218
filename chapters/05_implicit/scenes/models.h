/* models.h: surfaces whose f is a distance (有向距离场, signed distance field), and unions that melt.
 *
 *   implicit_ball(&s)      |p - c| - R                                        s: a sphere of 03
 *   implicit_torus_distance(&k)   sqrt((sqrt(x^2 + y^2) - R)^2 + z^2) - r     the surface of
 *                          implicit_torus, by another f
 *   implicit_box(&k)       a box with round edges: the distance from the box  k.c, k.half, k.r
 *                          of half sides `half`, less r
 *   implicit_blend(&k)     a and b, melted where both are nearer than k.w:    k.a, k.b, k.w
 *                          m - (w - |a - b|)^2 / (4 w), m = min(a, b), where |a - b| < w, else m
 *
 *         ____
 *        /    \____/    the smooth union (平滑并集) lies at most w / 4 outside of the plain one, and
 *       |  a    .b  |   never inside of it
 *        \____/ \__/
 *
 * All keep a pointer to what is given. f of the first three is the distance to the surface: L = 1,
 * so that sphere tracing takes the longest steps. f of a blend is a bound of it: its gradient is a
 * mean of those of a and b, so that L is the larger of the two. Gradients are left to differences;
 * on the edges of a distance there is none, and the normal is whatever the differences say.
 *
 * Sources: J. Hart, "Sphere tracing", The Visual Computer 12, 1996, section 4; I. Quilez, "Smooth
 * minimum", 2013 (the polynomial).
 */
#ifndef IMPLICIT_MODELS_H
#define IMPLICIT_MODELS_H

#include "surfaces.h"

typedef struct { vec3 c, half; real r; } implicit_box_shape;
typedef struct { implicit_surface a, b; real w; } implicit_pair;

/* ---------------------------------------------------------------------------------------------- */

static real implicit_ball_f(const void *data, vec3 p)
{
    const sphere *s = data;
    return vlength(vsub(p, s->c)) - s->r;
}

static jet implicit_ball_range(const void *data, jet x, jet y, jet z)
{
    const sphere *s = data;
    jet far = jet_length(jet_shift(x, -(double)s->c.x), jet_shift(y, -(double)s->c.y),
                         jet_shift(z, -(double)s->c.z));
    return jet_shift(far, -(double)s->r);
}

static inline implicit_surface implicit_ball(const sphere *s)
{
    return (implicit_surface){implicit_ball_f, NULL, implicit_ball_range, 1,
                              {s->c, fabs(s->r) * (real)1.25}, s};
}

static real implicit_torus_distance_f(const void *data, vec3 p)
{
    const implicit_ring *k = data;
    return vlength(vec(vlength(vec(p.x, p.y, 0)) - k->R, p.z, 0)) - k->r;
}

static jet implicit_torus_distance_range(const void *data, jet x, jet y, jet z)
{
    const implicit_ring *k = data;
    const jet none = {interval_at(0), interval_at(0)};
    jet flat = jet_shift(jet_length(x, y, none), -(double)k->R);
    return jet_shift(jet_length(flat, z, none), -(double)k->r);
}

static inline implicit_surface implicit_torus_distance(const implicit_ring *k)
{
    return (implicit_surface){implicit_torus_distance_f, NULL, implicit_torus_distance_range, 1,
                              {{0, 0, 0}, (k->R + k->r) * (real)1.25}, k};
}

/* q: how far p is beyond each side of the box; negative between them. */
static real implicit_box_f(const void *data, vec3 p)
{
    const implicit_box_shape *k = data;
    vec3 away = vsub(p, k->c), q = vsub(vmax(away, vneg(away)), k->half), none = {0, 0, 0};
    real inside = real_min(real_max(q.x, real_max(q.y, q.z)), 0);
    return vlength(vmax(q, none)) + inside - k->r;
}

static inline jet implicit_beyond(jet x, real c, real half)
{
    return jet_shift(jet_abs(jet_shift(x, -(double)c)), -(double)half);
}

static jet implicit_box_range(const void *data, jet x, jet y, jet z)
{
    const implicit_box_shape *k = data;
    const jet none = {interval_at(0), interval_at(0)};
    jet a = implicit_beyond(x, k->c.x, k->half.x), b = implicit_beyond(y, k->c.y, k->half.y);
    jet c = implicit_beyond(z, k->c.z, k->half.z);
    jet inside = jet_min(jet_max(a, jet_max(b, c)), none);
    jet far = jet_length(jet_max(a, none), jet_max(b, none), jet_max(c, none));
    return jet_shift(jet_add(far, inside), -(double)k->r);
}

static inline implicit_surface implicit_box(const implicit_box_shape *k)
{
    real out = vlength(k->half) + k->r;
    return (implicit_surface){implicit_box_f, NULL, implicit_box_range, 1,
                              {k->c, out * (real)1.25}, k};
}

static real implicit_blend_f(const void *data, vec3 p)
{
    const implicit_pair *k = data;
    real a = implicit_value(&k->a, p), b = implicit_value(&k->b, p);
    real melt = real_max(k->w - fabs(a - b), 0);
    return real_min(a, b) - melt * melt / (4 * k->w);
}

static jet implicit_blend_range(const void *data, jet x, jet y, jet z)
{
    const implicit_pair *k = data;
    const jet none = {interval_at(0), interval_at(0)};
    double w = (double)k->w;
    jet a = k->a.range(k->a.data, x, y, z), b = k->b.range(k->b.data, x, y, z);
    jet melt = jet_max(jet_shift(jet_neg(jet_abs(jet_sub(a, b))), w), none);
    jet deep = jet_square(melt);
    interval by = interval_at(4 * w);
    jet off = {interval_div(deep.v, by), interval_div(deep.d, by)};
    return jet_sub(jet_min(a, b), off);
}

/* Around both balls and what melts between them; w > 0. Without a range of a or of b there is none,
 * and without a bound of either none. */
static inline implicit_surface implicit_blend(const implicit_pair *k)
{
    bool proves = k->a.range && k->b.range, bounded = k->a.lipschitz > 0 && k->b.lipschitz > 0;
    vec3 apart = vsub(k->b.ball.c, k->a.ball.c);
    real least = real_max(k->a.ball.r, vlength(apart) + k->b.ball.r) + k->w / 4;
    return (implicit_surface){implicit_blend_f, NULL, proves ? implicit_blend_range : NULL,
                              bounded ? real_max(k->a.lipschitz, k->b.lipschitz) : 0,
                              {k->a.ball.c, least}, k};
}

#endif
