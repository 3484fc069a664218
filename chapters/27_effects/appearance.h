/* appearance.h: what a file says of a material, as one (18): `illum` says what is called for.
 *
 *   appearance a = appearance_of(&s.material[m]);      a.m: its colours; black: not called for
 *   appearance *look = appearances_of(&s)              of all materials; free
 *
 *   illum     matte          highlight  mirror or glossy  through                            (27.3)
 *   0         - (Kd is drawn as it is, unlit: `flat`)
 *   1, 10     Kd             -          -                 -
 *   2, 8      Kd             Ks         -                 -
 *   3         Kd             -          Ks                -
 *   5         Kd             -          Ks, Fresnel       -
 *   4         d Kd           -          Ks                (1-d) (1-Ks) Tf, straight
 *   9         d Kd           Ks         -                 (1-d) (1-Ks) Tf, straight
 *   6         (1-Tf) Kd      -          Ks                (1-Ks) Tf, bent by Ni
 *   7         (1-Tf) Kd      -          1, Fresnel        Tf, bent by Ni; Tf 0: F0 of Ni, as 5
 *     rough   -            -          1, by facets      Tf, by facets, bent by Ni
 *   not said  as 2; if d < 1, as 9
 *   NFF       Kd rgb         Ks rgb     Ks rgb, mirror    T, bent by ior
 *
 *   as        m.kd           m.ks       m.mirror, m.ks    m.through; bent: m.inside
 *
 * Ns says which: 1000 and more, or none: a mirror; else glossy, a lobe (23.13) of that exponent, as
 * highlights are. Rough: of glass with a roughness r, alpha = r^2 (23), all facets: Ns and Kd say
 * nothing. Colours are albedos. No channel may give back more than it gets: where matte + reflected
 * + through (with fresnel: matte + through) exceeds 1, all are divided by the sum, excess.
 */
#ifndef EFFECTS_APPEARANCE_H
#define EFFECTS_APPEARANCE_H

#include "../23_brdf/brdf.h"
#include "effect.h"
#include "studio.h"

typedef struct {
    material m;
    unsigned calls;              /* effects that its parts take; 0: it is black */
    bool fresnel;
    bool glossy;                 /* m.ks reflects all that is around; else lights: a highlight */
    vec3 flat;
    brdf lobe;                   /* white, of the exponent Ns */
    real excess;                 /* > 1: colours were divided by it */
} appearance;

enum { appearance_mirror_ns = 1000 };

/* ---------------------------------------------------------------------------------------------- */

static inline vec3 vrest(vec3 a)  /* 1 - a, not below 0 */
{
    return vmax((vec3){1 - a.x, 1 - a.y, 1 - a.z}, (vec3){0, 0, 0});
}

/* Reflection of all that is around: in a lobe or sharp. */
static inline void appearance_reflects(appearance *a, const studio_material *m, vec3 colour)
{
    a->glossy = m->said[MTL_NS].file && m->mtl.ns < appearance_mirror_ns;
    *(a->glossy ? &a->m.ks : &a->m.mirror) = colour;
}

/* Of glass: all, times F. Of what lets nothing through (Tf 0): F0 = ((1 - Ni) / (1 + Ni))^2. */
static inline vec3 appearance_surface(const mtl_material *m)
{
    real r = (1 - m->ni) / (1 + m->ni), F0 = vzero(m->tf) ? r * r : 1;
    return (vec3){F0, F0, F0};
}

/* Divides by what is too much, all channels alike, so that the hue stays. */
static inline void appearance_limit(appearance *a)
{
    material *m = &a->m;
    vec3 reflected = vmax(m->ks, m->mirror), rest = vadd(m->kd, m->through);
    a->excess = vlargest(a->fresnel ? vmax(reflected, rest) : vadd(reflected, rest));
    if (!(a->excess > 1 + 16 * real_epsilon)) return;
    vec3 *part[] = {&m->kd, &m->ks, &m->mirror, &m->through};
    for (int k = 0; k < 4; k++) *part[k] = vscale(*part[k], 1 / a->excess);
}

