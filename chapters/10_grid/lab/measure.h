/* measure.h: the tables and plots of this chapter.
 *
 *   measure_variants(o)          wrong hits against time
 *   measure_density(o)           time against cells an item, on four scenes
 *   measure_stadium(o)           one level and two, where cells of one size cannot serve
 *   measure_drift(o)             how far a walk of up to 1e5 cells goes astray
 */
#ifndef GRID_MEASURE_H
#define GRID_MEASURE_H

#include "../../../common/lab/report.h"
#include "../../../common/parallel.h"
#include "bench.h"
#include "drift.h"
#include "../first.h"
#include "../../09_aabb/trials/first_row.h"
#include "naive.h"
#include "../nested.h"
#include "specks.h"

/* ---------------------------------------------------------------------------------------------- */

/* Searches every ray; returns a sum that depends on all hits. */
#define GRID_RUN(name, type, hit_of)                                                           \
    static double name(void *context)                                                          \
    {                                                                                          \
        const grid_run *c = context;                                                           \
        double sum = 0;                                                                        \
        for (size_t i = 0; i < c->rays->n; i++) {                                              \
            hit h = {0, 0, 0, 0};                                                              \
            hit_of((const type *)c->built, c->rays->r[i], &h);                                 \
            sum += (double)h.t;                                                                \
            if (c->hits) c->hits[i] = h;                                                       \
        }                                                                                      \
        return sum;                                                                            \
    }

typedef struct { const void *built; const ray_set *rays; hit *hits; } grid_run;
GRID_RUN(run_default, grid, grid_hit)
GRID_RUN(run_early, grid, grid_hit_early)
GRID_RUN(run_naive, grid, grid_hit_naive)
GRID_RUN(run_nested, nested, nested_hit)

static inline double per_ray(size_t count, const ray_set *rays)
{
    return rays->n ? (double)count / (double)rays->n : 0;
}

static inline search_work grid_work(const grid *g, const ray_set *rays)
{
    search_work w = {0, 0, 0, 0};
    hit h;
    for (size_t i = 0; i < rays->n; i++) grid_hit_counted(g, rays->r[i], &h, &w);
    return w;
}

static inline search_work nested_work(const nested *x, const ray_set *rays)
{
    search_work w = {0, 0, 0, 0};
    hit h;
    for (size_t i = 0; i < rays->n; i++) nested_hit_counted(x, rays->r[i], &h, &w);
    return w;
}

/* ---- wrong hits against time ---- */

typedef struct { const items *x; const ray_set *rays; hit *h; } brute_job;

static void brute_one(size_t i, void *context)
{
    const brute_job *j = context;
    j->h[i] = (hit){0, 0, 0, 0};
    items_hit(j->x, j->rays->r[i], &j->h[i]);
}

/* Per cent of the rays whose hit is not that of brute force. */
static inline double wrong_hits(double (*run)(void *), const void *built, const ray_set *rays,
                                const hit *expected)
{
    size_t wrong = 0;
    hit *h = allocate(rays->n, sizeof *h);
    grid_run c = {built, rays, h};
    run(&c);
    for (size_t i = 0; i < rays->n; i++)
        wrong += h[i].t != expected[i].t || h[i].shape != expected[i].shape;
    free(h);
    return 100 * per_ray(wrong, rays);
}

static inline hit *brute_hits(const items *x, const ray_set *rays, int threads)
{
    hit *h = allocate(rays->n, sizeof *h);
    brute_job job = {x, rays, h};
    parallel_for(rays->n, threads, "brute force", brute_one, &job);
    return h;
}

/* What the rows of the table are built and searched with. */
typedef struct { const char *name; double density; bool exact, mailbox; } variant;
enum { variants = 10, first_naive = 0, first_early = 1, two_levels = 9 };
static const variant variant_list[variants] = {
    {"t added up, float", 27, true, true}, {"first hit accepted", 27, true, true},
    {"grid_hit", 27, true, true},          {"marked by bounds", 27, false, true},
    {"no mailbox", 27, true, false},       {"by bounds, no mailbox", 27, false, false},
    {"1 cell a shape", 1, true, true},     {"10 cells a shape", 10, true, true},
    {"100 cells a shape", 100, true, true}, {"two levels", 0, true, true}};

typedef struct { grid g; nested n; double (*run)(void *); } built_variant;

static inline const void *variant_built(const built_variant *b, int k)
{
    return k == two_levels ? (const void *)&b->n : (const void *)&b->g;
}

