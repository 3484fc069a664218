/* measure.h: the tables of this chapter.
 *
 *   measure_relations(o)    every relation: closed form, estimate, standard error, z
 *   measure_estimators(o)   error and time of four estimators; --full: a plot
 */
#ifndef RADIOMETRY_MEASURE_H
#define RADIOMETRY_MEASURE_H

#include "../../../common/lab/bench.h"
#include "../../../common/lab/report.h"
#include "directions.h"

/* ---------------------------------------------------------------------------------------------- */

static inline void measure_relations(const options *o)
{
    const size_t n = 400000;
    table t = table_new("Relations, measured; those with - are wrong, and z shows it",
                        "quantity|unit|closed form|error estimate|error standard|error z");
    for (size_t k = 0; k < relations; k++) {
        const relation r = relation_of(k);
        estimate e = relation_measure(k, o->seed, n);
        double c = r.closed, z = (e.mean - c) / estimate_error(e);
        table_text(&t, "%s", r.name), table_text(&t, "%s", r.unit);
        table_text(&t, "%.5f", c), table_text(&t, "%.5f", e.mean);
        table_number(&t, estimate_error(e)), table_text(&t, "%.1f", z);
    }
    output_extra_table(o, &t);
}

/* ---- error against samples and time ---- */

/* 16, 64 .. 16384 samples; without --full 4096. Four ways of the sphere, four of the square. */
enum { way_levels = 6, way_brief = 4, ways_all = radiometry_lights * direction_ways };
typedef struct {
    const options *o;
    radiometry_light light;
    direction_way by;
    double rms[way_levels];
} radiometry_way;

static inline uint32_t way_samples(int l) { return (uint32_t)16 << (2 * l); }

/* Uniform directions that look for the sphere are what first.h has. */
static inline bool way_is_first(const radiometry_way *w)
{
    return w->light == LIGHT_SPHERE && w->by == BY_HEMISPHERE;
}

static inline double way_estimate(const radiometry_way *w, uint64_t run, uint32_t n)
{
    if (!way_is_first(w)) return direction_estimate(w->light, w->by, w->o->seed, run, n);
    random_stream random = random_start(w->o->seed, run, n);
    return (double)first_mean(first_irradiance_by_directions(lamp, 1, seen_from, seen_up, (int)n,
                                                             &random));
}

static inline void way_job(size_t i, void *context)
{
    radiometry_way *w = (radiometry_way *)context + i;
    double exact = direction_exact(w->light);
    int runs = w->o->quick ? 2 : 64;
    for (int l = 0; l < way_levels; l++) {
        double square = 0;
        if (!w->o->full && l != way_brief) continue;
        for (int run = 0; run < runs; run++) {
            double off = way_estimate(w, (uint64_t)run, way_samples(l)) - exact;
            square += off * off;
        }
        w->rms[l] = sqrt(square / runs) / exact;
    }
}

static inline double run_way(void *context) { return way_estimate(context, 0, 1024); }

static inline void measure_estimators(const options *o)
{
    radiometry_way w[ways_all];
    double us[ways_all];
    table t = table_new("Irradiance of two lights by 4096 samples: error (root mean square, "
                        "relative) and time", "light|samples by|error random|time random [us]");
    plot p = plot_new("Irradiance of the square: error against time", "time [us]", "relative error",
                      PLOT_LOG_X | PLOT_LOG_Y);
    for (int i = 0; i < ways_all; i++)
        w[i] = (radiometry_way){o, (radiometry_light)(i / direction_ways),
                                (direction_way)(i % direction_ways), {0}};
    parallel_whole(ways_all, o->threads, "estimates", way_job, w);
    bench_each(run_way, w, sizeof *w, ways_all, o->quick ? 3 : o->full ? 51 : 15, 1e6 / 1024, us);
    for (int i = 0; i < ways_all; i++) {
        table_text(&t, "%s", radiometry_light_name[w[i].light]);
        table_text(&t, "%s", way_is_first(&w[i]) ? "first, hemisphere" : direction_name[w[i].by]);
        table_number(&t, w[i].rms[way_brief]), table_number(&t, us[i] * way_samples(way_brief));
        if (w[i].light == LIGHT_SPHERE) continue;
        int series = plot_series(&p, direction_name[w[i].by]);
        for (int l = 0; l < way_levels; l++)
            plot_add(&p, series, us[i] * way_samples(l), w[i].rms[l]);
    }
    plot_slope(&p, -0.5, "slope -1/2");
    output_table(o, &t);
    if (o->full) output_plot(o, &p, "22_radiometry_time.svg");
    else plot_free(&p);
}

#endif