/* Gives back light that falls on it: lights have something to do here. */
static inline bool appearance_lit(const appearance *a)
{
    return material_reflects(&a->m) || a->m.alpha > 0;
}

/* Bounds a body of glass. */
fast_inline bool appearance_body(const appearance *a) { return a->m.inside.ior > 0; }

fast_inline bool appearance_bends(const appearance *a)
{
    return appearance_body(a) && a->m.inside.ior != 1;
}

/* What its parts take, once they are known: a ray's hit asks for no others. */
static inline void appearance_note(appearance *a)
{
    const vec3 black = {0, 0, 0}, white = {1, 1, 1};
    material *m = &a->m;
    if (vzero(m->through)) m->inside.ior = 0;  /* what lets nothing through bounds no body */
    a->lobe = brdf_blinn_phong(black, white, m->shine);
    a->calls = (appearance_lit(a) ? EFFECTS_LIT : 0) | (vzero(m->kd) ? 0 : EFFECT_INDIRECT)
        | ((a->glossy && !vzero(m->ks)) || m->alpha > 0 ? EFFECT_GLOSSY : 0)
        | (vzero(m->mirror) ? 0 : EFFECT_MIRROR) | (vzero(m->through) ? 0 : EFFECT_REFRACTION)
        | (appearance_body(a) && !vzero(m->inside.absorb) ? EFFECT_ABSORPTION : 0);
}

static inline appearance appearance_classic(const mtl_material *m)
{
    appearance a = {.m = {.kd = m->kd, .ks = m->ks, .shine = m->ns, .ke = m->ke, .both = true,
                          .mirror = m->ks, .through = m->tf,
                          .inside = {m->ni, m->absorb, m->priority}}};
    appearance_limit(&a), appearance_note(&a);
    return a;
}

/* How it is read when nobody says: see the table. */
static inline int appearance_illum(const mtl_material *m)
{
    return m->illum >= 0 ? m->illum : m->d < 1 ? 9 : 2;
}

static inline appearance appearance_of(const studio_material *of)
{
    const mtl_material *m = &of->mtl;
    if (of->classic) return appearance_classic(m);
    int illum = appearance_illum(m);
    bool emits = !vzero(m->ke), lobe = of->said[MTL_NS].file;
    vec3 kd = emits && !of->said[MTL_KD].file ? (vec3){0, 0, 0} : m->kd;  /* a lamp is no wall */
    appearance a = {.m = {.kd = kd, .shine = m->ns, .ke = m->ke, .both = true}};
    switch (illum) {
    case 0: a.m.kd = (vec3){0, 0, 0}, a.flat = kd; break;
    case 2: case 8: case 9: if (lobe) a.m.ks = m->ks; break;
    case 3: case 4: case 5: case 6: appearance_reflects(&a, of, m->ks); break;
    case 7: if (m->ni != 1) appearance_reflects(&a, of, appearance_surface(m)); break;
    }
    if (illum == 4 || illum == 9) {
        a.m.kd = vscale(kd, m->d);
        a.m.through = vmul(vscale(m->tf, 1 - m->d), vrest(m->ks));
    }
    if (illum == 6 || illum == 7) {
        a.m.kd = vmul(kd, vrest(m->tf));
        a.m.through = illum == 6 ? vmul(m->tf, vrest(m->ks)) : m->tf;
        a.m.inside = (medium){m->ni, m->absorb, m->priority};
    }
    if (illum == 7 && m->ni != 1 && m->roughness > 0 && !vzero(a.m.through)) {
        a.m.alpha = real_max(ggx_alpha(m->roughness), real_epsilon);  /* small is not 0 */
        a.m.kd = a.m.ks = (vec3){0, 0, 0}, a.glossy = false;
        a.m.mirror = (vec3){1, 1, 1};
    }
    a.fresnel = (illum == 5 || illum == 7) && !(vzero(a.m.mirror) && vzero(a.m.ks));
    appearance_limit(&a), appearance_note(&a);
    return a;
}

static inline appearance *appearances_of(const studio *s)
{
    appearance *look = allocate(s->materials, sizeof *look);
    for (size_t m = 0; m < s->materials; m++) look[m] = appearance_of(&s->material[m]);
    return look;
}

#endif