static inline void variant_build(int k, const items *x, built_variant *b)
{
    const variant *v = &variant_list[k];
    grid_options how = {v->density, v->exact, v->mailbox, grid_defaults.most_bytes};
    failure f;
    *b = (built_variant){.run = k == first_naive   ? run_naive
                                : k == first_early ? run_early
                                : k == two_levels  ? run_nested
                                                   : run_default};
    if (k == two_levels ? !nested_build(x, nested_defaults, &b->n, &f)
                        : !grid_build(x, how, &b->g, &f)) fail(f);
}

static inline void variant_free(built_variant *b) { grid_free(&b->g), nested_free(&b->n); }

/* A mesh, rays and their hits by brute force; each variant builds it anew. */
typedef struct { mesh m; items x; ray_set rays; hit *h; } side_scene;

static inline double side_wrong(int k, const side_scene *s)
{
    built_variant b;
    variant_build(k, &s->x, &b);
    double wrong = wrong_hits(b.run, variant_built(&b, k), &s->rays, s->h);
    variant_free(&b);
    return wrong;
}

static inline void side_free(side_scene *s)
{
    mesh_free(&s->m), rays_free(&s->rays), free(s->h);
}

/* Lines through large triangles: each is in many cells. */
static inline void boards_make(const options *o, side_scene *s)
{
    s->m = bench_boards(o->quick ? 50 : 200, o->seed), s->x = items_of_mesh(&s->m);
    s->rays = rays_uniform((aabb){{-1, -1, -1}, {1, 1, 1}}, o->quick ? 500 : 10000, o->seed);
    s->h = brute_hits(&s->x, &s->rays, o->threads);
}

static inline void specks_make(const options *o, side_scene *s)
{
    size_t n = o->quick ? 1000 : 20000;
    s->m = specks_mesh(o->quick ? 300 : 2000, grid_defaults, o->seed);
    s->x = items_of_mesh(&s->m);
    s->rays = (ray_set){allocate(n, sizeof(ray)), n};
    for (size_t i = 0; i < n; i++) s->rays.r[i] = specks_ray(&s->m, o->seed, i);
    s->h = brute_hits(&s->x, &s->rays, o->threads);
}

/* Eye rays, and one on from each of their hits. */
static inline ray_set teapot_rays(const mesh *m, int width, int height, uint64_t seed, int threads)
{
    vec3 lo, hi;
    mesh_bounds(m, &lo, &hi);
    items x = items_of_mesh(m);
    ray_set p = rays_primary(camera_of(lo, hi, true, (real)width / (real)height), width, height);
    hit *h = brute_hits(&x, &p, threads);
    for (size_t i = 0; i < p.n; i++) if (h[i].t == 0) h[i] = hit_none;
    ray_set d = rays_diffuse(m, &p, h, seed), all = {allocate(p.n + d.n, sizeof(ray)), p.n + d.n};
    memcpy(all.r, p.r, p.n * sizeof(ray)), memcpy(all.r + p.n, d.r, d.n * sizeof(ray));
    free(h), rays_free(&p), rays_free(&d);
    return all;
}

static inline bool first_grid_search(const void *g, ray r, hit *out)
{
    return first_grid_hit(g, r, out);
}

/* Per cent of wrong hits. */
static inline double first_side_wrong(const mesh *m, const ray_set *rays, const hit *brute)
{
    first_mesh f = first_mesh_of(m);
    first_grid g = first_grid_build(&f);
    size_t wrong = first_wrong((first_search){&g, first_grid_search}, rays, brute);
    first_grid_free(&g), first_mesh_free(&f);
    return 100 * per_ray(wrong, rays);
}

static inline void first_row(table *t, const mesh *m, const ray_set *rays, const hit *brute,
                             const side_scene *boards, const side_scene *specks, int rounds)
{
    first_mesh f = first_mesh_of(m);
    first_grid g = first_grid_build(&f);
    first_search s = {&g, first_grid_search};
    table_text(t, "first"), table_count(t, (size_t)(g.n[0] * g.n[1] * g.n[2]));
    table_number(t, (double)g.items / (double)f.n), table_text(t, "-");
    table_number(t, first_tests_a_ray(s, rays));
    table_number(t, first_side_wrong(m, rays, brute));
    table_number(t, first_side_wrong(&boards->m, &boards->rays, boards->h));
    table_number(t, first_side_wrong(&specks->m, &specks->rays, specks->h));
    table_number(t, first_seconds(s, rays, rounds) * 1e9 / (double)rays->n);
    first_grid_free(&g), first_mesh_free(&f);
}

