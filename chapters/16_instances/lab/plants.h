/* plants.h: a few plants as meshes: z up, the foot of the stem at the origin, about 1 high.
 *
 *   plant p = plant_fir(seed), plant_grass(seed)
 *   plant p = plant_grown(seed, plant_oak)     or plant_birch, plant_bush
 *   mesh_free(&p.m)
 *
 * Stems are rings of quadrilaterals, leaves single triangles. Leaves have normals that lean half
 * outwards from the middle of the crown: it looks round, though its leaves are flat.
 */
#ifndef INSTANCES_LAB_PLANTS_H
#define INSTANCES_LAB_PLANTS_H

#include "../../07_mesh/scenes/soup.h"

typedef struct {
    mesh m;
    uint32_t wood;         /* triangles below this number are wood, the others leaves */
    vec3 bark, leaf, leaf_too;  /* colours; of leaves each instance has one in between */
} plant;

/* ---------------------------------------------------------------------------------------------- */

/* Room for n triangles, each with corners of its own; m counts what is used. */
static inline plant plant_room(size_t n, vec3 bark, vec3 leaf, vec3 leaf_too)
{
    plant p = {mesh_room(n), 0, bark, leaf, leaf_too};
    p.m.n = allocate(3 * n, sizeof *p.m.n);
    p.m.vertices = p.m.triangles = 0;
    return p;
}

static inline void plant_triangle(plant *p, vec3 a, vec3 b, vec3 c, vec3 na, vec3 nb, vec3 nc)
{
    mesh *m = &p->m;
    const vec3 v[3] = {a, b, c}, n[3] = {na, nb, nc};
    for (int k = 0; k < 3; k++) {
        m->n[m->vertices] = n[k];
        m->v[m->vertices++] = v[k];
    }
    m->normals = m->vertices, m->triangles++;
}

/* Cone from a, radius ra, to b, radius rb; six sides. */
static inline void plant_stem(plant *p, vec3 a, real ra, vec3 b, real rb)
{
    vec3 s, t, q[4], n[2];
    vbasis(vunit(vsub(b, a)), &s, &t);
    for (int k = 0; k < 6; k++) {
        for (int j = 0; j < 2; j++) {
            real angle = (real)(k + j) * pi / 3;
            n[j] = vmadd(vscale(s, cos(angle)), t, sin(angle));
            q[j] = vmadd(a, n[j], ra), q[2 + j] = vmadd(b, n[j], rb);
        }
        plant_triangle(p, q[0], q[1], q[3], n[0], n[1], n[1]);
        plant_triangle(p, q[0], q[3], q[2], n[0], n[1], n[0]);
    }
}

/* A leaf a b c of a crown about `middle`. */
static inline void plant_leaf(plant *p, vec3 a, vec3 b, vec3 c, vec3 middle)
{
    vec3 flat = vunit(vcross(vsub(b, a), vsub(c, a))), n[3];
    const vec3 v[3] = {a, b, c};
    for (int k = 0; k < 3; k++) {
        vec3 out = vunit(vsub(v[k], middle));
        n[k] = vadd(out, vscale(flat, vdot(flat, out) < 0 ? -1 : 1));
    }
    plant_triangle(p, a, b, c, n[0], n[1], n[2]);
}

/* One branch of a fir: it hangs, and carries needles to both sides, shorter towards its tip. */
static inline void plant_fir_branch(plant *p, vec3 foot, vec3 out, real length, real hang)
{
    enum { parts = 4 };
    vec3 side = {-out.y, out.x, 0}, middle = {0, 0, foot.z - length / 2}, at[parts + 1];
    for (int k = 0; k <= parts; k++) {
        real x = (real)k / parts;
        at[k] = vmadd(foot, out, length * x);
        at[k].z -= hang * length * x * (1 - (real)0.35 * x);
    }
    for (int k = 0; k < parts; k++)
        for (int s = -1; s <= 1; s += 2) {
            real width = length * (real)0.34 * (1 - (real)0.7 * (real)k / parts);
            vec3 tip = vmadd(vmadd(at[k], side, width * (real)s), out, (real)0.3 * length);
            tip.z -= (real)0.12 * length;
            plant_leaf(p, at[k], at[k + 1], tip, middle);
        }
}

static inline plant plant_fir(uint64_t seed)
{
    enum { rings = 17, most = 11 };
    plant p = plant_room(12 + rings * most * 8, vec(0.16, 0.10, 0.07), vec(0.045, 0.13, 0.06),
                         vec(0.08, 0.20, 0.07));
    random_stream g = random_start(seed, 1, 0);
    plant_stem(&p, vec(0, 0, -0.05), 0.022, (vec3){0, 0, 1}, 0.002);
    p.wood = (uint32_t)p.m.triangles;
    for (int i = 0; i < rings; i++) {
        real x = (real)i / rings, z = (real)0.1 + (real)0.9 * x;
        real turn = random_between(&g, 0, 2 * pi);
        int n = most - i / 3;
        for (int k = 0; k < n; k++) {
            real angle = turn + 2 * pi * ((real)k + random_between(&g, 0, 0.5)) / (real)n;
            real length = (real)0.235 * pow(1 - x, (real)0.85) * random_between(&g, 0.8, 1)
                + (real)0.02;
            vec3 foot = {0, 0, z + random_between(&g, -0.02, 0.02)};
            plant_fir_branch(&p, foot, (vec3){cos(angle), sin(angle), 0}, length,
                             random_between(&g, 0.35, 0.6));
        }
    }
    return p;
}

