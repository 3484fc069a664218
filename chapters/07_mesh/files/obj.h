/* obj.h: reads triangle meshes from Wavefront OBJ files.
 *
 *   v 0 0 0              a point; more columns (weight, colour) are checked and dropped
 *   vn 0 0 1             a normal, of any length
 *   vt 0 0               texture coordinates u, v, w; what is missing is 0
 *   f 1 2 3              a polygon of three or more corners  i  i/j  i//k  i/j/k
 *   f -4/1/1 -3/1 -2 -1  from 1 up in the order of the file; -1 is the last one so far
 *   f 1/ 2// 3/1/        a slash with no index behind it counts for nothing
 *   usemtl, mtllib NAME  kept by name, usemtl alone as "": no material from here on
 *   every other keyword  skipped (o g s l p curv ...)
 *
 * A polygon a b c d e ... becomes the fan abc, acd, ade ... in the order of the file. That is right
 * for convex polygons and for those that their first corner sees whole; of other concave ones the
 * fan covers more than the polygon. Positive indices may name what comes later in the file,
 * negative ones may not.
 *
 *   mesh m;
 *   failure f;
 *   if (!obj_read("teapot.obj", &m, &f)) fail(f);      then m is zeroed, and need not be freed
 *   const char *name = mesh_material(&m, i)            what usemtl gave triangle i, or ""
 *   mesh_free(&m);
 *
 *   what went wrong                                                                  exit code
 *   the file cannot be opened or read; no memory                                     1
 *   "FILE:LINE: what, allowed: ...": no text, NaN, infinity, overflow, index 0 or    2
 *     out of range, fewer than 3 corners, a missing coordinate, no face at all ...
 *
 * What a line, a blank, a number is, text.h says.
 *
 * Memory: 64 KB and the arrays, which grow by half and are cut to size in the end: at most 2.5
 * times what is returned even where realloc copies. A broken file cannot ask for more than a fixed
 * multiple of its own size.
 *
 * Source: Wavefront, "Object files (.obj)", Advanced Visualizer manual, app. B1, 1995.
 */
#ifndef MESH_OBJ_H
#define MESH_OBJ_H

#include "../mesh.h"
#include "../../../common/numbers/text.h"

/* Reads the mesh of the file at `path`. */
static inline bool obj_read(const char *path, mesh *out, failure *f);

/* The same from an open stream. `name` is for messages; a file may hold at most `most` items of a
 * kind [<= 2^32 - 1]. */
static inline bool obj_read_stream(FILE *in, const char *name, size_t most, mesh *out, failure *f);

/* Says on stderr which files named by mtllib are not beside the file at `path`; how many. */
static inline int obj_libraries_missing(const mesh *m, const char *path);

/* Calls use(user, file, true) for each that is, in their order, and use(user, name, false) for each
 * that is not. */
typedef void obj_library_use(void *user, const char *name, bool there);
static inline void obj_libraries_each(const mesh *m, const char *path, obj_library_use *use,
                                      void *user);

/* ---------------------------------------------------------------------------------------------- */

static inline const char *mesh_material(const mesh *m, size_t i)
{
    size_t k = mesh_run_of(m, i);
    return k ? m->names + m->run[k - 1].name : "";
}

typedef struct {
    const char *name;
    size_t count, room;
    size_t greatest, line;  /* greatest index that was named before its item came, and where */
} obj_kind;

typedef struct { uint32_t v, t, n; } obj_corner;

typedef struct {
    text_reader text;
    size_t most;
    obj_kind v, t, n;
    size_t index_room, texture_room, normal_room, run_room;
    size_t names, names_room, libraries, libraries_room;
    mesh m;
} obj_reader;

/* Appends the rest of the line to a text, with `end` behind it; end 0: there may be none. */
static inline bool obj_name(obj_reader *r, char **text, size_t *size, size_t *room, char end)
{
    const char *name = "";
    size_t n = 0;
    if ((end || text_more(&r->text)) && !text_rest(&r->text, &name, &n)) return false;
    char *grown = text_grow(&r->text, *text, room, *size, n + 2, 1);
    if (!grown) return false;
    *text = grown;
    memcpy(grown + *size, name, n);
    grown[*size += n] = end;
    grown[++*size] = 0;
    return true;
}

