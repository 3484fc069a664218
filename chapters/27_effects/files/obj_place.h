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

typedef struct {
    studio *s;
    const char *path;         /* of the OBJ file */
    uint32_t *library;
    size_t n, room;
    bool ok;
    failure *f;
} obj_found;

static inline void obj_found_add(void *user, const char *name, bool there)
{
    obj_found *l = user;
    uint32_t k;
    if (!l->ok) return;
    if (!there) {
        studio_note(l->s, "%.200s: no file '%.100s': what it describes stays grey", l->path, name);
        studio_warns(l->s);
        return;
    }
    if (!(l->ok = mtl_studio(l->s, name, &k, l->f))) return;
    for (size_t i = 0; i < l->n; i++)
        if (l->library[i] == k) return;
    l->library = grown(l->library, l->n, &l->room, sizeof *l->library);
    l->library[l->n++] = k;
}

static inline uint32_t obj_material_number(const studio *s, const obj_found *found,
                                           const char *name)
{
    uint32_t k = studio_palette_find(&s->own, name);
    for (size_t i = 0; k == name_none && i < found->n; i++)
        k = studio_palette_find(&s->library[found->library[i]].palette, name);
    return k;
}

/* Of each run; "None" is how Blender says that there is none, "" is usemtl without a name. */
static inline uint32_t *obj_run_materials(studio *s, const char *path, const mesh *m,
                                          const obj_found *found)
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
    obj_found found = {s, path, NULL, 0, 0, true, f};
    if (!obj_read_stream(in, path, UINT32_MAX / 4, &m, f)) return false;
    obj_libraries_each(&m, path, obj_found_add, &found);
    bool ok = found.ok;
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
