/* csg_measure.h: the tables and plots of this chapter.
 *
 *   csg_measure(&o)     what each way gets wrong, and its time; how many solids a ray asks; with
 *                       --full faces of meshes, trees of depth 1 to 20, the tolerance from 1e-12
 *                       to 1
 */
#ifndef CSG_MEASURE_H
#define CSG_MEASURE_H

#include "../../../common/lab/bench.h"
#include "../../../common/lab/report.h"
#include "../../../common/parallel.h"
#include "csg_meshes.h"
#include "csg_survey.h"

/* ---------------------------------------------------------------------------------------------- */

enum { csg_methods = 8, csg_timed = 1024 };

static const struct {
    const char *name;
    csg_hit_function *X_hit;
    double tolerance;
} csg_method[] = {
    {"t > 0, as first.h", csg_hit_front, 0},
    {"planes by points, one by one", csg_hit_points, 0},
    {"the same, tolerance 1e-9", csg_hit_tolerant, 1e-9},
    {"the same, tolerance 0.003", csg_hit_tolerant, 0.003},
    {"spans, planes computed anew", csg_hit_anew, 0},
    {"spans, meshes by themselves", csg_hit_apart, 0},
    {"spans", csg_hit_plain, 0},
    {"spans, bounds: csg_hit", csg_hit, 0}};

typedef struct {
    const csg *c;
    csg_hit_function *X_hit;
    double tolerance;
    ray *r;
    size_t n;  /* of rays: so few that a run ends before the machine turns to others */
} csg_timing;

static double csg_time_run(void *context)
{
    const csg_timing *x = context;
    double sum = 0;
    hit h;
    csg_tolerance = (real)x->tolerance;
    for (size_t i = 0; i < x->n; i++) sum += x->X_hit(x->c, x->r[i], &h) ? (double)h.t : 0;
    return sum;
}

typedef struct {
    csg_sight sight[csg_sights];
    size_t n;
    double wrong[csg_sights][csg_methods];  /* percent */
} csg_survey;

static inline void csg_survey_sight(size_t k, void *context)
{
    csg_survey *y = context;
    const csg_sight *s = &y->sight[k];
    for (size_t i = 0; i < y->n; i++) {
        csg_asked_ray x = csg_sight_asked(s, i);
        for (int m = 0; m < csg_methods; m++) {
            csg_tolerance = (real)csg_method[m].tolerance;
            const csg *c = m == csg_methods - 1 ? &s->scene.c : &s->bare;
            y->wrong[k][m] += csg_is_wrong(c, csg_method[m].X_hit, &x);
        }
    }
    for (int m = 0; m < csg_methods; m++) y->wrong[k][m] *= 100 / (double)y->n;
}

static inline void csg_time_methods(const options *o, const csg_sight *s, double ns[csg_methods])
{
    static ray r[csg_timed];
    csg_timing x[csg_methods];
    bench_candidate b[csg_methods];
    for (size_t i = 0; i < csg_timed; i++) r[i] = csg_sight_ray(s, i);
    for (int m = 0; m < csg_methods; m++) {
        const csg *c = m == csg_methods - 1 ? &s->scene.c : &s->bare;
        x[m] = (csg_timing){c, csg_method[m].X_hit, csg_method[m].tolerance, r, csg_timed};
        b[m] = (bench_candidate){.name = csg_method[m].name, .run = csg_time_run, .context = &x[m]};
    }
    bench_time(b, csg_methods, o->quick ? 3 : 31);
    for (int m = 0; m < csg_methods; m++) ns[m] = b[m].seconds / csg_timed * 1e9;
}

static inline void csg_main_table(const options *o)
{
    csg_survey y = {.n = o->quick ? 100 : 2000};
    double ns[csg_methods];
    for (int k = 0; k < csg_sights; k++)
        y.sight[k] = csg_sight_of((csg_sight_kind)k, o->seed);
    csg_time_methods(o, &y.sight[CSG_OUTSIDE], ns);
    table t = table_new("First hit of a tree: rays that get it wrong, and time",
                        "method|error eye outside [%]|error eye inside [%]|error coincident [%]|"
                        "error mesh faces [%]|error foils [%]|time [ns]");
    parallel_whole(csg_sights, o->threads, "rays", csg_survey_sight, &y);
    for (int m = 0; m < csg_methods; m++) {
        table_text(&t, "%s", csg_method[m].name);
        table_number(&t, y.wrong[CSG_OUTSIDE][m]), table_number(&t, y.wrong[CSG_EYE_INSIDE][m]);
        table_number(&t, (y.wrong[CSG_COINCIDENT][m] + y.wrong[CSG_FAR_AWAY][m]) / 2);
        table_number(&t, y.wrong[CSG_MESH_FACES][m]), table_number(&t, y.wrong[CSG_FOILS][m]);
        table_number(&t, ns[m]);
    }
    output_table(o, &t);
    for (int k = 0; k < csg_sights; k++) csg_sight_free(&y.sight[k]);
}

