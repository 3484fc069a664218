/* measure.h: the strategies on one mesh: time, memory, work, wrong hits; and what overlap costs. */
#ifndef BVH_MEASURE_H
#define BVH_MEASURE_H

#include "../../../common/lab/report.h"
#include "../../07_mesh/closest.h"
#include "../../07_mesh/scenes/teapot.h"
#include "../../09_aabb/trials/first_row.h"
#include "../first.h"
#include "../stats.h"
#include "survey.h"

typedef struct { const char *name; bvh_options options; bool naive; } candidate;

enum { candidates = 11 };
static const candidate candidate_list[candidates] = {
    {"cycling axis", {BVH_CYCLE, 4, 1}, false}, {"longest axis", {BVH_LONGEST, 4, 1}, false},
    {"median", {BVH_MEDIAN, 4, 1}, false}, {"SAH, bins", {BVH_SAH, 1, 1}, false},
    {"SAH, bins", {BVH_SAH, 4, 0.3}, false}, {"SAH, bins", {BVH_SAH, 8, 0.3}, false},
    {"SAH, bins", {BVH_SAH, 16, 0.1}, false}, {"SAH, sweep", {BVH_SAH_SWEEP, 8, 0.3}, false},
    {"SAH, boxes naive", {BVH_SAH, 8, 0.3}, true}, {"SAH, spatial", {BVH_SPATIAL, 8, 0.3}, false},
    {"Morton", {BVH_MORTON, 8, 0.3}, false}};

/* What the surveys share: the mesh, rays at it, and the hits of brute force for some of them. */
typedef struct {
    mesh m;
    view v;
    ray_set primary, diffuse, corners;
    hit *brute;                /* of `corners` */
    double brute_seconds;      /* a ray */
} subject;

static inline subject subject_of(mesh m, int width, int height, size_t corners, uint64_t seed);
static inline void subject_free(subject *s);
static inline void table_of_strategies(const options *o, const subject *s);
static inline void table_of_overlap(const options *o, const subject *s);

/* ---------------------------------------------------------------------------------------------- */

static inline subject subject_of(mesh m, int width, int height, size_t corners, uint64_t seed)
{
    subject s = {.m = m};
    vec3 lo, hi;
    bvh b;
    mesh_bounds(&m, &lo, &hi);
    s.v = view_of(lo, hi, true, (real)width / (real)height);
    s.primary = rays_primary(s.v, width, height);
    bvh_build(&m, bvh_defaults, &b);
    s.diffuse = rays_on(&b, &m, &s.primary, seed);
    bvh_free(&b);
    s.corners = rays_corners(&m, s.v.camera.e, corners, seed);
    s.brute = allocate(corners, sizeof *s.brute);
    double start = clock_seconds();
    for (size_t i = 0; i < corners; i++)
        if (!mesh_hit(&m, s.corners.r[i], &s.brute[i])) s.brute[i] = hit_none;
    s.brute_seconds = (clock_seconds() - start) / (double)(corners ? corners : 1);
    return s;
}

static inline void subject_free(subject *s)
{
    rays_free(&s->primary), rays_free(&s->diffuse), rays_free(&s->corners);
    mesh_free(&s->m);
    free(s->brute);
    s->brute = NULL;
}

typedef struct { const subject *s; const candidate *c; const ray_set *rays; bvh b; } trial;

static inline double run_build(void *context)
{
    trial *t = context;
    bvh_free(&t->b);
    bvh_build(&t->s->m, t->c->options, &t->b);
    return (double)t->b.tree.nodes;
}

