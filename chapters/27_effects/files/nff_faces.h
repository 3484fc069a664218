/* nff_faces.h: NFF: numbers wherever they stand, places, polygons, patches, triangles.
 *
 *   nff_number(&r, &x, lowest, highest)   the next one, on this line or a later one
 *   nff_place(&r, &p)                     a point, moved to where the file stands
 *   nff_polygon(&r), nff_patch(&r)        behind "p" and "pp"
 *
 * Triangles, and patches cut into triangles, are collected in r.m, one mesh for the whole file; a
 * run begins where the material changes. Polygons of more corners become shapes: exact, concave or
 * not.
 */
#ifndef EFFECTS_NFF_FACES_H
#define EFFECTS_NFF_FACES_H

#include "mtl.h"
#include "../patch.h"

typedef struct {
    studio *s;
    text_reader t;
    uint32_t file, material;    /* of what comes next */
    affine to_world;
    real size;                  /* how much it scales; 0: not evenly */
    name_table fills;           /* f lines by their numbers */
    uint32_t *fill;             /* [fills.n] materials */
    vec3 *v, *n;                /* corners and normals of the polygon at hand */
    mesh m;
    uint32_t *run_material;
    size_t fill_room, v_room, n_room, mesh_v_room, mesh_n_room, index_room, run_room,
        run_material_room, plain_lights;
    bool smooth, viewed;
} nff_reader;

/* ---------------------------------------------------------------------------------------------- */

static inline cite nff_cite(const nff_reader *r) { return (cite){r->file, (uint32_t)r->t.line}; }

/* Numbers anywhere behind, on this line or the next ones. */
static inline bool nff_number(nff_reader *r, real *out, double lowest, double highest)
{
    (void)word_more(&r->t);
    return word_number(&r->t, out, lowest, highest);
}

static inline bool nff_point(nff_reader *r, vec3 *out)
{
    const double most = word_largest;
    return nff_number(r, &out->x, -most, most) && nff_number(r, &out->y, -most, most)
        && nff_number(r, &out->z, -most, most);
}

static inline bool nff_colour(nff_reader *r, vec3 *out)
{
    return nff_number(r, &out->x, 0, 1e30) && nff_number(r, &out->y, 0, 1e30)
        && nff_number(r, &out->z, 0, 1e30);
}

static inline bool nff_finite(nff_reader *r, vec3 p)
{
    return vfinite(p) || text_bad(&r->t, r->t.p, "moved beyond what numbers hold, before",
                                  "smaller places");
}

/* The corner of a shape, moved to where it belongs. */
static inline bool nff_place(nff_reader *r, vec3 *out)
{
    if (!nff_point(r, out)) return false;
    *out = affine_point(r->to_world, *out);
    return nff_finite(r, *out);
}

static inline bool nff_radius(nff_reader *r, real *out)
{
    if (r->size == 0)
        return text_bad(&r->t, r->t.p, "scaled by unlike factors, before", "polygons and patches");
    if (!nff_number(r, out, -word_largest, word_largest)) return false;
    *out *= r->size;
    return nff_finite(r, (vec3){*out, 0, 0});
}

/* ---- triangles ---- */

static inline void nff_vertex(nff_reader *r, size_t i)
{
    mesh *m = &r->m;
    m->v = grown(m->v, m->vertices, &r->mesh_v_room, sizeof *m->v);
    m->n = grown(m->n, m->vertices, &r->mesh_n_room, sizeof *m->n);
    m->v[m->vertices] = r->v[i], m->n[m->vertices++] = r->n[i];
}

/* Triangles between the corners at hand; their normals may be zero. */
static inline bool nff_triangles(nff_reader *r, size_t corners, const uint32_t *index, size_t n)
{
    mesh *m = &r->m;
    size_t first = m->vertices;
    if (first + corners >= mesh_none / 4)
        return failed(r->t.f, 2, "%s: too many corners", text_name(&r->t));
    if (!m->runs || r->run_material[m->runs - 1] != r->material) {
        m->run = grown(m->run, m->runs, &r->run_room, sizeof *m->run);
        r->run_material = grown(r->run_material, m->runs, &r->run_material_room,
                                sizeof *r->run_material);
        r->run_material[m->runs] = r->material;
        m->run[m->runs++] = (mesh_run){(uint32_t)m->triangles, 0};
    }
    for (size_t i = 0; i < corners; i++) nff_vertex(r, i);
    for (size_t i = 0; i < 3 * n; i++) {
        m->index = grown(m->index, 3 * m->triangles + i, &r->index_room, sizeof *m->index);
        m->index[3 * m->triangles + i] = (uint32_t)(first + index[i]);
    }
    m->triangles += n;
    return true;
}

/* The list of corners, `normals` if each has one. */
static inline bool nff_corners(nff_reader *r, bool normals, size_t *corners)
{
    real count;
    if (!nff_number(r, &count, 3, 1e9)) return false;
    *corners = (size_t)count;
    if ((real)*corners != count)
        return text_bad(&r->t, r->t.p, "not a whole number before", "3 or more");
    for (size_t i = 0; i < *corners; i++) {
        r->v = grown(r->v, i, &r->v_room, sizeof *r->v);
        r->n = grown(r->n, i, &r->n_room, sizeof *r->n);
        r->n[i] = (vec3){0, 0, 0};
        if (!nff_place(r, &r->v[i]) || (normals && !nff_point(r, &r->n[i]))) return false;
    }
    return true;
}

static inline bool nff_polygon(nff_reader *r)
{
    size_t n;
    if (!nff_corners(r, false, &n)) return false;
    if (n == 3) return nff_triangles(r, 3, (const uint32_t[]){0, 1, 2}, 1);
    studio_add_polygon(r->s, r->v, n, r->material);
    return true;
}

static inline bool nff_patch(nff_reader *r)
{
    size_t n;
    if (!nff_corners(r, true, &n)) return false;
    uint32_t *index = allocate(n, 3 * sizeof *index);
    size_t triangles = patch_triangles(r->v, n, index);
    bool ok = triangles > 0
        || text_bad(&r->t, r->t.p, "a concave patch of many corners before", "up to 256 corners");
    affine back;
    if (affine_inverse(r->to_world, &back))  /* normals go by the inverse transposed (16) */
        for (size_t i = 0; i < n; i++) r->n[i] = normal_to_world(&back, r->n[i]);
    ok = ok && nff_triangles(r, n, index, triangles);
    free(index);
    return r->smooth = true, ok;
}

#endif