static inline bool obj_full(obj_reader *r)
{
    char allowed[48];
    snprintf(allowed, sizeof allowed, "at most %zu in all", r->most);
    return text_bad(&r->text, r->text.p, "too many items, this one before", allowed);
}

/* A line of `least` to `most` [<= 8] numbers. Three of them are kept. */
static inline bool obj_point(obj_reader *r, obj_kind *kind, vec3 **array, int least, int most)
{
    real x[8] = {0};
    int n = 0;
    while (n < most && text_more(&r->text))
        if (!text_number(&r->text, &x[n++])) return false;
    if (n < least || text_more(&r->text)) {
        char range[48];
        snprintf(range, sizeof range, "%d to %d numbers", least, most);
        return text_bad(&r->text, r->text.p,
                        n < least ? "too few numbers before" : "too many numbers:", range);
    }
    if (kind->count == r->most) return obj_full(r);
    vec3 *grown = text_grow(&r->text, *array, &kind->room, kind->count, 1, sizeof **array);
    if (!grown) return false;
    *array = grown;
    grown[kind->count++] = (vec3){x[0], x[1], x[2]};
    return true;
}

static inline bool obj_out_of_range(obj_reader *r, const char *token, const obj_kind *kind)
{
    size_t n = kind->count;
    char what[48], range[64] = "none, there is none so far";
    snprintf(what, sizeof what, "%s index out of range:", kind->name);
    if (n) snprintf(range, sizeof range, "1 to %zu or -%zu to -1", n, n);
    return text_bad(&r->text, token, what, range);
}

#define obj_corner_form "i  i/j  i//k  i/j/k"

/* One index, made to count from 0. Whether what lies ahead comes at all is asked at the end. */
static inline bool obj_index(obj_reader *r, obj_kind *kind, uint32_t *out)
{
    const char *start = r->text.p, *p = start;
    bool backwards = *p == '-';
    p += backwards;
    uint64_t i = 0;
    if (!decimal_digit(*p)) return text_bad(&r->text, start, "not an index:", obj_corner_form);
    for (; decimal_digit(*p) && i <= UINT32_MAX; p++) i = 10 * i + (uint64_t)(*p - '0');
    if (i == 0 || i > r->most || (backwards && i > kind->count))
        return obj_out_of_range(r, start, kind);
    if (!backwards && i > kind->count && i > kind->greatest) {
        kind->greatest = (size_t)i;
        kind->line = r->text.line;
    }
    *out = (uint32_t)(backwards ? kind->count - i : i - 1);
    r->text.p += p - start;
    return true;
}

static inline bool obj_corner_read(obj_reader *r, obj_corner *c)
{
    text_reader *t = &r->text;
    const char *start = t->p;
    if (!obj_index(r, &r->v, &c->v)) return false;
    if (*t->p == '/' && *++t->p != '/' && !text_ends_token(*t->p)
        && !obj_index(r, &r->t, &c->t)) return false;
    if (*t->p == '/' && !text_ends_token(*++t->p) && !obj_index(r, &r->n, &c->n)) return false;
    if (t->p - start >= text_token) return text_bad(t, start, "corner too long:", text_longest);
    return text_ends_token(*t->p) || text_bad(t, start, "not a corner:", obj_corner_form);
}

/* Appends three indices to an array that begins with the first corner that has one. */
static inline bool obj_indices(obj_reader *r, uint32_t **array, size_t *room, const uint32_t i[3])
{
    size_t k = 3 * r->m.triangles, had = *array ? k : 0;
    if (!*array && (i[0] & i[1] & i[2]) == mesh_none) return true;
    uint32_t *index = text_grow(&r->text, *array, room, had, k + 3 - had, sizeof *index);
    if (!index) return false;
    *array = index;
    for (; had < k; had++) index[had] = mesh_none;
    memcpy(index + k, i, 3 * sizeof *i);
    return true;
}

