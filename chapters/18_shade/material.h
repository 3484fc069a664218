/* material.h: how bright a surface looks under a light: matte and a highlight.
 *
 *        l = towards the light, v = towards the eye, n = shading normal, h = unit(l + v)
 *
 *   Lambert 漫反射             L = kd / pi E                                  (18.3)
 *   Blinn-Phong 高光           L = ks (n.h)^s E, s >= 0                       (18.4)
 *   ambient 环境光             L = kd La: what Lambert sees of a sky that is La everywhere
 *
 * E: light.h. L [W/m^2/sr] goes to the picture. (18.4) is an empirical lobe (经验模型) without a
 * unit: it neither keeps energy nor narrows at grazing angles.
 *
 *   vec3 c = blinn_phong(&m, ns, x.l, v, x.E)   (18.3) + (18.4)
 *   bool material_reflects(&m)                  false: black; no light is worth a shadow ray
 *
 * Sources: B. Phong, "Illumination for Computer Generated Pictures", CACM 18(6), 1975; J. Blinn,
 * "Models of Light Reflection for Computer Synthesized Pictures", SIGGRAPH 1977.
 */
#ifndef SHADE_MATERIAL_H
#define SHADE_MATERIAL_H

#include "../../common/vec3.h"

typedef struct {
    vec3 kd, ks;  /* colours [0, 1] */
    real shine;   /* exponent s */
    vec3 ke;      /* what it emits by itself [W/m^2/sr] */
} material;

/* ---------------------------------------------------------------------------------------------- */

static inline vec3 blinn_phong(const material *m, vec3 ns, vec3 l, vec3 v, vec3 E)
{
    vec3 matte = vscale(m->kd, 1 / pi);
    if (vzero(m->ks)) return vmul(E, matte);
    real nh = real_max(0, vdot(ns, vunit(vadd(l, v))));
    return vmul(E, vmadd(matte, m->ks, pow(nh, m->shine)));
}

static inline bool material_reflects(const material *m) { return !vzero(m->kd) || !vzero(m->ks); }

#endif
