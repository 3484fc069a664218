/* csg_measure.h: the tables and plots of this chapter.
 *
 *   csg_main_table(&o)       what each way gets wrong, and its time
 *   csg_tolerance_plot(&o)   tolerances from 1e-12 to 1
 */
#ifndef CSG_MEASURE_H
#define CSG_MEASURE_H

#include "../../../common/lab/bench.h"
#include "../../../common/lab/report.h"
#include "csg_survey.h"

/* ---------------------------------------------------------------------------------------------- */

enum { csg_methods = 6, csg_timed = 1024 };

static const char *const csg_method[csg_methods] = {
    "t > 0, as first.h", "planes by points, one by one", "the same, tolerance 1e-9",
    "the same, tolerance 0.003", "spans", "spans, bounds: csg_hit"};
static const csg_way csg_method_way[csg_methods] = {
    {csg_hit_front, 0, true}, {csg_hit_tolerant, -1, true}, {csg_hit_tolerant, 1e-9, true},
    {csg_hit_tolerant, 0.003, true}, {csg_hit, 0, true}, {csg_hit, 0, false}};

typedef struct { const csg *c; csg_way way; const ray *r; } csg_timing;

static double csg_time_run(void *context)
{
    const csg_timing *x = context;
    double sum = 0;
    hit h;
    csg_tolerance = (real)x->way.tolerance;
    for (size_t i = 0; i < csg_timed; i++)
        sum += x->way.X_hit(x->c, x->r[i], &h) ? (double)h.t : 0;
    return sum;
}

typedef struct { csg_sight sight[csg_sights]; size_t n; double wrong[csg_sights][csg_methods]; }
    csg_survey;

static inline void csg_survey_sight(size_t k, void *context)
{
    csg_survey *y = context;
    csg_wrong(&y->sight[k], csg_method_way, csg_methods, y->n, y->wrong[k]);
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
        x[m] = (csg_timing){csg_method_way[m].bare ? &bare : &c, csg_method_way[m], r};
    bench_each(csg_time_run, x, sizeof *x, csg_methods, o->quick ? 3 : o->full ? 31 : 9,
               1e9 / csg_timed, ns);
    table t = table_new("First hit of a tree: rays that get it wrong, and time",
                        "method|error eye outside [%]|error eye inside [%]|error coincident [%]|"
                        "error foils [%]|time [ns]");
    parallel_whole(5, o->threads, "rays", csg_survey_sight, &y);
    for (int m = 0; m < csg_methods; m++) {
        table_text(&t, "%s", csg_method[m]);
        table_number(&t, y.wrong[0][m]), table_number(&t, y.wrong[1][m]);
        table_number(&t, (y.wrong[2][m] + y.wrong[3][m]) / 2);
        table_number(&t, y.wrong[4][m]), table_number(&t, ns[m]);
    }
    output_table(o, &t);
    for (int k = 0; k < 5; k++) csg_scene_free(&y.sight[k].scene);
}

static inline void csg_tolerance_plot(const options *o)
{
    static const csg_sight_kind kind[3] = {CSG_COINCIDENT, CSG_FAR_AWAY, CSG_FOILS};
    static const char *const name[3] = {"coincident faces", "the same, far away", "foils"};
    plot p = plot_new("What a tolerance gets wrong", "tolerance", "wrong rays [%]",
                      PLOT_LOG_X | PLOT_LOG_Y);
    for (int k = 0; k < 3; k++) {
        csg_sight s = csg_sight_of(kind[k], o->seed);
        csg_way way[25];
        double wrong[25];
        plot_series(&p, name[k]);
        for (int e = 0; e < 25; e++)
            way[e] = (csg_way){csg_hit_tolerant, (double)pow((real)10, (real)e / 2 - 12), true};
        csg_wrong(&s, way, 25, 1000, wrong);
        for (int e = 0; e < 25; e++) plot_add(&p, k, way[e].tolerance, wrong[e]);
        csg_scene_free(&s.scene);
    }
    output_plot(o, &p, "06_csg_tolerance.svg");
}

#endif