static inline bool obj_triangle(obj_reader *r, obj_corner a, obj_corner b, obj_corner c)
{
    mesh *m = &r->m;
    if (m->triangles == r->most) return obj_full(r);
    if (!obj_indices(r, &m->index, &r->index_room, (uint32_t[3]){a.v, b.v, c.v})
        || !obj_indices(r, &m->texture_index, &r->texture_room, (uint32_t[3]){a.t, b.t, c.t})
        || !obj_indices(r, &m->normal_index, &r->normal_room, (uint32_t[3]){a.n, b.n, c.n}))
        return false;
    m->triangles++;
    return true;
}

static inline bool obj_face(obj_reader *r)
{
    obj_corner first = {0, mesh_none, mesh_none}, last = first;
    size_t corners = 0;
    for (; text_more(&r->text); corners++) {
        obj_corner c = {0, mesh_none, mesh_none};
        if (!obj_corner_read(r, &c)) return false;
        if (corners == 0) first = c;
        if (corners >= 2 && !obj_triangle(r, first, last, c)) return false;
        last = c;
    }
    return corners >= 3 || text_bad(&r->text, r->text.p, "too few corners before", "3 or more");
}

/* A new run begins; one that got no triangle gives way. */
static inline bool obj_material(obj_reader *r)
{
    mesh *m = &r->m;
    size_t name = r->names;
    if (!obj_name(r, &m->names, &r->names, &r->names_room, 0)) return false;
    if (m->runs && m->run[m->runs - 1].first == m->triangles) m->runs--;
    mesh_run *run = text_grow(&r->text, m->run, &r->run_room, m->runs, 1, sizeof *run);
    if (!run) return false;
    m->run = run;
    run[m->runs++] = (mesh_run){(uint32_t)m->triangles, name};
    return true;
}

/* The statement at p, up to the end of its line. */
static inline bool obj_statement(obj_reader *r)
{
    static const char *const known[] = {"v", "f", "vn", "vt", "usemtl", "mtllib"};
    text_reader *t = &r->text;
    mesh *m = &r->m;
    int k = 0;
    while (k < 6 && !text_is(t, known[k])) k++;
    if (k < 6) t->p += strlen(t->keyword = known[k]);
    switch (k) {
    case 0: return obj_point(r, &r->v, &m->v, 3, 7);  /* x y z, then w, or r g b, or both */
    case 1: return obj_face(r);
    case 2: return obj_point(r, &r->n, &m->n, 3, 3);
    case 3: return obj_point(r, &r->t, &m->t, 1, 3);
    case 4: return obj_material(r);
    case 5: return obj_name(r, &m->libraries, &r->libraries, &r->libraries_room, '\n');
    }
    if ((*t->p | 32) < 'a' || (*t->p | 32) > 'z')
        return text_bad(t, t->p, "begins with", "a keyword, as v, vn, vt, f, or #");
    text_skip(t);
    return true;
}

/* What can only be known at the end: did all the items come that were named? */
static inline bool obj_complete(obj_reader *r)
{
    const obj_kind *kinds[] = {&r->v, &r->t, &r->n};
    for (int i = 0; i < 3; i++)
        if (kinds[i]->greatest > kinds[i]->count)
            return failed(r->text.f, 2, "%s:%zu: f: %s index out of range: %zu, allowed: up to %zu",
                          text_name(&r->text), kinds[i]->line, kinds[i]->name, kinds[i]->greatest,
                          kinds[i]->count);
    if (r->m.triangles == 0) return text_bad(&r->text, r->text.end, "no face before", "1 or more");
    return true;
}

/* Cuts an array to size; an empty one becomes NULL. */
static inline void *obj_fit(void *array, size_t bytes)
{
    if (!bytes) free(array);
    void *fitted = bytes ? realloc(array, bytes) : NULL;
    return fitted || !bytes ? fitted : array;
}

