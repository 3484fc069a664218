/* plan.h: what a scene calls for, decided before the first ray.
 *
 *   plan p = plan_of(&s)            O(scene)
 *   p.effects, p.declined           masks of effect.h: what is simulated, what is left out
 *   p.verdict[k]                    of effect k
 *   p.rule[k], p.line[k]            that gave it, and which line of the scene says so; NULL: none
 *                                   did, it is called for
 *   p.facts                         what the scene says that bears on it
 *   plan_free(&p)
 *
 * plan_rules below is all of it: the first rule that holds gives the verdict; if none does, the
 * effect is called for. Nothing that draws knows the plan but by the mask that it is given, so that
 * `--effects all` can refute it. plan_of_rules(&s, rules): by another table, for tests.
 *
 * In use: a shape or a triangle that is placed is made of it. Lit: matte, highlight or glossy is
 * not black. The lights of NFF are of 1987, the numbers of `illum` in MTL say "ambient, diffuse,
 * specular", and neither has a word for light that walls pass on. Who writes a lamp into a scene
 * file speaks of radiometry.
 */
#ifndef EFFECTS_PLAN_H
#define EFFECTS_PLAN_H

#include "appearance.h"

typedef enum { VERDICT_CALLED, VERDICT_CANNOT, VERDICT_DECLINED } plan_verdict;

static const char *const verdict_names[] = {"called for", "cannot occur", "declined"};

/* Materials in use that have something in common: the first, and how many. */
typedef struct { uint32_t first; size_t n; } plan_group;

typedef struct {
    const studio *s;
    appearance *look;             /* [s->materials] */
    plan_group has[effect_kinds]; /* take part in effect k; RAY_TO_LIGHT: are lit */
    size_t lights, first_light;   /* point lights and suns that are not black */
    bool around;                  /* an environment that is not black */
    bool flat;                    /* all that reflects is one polygon in a plane, or nothing: what
                                     leaves it meets nothing that could send it back */
    bool direct_only;             /* all the light there is comes from formats that know direct
                                     light alone, and nobody says `indirect on` */
} plan_facts;

typedef struct {
    unsigned effect;
    plan_verdict verdict;
    bool (*holds)(const plan_facts *q, cite *line);
    const char *reason;
} plan_rule;

typedef struct {
    plan_facts facts;
    unsigned effects, declined;
    plan_verdict verdict[effect_kinds];
    const plan_rule *rule[effect_kinds];
    cite line[effect_kinds];
} plan;

/* ---------------------------------------------------------------------------------------------- */

/* A rule: what it asks, and the line of the scene that says so; no_line: none does. */
#define PLAN_RULE(name, test, said)                                   \
    static inline bool name(const plan_facts *q, cite *line)          \
    {                                                                 \
        *line = said;                                                 \
        return test;                                                  \
    }
#define no_line ((cite){0, 0})
PLAN_RULE(rule_no_light, q->s->lights == 0, no_line)
PLAN_RULE(rule_black_light, q->lights == 0, q->s->lights ? q->s->light[0].at : no_line)
PLAN_RULE(rule_no_lamp, q->s->emitters == 0, no_line)
PLAN_RULE(rule_no_sky, q->s->sky.kind == SKY_NONE, no_line)
PLAN_RULE(rule_black_sky, !q->around, q->s->sky_said)
PLAN_RULE(rule_unlit, !q->has[RAY_TO_LIGHT].n, no_line)
PLAN_RULE(rule_no_mirror, !q->has[RAY_MIRRORED].n, no_line)
PLAN_RULE(rule_no_lobe, !q->has[RAY_GLOSSY].n, no_line)
PLAN_RULE(rule_opaque, !q->has[RAY_REFRACTED].n, no_line)
PLAN_RULE(rule_clear, !q->has[RAY_ABSORBED].n, no_line)
PLAN_RULE(rule_nothing_matte, !q->has[RAY_SCATTERED].n, no_line)
PLAN_RULE(rule_dark, studio_dark(q->s), no_line)
PLAN_RULE(rule_one_plane, q->flat, no_line)
PLAN_RULE(rule_said_off, q->s->indirect == INDIRECT_OFF, q->s->indirect_said)
PLAN_RULE(rule_direct_formats, q->direct_only,
          q->lights ? q->s->light[q->first_light].at
          : q->s->emitters ? q->s->material[studio_emitter_material(q->s, 0)].at : no_line)
PLAN_RULE(rule_no_lens, !q->s->lens.said.file, no_line)
PLAN_RULE(rule_pinhole, !(q->s->lens.radius > 0), q->s->lens.said)
PLAN_RULE(rule_nothing_seen, !q->s->shapes && !q->s->solids && !q->s->places
                                 && q->s->sky.kind <= SKY_CONSTANT, no_line)

#define plan_unlit "no material in use is lit: none is matte, glossy, or has a highlight"

