/* first.h: direct light (直接光照), by directions that may meet the lamp, and by points of the lamp.
 * Wrong nowhere on average; but the first is noisy for a small lamp, the second close to a lamp.
 * mis.h takes both at once, and is never much worse than the better one. Matte walls, one lamp. */
#ifndef FIRST_DIRECT_H
#define FIRST_DIRECT_H
#include "../02_camera/first.h"
#include "../18_shade/first.h"
#include "../20_monte_carlo/first.h"

/* From x along a direction wi that is spread as the cosine. A matte wall has f = kd / pi; with
 * p = cos / pi whatever arrives along wi is worth f cos / p = kd of it.                  (24.2) */
static inline ray first_bounce(const first_scene *s, first_point x, random_stream *random)
{
    real u = random_next(random), v = random_next(random);
    return (ray){x.p, s->eps, directed(x.n, first_cosine_direction(u, v)), real_infinity};
}

/* A lamp shines on its front, where its a x b points. */
static inline vec3 first_emitted(first_point x)
{
    return x.inside ? vec(0, 0, 0) : x.m->ke;
}

/* One direction: L(wo) ~ f cos Le / p = kd Le, if it meets the lamp.              (24.1), (24.2) */
static inline vec3 first_direct_by_direction(const first_scene *s, first_point x,
                                             random_stream *random)
{
    ray r = first_bounce(s, x, random);
    hit h;
    if (!first_scene_hit(s, r, &h)) return vec(0, 0, 0);
    return vmul(x.kd, first_emitted(first_point_at(s, r, h)));
}

/* One point of the lamp, evenly chosen: p = 1 / A by area, and seen from x its piece dA fills the
 * solid angle dwi = cos' dA / r^2 (24.3). So f cos Le / p = kd / pi cos cos' A Le / r^2.  (24.4) */
static inline vec3 first_direct_by_lamp(const first_scene *s, int lamp, first_point x,
                                        random_stream *random)
{
    const first_thing *y = &s->thing[lamp];
    real u = random_next(random), v = random_next(random);
    vec3 q = vadd(y->corner, vadd(vscale(y->a, u), vscale(y->b, v)));
    vec3 d = vsub(q, x.p), wi = vunit(d);
    real cosine = vdot(x.n, wi), cosine_there = -vdot(vunit(y->n), wi);
    if (cosine <= 0 || cosine_there <= 0) return vec(0, 0, 0);
    if (first_occluded(s, (ray){x.p, s->eps, d, 1 - s->eps})) return vec(0, 0, 0);
    real A = vlength(y->n);
    return vscale(vmul(x.kd, y->m.ke), cosine * cosine_there * A / (pi * vdot(d, d)));
}

/* The Cornell box (康奈尔盒), in units of 100 mm: a white room, open in front, a red and a green wall,
 * two blocks, and a lamp, thing 0, a hair below the ceiling. All walls are made parallelograms.
 * Source of the measures: Cornell University Program of Computer Graphics. */
static inline void first_add_block(first_scene *s, vec3 top, vec3 a, vec3 b, first_material m)
{
    vec3 down = vec(0, -top.y, 0), c = vadd(top, vadd(a, b));
    first_add_flat(s, top, a, b, m);
    first_add_flat(s, top, down, a, m);
    first_add_flat(s, top, b, down, m);
    first_add_flat(s, c, down, vneg(a), m);
    first_add_flat(s, c, vneg(b), down, m);
}

static inline first_scene first_cornell(void)
{
    first_scene s = {.eps = 1e-5};
    first_material white = {.kd = vec(0.725, 0.71, 0.68)}, lamp = {.kd = vec(0.78, 0.78, 0.78)};
    first_material red = {.kd = vec(0.63, 0.065, 0.05)}, green = {.kd = vec(0.14, 0.45, 0.091)};
    lamp.ke = vec(17, 12, 4);
    first_add_flat(&s, vec(3.43, 5.487, 3.32), vec(-1.3, 0, 0), vec(0, 0, -1.05), lamp);
    first_add_flat(&s, vec(5.53, 0, 0), vec(-5.53, 0, 0), vec(0, 0, 5.592), white);
    first_add_flat(&s, vec(5.53, 5.488, 0), vec(0, 0, 5.592), vec(-5.53, 0, 0), white);
    first_add_flat(&s, vec(5.53, 0, 5.592), vec(-5.53, 0, 0), vec(0, 5.488, 0), white);
    first_add_flat(&s, vec(0, 0, 5.592), vec(0, 0, -5.592), vec(0, 5.488, 0), green);
    first_add_flat(&s, vec(5.53, 0, 0), vec(0, 0, 5.592), vec(0, 5.488, 0), red);
    first_add_block(&s, vec(1.3, 1.65, 0.65), vec(-0.48, 0, 1.6), vec(1.6, 0, 0.48), white);
    first_add_block(&s, vec(4.23, 3.3, 2.47), vec(-1.58, 0, 0.49), vec(0.49, 0, 1.58), white);
    return s;
}

static inline first_camera first_cornell_camera(int nx, int ny)
{
    return first_camera_at(vec(2.78, 2.73, -8), vec(2.78, 2.73, 0), vec(0, 1, 0), 39.3077, nx, ny);
}

/* The same without the dark rim round the box. */
static inline first_camera first_cornell_inside(int nx, int ny)
{
    return first_camera_at(vec(2.78, 2.73, -8), vec(2.78, 2.73, 0), vec(0, 1, 0), 37.5, nx, ny);
}
#endif
