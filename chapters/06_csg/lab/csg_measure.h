/* csg_measure.h: the tables and plots of this chapter.
 *
 *   csg_main_table(&o)       what each way gets wrong, and its time
 *   csg_savings_table(&o)    how many solids a ray asks
 *   csg_tolerance_plot(&o)   tolerances from 1e-12 to 1
 */
#ifndef CSG_MEASURE_H
#define CSG_MEASURE_H

#include "../../../common/lab/bench.h"
#include "../../../common/lab/report.h"
#include "csg_survey.h"

/* ---------------------------------------------------------------------------------------------- */

enum { csg_methods = 6, csg_timed = 1024 };

static const struct {
    const char *name;
    csg_hit_function *X_hit;
    double tolerance;
} csg_method[] = {
    {"t > 0, as first.h", csg_hit_front, 0},
    {"planes by points, one by one", csg_hit_points, 0},
    {"the same, tolerance 1e-9", csg_hit_tolerant, 1e-9},
    {"the same, tolerance 0.003", csg_hit_tolerant, 0.003},
    {"spans", csg_hit, 0},
    {"spans, bounds: csg_hit", csg_hit, 0}};

static inline int csg_rounds(const options *o) { return o->quick ? 3 : o->full ? 31 : 9; }

typedef struct { const csg *c; int method; ray *r; size_t n; } csg_timing;

static double csg_time_run(void *context)
{
    const csg_timing *x = context;
    double sum = 0;
    hit h;
    csg_tolerance = (real)csg_method[x->method].tolerance;
    for (size_t i = 0; i < x->n; i++)
        sum += csg_method[x->method].X_hit(x->c, x->r[i], &h) ? (double)h.t : 0;
    return sum;
}

typedef struct { csg_sight sight[csg_sights]; size_t n; double wrong[csg_methods][csg_sights]; }
    csg_survey;

/* What is due is asked once for all methods: it takes longer than they do. */
static inline void csg_survey_sight(size_t k, void *context)
{
    csg_survey *y = context;
    for (size_t i = 0; i < y->n; i++) {
        csg_due d = csg_due_of(&y->sight[k], i);
        for (int m = 0; m < csg_methods; m++) {
            csg_tolerance = (real)csg_method[m].tolerance;
            y->wrong[m][k] += csg_errs(&y->sight[k], &d, csg_method[m].X_hit, m < csg_methods - 1);
        }
    }
}

static inline void csg_main_table(const options *o)
{
    static const csg_sight_kind shown[] = {CSG_OUTSIDE, CSG_EYE_INSIDE, CSG_COINCIDENT,
                                           CSG_FAR_AWAY, CSG_FOILS};
    csg_survey y = {.n = o->quick ? 100 : 2000};
    static ray r[csg_timed];
    csg_timing x[csg_methods];
    double ns[csg_methods];
    for (int k = 0; k < 5; k++) y.sight[k] = csg_sight_of(shown[k], o->seed);
    csg c = y.sight[0].scene.c, bare = c;
    bare.no_bounds = true;
    for (size_t i = 0; i < csg_timed; i++) r[i] = csg_sight_ray(&y.sight[0], i);
    for (int m = 0; m < csg_methods; m++)
        x[m] = (csg_timing){m < csg_methods - 1 ? &bare : &c, m, r, csg_timed};
    bench_each(csg_time_run, x, sizeof *x, csg_methods, csg_rounds(o), 1e9 / csg_timed, ns);
    table t = table_new("First hit of a tree: rays that get it wrong, and time",
                        "method|error eye outside [%]|error eye inside [%]|error coincident [%]|"
                        "error foils [%]|time [ns]");
    parallel_whole(5, o->threads, "rays", csg_survey_sight, &y);
    for (int m = 0; m < csg_methods; m++) {
        const double *wrong = y.wrong[m], percent = 100 / (double)y.n;
        table_text(&t, "%s", csg_method[m].name);
        table_number(&t, percent * wrong[0]), table_number(&t, percent * wrong[1]);
        table_number(&t, percent * (wrong[2] + wrong[3]) / 2);
        table_number(&t, percent * wrong[4]), table_number(&t, ns[m]);
    }
    output_table(o, &t);
    for (int k = 0; k < 5; k++) csg_scene_free(&y.sight[k].scene);
}

