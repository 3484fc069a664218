/* nff_studio.h: an NFF file (nff.h of 07) as part of a scene: view, lights, materials and shapes.
 *
 *   if (!nff_studio(&s, "balls.nff", affine, material, &f)) ...
 *
 *   affine     stands before everything of the file: all is moved, turned, scaled by it. Spheres
 *              and cones stay what they are only if it scales evenly: else an error
 *   material   for what comes before the first f
 *
 *   f becomes a studio_material: kd = Kd rgb, ks = Ks rgb, ns = Shine, tf = T T T, ni = ior.
 *   Equal f lines become one material. A file with a view sets s.view, if no file did before.
 *   Triangles, and patches cut into triangles, become one mesh, placed as it stands, in which a run
 *   begins where the material changes; polygons of more corners are shapes: concave or not.
 *
 * Broken: "FILE:LINE: ..", exit code 2; cannot be read: 1. Memory: up to some 30 times the size of
 * the file. Patches: corner 0 sees all edges, or at most 256 corners.
 */
#ifndef EFFECTS_NFF_STUDIO_H
#define EFFECTS_NFF_STUDIO_H

#include "../../07_mesh/files/nff.h"
#include "../patch.h"
#include "mtl.h"

typedef struct {
    studio *s;
    nff_reader read;
    uint32_t file, material;    /* of what comes next */
    affine to_world;
    real size;                  /* how much it scales; 0: not evenly */
    name_table fills;           /* f lines by their numbers */
    uint32_t *fill;             /* [fills.n] materials */
    mesh m;
    uint32_t *run_material;
    size_t fill_room, mesh_v_room, mesh_n_room, index_room, run_room, run_material_room,
        plain_lights;
    bool smooth, viewed;
} nff_place;

/* ---------------------------------------------------------------------------------------------- */

static inline cite nff_cite(const nff_place *r)
{
    return (cite){r->file, (uint32_t)r->read.item.line};
}

/* Moves a point to where the file stands. */
static inline bool nff_move(nff_place *r, vec3 *p)
{
    *p = affine_point(r->to_world, *p);
    return vfinite(*p)
        || nff_refuse(&r->read, "moved beyond what numbers hold, before", "smaller places");
}

static inline bool nff_scale(nff_place *r, real *radius)
{
    if (r->size == 0)
        return nff_refuse(&r->read, "scaled by unlike factors, before", "polygons and patches");
    *radius *= r->size;
    return isfinite(*radius)
        || nff_refuse(&r->read, "moved beyond what numbers hold, before", "smaller places");
}

/* ---- view, lights, materials ---- */

static inline bool nff_place_view(nff_place *r, nff_view v)
{
    studio_view view = {.given = true, .said = nff_cite(r), .angle = v.angle,
                        .up = affine_vector(r->to_world, v.up), .hither = v.hither * r->size,
                        .width = (int)v.width, .height = (int)v.height};
    if (!nff_move(r, &v.from) || !nff_move(r, &v.at)) return false;
    view.from = v.from, view.at = v.at;
    if (!r->s->view.given || r->viewed) r->s->view = view, r->viewed = true;
    return true;
}

static inline bool nff_place_light(nff_place *r, nff_light x)
{
    light l = {LIGHT_POINT, x.at, x.colour};
    if (!nff_move(r, &l.at)) return false;
    if (x.plain) l.colour = (vec3){-1, -1, -1}, r->plain_lights++;  /* known when all are counted */
    studio_add_light(r->s, l, true, nff_cite(r));
    return true;
}

static inline bool nff_place_fill(nff_place *r, const nff_fill *x)
{
    cite at = nff_cite(r);
    char numbers[400], name[32];
    vec3 c = x->colour;
    snprintf(numbers, sizeof numbers, "%a %a %a %a %a %a %a %a", (double)c.x, (double)c.y,
             (double)c.z, (double)x->kd, (double)x->ks, (double)x->shine, (double)x->transmit,
             (double)x->ior);
    uint32_t known = name_find(&r->fills, numbers);
    if (known != name_none) return r->material = r->fill[known], true;
    name_add(&r->fills, numbers);
    snprintf(name, sizeof name, "f%zu", r->fills.n);
    r->material = studio_add_material(r->s, name, at);
    r->fill = grown(r->fill, r->fills.n - 1, &r->fill_room, sizeof *r->fill);
    r->fill[r->fills.n - 1] = r->material;
    studio_material *m = &r->s->material[r->material];
    m->kd = vscale(c, x->kd), m->ks = vscale(c, x->ks), m->ns = x->shine, m->classic = true;
    m->tf = (vec3){x->transmit, x->transmit, x->transmit}, m->ni = x->ior > 0 ? x->ior : 1;
    for (int k = 0; k < material_keys; k++) m->said[k] = at;
    m->said[KEY_KE] = m->said[KEY_ABSORB] = m->said[KEY_D] = (cite){0, 0};
    return true;
}

