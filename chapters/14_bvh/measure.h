/* measure.h: the tables and plots of this chapter. */
#ifndef BVH_MEASURE_H
#define BVH_MEASURE_H

#include "../../common/output.h"
#include "../07_mesh/closest.h"
#include "../07_mesh/teapot.h"
#include "stats.h"
#include "survey.h"

typedef struct { const char *name; bvh_options options; bool naive; } candidate;

enum { candidates = 9 };
static const candidate candidate_list[candidates] = {
    {"cycling axis", {BVH_CYCLE, 4, 1}, false}, {"longest axis", {BVH_LONGEST, 4, 1}, false},
    {"median", {BVH_MEDIAN, 4, 1}, false}, {"SAH, bins", {BVH_SAH, 1, 1}, false},
    {"SAH, bins", {BVH_SAH, 4, 0.3}, false}, {"SAH, bins", {BVH_SAH, 8, 0.3}, false},
    {"SAH, bins", {BVH_SAH, 16, 0.1}, false}, {"SAH, sweep", {BVH_SAH_SWEEP, 8, 0.3}, false},
    {"SAH, boxes naive", {BVH_SAH, 8, 0.3}, true}};

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
static inline void table_of_stadium(const options *o);
static inline void plot_of_leaves(const options *o, const subject *s);
static inline void growth(const options *o, bool full);

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
    s.diffuse = rays_diffuse(&b, &m, &s.primary, seed);
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

static inline double per(double x, size_t n) { return n ? x / (double)n : 0; }

static inline void table_of_strategies(const options *o, const subject *s)
{
    trial t[candidates];
    double build[candidates], primary[candidates], diffuse[candidates];
    char title[160];
    snprintf(title, sizeof title, "%zu triangles: %zu primary and %zu diffuse rays, one thread; wrong "
             "of %zu rays at corners", s->m.triangles, s->primary.n, s->diffuse.n, s->corners.n);
    table out = table_new(title, "structure|leaf|time build [ms]|memory [B/tri]|peak [B/tri]|depth|nodes/ray|"
                                 "tests/ray|error [wrong]|time primary [ns]|time diffuse [ns]|Mrays/s");
    for (int i = 0; i < candidates; i++)
        t[i] = (trial){s, &candidate_list[i], &s->primary, {{0}, NULL, NULL}};
    time_trials(t, candidates, run_build, o->quick ? 1 : 3, build);
    time_trials(t, candidates, run_search, o->quick ? 1 : 5, primary);
    for (int i = 0; i < candidates; i++) t[i].rays = &s->diffuse;
    time_trials(t, candidates, run_search, o->quick ? 1 : 5, diffuse);
    for (int i = 0; i < candidates; i++) {
        bvh_stats st = bvh_stats_of(&t[i].b.tree);
        bvh_work p = rays_count(&t[i].b, &s->primary), d = rays_count(&t[i].b, &s->diffuse);
        size_t rays = s->primary.n + s->diffuse.n;
        table_text(&out, "%s", t[i].c->name), table_count(&out, (size_t)t[i].c->options.leaf);
        table_number(&out, build[i] * 1e3);
        table_number(&out, per((double)st.bytes, st.items)), table_number(&out, per((double)st.peak, st.items));
        table_count(&out, (size_t)st.depth);
        table_number(&out, per((double)(p.nodes + d.nodes), rays));
        table_number(&out, per((double)(p.tests + d.tests), rays));
        table_count(&out, rays_wrong(&t[i].b, &s->corners, s->brute, t[i].c->naive));
        table_number(&out, per(primary[i] * 1e9, s->primary.n));
        table_number(&out, per(diffuse[i] * 1e9, s->diffuse.n));
        table_number(&out, (double)rays / (primary[i] + diffuse[i]) * 1e-6);
        bvh_free(&t[i].b);
    }
    table_text(&out, "brute force"), table_text(&out, "-"), table_number(&out, 0), table_number(&out, 0);
    table_number(&out, 0), table_text(&out, "-"), table_number(&out, 0);
    table_number(&out, (double)s->m.triangles), table_count(&out, 0);
    table_number(&out, s->brute_seconds * 1e9), table_number(&out, s->brute_seconds * 1e9);
    table_number(&out, 1e-6 / s->brute_seconds);
    output_table(o, &out);
}

