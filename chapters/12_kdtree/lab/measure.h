/* measure.h: the strategies on one mesh: time, memory, work, wrong hits. */
#ifndef KDTREE_MEASURE_H
#define KDTREE_MEASURE_H

#include "../../../common/lab/report.h"
#include "../../07_mesh/scenes/teapot.h"
#include "../../09_aabb/trials/first_row.h"
#include "../first.h"
#include "textbook.h"

typedef bool kd_searcher(const kdtree *t, ray r, hit *out);
typedef struct { const char *name; kdtree_options options; kd_searcher *search; } candidate;

#define KD_HOW(strategy, bonus, clip, planar) \
    {strategy, 4, 0, 1, kdtree_item_cost, bonus, clip, planar, SIZE_MAX / 4}

enum { candidates = 10, structures = 6 };  /* the first six are trees, the others other searches */
static const candidate candidate_list[candidates] = {
    {"middle", KD_HOW(KD_MIDDLE, 0, true, KD_THICK), kdtree_hit},
    {"median", KD_HOW(KD_MEDIAN, 0, true, KD_THICK), kdtree_hit},
    {"SAH, boxes", KD_HOW(KD_SAH, 0, false, KD_THICK), kdtree_hit},
    {"SAH, clipped", KD_HOW(KD_SAH, 0, true, KD_THICK), kdtree_hit},
    {"SAH, bonus 0.1", KD_HOW(KD_SAH, 0.1, true, KD_THICK), kdtree_hit},
    {"SAH, bonus 0.5", KD_HOW(KD_SAH, 0.5, true, KD_THICK), kdtree_hit},
    {"textbook search", KD_HOW(KD_SAH, 0.1, true, KD_BOTH), kdtree_hit_textbook},
    {"naive: first hit final", KD_HOW(KD_SAH, 0.1, true, KD_BOTH), kdtree_hit_naive_final},
    {"naive: strict", KD_HOW(KD_SAH, 0.1, true, KD_BOTH), kdtree_hit_naive_strict},
    {"naive: strict, one side", KD_HOW(KD_SAH, 0.1, true, KD_ONE), kdtree_hit_naive_strict}};

/* What the surveys share: the mesh, rays at it, and the hits of brute force for some of them. */
typedef struct {
    mesh m;
    items x;
    camera v;
    ray_set primary, diffuse, corners;
    hit *brute;                /* of `corners` */
    double brute_seconds;      /* a ray */
} subject;

static inline void subject_init(subject *s, mesh m, camera v, int width, size_t corners,
                                uint64_t seed);
static inline void subject_free(subject *s);
static inline void table_of_strategies(const options *o, const subject *s);

/* ---------------------------------------------------------------------------------------------- */

static inline void build_or_fail(const items *x, kdtree_options how, kdtree *t)
{
    failure f;
    if (!kdtree_build(x, how, t, &f)) fail(f);
}

static inline camera view_of_mesh(const mesh *m, real aspect)
{
    vec3 lo, hi;
    mesh_bounds(m, &lo, &hi);
    return camera_of(lo, hi, true, aspect);
}

static inline void subject_init(subject *s, mesh m, camera v, int width, size_t corners,
                                uint64_t seed)
{
    kdtree t;
    *s = (subject){.m = m, .v = v, .primary = rays_primary(v, width, width * 5 / 8)};
    s->x = items_of_mesh(&s->m);
    build_or_fail(&s->x, kdtree_defaults, &t);
    hit *h = allocate(s->primary.n, sizeof *h);
    for (size_t i = 0; i < s->primary.n; i++)
        if (!kdtree_hit(&t, s->primary.r[i], &h[i])) h[i] = hit_none;
    s->diffuse = rays_diffuse(&s->m, &s->primary, h, seed);
    free(h);
    kdtree_free(&t);
    s->corners = rays_corners(&s->m, v.e, corners, seed);
    s->brute = allocate(corners, sizeof *s->brute);
    double start = clock_seconds();
    for (size_t i = 0; i < corners; i++)
        if (!mesh_hit(&s->m, s->corners.r[i], &s->brute[i])) s->brute[i] = hit_none;
    s->brute_seconds = (clock_seconds() - start) / (double)(corners ? corners : 1);
}

static inline void subject_free(subject *s)
{
    rays_free(&s->primary), rays_free(&s->diffuse), rays_free(&s->corners);
    mesh_free(&s->m);
    free(s->brute);
    s->brute = NULL;
}

static inline bool hits_equal(hit a, hit b)
{
    return a.t == b.t && a.u == b.u && a.v == b.v && a.shape == b.shape;
}

static inline size_t rays_wrong(const kdtree *t, kd_searcher *search, const ray_set *s,
                                const hit *brute)
{
    size_t wrong = 0;
    for (size_t i = 0; i < s->n; i++) {
        hit h = hit_none;
        search(t, s->r[i], &h);
        wrong += !hits_equal(h, brute[i]);
    }
    return wrong;
}

static inline search_work rays_count(const kdtree *t, const ray_set *s)
{
    search_work w = {0, 0, 0, 0};
    hit h;
    for (size_t i = 0; i < s->n; i++) kdtree_hit_counted(t, s->r[i], &h, &w);
    return w;
}

typedef struct { const subject *s; const candidate *c; const ray_set *rays; kdtree t; } trial;