static inline void measure_variants(const options *o)
{
    table t = table_new("Wrong hits on three scenes; work and time a ray on the teapot",
                        "variant|cells|references a shape|cells a ray|tests a ray|"
                        "error teapot [%]|error boards [%]|error specks [%]|time [ns]");
    plot p = plot_new("Wrong hits: the worst of three scenes; time: teapot", "time a ray [ns]",
                      "wrong [%]", PLOT_LOG_Y);
    mesh m = teapot_mesh(o->quick ? 4 : 10);
    side_scene boards, specks;
    boards_make(o, &boards), specks_make(o, &specks);
    items x = items_of_mesh(&m);
    ray_set rays = teapot_rays(&m, o->quick ? 40 : 130, o->quick ? 25 : 80, o->seed, o->threads);
    hit *h = brute_hits(&x, &rays, o->threads);
    built_variant b[variants];
    grid_run run[variants];
    clock_variant v[variants];
    for (int i = 0; i < variants; i++) {
        variant_build(i, &x, &b[i]);
        run[i] = (grid_run){variant_built(&b[i], i), &rays, NULL};
        v[i] = (clock_variant){variant_list[i].name, b[i].run, &run[i], 0};
    }
    clock_compare(v, variants, o->quick ? 3 : 25);
    first_row(&t, &m, &rays, h, &boards, &specks, o->quick ? 3 : 25);
    for (int i = 0; i < variants; i++) {
        bool nest = i == two_levels;
        structure_stats st = nest ? nested_stats(&b[i].n) : grid_stats(&b[i].g);
        search_work w = nest ? nested_work(&b[i].n, &rays) : grid_work(&b[i].g, &rays);
        double wrong = wrong_hits(b[i].run, variant_built(&b[i], i), &rays, h);
        double time = v[i].seconds * 1e9 / (double)rays.n;
        table_text(&t, "%s", variant_list[i].name), table_count(&t, st.leaves);
        table_number(&t, (double)st.references / (double)st.items);
        if (i == first_naive || i == first_early) table_text(&t, "-"), table_text(&t, "-");
        else table_number(&t, per_ray(w.nodes, &rays)), table_number(&t, per_ray(w.tests, &rays));
        double boards_wrong = side_wrong(i, &boards), specks_wrong = side_wrong(i, &specks);
        double worst = fmax(wrong, fmax(boards_wrong, specks_wrong));
        table_number(&t, wrong), table_number(&t, boards_wrong), table_number(&t, specks_wrong);
        table_number(&t, time);
        if (i != 4 && i != 5) plot_add(&p, plot_series(&p, variant_list[i].name), time, worst);
    }
    for (int i = 0; i < variants; i++) variant_free(&b[i]);
    output_table(o, &t);
    output_plot(o, &p, "10_grid_wrong_time.svg");
    free(h), rays_free(&rays), mesh_free(&m), side_free(&boards), side_free(&specks);
}

/* ---- how many cells ---- */

/* Median of nine passes. */
static inline double time_of(double (*run)(void *), const void *built, const ray_set *rays)
{
    grid_run c = {built, rays, NULL};
    clock_variant v = {"", run, &c, 0};
    clock_compare(&v, 1, 9);
    return v.seconds * 1e9 / (double)rays->n;
}

enum { density_first = -3, density_last = 9, densities = density_last - density_first + 1 };

/* One scene: a point a density in both plots; the row of the table. */
static inline void measure_scene(const options *o, bench_kind kind, table *t, plot *time,
                                 plot *work)
{
    bench b;
    nested n;
    failure f;
    bench_make(kind, o->quick, o->seed, &b);
    int series = plot_series(time, bench_name[kind]), tests, cells;
    char name[64];
    snprintf(name, sizeof name, "%s: tests", bench_name[kind]), tests = plot_series(work, name);
    snprintf(name, sizeof name, "%s: cells", bench_name[kind]), cells = plot_series(work, name);
    double best = 0, best_time = 0, at_27 = 0;
    for (int k = density_first - 1; k <= (o->quick ? 4 : density_last); k++) {
        grid g;
        grid_options how = grid_defaults;
        bool notes = k < density_first;  /* 27 first */
        how.density = notes ? 27 : ldexp(1.0, k);
        if (!grid_build(&b.x, how, &g, &f)) break;
        search_work w = grid_work(&g, &b.rays);
        double ns = time_of(run_default, &g, &b.rays);
        grid_free(&g);
        if (notes) { at_27 = ns; continue; }
        if (best == 0 || ns < best_time) best = how.density, best_time = ns;
        plot_add(time, series, how.density, ns);
        plot_add(work, tests, how.density, per_ray(w.tests, &b.rays));
        plot_add(work, cells, how.density, per_ray(w.nodes, &b.rays));
    }
    if (!nested_build(&b.x, nested_defaults, &n, &f)) fail(f);
    double two = time_of(run_nested, &n, &b.rays);
    table_text(t, "%s", bench_name[kind]), table_count(t, b.x.n), table_number(t, best);
    table_number(t, best_time), table_number(t, at_27), table_number(t, at_27 / best_time);
    table_number(t, two);
    nested_free(&n), bench_free(&b);
}

