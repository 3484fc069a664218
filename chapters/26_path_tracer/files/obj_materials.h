/* obj_materials.h: what the materials of an OBJ file are to a path tracer: Kd is matte, Ke shines.
 *
 *   lit_add_mesh(&s, &m, grey);                   a mesh that obj_read (07) has read from `path`,
 *                                                 the first of the scene s
 *   if (!obj_materials(&m, path, grey, &s, &hash, &f)) ...     and its materials; hash: of the
 *                                                 libraries (state.h), 0: none
 *
 * A name that usemtl gives means the material of that name in the first library of mtllib that has
 * it, else `grey`. Where Kd is above 1 in a channel all are divided by the largest. Ke shines from
 * both sides of a triangle, as in 27: MTL knows no front; what has Ke and says nothing of Kd is
 * black. Named on stderr: libraries that are not there; names that nobody describes, unless all of
 * them are missing; what materials say beyond Kd and Ke. A broken library: false, as mtl.h says.
 * Cost: O(runs log runs + triangles log runs + bytes of the libraries).
 */
#ifndef PATH_OBJ_MATERIALS_H
#define PATH_OBJ_MATERIALS_H

#include "../../07_mesh/files/mtl.h"
#include "../../07_mesh/files/obj.h"
#include "../../24_direct_light/lit_scene.h"
#include "long_run.h"

typedef struct { const char *name; size_t run; } obj_named;
typedef struct {
    obj_named *named;        /* [runs] by rising name, then as in the file */
    uint16_t *look;          /* [runs] grey: nothing found so far */
    size_t runs;
    uint16_t grey;
    lit_scene *s;
    uint64_t hash;
    bool ok, more;
    failure *f;
} obj_looks;

/* ---------------------------------------------------------------------------------------------- */

static inline int obj_named_order(const void *a, const void *b)
{
    const obj_named *x = a, *y = b;
    int by = strcmp(x->name, y->name);
    return by ? by : (x->run > y->run) - (x->run < y->run);
}

/* The first of this name, or the place where it would be. */
static inline size_t obj_named_find(const obj_looks *l, const char *name)
{
    size_t lo = 0, hi = l->runs;
    while (lo < hi) {
        size_t middle = lo + (hi - lo) / 2;
        if (strcmp(l->named[middle].name, name) < 0) lo = middle + 1;
        else hi = middle;
    }
    return lo;
}

/* The material of that name, of which nothing is said yet; grey: no run has it, or it has been. */
static inline uint16_t obj_look_new(obj_looks *l, const char *name)
{
    size_t k = obj_named_find(l, name);
    uint16_t look = l->grey;
    for (; k < l->runs && strcmp(l->named[k].name, name) == 0; k++) {
        if (l->look[l->named[k].run] != l->grey) break;
        if (look == l->grey) look = lit_add_material(l->s, (material){.shine = 1});
        l->look[l->named[k].run] = look;
    }
    return look;
}

/* matte: it says Kd. A lamp is no wall. */
static inline void obj_look_set(obj_looks *l, uint16_t look, const mtl_material *m, bool matte)
{
    bool black = !matte && !vzero(m->ke);
    vec3 kd = vscale(m->kd, black ? 0 : 1 / real_max(1, vlargest(m->kd)));
    l->s->material[look] = (material){.kd = kd, .ke = m->ke, .both = true};
    l->more = l->more || !vzero(m->ks) || m->illum > 2 || m->d < 1;
}

static inline void obj_look_library(void *user, const char *file, bool there)
{
    obj_looks *l = user;
    mtl_reader r;
    uint16_t look = l->grey;
    bool matte = false;
    if (!l->ok || !there) return;
    FILE *in = file_open(file, l->f);
    l->ok = in && mtl_begin(&r, in, file, l->f);
    if (l->ok) l->hash = long_run_hash(l->hash, file);
    while (l->ok && mtl_next(&r)) {
        if (r.said.key == MTL_NEWMTL) look = obj_look_new(l, r.name);
        matte = r.said.key == MTL_KD || (matte && r.said.key != MTL_NEWMTL);
        if (look != l->grey) obj_look_set(l, look, &r.material, matte), l->more |= r.textures;
    }
    l->ok = l->ok && mtl_end(&r);
    if (in) fclose(in);
}

/* The triangles of each run are of its material, and shine, if that does. */
static inline void obj_look_paint(const obj_looks *l, const mesh *m)
{
    lit_scene *s = l->s;
    for (size_t i = 0; i < m->triangles; i++) {
        size_t run = mesh_run_of(m, i);
        s->of_triangle[i] = run ? l->look[run - 1] : l->grey;
        uint16_t look = s->of_triangle[i];
        emitter e = emitter_of_triangle(mesh_triangle(m, i), s->material[look].ke);
        s->emitter_of[i] = lit_emitter(s, look, e);
    }
}

/* "None" and "(null)" are how programs write that there is no material. */
static inline void obj_look_unknown(const obj_looks *l, const char *path)
{
    const char *first = NULL;
    size_t n = 0;
    for (size_t k = 0; k < l->runs; k++) {
        const char *name = l->named[k].name;
        if (l->look[l->named[k].run] != l->grey || !*name || strcmp(name, "None") == 0
            || strcmp(name, "(null)") == 0) continue;
        if (k && strcmp(name, l->named[k - 1].name) == 0) continue;
        if (n++ == 0) first = name;
    }
    if (n) fprintf(stderr, "%s: %.300s: material '%.100s' is nowhere described: grey", program_name,
                   path, first);
    if (n > 1) fprintf(stderr, " (and %zu more)", n - 1);
    if (n) fprintf(stderr, "\n");
}

static inline bool obj_materials(const mesh *m, const char *path, uint16_t grey, lit_scene *s,
                                 uint64_t *hash, failure *f)
{
    obj_looks l = {allocate(m->runs, sizeof *l.named), allocate(m->runs, sizeof *l.look), m->runs,
                   grey, s, 0, true, false, f};
    for (size_t k = 0; k < m->runs; k++)
        l.named[k] = (obj_named){m->names + m->run[k].name, k}, l.look[k] = grey;
    qsort(l.named, l.runs, sizeof *l.named, obj_named_order);
    int missing = obj_libraries_missing(m, path);
    obj_libraries_each(m, path, obj_look_library, &l);
    if (l.ok) obj_look_paint(&l, m);
    if (l.ok && (l.hash || !missing)) obj_look_unknown(&l, path);
    if (l.more)
        fprintf(stderr, "%s: %.300s: of its materials only Kd and Ke are used here: 27_effects "
                "knows the others\n", program_name, path);
    *hash = l.hash;
    free(l.named), free(l.look);
    return l.ok;
}

#endif
