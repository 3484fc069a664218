/* plan.h: what a scene calls for, decided before the first ray, and the line that says so.
 *
 *   plan p = plan_of(&s)
 *   p.effects, p.declined           masks of effect.h: what is simulated, what is left out
 *   p.verdict[k], p.why[k]          of effect k, in words for a person
 *   p.integrator                    the least that can do p.effects
 *   p.look[m]                       appearance of material m
 *   plan_effects(&p, m)             the effects that a hit of material m takes part in
 *   plan_free(&p)
 *
 * plan_rules below is all of it: the first rule that holds gives the verdict; if none does, the
 * effect is called for. Nothing that draws knows the plan but by the mask that it is given, so that
 * `--effects all` can refute it. plan_of_rules(&s, rules, n): by another table, for tests.
 */
#ifndef EFFECTS_PLAN_H
#define EFFECTS_PLAN_H

#include "effect.h"
#include "evidence.h"

typedef enum { VERDICT_CALLED, VERDICT_CANNOT, VERDICT_DECLINED } plan_verdict;

static const char *const verdict_names[] = {"called for", "cannot occur", "declined"};

/* If `holds` says which line it has read, the reason names it. */
typedef struct {
    unsigned effect;
    plan_verdict verdict;
    const char *name;
    bool (*holds)(const plan_facts *q, cite *line);
    const char *reason;
} plan_rule;