/* ---- faces ---- */

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
        m->v = grown(m->v, m->vertices, &r->mesh_v_room, sizeof *m->v);
        m->n = grown(m->n, m->vertices, &r->mesh_n_room, sizeof *m->n);
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
    affine back;
    if (affine_inverse(r->to_world, &back))  /* normals go by the inverse transposed (16) */
        for (size_t i = 0; i < x->corners; i++) x->normal[i] = normal_to_world(&back, x->normal[i]);
    ok = ok && nff_triangles(r, index, triangles);
    free(index);
    return r->smooth = true, ok;
}

static inline bool nff_place_face(nff_place *r)
{
    nff_item *x = &r->read.item;
    for (size_t i = 0; i < x->corners; i++)
        if (!nff_move(r, &x->corner[i])) return false;
    if (x->kind == NFF_PATCH) return nff_place_patch(r);
    if (x->corners == 3) return nff_triangles(r, (const uint32_t[]){0, 1, 2}, 1);
    studio_add_polygon(r->s, x->corner, x->corners, r->material);
    return true;
}

static inline bool nff_place_item(nff_place *r)
{
    nff_item *x = &r->read.item;
    sphere *b = &x->sphere;
    cone *c = &x->cone;
    switch (x->kind) {
    case NFF_VIEW: return nff_place_view(r, x->view);
    case NFF_LIGHT: return nff_place_light(r, x->light);
    case NFF_FILL: return nff_place_fill(r, &x->fill);
    case NFF_BACKGROUND:
        r->s->sky.background = x->background, r->s->background_said = nff_cite(r);
        return true;
    case NFF_SPHERE:
        if (!nff_move(r, &b->c) || !nff_scale(r, &b->r)) return false;
        return studio_add_shape(r->s, shape_of_sphere(*b), r->material), true;
    case NFF_CONE:
        if (!nff_move(r, &c->a) || !nff_scale(r, &c->ra) || !nff_move(r, &c->b)
            || !nff_scale(r, &c->rb)) return false;
        return studio_add_shape(r->s, shape_of_cone(*c), r->material), true;
    default: return nff_place_face(r);
    }
}

/* ---- the file ---- */

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
    name_table_free(&r->fills);
    free(r->fill);
}

static inline bool nff_studio_stream(studio *s, FILE *in, const char *path, affine to_world,
                                     uint32_t made_of, failure *f)
{
    vec3 x = to_world.x, y = to_world.y, z = to_world.z;
    real a = vlength(x), b = vlength(y), c = vlength(z), off = 64 * real_epsilon;
    bool even = fabs(a - b) <= off * a && fabs(a - c) <= off * a && fabs(vdot(x, y)) <= off * a * a
        && fabs(vdot(x, z)) <= off * a * a && fabs(vdot(y, z)) <= off * a * a;
    nff_place r = {.s = s, .file = name_add(&s->files, path), .material = made_of,
                   .to_world = to_world, .size = even ? a : 0};
    size_t lights_before = s->lights;
    if (!nff_begin(&r.read, in, path, f)) return false;
    bool ok = true;
    while (ok && nff_next(&r.read)) ok = nff_place_item(&r);
    ok = nff_end(&r.read) && ok;
    nff_place_finish(&r, ok, lights_before, made_of);
    return ok;
}

static inline bool nff_studio(studio *s, const char *path, affine to_world, uint32_t made_of,
                              failure *f)
{
    if (s->files_read >= studio_most_files)
        return failed(f, 2, "%.300s: too many files, allowed: %d in all", path, studio_most_files);
    FILE *in = word_open(path, false, f);
    if (!in) return false;
    s->files_read++;
    bool ok = nff_studio_stream(s, in, path, to_world, made_of, f);
    fclose(in);
    return ok;
}

#endif
