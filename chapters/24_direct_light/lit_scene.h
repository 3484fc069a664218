/* lit_scene.h: a world (18) with lights in it: triangles and shapes, their materials, what shines.
 *
 *   lit_scene s;
 *   lit_begin(&s);
 *   uint16_t grey = lit_add_material(&s, (material){.kd = {.5, .5, .5}});
 *   lit_add_rectangle(&s, (rectangle){o, s, t}, lamp);     front: s x t; if it shines, one emitter
 *   lit_add_triangle(&s, t, grey), lit_add_mesh(&s, &m, grey), lit_add_shape(&s, shape, grey);
 *   lit_end(&s);                                           its world and tables; then use it
 *   lit_free(&s);                                          a zeroed one may be freed
 *
 *   lit_trace(&s, r, &h)      what r meets first; h.s is 18's surface, turned to where r comes from
 *   lit_occluded_from(&s, r, i, e)    is there anything? Sooner for rays that 18's leave or
 *                             leave_between made: from triangle i [no_shape: none], to emitter e
 *                             [lit_dark: none]; so is lit_trace_from(&s, r, i, &h), and still
 *                             sooner lit_trace_at(&s, &r, i, &h): r in memory, and it ends there
 *   lit_emitted(&h)           radiance towards the origin of r: ke, or 0 where h.shines is false
 *
 * All that is the same for every ray is computed once, by lit_end: edges, normals, error bounds
 * (18.5), (18.6), (18.9) of triangles, BRDFs, lights. lit_trace of a triangle is a search, then two
 * products and a sum a coordinate: the same bits as surface_of_mesh.
 *
 * Everything added is copied, but for the corners of polygons, which must outlive the scene.
 * Emitters: one per shining triangle, rectangle, sphere of area > 0: in the order of adding, then
 * the spheres. Nothing else can shine; ke of a cone or polygon is ignored. At equal t a triangle
 * wins against a shape, else the lower index. At most 65535 materials; no memory, or more: the
 * program ends.
 */
#ifndef DIRECT_LIT_SCENE_H
#define DIRECT_LIT_SCENE_H

#include "../18_shade/leave.h"
#include "../18_shade/world.h"
#include "../23_brdf/brdf.h"
#include "emitter.h"

/* A triangle, ready: p = a + u e + v f (18.9), error = epsilon (reach + 2 |p|). */
typedef struct { vec3 a, e, f, n; real reach, noise, margin; } lit_face;

/* The triangles, and the shapes: parts of the world, which point at what they are made of. */
typedef struct { mesh m; scene shapes; world_part part[2]; } lit_parts;

typedef struct {
    mesh m;                   /* triangles: owned */
    uint16_t *of_triangle;    /* [m.triangles] its material */
    shape *shape;             /* [shapes] anything of 07; of these only spheres shine */
    size_t shapes;
    uint16_t *of_shape;       /* [shapes] */
    material *material;
    brdf *f;                  /* [materials] brdf_of it: how it reflects, on both sides */
    size_t materials;
    emitter *emitter;
    size_t emitters;
    uint32_t *emitter_of;     /* [m.triangles + shapes]; lit_dark: does not shine */
    vec3 background;          /* radiance from where nothing is */
    lit_face *face;           /* [m.triangles] */
    bvh8_skip *skip;          /* [emitters] its triangles, as .first and .last; none: a sphere */
    trace_world world;        /* what is searched: triangles; shapes, if there are some */
    lit_parts *parts;         /* in a place of their own: a scene may be copied */
    struct {
        size_t v, n, index, normal_index, of_triangle, emitter_of, shapes, of_shape, materials,
            emitters;
    } room;
} lit_scene;

typedef struct {
    surface s;                /* faces the ray: s.n.d <= 0 */
    const material *m;
    const brdf *f;            /* of m */
    uint32_t emitter;         /* or lit_dark */
    real t;
    bool front;               /* n.d < 0 before it was turned */
    bool shines;              /* to where the ray comes from */
} lit_hit;

#define lit_dark UINT32_MAX

/* ---------------------------------------------------------------------------------------------- */

static inline void lit_begin(lit_scene *s) { *s = (lit_scene){.background = {0, 0, 0}}; }

static inline uint16_t lit_add_material(lit_scene *s, material m)
{
    if (s->materials >= UINT16_MAX) die(2, "more than 65535 materials");
    s->material = grown(s->material, s->materials, &s->room.materials, sizeof m);
    s->material[s->materials] = m;
    return (uint16_t)s->materials++;
}

/* The index of a new emitter of that look, or lit_dark. */
static inline uint32_t lit_emitter(lit_scene *s, uint16_t look, emitter e)
{
    e.both = s->material[look].both && e.kind != EMITTER_SPHERE;
    if (!(e.area > 0) || !isfinite(e.area) || vzero(e.Le)) return lit_dark;
    s->emitter = grown(s->emitter, s->emitters, &s->room.emitters, sizeof e);
    s->emitter[s->emitters] = e;
    return (uint32_t)s->emitters++;
}

