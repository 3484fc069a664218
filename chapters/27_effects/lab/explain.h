/* explain.h: the plan in words: --explain.
 *
 *   explain(stdout, &s, &p, &view)
 *   explain_why(&p, k).text          why effect k got its verdict: the rule, or what calls for it
 *   explain_warnings(stderr, &s)     what nobody should miss: a library that is not there, no thing
 *
 * What there is; camera, lens, light by file and line; the plan, each effect with its reason;
 * materials, with the effects that a hit of them has a part in; what was read but not understood.
 */
#ifndef EFFECTS_EXPLAIN_H
#define EFFECTS_EXPLAIN_H

#include "../framing.h"
#include "../plan.h"
#include <stdarg.h>

/* ---------------------------------------------------------------------------------------------- */

enum { explain_most_materials = 40 };

/* A line; texts may be a file's: what could hurt a terminal is shown as "?". */
__attribute__((format(printf, 2, 3)))
static inline void explain_say(FILE *out, const char *format, ...)
{
    char text[2000];
    va_list list;
    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    for (const char *c = text; *c; c++)
        fputc((unsigned char)*c < ' ' || *c == 127 ? '?' : *c, out);
    fputc('\n', out);
}

/* ---- why: the plan in words ---- */

typedef struct { char text[640]; } explain_words;

__attribute__((format(printf, 1, 2)))
static inline explain_words explain_text(const char *format, ...)
{
    explain_words w;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(w.text, sizeof w.text, format, arguments);
    va_end(arguments);
    return w;
}

static inline explain_words explain_more(size_t n)
{
    return n > 1 ? explain_text(" and %zu more", n - 1) : (explain_words){""};
}

/* "material 'red' (room.scene:7) and 3 more": the line that says most about why. None: a table of
 * rules that is wrong has called for it. */
static inline explain_words explain_group(const studio *s, plan_group g, mtl_keyword key)
{
    if (g.n == 0) return (explain_words){"no material"};
    const studio_material *m = &s->material[g.first];
    cite at = m->said[key].file ? m->said[key] : m->at;
    return explain_text("material '%.60s' (%.150s)%.40s", studio_material_name(s, g.first),
                        studio_said(s, at).text, explain_more(g.n).text);
}

/* Rough glass says so, and not Ns; where illum is not said, d lets light through. */
static inline mtl_keyword explain_key(const plan_facts *q, int kind)
{
    uint32_t m = q->has[kind].n ? q->has[kind].first : 0;
    switch (kind) {
    case RAY_GLOSSY: return q->look[m].m.alpha > 0 ? MTL_ROUGHNESS : MTL_NS;
    case RAY_REFRACTED: return q->s->material[m].mtl.illum < 0 ? MTL_D : MTL_ILLUM;
    case RAY_ABSORBED: return MTL_ABSORB;
    case RAY_SCATTERED: return MTL_KD;
    default: return MTL_ILLUM;
    }
}

/* What calls for it: a material; with light, the light, and the first surface that it reaches. */
static inline explain_words explain_called(const plan_facts *q, int kind)
{
    const studio *s = q->s;
    bool reaches = EFFECTS_LIT >> kind & 1, lit = q->lights > 0, lamp = s->emitters > 0;
    explain_words by = explain_group(s, q->has[reaches ? RAY_TO_LIGHT : kind],
                                     explain_key(q, kind));
    switch (kind) {
    case RAY_TO_LIGHT: {
        const studio_light *l = &s->light[q->first_light];
        return explain_text("%s (%.150s)%.40s on %.300s",
                            l->light.kind == LIGHT_POINT ? "light" : "sun",
                            studio_said(s, l->at).text, explain_more(q->lights).text, by.text);
    }
    case RAY_TO_LAMP:
        return explain_text("%zu face%s of %.270s on %.300s", s->emitters,
                            s->emitters == 1 ? "" : "s, the first", explain_group(s,
                            (plan_group){studio_emitter_material(s, 0), 1}, MTL_KE).text, by.text);
    case RAY_TO_SKY:
        return explain_text("environment (%.150s) on %.300s", studio_said(s, s->sky_said).text,
                            by.text);
    case RAY_SCATTERED:
        return explain_text("%.300s, lit by%s%s%s%s%s", by.text, lit ? " lights" : "",
                            lit && lamp ? "," : "", lamp ? " lamps (Ke)" : "",
                            q->around && (lit || lamp) ? "," : "",
                            q->around ? " environment" : "");
    case RAY_OF_LENS:
        return explain_text("lens (%.150s), radius %g", studio_said(s, s->lens.said).text,
                            (double)s->lens.radius);
    default: return by;
    }
}

static inline explain_words explain_why(const plan *p, int kind)
{
    const plan_rule *r = p->rule[kind];
    if (!r) return explain_called(&p->facts, kind);
    if (!p->line[kind].file) return explain_text("%s", r->reason);
    return explain_text("%s (%.150s)", r->reason, studio_said(p->facts.s, p->line[kind]).text);
}

