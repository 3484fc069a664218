/* triangle_measure.h: the tables and plots of this chapter.
 *
 *   triangle_measure(&o)   the main table; with --full all others, and the plots
 */
#ifndef TRIANGLE_MEASURE_H
#define TRIANGLE_MEASURE_H

#include "../../../common/lab/report.h"
#include "../../../common/parallel.h"
#include "mine.h"
#include "soup.h"
#include "triangle_variants.h"

/* ---------------------------------------------------------------------------------------------- */

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

/* For the columns that do not measure time. */
static bool hit_sheared(triangle tri, ray r, hit *out)
{
    ray_shear s = shear_of(r);
    return triangle_hit_sheared(tri, &s, r, out);
}

enum { triangle_methods = 9 + triangle_mine };
static const struct {
    const char *name;
    triangle_method *hit;
    double (*run)(void *);
    bool f32, plotted, timed;  /* corners are floats, in a plot alone; which plots */
} method[] = {
    {"Möller-Trumbore, float", triangle_hit_moller_trumbore_f32, NULL, 1, 1, 0},
    {"plane + inside", triangle_hit_plane, run_plane, 0, 1, 1},
    {"first: Möller-Trumbore", first_triangle_hit, run_first, 0, 1, 1},
    {"Möller-Trumbore, divides last", triangle_hit_moller_trumbore, run_mt, 0, 0, 1},
    {"Möller-Trumbore, edges +1e-5", triangle_hit_tolerant, run_tolerant, 0, 1, 0},
    {"planes computed beforehand", triangle_hit_planes, run_planes, 0, 1, 1},
    {"triple products", triangle_hit_triple, run_triple, 0, 1, 1},
    {"watertight", triangle_hit, run_watertight, 0, 1, 1},
    {"watertight, shear kept", hit_sheared, run_sheared, 0, 0, 1},
    {"mine", mine_triangle_hit, run_mine, 0, 1, 1}};

static inline icosphere sphere_at(int k, real translation)
{
    icosphere m = icosphere_new(4, (vec3){translation, 0, 0}, 1);
    if (method[k].f32) icosphere_f32(&m);
    return m;
}

typedef struct {
    double slips[2];  /* at edges, at vertices, percent */
    double at_edge;   /* hits a ray aimed at an edge */
    triangle_needle_count needles;
    double ns;
} triangle_row;
typedef struct { const options *o; triangle_row row[triangle_methods]; } triangle_rows;

/* All but the time, of one method: for parallel_for. Who never slips gets a million rays. */
static inline void triangle_row_of(size_t k, void *context)
{
    triangle_rows *all = context;
    const options *o = all->o;
    triangle_row *y = &all->row[k];
    bool tight = method[k].hit == triangle_hit || method[k].hit == hit_sheared;
    if (method[k].f32) return;
    size_t rays = o->quick ? 500 : tight ? 1000000 : 4000;
    icosphere m = sphere_at((int)k, 0);
    for (int v = 0; v < 2; v++) {
        triangle_slip_count n = slips(&m, method[k].hit, v, rays, o->seed);
        y->slips[v] = 100 * (double)n.slips / (double)n.rays;
    }
    y->at_edge = slip_hits(&m, method[k].hit, false, o->quick ? 500 : 10000, o->seed);
    icosphere_free(&m);
    y->needles = triangle_needles(method[k].hit, 1e-6, o->quick ? 500 : 10000, o->seed);
}

static inline void triangle_times(const options *o, triangle_rows *all)
{
    triangle_soup *s = soup_new(o->quick ? 20 : 100, o->seed);
    bench_candidate v[triangle_methods];
    int n = 0, of[triangle_methods];
    for (int k = 0; k < triangle_methods; k++)
        if (!method[k].f32)
            of[n] = k, v[n++] = (bench_candidate){method[k].name, method[k].run, s, 0, 0};
    bench_time(v, n, o->quick ? 3 : 41);
    for (int i = 0; i < n; i++)
        all->row[of[i]].ns = 1e9 * v[i].seconds / (soup_triangles * s->rays);
    free(s);
}

