/* first.h: the BRDF (双向反射分布函数): how much of the light from wi leaves along wo.
 * Wrong: at a slant a sharp lobe loses light, 3/4 of it at 60 degrees; for e = 1e6 in float (n.h)^e
 * is off by per cents. microfacet.h keeps the light, blinn_phong.h the digits. kd + ks <= 1. */
#ifndef FIRST_BRDF_H
#define FIRST_BRDF_H
#include "../20_monte_carlo/first.h"

/* f(wi, wo) = dL(wo) / dE(wi) in 1/sr (23.1), here the sum of two:
 *     Lambert (漫反射)    kd / pi
 *     Blinn-Phong (高光)  ks C (n.h)^e,   h = unit(wi + wo)                             (23.13) */
typedef struct { vec3 kd, ks; real e; } first_brdf;

/* C, with which the lobe seen head-on reflects ks of the light.                        (23.14) */
static inline real first_brdf_scale(real e)
{
    return (e + 2) * (e + 4) / (8 * pi * (e + pow(2, -e / 2)));
}

/* wi, wo: unit, both above the surface, whose normal is z. They may be swapped.          (23.3) */
static inline vec3 first_brdf_value(first_brdf f, vec3 wi, vec3 wo)
{
    vec3 h = vunit(vadd(wi, wo));
    real lobe = first_brdf_scale(f.e) * pow(real_max(h.z, 0), f.e);
    return vadd(vscale(f.kd, 1 / pi), vscale(f.ks, lobe));
}

/* What comes from the direction w in the picture: a window, in a room of blue and brown. */
static inline vec3 first_room_light(vec3 w)
{
    if (w.z > 0.3 && fabs(w.x) < 0.34 && fabs(w.y - 0.45) < 0.3) return vec(6, 5.7, 5);
    real up = (1 + w.y) / 2;
    return vadd(vscale(vec(0.35, 0.5, 0.75), up), vscale(vec(0.3, 0.18, 0.1), 1 - up));
}

/* The reflection equation (反射方程) L(wo) = integral of f(wi, wo) L(wi) cos d omega     (23.2)
 * by N directions drawn with p = cos / pi: each is worth f L cos / p = pi f L.          (23.19)
 * n: unit normal in the world, wo: unit direction to the viewer. N a square: evenly spread. */
static inline vec3 first_reflection(first_brdf f, vec3 n, vec3 wo, int N, random_stream *random)
{
    vec3 s, t, L = vec(0, 0, 0);
    vbasis(n, &s, &t);
    vec3 local = {vdot(s, wo), vdot(t, wo), vdot(n, wo)};
    int side = (int)(sqrt(N) + 0.5);
    for (int i = 0; i < N; i++) {
        real u = (i % side + random_next(random)) / side;
        real v = (i / side + random_next(random)) / side;
        vec3 wi = first_cosine_direction(u, v);
        vec3 arrives = first_room_light(directed(n, wi));
        L = vadd(L, vscale(vmul(first_brdf_value(f, wi, local), arrives), pi / N));
    }
    return L;
}

/* Albedo (反照率): the share of the light from all around that leaves along wo.         (23.4) */
static inline vec3 first_albedo(first_brdf f, vec3 wo, int N, random_stream *random)
{
    vec3 sum = vec(0, 0, 0);
    for (int i = 0; i < N; i++) {
        real u = random_next(random), v = random_next(random);
        sum = vadd(sum, vscale(first_brdf_value(f, first_cosine_direction(u, v), wo), pi / N));
    }
    return sum;
}
#endif
