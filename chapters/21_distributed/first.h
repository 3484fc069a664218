/* first.h: the two that Whitted's way lacks: a light with an area, and blurred reflection.
 * Wrong: what of a lobe leads below the surface is lost, at grazing angles half: glossy.h says how
 * much. Near the lamp (21.2) has no bound; by solid angle it has: 22's spherical_sampling.h. */
#ifndef FIRST_DISTRIBUTED_H
#define FIRST_DISTRIBUTED_H
#include "../19_whitted/first.h"
#include "../20_monte_carlo/first.h"

/* A lamp: the parallelogram corner + u a + v b. It shines on the side to which a x b points. */
typedef struct { vec3 corner, a, b, L; } first_lamp;

/* E at x is the integral of L V cos cos' / r^2 over the lamp (21.1); one point q of it, chosen
 * evenly, stands for all: with p(q) = 1 / A, f / p is A times as much.                   (21.2) */
static inline vec3 first_lamp_sample(const first_scene *s, const first_lamp *lamp, first_point x,
                                     random_stream *random)
{
    real u = random_next(random), v = random_next(random);
    vec3 q = vadd(lamp->corner, vadd(vscale(lamp->a, u), vscale(lamp->b, v)));
    vec3 d = vsub(q, x.p), l = vunit(d), across = vcross(lamp->a, lamp->b);
    real A = vlength(across), cosine = vdot(x.n, l), cosine_there = -vdot(vunit(across), l);
    if (cosine <= 0 || cosine_there <= 0) return vec(0, 0, 0);
    if (first_occluded(s, (ray){x.p, s->eps, d, 1 - s->eps})) return vec(0, 0, 0);
    return vscale(lamp->L, A * cosine * cosine_there / vdot(d, d));
}

/* A direction near the unit vector r, with p(w) = (s + 1) / (2 pi) (r.w)^s.              (21.4) */
static inline vec3 first_lobe(vec3 r, real s, random_stream *random)
{
    real z = pow(1 - random_next(random), 1 / (s + 1)), phi = 2 * pi * random_next(random);
    real side = sqrt(real_max(1 - z * z, 0));
    return directed(r, vec(side * cos(phi), side * sin(phi), z));
}

/* One path instead of Whitted's tree. What is mirrored comes from the lobe (21.5). Glass reflects
 * with the chance R, or else refracts: on average R of one and 1 - R of the other.      (21.15) */
static inline vec3 first_distributed(const first_scene *s, const first_lamp *lamp, ray r, int depth,
                                     random_stream *random)
{
    hit h;
    if (depth <= 0) return vec(0, 0, 0);
    if (!first_scene_hit(s, r, &h)) return first_background(s, r.d);
    first_point x = first_point_at(s, r, h);
    vec3 E = first_lamp_sample(s, lamp, x, random), weight = x.m->mirror;
    vec3 L = vadd(x.m->ke, vmul(x.kd, vadd(s->ambient, vscale(E, 1 / pi))));

    ray next = {x.p, s->eps, first_reflect(r.d, x.n), real_infinity};
    if (x.m->ior > 0) {
        real n1 = x.inside ? x.m->ior : 1, n2 = x.inside ? 1 : x.m->ior;
        vec3 through;
        weight = vec(1, 1, 1);
        if (first_refract(r.d, x.n, n1, n2, &through)
            && random_next(random) >= first_fresnel(-vdot(r.d, x.n), -vdot(through, x.n), n1, n2))
            next.d = through;
    } else if (!vzero(weight)) {
        next.d = first_lobe(next.d, x.m->shine, random);
        if (vdot(next.d, x.n) <= 0) return L;
    } else return L;
    return vadd(L, vmul(weight, first_distributed(s, lamp, next, depth - 1, random)));
}

/* Where the light of 19 was, a square at right angles to the way from there to the balls. */
static inline first_lamp first_two_balls_lamp(const first_scene *s)
{
    vec3 at = s->light[0].p, down = vunit(vneg(at)), a, b;
    vbasis(down, &a, &b);
    return (first_lamp){vsub(at, vscale(vadd(a, b), 2)), vscale(a, 4), vscale(b, 4),
                        vscale(s->light[0].intensity, 1 / 16.0)};
}
#endif