/* The same trees, by the formulas and by counting. */
static inline void table_of_overlap(const options *o, const subject *s)
{
    static const int shown[5] = {0, 1, 2, 5, 7};
    table out = table_new("Overlap: random lines through the box of the mesh, and diffuse rays",
                          "structure|nodes (14.7)|nodes, lines|tests (14.7)|tests, lines|in both (14.8)|"
                          "both, rays [%]|barren leaves, rays [%]");
    for (int i = 0; i < 5; i++) {
        bvh b;
        bvh_build(&s->m, candidate_list[shown[i]].options, &b);
        bvh_stats st = bvh_stats_of(&b.tree);
        ray_set lines = rays_uniform(&b.tree.node[0].box, o->quick ? 2000 : 50000, o->seed);
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

/* The teapot in a stadium: a fine teapot in the middle of one of 4032 triangles, 100 times as
 * large. Where triangles are alike, any cut will do; here the middle of a box is the wrong place.
 * */
static inline mesh stadium_mesh(int fine)
{
    mesh a = teapot_mesh(fine), b = teapot_mesh(8), m = {0};
    m.vertices = a.vertices + b.vertices, m.triangles = a.triangles + b.triangles;
    m.v = allocate(m.vertices, sizeof *m.v);
    m.index = allocate(3 * m.triangles, sizeof *m.index);
    memcpy(m.v, a.v, a.vertices * sizeof *m.v);
    memcpy(m.index, a.index, 3 * a.triangles * sizeof *m.index);
    for (size_t i = 0; i < b.vertices; i++)
        m.v[a.vertices + i] = vadd(vscale(b.v[i], 100), (vec3){20, 30, -150});
    for (size_t i = 0; i < 3 * b.triangles; i++)
        m.index[3 * a.triangles + i] = b.index[i] + (uint32_t)a.vertices;
    mesh_free(&a), mesh_free(&b);
    return m;
}

static inline void table_of_stadium(const options *o)
{
    static const int shown[5] = {0, 1, 2, 5, 7};
    mesh pot = teapot_mesh(1), m = stadium_mesh(o->quick ? 8 : 32);
    vec3 lo, hi;
    trial t[5];
    double seconds[5];
    bvh b;
    table out = table_new("The teapot in a stadium: diffuse rays from the teapot",
                          "structure|depth|nodes/ray|tests/ray|ray [ns]|nodes (14.7)|tests (14.7)|in both (14.8)");
    mesh_bounds(&pot, &lo, &hi);
    subject s = {.m = m, .v = view_of(lo, hi, true, (real)1.6)};
    s.primary = rays_primary(s.v, o->quick ? 40 : 160, o->quick ? 25 : 100);
    bvh_build(&m, bvh_defaults, &b);
    s.diffuse = rays_diffuse(&b, &m, &s.primary, o->seed);
    bvh_free(&b);
    for (int i = 0; i < 5; i++) {
        t[i] = (trial){&s, &candidate_list[shown[i]], &s.diffuse, {{0}, NULL, NULL}};
        run_build(&t[i]);
    }
    time_trials(t, 5, run_search, o->quick ? 1 : 5, seconds);
    for (int i = 0; i < 5; i++) {
        bvh_stats st = bvh_stats_of(&t[i].b.tree);
        bvh_work w = rays_count(&t[i].b, &s.diffuse);
        table_text(&out, "%s", t[i].c->name), table_count(&out, (size_t)st.depth);
        table_number(&out, per((double)w.nodes, s.diffuse.n));
        table_number(&out, per((double)w.tests, s.diffuse.n));
        table_number(&out, per(seconds[i] * 1e9, s.diffuse.n));
        table_number(&out, st.nodes), table_number(&out, st.tests), table_number(&out, st.overlap);
        bvh_free(&t[i].b);
    }
    output_extra_table(o, &out);
    mesh_free(&pot);
    subject_free(&s);
}

/* Quality against build time: each strategy a curve, leaf sizes 16, 8, 4, 2, 1 its points. */
static inline void plot_of_leaves(const options *o, const subject *s)
{
    static const char *const name[bvh_strategies] = {"cycling axis", "longest axis", "median",
                                                     "SAH, bins", "SAH, sweep"};
    plot p = plot_new("Leaves of 16, 8, 4, 2, 1", "build [ns a triangle]", "diffuse ray [ns]", 0);
    for (int k = 0; k < bvh_strategies; k++) {
        int series = plot_series(&p, name[k]);
        for (int leaf = 16; leaf > 0; leaf /= 2) {
            candidate c = {name[k], {(bvh_strategy)k, leaf, leaf > 1 ? 0.8 / leaf : 1}, false};
            trial t = {s, &c, &s->diffuse, {{0}, NULL, NULL}};
            double build, search;
            time_trials(&t, 1, run_build, 1, &build);
            time_trials(&t, 1, run_search, 3, &search);
            plot_add(&p, series, per(build * 1e9, s->m.triangles), per(search * 1e9, s->diffuse.n));
            bvh_free(&t.b);
        }
    }
    output_plot(o, &p, "14_bvh_build_time.svg");
}

/* Slope of y over x by least squares. */
static inline double slope_of(const double *x, const double *y, int n)
{
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (int i = 0; i < n; i++) sx += x[i], sy += y[i], sxx += x[i] * x[i], sxy += x[i] * y[i];
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

/* Time against n: teapots of 64 n^2 - 8 n triangles, ever finer. */
static inline void growth(const options *o, bool full)
{
    static const int fine[] = {1, 2, 4, 8, 16, 32, 64, 125, 177};
    static const candidate binned = {"SAH, bins", {BVH_SAH, 8, 0.3}, false};
    int n = o->quick ? 4 : full ? 9 : 8;
    double x[9], build[9], search[9], nodes[9], least = HUGE_VAL, greatest = 0;
    table out = table_new("Growth with n, SAH, bins, leaves of 8; one thread",
                          "triangles|build [ms]|build / (n log2 n) [ns]|nodes/ray|tests/ray|ray [ns]|"
                          "brute force [ns]|peak [B/tri]");
    plot p = plot_new("Time against n", "triangles", "time [ns]", PLOT_LOG_X | PLOT_LOG_Y);
    plot q = plot_new("Diffuse rays: work against n", "triangles", "a ray", PLOT_LOG_X);
    int by_build = plot_series(&p, "build, a triangle"), by_ray = plot_series(&p, "BVH, a ray");
    int by_brute = plot_series(&p, "brute force, a ray"), by_nodes = plot_series(&q, "pairs of boxes");
    int by_tests = plot_series(&q, "triangles");
    for (int i = 0; i < n; i++) {
        subject s = subject_of(teapot_mesh(fine[i]), 200, 125,
                               fine[i] <= 64 ? 40 : 0, o->seed);
        trial t = {&s, &binned, &s.diffuse, {{0}, NULL, NULL}};
        double triangles = (double)s.m.triangles, seconds;
        time_trials(&t, 1, run_build, fine[i] < 64 ? 9 : fine[i] < 120 ? 3 : 1, &build[i]);
        time_trials(&t, 1, run_search, 3, &seconds);
        bvh_work w = rays_count(&t.b, &s.diffuse);
        x[i] = log2(triangles), search[i] = log2(seconds / (double)s.diffuse.n);
        nodes[i] = per((double)w.nodes, s.diffuse.n);
        double unit = build[i] / (triangles * x[i]);
        if (triangles > 900 && unit < least) least = unit;
        if (triangles > 900 && unit > greatest) greatest = unit;
        table_count(&out, s.m.triangles), table_number(&out, build[i] * 1e3), table_number(&out, unit * 1e9);
        table_number(&out, nodes[i]), table_number(&out, per((double)w.tests, s.diffuse.n));
        table_number(&out, per(seconds * 1e9, s.diffuse.n));
        if (s.corners.n) table_number(&out, s.brute_seconds * 1e9);
        else table_text(&out, "-");
        table_number(&out, per((double)t.b.tree.peak, s.m.triangles));
        plot_add(&p, by_build, triangles, build[i] * 1e9 / triangles);
        plot_add(&p, by_ray, triangles, per(seconds * 1e9, s.diffuse.n));
        if (s.corners.n) plot_add(&p, by_brute, triangles, s.brute_seconds * 1e9);
        plot_add(&q, by_nodes, triangles, nodes[i]);
        plot_add(&q, by_tests, triangles, per((double)w.tests, s.diffuse.n));
        build[i] = log2(build[i]);
        bvh_free(&t.b);
        subject_free(&s);
    }
    output_extra_table(o, &out);
    printf("# fitted: build ~ n^%.2f; build / (n log2 n) within a factor %.2f from 1e3 triangles on\n",
           slope_of(x, build, n), greatest / least);
    printf("# fitted: a diffuse ray tests %.2f more pairs of boxes for each doubling of n; time ~ n^%.2f\n",
           slope_of(x, nodes, n), slope_of(x, search, n));
    plot_slope(&p, 1, "slope 1");
    output_plot(o, &p, "14_bvh_n_time.svg");
    output_plot(o, &q, "14_bvh_n.svg");
}

#endif
