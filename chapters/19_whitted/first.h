/* first.h: Whitted's ray tracer: shade() calls trace() again for what mirrors and glass show.
 * Wrong where n2 is nearly n1: R loses digits (refract.h); where glass touches glass: one face goes
 * unseen (media.h); in glass light is n^2 too bright, the sky n^2 too dark (whitted.h). */
#ifndef FIRST_WHITTED_H
#define FIRST_WHITTED_H
#include "../02_camera/first.h"
#include "../18_shade/first.h"

/* w = d + 2 c n, c = -n.d: the part of d along n turns round.                            (19.1) */
static inline vec3 first_reflect(vec3 d, vec3 n)
{
    return vsub(d, vscale(n, 2 * vdot(n, d)));
}

/* Snell's law (斯涅尔定律), n1 sin i = n2 sin t (19.2), gives the cosine behind the surface:
 *     ct^2 = 1 - (n1/n2)^2 (1 - ci^2)                                                    (19.3)
 *     w = (n1/n2) d + ((n1/n2) ci - ct) n                                                (19.4)
 * False if ct^2 < 0: nothing goes through, total reflection (全反射). d, n unit, d . n <= 0. */
static inline bool first_refract(vec3 d, vec3 n, real n1, real n2, vec3 *w)
{
    real ratio = n1 / n2, ci = -vdot(d, n), ct2 = 1 - ratio * ratio * (1 - ci * ci);
    if (ct2 < 0) return false;
    *w = vadd(vscale(d, ratio), vscale(n, ratio * ci - sqrt(ct2)));
    return true;
}

/* Fresnel's equations (菲涅耳方程): the share that is reflected, mean of both polarisations.
 *     rs = (n1 ci - n2 ct) / (n1 ci + n2 ct),   rp = (n2 ci - n1 ct) / (n2 ci + n1 ct)
 *     R = (rs^2 + rp^2) / 2                                                              (19.5) */
static inline real first_fresnel(real ci, real ct, real n1, real n2)
{
    real rs = (n1 * ci - n2 * ct) / (n1 * ci + n2 * ct);
    real rp = (n2 * ci - n1 * ct) / (n2 * ci + n1 * ct);
    return (rs * rs + rp * rp) / 2;
}

/* What comes back along r, of unit direction, from a tree of rays with `depth` levels (光线深度);
 * the eye ray is the first. (To a shadow ray glass is like stone.)                      (19.10) */
static inline vec3 first_whitted(const first_scene *s, ray r, int depth)
{
    hit h;
    if (depth == 0) return vec(0, 0, 0);
    if (!first_scene_hit(s, r, &h)) return first_background(s, r.d);
    first_point x = first_point_at(s, r, h);
    vec3 L = first_shade(s, x);

    /* Mirrors and glass reflect. */
    ray mirrored = {x.p, s->eps, first_reflect(r.d, x.n), real_infinity};
    if (!vzero(x.m->mirror)) L = vadd(L, vmul(x.m->mirror, first_whitted(s, mirrored, depth - 1)));
    if (x.m->ior == 0) return L;

    /* Glass also lets light through: 1 - R of it, or nothing. */
    real n1 = x.inside ? x.m->ior : 1, n2 = x.inside ? 1 : x.m->ior, R = 1;
    ray through = {x.p, s->eps, vec(0, 0, 0), real_infinity};
    if (first_refract(r.d, x.n, n1, n2, &through.d)) {
        R = first_fresnel(-vdot(r.d, x.n), -vdot(through.d, x.n), n1, n2);
        L = vadd(L, vscale(first_whitted(s, through, depth - 1), 1 - R));
    }
    return vadd(L, vscale(first_whitted(s, mirrored, depth - 1), R));
}

/* The scene of 19 and 21: a ball of glass and one of chrome over a checkerboard. */
static inline first_scene first_two_balls(void)
{
    first_scene s = {.ambient = vec(0.12, 0.13, 0.16), .above = vec(0.12, 0.28, 0.6),
                     .below = vec(0.95, 0.85, 0.7), .eps = 1e-4};
    first_material board = {.kd = vec(0.8, 0.72, 0.55), .checks = 16};
    first_material chrome = {.kd = vec(0.02, 0.02, 0.02), .ks = vec(0.6, 0.6, 0.6), .shine = 300,
                             .mirror = vec(0.85, 0.83, 0.8)};
    first_material glass = {.ior = 1.5, .ks = vec(0.4, 0.4, 0.4), .shine = 300};
    first_material clay = {.kd = vec(0.7, 0.12, 0.05), .ks = vec(0.1, 0.1, 0.1), .shine = 20};
    first_material moss = {.kd = vec(0.1, 0.4, 0.12), .ks = vec(0.1, 0.1, 0.1), .shine = 20};
    first_add_flat(&s, vec(-8, 0, 8), vec(16, 0, 0), vec(0, 0, -16), board);
    first_add_ball(&s, vec(-0.9, 1, 1), 1, glass);
    first_add_ball(&s, vec(1.3, 1.3, -0.9), 1.3, chrome);
    first_add_ball(&s, vec(-2.6, 0.6, -1.8), 0.6, clay);
    first_add_ball(&s, vec(1.5, 0.35, 1.6), 0.35, moss);
    s.light[s.lights++] = (first_light){vec(-4, 7, 5), vec(260, 250, 230)};
    return s;
}

static inline first_camera first_two_balls_camera(int nx, int ny)
{
    return first_camera_at(vec(0.6, 2.1, 7.2), vec(0, 0.85, 0), vec(0, 1, 0), 36, nx, ny);
}
#endif
