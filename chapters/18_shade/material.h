/* material.h: what a surface is made of, and how bright it looks under a light.
 *
 *        l = towards the light, v = towards the eye, n = shading normal, h = unit(l + v)
 *
 *   Lambert 漫反射             L = kd / pi E                                  (18.3)
 *   Blinn-Phong 高光           L = ks (n.h)^s E, s >= 0                       (18.4)
 *   ambient 环境光             L = kd La: what Lambert sees of a sky that is La everywhere
 *
 * E: light.h. L [W/m^2/sr] goes to the picture. (18.4) is an empirical lobe (经验模型) without a
 * unit: it neither keeps energy nor narrows at grazing angles. 23 makes of the same numbers what
 * does, brdf_of, for 24 to 27. Each chapter reads those members that it simulates; what is 0 is not
 * there.
 *
 *   vec3 c = blinn_phong(&m, ns, x.l, v, x.E)   (18.3) + (18.4)
 *   bool material_reflects(&m)                  false: black; no light is worth a shadow ray
 *   material m = material_glass(inside, alpha)  its surface tints nothing: mirror and through white
 *
 * Sources: B. Phong, "Illumination for Computer Generated Pictures", CACM 18(6), 1975; J. Blinn,
 * "Models of Light Reflection for Computer Synthesized Pictures", SIGGRAPH 1977.
 */
#ifndef SHADE_MATERIAL_H
#define SHADE_MATERIAL_H

#include "../../common/vec3.h"

typedef struct {
    real ior;        /* refractive index (折射率) > 0; of a material, 0: it is no glass */
    vec3 absorb;     /* (19.9), per unit length */
    int priority;    /* of bodies that overlap: media.h of 19 */
} medium;

typedef struct {
    vec3 kd, ks;     /* colours [0, 1]: matte, highlight */
    real shine;      /* exponent s */
    vec3 ke;         /* what it emits by itself [W/m^2/sr] */
    bool both;       /* 24: what is flat emits from its back, too */
    vec3 mirror;     /* 19: all that is around, reflected; of glass a factor of Fresnel's R */
    vec3 through;    /* 19: of glass, a factor of 1 - R */
    real alpha;      /* 23: width of the facets of mirror and glass (23.6); 0: smooth */
    medium inside;   /* 24: what glass is filled with */
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

static inline material material_glass(medium inside, real alpha)
{
    return (material){.mirror = {1, 1, 1}, .through = {1, 1, 1}, .alpha = alpha, .inside = inside};
}

#endif