static inline void measure_density(const options *o)
{
    table t = table_new("How many cells a shape are best? Lines from everywhere; stadium: eye rays",
                        "scene|shapes|best|time best [ns]|time at 27 [ns]|27 / best|"
                        "time two levels [ns]");
    plot time = plot_new("Time against cells", "cells a shape", "time a ray [ns]",
                         PLOT_LOG_X | PLOT_LOG_Y);
    plot work = plot_new("Work against cells", "cells a shape", "a ray", PLOT_LOG_X | PLOT_LOG_Y);
    for (int k = 0; k < benches; k++) measure_scene(o, (bench_kind)k, &t, &time, &work);
    output_extra_table(o, &t);
    output_plot(o, &time, "10_grid_time.svg");
    output_plot(o, &work, "10_grid_density.svg");
}

/* ---- one level and two ---- */

static inline void stadium_row(table *t, const char *place, const char *name, double seconds,
                               structure_stats s, search_work w, double ns, const ray_set *rays)
{
    table_text(t, "%s", place), table_text(t, "%s", name), table_number(t, 1e3 * seconds);
    table_number(t, (double)s.bytes / (double)s.items);
    table_number(t, per_ray(w.nodes, rays)), table_number(t, per_ray(w.tests, rays));
    table_number(t, ns);
}

static inline void measure_stadium(const options *o)
{
    table t = table_new("One level and two: the teapot alone, and in a stadium",
                        "scene|structure|build [ms]|bytes a shape|cells a ray|tests a ray|"
                        "time [ns]");
    static const double density[] = {1, 27, 512};
    for (int both = 0; both < 2; both++) {
        bench b;
        failure f;
        char name[64];
        bench_make(both ? BENCH_STADIUM : BENCH_TEAPOT, o->quick, o->seed, &b);
        for (int k = 0; k < (o->quick ? 2 : 3); k++) {
            grid g;
            grid_options how = grid_defaults;
            how.density = density[k];
            double start = clock_seconds();
            if (!grid_build(&b.x, how, &g, &f)) fail(f);
            double built = clock_seconds() - start;
            snprintf(name, sizeof name, "grid, %g cells a shape", density[k]);
            stadium_row(&t, bench_name[both ? BENCH_STADIUM : BENCH_TEAPOT], name, built,
                        grid_stats(&g), grid_work(&g, &b.rays), time_of(run_default, &g, &b.rays),
                        &b.rays);
            grid_free(&g);
        }
        nested n;
        double start = clock_seconds();
        if (!nested_build(&b.x, nested_defaults, &n, &f)) fail(f);
        double built = clock_seconds() - start;
        stadium_row(&t, bench_name[both ? BENCH_STADIUM : BENCH_TEAPOT], "two levels", built,
                    nested_stats(&n), nested_work(&n, &b.rays), time_of(run_nested, &n, &b.rays),
                    &b.rays);
        nested_free(&n), bench_free(&b);
    }
    output_extra_table(o, &t);
}

/* ---- how far a walk goes astray ---- */

static inline void measure_drift(const options *o)
{
    table t = table_new("Walks in a wrong cell, and how far off the next wall is",
                        "cells passed|float, added: wrong [%]|off [cells]|added: wrong [%]|"
                        "off [cells]|counted: wrong [%]|off [cells]");
    plot p = plot_new("How far off is the next wall?", "cells passed", "error [cells]",
                      PLOT_LOG_X | PLOT_LOG_Y);
    for (int k = 0; k < drift_kinds; k++) plot_series(&p, drift_name[k]);
    plot_slope(&p, 2, "slope 2"), plot_slope(&p, 1, "slope 1");
    for (size_t n = 10; n <= (o->quick ? 1000 : 100000); n *= 10) {
        table_count(&t, n);
        for (int k = 0; k < drift_kinds; k++) {
            drift d = drift_after((drift_kind)k, n, o->quick ? 50 : 200, o->seed);
            table_number(&t, 100 * d.wrong), table_number(&t, d.error);
            plot_add(&p, k, (double)n, d.error);
        }
    }
    output_extra_table(o, &t);
    output_plot(o, &p, "10_grid_drift.svg");
}

#endif
