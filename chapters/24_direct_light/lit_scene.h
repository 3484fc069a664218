/* lit_scene.h: a scene with lights in it: triangles and shapes, their materials, what shines.
 *
 *   lit_scene s;
 *   lit_begin(&s);
 *   uint16_t grey = lit_add_material(&s, (lit_material){.f = brdf_lambert((vec3){.5, .5, .5})});
 *   lit_add_rectangle(&s, (rectangle){o, s, t}, lamp);     front: s x t; if it shines, one emitter
 *   lit_add_triangle(&s, t, grey), lit_add_mesh(&s, &m, grey), lit_add_shape(&s, shape, grey);
 *   lit_end(&s);                                           trees and tables; then use it
 *   lit_free(&s);                                          a zeroed one may be freed
 *
 *   lit_trace(&s, r, &h)      what r meets first; h.s is 18's surface, turned to where r comes from
 *   lit_occluded(&s, r)       is there anything?
 *   lit_trace_from(&s, r, i, &h), lit_occluded_from(&s, r, i, e)   the same answers, sooner, for
 *                             rays that 18's leave or leave_between made: from triangle i
 *                             [no_shape: none], to emitter e [lit_dark: none]
 *   lit_emitted(&h)           radiance towards the origin of r: Le from the front, 0 from behind
 *
 * All that is the same for every ray is computed once, by lit_end: edges, normals, error bounds
 * (18.5), (18.6), (18.9) of triangles, lights. lit_trace of a triangle is a search, then two
 * products and a sum a coordinate: the same bits as surface_of_mesh.
 *
 * Everything added is copied, but for the corners of polygons, which must outlive the scene.
 * Emitters: one per shining triangle, rectangle, sphere of area > 0: first the flat ones in the
 * order of adding, then the spheres.
 * Nothing else can shine; Le of a cone or polygon is ignored. At equal t a triangle wins against a
 * shape, else the lower index. At most 65535 materials; no memory, or more: the program ends.
 */
#ifndef DIRECT_LIT_SCENE_H
#define DIRECT_LIT_SCENE_H

#include "../14_bvh/bvh_mesh.h"
#include "../14_bvh/bvh_shapes.h"
#include "../18_shade/leave.h"
#include "../23_brdf/brdf.h"
#include "emitter.h"
#include "few.h"

typedef struct {
    brdf f;         /* reflection, on both sides; brdf_is_black: none */
    vec3 Le;        /* radiance of the front [W/(m^2 sr)]; 0: none */
    real ior;       /* > 0: smooth dielectric between inside (behind n) and outside; f is unused */
    vec3 sigma;     /* absorption inside, per unit of length */
} lit_material;

/* A triangle, ready: p = a + u e + v f (18.9), error = epsilon (reach + 2 |p|). */
typedef struct { vec3 a, e, f, n; real reach, noise, margin; } lit_face;

typedef struct { uint32_t corner[3], normal[3], emitter; uint16_t material; } lit_part;

typedef struct {
    mesh m;                   /* triangles: owned */
    uint16_t *of_triangle;    /* [m.triangles] its material */
    shape *shape;             /* [shapes] anything of 07; of these only spheres shine */
    size_t shapes;
    uint16_t *of_shape;       /* [shapes] */
    lit_material *material;
    size_t materials;
    emitter *emitter;
    size_t emitters;
    uint32_t *emitter_of;     /* [m.triangles + shapes]; lit_dark: does not shine */
    vec3 background;          /* radiance from where nothing is */
    lit_face *face;           /* [m.triangles] */
    bvh_mesh tree;
    bvh_shapes shape_tree;
    int32_t *first, *last;    /* [emitters] its lanes in `few`; -1: none, a sphere */
    few few;                  /* of up to 64 triangles: in place of the tree */
    lit_part *part;           /* what was added, until lit_end */
    struct { size_t v, n, parts, shapes, of_shape, materials, emitters; } room;
} lit_scene;

typedef struct {
    surface s;                /* faces the ray: s.n.d <= 0 */
    const lit_material *m;
    uint32_t emitter;         /* or lit_dark */
    real t;
    bool front;               /* n.d < 0 before it was turned */
} lit_hit;

