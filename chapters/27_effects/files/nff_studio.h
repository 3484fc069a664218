/* nff_studio.h: an NFF file (nff.h of 07) as part of a scene: view, lights, materials and shapes.
 *
 *   if (!nff_studio(&s, "balls.nff", material, &f)) ...     material: of what comes before the
 * first f
 *
 *   f becomes a studio_material: kd = Kd rgb, ks = Ks rgb, ns = Shine, tf = T T T, ni = ior.
 *   A file with a view sets s.view, if no file did before. Triangles, and patches cut into
 *   triangles, become one mesh, in which a run begins where the material changes; polygons of more
 *   corners are shapes: concave or not.
 *
 * Broken: "FILE:LINE: ..", exit code 2; cannot be read: 1. Memory: up to some 30 times the size of
 * the file. Patches: corner 0 sees all edges, or at most 256 corners.
 */
#ifndef EFFECTS_NFF_STUDIO_H
#define EFFECTS_NFF_STUDIO_H

#include "../../07_mesh/files/nff.h"
#include "patch.h"
#include "mtl_studio.h"

typedef struct {
    studio *s;
    nff_reader read;
    uint32_t file, material;    /* of what comes next */
    size_t fills, plain_lights;
    mesh m;
    uint32_t *run_material;
    size_t v_room, n_room, index_room, run_room, run_material_room;
    bool smooth, viewed;
} nff_place;

/* ---------------------------------------------------------------------------------------------- */

static inline cite nff_cite(const nff_place *r)
{
    return (cite){r->file, (uint32_t)r->read.item.line};
}

static inline void nff_place_fill(nff_place *r, const nff_fill *x)
{
    char name[32];
    snprintf(name, sizeof name, "f%zu", ++r->fills);
    r->material = studio_add_material(r->s, name, nff_cite(r));
    studio_material *m = &r->s->material[r->material];
    mtl_material *n = &m->mtl;
    n->kd = vscale(x->colour, x->kd), n->ks = vscale(x->colour, x->ks), n->ns = x->shine;
    n->tf = (vec3){x->transmit, x->transmit, x->transmit}, n->ni = x->ior > 0 ? x->ior : 1;
    m->classic = true;
    static const mtl_keyword said[] = {MTL_KD, MTL_KS, MTL_TF, MTL_NS, MTL_NI, MTL_ILLUM};
    for (size_t k = 0; k < sizeof said / sizeof *said; k++) m->said[said[k]] = m->at;
}

/* n triangles between the corners of the item; their normals may be zero. */
static inline bool nff_triangles(nff_place *r, const uint32_t *index, size_t n)
{
    const nff_item *x = &r->read.item;
    mesh *m = &r->m;
    size_t first = m->vertices;
    if (first + x->corners >= mesh_none / 4)
        return failed(r->read.t.f, 2, "%s: too many corners", text_name(&r->read.t));
    if (!m->runs || r->run_material[m->runs - 1] != r->material) {
        m->run = grown(m->run, m->runs, &r->run_room, sizeof *m->run);
        r->run_material = grown(r->run_material, m->runs, &r->run_material_room,
                                sizeof *r->run_material);
        r->run_material[m->runs] = r->material;
        m->run[m->runs++] = (mesh_run){(uint32_t)m->triangles, 0};
    }
    for (size_t i = 0; i < x->corners; i++) {
        m->v = grown(m->v, m->vertices, &r->v_room, sizeof *m->v);
        m->n = grown(m->n, m->vertices, &r->n_room, sizeof *m->n);
        m->v[m->vertices] = x->corner[i], m->n[m->vertices++] = x->normal[i];
    }
    for (size_t i = 0; i < 3 * n; i++) {
        m->index = grown(m->index, 3 * m->triangles + i, &r->index_room, sizeof *m->index);
        m->index[3 * m->triangles + i] = (uint32_t)(first + index[i]);
    }
    m->triangles += n;
    return true;
}

static inline bool nff_place_patch(nff_place *r)
{
    nff_item *x = &r->read.item;
    uint32_t *index = allocate(x->corners, 3 * sizeof *index);
    size_t triangles = patch_triangles(x->corner, x->corners, index);
    bool ok = triangles > 0 || nff_refuse(&r->read, "a concave patch of many corners before",
                                          "up to 256 corners");
    ok = ok && nff_triangles(r, index, triangles);
    free(index);
    return r->smooth = true, ok;
}

static inline bool nff_place_item(nff_place *r)
{
    nff_item *x = &r->read.item;
    studio *s = r->s;
    switch (x->kind) {
    case NFF_VIEW:
        if (!s->view.given || r->viewed)
            s->view = (studio_view){true, x->view.from, x->view.at, x->view.up, x->view.angle,
                                    x->view.hither, nff_cite(r)}, r->viewed = true;
        return true;
    case NFF_LIGHT:  /* plain: known when all are counted */
        if (x->light.plain) x->light.colour.x = -1, r->plain_lights++;
        studio_add_light(s, (light){LIGHT_POINT, x->light.at, x->light.colour}, true, nff_cite(r));
        return true;
    case NFF_FILL: return nff_place_fill(r, &x->fill), true;
    case NFF_BACKGROUND:
        return s->sky.background = x->background, true;
    case NFF_SPHERE: return studio_add_shape(s, shape_of_sphere(x->sphere), r->material), true;
    case NFF_CONE: return studio_add_shape(s, shape_of_cone(x->cone), r->material), true;
    case NFF_PATCH: return nff_place_patch(r);
    default:
        if (x->corners == 3) return nff_triangles(r, (const uint32_t[]){0, 1, 2}, 1);
        return studio_add_polygon(s, x->corner, x->corners, r->material), true;
    }
}

/* What one can say only when all is read: of lights, and the mesh. */
static inline void nff_place_finish(nff_place *r, bool ok, size_t lights_before, uint32_t made_of)
{
    real each = nff_plain_light(r->plain_lights);
    for (size_t i = lights_before; i < r->s->lights; i++)
        if (r->s->light[i].light.colour.x < 0)
            r->s->light[i].light.colour = (vec3){each, each, each};
    r->m.normals = r->smooth ? r->m.vertices : 0;
    if (!r->smooth) free(r->m.n), r->m.n = NULL;
    if (ok && r->m.triangles) {
        r->m.names = allocate(1, 1);
        uint32_t m = studio_add_mesh(r->s, r->m, r->run_material, r->file, r->smooth);
        studio_place(r->s, m, affine_scaling((vec3){1, 1, 1}), made_of, (cite){r->file, 0});
    } else mesh_free(&r->m), free(r->run_material);
}

static inline bool nff_studio_stream(studio *s, FILE *in, const char *path, uint32_t made_of,
                                     failure *f)
{
    nff_place r = {.s = s, .file = name_add(&s->files, path), .material = made_of};
    size_t lights_before = s->lights;
    bool ok = true;
    if (!nff_begin(&r.read, in, path, f)) return false;
    while (ok && nff_next(&r.read)) ok = nff_place_item(&r);
    ok = nff_end(&r.read) && ok;
    nff_place_finish(&r, ok, lights_before, made_of);
    return ok;
}

static inline bool nff_studio(studio *s, const char *path, uint32_t made_of, failure *f)
{
    FILE *in = studio_open(s, path, f);
    bool ok = in && nff_studio_stream(s, in, path, made_of, f);
    if (in) fclose(in);
    return ok;
}

#endif