static inline void triangle_main_table(const options *o, const triangle_rows *all)
{
    table t = table_new("Rays aimed from inside at a sphere of 5120 triangles: slips;"
                        " needles 1e-6 wide: t; a test's time",
                        "method|error at vertices [%]|error at edges [%]|error hits at an edge|"
                        "error needles t|time [ns]");
    plot p = plot_new("Needles 1e-6 wide: error against time", "time [ns]",
                      "largest relative error of t", PLOT_LOG_Y);
    for (int k = 0; k < triangle_methods; k++) {
        const triangle_row *y = &all->row[k];
        if (method[k].f32) continue;
        table_text(&t, "%s", method[k].name);
        table_number(&t, y->slips[1]), table_number(&t, y->slips[0]);
        table_number(&t, y->at_edge), table_number(&t, y->needles.error);
        table_number(&t, y->ns);
        if (method[k].timed) plot_add(&p, plot_series(&p, method[k].name), y->ns, y->needles.error);
    }
    output_table(o, &t);
    output_plot(o, &p, "04_triangle_time.svg");
}

static inline void triangle_plots(const options *o)
{
    plot p = plot_new("Rays aimed at vertices of a closed mesh", "translation [R]", "slips [%]",
                      PLOT_LOG_X);
    plot q = plot_new("Needles: error against width", "width", "largest relative error of t",
                      PLOT_LOG_X | PLOT_LOG_Y);
    for (int k = 0; k < triangle_methods; k++) {
        if (!method[k].plotted) continue;
        int on_p = plot_series(&p, method[k].name), on_q = plot_series(&q, method[k].name);
        for (real far = 1; far < (real)2e6; far *= 10) {
            icosphere m = sphere_at(k, far);
            triangle_slip_count n = slips(&m, method[k].hit, true, 4000, o->seed);
            plot_add(&p, on_p, (double)far, 100 * (double)n.slips / (double)n.rays);
            icosphere_free(&m);
        }
        for (double width = 1; width > 5e-8; width /= 10) {
            triangle_needle_count n = triangle_needles(method[k].hit, width, 2000, o->seed);
            if (n.missed < n.due) plot_add(&q, on_q, width, n.error);
        }
    }
    output_plot(o, &p, "04_triangle_slips.svg");
    output_plot(o, &q, "04_triangle_needles.svg");
}

/* ---- what the watertight test computes: how far each of its tests gets ---- */

typedef struct { const char *name; size_t tests, divided, exact; } triangle_effort;

static inline void triangle_effort_add(triangle_effort *e, triangle tri, ray r)
{
    ray_shear s = shear_of(r);
    vec3 a = shear_corner(&tri.a, &s), b = shear_corner(&tri.b, &s), c = shear_corner(&tri.c, &s);
    size_t before = triangle_doubts;
    hit h;
    (void)triangle_hit(tri, r, &h);
    e->tests++, e->exact += triangle_doubts - before;
    e->divided += !signs_differ(c.x * b.y - c.y * b.x, a.x * c.y - a.y * c.x,
                                b.x * a.y - b.y * a.x);
}

static inline void triangle_effort_table(const options *o)
{
    triangle_effort e[3] = {{"triangles anywhere, rays anywhere", 0, 0, 0},
                            {"the sphere, rays at its vertices", 0, 0, 0},
                            {"needles 1e-6 wide, rays at their middle", 0, 0, 0}};
    triangle_soup *s = soup_new(400, o->seed);
    for (int i = 0; i < s->rays; i++)
        for (int k = 0; k < soup_triangles; k++) triangle_effort_add(&e[0], s->tri[k], s->r[i]);
    icosphere m = icosphere_new(4, (vec3){0, 0, 0}, 1);
    random_stream g = random_start(o->seed, 20, 0);
    for (int i = 0; i < 40; i++) {
        ray r = slip_aim(&m, true, &g).r, q;
        for (uint32_t k = 0; k < m.triangles; k++)
            triangle_effort_add(&e[1], icosphere_triangle(&m, k), r);
        for (int k = 0; k < 5000; k++) {
            triangle tri = needle(&g, (real)1e-6, &q);
            triangle_effort_add(&e[2], tri, q);
        }
    }
    table t = table_new("What the watertight test computes",
                        "tests|number|signs agree: divided|exact signs|share of exact signs [%]");
    for (int k = 0; k < 3; k++) {
        table_text(&t, "%s", e[k].name), table_count(&t, e[k].tests);
        table_count(&t, e[k].divided), table_count(&t, e[k].exact);
        table_number(&t, 100 * (double)e[k].exact / (double)e[k].tests);
    }
    output_extra_table(o, &t);
    icosphere_free(&m);
    free(s);
}

static inline void triangle_measure(const options *o)
{
    triangle_rows *all = allocate(1, sizeof *all);
    all->o = o;
    parallel_whole(triangle_methods, o->threads, "rays", triangle_row_of, all);
    triangle_times(o, all);
    triangle_main_table(o, all);
    if (o->full) {
        triangle_plots(o);
        triangle_effort_table(o);
    }
    free(all);
}

#endif