#define lit_dark UINT32_MAX

/* ---------------------------------------------------------------------------------------------- */

/* Room for `more` after n of them; what is there stays. */
static inline void *lit_grow(void *old, size_t n, size_t more, size_t size, size_t *room)
{
    if (n + more <= *room) return old;
    void *x = allocate(*room = 2 * *room + more + 16, size);
    if (n) memcpy(x, old, n * size);
    free(old);
    return x;
}

static inline void lit_begin(lit_scene *s) { *s = (lit_scene){.background = {0, 0, 0}}; }

static inline uint16_t lit_add_material(lit_scene *s, lit_material m)
{
    if (s->materials >= UINT16_MAX) die(2, "more than 65535 materials");
    s->material = lit_grow(s->material, s->materials, 1, sizeof m, &s->room.materials);
    s->material[s->materials] = m;
    return (uint16_t)s->materials++;
}

/* The index of a new emitter, or lit_dark. */
static inline uint32_t lit_emitter(lit_scene *s, emitter e)
{
    if (!(e.area > 0) || !isfinite(e.area) || vzero(e.Le)) return lit_dark;
    s->emitter = lit_grow(s->emitter, s->emitters, 1, sizeof e, &s->room.emitters);
    s->emitter[s->emitters] = e;
    return (uint32_t)s->emitters++;
}

/* Room for so many corners and triangles more. */
static inline void lit_room(lit_scene *s, size_t points, size_t n)
{
    s->m.v = lit_grow(s->m.v, s->m.vertices, points, sizeof *s->m.v, &s->room.v);
    s->part = lit_grow(s->part, s->m.triangles, n, sizeof *s->part, &s->room.parts);
}

/* One triangle of corners that are in m.v already, without normals of its own. */
static inline void lit_join(lit_scene *s, size_t a, size_t b, size_t c, uint16_t material,
                            uint32_t light)
{
    s->part[s->m.triangles++] = (lit_part){{(uint32_t)a, (uint32_t)b, (uint32_t)c},
                                           {mesh_none, mesh_none, mesh_none}, light, material};
}

static inline void lit_add_triangle(lit_scene *s, triangle t, uint16_t material)
{
    size_t v = s->m.vertices;
    lit_room(s, 3, 1);
    s->m.v[v] = t.a, s->m.v[v + 1] = t.b, s->m.v[v + 2] = t.c;
    s->m.vertices += 3;
    lit_join(s, v, v + 1, v + 2, material,
             lit_emitter(s, emitter_of_triangle(t, s->material[material].Le)));
}

static inline void lit_add_rectangle(lit_scene *s, rectangle r, uint16_t material)
{
    size_t v = s->m.vertices;
    vec3 b = vadd(r.o, r.s);
    lit_room(s, 4, 2);
    s->m.v[v] = r.o, s->m.v[v + 1] = b, s->m.v[v + 2] = vadd(b, r.t);
    s->m.v[v + 3] = vadd(r.o, r.t);
    s->m.vertices += 4;
    uint32_t e = lit_emitter(s, emitter_of_rectangle(r, s->material[material].Le));
    lit_join(s, v, v + 1, v + 2, material, e);
    lit_join(s, v, v + 2, v + 3, material, e);
}

/* With its shading normals, if it has some. */
static inline void lit_add_mesh(lit_scene *s, const mesh *from, uint16_t material)
{
    mesh *m = &s->m;
    size_t v = m->vertices, n = m->normals;
    lit_room(s, from->vertices, from->triangles);
    for (size_t i = 0; i < from->vertices; i++) m->v[m->vertices++] = from->v[i];
    if (from->n) {
        m->n = lit_grow(m->n, n, from->normals, sizeof *m->n, &s->room.n);
        for (size_t i = 0; i < from->normals; i++) m->n[m->normals++] = from->n[i];
    }
    for (size_t i = 0; i < from->triangles; i++) {
        const uint32_t *k = from->index + 3 * i;
        emitter e = emitter_of_triangle(mesh_triangle(from, i), s->material[material].Le);
        lit_join(s, v + k[0], v + k[1], v + k[2], material, lit_emitter(s, e));
        if (!from->n) continue;
        const uint32_t *of = (from->normal_index ? from->normal_index : from->index) + 3 * i;
        for (int j = 0; j < 3; j++)
            if (of[j] != mesh_none)
                s->part[m->triangles - 1].normal[j] = (uint32_t)n + of[j];
    }
}