static inline void obj_fit_all(obj_reader *r)
{
    mesh *m = &r->m;
    m->vertices = r->v.count;
    m->normals = m->normal_index ? r->n.count : 0;  /* 0: no face asks for them */
    m->textures = m->texture_index ? r->t.count : 0;
    m->v = obj_fit(m->v, m->vertices * sizeof *m->v);
    m->n = obj_fit(m->n, m->normals * sizeof *m->n);
    size_t bytes = 3 * m->triangles * sizeof *m->index;
    m->index = obj_fit(m->index, bytes);
    m->normal_index = obj_fit(m->normal_index, m->normals ? bytes : 0);
    m->t = obj_fit(m->t, m->textures * sizeof *m->t);
    m->texture_index = obj_fit(m->texture_index, m->textures ? bytes : 0);
    m->run = obj_fit(m->run, m->runs * sizeof *m->run);
    m->names = obj_fit(m->names, m->runs ? r->names : 0);
    m->libraries = obj_fit(m->libraries, r->libraries ? r->libraries + 1 : 0);
}

static inline bool obj_read_stream(FILE *in, const char *name, size_t most, mesh *out, failure *f)
{
    obj_reader r = {.most = most < UINT32_MAX ? most : UINT32_MAX,
                    .v.name = "vertex", .t.name = "texture", .n.name = "normal"};
    *out = (mesh){0};
    if (!text_begin(&r.text, in, name, f)) return false;
    bool ok = true;
    while (ok && text_statement(&r.text)) ok = obj_statement(&r);
    ok = ok && !r.text.bad && obj_complete(&r);
    ok = text_end(&r.text) && ok;
    if (ok) obj_fit_all(&r);
    else mesh_free(&r.m);
    *out = r.m;
    return ok;
}

/* Is there a file of this name [n bytes] in the folder of `path`? A folder or a device is none, as
 * file_open has it. The model needs it: kept. */
static inline bool obj_beside(const char *path, const char *name, size_t n, obj_library_use *use,
                              void *user)
{
    char file[4096];
    struct stat s;
    const char *slash = strrchr(path, '/');
    int folder = slash && *name != '/' ? (int)(slash + 1 - path) : 0;
    snprintf(file, sizeof file, "%.*s%.*s", folder, path, (int)n, name);
    if (access(file, R_OK) != 0 || stat(file, &s) != 0 || !S_ISREG(s.st_mode)) return false;
    file_keep(&s);
    use(user, file, true);
    return true;
}

/* A line of mtllib is one name, blanks and all, or several; of C:\old\pot.mtl the last part. */
static inline void obj_libraries_each(const mesh *m, const char *path, obj_library_use *use,
                                      void *user)
{
    for (const char *p = m->libraries; p && *p; p += strcspn(p, "\n") + 1) {
        size_t line = strcspn(p, "\n"), word, last = line;
        while (last > 0 && p[last - 1] != '/' && p[last - 1] != '\\') last--;
        if (obj_beside(path, p, line, use, user)
            || obj_beside(path, p + last, line - last, use, user)) continue;
        for (const char *q = p; q < p + line; q += word + strspn(q + word, " \t")) {
            char name[201];
            word = strcspn(q, " \t\n");
            if (obj_beside(path, q, word, use, user)) continue;
            snprintf(name, sizeof name, "%.*s", (int)word, q);
            use(user, name, false);
        }
    }
}

typedef struct { const char *path; int missing; } obj_missing;

static inline void obj_library_missing(void *user, const char *name, bool there)
{
    obj_missing *m = user;
    if (there) return;
    fprintf(stderr, "%s: %.200s: mtllib %s: no such file beside it\n", program_name, m->path, name);
    m->missing++;
}

static inline int obj_libraries_missing(const mesh *m, const char *path)
{
    obj_missing x = {path, 0};
    obj_libraries_each(m, path, obj_library_missing, &x);
    return x.missing;
}

static inline void obj_library_keep(void *user, const char *name, bool there)
{
    (void)user, (void)name, (void)there;
}

static inline bool obj_read(const char *path, mesh *out, failure *f)
{
    FILE *in = file_open(path, f);
    *out = (mesh){0};
    if (!in) return false;
    bool ok = obj_read_stream(in, path, UINT32_MAX, out, f);
    fclose(in);
    if (ok) obj_libraries_each(out, path, obj_library_keep, NULL);  /* no output replaces them */
    return ok;
}

#endif
