/* studio.h: a scene from files, in memory: what there is, what it is made of, and which line of
 * which file says so.
 *
 *   shape[0 .. shapes-1]       loose shapes of 07, in the world; shape_material[i] goes with each
 *   solid[0 .. solids-1]       solids cut from solids: solids.h; the first `boxed` have an end
 *   mesh[0 .. meshes-1]        triangle meshes of 07, each in a space of its own
 *   placed[0 .. places-1]      instances of 16: a mesh and where it stands; nothing else shows it
 *   material[0 .. materials-1] what MTL, NFF or scene file say; [0] is the default, matte grey
 *   light[0 .. lights-1]       lights without size (18); emitter[0 .. emitters-1]: faces with Ke
 *   view, lens, sky            camera, its lens, and what is behind everything
 *
 *   m = studio_material_of(&s, place, triangle)  its material: O(log runs); no_shape, shape: too
 *   m = studio_emitter_material(&s, i)           of emitter i
 *   aabb *box = studio_boxes(&s)                 of each of its studio_things(&s)
 *   studio_bounds(&s, &lo, &hi)                  of all; false: nothing there
 *   studio_stands(&s, place)                     placed as it is in its file, not moved
 *   studio_dark(&s)                              no light that is not black
 *   studio_said(&s, cite).text                   "room.scene:7", "(default)", "--light"
 *   studio_free(&s);                             a zeroed one may be freed
 *
 * studio_read (studio_read.h) fills it in; nothing changes afterwards, so threads may share it.
 * Numbers are finite. Radii may be negative (a sphere seen from inside), polygons concave.
 */
#ifndef EFFECTS_STUDIO_H
#define EFFECTS_STUDIO_H

#include "../07_mesh/files/mtl.h"
#include "../16_instances/placing.h"
#include "../18_shade/leave.h"
#include "../18_shade/light.h"
#include "files/name_table.h"
#include "sky.h"
#include "solids.h"

typedef struct {
    uint32_t name;             /* in s.names */
    mtl_material mtl;          /* what the file says. What that means: appearance.h */
    bool classic;              /* NFF: weights as they stand; reflections are sharp */
    bool library;              /* of an MTL file */
    cite at, said[mtl_keys];
    bool used;                 /* by a shape or a placed triangle */
} studio_material;

typedef struct { name_table names; uint32_t *number; size_t room; } studio_palette;
typedef struct { studio_palette palette; uint32_t file; } studio_library;
typedef struct { light light; bool classic; cite at; } studio_light;
typedef struct { uint32_t *run_material, file; bool smooth; } studio_paint;  /* of a mesh */
typedef struct { uint32_t material; cite at; } studio_placing;  /* for triangles without usemtl */
typedef struct { uint32_t place, index; } studio_face;  /* place no_shape: shape `index` */

typedef struct {
    bool given;                /* false: found in framing.h */
    vec3 from, at, up;
    real angle;                /* vertical, full, degrees (0, 180) */
    real hither;               /* nothing nearer is seen, along the axis of the view */
    cite said;
} studio_view;

typedef enum { INDIRECT_UNSAID, INDIRECT_OFF, INDIRECT_ON } studio_indirect;

typedef struct { real radius, focus; cite said; } studio_lens;  /* radius 0: pinhole; focus 0: at */

typedef struct {
    name_table files, names;   /* file 0 is "" */
    studio_palette own;        /* materials by name: those of scene files */
    studio_library *library;   /* [libraries] those of MTL files */
    studio_material *material;
    shape *shape;
    uint32_t *shape_material;
    studio_solid *solid;
    vec3 *corner;              /* of all polygons, one after the other */
    mesh *mesh;
    studio_paint *paint;       /* [meshes] */
    instance *placed;
    studio_placing *placing;   /* [places] */
    studio_light *light;
    studio_face *emitter;
    size_t libraries, materials, shapes, solids, boxed, corners, meshes, places, lights, emitters;
    size_t library_room, material_room, shape_room, shape_material_room,
        solid_room, corner_room, mesh_room, paint_room, placed_room, placing_room, light_room,
        emitter_room;
    studio_view view;
    studio_lens lens;
    effects_sky sky;
    cite sky_said, indirect_said;
    studio_indirect indirect;  /* is light that walls pass on wanted? */
    int up;                    /* 0, 1, 2: x, y, z is upwards, where nothing else says so; y */
    char *notes;               /* a line each: what was read but not understood */
    size_t note_count, note_size, note_room;
    uint32_t warned;           /* a bit for each of these lines that nobody should miss */
    size_t files_read;
} studio;

typedef struct { char text[300]; } cite_words;