typedef struct {
    vec3 middle;          /* of the crown */
    real leaf_size, spread, up;  /* how far branches turn away; how much they rise */
    int levels, children, leaves;
    real stem, radius;
    vec3 bark, leaf, leaf_too;
} plant_habit;

enum { plant_oak, plant_birch, plant_bush };
static const plant_habit plant_habits[] = {
    {{0, 0, 0.62}, 0.036, 0.85, 0.12, 5, 3, 14, 0.34, 0.03,
     {0.20, 0.15, 0.11}, {0.13, 0.26, 0.05}, {0.32, 0.30, 0.05}},
    {{0, 0, 0.65}, 0.026, 0.5, 0.3, 6, 2, 22, 0.38, 0.016,
     {0.75, 0.73, 0.68}, {0.55, 0.42, 0.06}, {0.70, 0.30, 0.05}},
    {{0, 0, 0.1}, 0.11, 1.1, 0.05, 4, 3, 12, 0.25, 0.02,
     {0.18, 0.13, 0.10}, {0.14, 0.22, 0.07}, {0.26, 0.25, 0.08}}};

static inline void plant_branch(plant *p, random_stream *g, const plant_habit *h, vec3 a, vec3 d,
                                real length, real radius, int level, bool leaves)
{
    vec3 b = vmadd(a, d, length);
    if (!leaves) plant_stem(p, a, radius, b, radius * (real)0.62);
    if (leaves && level >= h->levels - 2)
        for (int k = 0; k < h->leaves; k++) {
            real off = length * (real)0.55 * random_next(g);
            vec3 aside = vscale(random_unit(g), off);
            vec3 at = vadd(vmadd(a, d, length * random_between(g, 0.3, 1.1)), aside);
            vec3 x = random_unit(g), y = vcross(x, random_unit(g));
            plant_leaf(p, at, vmadd(at, x, h->leaf_size),
                       vmadd(vmadd(at, x, h->leaf_size / 2), y, h->leaf_size), h->middle);
        }
    if (level + 1 >= h->levels) return;
    for (int k = 0; k < h->children; k++) {
        random_stream own = random_start(random_next_bits(g), 0, 0);  /* the same in both passes */
        vec3 s, t;
        vbasis(d, &s, &t);
        real angle = 2 * pi * ((real)k + random_between(&own, 0, 0.8)) / (real)h->children;
        vec3 e = vmadd(vmadd(d, s, h->spread * cos(angle)), t, h->spread * sin(angle));
        e.z += h->up;
        real shorter = length * random_between(&own, 0.62, 0.8);
        vec3 foot = vmadd(a, d, length * random_between(&own, 0.75, 1));
        plant_branch(p, &own, h, foot, vunit(e), shorter, radius * (real)0.6, level + 1, leaves);
    }
}

/* First all wood, then all leaves: the same random numbers in both passes. */
static inline plant plant_grown(uint64_t seed, int kind)
{
    plant_habit h = plant_habits[kind];
    size_t branches = 0, at_level = 1;
    for (int k = 0; k < h.levels; k++) branches += at_level, at_level *= (size_t)h.children;
    plant p = plant_room(branches * (12 + (size_t)h.leaves), h.bark, h.leaf, h.leaf_too);
    for (int pass = 0; pass < 2; pass++) {
        random_stream g = random_start(seed, 2, 0);
        plant_branch(&p, &g, &h, vec(0, 0, -0.03), (vec3){0, 0, 1}, h.stem, h.radius, 0, pass);
        if (!pass) p.wood = (uint32_t)p.m.triangles;
    }
    return p;
}

/* Blades that bend outwards. */
static inline plant plant_grass(uint64_t seed)
{
    enum { blades = 60 };
    const vec3 hay = {0.24, 0.30, 0.07};
    plant p = plant_room(2 * blades, hay, hay, vec(0.38, 0.36, 0.12));
    random_stream g = random_start(seed, 5, 0);
    for (int k = 0; k < blades; k++) {
        real angle = random_between(&g, 0, 2 * pi), far = (real)0.9 * sqrt(random_next(&g));
        real height = random_between(&g, 0.4, 1), turn = random_between(&g, 0, 2 * pi);
        vec3 out = {cos(angle), sin(angle), 0}, side = {cos(turn), sin(turn), 0};
        vec3 a = vscale(out, far), b = vmadd(a, side, 0.09);
        vec3 tip = vmadd(a, out, (real)0.5 * height);
        vec3 c = vmadd(vmadd(a, out, (real)0.12 * height), side, 0.08), up = {0, 0, 1};
        c.z = (real)0.6 * height, tip.z = height;
        plant_triangle(&p, a, b, c, up, up, up);
        plant_triangle(&p, a, c, tip, up, up, up);
    }
    return p;
}

#endif
