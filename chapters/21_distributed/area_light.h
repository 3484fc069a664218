/* area_light.h: lights with a size; the part of one that a point sees makes the shadow soft.
 *
 *        ____n'____            E(p) = integral over the light of
 *       /    |    /|                  L V(p, q) cos(theta) cos(theta') / |q - p|^2 dA        (21.1)
 *      /____ v __/  a                                                    [W/m^2]
 *         b   \ q              n: theta at p;  n': theta' at q, a random point of the light
 *         ___  \               one sample:  I V cos(theta) cos(theta') / |q - p|^2,  I = L A (21.2)
 *       occluder\              V: 1 if one shadow ray gets through, or 0
 *     n|    ######\
 *   ---p--------- umbra (本影), then penumbra (半影), then all of the light
 *
 * A light is given by its intensity I [W/sr] straight ahead, not by its radiance L: if it shrinks
 * and I stays, (21.2) does, and a light of no size is a point light. There is no other code for it:
 * a ball of radius 0 gives what light.h (18) gives, to the last bit.
 *
 *   area_light L = {AREA_RECTANGLE, centre, a, b, n', 0, I};     corners: centre -+ a/2 -+ b/2
 *   area_light L = {AREA_DISK, centre, a, b, n', 0, I};          a, b: radii at right angles
 *   area_light L = {AREA_BALL, centre, .r = r, .colour = I};     I = L pi r^2 in all directions
 *       flat ones shine to the side of n' [unit] only; any parallelogram will do as a rectangle
 *
 *   area_sample x;                                          u: any numbers for a light of no size
 *   bool area_light_reaches(&L, p, ng, ns, u, &x)           x.to: q; x.E: (21.2) as if V were 1
 *       false: behind the surface, behind the light, black: no ray is called for; x.E is 0
 *   bool area_light_has_size(&L)                            false: one ray says it all
 *   real area_light_area(&L), vec3 area_light_radiance(&L)  ball: pi r^2, as it is seen
 *
 * A ball is sampled by directions, uniformly in the cone under which it is seen: no sample falls on
 * its far side, and 1 / |q - p|^2 is gone. From inside it reaches nothing.
 *
 * Sources: Cook et al., 1984 (penumbras); P. Shirley, C. Wang, K. Zimmerman, "Monte Carlo
 * techniques for direct lighting calculations", ACM Trans. Graphics 15(1), 1996 (by area, by cone).
 */
#ifndef DISTRIBUTED_AREA_LIGHT_H
#define DISTRIBUTED_AREA_LIGHT_H

#include "../20_monte_carlo/sampler.h"
#include "../20_monte_carlo/sampling.h"

typedef enum { AREA_RECTANGLE, AREA_DISK, AREA_BALL } area_light_kind;
typedef struct {
    area_light_kind kind;
    vec3 at, a, b, n;
    real r;
    vec3 colour;
} area_light;

typedef struct {
    vec3 to, l;  /* the point of the light; unit, towards it */
    vec3 E;
} area_sample;

/* ---------------------------------------------------------------------------------------------- */

static inline bool area_light_has_size(const area_light *L)
{
    return L->kind == AREA_BALL ? L->r != 0 : !(vzero(L->a) && vzero(L->b));
}

static inline real area_light_area(const area_light *L)
{
    real parallelogram = vlength(vcross(L->a, L->b));
    switch (L->kind) {
    case AREA_RECTANGLE: return parallelogram;
    case AREA_DISK: return pi * parallelogram;
    case AREA_BALL: return pi * L->r * L->r;
    }
    return 0;
}

/* Without an area it is infinite, but nobody can see it: 0. */
static inline vec3 area_light_radiance(const area_light *L)
{
    real A = area_light_area(L);
    return A > 0 ? vscale(L->colour, 1 / A) : (vec3){0, 0, 0};
}

static inline vec3 area_light_point(const area_light *L, point2 u)
{
    vec3 d = {u.u - (real)0.5, u.v - (real)0.5, 0};
    if (L->kind == AREA_DISK) d = sample_disk(u.u, u.v);
    return vmadd(vmadd(L->at, L->a, d.x), L->b, d.y);
}

/* Where a ray from p meets the ball, uniformly in its cone of half angle beta, sin beta = r / d.
 * q = sin^2(alpha/2) makes alpha (20); then t = d cos(alpha) - sqrt(r^2 - d^2 sin^2 alpha). E =
 * L cos(theta) omega, and omega = 4 pi q_max = pi r^2 / d^2 times 2 / (1 + cos beta): `wider`. */
static inline bool area_light_ball(const area_light *L, vec3 p, point2 u, area_sample *out,
                                   real *square, real *wider)
{
    vec3 c = vsub(L->at, p);
    *square = vdot(c, c);
    *wider = 1, out->to = L->at, out->l = vunit(c);
    if (L->r == 0) return true;
    real d = vlength(c), s = fabs(L->r) / d, cosine = sqrt(real_max((1 - s) * (1 + s), 0));
    if (!(s < 1)) return false;
    vec3 w = sample_cone(cone_of_sphere(fabs(L->r), d), u.u, u.v);
    real across = d * d * (w.x * w.x + w.y * w.y);
    real t = d * w.z - sqrt(real_max(L->r * L->r - across, 0));
    out->l = directed(out->l, w), out->to = vmadd(p, out->l, t);
    *wider = 2 / (1 + cosine);
    return true;
}

/* ng, geometric normal of the surface; ns, its shading normal: both must face the sample. Written
 * so that a NaN reaches nothing. Products in the order of light_reaches (18). */
static inline bool area_light_reaches(const area_light *L, vec3 p, vec3 ng, vec3 ns, point2 u,
                                      area_sample *out)
{
    real square, factor = 1;
    *out = (area_sample){L->at, {0, 0, 0}, {0, 0, 0}};
    if (L->kind == AREA_BALL) {
        if (!area_light_ball(L, p, u, out, &square, &factor)) return false;
    } else {
        out->to = area_light_has_size(L) ? area_light_point(L, u) : L->at;
        vec3 to = vsub(out->to, p);
        out->l = vunit(to), square = vdot(to, to), factor = -vdot(L->n, out->l);
    }
    real cosine = vdot(ns, out->l);
    if (!(cosine > 0 && vdot(ng, out->l) > 0 && factor > 0 && square > 0)) return false;
    vec3 E = vscale(vscale(L->colour, cosine / square), factor);
    if (!vfinite(E)) return false;
    out->E = E;
    return !vzero(L->colour);
}

#endif
