/* measure.h: the tables of this chapter.
 *
 *   measure_relations(o)    every relation: closed form, estimate, standard error, z
 *   measure_ways(o)         error and time of four estimators; --full: a plot
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
        const relation *r = &relation_list[k];
        estimate e = relation_measure(k, o->seed, n);
        double c = r->closed(), z = (e.mean - c) / estimate_error(e);
        table_text(&t, "%s", r->name), table_text(&t, "%s", r->unit);
        table_text(&t, "%.5f", c), table_text(&t, "%.5f", e.mean);
        table_number(&t, estimate_error(e)), table_text(&t, "%.1f", z);
    }
    output_extra_table(o, &t);
}

/* ---- error against samples and time ---- */

enum { way_levels = 6, way_brief = 4 };  /* 16, 64 .. 16384 samples; without --full 4096 */
typedef struct {
    radiometry_light light;
    direction_way by;           /* direction_ways: as first.h does, of the sphere, at random */
    sequence_kind kind;
    uint64_t seed;
} radiometry_timed;
typedef struct {
    radiometry_timed what;
    int runs;
    bool full;
    double rms[way_levels];
} radiometry_errors;

static inline uint32_t way_samples(int l) { return (uint32_t)16 << (2 * l); }

static inline double way_estimate(const radiometry_timed *w, uint64_t run, uint32_t n)
{
    if (w->by != direction_ways)
        return direction_estimate(w->light, w->by, w->kind, w->seed, run, n);
    random_stream random = random_start(w->seed, run, n);
    return (double)first_mean(first_irradiance_by_directions(lamp, 1, seen_from, seen_up, (int)n,
                                                             &random));
}

static inline void way_job(size_t i, void *context)
{
    radiometry_errors *e = (radiometry_errors *)context + i;
    double exact = direction_exact(e->what.light);
    for (int l = 0; l < way_levels; l++) {
        double square = 0;
        if (!e->full && l != way_brief) continue;
        for (int run = 0; run < e->runs; run++) {
            double off = way_estimate(&e->what, (uint64_t)run, way_samples(l)) - exact;
            square += off * off;
        }
        e->rms[l] = sqrt(square / e->runs) / exact;
    }
}

static inline double run_way(void *context) { return way_estimate(context, 0, 1024); }

/* Row k of the table: the sphere's ways and first.h's, then those of the square. */
enum { sphere_rows = direction_ways + 1, way_rows = sphere_rows + direction_ways };
static inline radiometry_timed way_of_row(int k, sequence_kind kind, uint64_t seed)
{
    bool square = k >= sphere_rows;
    return (radiometry_timed){square ? LIGHT_SQUARE : LIGHT_SPHERE,
                       (direction_way)(square ? k - sphere_rows : k), kind, seed};
}

/* Of the square, each way by random numbers, then by Sobol's. */
static inline void ways_plot(const options *o, const radiometry_errors *e,
                             const bench_candidate *clock)
{
    plot p = plot_new("Irradiance of the square: error against time", "time [us]", "relative error",
                      PLOT_LOG_X | PLOT_LOG_Y);
    for (int i = 2 * sphere_rows; i < 2 * way_rows; i++) {
        char name[64];
        snprintf(name, sizeof name, "%s%s", direction_name[e[i].what.by], i % 2 ? ", Sobol'" : "");
        int series = plot_series(&p, name);
        for (int l = 0; l < way_levels; l++)
            plot_add(&p, series, clock[i].seconds / 1024 * way_samples(l) * 1e6, e[i].rms[l]);
    }
    plot_slope(&p, -0.5, "slope -1/2");
    output_plot(o, &p, "22_radiometry_time.svg");
}

/* The rows of two lights. */
static inline table ways_table(const char *title, const radiometry_errors *e,
                               const bench_candidate *clock)
{
    table t = table_new(title, "light|samples by|N|error random|time random [us]|error Sobol'|"
                               "time Sobol' [us]");
    int l = way_brief;
    for (int i = 0; i < 2 * way_rows; i += 2) {
        bool first = e[i].what.by == direction_ways;
        table_text(&t, "%s", radiometry_light_name[e[i].what.light]);
        table_text(&t, "%s", first ? "first" : direction_name[e[i].what.by]);
        table_count(&t, way_samples(l));
        for (int k = i; k < i + 2; k++)
            if (first && k > i) table_text(&t, "-"), table_text(&t, "-");
            else table_number(&t, e[k].rms[l]),
                 table_number(&t, clock[k].seconds / 1024 * way_samples(l) * 1e6);
    }
    return t;
}

static inline void measure_ways(const options *o)
{
    enum { all = 2 * way_rows };
    int runs = o->quick ? 2 : 64;
    radiometry_errors e[all];
    bench_candidate clock[all];
    for (int i = 0; i < all; i++) {
        sequence_kind kind = i % 2 ? SEQUENCE_SOBOL : SEQUENCE_RANDOM;
        e[i] = (radiometry_errors){way_of_row(i / 2, kind, o->seed), runs, o->full, {0}};
        clock[i] = (bench_candidate){.run = run_way, .context = &e[i].what};
    }
    parallel_whole(all, o->threads, "estimates", way_job, e);
    bench_time(clock, all, o->quick ? 3 : o->full ? 51 : 15);
    char title[120];
    snprintf(title, sizeof title, "Irradiance of two lights by 4096 samples: error (root mean "
             "square over %d runs, relative) and time", runs);
    table t = ways_table(title, e, clock);
    output_table(o, &t);
    if (o->full) ways_plot(o, e, clock);
}

#endif
