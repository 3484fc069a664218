/* measure.h: the tables of this chapter.
 *
 *   measure_relations(o)    every relation: closed form, estimate, standard error, z
 *   measure_view(o)         areas of the picture of view.h, counted in pixels
 *   measure_ways(o)         error of four estimators against samples and time; plots
 *   measure_photometry(o)   lights in watts and in lumens
 */
#ifndef MEASURE_22_H
#define MEASURE_22_H

#include "../../../common/lab/report.h"
#include "directions.h"
#include "../photometry.h"
#include "view.h"

/* ---------------------------------------------------------------------------------------------- */

static inline void measure_relations(const options *o)
{
    size_t n = o->quick ? 20000 : 400000;
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

static inline void measure_view(const options *o)
{
    int n = o->quick ? 200 : 1000;
    double area[view_maps][view_things];
    for (int m = 0; m < view_maps; m++) view_count((view_map)m, n, area[m]);
    char title[80];
    snprintf(title, sizeof title, "What a point sees: pixels counted, of %d x %d", n, n);
    table t = table_new(title,
                        "thing|solid angle [sr]|"
                        "error counted [sr]|irradiance [W/m^2]|error counted [W/m^2]");
    for (int k = 0; k < view_things; k++) {
        table_text(&t, "%s", view_name[k]);
        for (int m = 0; m < view_maps; m++) {
            double closed = view_closed((view_map)m, k);
            table_text(&t, isnan(closed) ? "-" : "%.5f", closed);
            table_text(&t, "%.5f", area[m][k]);
        }
    }
    output_extra_table(o, &t);
}

/* ---- error against samples and time ---- */

enum { levels = 6 };
typedef struct { light_kind light; way by; sequence_kind kind; uint64_t seed; } timed_way;
typedef struct { timed_way what; int runs; double rms[levels]; } way_errors;

static inline uint32_t level_n(int l) { return (uint32_t)16 << (2 * l); }  /* 16 ... 16384 */

/* One way more: first.h's, of a sphere and by random numbers only. */
static inline bool is_first(way by) { return by == ways; }

static inline double way_estimate(const timed_way *w, uint64_t run, uint32_t n)
{
    if (!is_first(w->by)) return direction_estimate(w->light, w->by, w->kind, w->seed, run, n);
    random_stream random = random_start(w->seed, run, n);
    return (double)first_mean(first_irradiance_by_directions(lamp, 1, seen_from, seen_up, (int)n,
                                                             &random));
}

static inline void way_job(size_t i, void *context)
{
    way_errors *e = (way_errors *)context + i;
    double exact = direction_exact(e->what.light);
    for (int l = 0; l < levels; l++) {
        double square = 0;
        for (int run = 0; run < e->runs; run++) {
            double off = way_estimate(&e->what, (uint64_t)run, level_n(l)) - exact;
            square += off * off;
        }
        e->rms[l] = sqrt(square / e->runs) / exact;
    }
}

static inline double run_way(void *context)
{
    return way_estimate(context, 0, 1024);
}

/* Row k of the table: the sphere's ways and first.h's, then those of the square. */
enum { sphere_rows = ways + 1, way_rows = sphere_rows + ways };
static inline timed_way way_of_row(int k, sequence_kind kind, uint64_t seed)
{
    bool square = k >= sphere_rows;
    return (timed_way){square ? LIGHT_SQUARE : LIGHT_SPHERE, (way)(square ? k - sphere_rows : k),
                       kind, seed};
}

static inline void way_cells(table *t, const way_errors *e, double seconds, int l)
{
    bool none = is_first(e->what.by) && e->what.kind != SEQUENCE_RANDOM;
    if (none) table_text(t, "-"), table_text(t, "-");
    else table_number(t, e->rms[l]), table_number(t, seconds / 1024 * level_n(l) * 1e6);
}

/* Of each row random, then Sobol'. */
static inline void measure_ways(const options *o)
{
    enum { all = 2 * way_rows, square = 2 * sphere_rows };
    int runs = o->quick ? 2 : 64;
    way_errors e[all];
    clock_variant clock[all];
    for (int i = 0; i < all; i++) {
        e[i] = (way_errors){way_of_row(i / 2, i % 2 ? SEQUENCE_SOBOL : SEQUENCE_RANDOM, o->seed),
                            runs, {0}};
        clock[i] = (clock_variant){"", run_way, &e[i].what, 0};
    }
    parallel_for(all, o->threads, "estimates", way_job, e);
    clock_compare(clock, square, o->quick ? 3 : 51);
    clock_compare(clock + square, all - square, o->quick ? 3 : 51);
    char title[120];
    snprintf(title, sizeof title, "Irradiance of two lights: error (root mean square over %d runs, "
                                  "relative) and time", runs);
    table t = table_new(title, "light|samples by|N|error random|time random [us]|error Sobol'|"
                               "time Sobol' [us]");
    for (int i = 0; i < all; i += 2)
        for (int l = 0; l < levels; l += 2) {
            way by = e[i].what.by;
            table_text(&t, "%s", light_name[e[i].what.light]);
            table_text(&t, "%s", is_first(by) ? "first" : way_name[by]);
            table_count(&t, level_n(l));
            for (int k = 0; k < 2; k++) way_cells(&t, &e[i + k], clock[i + k].seconds, l);
        }
    output_table(o, &t);
    plot n = plot_new("Irradiance of the square: error against samples", "N", "relative error",
                      PLOT_LOG_X | PLOT_LOG_Y);
    plot time = plot_new("Irradiance of the square: error against time", "time [us]",
                         "relative error", PLOT_LOG_X | PLOT_LOG_Y);
    for (int i = square; i < all; i++) {
        char name[64];
        snprintf(name, sizeof name, "%s%s", way_name[e[i].what.by], i % 2 ? ", Sobol'" : "");
        int a = plot_series(&n, name), b = plot_series(&time, name);
        for (int l = 0; l < levels; l++) {
            plot_add(&n, a, level_n(l), e[i].rms[l]);
            plot_add(&time, b, clock[i].seconds / 1024 * level_n(l) * 1e6, e[i].rms[l]);
        }
    }
    plot_slope(&n, -0.5, "slope -1/2"), plot_slope(&time, -0.5, "slope -1/2");
    output_plot(o, &n, "22_radiometry_error.svg");
    output_plot(o, &time, "22_radiometry_time.svg");
}

/* ---- watts and lumens ---- */

static inline void photometry_row(table *t, const char *what, double efficacy, double watts,
                                  const char *unit, const char *photometric)
{
    table_text(t, "%s", what), table_number(t, efficacy), table_number(t, watts);
    table_text(t, "%s", unit), table_number(t, watts * efficacy), table_text(t, "%s", photometric);
}

static inline void measure_photometry(const options *o)
{
    double worst = 0;
    for (int i = 0; i < efficiencies; i++) {
        double nm = efficiency_first + efficiency_step * i;
        double off = fabs(luminous_efficiency_fit(nm) - efficiency_table[i]);
        if (off > worst) worst = off;
    }
    black_body_light lamp_2800 = black_body(2800), sun = black_body(5772);
    black_body_light platinum = black_body(2041.4);
    double disk = (double)pi / 4 * 0.00930 * 0.00930;  /* the sun's disk: 0.00930 rad wide */
    char title[160];
    snprintf(title, sizeof title,
             "The same light in watts and in lumens (the fit of V is off by at "
             "most %.4f)",
             worst);
    table t = table_new(title, "light|efficacy [lm/W]|radiometric|unit|photometric|unit ");
    double k555 = lumens_per_watt * luminous_efficiency(555);
    photometry_row(&t, "1 W at 555 nm", k555, 1, "W", "lm");
    photometry_row(&t, "1 W at 650 nm", lumens_per_watt * luminous_efficiency(650), 1, "W", "lm");
    photometry_row(&t, "glowing wire, 2800 K: flux", lamp_2800.efficacy, 60, "W", "lm");
    photometry_row(&t, "- intensity, the same all round", lamp_2800.efficacy, 60 / four_pi(),
                   "W/sr", "cd");
    photometry_row(&t, "- irradiance at 2 m", lamp_2800.efficacy, 60 / four_pi() / 4, "W/m^2",
                   "lx");
    photometry_row(&t, "- radiance of the wire", lamp_2800.efficacy, lamp_2800.radiance,
                   "W/(m^2 sr)", "nit");
    photometry_row(&t, "platinum freezing, 2041.4 K", platinum.efficacy, platinum.radiance,
                   "W/(m^2 sr)", "nit");
    photometry_row(&t, "sun, 5772 K: radiance", sun.efficacy, sun.radiance, "W/(m^2 sr)", "nit");
    photometry_row(&t, "- irradiance above the air", sun.efficacy, sun.radiance * disk, "W/m^2",
                   "lx");
    black_body_light best = black_body(6640);  /* found by a search in the tests */
    photometry_row(&t, "best black body, 6640 K: radiance", best.efficacy, best.radiance,
                   "W/(m^2 sr)", "nit");
    output_extra_table(o, &t);
}

#endif
