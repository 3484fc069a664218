/* measure.h: what each knob costs: time, memory, work, wrong hits; and which rays find them.
 *
 *   table_of_knobs(o, m)      the main table; frees m
 *   table_of_faults(o)        wrong hits by kind of ray, on a mesh whose corners lie on the walls
 */
#ifndef OCTREE_MEASURE_H
#define OCTREE_MEASURE_H

#include "../../../common/lab/report.h"
#include "../../07_mesh/scenes/specimens.h"
#include "../../07_mesh/scenes/teapot.h"
#include "../../09_aabb/trials/first_row.h"
#include "../first.h"
#include "../octree.h"
#include "variants.h"

static inline void table_of_knobs(const options *o, mesh m);
static inline void table_of_faults(const options *o);

/* ---------------------------------------------------------------------------------------------- */

typedef bool octree_search(const octree *t, ray r, hit *out);
typedef struct {
    const char *name;
    octree_search *hit;
    octree_options how;
} octree_candidate;

typedef struct { octree t; octree_search *hit; const ray_set *rays; } octree_trial;

static inline double octree_run(void *context)
{
    const octree_trial *t = context;
    size_t hits = 0;
    hit h;
    for (size_t i = 0; i < t->rays->n; i++) hits += t->hit(&t->t, t->rays->r[i], &h);
    return (double)hits;
}

static inline double octree_per(double x, size_t n) { return n ? x / (double)n : 0; }

static inline search_work octree_count(const octree *t, const ray_set *s)
{
    search_work w = {0, 0, 0, 0};
    hit h;
    for (size_t i = 0; i < s->n; i++) octree_hit_counted(t, s->r[i], &h, &w);
    return w;
}

/* Diffuse rays from the hits of the rays s. */
static inline ray_set octree_rays_on(const octree *t, const mesh *m, const ray_set *s,
                                     uint64_t seed)
{
    hit *h = allocate(s->n, sizeof *h);
    for (size_t i = 0; i < s->n; i++)
        if (!octree_hit(t, s->r[i], &h[i])) h[i] = hit_none;
    ray_set d = rays_diffuse(m, s, h, seed);
    free(h);
    return d;
}

static inline size_t octree_wrong(const octree *t, octree_search *search, const ray_set *s,
                                  const hit *brute)
{
    size_t wrong = 0;
    for (size_t i = 0; i < s->n; i++) {
        hit h = hit_none;
        search(t, s->r[i], &h);
        wrong += h.t != brute[i].t || h.shape != brute[i].shape || h.u != brute[i].u
                 || h.v != brute[i].v;
    }
    return wrong;
}

static inline hit *octree_brute(const items *x, const ray_set *s)
{
    hit *h = allocate(s->n, sizeof *h);
    for (size_t i = 0; i < s->n; i++)
        if (!items_hit(x, s->r[i], &h[i])) h[i] = hit_none;
    return h;
}

/* Half at corners from the eye, half along the axes through corners. */
static inline ray_set octree_hard_rays(const mesh *m, vec3 eye, real far, size_t n, uint64_t seed)
{
    ray_set s = rays_corners(m, eye, n, seed);
    for (size_t i = 0; i < n; i += 2) {
        vec3 at = ray_at(s.r[i], 1), axis = {0, 0, 0};
        ((real *)&axis)[i / 2 % 3] = i / 6 % 2 ? 1 : -1;
        s.r[i] = ray_from(vmadd(at, axis, -far), axis);
    }
    return s;
}

static inline bool first_octree_search(const void *t, ray r, hit *out)
{
    return first_octree_hit(t, r, out);
}

static inline void first_octree_row(table *out, const mesh *m, const ray_set *primary,
                                    const ray_set *diffuse, const ray_set *hard,
                                    const hit *brute, int rounds)
{
    first_octree t;
    first_mesh f = first_mesh_of(m);
    double start = clock_seconds();
    first_octree_build(&f, &t);
    double build = clock_seconds() - start;
    table_text(out, "first"), table_count(out, first_octree_leaf), table_text(out, "-");
    table_number(out, build * 1e3);
    for (int k = 0; k < 5; k++) table_text(out, "-");
    first_cells(out, (first_search){&t, first_octree_search}, primary, diffuse, hard, brute,
                rounds);
    first_octree_free(&t), first_mesh_free(&f);
}

