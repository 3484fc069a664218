/* triangle_measure.h: the tables of this chapter, and the plot of slips.
 *
 *   triangle_main_table(&o)   triangle_plot_slips(&o)   triangle_effort_table(&o): what is computed
 *
 * What a test costs is measured with triangles anywhere and rays anywhere: the closest hit of each
 * ray among all of them, most of which it misses; that is what a test is for. Whether a ray passes
 * left or right of an edge is a coin toss here, as it is in the leaf of a tree: the processor
 * cannot predict a branch on it. The triangles fit into the cache.
 */
#ifndef TRIANGLE_MEASURE_H
#define TRIANGLE_MEASURE_H

#include "../../../common/lab/bench.h"
#include "../../../common/lab/report.h"
#include "mine.h"
#include "triangle_variants.h"

enum { soup_triangles = 512, soup_rays = 400, soup_timed = 100 };
typedef struct {
    triangle tri[soup_triangles];
    triangle_planes planes[soup_triangles];
    ray r[soup_rays];  /* of which the first soup_timed are timed */
} triangle_soup;

/* ---------------------------------------------------------------------------------------------- */

/* Edges about 0.5 long in a cube of side 2, rays from a cube of side 4. */
static inline triangle_soup *soup_new(uint64_t seed)
{
    triangle_soup *s = allocate(1, sizeof *s);
    random_stream g = random_start(seed, 9, 0);
    for (int i = 0; i < soup_triangles; i++) {
        vec3 m = random_in_cube(&g, 1), a = random_in_cube(&g, 0.5), b = random_in_cube(&g, 0.5);
        s->tri[i] = (triangle){vadd(m, a), vadd(m, b), vadd(m, random_in_cube(&g, 0.5))};
        s->planes[i] = triangle_planes_of(s->tri[i]);
    }
    for (int i = 0; i < soup_rays; i++) {
        vec3 from = random_in_cube(&g, 2);
        s->r[i] = ray_from(from, random_in_cube(&g, 1));
    }
    return s;
}

/* A function for bench.h: for each ray r `prepare`, then `test` for each triangle *k; a hit in h
 * narrows r.tmax. Every test is inlined: a call that copies ray and triangle takes longer. */
#define SOUP_TIMED(name, prepare, test)                                                        \
    __attribute__((flatten))                                                                   \
    static double name(void *context)                                                          \
    {                                                                                          \
        const triangle_soup *s = context;                                                      \
        double sum = 0;                                                                        \
        for (int i = 0; i < soup_timed; i++) {                                                 \
            ray r = s->r[i];                                                                   \
            hit h = hit_none;                                                                  \
            prepare;                                                                           \
            for (const triangle *k = s->tri; k < s->tri + soup_triangles; k++)                 \
                if (test) r.tmax = h.t;                                                        \
            sum += (double)h.u;                                                                \
        }                                                                                      \
        return sum;                                                                            \
    }

SOUP_TIMED(run_plane, (void)0, triangle_hit_plane(*k, r, &h))
SOUP_TIMED(run_first, (void)0, first_triangle_hit(*k, r, &h))
SOUP_TIMED(run_mt, (void)0, triangle_hit_moller_trumbore(*k, r, &h))
SOUP_TIMED(run_tolerant, (void)0, triangle_hit_tolerant(*k, r, &h))
SOUP_TIMED(run_planes, (void)0, triangle_hit_planes_of(&s->planes[k - s->tri], r, &h))
SOUP_TIMED(run_triple, (void)0, triangle_hit_triple(*k, r, &h))
SOUP_TIMED(run_watertight, (void)0, triangle_hit(*k, r, &h))
SOUP_TIMED(run_sheared, ray_shear z = shear_of(r),
           triangle_hit_corners(&k->a, &k->b, &k->c, &z, r, &h))
SOUP_TIMED(run_mine, (void)0, mine_triangle_hit(*k, r, &h))

enum { triangle_methods = 8 + triangle_mine };
static const struct {
    const char *name;
    triangle_method *hit;
    double (*run)(void *);
    bool plotted;
} method[] = {
    {"plane + inside", triangle_hit_plane, run_plane, true},
    {"first: Möller-Trumbore", first_triangle_hit, run_first, true},
    {"Möller-Trumbore, divides last", triangle_hit_moller_trumbore, run_mt, false},
    {"Möller-Trumbore, edges +1e-5", triangle_hit_tolerant, run_tolerant, true},
    {"planes computed beforehand", triangle_hit_planes, run_planes, true},
    {"triple products", triangle_hit_triple, run_triple, true},
    {"watertight", triangle_hit, run_watertight, true},
    {"watertight, shear kept", triangle_hit, run_sheared, false},
    {"mine", mine_triangle_hit, run_mine, true}};

