/* light.h: lights without size, and how bright a surface looks under them.
 *
 *        l = towards the light, v = towards the eye, n = shading normal, h = unit(l + v)
 *
 *   point light 点光源         E = I (n.l) / |L - p|^2                        (18.1)
 *   directional light 方向光   E = E0 (n.l), from infinitely far: the sun     (18.2)
 *   Lambert 漫反射             L = kd / pi E                                  (18.3)
 *   Blinn-Phong 高光           L = ks (n.h)^s E, s >= 0                       (18.4)
 *   ambient 环境光             L = kd La: what Lambert sees of a sky that is La everywhere
 *
 * I [W/sr] or E0 [W/m^2] per colour channel; L [W/m^2/sr] goes to the picture. (18.4) is an
 * empirical lobe (经验模型) without a unit: it neither keeps energy nor narrows at grazing angles.
 *
 *   light_sample x;
 *   if (light_reaches(&light, p, n, ns, &x)) .. false: behind the surface, black, or at p itself
 *                                               (as near as that: if E overflows)
 *   vec3 c = blinn_phong(&m, ns, x.l, v, x.E)   (18.3) + (18.4)
 *   bool material_reflects(&m)                  false: black; no light is worth a shadow ray
 *
 * Sources: J. Lambert, "Photometria", 1760; B. Phong, "Illumination for Computer Generated
 * Pictures", CACM 18(6), 1975; J. Blinn, "Models of Light Reflection for Computer Synthesized
 * Pictures", SIGGRAPH 1977.
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
    vec3 kd, ks;  /* colours [0, 1] */
    real shine;   /* exponent s */
    vec3 ke;      /* what it emits by itself [W/m^2/sr] */
} material;

typedef struct {
    vec3 l;       /* unit, towards the light */
    vec3 E;       /* irradiance with n.l, if nothing is in between */
} light_sample;

/* ---------------------------------------------------------------------------------------------- */

/* ng, geometric: what the surface itself hides; ns, shading: what the formulas use. Both must face
 * the light: on a smoothed mesh they disagree near the terminator (明暗交界). `out` is set even
 * then, with E = 0 where n.l <= 0. Written so that a NaN reaches nothing. */
static inline bool light_reaches(const light *L, vec3 p, vec3 ng, vec3 ns, light_sample *out)
{
    vec3 to = L->kind == LIGHT_POINT ? vsub(L->at, p) : L->at;
    *out = (light_sample){L->kind == LIGHT_POINT ? vunit(to) : to, {0, 0, 0}};
    real cosine = vdot(ns, out->l), square = L->kind == LIGHT_POINT ? vdot(to, to) : 1;
    if (!(cosine > 0) || !(vdot(ng, out->l) > 0) || !(square > 0)) return false;
    vec3 E = vscale(L->colour, cosine / square);
    if (!vfinite(E)) return false;  /* infinity times a black kd would be a NaN */
    out->E = E;
    return !vzero(L->colour);
}

static inline vec3 blinn_phong(const material *m, vec3 ns, vec3 l, vec3 v, vec3 E)
{
    vec3 matte = vscale(m->kd, 1 / pi);
    if (vzero(m->ks)) return vmul(E, matte);
    real nh = real_max(0, vdot(ns, vunit(vadd(l, v))));
    return vmul(E, vmadd(matte, m->ks, pow(nh, m->shine)));
}

static inline bool material_reflects(const material *m) { return !vzero(m->kd) || !vzero(m->ks); }

#endif
