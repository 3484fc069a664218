/* plan.h: which effects a scene calls for, by what, or why not; and so how it is to be drawn.
 *
 *   plan p = plan_of(&s);            s finished (studio_read.h)
 *   p.effects                        mask of effect.h; p.integrator: the least that does them
 *   p.why[k]                         what calls for effect k, by name and line, or why not
 *   p.look[m]                        appearance of material m
 *   plan_effects(&p, m)              those that a hit of material m has a part in
 *   p.headlight                      no light at all is there: each ray carries a lamp
 *   plan_free(&p)
 *
 *   effect            called for if all of these are so
 *   hard shadows      a point light or sun that is not black; a material in use that is lit by it
 *   soft shadows      a face in use emits (Ke); a material in use is lit
 *   environment       an environment that is not black; a material in use is lit
 *   mirror, glossy,   a material in use has such a part (appearance.h)
 *     refraction
 *   absorption        a material in use refracts and absorbs
 *   indirect light    a material in use is matte; light comes from faces (Ke) or an environment;
 *                     what reflects does not all lie in one plane x, y or z = constant
 *   depth of field    the lens has a radius; something is there, or a sky of many colours
 *
 * lit: matte, highlight or glossy is not black. In use: a shape or a triangle that is placed has
 * it.
 *
 * Why point lights and suns call for no indirect light: they and the `illum` numbers come from
 * models where light reaches a surface straight from a lamp (Phong, Whitted), or by mirrors and
 * glass. Who gives a lamp a size, or the sky a radiance, speaks of radiometry, and there every
 * matte surface lights every other. --effects called,indirect asks for it all the same.
 *
 * Without any light that is not black (no point light, sun, Ke, environment) the picture would be
 * black: then each ray carries a lamp of its own, a matte surface at angle theta shows
 * (matte + highlight + glossy) |cos theta|, and no shadow is there to be seen, so none is traced.
 */
#ifndef EFFECTS_PLAN_H
#define EFFECTS_PLAN_H

#include "effect.h"
#include "flat.h"

typedef struct {
    unsigned effects;
    integrator integrator;
    bool headlight;
    appearance *look;             /* [s.materials] */
    char why[effect_kinds][640];
} plan;

/* ---------------------------------------------------------------------------------------------- */

static inline void plan_free(plan *p)
{
    free(p->look);
    p->look = NULL;
}

/* Materials in use that have something in common: the first, and how many. */
typedef struct { uint32_t first; size_t n; } plan_group;

typedef enum {
    PART_LIT, PART_MATTE, PART_MIRROR, PART_GLOSSY, PART_THROUGH, PART_ABSORB
} plan_part;

static inline bool plan_has(const appearance *a, plan_part part)
{
    switch (part) {
    case PART_LIT: return appearance_lit(a);
    case PART_MATTE: return !vzero(a->matte);
    case PART_MIRROR: return !vzero(a->mirror);
    case PART_GLOSSY: return !vzero(a->glossy);
    case PART_THROUGH: return !vzero(a->through);
    case PART_ABSORB: return !vzero(a->through) && a->solid && !vzero(a->absorb);
    }
    return false;
}

static inline plan_group plan_find(const studio *s, const plan *p, plan_part part)
{
    plan_group g = {name_none, 0};
    for (uint32_t m = 0; m < s->materials; m++) {
        if (!s->material[m].used || !plan_has(&p->look[m], part)) continue;
        if (g.n++ == 0) g.first = m;
    }
    return g;
}

/* The line of a material that says most about why: of illum if it is there. */
static inline cite plan_cite(const studio_material *m, material_key key)
{
    return m->said[key].file ? m->said[key] : m->at;
}

static inline const char *plan_more(char text[32], size_t n)
{
    if (n < 2) text[0] = 0;
    else snprintf(text, 32, " and %zu more", n - 1);
    return text;
}

/* "material 'red' (room.scene:7) and 3 more" */
static inline const char *plan_name(const studio *s, plan_group g, material_key key, char *text,
                                    size_t room)
{
    char said[300], more[32];
    snprintf(text, room, "material '%.60s' (%.150s)%s", studio_material_name(s, g.first),
             studio_said(s, plan_cite(&s->material[g.first], key), said, sizeof said),
             plan_more(more, g.n));
    return text;
}

__attribute__((format(printf, 4, 5)))
static inline void plan_says(plan *p, unsigned effect, bool called, const char *format, ...)
{
    int k = 0;
    va_list arguments;
    while (1u << k != effect) k++;
    if (called) p->effects |= effect;
    va_start(arguments, format);
    vsnprintf(p->why[k], sizeof p->why[k], format, arguments);
    va_end(arguments);
}

/* ---- the effects, one after the other ---- */

