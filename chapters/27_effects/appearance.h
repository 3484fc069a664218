/* appearance.h: what the numbers of a material mean for light: `illum` says what they call for.
 *
 *   appearance a = appearance_of(&s.material[m]);      colours; black: not called for
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
    vec3 flat, emits;
    vec3 matte, highlight, mirror, glossy, through;
    vec3 absorb;                 /* per unit of length */
    brdf lobe;                   /* white, of the exponent Ns */
    real ior;
    real rough;                  /* alpha (23): `mirror` and `through` are of facets; 0: smooth */
    bool fresnel, bends, solid;
    real excess;                 /* > 1: colours were divided by it */
    bool has_lobe;               /* highlight or glossy */
    unsigned calls;              /* effects that its parts take; 0: it is black */
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
    bool spread = !m->classic && m->said[MTL_NS].file && m->mtl.ns < appearance_mirror_ns;
    *(spread ? &a->glossy : &a->mirror) = colour;
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
    vec3 reflected = vmax(a->highlight, vadd(a->mirror, a->glossy));
    vec3 rest = vadd(a->matte, a->through);
    a->excess = vlargest(a->fresnel ? vmax(reflected, rest) : vadd(reflected, rest));
    if (!(a->excess > 1 + 16 * real_epsilon)) return;
    vec3 *part[] = {&a->matte, &a->highlight, &a->mirror, &a->glossy, &a->through};
    for (int k = 0; k < 5; k++) *part[k] = vscale(*part[k], 1 / a->excess);
}

/* Gives back light that falls on it: lights have something to do here. */
static inline bool appearance_lit(const appearance *a)
{
    return !vzero(a->matte) || !vzero(a->highlight) || !vzero(a->glossy) || a->rough > 0;
}

/* Bounds a body of glass. */
static inline bool appearance_body(const appearance *a) { return a->solid && !vzero(a->through); }

/* What its parts take, once they are known: a ray's hit asks for no others. */
static inline void appearance_note(appearance *a, real ns)
{
    const vec3 black = {0, 0, 0}, white = {1, 1, 1};
    a->lobe = brdf_blinn_phong(black, white, ns);
    a->has_lobe = !vzero(a->highlight) || !vzero(a->glossy);
    a->calls = (appearance_lit(a) ? EFFECTS_LIT : 0) | (vzero(a->matte) ? 0 : EFFECT_INDIRECT)
        | (vzero(a->glossy) && !(a->rough > 0) ? 0 : EFFECT_GLOSSY)
        | (vzero(a->mirror) ? 0 : EFFECT_MIRROR) | (vzero(a->through) ? 0 : EFFECT_REFRACTION)
        | (appearance_body(a) && !vzero(a->absorb) ? EFFECT_ABSORPTION : 0);
}

static inline appearance appearance_classic(const mtl_material *m)
{
    appearance a = {.matte = m->kd, .highlight = m->ks, .mirror = m->ks, .through = m->tf,
                    .emits = m->ke, .absorb = m->absorb, .ior = m->ni, .bends = m->ni != 1,
                    .solid = true};
    appearance_limit(&a), appearance_note(&a, m->ns);
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
    appearance a = {.matte = kd, .emits = m->ke, .ior = m->ni};
    switch (illum) {
    case 0: a.matte = (vec3){0, 0, 0}, a.flat = kd; break;
    case 2: case 8: case 9: if (lobe) a.highlight = m->ks; break;
    case 3: case 4: case 5: case 6: appearance_reflects(&a, of, m->ks); break;
    case 7: if (m->ni != 1) appearance_reflects(&a, of, appearance_surface(m)); break;
    }
    if (illum == 4 || illum == 9) {
        a.matte = vscale(kd, m->d);
        a.through = vmul(vscale(m->tf, 1 - m->d), vrest(m->ks));
    }
    if (illum == 6 || illum == 7) {
        a.matte = vmul(kd, vrest(m->tf));
        a.through = illum == 6 ? vmul(m->tf, vrest(m->ks)) : m->tf;
        a.bends = m->ni != 1, a.solid = true, a.absorb = m->absorb;
    }
    if (illum == 7 && m->ni != 1 && m->roughness > 0 && !vzero(a.through)) {
        a.rough = real_max(m->roughness * m->roughness, real_epsilon);  /* small is not 0 */
        a.matte = a.glossy = (vec3){0, 0, 0};
        a.mirror = (vec3){1, 1, 1};
    }
    a.fresnel = (illum == 5 || illum == 7) && !(vzero(a.mirror) && vzero(a.glossy));
    appearance_limit(&a), appearance_note(&a, m->ns);
    return a;
}

static inline appearance *appearances_of(const studio *s)
{
    appearance *look = allocate(s->materials, sizeof *look);
    for (size_t m = 0; m < s->materials; m++) look[m] = appearance_of(&s->material[m]);
    return look;
}

#endif