/* ---- all of it ---- */

static inline void explain_view(FILE *out, const studio *s, const studio_view *v)
{
    explain_say(out, "camera     from %.6g %.6g %.6g at %.6g %.6g %.6g up %.6g %.6g %.6g angle %g  "
                "(%s)", (double)v->from.x, (double)v->from.y, (double)v->from.z, (double)v->at.x,
                (double)v->at.y, (double)v->at.z, (double)v->up.x, (double)v->up.y,
                (double)v->up.z, (double)v->angle,
                v->given ? studio_said(s, v->said).text
                         : "found: none was given, this one shows everything");
    if (s->lens.radius > 0)
        explain_say(out, "lens       radius %g, in focus at %g", (double)s->lens.radius,
                    (double)studio_focus(s, v));
    if (studio_dark(s))
        explain_say(out, "light      none was given: each ray carries a lamp without shadows");
}

static inline void explain_material(FILE *out, const studio *s, const plan *p, uint32_t m)
{
    const studio_material *x = &s->material[m];
    char at[320] = "", illum[40] = "NFF", does[700] = "";
    size_t n = 0, room = sizeof does;
    unsigned mask = plan_calls(&p->facts.look[m]) & p->effects;
    if (x->at.file) snprintf(at, sizeof at, "  (%s)", studio_said(s, x->at).text);
    if (!x->classic) snprintf(illum, sizeof illum, x->mtl.illum < 0 ? "illum not said, as %d"
                              : "illum %d", appearance_illum(&x->mtl));
    for (int k = 0; k < effect_kinds && x->used; k++)
        if (mask >> k & 1) n += (size_t)snprintf(does + n, room - n, "%s%s", n ? ", " : "",
                                                 effect_names[k].name);
    if (!n) n = (size_t)snprintf(does, room, x->used ? "none" : "not in use");
    if (x->used && !vzero(x->mtl.ke)) n += (size_t)snprintf(does + n, room - n, "; emits");
    if (x->used && p->facts.look[m].excess > 1 + 16 * real_epsilon)
        n += (size_t)snprintf(does + n, room - n, "; gives back %.3g times what it gets: divided "
                              "by that", (double)p->facts.look[m].excess);
    if (!x->classic && x->mtl.d < 1 && vzero(p->facts.look[m].m.through))
        n += (size_t)snprintf(does + n, room - n, "; d %g, but illum %d calls for no transparency",
                              (double)x->mtl.d, x->mtl.illum);
    if (x->mtl.illum >= 8 && x->mtl.illum <= 10)
        snprintf(does + n, room - n, "; what illum %d means is not all simulated", x->mtl.illum);
    explain_say(out, "  %s%s  %s: %s", studio_material_name(s, m), at, illum, does);
}

static inline void explain_warnings(FILE *out, const studio *s)
{
    uint32_t bit = 1;
    for (const char *n = s->notes, *end; n && *n; n = end + 1, bit <<= 1) {
        end = strchr(n, '\n');
        if (s->warned & bit) fprintf(out, "%s: warning: %.*s\n", program_name, (int)(end - n), n);
    }
    if (!s->shapes && !s->places && !s->solids)
        explain_say(out, "%s: warning: %s: no shape and no mesh: there is nothing to see",
                    program_name, name_text(&s->files, s->files.n > 1));
}

cold_inline void explain(FILE *out, const studio *s, const plan *p, const studio_view *v)
{
    size_t triangles = 0;
    for (size_t i = 0; i < s->places; i++) triangles += s->mesh[s->placed[i].mesh].triangles;
    explain_say(out, "scene      %zu shapes; %zu meshes in %zu places, %zu triangles; %zu "
                "materials; %zu lights; %zu emitting faces", s->shapes + s->solids, s->meshes,
                s->places, triangles, s->materials, s->lights, s->emitters);
    explain_view(out, s, v);
    explain_say(out, "plan       %s", integrator_of(p->effects));
    for (int k = 0; k < effect_kinds; k++)
        explain_say(out, "  %-13s %-15s %s", verdict_names[p->verdict[k]], effect_names[k].name,
                    explain_why(p, k).text);
    explain_say(out, "materials");
    for (uint32_t m = 0; m < s->materials && m < explain_most_materials; m++)
        if (m > 0 || s->material[m].used) explain_material(out, s, p, m);
    if (s->materials > explain_most_materials)
        explain_say(out, "  and %zu more", s->materials - explain_most_materials);
    if (s->note_count) explain_say(out, "notes");
    for (const char *n = s->notes, *end; n && *n; n = end + 1) {
        end = strchr(n, '\n');
        explain_say(out, "  %.*s", (int)(end - n), n);
    }
    if (s->note_count > studio_most_notes)
        explain_say(out, "  and %zu more", s->note_count - studio_most_notes);
}

#endif