static inline double run_search(void *context)
{
    const trial *t = context;
    size_t hits = 0;
    hit h;
    if (t->c->naive)
        for (size_t i = 0; i < t->rays->n; i++) hits += bvh_hit_naive(&t->b, t->rays->r[i], &h);
    else
        for (size_t i = 0; i < t->rays->n; i++) hits += bvh_hit(&t->b, t->rays->r[i], &h);
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

/* Seconds of one run that nothing has warmed up. For building: its memory is new each time. */
static inline double time_once(trial *t, double (*run)(void *))
{
    double start = clock_seconds();
    clock_kept = run(t);
    return clock_seconds() - start;
}

static inline double per(double x, size_t n) { return n ? x / (double)n : 0; }

static inline bool first_bvh_search(const void *b, ray r, hit *out)
{
    return first_bvh_hit(b, r, out);
}

static inline void first_strategy_row(table *out, const subject *s, bool sah, int rounds)
{
    first_mesh f = first_mesh_of(&s->m);
    double start = clock_seconds(), rays = (double)(s->primary.n + s->diffuse.n);
    first_bvh b = first_bvh_build(&f, sah);
    double build = clock_seconds() - start;
    table_text(out, sah ? "first, SAH" : "first, middle"), table_count(out, first_bvh_leaf);
    table_number(out, build * 1e3);
    for (int k = 0; k < 4; k++) table_text(out, "-");
    double seconds = first_cells(out, (first_search){&b, first_bvh_search}, &s->primary,
                                 &s->diffuse, &s->corners, s->brute, rounds);
    table_number(out, rays / seconds * 1e-6);
    first_bvh_free(&b), first_mesh_free(&f);
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
        title, "structure|leaf|time build [ms]|memory [B/tri]|peak [B/tri]|depth|nodes/ray|"
               "tests/ray|error [wrong]|time primary [ns]|time diffuse [ns]|Mrays/s");
    for (int i = 0; i < candidates; i++)
        t[i] = (trial){s, &candidate_list[i], &s->primary, {{0}, NULL}};
    time_trials(t, candidates, run_build, o->quick ? 1 : 3, build);
    time_trials(t, candidates, run_search, o->quick ? 1 : 5, primary);
    for (int i = 0; i < candidates; i++) t[i].rays = &s->diffuse;
    time_trials(t, candidates, run_search, o->quick ? 1 : 5, diffuse);
    for (int sah = 0; sah < 2; sah++) first_strategy_row(&out, s, sah != 0, o->quick ? 1 : 5);
    for (int i = 0; i < candidates; i++) {
        bvh_stats st = bvh_stats_of(&t[i].b.tree);
        bvh_work p = rays_count(&t[i].b, &s->primary), d = rays_count(&t[i].b, &s->diffuse);
        size_t rays = s->primary.n + s->diffuse.n;
        table_text(&out, "%s", t[i].c->name), table_count(&out, (size_t)t[i].c->options.leaf);
        table_number(&out, build[i] * 1e3);
        table_number(&out, per((double)st.bytes, st.items));
        table_number(&out, per((double)st.peak, st.items));
        table_count(&out, (size_t)st.depth);
        table_number(&out, per((double)(p.nodes + d.nodes), rays));
        table_number(&out, per((double)(p.tests + d.tests), rays));
        table_count(&out, rays_wrong(&t[i].b, &s->corners, s->brute, t[i].c->naive));
        table_number(&out, per(primary[i] * 1e9, s->primary.n));
        table_number(&out, per(diffuse[i] * 1e9, s->diffuse.n));
        table_number(&out, (double)rays / (primary[i] + diffuse[i]) * 1e-6);
        bvh_free(&t[i].b);
    }
    table_text(&out, "brute force");
    for (int k = 0; k < 5; k++) table_text(&out, "-");
    table_number(&out, 0);
    table_number(&out, (double)s->m.triangles), table_count(&out, 0);
    table_number(&out, s->brute_seconds * 1e9), table_number(&out, s->brute_seconds * 1e9);
    table_number(&out, 1e-6 / s->brute_seconds);
    output_table(o, &out);
}

/* The same trees, by the formulas and by counting. */
static inline void table_of_overlap(const options *o, const subject *s)
{
    static const int shown[5] = {0, 1, 2, 5, 7};
    table out = table_new(
        "Overlap: random lines through the box of the mesh, and diffuse rays",
        "structure|nodes (14.7)|nodes, lines|tests (14.7)|tests, lines|in both (14.8)|"
        "both, rays [%]|barren leaves, rays [%]");
    for (int i = 0; i < 5; i++) {
        bvh b;
        bvh_build(&s->m, candidate_list[shown[i]].options, &b);
        bvh_stats st = bvh_stats_of(&b.tree);
        ray_set lines = rays_lines(&b, o->quick ? 2000 : 50000, o->seed);
        bvh_work w = {0, 0, 0, 0, 0}, d = rays_count(&b, &s->diffuse);
        for (size_t k = 0; k < lines.n; k++) tree_pierced(&b.tree, lines.r[k], &w);
        table_text(&out, "%s", candidate_list[shown[i]].name);
        table_number(&out, st.nodes), table_number(&out, per((double)w.nodes, lines.n));
        table_number(&out, st.tests), table_number(&out, per((double)w.tests, lines.n));
        table_number(&out, st.overlap);
        table_number(&out, 100 * per((double)d.both, d.nodes));
        table_number(&out, 100 * per((double)d.barren, d.leaves));
        rays_free(&lines);
        bvh_free(&b);
    }
    output_extra_table(o, &out);
}

#endif
