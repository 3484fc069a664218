/* implicit_measure.h: the tables and plots of this chapter.
 *
 *   implicit_measure(&o)    grazing rays at a torus: the main table; with --full rays anywhere,
 *                           Barth's sextic, and the plot
 */
#ifndef IMPLICIT_MEASURE_H
#define IMPLICIT_MEASURE_H

#include "../../../common/lab/bench.h"
#include "../../../common/lab/report.h"
#include "implicit_trials.h"

/* ---------------------------------------------------------------------------------------------- */

typedef struct { const char *name; implicit_how how; } implicit_row;

/* Sphere tracing asks the distance of a torus, the others its quartic: the same surface. */
static const implicit_row implicit_torus_rows[] = {
    {"first, 32 steps", {IMPLICIT_FIRST, 32, 0}}, {"first, 128 steps", {IMPLICIT_FIRST, 128, 0}},
    {"first, 512 steps", {IMPLICIT_FIRST, 512, 0}}, {"Newton, 32 steps", {IMPLICIT_NEWTON, 32, 0}},
    {"sphere tracing, eps 1e-2", {IMPLICIT_TRACE, 4096, (real)1e-2}},
    {"sphere tracing, eps 1e-4", {IMPLICIT_TRACE, 4096, (real)1e-4}},
    {"the same, 64 steps at most", {IMPLICIT_TRACE, 64, (real)1e-4}},
    {"intervals", {IMPLICIT_INTERVAL, 0, 0}}};
static const implicit_row implicit_barth_rows[] = {
    {"first, 128 steps", {IMPLICIT_FIRST, 128, 0}}, {"Newton, 32 steps", {IMPLICIT_NEWTON, 32, 0}},
    {"sphere tracing, eps 1e-6", {IMPLICIT_TRACE, 4096, (real)1e-6}},
    {"intervals", {IMPLICIT_INTERVAL, 0, 0}}};
enum { implicit_most_rows = 8, implicit_timed = 128 };

typedef struct { implicit_subject u; implicit_how how; ray r[implicit_timed]; } implicit_timing;

static inline double implicit_time_rays(void *context)
{
    const implicit_timing *t = context;
    double sum = 0;
    for (int i = 0; i < implicit_timed; i++) {
        hit h = hit_none;
        if (implicit_method_hit(t->how, &t->u.s, t->r[i], &h)) sum += (double)h.t;
    }
    return sum;
}

/* `n` rays of each row, and [ns] of a ray, side by side. */
static inline table implicit_table(const options *o, const char *title, implicit_name surface,
                                   const implicit_row *row, int rows, implicit_aim aim, size_t n)
{
    double ns[implicit_most_rows];
    implicit_timing *w = allocate((size_t)rows, sizeof *w);
    for (int k = 0; k < rows; k++) {
        bool tube = surface == IMPLICIT_TORUS && row[k].how.kind == IMPLICIT_TRACE;
        w[k].u = implicit_subject_of(tube ? IMPLICIT_TUBE : surface), w[k].how = row[k].how;
        for (size_t i = 0; i < implicit_timed; i++)
            implicit_shot(&w[k].u, o->seed + 1, aim, i, &w[k].r[i]);
    }
    bench_each(implicit_time_rays, w, sizeof *w, rows, o->quick ? 1 : o->full ? 25 : 5,
               1e9 / implicit_timed, ns);
    table t = table_new(title, "method|error missed [%]|error made up [%]|error of t [B]|"
                               "evaluations a ray|time [ns]");
    for (int k = 0; k < rows; k++) {
        implicit_survey y = implicit_survey_of(&w[k].u, row[k].how, o->seed, aim,
                                               o->quick ? 500 : n, o->threads);
        table_text(&t, "%s", row[k].name);
        table_number(&t, y.missed), table_number(&t, y.made_up), table_number(&t, y.off);
        table_number(&t, y.calls), table_number(&t, ns[k]);
    }
    free(w);
    return t;
}

/* Wrong answers against what they cost: steps, tolerances, and intervals, which have no knob. */
static inline void implicit_plot_missed(const options *o)
{
    static const struct { const char *name; implicit_name surface; implicit_kind kind; } line[] = {
        {"first", IMPLICIT_TORUS, IMPLICIT_FIRST}, {"Newton", IMPLICIT_TORUS, IMPLICIT_NEWTON},
        {"sphere tracing, fewer steps", IMPLICIT_TUBE, IMPLICIT_TRACE},
        {"sphere tracing, larger eps", IMPLICIT_TUBE, IMPLICIT_TRACE},
        {"intervals", IMPLICIT_TORUS, IMPLICIT_INTERVAL}};
    plot p = plot_new("Grazing rays at a torus: wrong answers", "evaluations a ray", "wrong [%]",
                      PLOT_LOG_X | PLOT_LOG_Y);
    const size_t n = o->quick ? 500 : 20000;
    for (int k = 0; k < 5; k++) {
        int series = plot_series(&p, line[k].name);
        implicit_subject u = implicit_subject_of(line[k].surface);
        bool traced = line[k].kind == IMPLICIT_TRACE;
        for (int knob = 0; knob < (line[k].kind == IMPLICIT_INTERVAL ? 1 : 8); knob++) {
            implicit_how how = {line[k].kind, k == 2 ? 8 << knob : traced ? 4096 : 4 << knob,
                                k == 2 ? (real)1e-4 : pow((real)10, -(real)knob / 2 - 1)};
            implicit_survey y = implicit_survey_of(&u, how, o->seed, IMPLICIT_GRAZING, n,
                                                   o->threads);
            plot_add(&p, series, y.calls, y.missed + y.made_up);
        }
    }
    output_plot(o, &p, "05_implicit_wrong.svg");
}

static inline void implicit_measure(const options *o)
{
    table t = implicit_table(o, "A torus, grazing rays: what is missed, what is made up, and what "
                                "it costs", IMPLICIT_TORUS, implicit_torus_rows, 8,
                             IMPLICIT_GRAZING, 4000);
    output_table(o, &t);
    if (!o->full) return;
    t = implicit_table(o, "A torus, rays anywhere", IMPLICIT_TORUS, implicit_torus_rows, 8,
                       IMPLICIT_ANYWHERE, 100000);
    output_extra_table(o, &t);
    t = implicit_table(o, "Barth's sextic, grazing rays", IMPLICIT_BARTH, implicit_barth_rows, 4,
                       IMPLICIT_GRAZING, 20000);
    output_extra_table(o, &t);
    if (!getenv("BENCH_ONCE")) implicit_plot_missed(o);  /* bench.h: only tables are asked for */
}

#endif
