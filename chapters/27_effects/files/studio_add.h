/* studio_add.h: what readers put into a studio. Everything is copied or taken over; then
 * studio_finish (finish.h), once.
 *
 *   uint32_t m = studio_add_material(&s, "red", cite)      with the defaults of MTL
 *   studio_palette_add(&palette, "red", m), studio_palette_find(&palette, "red")
 *   studio_add_shape(&s, x, m)                             a shape, but no polygon:
 *   studio_add_polygon(&s, corners, n, m)                  its corners are copied
 *   uint32_t k = studio_add_mesh(&s, mesh, run_material, file, smooth)   takes both over
 *   studio_place(&s, k, to_world, m, cite)                 shows mesh k; m: if no usemtl says more
 *   studio_add_light(&s, light, classic, cite)
 *   FILE *in = studio_open(&s, path, &f)                   counted; NULL: no file, or too many
 */
#ifndef EFFECTS_STUDIO_ADD_H
#define EFFECTS_STUDIO_ADD_H

#include "../../07_mesh/files/words.h"
#include "../studio.h"

/* ---------------------------------------------------------------------------------------------- */

/* ---- materials ---- */

/* A new material with the defaults of MTL: matte, opaque, and kd of its own. */
static inline uint32_t studio_add_material(studio *s, const char *name, cite at)
{
    studio_grow(s, material, s->materials);
    s->material[s->materials] = (studio_material){
        .name = name_add(&s->names, name), .kd = {0.8, 0.8, 0.8},
        .tf = {1, 1, 1}, .ns = 1000, .ni = 1, .d = 1, .illum = -1, .at = at};
    return (uint32_t)s->materials++;
}

/* From now on the name means this material. */
static inline void studio_palette_add(studio_palette *p, const char *name, uint32_t number)
{
    uint32_t k = name_add(&p->names, name);
    p->number = grown(p->number, p->names.n - 1, &p->room, sizeof *p->number);
    p->number[k] = number;
}

static inline uint32_t studio_palette_find(const studio_palette *p, const char *name)
{
    uint32_t k = name_find(&p->names, name);
    return k == name_none ? name_none : p->number[k];
}

/* ---- things ---- */

static inline void studio_add_shape(studio *s, shape x, uint32_t made_of)
{
    studio_grow(s, shape, s->shapes), studio_grow(s, shape_material, s->shapes);
    s->shape_material[s->shapes] = made_of;
    s->shape[s->shapes++] = x;
}

/* Its corners move until studio_finish says where they are. */
static inline void studio_add_polygon(studio *s, const vec3 *v, size_t n, uint32_t made_of)
{
    for (size_t i = 0; i < n; i++) {
        studio_grow(s, corner, s->corners);
        s->corner[s->corners++] = v[i];
    }
    studio_add_shape(s, shape_of_polygon(polygon_of(v, n)), made_of);
}

/* Takes the mesh over; run_material [m->runs] too: name_none where nobody knows the name. */
static inline uint32_t studio_add_mesh(studio *s, mesh m, uint32_t *run_material, uint32_t file,
                                       bool smooth)
{
    studio_grow(s, mesh, s->meshes), studio_grow(s, paint, s->meshes);
    s->paint[s->meshes] = (studio_paint){run_material, file, smooth};
    s->mesh[s->meshes] = m;
    return (uint32_t)s->meshes++;
}

static inline void studio_place(studio *s, uint32_t m, affine to_world, uint32_t made_of, cite at)
{
    studio_grow(s, placed, s->places), studio_grow(s, placing, s->places);
    s->placing[s->places] = (studio_placing){made_of, at};
    s->placed[s->places++] = (instance){to_world, m};
}

static inline void studio_add_light(studio *s, light l, bool classic, cite at)
{
    studio_grow(s, light, s->lights);
    s->light[s->lights++] = (studio_light){l, classic, at};
}

static inline FILE *studio_open(studio *s, const char *path, failure *f)
{
    if (s->files_read >= studio_most_files) {
        failed(f, 2, "%.300s: too many files, allowed: %d in all", path, studio_most_files);
        return NULL;
    }
    FILE *in = word_open(path, false, f);
    s->files_read += in != NULL;
    return in;
}

#endif