/* The whole plan. A proof, in the last column, is one that a reader can check in a line. */
static const plan_rule plan_rules[] = {
    {EFFECT_HARD_SHADOWS, VERDICT_CANNOT, rule_no_light, "no point light and no sun"},
    {EFFECT_HARD_SHADOWS, VERDICT_CANNOT, rule_black_light,
     "no point light and no sun that is not black"},
    {EFFECT_HARD_SHADOWS, VERDICT_CANNOT, rule_unlit, plan_unlit},

    {EFFECT_SOFT_SHADOWS, VERDICT_CANNOT, rule_no_lamp, "nothing in use emits light (Ke)"},
    {EFFECT_SOFT_SHADOWS, VERDICT_CANNOT, rule_unlit, plan_unlit},

    {EFFECT_MIRROR, VERDICT_CANNOT, rule_no_mirror,
     "no material in use reflects sharply (illum 3 to 7 with Ns 1000 or none; NFF: Ks)"},
    {EFFECT_GLOSSY, VERDICT_CANNOT, rule_no_lobe,
     "no material in use reflects in a lobe (illum 3 to 7 with Ns below 1000; roughness)"},
    {EFFECT_REFRACTION, VERDICT_CANNOT, rule_opaque,
     "no material in use lets light through (illum 6, 7; 4, 9 with d below 1; NFF: T)"},
    {EFFECT_ABSORPTION, VERDICT_CANNOT, rule_clear,
     "no material in use lets light through and absorbs it inside (absorb)"},

    {EFFECT_INDIRECT, VERDICT_CANNOT, rule_nothing_matte, "no material in use is matte (Kd)"},
    {EFFECT_INDIRECT, VERDICT_CANNOT, rule_dark, "there is no light to be passed on"},
    {EFFECT_INDIRECT, VERDICT_CANNOT, rule_one_plane,
     "all that reflects is one flat polygon, and a plane does not see itself"},
    {EFFECT_INDIRECT, VERDICT_DECLINED, rule_said_off, "`indirect off`"},
    {EFFECT_INDIRECT, VERDICT_DECLINED, rule_direct_formats,
     "all light is of NFF or MTL, which define direct light only"},

    {EFFECT_ENVIRONMENT, VERDICT_CANNOT, rule_no_sky, "no environment"},
    {EFFECT_ENVIRONMENT, VERDICT_CANNOT, rule_black_sky, "no environment that is not black"},
    {EFFECT_ENVIRONMENT, VERDICT_CANNOT, rule_unlit, "it is seen, but nothing gathers it"},

    {EFFECT_DEPTH_OF_FIELD, VERDICT_CANNOT, rule_no_lens, "no lens is given"},
    {EFFECT_DEPTH_OF_FIELD, VERDICT_CANNOT, rule_pinhole, "the lens has radius 0"},
    {EFFECT_DEPTH_OF_FIELD, VERDICT_CANNOT, rule_nothing_seen,
     "nothing is there that could be out of focus"}};

enum { plan_rule_count = sizeof plan_rules / sizeof *plan_rules };

/* ---- what the scene says ---- */

/* Rough glass calls for no mirror: its facets are glossy. */
static inline unsigned plan_calls(const appearance *a)
{
    return a->m.alpha > 0 ? a->calls & ~(unsigned)EFFECT_MIRROR : a->calls;
}

static inline plan_group plan_find(const plan_facts *q, int kind)
{
    plan_group g = {name_none, 0};
    for (uint32_t m = 0; m < q->s->materials; m++)
        if (q->s->material[m].used && plan_calls(&q->look[m]) >> kind & 1 && !g.n++) g.first = m;
    return g;
}

/* Meshes and solids are not looked into: with one of them the scene counts as not flat. */
static inline bool plan_flat(const studio *s, const appearance *look)
{
    size_t reflecting = 0;
    for (size_t i = 0; i < s->shapes; i++) {
        if (!look[s->shape_material[i]].calls) continue;
        const shape *x = &s->shape[i];
        if (x->kind != SHAPE_POLYGON || !polygon_is_flat(&x->polygon) || reflecting++ > 0)
            return false;
    }
    return !s->places && !s->solids;
}

static inline bool plan_direct_only(const plan_facts *q)
{
    const studio *s = q->s;
    if (s->indirect == INDIRECT_ON || q->around) return false;
    for (size_t i = 0; i < s->lights; i++)
        if (!vzero(s->light[i].light.colour) && !s->light[i].classic) return false;
    for (size_t i = 0; i < s->emitters; i++)
        if (!s->material[studio_emitter_material(s, i)].library) return false;
    return true;
}

static inline plan_facts plan_facts_of(const studio *s)
{
    plan_facts q = {.s = s, .look = appearances_of(s), .around = sky_lights(&s->sky)};
    for (int k = 0; k < effect_kinds; k++) q.has[k] = plan_find(&q, k);
    for (size_t i = s->lights; i-- > 0;)
        if (!vzero(s->light[i].light.colour)) q.lights++, q.first_light = i;
    q.flat = plan_flat(s, q.look), q.direct_only = plan_direct_only(&q);
    return q;
}

/* ---- the plan ---- */

static inline void plan_free(plan *p)
{
    free(p->facts.look);
    p->facts.look = NULL;
}

static inline plan plan_of_rules(const studio *s, const plan_rule rules[plan_rule_count])
{
    plan p = {.facts = plan_facts_of(s)};
    for (int k = 0; k < effect_kinds; k++) {
        const unsigned bit = 1u << k;
        const plan_rule *r = rules, *end = rules + plan_rule_count;
        while (r < end && !(r->effect == bit && r->holds(&p.facts, &p.line[k]))) r++;
        p.rule[k] = r < end ? r : NULL, p.verdict[k] = r < end ? r->verdict : VERDICT_CALLED;
        if (p.verdict[k] == VERDICT_CALLED) p.effects |= bit;
        if (p.verdict[k] == VERDICT_DECLINED) p.declined |= bit;
    }
    return p;
}

static inline plan plan_of(const studio *s) { return plan_of_rules(s, plan_rules); }

#endif
