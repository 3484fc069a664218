/* plants.h: plants as meshes: z up, the foot of the stem at the origin, about 1 high.
 *
 *   uint32_t wood;
 *   mesh m = plant_grown(PLANT_OAK, seed, &wood)     triangles below this number are wood, the
 *                                                    others leaves; mesh_free(&m)
 *
 * A branch carries others, by its kind's habit. Stems are cones of six sides, leaves triangles,
 * whose normals lean half outwards from the middle of the crown: it looks round, though they are
 * flat.
 */
#ifndef INSTANCES_LAB_PLANTS_H
#define INSTANCES_LAB_PLANTS_H

#include "../../07_mesh/scenes/soup.h"

enum { PLANT_GROUND, PLANT_FIR, PLANT_OAK, PLANT_BIRCH, PLANT_BUSH, PLANT_GRASS, plant_kinds };

typedef struct {
    int levels, children, leaves;     /* leaves: on each branch of the last two levels */
    real stem, radius, middle, loose; /* the stem; how high the crown's middle is; how far from its
                                         branch a leaf is, in lengths of that */
    real leaf_size, spread, up;       /* how far branches turn away; how much they rise */
    real from, ratio, taper;          /* where on a branch others begin [0,1]; how long they are,
                                         of it, at its foot; how much less at its tip */
    vec3 bark, leaf, leaf_too;        /* colours; of leaves each instance has one in between */
} plant_habit;

static const plant_habit plant_habits[plant_kinds] = {
    [PLANT_GROUND] = {.leaf = {0.20, 0.24, 0.07}, .leaf_too = {0.20, 0.24, 0.07}},
    {2, 56, 14, 1, 0.009, 0.4, 0.35, 0.42, 2, -1.4, 0.08, 0.24, 0.85,
     {0.16, 0.10, 0.07}, {0.045, 0.13, 0.06}, {0.08, 0.20, 0.07}},
    {5, 3, 14, 0.34, 0.03, 0.62, 0.55, 0.36, 0.85, 0.12, 0.75, 0.71, 0,
     {0.20, 0.15, 0.11}, {0.13, 0.26, 0.05}, {0.32, 0.30, 0.05}},
    {6, 2, 22, 0.38, 0.016, 0.65, 0.55, 0.32, 0.5, 0.3, 0.75, 0.71, 0,
     {0.75, 0.73, 0.68}, {0.55, 0.42, 0.06}, {0.70, 0.30, 0.05}},
    {4, 3, 12, 0.25, 0.02, 0.1, 0.55, 1, 1.1, 0.05, 0.75, 0.71, 0,
     {0.18, 0.13, 0.10}, {0.14, 0.22, 0.07}, {0.26, 0.25, 0.08}},
    {2, 32, 0, 0.1, 0.06, 0, 0, 0, 1.5, 0.6, 0.1, 10, 0,
     {0.42, 0.42, 0.13}, {0, 0, 0}, {0, 0, 0}}};

/* ---------------------------------------------------------------------------------------------- */

static inline void plant_triangle(mesh *m, const vec3 v[3], const vec3 n[3])
{
    for (int k = 0; k < 3; k++) m->n[m->vertices] = n[k], m->v[m->vertices++] = v[k];
    m->normals = m->vertices, m->triangles++;
}

/* A strip of twelve triangles: a corner below, one above, one below .. */
static inline void plant_stem(mesh *m, vec3 a, real ra, vec3 b, real rb)
{
    vec3 s, t, v[3], n[3];
    vbasis(vunit(vsub(b, a)), &s, &t);
    for (int k = 0; k < 12; k++) {
        for (int j = 0; j < 3; j++) {
            real angle = (real)((k + j) / 2) * pi / 3;
            n[j] = vmadd(vscale(s, cos(angle)), t, sin(angle));
            v[j] = (k + j) % 2 ? vmadd(b, n[j], rb) : vmadd(a, n[j], ra);
        }
        plant_triangle(m, v, n);
    }
}

static inline void plant_leaf(mesh *m, vec3 at, vec3 x, vec3 y, real middle)
{
    vec3 v[3] = {at, vadd(at, x), vadd(vmadd(at, x, 0.5), y)}, n[3], flat = vunit(vcross(x, y));
    for (int k = 0; k < 3; k++) {
        vec3 out = vunit(vsub(v[k], (vec3){0, 0, middle}));
        n[k] = vadd(out, vscale(flat, vdot(flat, out) < 0 ? -1 : 1));
    }
    plant_triangle(m, v, n);
}

/* From a along d. leaves: these alone; else wood alone. */
static inline void plant_branch(mesh *m, random_stream *g, const plant_habit *h, vec3 a, vec3 d,
                                real length, real radius, int level, bool leaves)
{
    if (!leaves) plant_stem(m, a, radius, vmadd(a, d, length), radius * (real)0.62);
    for (int k = 0; leaves && level && level >= h->levels - 2 && k < h->leaves; k++) {
        real off = length * h->loose * random_next(g);
        vec3 aside = vscale(random_unit(g), off);
        vec3 at = vadd(vmadd(a, d, length * random_between(g, 0.3, 1.1)), aside);
        vec3 x = vscale(random_unit(g), length * h->leaf_size);
        plant_leaf(m, at, x, vcross(x, random_unit(g)), h->middle);
    }
    for (int k = 0; level + 1 < h->levels && k < h->children; k++) {
        random_stream own = random_start(random_next_bits(g), 0, 0);  /* the same in both passes */
        vec3 s, t;
        vbasis(d, &s, &t);
        real angle = 2 * pi * ((real)k + random_between(&own, 0, 0.8)) / (real)h->children;
        real at = random_between(&own, h->from, 1);
        vec3 e = vmadd(vmadd(d, s, h->spread * cos(angle)), t, h->spread * sin(angle));
        e.z += h->up;
        real part = h->ratio * random_between(&own, 0.88, 1.12) * (1 - h->taper * at);
        plant_branch(m, &own, h, vmadd(a, d, length * at), vunit(e), length * part,
                     radius * (real)0.6, level + 1, leaves);
    }
}

static inline mesh plant_grown(int kind, uint64_t seed, uint32_t *wood)
{
    const plant_habit *h = &plant_habits[kind];
    size_t branches = 0, at_level = 1;
    for (int k = 0; k < h->levels; k++) branches += at_level, at_level *= (size_t)h->children;
    mesh m = mesh_room(branches * (12 + (size_t)h->leaves));
    m.n = allocate(m.vertices, sizeof *m.n);
    m.vertices = m.triangles = 0;
    for (int pass = 0; pass < 2; pass++) {
        random_stream g = random_start(seed, 2, 0);
        if (pass) *wood = (uint32_t)m.triangles;
        plant_branch(&m, &g, h, vec(0, 0, -0.03), (vec3){0, 0, 1}, h->stem, h->radius, 0, pass);
    }
    return m;
}

#endif