static inline double run_build(void *context)
{
    trial *t = context;
    kdtree_free(&t->t);
    build_or_fail(&t->s->x, t->c->options, &t->t);
    return (double)t->t.nodes;
}

static inline double run_search(void *context)
{
    const trial *t = context;
    size_t hits = 0;
    hit h;
    if (t->c->search == kdtree_hit)  /* known here, so that it is no call */
        for (size_t i = 0; i < t->rays->n; i++) hits += kdtree_hit(&t->t, t->rays->r[i], &h);
    else
        for (size_t i = 0; i < t->rays->n; i++) hits += t->c->search(&t->t, t->rays->r[i], &h);
    return (double)hits;
}

/* Median seconds of each trial, taken in turn. */
static inline void time_trials(trial *t, int n, double (*run)(void *), int rounds, double *seconds)
{
    clock_variant v[16];
    for (int i = 0; i < n; i++) v[i] = (clock_variant){t[i].c->name, run, &t[i], 0};
    clock_compare(v, n, rounds);
    for (int i = 0; i < n; i++) seconds[i] = v[i].seconds;
}

static inline double per(double x, size_t n) { return n ? x / (double)n : 0; }

/* Work of the padded search. The textbook's rows have it too: it is their tree that is measured. */
static inline void row_of_work(table *out, const kdtree *t, search_work w, size_t rays)
{
    structure_stats st = kdtree_stats(t);
    table_count(out, (size_t)st.depth);
    table_number(out, per((double)st.references, st.items));
    table_number(out, 100 * per((double)st.empty, st.leaves));
    table_number(out, per((double)w.nodes, rays)), table_number(out, per((double)w.leaves, rays));
    table_number(out, per((double)w.tests, rays));
}

static inline void row_of_brute(table *out, const subject *s)
{
    table_text(out, "brute force");
    for (int k = 0; k < 8; k++) table_text(out, "-");
    table_number(out, (double)s->m.triangles), table_count(out, 0);
    table_number(out, s->brute_seconds * 1e9), table_number(out, s->brute_seconds * 1e9);
}

static inline bool first_kdtree_search(const void *t, ray r, hit *out)
{
    return first_kdtree_hit(t, r, out);
}

static inline void row_of_first(table *out, const subject *s, int rounds)
{
    first_kdtree t;
    first_mesh f = first_mesh_of(&s->m);
    double start = clock_seconds();
    first_kdtree_build(&f, &t);
    double build = clock_seconds() - start;
    table_text(out, "first"), table_number(out, build * 1e3);
    for (int k = 0; k < 7; k++) table_text(out, "-");
    first_cells(out, (first_search){&t, first_kdtree_search}, &s->primary, &s->diffuse,
                &s->corners, s->brute, rounds);
    first_kdtree_free(&t), first_mesh_free(&f);
}

static inline void table_of_strategies(const options *o, const subject *s)
{
    trial t[candidates];
    double build[candidates], primary[candidates], diffuse[candidates];
    char title[160];
    snprintf(title, sizeof title,
             "%zu triangles: %zu primary and %zu diffuse rays, one thread; wrong of %zu at corners",
             s->m.triangles, s->primary.n, s->diffuse.n, s->corners.n);
    table out = table_new(
        title, "structure|time build [ms]|memory [B/tri]|peak [B/tri]|depth|references/tri|"
               "empty leaves [%]|nodes/ray|leaves/ray|tests/ray|error [wrong]|time primary [ns]|"
               "time diffuse [ns]");
    for (int i = 0; i < candidates; i++)
        t[i] = (trial){s, &candidate_list[i], &s->primary, {0}};
    for (int i = 0; i < candidates; i++) {
        bool again = i > structures && i + 1 < candidates;  /* the tree of the row before */
        double start = clock_seconds();
        if (again) t[i].t = t[i - 1].t, build[i] = build[i - 1];
        else run_build(&t[i]), build[i] = clock_seconds() - start;
    }
    time_trials(t, candidates, run_search, o->quick ? 1 : 3, primary);
    for (int i = 0; i < candidates; i++) t[i].rays = &s->diffuse;
    time_trials(t, candidates, run_search, o->quick ? 1 : 3, diffuse);
    row_of_first(&out, s, o->quick ? 1 : 3);
    for (int i = 0; i < candidates; i++) {
        search_work w = rays_count(&t[i].t, &s->primary), d = rays_count(&t[i].t, &s->diffuse);
        w.nodes += d.nodes, w.leaves += d.leaves, w.tests += d.tests;
        table_text(&out, "%s", t[i].c->name), table_number(&out, build[i] * 1e3);
        table_number(&out, per((double)t[i].t.bytes, t[i].t.items));
        table_number(&out, per((double)t[i].t.peak, t[i].t.items));
        row_of_work(&out, &t[i].t, w, s->primary.n + s->diffuse.n);
        table_count(&out, rays_wrong(&t[i].t, t[i].c->search, &s->corners, s->brute));
        table_number(&out, per(primary[i] * 1e9, s->primary.n));
        table_number(&out, per(diffuse[i] * 1e9, s->diffuse.n));
        if (i < structures || i + 2 >= candidates) kdtree_free(&t[i].t);
    }
    row_of_brute(&out, s);
    output_table(o, &out);
}

#endif
