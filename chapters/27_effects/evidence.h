/* evidence.h: what a scene says that bears on its effects: read once, before the plan is drawn up.
 *
 *   plan_facts q = plan_facts_of(&s, look)     look[m]: appearance of material m; O(scene)
 *   q.has[PART_MIRROR]                         materials in use that reflect sharply: the first,
 *                                              and how many
 *   q.lights, q.first_light                    point lights and suns that are not black
 *   q.around                                   an environment that is not black
 *   q.flat                                     all that reflects is one polygon in a plane, or
 *                                              nothing: what leaves it meets nothing that could
 *                                              send it back
 *   q.direct_only                              all the light there is comes from formats that know
 *                                              direct light alone, and nobody says `indirect on`
 *
 * In use: a shape or a triangle that is placed is made of it. Lit: matte, highlight or glossy is
 * not black. The lights of NFF are of 1987, the numbers of `illum` in MTL say "ambient, diffuse,
 * specular", and neither has a word for light that walls pass on. Who writes a lamp into a scene
 * file speaks of radiometry.
 */
#ifndef EFFECTS_EVIDENCE_H
#define EFFECTS_EVIDENCE_H

#include "appearance.h"

typedef enum {
    PART_LIT, PART_MATTE, PART_MIRROR, PART_GLOSSY, PART_THROUGH, PART_ABSORB, plan_parts
} plan_part;

/* Materials in use that have something in common: the first, and how many. */
typedef struct { uint32_t first; size_t n; } plan_group;

typedef struct {
    const studio *s;
    const appearance *look;
    plan_group has[plan_parts];
    size_t lights, first_light;
    bool around, flat, direct_only;
} plan_facts;

/* ---------------------------------------------------------------------------------------------- */

static inline bool plan_has(const appearance *a, plan_part part)
{
    switch (part) {
    case PART_LIT: return appearance_lit(a);
    case PART_MATTE: return !vzero(a->matte);
    case PART_MIRROR: return !vzero(a->mirror) && !(a->rough > 0);
    case PART_GLOSSY: return !vzero(a->glossy) || a->rough > 0;
    case PART_THROUGH: return !vzero(a->through);
    case PART_ABSORB: return !vzero(a->through) && a->solid && !vzero(a->absorb);
    case plan_parts: break;
    }
    return false;
}

static inline plan_group plan_find(const studio *s, const appearance *look, plan_part part)
{
    plan_group g = {name_none, 0};
    for (uint32_t m = 0; m < s->materials; m++) {
        if (!s->material[m].used || !plan_has(&look[m], part)) continue;
        if (g.n++ == 0) g.first = m;
    }
    return g;
}

/* Meshes and solids are not looked into: with one of them the scene counts as not flat. */
static inline bool plan_flat(const studio *s, const appearance *look)
{
    size_t reflecting = 0;
    for (size_t i = 0; i < s->shapes; i++) {
        if (appearance_black(&look[s->shape_material[i]])) continue;
        const shape *x = &s->shape[i];
        if (x->kind != SHAPE_POLYGON || !polygon_is_flat(&x->polygon) || reflecting++ > 0)
            return false;
    }
    return !s->places && !s->solids;
}

/* The material of a face that emits. */
static inline uint32_t plan_emitter_material(const studio *s, size_t i)
{
    studio_face e = s->emitter[i];
    return e.place == no_shape ? s->shape_material[e.index]
                               : studio_material_of(s, e.place, e.index);
}

static inline bool plan_direct_only(const plan_facts *q)
{
    const studio *s = q->s;
    if (s->indirect == INDIRECT_ON || q->around) return false;
    for (size_t i = 0; i < s->lights; i++)
        if (!vzero(s->light[i].light.colour) && !s->light[i].classic) return false;
    for (size_t i = 0; i < s->emitters; i++)
        if (!s->material[plan_emitter_material(s, i)].library) return false;
    return true;
}

static inline plan_facts plan_facts_of(const studio *s, const appearance *look)
{
    plan_facts q = {.s = s, .look = look, .around = sky_lights(&s->sky),
                    .flat = plan_flat(s, look)};
    for (int k = 0; k < plan_parts; k++) q.has[k] = plan_find(s, look, (plan_part)k);
    for (size_t i = s->lights; i-- > 0;)
        if (!vzero(s->light[i].light.colour)) q.lights++, q.first_light = i;
    q.direct_only = plan_direct_only(&q);
    return q;
}

#endif