/* Room for so many corners and triangles more. */
static inline void lit_room(lit_scene *s, size_t points, size_t n)
{
    mesh *m = &s->m;
    size_t had = m->triangles, corners = 3 * sizeof *m->index;
    m->v = grown_by(m->v, m->vertices, points, &s->room.v, sizeof *m->v);
    m->index = grown_by(m->index, had, n, &s->room.index, corners);
    m->normal_index = grown_by(m->normal_index, had, n, &s->room.normal_index, corners);
    s->of_triangle = grown_by(s->of_triangle, had, n, &s->room.of_triangle, sizeof *s->of_triangle);
    s->emitter_of = grown_by(s->emitter_of, had, n, &s->room.emitter_of, sizeof *s->emitter_of);
}

/* One triangle of corners that are in m.v already, without normals of its own. */
static inline void lit_join(lit_scene *s, size_t a, size_t b, size_t c, uint16_t look,
                            uint32_t e)
{
    size_t i = s->m.triangles++;
    uint32_t corner[3] = {(uint32_t)a, (uint32_t)b, (uint32_t)c};
    memcpy(s->m.index + 3 * i, corner, sizeof corner);
    for (size_t k = 3 * i; k < 3 * i + 3; k++) s->m.normal_index[k] = mesh_none;
    s->of_triangle[i] = look, s->emitter_of[i] = e;
}

static inline void lit_add_triangle(lit_scene *s, triangle t, uint16_t look)
{
    size_t v = s->m.vertices;
    lit_room(s, 3, 1);
    s->m.v[v] = t.a, s->m.v[v + 1] = t.b, s->m.v[v + 2] = t.c;
    s->m.vertices += 3;
    lit_join(s, v, v + 1, v + 2, look,
             lit_emitter(s, look, emitter_of_triangle(t, s->material[look].ke)));
}

static inline void lit_add_rectangle(lit_scene *s, rectangle r, uint16_t look)
{
    size_t v = s->m.vertices;
    vec3 b = vadd(r.o, r.s);
    lit_room(s, 4, 2);
    s->m.v[v] = r.o, s->m.v[v + 1] = b, s->m.v[v + 2] = vadd(b, r.t);
    s->m.v[v + 3] = vadd(r.o, r.t);
    s->m.vertices += 4;
    uint32_t e = lit_emitter(s, look, emitter_of_rectangle(r, s->material[look].ke));
    lit_join(s, v, v + 1, v + 2, look, e);
    lit_join(s, v, v + 2, v + 3, look, e);
}

/* With its shading normals, if it has some. */
static inline void lit_add_mesh(lit_scene *s, const mesh *from, uint16_t look)
{
    mesh *m = &s->m;
    size_t v = m->vertices, n = m->normals;
    lit_room(s, from->vertices, from->triangles);
    for (size_t i = 0; i < from->vertices; i++) m->v[m->vertices++] = from->v[i];
    if (from->n) {
        m->n = grown_by(m->n, n, from->normals, &s->room.n, sizeof *m->n);
        for (size_t i = 0; i < from->normals; i++) m->n[m->normals++] = from->n[i];
    }
    for (size_t i = 0; i < from->triangles; i++) {
        const uint32_t *k = from->index + 3 * i;
        emitter e = emitter_of_triangle(mesh_triangle(from, i), s->material[look].ke);
        lit_join(s, v + k[0], v + k[1], v + k[2], look, lit_emitter(s, look, e));
        if (!from->n) continue;
        const uint32_t *of = (from->normal_index ? from->normal_index : from->index) + 3 * i;
        for (int j = 0; j < 3; j++)
            if (of[j] != mesh_none)
                m->normal_index[3 * (m->triangles - 1) + (size_t)j] = (uint32_t)n + of[j];
    }
}

