/* finish.h: what can be said of a scene when all of it is read: who is used, what emits.
 *
 *   studio_finish(&s, &f)      once, at the end of reading: studio_read does it
 *
 *   corners     polygons are told where theirs are
 *   used        of materials: does a shape, or a triangle of a placed mesh, have it?
 *   emitter     a list of all that has Ke: shapes, and triangles by place
 *   classic     lights of NFF get their intensity: I = pi c D^2, D the distance from where the
 *               camera looks at (without a camera: the middle of everything)                 (27.4)
 *
 * False (exit code 2): more than studio_most_emitters faces emit: instances of a mesh that glows;
 * a light of NFF so far away that no number holds its intensity; a solid (solids.h) that lets light
 * through or emits it.
 */
#ifndef EFFECTS_FINISH_H
#define EFFECTS_FINISH_H

#include "../appearance.h"
#include "studio_add.h"

/* ---------------------------------------------------------------------------------------------- */

/* The triangles of run k of a mesh; k = m->runs stands for those before the first run. */
static inline void finish_range(const mesh *m, size_t k, size_t *first, size_t *end)
{
    *first = k < m->runs ? m->run[k].first : 0;
    *end = k == m->runs ? (m->runs ? m->run[0].first : m->triangles)
        : k + 1 < m->runs ? m->run[k + 1].first : m->triangles;
}

typedef struct { uint32_t *triangle; size_t n; } finish_list;

/* Of one mesh: the triangles that emit by their own material, and those without one. */
static inline void finish_lists(studio *s, size_t number, finish_list *glow, finish_list *bare)
{
    const mesh *m = &s->mesh[number];
    *glow = *bare = (finish_list){NULL, 0};
    for (int pass = 0; pass < 2; pass++) {  /* count, then fill */
        if (pass) glow->triangle = allocate(glow->n, sizeof *glow->triangle);
        if (pass) bare->triangle = allocate(bare->n, sizeof *bare->triangle);
        glow->n = bare->n = 0;
        for (size_t k = 0; k <= m->runs; k++) {
            uint32_t a = k < m->runs ? s->paint[number].run_material[k] : name_none;
            size_t first, end;
            finish_range(m, k, &first, &end);
            finish_list *to = a == name_none ? bare : vzero(s->material[a].ke) ? NULL : glow;
            for (size_t i = first; to && i < end; i++, to->n++)
                if (pass) to->triangle[to->n] = (uint32_t)i;
        }
    }
}

static inline bool finish_emits(studio *s, uint32_t place, const finish_list *list, failure *f)
{
    if (s->emitters + list->n > studio_most_emitters)
        return failed(f, 2, "%zu faces emit light: at most %d are allowed", s->emitters + list->n,
                      studio_most_emitters);
    for (size_t i = 0; i < list->n; i++) {
        studio_grow(s, emitter, s->emitters);
        s->emitter[s->emitters++] = (studio_emitter){place, list->triangle[i]};
    }
    return true;
}

/* All places of one mesh. */
static inline bool finish_mesh(studio *s, uint32_t number, failure *f)
{
    finish_list glow, bare;
    const mesh *m = &s->mesh[number];
    bool ok = true, seen = false;
    finish_lists(s, number, &glow, &bare);
    for (uint32_t p = 0; ok && p < s->places; p++) {
        if (s->placed[p].mesh != number) continue;
        studio_material *own = &s->material[s->placing[p].material];
        seen = true;
        own->used |= bare.n > 0;
        ok = finish_emits(s, p, &glow, f) && (vzero(own->ke) || finish_emits(s, p, &bare, f));
    }
    for (size_t k = 0; seen && k < m->runs; k++) {
        uint32_t a = s->paint[number].run_material[k];
        size_t first, end;
        finish_range(m, k, &first, &end);
        if (a != name_none && first < end) s->material[a].used = true;
    }
    free(glow.triangle), free(bare.triangle);
    return ok;
}

/* (27.4) */
static inline bool finish_classic_lights(studio *s, failure *f)
{
    char said[300];
    vec3 lo, hi, middle = s->view.at;
    if (!s->view.given && studio_bounds(s, &lo, &hi))
        middle = vmadd(vscale(lo, 0.5), hi, 0.5);
    for (size_t i = 0; i < s->lights; i++) {
        light *l = &s->light[i].light;
        real D = vlength(vsub(l->at, middle));
        if (!s->light[i].classic) continue;
        l->colour = vscale(l->colour, pi * D * D);
        if (!vfinite(l->colour))
            return failed(f, 2, "%s: l: too far away: no number holds its intensity, allowed: "
                          "nearer", studio_said(s, s->light[i].at, said, sizeof said));
    }
    return true;
}

/* Media (19) are of bodies with a surface each, lamps of faces: a tree of operands is neither. */
static inline bool finish_solid(studio *s, const studio_solid *x, failure *f)
{
    char said[300];
    studio_material *m = &s->material[x->material];
    bool through = !vzero(appearance_of(m).through);
    m->used = true;
    if (!through && vzero(m->ke)) return true;
    return failed(f, 2, "%s: solid: '%.60s' %s, allowed: materials that do not",
                  studio_said(s, x->at, said, sizeof said), studio_material_name(s, x->material),
                  through ? "lets light through" : "emits light");
}

static inline bool studio_finish(studio *s, failure *f)
{
    const vec3 *next = s->corner;
    bool ok = true;
    for (size_t i = 0; i < s->shapes; i++) {
        shape *x = &s->shape[i];
        s->material[s->shape_material[i]].used = true;
        if (x->kind == SHAPE_POLYGON) x->polygon.v = next, next += x->polygon.n;
    }
    for (size_t k = 0; ok && k < s->solids; k++) ok = finish_solid(s, &s->solid[k], f);
    for (uint32_t i = 0; ok && i < s->shapes; i++)
        if (!vzero(s->material[s->shape_material[i]].ke))
            ok = finish_emits(s, no_shape, &(finish_list){&i, 1}, f);
    for (uint32_t m = 0; ok && m < s->meshes; m++) ok = finish_mesh(s, m, f);
    return ok && finish_classic_lights(s, f);
}

#endif
