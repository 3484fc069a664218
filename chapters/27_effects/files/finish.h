/* finish.h: what can be said of a scene when all of it is read: who is used, what emits.
 *
 *   studio_finish(&s, &f)      once, at the end of reading: studio_read does it
 *
 *   corners     polygons are told where theirs are; those that emit, but for parallelograms, become
 *               triangles: of these points can be drawn (lamps.h)
 *   used        of materials: does a shape, or a triangle of a placed mesh, have it?
 *   emitter     a list of all that has Ke: shapes, and triangles by place
 *   classic     lights of NFF get their intensity: I = pi c D^2, D the distance from where the
 *               camera looks at (without a camera: the middle of everything)                 (27.4)
 *
 * False (exit code 2): more than studio_most_emitters faces emit: instances of a mesh that glows;
 * a light of NFF so far away that no number holds its intensity; a solid (solids.h) that lets light
 * through or emits it; a cone, or a concave polygon of many corners, that emits; a roughness of
 * what is no glass.
 */
#ifndef EFFECTS_FINISH_H
#define EFFECTS_FINISH_H

#include "../appearance.h"
#include "patch.h"
#include "studio_add.h"

/* ---------------------------------------------------------------------------------------------- */

static inline bool finish_emits(studio *s, uint32_t place, uint32_t index, failure *f)
{
    if (s->emitters == studio_most_emitters)
        return failed(f, 2, "too many faces emit light: at most %d are allowed",
                      studio_most_emitters);
    studio_grow(s, emitter, s->emitters);
    s->emitter[s->emitters++] = (studio_face){place, index};
    return true;
}

/* A mesh is a row of runs, each of one material; name_none: that of the place, and so are the
 * triangles before the first usemtl. */
typedef struct { uint32_t first, end, material; } finish_run;

/* Those that emit, or would by a place's material: [*n], the caller frees them. */
static inline finish_run *finish_runs(studio *s, uint32_t number, bool *bare, size_t *n)
{
    const mesh *m = &s->mesh[number];
    finish_run *list = allocate(m->runs + 1, sizeof *list);
    *n = 0, *bare = false;
    for (size_t k = 0; k <= m->runs; k++) {
        finish_run r = {k ? m->run[k - 1].first : 0,
                        k < m->runs ? m->run[k].first : (uint32_t)m->triangles,
                        k ? s->paint[number].run_material[k - 1] : name_none};
        if (r.first >= r.end) continue;
        if (r.material == name_none) *bare = true;
        else s->material[r.material].used = true;
        if (r.material == name_none || !vzero(s->material[r.material].mtl.ke)) list[(*n)++] = r;
    }
    return list;
}

/* All places of one mesh. */
static inline bool finish_mesh(studio *s, uint32_t number, failure *f)
{
    finish_run *list = NULL;
    bool bare = false, ok = true;
    size_t n = 0;
    for (uint32_t p = 0; ok && p < s->places; p++) {
        if (s->placed[p].mesh != number) continue;
        if (!list) list = finish_runs(s, number, &bare, &n);
        studio_material *own = &s->material[s->placing[p].material];
        own->used |= bare;
        for (size_t k = 0; k < n; k++)
            for (uint32_t i = list[k].first; ok && i < list[k].end; i++)
                if (list[k].material != name_none || !vzero(own->mtl.ke))
                    ok = finish_emits(s, p, i, f);
    }
    free(list);
    return ok;
}

/* (27.4) */
static inline bool finish_classic_lights(studio *s, failure *f)
{
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
                          "nearer", studio_said(s, s->light[i].at).text);
    }
    return true;
}

/* Media (19) are of bodies with a surface each: a tree of operands is none. Lamps are drawn from
 * face by face, and nobody draws points of a cut face, or of a cone. */
static inline bool finish_refuses(studio *s, uint32_t made_of, const char *what, bool opaque,
                                  cite at, failure *f)
{
    studio_material *m = &s->material[made_of];
    bool through = opaque && !vzero(appearance_of(m).m.through);
    if (!through && vzero(m->mtl.ke)) return false;
    failed(f, 2, "%s: %s: '%.60s' %s, allowed: materials that do not",
           studio_said(s, at).text, what, studio_material_name(s, made_of),
           through ? "lets light through" : "emits light");
    return true;
}