static inline void lit_add_shape(lit_scene *s, shape x, uint16_t look)
{
    s->of_shape = grown(s->of_shape, s->shapes, &s->room.of_shape, sizeof *s->of_shape);
    s->shape = grown(s->shape, s->shapes, &s->room.shapes, sizeof x);
    s->of_shape[s->shapes] = look;
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

static inline void lit_end(lit_scene *s)
{
    size_t n = s->m.triangles;
    s->face = allocate(n, sizeof *s->face);
    for (size_t i = 0; i < n; i++) s->face[i] = lit_face_of(mesh_triangle(&s->m, i));
    s->f = allocate(s->materials, sizeof *s->f);
    for (size_t i = 0; i < s->materials; i++) s->f[i] = brdf_of(&s->material[i]);
    s->emitter_of = grown_by(s->emitter_of, n, s->shapes, &s->room.emitter_of,
                             sizeof *s->emitter_of);
    for (size_t i = 0; i < s->shapes; i++) {
        uint16_t look = s->of_shape[i];
        vec3 ke = s->material[look].ke;
        s->emitter_of[n + i] = s->shape[i].kind != SHAPE_SPHERE ? lit_dark
            : lit_emitter(s, look, emitter_of_sphere(s->shape[i].sphere, ke));
    }
    s->skip = allocate(s->emitters, sizeof *s->skip);
    for (size_t e = 0; e < s->emitters; e++) s->skip[e] = bvh8_skip_none;
    for (uint32_t i = (uint32_t)n; i-- > 0;) {
        if (s->emitter_of[i] == lit_dark) continue;
        bvh8_skip *k = &s->skip[s->emitter_of[i]];
        k->first = i, k->last = k->last == no_shape ? i : k->last;
    }
    lit_parts *of = s->parts = allocate(1, sizeof *of);
    of->m = s->m, of->shapes = (scene){s->shape, s->shapes};
    world_part_of_mesh(&of->m, MASK_ALL, &of->part[0]);
    world_part_of_scene(&of->shapes, MASK_ALL, &of->part[1]);
    of->part[0].id = 0, of->part[1].id = 1;
    s->world = (trace_world){of->part, s->shapes ? 2 : 1};
}

static inline void lit_free(lit_scene *s)
{
    mesh_free(&s->m);
    for (int k = 0; s->parts && k < 2; k++) world_part_free(&s->parts->part[k]);
    free(s->parts), free(s->skip);
    free(s->of_triangle), free(s->shape), free(s->of_shape), free(s->material);
    free(s->f);
    free(s->emitter), free(s->emitter_of), free(s->face);
    lit_begin(s);
}

/* ---- rays ---- */

fast_inline surface lit_surface(const lit_scene *s, hit h)
{
    const lit_face *k = &s->face[h.shape];
    vec3 p = surface_inside(k->a, k->e, k->f, k->margin, h.u, h.v);
    real error = real_epsilon * (k->reach + 2 * surface_reach(p));
    vec3 ns = s->m.n ? mesh_normal(&s->m, h.shape, h.u, h.v) : k->n;
    return (surface){p, k->n, ns, error, k->noise, h.shape};
}

/* Fields one by one: a struct that is copied as a whole right after its fields were written waits
 * for all of them. */
fast_inline void lit_found(const lit_scene *s, vec3 d, surface x, size_t place, uint16_t look,
                           real t, lit_hit *out)
{
    real side = vdot(x.n, d), turn = side > 0 ? -1 : 1;
    out->s.p = x.p, out->s.n = vscale(x.n, turn), out->s.ns = vscale(x.ns, turn);
    out->s.error = x.error, out->s.noise = x.noise, out->s.shape = (uint32_t)place;
    out->m = &s->material[look], out->f = &s->f[look], out->emitter = s->emitter_of[place];
    out->t = t, out->front = side < 0;
    out->shines = out->emitter != lit_dark && (side < 0 || s->emitter[out->emitter].both);
}

/* A ray that leaves triangle `from` never meets it again (18.10): the search need not ask. */
fast_inline world_but lit_left(uint32_t from)
{
    return (world_but){0, from, 0, no_shape, no_shape};
}

/* Nor does it, up to its end, meet the emitter e that it was sent to. */
fast_inline world_but lit_left_to(const lit_scene *s, uint32_t from, uint32_t e)
{
    bvh8_skip to = e < s->emitters ? s->skip[e] : bvh8_skip_none;
    return (world_but){0, from, 0, to.first, to.last};
}

/* The search alone. */
fast_inline bool lit_find(const lit_scene *s, ray *r, uint32_t from, trace_hit *x)
{
    return world_find(&s->world, MASK_ALL, lit_left(from), r, x);
}

/* What was found. out->s.shape: triangle, or m.triangles + shape. */
fast_inline void lit_hit_of(const lit_scene *s, const ray *r, const trace_hit *x, lit_hit *out)
{
    uint32_t k = x->h.shape;
    if (x->part == 0)
        lit_found(s, r->d, lit_surface(s, x->h), k, s->of_triangle[k], x->h.t, out);
    else lit_found(s, r->d, surface_of_shape(&s->shape[k], *r, x->h), s->m.triangles + k,
                   s->of_shape[k], x->h.t, out);
}

fast_inline bool lit_trace_at(const lit_scene *s, ray *r, uint32_t from, lit_hit *out)
{
    trace_hit x;
    if (!lit_find(s, r, from, &x)) return false;
    lit_hit_of(s, r, &x, out);
    return true;
}

static inline bool lit_trace_from(const lit_scene *s, ray r, uint32_t from, lit_hit *out)
{
    ray own = {{r.o.x, r.o.y, r.o.z}, r.tmin, {r.d.x, r.d.y, r.d.z}, r.tmax};
    return lit_trace_at(s, &own, from, out);
}

static inline bool lit_trace(const lit_scene *s, ray r, lit_hit *out)
{
    return lit_trace_from(s, r, no_shape, out);
}

static inline bool lit_occluded_from(const lit_scene *s, ray r, uint32_t from, uint32_t e)
{
    ray own = {{r.o.x, r.o.y, r.o.z}, r.tmin, {r.d.x, r.d.y, r.d.z}, r.tmax};
    return world_find(&s->world, MASK_ALL, lit_left_to(s, from, e), &own, NULL);
}

static inline vec3 lit_emitted(const lit_hit *h)
{
    return h->shines ? h->m->ke : (vec3){0, 0, 0};
}

#endif
