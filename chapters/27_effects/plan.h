/* plan.h: what a scene calls for, decided before the first ray, and the line that says so.
 *
 *   plan p = plan_of(&s)
 *   p.effects, p.declined           masks of effect.h: what is simulated, what is left out
 *   p.verdict[k], p.why[k]          of effect k, in words for a person
 *   p.integrator                    the least that can do p.effects
 *   p.look[m]                       appearance of material m, as plan_of found it
 *   plan_effects(&p, m)             the effects that a hit of material m takes part in
 *   plan_free(&p)
 *
 *   called for     no rule speaks against it
 *   cannot occur   a rule proves it: switched on, it changes nothing
 *   declined       it would occur, but the scene or its format says no; --price says what is lost
 *
 * plan_rules below is all of it: the first rule that holds gives the verdict. Nothing that draws
 * knows the plan but by the mask that it is given, so that `--effects all` can refute it: stage.h.
 *
 *   plan_of_rules(&s, rules, n)     the plan by another table: tests break one rule, and look
 *                                   whether the pictures tell
 */
#ifndef EFFECTS_PLAN_H
#define EFFECTS_PLAN_H

#include "effect.h"
#include "evidence.h"

typedef enum { VERDICT_CALLED, VERDICT_CANNOT, VERDICT_DECLINED } plan_verdict;

static const char *const verdict_names[] = {"called for", "cannot occur", "declined"};

/* `holds` may say which line it has read; then the reason names it. */
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

/* Rules that no line of the scene speaks of. */
#define PLAN_RULE(name, test)                                         \
    static inline bool name(const plan_facts *q, cite *line)          \
    {                                                                 \
        (void)line;                                                   \
        return test;                                                  \
    }
PLAN_RULE(rule_no_light, q->s->lights == 0)
PLAN_RULE(rule_no_lamp, q->s->emitters == 0)
PLAN_RULE(rule_no_sky, q->s->sky.kind == SKY_NONE)
PLAN_RULE(rule_unlit, !q->has[PART_LIT].n)
PLAN_RULE(rule_no_mirror, !q->has[PART_MIRROR].n)
PLAN_RULE(rule_no_lobe, !q->has[PART_GLOSSY].n)
PLAN_RULE(rule_opaque, !q->has[PART_THROUGH].n)
PLAN_RULE(rule_clear, !q->has[PART_ABSORB].n)
PLAN_RULE(rule_nothing_matte, !q->has[PART_MATTE].n)
PLAN_RULE(rule_dark, !q->lights && !q->s->emitters && !q->around)
PLAN_RULE(rule_one_plane, q->flat)
PLAN_RULE(rule_no_lens, !q->s->lens.said.file)
PLAN_RULE(rule_nothing_seen, !q->s->shapes && !q->s->solids && !q->s->places
                                 && q->s->sky.kind <= SKY_CONSTANT)

static inline bool rule_black_light(const plan_facts *q, cite *line)
{
    if (q->s->lights > 0) *line = q->s->light[0].at;
    return q->lights == 0;
}

static inline bool rule_black_sky(const plan_facts *q, cite *line)
{
    *line = q->s->sky_said;
    return !q->around;
}

static inline bool rule_said_off(const plan_facts *q, cite *line)
{
    *line = q->s->indirect_said;
    return q->s->indirect == INDIRECT_OFF;
}

static inline bool rule_direct_formats(const plan_facts *q, cite *line)
{
    if (q->lights) *line = q->s->light[q->first_light].at;
    else if (q->s->emitters) *line = q->s->material[plan_emitter_material(q->s, 0)].at;
    return q->direct_only;
}

static inline bool rule_pinhole(const plan_facts *q, cite *line)
{
    *line = q->s->lens.said;
    return !(q->s->lens.radius > 0);
}

