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
 *   studio_note(&s, format, ..), studio_warns(&s)          something to tell; .. that matters
 *   FILE *in = studio_open(&s, path, &f)                   counted; NULL: no file, or too many
 */
#ifndef EFFECTS_STUDIO_ADD_H
#define EFFECTS_STUDIO_ADD_H

#include "../../07_mesh/files/words.h"
#include "../studio.h"

/* ---------------------------------------------------------------------------------------------- */

/* Room for one more in s->ARRAY, which has n of them. */
#define studio_grow(s, array, n) \
    ((s)->array = grown((s)->array, n, &(s)->array##_room, sizeof *(s)->array))

/* Something to tell whoever reads the scene: kept, not an error. */
__attribute__((format(printf, 2, 3)))
static inline void studio_note(studio *s, const char *format, ...)
{
    char text[480];
    va_list arguments;
    if (s->note_count++ >= studio_most_notes) return;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    while (s->note_size + sizeof text >= s->note_room)  /* the old text is note_room long */
        s->notes = grown(s->notes, s->note_room, &s->note_room, 1);
    for (const char *p = text; *p; p++)
        s->notes[s->note_size++] = (char)((unsigned char)*p < ' ' || *p == 127 ? '?' : *p);
    s->notes[s->note_size++] = '\n', s->notes[s->note_size] = 0;
}

/* The note just made is more than that: something will not look as it was meant to. */
static inline void studio_warns(studio *s)
{
    if (s->note_count <= studio_most_notes) s->warned |= (uint32_t)1 << (s->note_count - 1);
}

/* ---- materials ---- */

/* A new material with the defaults of MTL. */
static inline uint32_t studio_add_material(studio *s, const char *name, cite at)
{
    studio_grow(s, material, s->materials);
    s->material[s->materials] = (studio_material){
        .name = name_add(&s->names, name), .mtl = mtl_default, .at = at};
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

/* Unturned, the middle of the picture is seen along the first axis that is not up, backwards:
 * -z with y up, as a camera looks that was not turned; +y with z up. */
static inline void sky_aim(effects_sky *s, int up, real degrees)
{
    static const int axis[3][2][3] = {{{1, 0, 0}, {0, 1, 0}}, {{0, 1, 0}, {0, 0, -1}},
                                      {{0, 0, 1}, {0, 1, 0}}};
    const int (*a)[3] = axis[up];
    s->up = vec(a[0][0], a[0][1], a[0][2]);
    vec3 front = {(real)a[1][0], (real)a[1][1], (real)a[1][2]};
    s->front = degrees == 0 ? front : vturned(front, s->up, degrees * (pi / 180));
    s->right = vcross(s->front, s->up);
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
