/* mtl_studio.h: an MTL file (mtl.h of 07) as a library of a scene: materials by name.
 *
 *   if (!mtl_studio(&s, "a.mtl", &library, &f)) ...   s.library[library]; a file is read only once
 *   mtl_studio_key(&s, &t, m, cite)                    one line Kd .. priority for material m
 *
 * What was read, but not as it stands, becomes a note of s. Broken: as mtl.h says, exit code 2; the
 * file cannot be read: 1. Memory: a fixed multiple of the size of the file.
 */
#ifndef EFFECTS_MTL_STUDIO_H
#define EFFECTS_MTL_STUDIO_H

#include "studio_add.h"

/* ---------------------------------------------------------------------------------------------- */

static inline void mtl_studio_said(studio *s, uint32_t number, const mtl_said *x, cite at)
{
    if (*x->note) studio_note(s, "%s", x->note);
    if (x->key < mtl_keys) s->material[number].said[x->key] = at;
}

/* At a keyword that mtl_find knows. */
static inline bool mtl_studio_key(studio *s, text_reader *t, uint32_t number, cite at)
{
    mtl_said x;
    if (!mtl_key(t, &s->material[number].mtl, &x)) return false;
    mtl_studio_said(s, number, &x, at);
    return true;
}

static inline bool mtl_studio_stream(studio *s, FILE *in, const char *path, uint32_t file,
                                     studio_palette *p, failure *f)
{
    mtl_reader r;
    uint32_t current = 0;  /* before the first newmtl nothing is said */
    if (!mtl_begin(&r, in, path, f)) return false;
    while (mtl_next(&r)) {
        cite at = {file, (uint32_t)r.said.line};
        if (r.said.key == MTL_NEWMTL) {
            studio_palette_add(p, r.name, current = studio_add_material(s, r.name, at));
            s->material[current].library = true;
        } else if (r.begun) s->material[current].mtl = r.material;
        mtl_studio_said(s, current, &r.said, at);
    }
    return mtl_end(&r);
}

/* The library of that file, read now unless it was before. */
static inline bool mtl_studio(studio *s, const char *path, uint32_t *library, failure *f)
{
    uint32_t file = name_add(&s->files, path);
    for (*library = 0; *library < s->libraries; ++*library)
        if (s->library[*library].file == file) return true;
    FILE *in = studio_open(s, path, f);
    if (!in) return false;
    studio_grow(s, library, s->libraries);
    s->library[s->libraries++] = (studio_library){.file = file};
    bool ok = mtl_studio_stream(s, in, path, file, &s->library[*library].palette, f);
    fclose(in);
    return ok;
}

#endif