/* The whole plan. A proof, in the second column, is one that a reader can check in a line. */
static const plan_rule plan_rules[] = {
    {EFFECT_HARD_SHADOWS, VERDICT_CANNOT, "no light", rule_no_light, "no point light and no sun"},
    {EFFECT_HARD_SHADOWS, VERDICT_CANNOT, "black light", rule_black_light,
     "no point light and no sun that is not black"},
    {EFFECT_HARD_SHADOWS, VERDICT_CANNOT, "unlit", rule_unlit,
     "no material in use is lit: none is matte, glossy, or has a highlight"},

    {EFFECT_SOFT_SHADOWS, VERDICT_CANNOT, "no lamp", rule_no_lamp,
     "nothing in use emits light (Ke)"},
    {EFFECT_SOFT_SHADOWS, VERDICT_CANNOT, "unlit", rule_unlit,
     "no material in use is lit: none is matte, glossy, or has a highlight"},

    {EFFECT_MIRROR, VERDICT_CANNOT, "no mirror", rule_no_mirror,
     "no material in use reflects sharply (illum 3 to 7 with Ns 1000 or none; NFF: Ks)"},
    {EFFECT_GLOSSY, VERDICT_CANNOT, "no lobe", rule_no_lobe,
     "no material in use reflects in a lobe (illum 3 to 7 with Ns below 1000)"},
    {EFFECT_REFRACTION, VERDICT_CANNOT, "opaque", rule_opaque,
     "no material in use lets light through (illum 6, 7; 4, 9 with d below 1; NFF: T)"},
    {EFFECT_ABSORPTION, VERDICT_CANNOT, "clear", rule_clear,
     "no material in use lets light through and absorbs it inside (absorb)"},

    {EFFECT_INDIRECT, VERDICT_CANNOT, "nothing matte", rule_nothing_matte,
     "no material in use is matte (Kd)"},
    {EFFECT_INDIRECT, VERDICT_CANNOT, "dark", rule_dark, "there is no light to be passed on"},
    {EFFECT_INDIRECT, VERDICT_CANNOT, "one plane", rule_one_plane,
     "all that reflects lies in one plane, and a plane does not see itself"},
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

static inline const char *plan_more(char text[32], size_t n)
{
    if (n < 2) text[0] = 0;
    else snprintf(text, 32, " and %zu more", n - 1);
    return text;
}

/* "material 'red' (room.scene:7) and 3 more": the line that says most about why. */
static inline const char *plan_name(const plan_facts *q, plan_group g, material_key key, char *text,
                                    size_t room)
{
    const studio_material *m = &q->s->material[g.first];
    char said[300], more[32];
    snprintf(text, room, "material '%.60s' (%.150s)%s", studio_material_name(q->s, g.first),
             studio_said(q->s, m->said[key].file ? m->said[key] : m->at, said, sizeof said),
             plan_more(more, g.n));
    return text;
}

__attribute__((format(printf, 3, 4)))
static inline void plan_says(plan *p, unsigned effect, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(p->why[effect_number(effect)], sizeof *p->why, format, arguments);
    va_end(arguments);
}

/* What calls for light that reaches a surface: the light, and the first surface. */
static inline void plan_because_light(plan *p, const plan_facts *q)
{
    const studio *s = q->s;
    char lamp[300], by[300], more[32];
    plan_name(q, q->has[PART_LIT], KEY_ILLUM, by, sizeof by);
    if (p->effects & EFFECT_HARD_SHADOWS) {
        const studio_light *l = &s->light[q->first_light];
        plan_says(p, EFFECT_HARD_SHADOWS, "%s (%.150s)%s on %s",
                  l->light.kind == LIGHT_POINT ? "light" : "sun",
                  studio_said(s, l->at, lamp, sizeof lamp), plan_more(more, q->lights), by);
    }
    if (p->effects & EFFECT_SOFT_SHADOWS) {
        plan_group first = {plan_emitter_material(s, 0), 1};
        plan_says(p, EFFECT_SOFT_SHADOWS, "%zu face%s of %s on %s", s->emitters,
                  s->emitters == 1 ? "" : "s, the first",
                  plan_name(q, first, KEY_KE, lamp, sizeof lamp), by);
    }
    if (p->effects & EFFECT_ENVIRONMENT)
        plan_says(p, EFFECT_ENVIRONMENT, "environment (%.150s) on %s",
                  studio_said(s, s->sky_said, lamp, sizeof lamp), by);
}

static inline void plan_because(plan *p, const plan_facts *q)
{
    static const struct { unsigned effect; plan_part part; material_key key; } list[] = {
        {EFFECT_MIRROR, PART_MIRROR, KEY_ILLUM}, {EFFECT_GLOSSY, PART_GLOSSY, KEY_NS},
        {EFFECT_REFRACTION, PART_THROUGH, KEY_ILLUM}, {EFFECT_ABSORPTION, PART_ABSORB, KEY_ABSORB}};
    char by[300];
    if (p->effects & EFFECTS_LIT) plan_because_light(p, q);
    for (size_t k = 0; k < sizeof list / sizeof *list; k++)
        if (p->effects & list[k].effect)
            plan_says(p, list[k].effect, "%s",
                      plan_name(q, q->has[list[k].part], list[k].key, by, sizeof by));
    if (p->effects & EFFECT_INDIRECT)
        plan_says(p, EFFECT_INDIRECT, "%s, lit by%s%s%s",
                  plan_name(q, q->has[PART_MATTE], KEY_KD, by, sizeof by),
                  q->lights ? " lights" : "",
                  q->s->emitters ? q->lights ? ", lamps (Ke)" : " lamps (Ke)" : "",
                  q->around ? q->lights || q->s->emitters ? ", environment" : " environment" : "");
    if (p->effects & EFFECT_DEPTH_OF_FIELD)
        plan_says(p, EFFECT_DEPTH_OF_FIELD, "lens (%.150s), radius %g",
                  studio_said(q->s, q->s->lens.said, by, sizeof by), (double)q->s->lens.radius);
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
        char said[300];
        cite line;
        const plan_rule *r = plan_first(&q, rules, n, 1u << k, &line);
        p.rule[k] = r, p.verdict[k] = r ? r->verdict : VERDICT_CALLED;
        if (!r) p.effects |= 1u << k;
        else if (line.file)
            plan_says(&p, 1u << k, "%s (%.150s)", r->reason,
                      studio_said(s, line, said, sizeof said));
        else plan_says(&p, 1u << k, "%s", r->reason);
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
