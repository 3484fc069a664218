/* explain.h: the plan in words: --explain.
 *
 *   explain(stdout, &s, &p, &view)
 *   explain_warnings(stderr, &s)     what nobody should miss: a library that is not there, no thing
 *
 *   scene        what there is, and from where
 *   camera, lens, light   by file and line, or how they were found
 *   plan         path tracing, because of: ...
 *     called for    soft shadows    2 faces, the first of material 'lamp' (room.scene:12) on ...
 *     cannot occur  mirror          no material in use reflects sharply ...
 *     declined      indirect light  `indirect off` (room.scene:2)
 *   materials    each with its line, its illum and the effects that a hit of it has a part in
 *   notes        what was read but not understood
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

static inline void explain_view(FILE *out, const studio *s, const studio_view *v)
{
    char said[300];
    explain_say(out, "camera     from %.6g %.6g %.6g at %.6g %.6g %.6g up %.6g %.6g %.6g angle %g  "
                "(%s)", (double)v->from.x, (double)v->from.y, (double)v->from.z, (double)v->at.x,
                (double)v->at.y, (double)v->at.z, (double)v->up.x, (double)v->up.y,
                (double)v->up.z, (double)v->angle,
                v->given ? studio_said(s, v->said, said, sizeof said)
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
    char said[300], at[320] = "", illum[40] = "NFF", does[700] = "";
    size_t n = 0, room = sizeof does;
    unsigned mask = plan_effects(p, m);
    if (x->at.file) snprintf(at, sizeof at, "  (%s)", studio_said(s, x->at, said, sizeof said));
    if (!x->classic) snprintf(illum, sizeof illum, x->illum < 0 ? "illum not said, as %d"
                              : "illum %d", appearance_illum(x));
    for (int k = 0; k < effect_kinds && x->used; k++)
        if (mask >> k & 1) n += (size_t)snprintf(does + n, room - n, "%s%s", n ? ", " : "",
                                                 effect_names[k].name);
    if (!n) n = (size_t)snprintf(does, room, x->used ? "none" : "not in use");
    if (x->used && !vzero(x->ke)) n += (size_t)snprintf(does + n, room - n, "; emits");
    if (x->used && p->look[m].excess > 1 + 16 * real_epsilon)
        n += (size_t)snprintf(does + n, room - n, "; gives back %.3g times what it gets: divided "
                              "by that", (double)p->look[m].excess);
    if (!x->classic && x->d < 1 && vzero(p->look[m].through))
        n += (size_t)snprintf(does + n, room - n, "; d %g, but illum %d calls for no transparency",
                              (double)x->d, x->illum);
    if (x->illum >= 8 && x->illum <= 10)
        snprintf(does + n, room - n, "; what illum %d means is not all simulated", x->illum);
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

static inline void explain(FILE *out, const studio *s, const plan *p, const studio_view *v)
{
    size_t triangles = 0;
    for (size_t i = 0; i < s->places; i++) triangles += s->mesh[s->placed[i].mesh].triangles;
    explain_say(out, "scene      %zu shapes; %zu meshes in %zu places, %zu triangles; %zu "
                "materials; %zu lights; %zu emitting faces", s->shapes + s->solids, s->meshes,
                s->places, triangles, s->materials, s->lights, s->emitters);
    explain_view(out, s, v);
    explain_say(out, "plan       %s", integrator_names[p->integrator]);
    for (int k = 0; k < effect_kinds; k++)
        explain_say(out, "  %-13s %-15s %s", verdict_names[p->verdict[k]], effect_names[k].name,
                    p->why[k]);
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