enum {
    studio_most_files = 256,       /* read in all, so that files that include each other end */
    studio_most_notes = 20,        /* kept; the rest is counted */
    studio_most_emitters = 1 << 20 /* faces with Ke: instances multiply them */
};

/* ---------------------------------------------------------------------------------------------- */

static inline void studio_palette_free(studio_palette *p)
{
    name_table_free(&p->names);
    free(p->number);
}

static inline void studio_free(studio *s)
{
    for (size_t k = 0; k < s->libraries; k++) studio_palette_free(&s->library[k].palette);
    for (size_t k = 0; k < s->meshes; k++) mesh_free(&s->mesh[k]), free(s->paint[k].run_material);
    for (size_t k = 0; k < s->solids; k++) solid_free(&s->solid[k]);
    studio_palette_free(&s->own);
    name_table_free(&s->files), name_table_free(&s->names);
    sky_free(&s->sky);
    free(s->library), free(s->material), free(s->shape);
    free(s->shape_material), free(s->solid), free(s->corner), free(s->mesh), free(s->paint);
    free(s->placed);
    free(s->placing), free(s->light), free(s->emitter), free(s->notes);
    *s = (studio){.up = 0};
}

static inline cite_words studio_said(const studio *s, cite c)
{
    cite_words w = {"(default)"};
    if (c.file) snprintf(w.text, sizeof w.text, c.line ? "%s:%u" : "%s",
                         name_text(&s->files, c.file), (unsigned)c.line);
    return w;
}

static inline const char *studio_material_name(const studio *s, uint32_t m)
{
    return name_text(&s->names, s->material[m].name);
}

static inline size_t studio_things(const studio *s) { return s->shapes + s->places + s->solids; }

static inline scene studio_shapes(const studio *s) { return (scene){s->shape, s->shapes}; }

static inline uint32_t studio_material_of(const studio *s, uint32_t place, uint32_t k)
{
    if (place == no_shape) return s->shape_material[k];
    uint32_t m = s->placed[place].mesh;
    size_t run = mesh_run_of(&s->mesh[m], k);
    uint32_t of = run ? s->paint[m].run_material[run - 1] : name_none;
    return of == name_none ? s->placing[place].material : of;
}

static inline uint32_t studio_emitter_material(const studio *s, size_t i)
{
    return studio_material_of(s, s->emitter[i].place, s->emitter[i].index);
}

/* No light at all: then each ray of the eye carries a lamp, or the picture would be black. */
static inline bool studio_dark(const studio *s)
{
    for (size_t i = 0; i < s->lights; i++)
        if (!vzero(s->light[i].light.colour)) return false;
    return !s->emitters && !sky_lights(&s->sky);
}

static inline bool studio_stands(const studio *s, size_t place)
{
    affine a = s->placed[place].to_world, one = affine_scaling((vec3){1, 1, 1});
    return memcmp(&a, &one, sizeof a) == 0;
}

/* Of shapes, then places, then solids; the caller frees them. A mesh that was turned: a box round
 * the corners of its own. */
static inline aabb *studio_boxes(const studio *s)
{
    aabb *list = allocate(studio_things(s), sizeof *list), *x = list;
    aabb *own = allocate(s->meshes, sizeof *own);
    for (size_t m = 0; m < s->meshes; m++)
        if (!mesh_bounds(&s->mesh[m], &own[m].lo, &own[m].hi)) own[m] = aabb_empty();
    for (size_t i = 0; i < s->shapes; i++, x++) shape_bounds(s->shape[i], &x->lo, &x->hi);
    for (size_t k = 0; k < s->places; k++, x++) {
        const aabb b = own[s->placed[k].mesh];
        *x = aabb_empty();
        for (int i = 0; i < 8 && !aabb_is_empty(b); i++) {
            vec3 p = {i & 1 ? b.lo.x : b.hi.x, i & 2 ? b.lo.y : b.hi.y, i & 4 ? b.lo.z : b.hi.z};
            *x = aabb_grow_point(*x, affine_point(s->placed[k].to_world, p));
        }
    }
    for (size_t k = 0; k < s->solids; k++, x++)
        x->lo = s->solid[k].c.node[0].bound.lo, x->hi = s->solid[k].c.node[0].bound.hi;
    free(own);
    return list;
}

/* Of what has an end. */
static inline bool studio_bounds(const studio *s, vec3 *lo, vec3 *hi)
{
    aabb *box = studio_boxes(s), all = aabb_empty();
    for (size_t i = 0; i < studio_things(s); i++)
        if (vfinite(box[i].lo) && vfinite(box[i].hi)) all = aabb_union(all, box[i]);
    free(box);
    *lo = all.lo, *hi = all.hi;
    return !aabb_is_empty(all);
}

#endif