/* ---- what bounds save ---- */

/* Where ball i of n is: the bits of i halve the cube along x, y, z in turn, chance does the rest:
 * neighbours in number are neighbours in space, and the bounds of pairs of pairs are small. */
static inline vec3 csg_many_place(size_t i, size_t n)
{
    random_stream x = random_start(7, i, 0);
    vec3 at = {0, 0, 0}, half = {1, 1, 1};
    int k = 0;
    for (size_t bit = n / 2; bit > 0; bit /= 2, k = (k + 1) % 3) {
        real h = vaxis(half, k) / 2;
        half = vwith(half, k, h), at = vwith(at, k, vaxis(at, k) + (i & bit ? h : -h));
    }
    return vadd(at, vmul(half, random_in_cube(&x, 1)));
}

/* A plate with n holes in rows of ten, as a chain of differences; or n balls [a power of two] in a
 * cube, in pairs of pairs. The caller frees both arrays. */
static inline csg_model csg_many(size_t n, bool plate)
{
    csg_solid *s = allocate(n + 1, sizeof *s);
    csg_step *step = allocate(2 * n + 2, sizeof *step);
    size_t steps = 0, solids = 0;
    if (plate) {
        s[solids] = csg_box(vec(-1, -1, -0.05), vec(1, 1, 0.05));
        step[steps++] = (csg_step){CSG_SOLID, (uint32_t)solids++};
    }
    for (size_t i = 0; i < n; i++) {
        double u = -0.9 + 0.2 * (double)(i % 10), v = 0.9 - 0.2 * (double)(i / 10 % 10);
        s[solids] = plate ? csg_cylinder(vec(u, v, 0), vec(0, 0, 1), (real)0.07)
            : csg_sphere(csg_many_place(i, n), pow((real)n, (real)(-1 / 3.0)) / 2);
        step[steps++] = (csg_step){CSG_SOLID, (uint32_t)solids++};
        if (plate) step[steps++].what = CSG_DIFFERENCE;
        for (size_t k = i + 1; !plate && k % 2 == 0; k /= 2) step[steps++].what = CSG_UNION;
    }
    return (csg_model){s, solids, step, steps};
}

typedef struct { csg_statistics stats; double asked[2], boxes, ns[2]; } csg_savings;

/* Rays from around (2, 2, 4) to the cube of side 2; without and with bounds. */
static inline csg_savings csg_savings_of(const options *o, csg_model m)
{
    static ray r[csg_timed];
    csg_savings y = {.boxes = 0};
    csg c[2];
    csg_timing x[2];
    size_t few = m.solids > 20 ? 64 : csg_timed;
    bench_candidate b[2];
    failure f;
    hit h;
    for (size_t i = 0; i < csg_timed; i++) {
        random_stream s = random_start(o->seed, i, 99);
        vec3 eye = vadd(vec(1, 1.5, 4), random_in_cube(&s, (real)0.5));
        r[i] = ray_from(eye, vsub(random_in_cube(&s, 1), eye));
    }
    for (int k = 0; k < 2; k++) {
        if (!csg_build(m, (csg_options){k == 0}, &c[k], &f)) fail(f);
        csg_asked.solids = csg_asked.bounds = 0;
        for (size_t i = 0; i < csg_timed; i++) (void)csg_hit(&c[k], r[i], &h);
        y.asked[k] = (double)csg_asked.solids / csg_timed;
        y.boxes = (double)csg_asked.bounds / csg_timed;
        x[k] = (csg_timing){&c[k], csg_hit, 0, r, few};
        b[k] = (bench_candidate){.run = csg_time_run, .context = &x[k]};
    }
    bench_time(b, 2, o->quick ? 3 : m.solids > 2000 ? 9 : 25);
    y.stats = csg_stats(&c[1]);
    for (int k = 0; k < 2; k++) y.ns[k] = b[k].seconds / (double)few * 1e9, csg_free(&c[k]);
    return y;
}