/* ---- what bounds save ---- */

/* n balls [a power of two] in a cube, in pairs of pairs. The bits of i halve the cube along x, y, z
 * in turn, chance does the rest: neighbours in number are neighbours in space, and the bounds of
 * pairs of pairs are small. */
static inline csg_expression csg_balls(size_t n)
{
    csg_expression e = {.solids = n};
    e.solid = allocate(n, sizeof *e.solid), e.step = allocate(2 * n, sizeof *e.step);
    for (size_t i = 0; i < n; i++) {
        random_stream x = random_start(7, i, 0);
        vec3 at = {0, 0, 0}, half = {1, 1, 1};
        int k = 0;
        for (size_t bit = n / 2; bit > 0; bit /= 2, k = (k + 1) % 3) {
            real h = vaxis(half, k) / 2;
            half = vwith(half, k, h), at = vwith(at, k, vaxis(at, k) + (i & bit ? h : -h));
        }
        e.solid[i] = csg_sphere(vadd(at, vmul(half, random_in_cube(&x, 1))),
                                pow((real)n, (real)(-1 / 3.0)) / 2);
        e.step[e.steps++] = (csg_step){CSG_SOLID, (uint32_t)i};
        for (size_t j = i + 1; j % 2 == 0; j /= 2) e.step[e.steps++].what = CSG_UNION;
    }
    return e;
}

/* Rays from around (1, 1.5, 4) to the cube of side 2; without and with bounds. */
static inline void csg_savings_table(const options *o)
{
    static ray r[csg_timed];
    table t = table_new("Solids of 1024 balls that a ray asks", "tree|solids|boxes|time [ns]");
    csg_scene balls = csg_scene_built(csg_balls(1024));
    csg c[2] = {balls.c, balls.c};
    csg_timing x[2];
    double ns[2];
    const size_t few = 64;
    hit h;
    for (size_t i = 0; i < csg_timed; i++) {
        random_stream s = random_start(o->seed, i, 99);
        vec3 eye = vadd(vec(1, 1.5, 4), random_in_cube(&s, (real)0.5));
        r[i] = ray_from(eye, vsub(random_in_cube(&s, 1), eye));
    }
    c[0].no_bounds = true;
    for (int k = 0; k < 2; k++) x[k] = (csg_timing){&c[k], csg_methods - 1, r, few};
    bench_each(csg_time_run, x, sizeof *x, 2, csg_rounds(o), 1e9 / (double)few, ns);
    for (int k = 0; k < 2; k++) {
        csg_asked.solids = csg_asked.bounds = 0;
        for (size_t i = 0; i < csg_timed; i++) (void)csg_hit(&c[k], r[i], &h);
        table_text(&t, k ? "with bounds" : "no bounds");
        table_number(&t, (double)csg_asked.solids / csg_timed);
        table_number(&t, (double)csg_asked.bounds / csg_timed), table_number(&t, ns[k]);
    }
    csg_scene_free(&balls);
    output_extra_table(o, &t);
}

/* ---- with --full ---- */

static inline void csg_tolerance_plot(const options *o)
{
    static const csg_sight_kind kind[3] = {CSG_COINCIDENT, CSG_FAR_AWAY, CSG_FOILS};
    static const char *const name[3] = {"coincident faces", "the same, far away", "foils"};
    plot p = plot_new("What a tolerance gets wrong", "tolerance", "wrong rays [%]",
                      PLOT_LOG_X | PLOT_LOG_Y);
    for (int k = 0; k < 3; k++) {
        csg_sight s = csg_sight_of(kind[k], o->seed);
        plot_series(&p, name[k]);
        for (int e = -24; e <= 0; e++) {
            csg_tolerance = pow((real)10, (real)e / 2);
            plot_add(&p, k, (double)csg_tolerance, csg_wrong(&s, csg_hit_tolerant, true, 1000));
        }
        csg_scene_free(&s.scene);
    }
    output_plot(o, &p, "06_csg_tolerance.svg");
}

#endif