static inline bool finish_is_parallelogram(const polygon *g)
{
    vec3 s = vsub(g->v[1], g->v[0]), t = vsub(g->v[g->n - 1], g->v[0]);
    real size = vlength(s) + vlength(t) + surface_reach(g->v[0]);
    return g->n == 4 && vlength(vsub(vsub(g->v[2], g->v[1]), t)) <= 16 * real_epsilon * size;
}

/* Shape i, a polygon that emits: the first triangle in its place, the others behind all shapes. */
static inline bool finish_lamp(studio *s, uint32_t i, failure *f)
{
    const polygon g = s->shape[i].polygon;
    uint32_t m = s->shape_material[i], *k = NULL;
    if (finish_is_parallelogram(&g)) return true;
    k = allocate(g.n, 3 * sizeof *k);
    size_t n = patch_triangles(g.v, g.n, k);
    for (size_t j = 0; j < n; j++) {
        triangle t = {g.v[k[3 * j]], g.v[k[3 * j + 1]], g.v[k[3 * j + 2]]};
        if (j) studio_add_shape(s, shape_of_triangle(t), m);
        else s->shape[i] = shape_of_triangle(t);
    }
    free(k);
    return n || failed(f, 2, "%s: Ke: of a concave polygon of %u corners, allowed: of up to %d",
                       studio_said(s, s->material[m].said[MTL_KE]).text,
                       (unsigned)g.n, patch_most);
}

static inline bool finish_rough(const studio *s, failure *f)
{
    for (uint32_t m = 0; m < s->materials; m++) {
        const studio_material *x = &s->material[m];
        if (!(x->mtl.roughness > 0) || appearance_of(x).m.alpha > 0) continue;
        return failed(f, 2, "%s: roughness: '%.60s' is no glass, allowed: 0, or with illum 7, Tf "
                      "above 0, Ni not 1; of what reflects alone say Ns",
                      studio_said(s, x->said[MTL_ROUGHNESS]).text,
                      studio_material_name(s, m));
    }
    return true;
}

/* Solids that have an end come first, for the tree; of others, which no tree holds, there may be
 * few. */
static inline bool finish_solids(studio *s, failure *f)
{
    enum { most = 64 };
    for (size_t k = 0; k < s->solids; k++) {
        const studio_solid x = s->solid[k];
        const csg_bound b = x.c.node[0].bound;
        s->material[x.material].used = true;
        if (finish_refuses(s, x.material, "solid", true, x.at, f)) return false;
        if (vlargest(vmax(vabs(b.lo), vabs(b.hi))) <= items_most)
            s->solid[k] = s->solid[s->boxed], s->solid[s->boxed++] = x;
        else if (k - s->boxed == most)
            return failed(f, 2, "%s: solid: one too many without end, allowed: %d in all",
                          studio_said(s, x.at).text, most);
    }
    return true;
}

static inline bool studio_finish(studio *s, failure *f)
{
    const vec3 *next = s->corner;
    if (!finish_rough(s, f) || !finish_solids(s, f)) return false;
    for (uint32_t i = 0; i < s->shapes; i++) {
        shape *x = &s->shape[i];
        uint32_t m = s->shape_material[i];
        s->material[m].used = true;
        if (x->kind == SHAPE_POLYGON) x->polygon.v = next, next += x->polygon.n;
        if (vzero(s->material[m].mtl.ke)) continue;
        if (x->kind == SHAPE_CONE && finish_refuses(s, m, "cone", false, s->material[m].at, f))
            return false;
        if (x->kind == SHAPE_POLYGON && !finish_lamp(s, i, f)) return false;
        if (!finish_emits(s, no_shape, i, f)) return false;
    }
    for (uint32_t m = 0; m < s->meshes; m++)
        if (!finish_mesh(s, m, f)) return false;
    return finish_classic_lights(s, f);
}

#endif