static inline void lit_add_shape(lit_scene *s, shape x, uint16_t material)
{
    s->of_shape = lit_grow(s->of_shape, s->shapes, 1, sizeof *s->of_shape, &s->room.of_shape);
    s->shape = lit_grow(s->shape, s->shapes, 1, sizeof x, &s->room.shapes);
    s->of_shape[s->shapes] = material;
    s->shape[s->shapes++] = x;
}

/* (18.5), (18.6), as surface_on_triangle has them, but for what depends on p. */
static inline lit_face lit_face_of(triangle t)
{
    vec3 e = vsub(t.b, t.a), f = vsub(t.c, t.a);
    surface s = surface_on_triangle(t, no_shape, 0, 0);
    real LL = real_max(vdot(e, e), vdot(f, f)), L = sqrt(LL), k = surface_needle(e, f, LL);
    return (lit_face){t.a, e, f, s.n, 2 * L, s.noise, surface_margin(t.a, L, k)};
}

/* What was added triangle by triangle becomes one array for each of its fields. */
static inline void lit_split(lit_scene *s)
{
    mesh *m = &s->m;
    size_t n = m->triangles;
    m->index = allocate(n, 3 * sizeof *m->index);
    if (m->n) m->normal_index = allocate(n, 3 * sizeof *m->normal_index);
    s->of_triangle = allocate(n, sizeof *s->of_triangle);
    s->emitter_of = allocate(n + s->shapes, sizeof *s->emitter_of);
    s->face = allocate(n, sizeof *s->face);
    for (size_t i = 0; i < n; i++) {
        const lit_part *p = &s->part[i];
        memcpy(m->index + 3 * i, p->corner, sizeof p->corner);
        if (m->n) memcpy(m->normal_index + 3 * i, p->normal, sizeof p->normal);
        s->of_triangle[i] = p->material, s->emitter_of[i] = p->emitter;
        s->face[i] = lit_face_of(mesh_triangle(m, i));
    }
    free(s->part);
    s->part = NULL;
}

static inline void lit_end(lit_scene *s)
{
    bvh_options how = bvh_defaults;
    failure f;
    scene shapes = {s->shape, s->shapes};
    lit_split(s);
    for (size_t i = 0; i < s->shapes; i++) {
        bool ball = s->shape[i].kind == SHAPE_SPHERE;
        vec3 Le = s->material[s->of_shape[i]].Le;
        uint32_t e = ball ? lit_emitter(s, emitter_of_sphere(s->shape[i].sphere, Le)) : lit_dark;
        s->emitter_of[s->m.triangles + i] = e;
    }
    s->first = allocate(s->emitters, sizeof *s->first);
    s->last = allocate(s->emitters, sizeof *s->last);
    for (size_t e = 0; e < s->emitters; e++) s->first[e] = s->last[e] = -1;
    if (!bvh_mesh_build(&s->m, how, &s->tree, &f)) fail(f);
    few_build(&s->m, &s->few);
    for (size_t i = s->few.lanes ? s->m.triangles : 0; i-- > 0;) {
        uint32_t e = s->emitter_of[i];
        if (e == lit_dark) continue;
        s->first[e] = s->few.lane[i];
        if (s->last[e] < 0) s->last[e] = s->few.lane[i];
    }
    how.item_cost = 1.5;  /* a shape's test costs more than a triangle's */
    if (!bvh_shapes_build(&shapes, how, &s->shape_tree, &f)) fail(f);
}

static inline void lit_free(lit_scene *s)
{
    mesh_free(&s->m);
    bvh_mesh_free(&s->tree), bvh_shapes_free(&s->shape_tree), few_free(&s->few);
    free(s->first), free(s->last);
    free(s->of_triangle), free(s->shape), free(s->of_shape), free(s->material);
    free(s->emitter), free(s->emitter_of), free(s->face), free(s->part);
    lit_begin(s);
}

