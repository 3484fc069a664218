/* obj_write.h: writes a mesh as an OBJ file, and colours for the materials that it names.
 *
 *   if (!obj_write("pot.obj", &m, &f)) fail(f);   points, texture coordinates, normals, triangles
 *   if (!mtl_write("pot.mtl", &m, &f)) fail(f);   a colour (Kd) for each name that usemtl has
 *
 *   mesh_write(&m, "pot.obj");                    both
 *
 * pot.obj names pot.mtl where the mesh has names; both go to one folder. Numbers have 6 to 9
 * digits, as many as give the same float32 back: what obj_read makes of the file is the mesh again,
 * so rounded. Files are written whole or not at all.
 */
#ifndef MESH_OBJ_WRITE_H
#define MESH_OBJ_WRITE_H

#include "../../../common/output.h"
#include "../mesh.h"

/* ---------------------------------------------------------------------------------------------- */

static inline void obj_write_points(FILE *out, const char *keyword, const vec3 *p, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        fputs(keyword, out);
        for (int k = 0; k < 3; k++) {
            float x = (float)vaxis(p[i], k);
            char text[32];
            for (int digits = 6; digits <= 9; digits++) {
                snprintf(text, sizeof text, "%.*g", digits, (double)(x + 0));  /* -0 becomes 0 */
                if ((float)strtod(text, NULL) == x) break;
            }
            fprintf(out, " %s", text);
        }
        fputc('\n', out);
    }
}

/* i, i/t, i//n or i/t/n, counted from 1. */
static inline void obj_write_corner(FILE *out, const mesh *m, size_t k)
{
    uint32_t t = m->texture_index ? m->texture_index[k] : mesh_none;
    uint32_t n = !m->n ? mesh_none : m->normal_index ? m->normal_index[k] : m->index[k];
    fprintf(out, " %u", m->index[k] + 1);
    if (t != mesh_none) fprintf(out, "/%u", t + 1);
    else if (n != mesh_none) fputc('/', out);
    if (n != mesh_none) fprintf(out, "/%u", n + 1);
}

static inline bool obj_write(const char *path, const mesh *m, failure *f)
{
    file_writer w;
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
    if (!file_begin(&w, path, f)) return false;
    if (m->runs)
        fprintf(w.stream, "mtllib %.*s.mtl\n", (int)(strlen(name) - strlen(".obj")), name);
    obj_write_points(w.stream, "v", m->v, m->vertices);
    obj_write_points(w.stream, "vt", m->t, m->textures);
    obj_write_points(w.stream, "vn", m->n, m->n ? m->normals : 0);
    for (size_t i = 0, run = 0; i < m->triangles; i++) {
        for (; run < m->runs && m->run[run].first == i; run++)
            fprintf(w.stream, "usemtl %s\n", m->names + m->run[run].name);
        fputc('f', w.stream);
        for (size_t k = 3 * i; k < 3 * i + 3; k++) obj_write_corner(w.stream, m, k);
        fputc('\n', w.stream);
    }
    return file_commit(&w, f);
}

/* Five colours in turn, one for each name where it comes first. */
static inline bool mtl_write(const char *path, const mesh *m, failure *f)
{
    static const char *const colour[] = {"0.1 0.35 0.65", "0.85 0.45 0.05", "0.05 0.5 0.35",
                                         "0.7 0.25 0.05", "0.6 0.35 0.5"};
    file_writer w;
    if (!file_begin(&w, path, f)) return false;
    for (size_t i = 0, n = 0; i < m->runs; i++) {
        const char *name = m->names + m->run[i].name;
        size_t k = 0;
        while (k < i && strcmp(m->names + m->run[k].name, name) != 0) k++;
        if (k == i && *name) fprintf(w.stream, "newmtl %s\nKd %s\n", name, colour[n++ % 5]);
    }
    return file_commit(&w, f);
}

/* Both, said in the program's last line; ends the program on failure: neither is written where one
 * may not be. */
static inline void mesh_write(const mesh *m, const char *path)
{
    failure f;
    char *beside = allocate(strlen(path) + 1, 1);
    strcpy(beside, path), strcpy(beside + strlen(path) - 4, ".mtl");
    if ((m->runs && !file_try(beside, &f)) || !obj_write(path, m, &f)
        || (m->runs && !mtl_write(beside, m, &f))) fail(f);
    output_note(path);
    if (m->runs) output_note(beside);
    free(beside);
}

#endif
