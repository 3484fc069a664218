/* mtl.h: reads materials from Wavefront MTL files (材质库).
 *
 *   newmtl NAME          a material begins; of two with the same name the later one counts
 *   Kd Ks Ke r [g b]     matte, specular, emitted; one number: grey          (27.3) of appearance.h
 *   Tf r [g b]           transmission filter
 *   Ns x                 exponent of the highlight, 0 to 1e9; 1000 and more: a mirror
 *   Ni x                 refractive index, 0.001 to 10; 0, which some programs write: 1, and a note
 *   d x, d -halo x       1: opaque, 0: not there;  Tr x: d = 1 - x
 *   illum n              0 to 10: what light does there
 *   absorb r [g b]       our own: absorbed inside, per unit of length; other programs skip it
 *   Ka                   checked and dropped: what it stands for is computed, or not called for
 *   every other keyword  skipped (map_Kd, bump, Pr ...); textures are named in a note
 *
 *   if (!mtl_read(&s, "a.mtl", &library, &f)) ...   s.library[library]; a file is read only once
 *   mtl_key(&s, &t, m, cite, &known)                 one such line for material m: scene files, too
 *
 * Broken: "FILE:LINE: Kd: not a number: 'x', allowed: finite decimals", exit code 2; the file
 * cannot be read: 1. What a line is, text.h says. Memory: a fixed multiple of the size of the file.
 *
 * Source: Wavefront, "Material library file (.mtl)", Advanced Visualizer manual, 1995.
 */
#ifndef EFFECTS_MTL_H
#define EFFECTS_MTL_H

#include "studio_add.h"
#include "../../07_mesh/files/words.h"

/* ---------------------------------------------------------------------------------------------- */

static const char *const material_key_names[material_keys] = {
    "Kd", "Ks", "Ke", "Tf", "absorb", "Ns", "Ni", "d", "illum"};

static inline bool mtl_skip(text_reader *t)
{
    text_skip(t);
    return true;
}

/* Spectral curves and CIE colours are of no use here. */
static inline bool mtl_colour(text_reader *t, vec3 *out, bool *read)
{
    *read = !(word_take(t, "spectral") || word_take(t, "xyz"));
    return *read ? word_colour(t, out) : mtl_skip(t);
}

static inline bool mtl_number(text_reader *t, studio *s, studio_material *m, material_key key,
                              cite at)
{
    real n = 0;
    switch (key) {
    case KEY_NS: return word_number(t, &m->ns, 0, 1e9);
    case KEY_D: return word_take(t, "-halo"), word_number(t, &m->d, 0, 1);
    case KEY_ILLUM:
        if (!word_number(t, &n, 0, 10)) return false;
        m->illum = (int)n;
        return (real)m->illum == n || text_bad(t, t->p, "not a whole number before", "0 to 10");
    case KEY_NI:
        if (!word_number(t, &n, 0, 10)) return false;
        if (n > 0 && n < (real)0.000999)
            return text_bad(t, t->p, "too small before", "0.001 to 10");
        if (n == 0)
            studio_note(s, "%s:%u: Ni 0 is taken as 1", text_name(t), (unsigned)at.line);
        return m->ni = n > 0 ? n : 1, true;
    default: return true;
    }
}

static inline bool mtl_is_key(const text_reader *t)
{
    int k = 0;
    while (k < material_keys && !text_is(t, material_key_names[k])) k++;
    return k < material_keys || text_is(t, "Ka") || text_is(t, "Tr");
}

/* At the keyword. *known: false if it is none of these; then nothing was read. */
static inline bool mtl_key(studio *s, text_reader *t, uint32_t number, cite at, bool *known)
{
    studio_material *m = &s->material[number];
    vec3 *colour[] = {&m->kd, &m->ks, &m->ke, &m->tf, &m->absorb}, dropped;
    bool read = true;
    int k = 0;
    *known = true;
    while (k < material_keys && !text_is(t, material_key_names[k])) k++;
    if (text_is(t, "Ka")) {
        t->p += strlen(t->keyword = "Ka");
        return mtl_colour(t, &dropped, &read);
    }
    if (text_is(t, "Tr")) {
        t->p += strlen(t->keyword = "Tr");
        if (!word_number(t, &m->d, 0, 1)) return false;
        m->d = 1 - m->d, m->said[KEY_D] = at;
        return true;
    }
    if (k == material_keys) return *known = false, true;
    t->p += strlen(t->keyword = material_key_names[k]);
    if (k < KEY_NS ? !mtl_colour(t, colour[k], &read) : !mtl_number(t, s, m, (material_key)k, at))
        return false;
    if (read) m->said[k] = at;
    else studio_note(s, "%s:%u: %s: only r g b is read", text_name(t), (unsigned)at.line,
                     t->keyword);
    return true;
}

/* Nothing else may stand on the line. */
static inline bool mtl_line_ends(text_reader *t)
{
    return !text_more(t) || text_bad(t, t->p, "too much:", "the end of the line");
}

static inline bool mtl_name(text_reader *t, char name[text_token])
{
    const char *start = NULL;
    size_t n = 0;
    if (!text_rest(t, &start, &n)) return false;
    memcpy(name, start, n), name[n] = 0;
    return true;
}

/* The keywords of textures begin so. */
static inline bool mtl_texture(const text_reader *t)
{
    return strncmp(t->p, "map_", 4) == 0 || text_is(t, "bump") || text_is(t, "refl")
        || text_is(t, "disp") || text_is(t, "decal") || text_is(t, "norm");
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
        return mtl_is_key(t) ? text_bad(t, t->p, "before the first material:", "newmtl NAME")
                             : mtl_skip(t);
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
        if (s->library_file[*library] == file) return true;
    if (s->files_read >= studio_most_files)
        return failed(f, 2, "%.300s: too many files, allowed: %d in all", path, studio_most_files);
    FILE *in = word_open(path, false, f);
    if (!in) return false;
    s->files_read++;
    studio_grow(s, library, s->libraries), studio_grow(s, library_file, s->libraries);
    s->library[s->libraries] = (studio_palette){.room = 0};
    s->library_file[s->libraries++] = file;
    bool ok = mtl_read_stream(s, in, path, file, &s->library[*library], f);
    fclose(in);
    return ok;
}

#endif