static inline void table_of_knobs(const options *o, mesh m)
{
    enum { n = 16 };
    const size_t most = (size_t)1 << 30;
    const octree_candidate c[n] = {
        {"textbook", octree_hit_textbook, {16, 16, true, true, most}},
        {"no delta", octree_hit_unpadded, {16, 16, true, true, most}},
        {"slab tests", octree_hit_slabs, {16, 16, true, true, most}},
        {"octree", octree_hit, {16, 16, true, true, most}},
        {"no mailbox", octree_hit, {16, 16, false, true, most}},
        {"by boxes", octree_hit, {16, 16, true, false, most}},
        {"leaf 1", octree_hit, {1, 16, true, true, most}},
        {"leaf 4", octree_hit, {4, 16, true, true, most}},
        {"leaf 8", octree_hit, {8, 16, true, true, most}},
        {"leaf 32", octree_hit, {32, 16, true, true, most}},
        {"leaf 64", octree_hit, {64, 16, true, true, most}},
        {"depth 4", octree_hit, {16, 4, true, true, most}},
        {"depth 6", octree_hit, {16, 6, true, true, most}},
        {"depth 8", octree_hit, {16, 8, true, true, most}},
        {"depth 10", octree_hit, {16, 10, true, true, most}},
        {"depth 12", octree_hit, {16, 12, true, true, most}}};
    octree_trial t[n];
    clock_variant v[n];
    double build[n], primary[n];
    failure f;
    vec3 lo, hi;
    items x = items_of_mesh(&m);
    mesh_bounds(&m, &lo, &hi);
    int width = o->quick ? 40 : 160;
    camera look = camera_of(lo, hi, true, 1.6);
    ray_set p = rays_primary(look, width, width * 5 / 8);
    ray_set hard = octree_hard_rays(&m, look.e, 2 * vlength(vsub(hi, lo)), o->quick ? 60 : 1000,
                                    o->seed);
    double start = clock_seconds();
    hit *brute = octree_brute(&x, &hard);
    double brute_seconds = (clock_seconds() - start) / (double)hard.n;
    for (int i = 0; i < n; i++) {
        start = clock_seconds();
        t[i] = (octree_trial){.hit = c[i].hit, .rays = &p};
        if (!octree_build(&x, c[i].how, &t[i].t, &f)) fail(f);
        build[i] = clock_seconds() - start;
        v[i] = (clock_variant){c[i].name, octree_run, &t[i], 0};
    }
    ray_set d = octree_rays_on(&t[3].t, &m, &p, o->seed);
    clock_compare(v, n, o->quick ? 1 : 9);
    for (int i = 0; i < n; i++) primary[i] = v[i].seconds, t[i].rays = &d;
    clock_compare(v, n, o->quick ? 1 : 9);

    char title[160];
    snprintf(title, sizeof title, "%zu triangles: %zu primary and %zu diffuse rays, one thread; "
             "wrong of %zu at corners and along axes", m.triangles, p.n, d.n, hard.n);
    table out = table_new(title, "structure|leaf|depth|time build [ms]|memory [B/item]|"
                          "peak [B/item]|refs/item|nodes/ray|leaves/ray|tests/ray|error [wrong]|"
                          "time primary [ns]|time diffuse [ns]");
    first_octree_row(&out, &m, &p, &d, &hard, brute, o->quick ? 1 : 9);
    for (int i = 0; i < n; i++) {
        structure_stats s = octree_stats(&t[i].t);
        search_work w = octree_count(&t[i].t, &p), e = octree_count(&t[i].t, &d);
        bool counted = c[i].hit == octree_hit;
        size_t rays = p.n + d.n;
        table_text(&out, "%s", c[i].name), table_count(&out, (size_t)c[i].how.leaf);
        table_count(&out, (size_t)s.depth), table_number(&out, build[i] * 1e3);
        table_number(&out, octree_per((double)s.bytes, s.items));
        table_number(&out, octree_per((double)s.peak, s.items));
        table_number(&out, octree_per((double)s.references, s.items));
        if (!counted) table_text(&out, "-"), table_text(&out, "-"), table_text(&out, "-");
        else {
            table_number(&out, octree_per((double)(w.nodes + e.nodes), rays));
            table_number(&out, octree_per((double)(w.leaves + e.leaves), rays));
            table_number(&out, octree_per((double)(w.tests + e.tests), rays));
        }
        table_count(&out, octree_wrong(&t[i].t, c[i].hit, &hard, brute));
        table_number(&out, octree_per(primary[i] * 1e9, p.n));
        table_number(&out, octree_per(v[i].seconds * 1e9, d.n));
        octree_free(&t[i].t);
    }
    table_text(&out, "brute force");
    for (int k = 0; k < 8; k++) table_text(&out, "-");
    table_number(&out, (double)m.triangles), table_count(&out, 0);
    table_number(&out, brute_seconds * 1e9), table_number(&out, brute_seconds * 1e9);
    output_table(o, &out);
    free(brute);
    rays_free(&p), rays_free(&d), rays_free(&hard);
    mesh_free(&m);
}

