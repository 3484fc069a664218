/* first.h: path tracing (路径追踪): shade() with one ray a hit, light sampling and Russian roulette.
 * Wrong nowhere on average, but noisy close to a lamp (24); and it knows matte walls and one lamp.
 * path.h has mirrors, glass, many lamps, a sky, and takes both ways to a lamp at once. */
#ifndef FIRST_PATH_H
#define FIRST_PATH_H
#include "../24_direct_light/first.h"

/* The chance that a path goes on (Russian roulette, 俄罗斯轮盘赌). It may not be 1: in a closed room
 * no path would end. At .8 a path has five hits on average; one in 1e9 has more than 93. */
static const double first_go_on = 0.8;

/* What the eye sees along r, by one direction a hit and luck: x emits, and reflects what comes that
 * way. The path ends where it leaves the scene, or after `most` hits: in a closed room it would not
 * end at all, and what comes after the last is lost.
 *     L(x0) = Le(x0) + f cos / p L(x1),  f cos / p = kd                          (26.1), (24.2) */
static inline vec3 first_path_by_luck(const first_scene *s, ray r, int most, random_stream *random)
{
    hit h;
    if (most <= 0 || !first_scene_hit(s, r, &h)) return vec(0, 0, 0);
    first_point x = first_point_at(s, r, h);
    vec3 Li = first_path_by_luck(s, first_bounce(s, x, random), most - 1, random);
    return vadd(first_emitted(x), vmul(x.kd, Li));
}

/* The notes' shade(p, wo): all light that leaves x for the viewer but its own emission,
 *     L = K E + K^2 E + ...                                                              (25.3) */
static inline vec3 first_path_shade(const first_scene *s, first_point x, random_stream *random)
{
    /* From the lamp: a point of it, and a shadow ray.                                    (24.4) */
    vec3 L = first_direct_by_lamp(s, 0, x, random);

    /* From everything else: one direction, with probability q, and then worth 1/q times as much, so
     * that on average nothing changes.                                                   (26.3) */
    const real q = first_go_on;
    if (random_next(random) >= q) return L;
    ray r = first_bounce(s, x, random);
    hit h;
    if (!first_scene_hit(s, r, &h)) return L;

    /* Li leaves out emission: a lamp that is met here is counted already. But lamps reflect. */
    vec3 Li = first_path_shade(s, first_point_at(s, r, h), random);
    return vadd(L, vscale(vmul(x.kd, Li), 1 / q));                                      /* (24.2) */
}

/* What the eye sees along r: L = E + ..., since lamps are seen directly, too.            (25.1) */
static inline vec3 first_path(const first_scene *s, ray r, random_stream *random)
{
    hit h;
    if (!first_scene_hit(s, r, &h)) return vec(0, 0, 0);
    first_point x = first_point_at(s, r, h);
    return vadd(first_emitted(x), first_path_shade(s, x, random));
}
#endif