static inline void plan_shadows(plan *p, const studio *s, plan_group lit, size_t lamps,
                                size_t first)
{
    char lamp[300] = "", by[300] = "", more[32];
    bool on = lit.n > 0;
    if (on) plan_name(s, lit, KEY_ILLUM, by, sizeof by);
    if (!lamps) plan_says(p, EFFECT_HARD_SHADOWS, false, "no point light and no sun%s",
                          s->lights ? " that is not black" : "");
    else if (!on) plan_says(p, EFFECT_HARD_SHADOWS, false, "no material in use is lit by lights");
    else plan_says(p, EFFECT_HARD_SHADOWS, true, "%s (%.150s)%s on %s",
                   s->light[first].light.kind == LIGHT_POINT ? "light" : "sun",
                   studio_said(s, s->light[first].at, lamp, sizeof lamp), plan_more(more, lamps),
                   by);
    if (!s->emitters) plan_says(p, EFFECT_SOFT_SHADOWS, false, "nothing in use emits light (Ke)");
    else if (!on) plan_says(p, EFFECT_SOFT_SHADOWS, false, "no material in use is lit by lamps");
    else {
        studio_emitter e = s->emitter[0];
        uint32_t m = e.place == no_shape ? s->shape_material[e.index]
                                         : studio_material_of(s, e.place, e.index);
        plan_says(p, EFFECT_SOFT_SHADOWS, true, "%zu face%s of %s on %s", s->emitters,
                  s->emitters == 1 ? "" : "s, the first",
                  plan_name(s, (plan_group){m, 1}, KEY_KE, lamp, sizeof lamp), by);
    }
    if (!sky_lights(&s->sky)) plan_says(p, EFFECT_ENVIRONMENT, false, "no environment%s",
                                        s->sky.kind == SKY_NONE ? "" : " that is not black");
    else if (!on) plan_says(p, EFFECT_ENVIRONMENT, false, "it is seen, but nothing gathers it");
    else plan_says(p, EFFECT_ENVIRONMENT, true, "environment (%.150s) on %s",
                   studio_said(s, s->sky_said, lamp, sizeof lamp), by);
}

static inline void plan_reflections(plan *p, const studio *s)
{
    static const struct { unsigned effect; plan_part part; material_key key; const char *not; }
        list[] = {
            {EFFECT_MIRROR, PART_MIRROR, KEY_ILLUM, "no material in use reflects sharply (illum 3 "
             "to 7 with Ns 1000 or none; NFF: Ks)"},
            {EFFECT_GLOSSY, PART_GLOSSY, KEY_NS, "no material in use reflects in a lobe (illum 3 "
             "to 7 with Ns below 1000)"},
            {EFFECT_REFRACTION, PART_THROUGH, KEY_ILLUM, "no material in use lets light through "
             "(illum 6, 7; 4, 9 with d below 1; NFF: T)"},
            {EFFECT_ABSORPTION, PART_ABSORB, KEY_ABSORB, "no material in use lets light through "
             "and absorbs it inside (absorb)"}};
    char by[300];
    for (int k = 0; k < 4; k++) {
        plan_group g = plan_find(s, p, list[k].part);
        plan_says(p, list[k].effect, g.n > 0, "%s",
                  g.n ? plan_name(s, g, list[k].key, by, sizeof by) : list[k].not);
    }
}

static inline void plan_indirect(plan *p, const studio *s)
{
    char by[300];
    bool lamps = s->emitters > 0, around = sky_lights(&s->sky);
    plan_group matte = plan_find(s, p, PART_MATTE);
    if (!matte.n) plan_says(p, EFFECT_INDIRECT, false, "no material in use is matte (Kd)");
    else if (!lamps && !around)
        plan_says(p, EFFECT_INDIRECT, false, "no light has a size (Ke, environment); points and "
                  "suns are of models without it");
    else if (flat_studio(s, p->look))
        plan_says(p, EFFECT_INDIRECT, false, "all that reflects lies in one plane");
    else plan_says(p, EFFECT_INDIRECT, true, "%s, lit by %s",
                   plan_name(s, matte, KEY_KD, by, sizeof by),
                   lamps && around ? "Ke and environment" : lamps ? "Ke" : "environment");
}

static inline plan plan_of(const studio *s)
{
    plan p = {.look = allocate(s->materials, sizeof *p.look)};
    char said[300];
    size_t lamps = 0, first = 0;
    for (size_t m = 0; m < s->materials; m++) p.look[m] = appearance_of(&s->material[m]);
    for (size_t i = s->lights; i-- > 0;)
        if (!vzero(s->light[i].light.colour)) lamps++, first = i;
    plan_group lit = plan_find(s, &p, PART_LIT);
    plan_shadows(&p, s, lit, lamps, first);
    plan_reflections(&p, s);
    plan_indirect(&p, s);
    if (!s->lens.said.file) plan_says(&p, EFFECT_DEPTH_OF_FIELD, false, "no lens is given");
    else if (!s->shapes && !s->places && s->sky.kind <= SKY_CONSTANT)
        plan_says(&p, EFFECT_DEPTH_OF_FIELD, false, "nothing is there that could be out of focus");
    else plan_says(&p, EFFECT_DEPTH_OF_FIELD, s->lens.radius > 0, "lens (%.150s), radius %g",
                   studio_said(s, s->lens.said, said, sizeof said), (double)s->lens.radius);
    p.headlight = !lamps && !s->emitters && !sky_lights(&s->sky);
    p.integrator = integrator_of(p.effects);
    return p;
}

/* What a hit of this material has a part in. */
static inline unsigned plan_effects(const plan *p, uint32_t m)
{
    const appearance *a = &p->look[m];
    unsigned own = plan_has(a, PART_LIT) ? (unsigned)EFFECTS_LIT : 0;
    if (plan_has(a, PART_MATTE)) own |= EFFECT_INDIRECT;
    if (plan_has(a, PART_MIRROR)) own |= EFFECT_MIRROR;
    if (plan_has(a, PART_GLOSSY)) own |= EFFECT_GLOSSY;
    if (plan_has(a, PART_THROUGH)) own |= EFFECT_REFRACTION;
    if (plan_has(a, PART_ABSORB)) own |= EFFECT_ABSORPTION;
    return own & p->effects;
}

#endif