typedef struct { const options *o; icosphere m; double cell[triangle_methods][4]; } triangle_rows;

/* A column of a row, all but the time: for parallel_whole. 0: vertices, 1: edges, 3: needles. */
static inline void triangle_cell(size_t i, void *context)
{
    triangle_rows *all = context;
    const options *o = all->o;
    size_t k = i / 3, c = i % 3, few = o->quick ? 500 : 10000;
    double *cell = all->cell[k];
    if (c == 2) { cell[3] = triangle_needles(method[k].hit, 1e-6, few, o->seed).error; return; }
    /* who never slips gets more rays; with --full a million */
    size_t many = o->full ? 1000000 : 100000;
    size_t rays = o->quick ? 500 : method[k].hit == triangle_hit ? many : 4000;
    triangle_slip_count n = slips(&all->m, method[k].hit, c == 0, rays, o->seed);
    cell[c] = 100 * (double)n.slips / (double)rays;
    if (c == 1) cell[2] = (double)n.hits / (double)rays;
}

static inline void triangle_main_table(const options *o)
{
    table t = table_new("Rays aimed from inside at a sphere of 5120 triangles: slips;"
                        " needles 1e-6 wide: t; a test's time",
                        "method|error at vertices [%]|error at edges [%]|error hits at an edge|"
                        "error needles t|time [ns]");
    triangle_rows all = {.o = o, .m = icosphere_new(4, (vec3){0, 0, 0}, 1)};
    parallel_whole(3 * triangle_methods, o->threads, "rays", triangle_cell, &all);
    icosphere_free(&all.m);
    triangle_soup *s = soup_new(o->seed);
    bench_candidate timed[triangle_methods];
    for (int k = 0; k < triangle_methods; k++)
        timed[k] = (bench_candidate){.run = method[k].run, .context = s};
    bench_time(timed, triangle_methods, o->quick ? 3 : o->full ? 41 : 15);
    for (int k = 0; k < triangle_methods; k++) {
        table_text(&t, "%s", method[k].name);
        for (int c = 0; c < 4; c++) table_number(&t, all.cell[k][c]);
        table_number(&t, 1e9 * timed[k].seconds / (soup_triangles * soup_timed));
    }
    free(s);
    output_table(o, &t);
}

cold_inline void triangle_plot_slips(const options *o)
{
    plot p = plot_new("Rays aimed at vertices of a closed mesh", "translation [R]", "slips [%]",
                      PLOT_LOG_X);
    for (int k = 0; k < triangle_methods; k++)
        if (method[k].plotted) plot_series(&p, method[k].name);
    for (real far = 1; far < (real)2e6; far *= 10) {
        icosphere m = icosphere_new(4, (vec3){far, 0, 0}, 1);
        for (int k = 0, series = 0; k < triangle_methods; k++)
            if (method[k].plotted)
                plot_add(&p, series++, (double)far,
                         (double)slips(&m, method[k].hit, true, 4000, o->seed).slips / 40);
        icosphere_free(&m);
    }
    output_plot(o, &p, "04_triangle_slips.svg");
}

/* How far the watertight test gets with triangles anywhere and rays anywhere: where the signs
 * agree, the whole line is hit. */
static inline void triangle_effort_table(const options *o)
{
    size_t before = triangle_doubts, divided = 0;
    triangle_soup *u = soup_new(o->seed);
    for (int i = 0; i < soup_rays; i++) {
        ray line = {u->r[i].o, -real_infinity, u->r[i].d, real_infinity};
        hit h;
        for (int k = 0; k < soup_triangles; k++) divided += triangle_hit(u->tri[k], line, &h);
    }
    table t = table_new("What the watertight test computes: triangles anywhere, rays anywhere",
                        "tests|signs agree: divided|exact signs");
    table_count(&t, soup_rays * soup_triangles), table_count(&t, divided);
    table_count(&t, triangle_doubts - before);
    free(u);
    output_extra_table(o, &t);
}

#endif
