/* light.h: lights without size.
 *
 *        l = towards the light, n = shading normal
 *
 *   point light 点光源         E = I (n.l) / |L - p|^2                        (18.1)
 *   directional light 方向光   E = E0 (n.l), from infinitely far: the sun     (18.2)
 *
 * I [W/sr] or E0 [W/m^2] per colour channel.
 *
 *   light_sample x;
 *   if (light_reaches(&light, p, n, ns, &x)) .. false: behind the surface, black, or at p itself
 *                                               (as near as that: if E overflows)
 *   vec3 l = light_towards(&light, p, &square)  l alone, and |L - p|^2; 1: the sun's
 *
 * Source: J. Lambert, "Photometria", 1760.
 */
#ifndef SHADE_LIGHT_H
#define SHADE_LIGHT_H

#include "../../common/vec3.h"

typedef enum { LIGHT_POINT, LIGHT_DIRECTIONAL } shade_light_kind;
typedef struct {
    shade_light_kind kind;
    vec3 at;      /* point: where it is. directional: unit vector towards it */
    vec3 colour;  /* point: intensity I. directional: irradiance E0 at normal incidence */
} light;

typedef struct {
    vec3 l;       /* unit, towards the light */
    vec3 E;       /* irradiance with n.l, if nothing is in between */
} light_sample;

/* ---------------------------------------------------------------------------------------------- */

static inline vec3 light_towards(const light *L, vec3 p, real *square)
{
    vec3 to = vsub(L->at, p);
    bool sun = L->kind == LIGHT_DIRECTIONAL;
    *square = sun ? 1 : vdot(to, to);
    return sun ? L->at : vunit(to);
}

/* ng, geometric: what the surface itself hides; ns, shading: what the formulas use. Both must face
 * the light: on a smoothed mesh they disagree near the terminator (明暗交界). `out` is set even
 * then, with E = 0 where n.l <= 0. Written so that a NaN reaches nothing. */
static inline bool light_reaches(const light *L, vec3 p, vec3 ng, vec3 ns, light_sample *out)
{
    real square;
    *out = (light_sample){light_towards(L, p, &square), {0, 0, 0}};
    real cosine = vdot(ns, out->l);
    if (!(cosine > 0) || !(vdot(ng, out->l) > 0) || !(square > 0)) return false;
    vec3 E = vscale(L->colour, cosine / square);
    if (!vfinite(E)) return false;  /* infinity times a black kd would be a NaN */
    out->E = E;
    return !vzero(L->colour);
}

#endif
