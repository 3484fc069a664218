/* mtl_studio.h: reads materials from Wavefront MTL files (材质库).
 *
 *   newmtl NAME; Kd Ks Ke Tf r [g b]; Ns x; Ni x; d x, d -halo x, Tr x: d = 1 - x; illum n;
 *   our own: absorb r [g b], absorbed inside, per unit of length; priority n, of what overlaps;
 *   roughness x, of glass. What they mean: appearance.h. Ka is checked and dropped, Ni 0 is taken
 *   as 1, all else is skipped; textures are named in a note.
 *
 *   if (!mtl_read(&s, "a.mtl", &library, &f)) ...   s.library[library]; a file is read only once
 *   mtl_key(&s, &t, m, cite, &known)                 one such line for material m: scene files, too
 *
 * Broken: "FILE:LINE: Kd: not a number: 'x', allowed: finite decimals", exit code 2; the file
 * cannot be read: 1. Memory: a fixed multiple of the size of the file.
 *
 * Source: Wavefront, "Material library file (.mtl)", Advanced Visualizer manual, 1995.
 */
#ifndef EFFECTS_MTL_STUDIO_H
#define EFFECTS_MTL_STUDIO_H

#include "studio_add.h"

/* ---------------------------------------------------------------------------------------------- */

static inline bool mtl_number(text_reader *t, studio *s, studio_material *m, int key)
{
    real n = 0;
    switch (key) {
    case KEY_NS: return word_number(t, &m->ns, 0, 1e9);
    case KEY_ROUGHNESS: return word_number(t, &m->roughness, 0, 1);
    case KEY_D: return word_take(t, "-halo"), word_number(t, &m->d, 0, 1);
    case mtl_tr:
        if (!word_number(t, &n, 0, 1)) return false;
        return m->d = 1 - n, true;
    case KEY_ILLUM: return mtl_whole(t, &m->illum, 10, "0 to 10");
    case KEY_PRIORITY: return mtl_whole(t, &m->priority, 1000, "0 to 1000");
    default:
        if (!word_number(t, &n, 0, 10)) return false;
        if (n > 0 && n < (real)0.000999)
            return text_bad(t, t->p, "too small before", "0.001 to 10");
        if (n == 0)
            studio_note(s, "%s:%zu: Ni 0 is taken as 1", text_name(t), t->line);
        return m->ni = n > 0 ? n : 1, true;
    }
}

/* At the keyword. *known: false if it is none of these; then nothing was read. */
static inline bool mtl_key(studio *s, text_reader *t, uint32_t number, cite at, bool *known)
{
    studio_material *m = &s->material[number];
    vec3 dropped, *colour[] = {&m->kd, &m->ks, &m->ke, &m->tf, &m->absorb};
    bool read = true;
    int k = mtl_find(t);
    if (!(*known = k < mtl_keys)) return true;
    t->p += strlen(t->keyword = mtl_key_names[k]);
    if (k < KEY_NS || k == mtl_ka) {
        if (!mtl_colour(t, k < KEY_NS ? colour[k] : &dropped, &read)) return false;
    } else if (!mtl_number(t, s, m, k)) return false;
    if (!read) studio_note(s, "%s:%u: %s: only r g b is read", text_name(t), (unsigned)at.line,
                           t->keyword);
    else if (k != mtl_ka) m->said[k == mtl_tr ? KEY_D : k] = at;
    return true;
}

static inline bool mtl_statement(studio *s, text_reader *t, uint32_t file, studio_palette *p,
                                 uint32_t *current, bool *textures)
{
    cite at = {file, (uint32_t)t->line};
    char name[text_token];
    bool known;
    if (text_is(t, "newmtl")) {
        t->p += strlen(t->keyword = "newmtl");
        if (!mtl_name(t, name)) return false;
        studio_palette_add(p, name, *current = studio_add_material(s, name, at));
        s->material[*current].library = true;
        return true;
    }
    if (*current == name_none)
        return mtl_find(t) == mtl_keys ? mtl_skip(t)
            : text_bad(t, t->p, "before the first material:", "newmtl NAME");
    if (mtl_texture(t)) {
        if (!*textures)
            studio_note(s, "%s:%u: textures are not read", text_name(t), (unsigned)at.line);
        *textures = true;
        return mtl_skip(t);
    }
    return mtl_key(s, t, *current, at, &known) && (known ? mtl_line_ends(t) : mtl_skip(t));
}

static inline bool mtl_read_stream(studio *s, FILE *in, const char *path, uint32_t file,
                                   studio_palette *p, failure *f)
{
    text_reader t;
    uint32_t current = name_none;
    bool ok = text_begin(&t, in, path, f), textures = false;
    if (!ok) return false;
    while (ok && text_statement(&t)) ok = mtl_statement(s, &t, file, p, &current, &textures);
    return text_end(&t) && ok;
}

/* The library of that file, read now unless it was before. */
static inline bool mtl_read(studio *s, const char *path, uint32_t *library, failure *f)
{
    uint32_t file = name_add(&s->files, path);
    for (*library = 0; *library < s->libraries; ++*library)
        if (s->library[*library].file == file) return true;
    FILE *in = studio_open(s, path, f);
    if (!in) return false;
    studio_grow(s, library, s->libraries);
    s->library[s->libraries++] = (studio_library){.file = file};
    bool ok = mtl_read_stream(s, in, path, file, &s->library[*library].palette, f);
    fclose(in);
    return ok;
}

#endif
