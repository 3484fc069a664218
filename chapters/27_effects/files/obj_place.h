/* obj_place.h: OBJ files (07) with their materials, placed in a scene.
 *
 *   if (!obj_mesh(&s, "pot.obj", smooth, &m, &f)) ...        s.mesh[m]; each file is read only once
 *
 * A name that usemtl gives means: the material of that name in the scene files read so far, else in
 * the first library of mtllib that has it, else the one of the place. Libraries are looked for
 * beside the OBJ file: the whole line as one name, the last part of a path, the words of the line.
 * One that is not there is a note, one that is broken an error. smooth: by mesh_smooth_normals.
 */
#ifndef EFFECTS_OBJ_PLACE_H
#define EFFECTS_OBJ_PLACE_H

#include "../../07_mesh/files/obj.h"
#include "mtl_studio.h"

/* ---------------------------------------------------------------------------------------------- */

typedef struct { uint32_t *library; size_t n, room; } obj_libraries;

/* Reads the library of that name, if there is a file of that name. False: broken. */
static inline bool obj_try_library(studio *s, const char *base, const char *name,
                                   obj_libraries *found, bool *there, failure *f)
{
    char path[word_longest_path];
    struct stat what;
    uint32_t k;
    *there = word_path(base, name, path) && stat(path, &what) == 0 && S_ISREG(what.st_mode)
        && access(path, R_OK) == 0;
    if (!*there) return true;
    if (!mtl_studio(s, path, &k, f)) return false;
    for (size_t i = 0; i < found->n; i++)
        if (found->library[i] == k) return true;
    found->library = grown(found->library, found->n, &found->room, sizeof *found->library);
    found->library[found->n++] = k;
    return true;
}

/* One line of mtllib, in the three ways; it is changed. */
static inline bool obj_library_line(studio *s, const char *base, char *line, obj_libraries *found,
                                    failure *f)
{
    bool there;
    size_t before = found->n;
    if (!obj_try_library(s, base, line, found, &there, f)) return false;
    if (there) return true;
    char *last = line;
    for (char *p = line; *p; p++)
        if (*p == '/' || *p == '\\') last = p + 1;
    if (last > line && !obj_try_library(s, base, last, found, &there, f)) return false;
    if (found->n == before)
        for (char *save = NULL, *word = strtok_r(line, " \t", &save); word;
             word = strtok_r(NULL, " \t", &save)) {
            if (!obj_try_library(s, base, word, found, &there, f)) return false;
            if (there) continue;
            studio_note(s, "%.200s: no file '%.100s': what it describes stays grey", base, word);
            studio_warns(s);
        }
    return true;
}

static inline uint32_t obj_material_number(const studio *s, const obj_libraries *found,
                                           const char *name)
{
    uint32_t k = studio_palette_find(&s->own, name);
    for (size_t i = 0; k == name_none && i < found->n; i++)
        k = studio_palette_find(&s->library[found->library[i]].palette, name);
    return k;
}

/* Of each run; "None" is how Blender says that there is none, "" is usemtl without a name. */
static inline uint32_t *obj_run_materials(studio *s, const char *path, const mesh *m,
                                          const obj_libraries *found)
{
    uint32_t *number = allocate(m->runs, sizeof *number);
    name_table unknown = {NULL, 0, 0, NULL, 0, 0, NULL, 0};
    for (size_t i = 0; i < m->runs; i++) {
        const char *name = m->names + m->run[i].name;
        number[i] = obj_material_number(s, found, name);
        if (number[i] != name_none || name_find(&unknown, name) != name_none) continue;
        name_add(&unknown, name);
        bool missing = m->libraries && !found->n;  /* that has been said */
        if (missing || !*name || strcmp(name, "None") == 0 || strcmp(name, "(null)") == 0) continue;
        studio_note(s, "%.200s: material '%.100s' is nowhere described: grey", path, name);
        studio_warns(s);
    }
    name_table_free(&unknown);
    return number;
}

/* Of an open stream: a new mesh. */
static inline bool obj_mesh_stream(studio *s, FILE *in, const char *path, bool smooth,
                                   uint32_t *out, failure *f)
{
    uint32_t file = name_add(&s->files, path);
    mesh m;
    obj_libraries found = {NULL, 0, 0};
    bool ok = obj_read_stream(in, path, UINT32_MAX / 4, &m, f);
    if (!ok) return false;
    char *save = NULL, *line = m.libraries ? strtok_r(m.libraries, "\n", &save) : NULL;
    for (; ok && line; line = strtok_r(NULL, "\n", &save))
        ok = obj_library_line(s, path, line, &found, f);
    if (!ok) mesh_free(&m);
    else {
        if (smooth) mesh_smooth_normals(&m);
        *out = studio_add_mesh(s, m, obj_run_materials(s, path, &m, &found), file, smooth);
    }
    free(found.library);
    return ok;
}

static inline bool obj_mesh(studio *s, const char *path, bool smooth, uint32_t *out, failure *f)
{
    uint32_t file = name_add(&s->files, path);
    for (uint32_t k = 0; k < s->meshes; k++)
        if (s->paint[k].file == file && s->paint[k].smooth == smooth) return *out = k, true;
    FILE *in = studio_open(s, path, f);
    if (!in) return false;
    bool ok = obj_mesh_stream(s, in, path, smooth, out, f);
    fclose(in);
    return ok;
}

#endif