/* ---------------------------------------------------------------------------------------------- */

/* n small triangles anywhere in a cube of side 2, `size` [scene units] or less. */
static inline mesh octree_soup(size_t n, real size, uint64_t seed)
{
    mesh m = {.vertices = 3 * n, .triangles = n};
    m.v = allocate(m.vertices, sizeof *m.v);
    m.index = allocate(m.vertices, sizeof *m.index);
    for (size_t i = 0; i < 3 * n; i++) {
        random_stream g = random_start(seed, i / 3, 0), h = random_start(seed, i, 1);
        vec3 p = {2 * random_next(&g), 2 * random_next(&g), 2 * random_next(&g)};
        m.v[i] = vadd(p, vscale((vec3){random_next(&h), random_next(&h), random_next(&h)}, size));
        m.index[i] = (uint32_t)i;
    }
    return m;
}

enum { fault_kinds = 5 };

/* Kinds: anywhere, at corners, corner to corner, along axes through corners, ... between them. */
static inline ray_set fault_rays(const mesh *m, int kind, size_t n, uint64_t seed)
{
    ray_set s = {allocate(n, sizeof(ray)), n};
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(seed, i, (uint64_t)kind);
        vec3 a = m->v[random_next_bits(&g) % m->vertices];
        vec3 b = m->v[random_next_bits(&g) % m->vertices];
        vec3 o = diffuse_direction((vec3){0, 0, 0}, &g), axis = {0, 0, 0};
        ((real *)&axis)[i % 3] = i & 1 ? 1 : -1;
        o = vscale(o, 3);
        vec3 inside = {random_next(&g) - (real)0.5, random_next(&g) - (real)0.5,
                       random_next(&g) - (real)0.5};
        if (kind == 0) s.r[i] = ray_from(o, vsub(inside, o));
        if (kind == 1) s.r[i] = ray_from(o, vsub(a, o));
        if (kind == 2) s.r[i] = ray_from(vadd(a, vscale(vsub(a, b), 3)), vsub(b, a));
        if (kind == 3) s.r[i] = ray_from(vmadd(a, axis, -4), axis);
        if (kind == 4) s.r[i] = ray_from(vmadd(inside, axis, -4), axis);
    }
    return s;
}

static inline void table_of_faults(const options *o)
{
    static const struct { const char *name; octree_search *hit; } way[4] = {
        {"textbook", octree_hit_textbook}, {"no delta", octree_hit_unpadded},
        {"slab tests", octree_hit_slabs}, {"octree_hit", octree_hit}};
    static const int kind[fault_kinds + 1] = {0, 0, 1, 2, 4, 3};
    const octree_options how = {4, 6, true, true, (size_t)1 << 26};
    size_t n = o->quick ? 200 : 2000;
    mesh m[2] = {octree_soup(500, 1, 3), octahedron_mesh(8)};
    items x[2] = {items_of_mesh(&m[0]), items_of_mesh(&m[1])};
    octree t[2];
    failure f;
    char title[120];
    snprintf(title, sizeof title, "Wrong hits of %zu rays each; octahedron of 512 triangles with "
             "corners on the walls", n);
    table out = table_new(title, "search|soup, anywhere|anywhere|at corners|corner to corner|"
                          "along axes|... through corners");
    for (int k = 0; k < 2; k++)
        if (!octree_build(&x[k], how, &t[k], &f)) fail(f);
    for (int i = 0; i < 4; i++) {
        table_text(&out, "%s", way[i].name);
        for (int k = 0; k <= fault_kinds; k++) {
            ray_set s = fault_rays(&m[k > 0], kind[k], n, o->seed);
            hit *brute = octree_brute(&x[k > 0], &s);
            table_count(&out, octree_wrong(&t[k > 0], way[i].hit, &s, brute));
            free(brute);
            rays_free(&s);
        }
    }
    output_extra_table(o, &out);
    for (int k = 0; k < 2; k++) octree_free(&t[k]), mesh_free(&m[k]);
}

#endif