static inline void csg_savings_row(table *t, const char *name, csg_savings y)
{
    table_text(t, "%s", name);
    table_count(t, y.stats.leaves), table_count(t, y.stats.depth);
    table_number(t, y.asked[0]), table_number(t, y.asked[1]), table_number(t, y.boxes);
    table_number(t, y.ns[0]), table_number(t, y.ns[1]);
}

static inline csg_savings csg_savings_many(const options *o, size_t n, bool plate)
{
    csg_model m = csg_many(n, plate);
    csg_savings y = csg_savings_of(o, m);
    free((void *)(uintptr_t)m.solid), free((void *)(uintptr_t)m.step);
    return y;
}

#define CSG_SAVINGS "tree|leaves|depth|solids, no bounds|solids, bounds|boxes|" \
                    "time, no bounds [ns]|time, bounds [ns]"

static inline void csg_savings_table(const options *o)
{
    table t = table_new("Solids that a ray asks, without bounds and with them", CSG_SAVINGS);
    csg_scene s = csg_scene_of(csg_scene_text("classic"));
    csg_savings_row(&t, "classic", csg_savings_of(o, csg_expression_model(&s.e)));
    csg_scene_free(&s);
    csg_savings_row(&t, "plate, 100 holes", csg_savings_many(o, 100, true));
    csg_savings_row(&t, "1024 balls", csg_savings_many(o, 1024, false));
    output_extra_table(o, &t);
}

/* ---- with --full ---- */

static inline void csg_depth_table(const options *o)
{
    static const char *const name[] = {"chain, no bounds", "chain, bounds", "pairs, no bounds",
                                       "pairs, bounds"};
    table t = table_new("Trees of depth 1 to 20: a plate with holes, balls in pairs of pairs",
                        CSG_SAVINGS);
    plot p = plot_new("Solids that a ray asks", "depth of the tree", "solids a ray", PLOT_LOG_Y);
    plot q = plot_new("Time of a ray", "depth of the tree", "time [ns]", PLOT_LOG_Y);
    for (int k = 0; k < 4; k++) (void)plot_series(&p, name[k]), (void)plot_series(&q, name[k]);
    for (int pairs = 0; pairs < 2; pairs++)
        for (size_t depth = 1; depth <= (pairs ? 13 : 20); depth++) {
            csg_savings y = csg_savings_many(o, pairs ? (size_t)1 << depth : depth, !pairs);
            csg_savings_row(&t, pairs ? "balls in pairs" : "plate with holes", y);
            for (int k = 0; k < 2; k++) {
                plot_add(&p, 2 * pairs + k, (double)depth, y.asked[k]);
                plot_add(&q, 2 * pairs + k, (double)depth, y.ns[k]);
            }
        }
    output_extra_table(o, &t);
    output_plot(o, &p, "06_csg_depth.svg"), output_plot(o, &q, "06_csg_time.svg");
}

static inline void csg_tolerance_plot(const options *o)
{
    static const csg_sight_kind kind[3] = {CSG_COINCIDENT, CSG_FAR_AWAY, CSG_FOILS};
    static const char *const name[3] = {"coincident faces", "the same, far away", "foils"};
    table t = table_new("Crossings that count as one: rays that get the first hit wrong [%]",
                        "tolerance|error coincident|error far away|error foils");
    plot p = plot_new("What a tolerance gets wrong", "tolerance", "wrong rays [%]",
                      PLOT_LOG_X | PLOT_LOG_Y);
    csg_sight s[3];
    for (int k = 0; k < 3; k++) s[k] = csg_sight_of(kind[k], o->seed), plot_series(&p, name[k]);
    for (int e = -24; e <= 0; e++) {
        csg_tolerance = pow((real)10, (real)e / 2);
        if (e % 2 == 0) table_text(&t, "%.0e", (double)csg_tolerance);
        for (int k = 0; k < 3; k++) {
            double wrong = csg_wrong(&s[k], csg_hit_tolerant, 1000);
            plot_add(&p, k, (double)csg_tolerance, wrong);
            if (e % 2 == 0) table_number(&t, wrong);
        }
    }
    table_text(&t, "csg_hit");
    for (int k = 0; k < 3; k++) table_number(&t, csg_wrong(&s[k], csg_hit, 1000));
    for (int k = 0; k < 3; k++) csg_sight_free(&s[k]);
    output_extra_table(o, &t);
    output_plot(o, &p, "06_csg_tolerance.svg");
}

static inline void csg_measure(const options *o)
{
    csg_main_table(o);
    csg_savings_table(o);
    if (!o->full) return;
    csg_mesh_table(o);
    csg_depth_table(o);
    csg_tolerance_plot(o);
}

#endif