typedef struct {
    unsigned effects, declined;
    integrator integrator;
    plan_verdict verdict[effect_kinds];
    const plan_rule *rule[effect_kinds];  /* that held; NULL: none, it is called for */
    appearance *look;             /* [s.materials] */
    char why[effect_kinds][640];
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
PLAN_RULE(rule_unlit, !q->has[PART_LIT].n, no_line)
PLAN_RULE(rule_no_mirror, !q->has[PART_MIRROR].n, no_line)
PLAN_RULE(rule_no_lobe, !q->has[PART_GLOSSY].n, no_line)
PLAN_RULE(rule_opaque, !q->has[PART_THROUGH].n, no_line)
PLAN_RULE(rule_clear, !q->has[PART_ABSORB].n, no_line)
PLAN_RULE(rule_nothing_matte, !q->has[PART_MATTE].n, no_line)
PLAN_RULE(rule_dark, studio_dark(q->s), no_line)
PLAN_RULE(rule_one_plane, q->flat, no_line)
PLAN_RULE(rule_said_off, q->s->indirect == INDIRECT_OFF, q->s->indirect_said)
PLAN_RULE(rule_direct_formats, q->direct_only,
          q->lights ? q->s->light[q->first_light].at
          : q->s->emitters ? q->s->material[plan_emitter_material(q->s, 0)].at : no_line)
PLAN_RULE(rule_no_lens, !q->s->lens.said.file, no_line)
PLAN_RULE(rule_pinhole, !(q->s->lens.radius > 0), q->s->lens.said)
PLAN_RULE(rule_nothing_seen, !q->s->shapes && !q->s->solids && !q->s->places
                                 && q->s->sky.kind <= SKY_CONSTANT, no_line)

#define plan_unlit "no material in use is lit: none is matte, glossy, or has a highlight"

/* The whole plan. A proof, in the second column, is one that a reader can check in a line. */
static const plan_rule plan_rules[] = {
    {EFFECT_HARD_SHADOWS, VERDICT_CANNOT, "no light", rule_no_light, "no point light and no sun"},
    {EFFECT_HARD_SHADOWS, VERDICT_CANNOT, "black light", rule_black_light,
     "no point light and no sun that is not black"},
    {EFFECT_HARD_SHADOWS, VERDICT_CANNOT, "unlit", rule_unlit, plan_unlit},

    {EFFECT_SOFT_SHADOWS, VERDICT_CANNOT, "no lamp", rule_no_lamp,
     "nothing in use emits light (Ke)"},
    {EFFECT_SOFT_SHADOWS, VERDICT_CANNOT, "unlit", rule_unlit, plan_unlit},

    {EFFECT_MIRROR, VERDICT_CANNOT, "no mirror", rule_no_mirror,
     "no material in use reflects sharply (illum 3 to 7 with Ns 1000 or none; NFF: Ks)"},
    {EFFECT_GLOSSY, VERDICT_CANNOT, "no lobe", rule_no_lobe,
     "no material in use reflects in a lobe (illum 3 to 7 with Ns below 1000; roughness)"},
    {EFFECT_REFRACTION, VERDICT_CANNOT, "opaque", rule_opaque,
     "no material in use lets light through (illum 6, 7; 4, 9 with d below 1; NFF: T)"},
    {EFFECT_ABSORPTION, VERDICT_CANNOT, "clear", rule_clear,
     "no material in use lets light through and absorbs it inside (absorb)"},

    {EFFECT_INDIRECT, VERDICT_CANNOT, "nothing matte", rule_nothing_matte,
     "no material in use is matte (Kd)"},
    {EFFECT_INDIRECT, VERDICT_CANNOT, "dark", rule_dark, "there is no light to be passed on"},
    {EFFECT_INDIRECT, VERDICT_CANNOT, "one plane", rule_one_plane,
     "all that reflects is one flat polygon, and a plane does not see itself"},
    {EFFECT_INDIRECT, VERDICT_DECLINED, "said off", rule_said_off, "`indirect off`"},
    {EFFECT_INDIRECT, VERDICT_DECLINED, "direct formats", rule_direct_formats,
     "all light is of NFF or MTL, which define direct light only"},

    {EFFECT_ENVIRONMENT, VERDICT_CANNOT, "no sky", rule_no_sky, "no environment"},
    {EFFECT_ENVIRONMENT, VERDICT_CANNOT, "black sky", rule_black_sky,
     "no environment that is not black"},
    {EFFECT_ENVIRONMENT, VERDICT_CANNOT, "unlit", rule_unlit,
     "it is seen, but nothing gathers it"},

    {EFFECT_DEPTH_OF_FIELD, VERDICT_CANNOT, "no lens", rule_no_lens, "no lens is given"},
    {EFFECT_DEPTH_OF_FIELD, VERDICT_CANNOT, "pinhole", rule_pinhole, "the lens has radius 0"},
    {EFFECT_DEPTH_OF_FIELD, VERDICT_CANNOT, "nothing seen", rule_nothing_seen,
     "nothing is there that could be out of focus"}};

enum { plan_rule_count = sizeof plan_rules / sizeof *plan_rules };

/* ---- in words ---- */

static inline void plan_free(plan *p)
{
    free(p->look);
    p->look = NULL;
}

__attribute__((format(printf, 3, 4)))
static inline void plan_says(plan *p, int kind, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(p->why[kind], sizeof *p->why, format, arguments);
    va_end(arguments);
}

typedef struct { char text[300]; } plan_words;

static inline plan_words plan_more(size_t n)
{
    plan_words w = {""};
    if (n > 1) snprintf(w.text, sizeof w.text, " and %zu more", n - 1);
    return w;
}

static inline plan_words plan_line(const plan_facts *q, cite line)
{
    plan_words w;
    studio_said(q->s, line, w.text, sizeof w.text);
    return w;
}

/* "material 'red' (room.scene:7) and 3 more": the line that says most about why. None: a table of
 * rules that is wrong has called for it. */
static inline plan_words plan_name(const plan_facts *q, plan_group g, material_key key)
{
    if (g.n == 0) return (plan_words){"no material"};
    const studio_material *m = &q->s->material[g.first];
    plan_words w;
    snprintf(w.text, sizeof w.text, "material '%.60s' (%.150s)%.40s",
             studio_material_name(q->s, g.first),
             plan_line(q, m->said[key].file ? m->said[key] : m->at).text, plan_more(g.n).text);
    return w;
}

/* Of a part; rough glass says so, and not Ns; where illum is not said, d lets light through. */
static inline plan_words plan_part_name(const plan_facts *q, plan_part part, material_key key)
{
    plan_group g = q->has[part];
    bool rough = part == PART_GLOSSY && g.n && q->look[g.first].rough > 0;
    bool thin = part == PART_THROUGH && g.n && q->s->material[g.first].illum < 0;
    return plan_name(q, g, rough ? KEY_ROUGHNESS : thin ? KEY_D : key);
}

/* What calls for light that reaches a surface: the light, and the first surface. */
static inline void plan_because_light(plan *p, const plan_facts *q)
{
    const studio *s = q->s;
    plan_words by = plan_name(q, q->has[PART_LIT], KEY_ILLUM);
    if (p->effects & EFFECT_HARD_SHADOWS) {
        const studio_light *l = &s->light[q->first_light];
        plan_says(p, RAY_TO_LIGHT, "%s (%.150s)%s on %s",
                  l->light.kind == LIGHT_POINT ? "light" : "sun", plan_line(q, l->at).text,
                  plan_more(q->lights).text, by.text);
    }
    if (p->effects & EFFECT_SOFT_SHADOWS)
        plan_says(p, RAY_TO_LAMP, "%zu face%s of %s on %s", s->emitters,
                  s->emitters == 1 ? "" : "s, the first",
                  plan_name(q, (plan_group){plan_emitter_material(s, 0), 1}, KEY_KE).text, by.text);
    if (p->effects & EFFECT_ENVIRONMENT)
        plan_says(p, RAY_TO_SKY, "environment (%.150s) on %s", plan_line(q, s->sky_said).text,
                  by.text);
}

static inline void plan_because(plan *p, const plan_facts *q)
{
    static const struct { int kind; plan_part part; material_key key; } list[] = {
        {RAY_MIRRORED, PART_MIRROR, KEY_ILLUM}, {RAY_GLOSSY, PART_GLOSSY, KEY_NS},
        {RAY_REFRACTED, PART_THROUGH, KEY_ILLUM}, {RAY_ABSORBED, PART_ABSORB, KEY_ABSORB}};
    if (p->effects & EFFECTS_LIT) plan_because_light(p, q);
    for (size_t k = 0; k < sizeof list / sizeof *list; k++)
        if (p->effects >> list[k].kind & 1)
            plan_says(p, list[k].kind, "%s", plan_part_name(q, list[k].part, list[k].key).text);
    if (p->effects & EFFECT_INDIRECT) {
        bool lit = q->lights > 0, lamp = q->s->emitters > 0;
        plan_says(p, RAY_SCATTERED, "%s, lit by%s%s%s%s%s",
                  plan_name(q, q->has[PART_MATTE], KEY_KD).text, lit ? " lights" : "",
                  lit && lamp ? "," : "", lamp ? " lamps (Ke)" : "",
                  q->around && (lit || lamp) ? "," : "", q->around ? " environment" : "");
    }
    if (p->effects & EFFECT_DEPTH_OF_FIELD)
        plan_says(p, RAY_OF_LENS, "lens (%.150s), radius %g", plan_line(q, q->s->lens.said).text,
                  (double)q->s->lens.radius);
}

/* ---- the plan ---- */

/* The first rule of the table that holds for this effect; NULL: it is called for. */
static inline const plan_rule *plan_first(const plan_facts *q, const plan_rule *rule, size_t n,
                                          unsigned effect, cite *line)
{
    for (size_t i = 0; i < n; i++) {
        *line = (cite){0, 0};
        if (rule[i].effect == effect && rule[i].holds(q, line)) return &rule[i];
    }
    return NULL;
}

static inline plan plan_of_rules(const studio *s, const plan_rule *rules, size_t n)
{
    plan p = {.look = allocate(s->materials, sizeof *p.look)};
    for (size_t m = 0; m < s->materials; m++) p.look[m] = appearance_of(&s->material[m]);
    plan_facts q = plan_facts_of(s, p.look);
    for (int k = 0; k < effect_kinds; k++) {
        cite line;
        const plan_rule *r = plan_first(&q, rules, n, 1u << k, &line);
        p.rule[k] = r, p.verdict[k] = r ? r->verdict : VERDICT_CALLED;
        if (!r) p.effects |= 1u << k;
        else if (line.file) plan_says(&p, k, "%s (%.150s)", r->reason, plan_line(&q, line).text);
        else plan_says(&p, k, "%s", r->reason);
        if (p.verdict[k] == VERDICT_DECLINED) p.declined |= 1u << k;
    }
    plan_because(&p, &q);
    p.integrator = integrator_of(p.effects);
    return p;
}

static inline plan plan_of(const studio *s)
{
    return plan_of_rules(s, plan_rules, plan_rule_count);
}

/* What a hit of this material has a part in. */
static inline unsigned plan_effects(const plan *p, uint32_t m)
{
    static const unsigned of[plan_parts] = {EFFECTS_LIT, EFFECT_INDIRECT, EFFECT_MIRROR,
                                            EFFECT_GLOSSY, EFFECT_REFRACTION, EFFECT_ABSORPTION};
    unsigned own = 0;
    for (int k = 0; k < plan_parts; k++)
        if (plan_has(&p->look[m], (plan_part)k)) own |= of[k];
    return own & p->effects;
}

#endif
