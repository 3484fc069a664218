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

/* ---------------------------------------------------------------------------------------------- */

enum { explain_most_materials = 40 };

/* A text of our own, or of a file: what could hurt a terminal is shown as "?". */
static inline void explain_text(FILE *out, const char *text)
{
    for (; *text; text++)
        fputc((unsigned char)*text < ' ' || *text == 127 ? '?' : *text, out);
}

static inline void explain_scene(FILE *out, const studio *s)
{
    size_t triangles = 0;
    for (size_t i = 0; i < s->places; i++) triangles += s->mesh[s->placed[i].mesh].triangles;
    fprintf(out, "scene      %zu shapes; %zu meshes in %zu places, %zu triangles; %zu materials; "
            "%zu lights; %zu emitting faces\n", s->shapes + s->solids, s->meshes, s->places,
            triangles, s->materials, s->lights, s->emitters);
}

static inline void explain_view(FILE *out, const studio *s, const studio_view *v)
{
    char said[300];
    fprintf(out, "camera     from %.6g %.6g %.6g at %.6g %.6g %.6g up %.6g %.6g %.6g angle %g  (",
            (double)v->from.x, (double)v->from.y, (double)v->from.z, (double)v->at.x,
            (double)v->at.y, (double)v->at.z, (double)v->up.x, (double)v->up.y, (double)v->up.z,
            (double)v->angle);
    explain_text(out, v->given ? studio_said(s, v->said, said, sizeof said)
                               : "found: none was given, this one shows everything");
    fprintf(out, ")\n");
    if (s->lens.radius > 0)
        fprintf(out, "lens       radius %g, in focus at %g\n", (double)s->lens.radius,
                (double)studio_focus(s, v));
    if (studio_dark(s))
        fprintf(out, "light      none was given: each ray carries a lamp that throws no shadow\n");
}

static inline void explain_mask(FILE *out, unsigned mask)
{
    const char *between = "";
    if (!mask) fprintf(out, "none");
    for (int k = 0; k < effect_kinds; k++)
        if (mask >> k & 1) fprintf(out, "%s%s", between, effect_names[k].name), between = ", ";
}

static inline void explain_effects(FILE *out, const plan *p)
{
    fprintf(out, "plan       %s\n", integrator_names[p->integrator]);
    for (int k = 0; k < effect_kinds; k++) {
        fprintf(out, "  %-13s %-15s ", verdict_names[p->verdict[k]], effect_names[k].name);
        explain_text(out, p->why[k]);
        fprintf(out, "\n");
    }
}

static inline void explain_material(FILE *out, const studio *s, const plan *p, uint32_t m)
{
    const studio_material *x = &s->material[m];
    char said[300], illum[40];
    fprintf(out, "  ");
    explain_text(out, studio_material_name(s, m));
    if (x->at.file) {
        fprintf(out, "  (");
        explain_text(out, studio_said(s, x->at, said, sizeof said));
        fprintf(out, ")");
    }
    if (x->classic) snprintf(illum, sizeof illum, "NFF");
    else snprintf(illum, sizeof illum, x->illum < 0 ? "illum not said, as %d" : "illum %d",
                  appearance_illum(x));
    fprintf(out, "  %s: ", illum);
    if (!x->used) fprintf(out, "not in use");
    else explain_mask(out, plan_effects(p, m));
    if (x->used && !vzero(x->ke)) fprintf(out, "; emits");
    if (x->used && p->look[m].excess > 1 + 16 * real_epsilon)
        fprintf(out, "; gives back %.3g times what it gets: divided by that",
                (double)p->look[m].excess);
    if (!x->classic && x->d < 1 && vzero(p->look[m].through))
        fprintf(out, "; d %g, but illum %d calls for no transparency", (double)x->d, x->illum);
    if (x->illum == 8 || x->illum == 9 || x->illum == 10)
        fprintf(out, "; what illum %d means is not all simulated", x->illum);
    fprintf(out, "\n");
}

static inline void explain_warnings(FILE *out, const studio *s)
{
    uint32_t bit = 1;
    for (const char *n = s->notes, *end; n && *n; n = end + 1, bit <<= 1) {
        end = strchr(n, '\n');
        if (s->warned & bit) fprintf(out, "%s: warning: %.*s\n", program_name, (int)(end - n), n);
    }
    if (s->shapes || s->places || s->solids) return;
    fprintf(out, "%s: warning: ", program_name);
    explain_text(out, name_text(&s->files, s->files.n > 1));
    fprintf(out, ": no shape and no mesh: there is nothing to see\n");
}

static inline void explain(FILE *out, const studio *s, const plan *p, const studio_view *v)
{
    explain_scene(out, s);
    explain_view(out, s, v);
    explain_effects(out, p);
    fprintf(out, "materials\n");
    for (uint32_t m = 0; m < s->materials && m < explain_most_materials; m++)
        if (m > 0 || s->material[m].used) explain_material(out, s, p, m);
    if (s->materials > explain_most_materials)
        fprintf(out, "  and %zu more\n", s->materials - explain_most_materials);
    if (s->note_count) fprintf(out, "notes\n");
    for (const char *n = s->notes, *end; n && *n; n = end + 1) {
        end = strchr(n, '\n');
        fprintf(out, "  %.*s\n", (int)(end - n), n);
    }
    if (s->note_count > studio_most_notes)
        fprintf(out, "  and %zu more\n", s->note_count - studio_most_notes);
}

#endif