/* ---- rays ---- */

__attribute__((always_inline))
static inline surface lit_surface(const lit_scene *s, hit h)
{
    const lit_face *k = &s->face[h.shape];
    vec3 p = surface_inside(k->a, k->e, k->f, k->margin, h.u, h.v);
    real error = real_epsilon * (k->reach + 2 * surface_reach(p));
    vec3 ns = s->m.n ? mesh_normal(&s->m, h.shape, h.u, h.v) : k->n;
    return (surface){p, k->n, ns, error, k->noise, h.shape};
}

/* A ray that leaves a triangle never meets it again (18.7); nor, up to its end, the emitter. */
static inline few_skip lit_skip(const lit_scene *s, uint32_t from, uint32_t e)
{
    few_skip k = few_skip_none;
    if (s->few.lanes == 0) return k;
    if (from < few_most && from < s->m.triangles) k.other = s->few.lane[from];
    if (e < s->emitters) k.first = s->first[e], k.last = s->last[e];
    return k;
}

/* Among the triangles. */
__attribute__((always_inline))
static inline bool lit_closest(const lit_scene *s, ray r, uint32_t from, hit *h)
{
    int known = few_hit(&s->few, &s->m, r, lit_skip(s, from, lit_dark), h);
    return known >= 0 ? known : bvh_mesh_hit(&s->tree, r, h);
}

/* Fields one by one: a struct that is copied as a whole right after its fields were written waits
 * for all of them. */
__attribute__((always_inline))
static inline void lit_found(const lit_scene *s, ray r, surface x, size_t place, uint16_t material,
                             real t, lit_hit *out)
{
    real side = vdot(x.n, r.d), turn = side > 0 ? -1 : 1;
    out->s.p = x.p, out->s.n = vscale(x.n, turn), out->s.ns = vscale(x.ns, turn);
    out->s.error = x.error, out->s.noise = x.noise, out->s.shape = (uint32_t)place;
    out->m = &s->material[material], out->emitter = s->emitter_of[place];
    out->t = t, out->front = side < 0;
}

/* In a scene without shapes. */
__attribute__((always_inline))
static inline bool lit_trace_flat(const lit_scene *s, ray r, uint32_t from, lit_hit *out)
{
    hit h;
    if (!lit_closest(s, r, from, &h)) return false;
    lit_found(s, r, lit_surface(s, h), h.shape, s->of_triangle[h.shape], h.t, out);
    return true;
}

/* out->s.shape: triangle, or m.triangles + shape. */
__attribute__((always_inline))
static inline bool lit_trace_from(const lit_scene *s, ray r, uint32_t from, lit_hit *out)
{
    hit other;
    ray rest = r;
    bool met = lit_trace_flat(s, r, from, out);
    if (!s->shapes) return met;
    if (met) rest.tmax = out->t;
    if (!bvh_shapes_hit(&s->shape_tree, rest, &other) || (met && !(other.t < out->t))) return met;
    lit_found(s, r, surface_of_shape(&s->shape[other.shape], r, other),
              s->m.triangles + other.shape, s->of_shape[other.shape], other.t, out);
    return true;
}

static inline bool lit_trace(const lit_scene *s, ray r, lit_hit *out)
{
    return lit_trace_from(s, r, no_shape, out);
}

__attribute__((always_inline))
static inline bool lit_occluded_from(const lit_scene *s, ray r, uint32_t from, uint32_t e)
{
    int known = few_occluded(&s->few, &s->m, r, lit_skip(s, from, e));
    if (known < 0) known = bvh_mesh_occluded(&s->tree, r);
    return known || (s->shapes && bvh_shapes_occluded(&s->shape_tree, r));
}

static inline bool lit_occluded(const lit_scene *s, ray r)
{
    return lit_occluded_from(s, r, no_shape, lit_dark);
}

static inline vec3 lit_emitted(const lit_hit *h)
{
    return h->front && h->emitter != lit_dark ? h->m->Le : (vec3){0, 0, 0};
}

#endif
