/* measure.h: the reflection equation, error against samples against time.
 *
 *   measure_glossy(&o)   main table of a glossy surface, five ways to integrate; with --full at all
 *                        levels, and that of first.h, which sees a window, six ways; a plot
 *   measure_furnace(&o)  what GGX keeps of a white sky: roughness against angle
 */
#ifndef BRDF_MEASURE_H
#define BRDF_MEASURE_H

#include "../../../common/lab/bench.h"
#include "../../../common/lab/report.h"
#include "../../../common/parallel.h"
#include "../first.h"
#include "reference.h"

enum { GLOSSY, WINDOW, surfaces };  /* the last reflects the window of first.h, no sky */
enum { FIRST = 5, methods, levels = 5, brief_level = 2 };  /* without --full that one */
static const char *const surface_name[surfaces] = {"GGX .25", "window"};
static const char *const method_name[methods] = {"grid", "uniform", "cosine", "BRDF",
                                                 "BRDF, Sobol'", "first"};

/* ---------------------------------------------------------------------------------------------- */

static const first_brdf window_brdf = {{0.12, 0.04, 0.02}, {0.75, 0.6, 0.4}, 64};

static inline brdf surface_brdf(int surface)
{
    return surface == GLOSSY ? brdf_ggx((vec3){1, 1, 1}, (real)0.25)
                             : brdf_blinn_phong(window_brdf.kd, window_brdf.ks, window_brdf.e);
}

static inline uint32_t level_samples(int level) { return (uint32_t)16 << 2 * level; }

/* A sky without edges: brighter overhead, with a glow 40 degrees wide. */
static inline vec3 glowing_sky(vec3 w)
{
    real c = vdot(w, vunit(vec(0.5, 0.5, 1)));
    real l = (1 + w.z) / 2 + 4 * exp(20 * (c - 1));
    return (vec3){l, l, l};
}

static const vec3 upright = {0, 0, 1};
static inline incident_light *surface_light(int surface)
{
    return surface == WINDOW ? first_room_light : glowing_sky;
}

/* At 45 degrees; at WINDOW from where the window is seen mirrored. */
static inline vec3 surface_view(int surface)
{
    return vunit(surface == WINDOW ? vec(-0.2, -0.5, 0.85) : vec(-1, 0, 1));
}

/* Within 1e-6, that of the window within 1e-5. */
static inline double surface_exact(int surface)
{
    brdf b = surface_brdf(surface);
    reflection r = {DIRECTIONS_UNIFORM, false, 0};
    vec3 wo = surface_view(surface);
    incident_light *light = surface_light(surface);
    return (double)(surface == GLOSSY ? reflection_reference(&b, upright, wo, light)
                                      : reflection_grid(&r, &b, upright, wo, light, 4000)).x;
}

/* A row of the tables, at all levels. */
typedef struct {
    int surface, method;
    const options *o;
    double exact, error[levels], asked[levels];
} brdf_row;

/* Of the surfaces only what is asked for; and first.h knows no light but its own. */
static inline int brdf_rows(const options *o, brdf_row row[surfaces * methods])
{
    int n = 0;
    for (int f = 0; f < surfaces; f++) {
        double exact = o->full || f == GLOSSY ? surface_exact(f) : 0;
        for (int m = 0; m < methods; m++)
            if ((o->full || f == GLOSSY) && (m != FIRST || f == WINDOW))
                row[n++] = (brdf_row){f, m, o, exact, {0}, {0}};
    }
    return n;
}

static inline double row_run(const brdf_row *w, reflection *r, int level, uint64_t run)
{
    static const direction_choice choice[FIRST] = {
        DIRECTIONS_UNIFORM, DIRECTIONS_UNIFORM, DIRECTIONS_COSINE, DIRECTIONS_BRDF,
        DIRECTIONS_BRDF};
    brdf b = surface_brdf(w->surface);
    uint32_t n = level_samples(level);
    vec3 wo = surface_view(w->surface);
    incident_light *light = surface_light(w->surface);
    if (w->method == FIRST) {
        random_stream random = random_start(w->o->seed, run, n);
        r->asked += n;
        return (double)first_reflection(window_brdf, upright, wo, (int)n, &random).x;
    }
    r->choice = choice[w->method];
    if (w->method == 0) return (double)reflection_grid(r, &b, upright, wo, light, 4 << level).x;
    return (double)reflection_estimate(r, &b, upright, wo, light,
                                       w->method == 4 ? SEQUENCE_SOBOL : SEQUENCE_RANDOM,
                                       w->o->seed, run, n).x;
}

static inline double row_timed(void *context)
{
    reflection r = {DIRECTIONS_UNIFORM, false, 0};
    return row_run(context, &r, 3, 1);
}

/* The grid is not random: one run is all. */
static inline void row_job(size_t i, void *context)
{
    brdf_row *w = (brdf_row *)context + i;
    int runs = w->method == 0 ? 1 : w->o->quick ? 10 : 200;
    for (int level = 0; level < levels; level++) {
        double square = 0;
        reflection r = {DIRECTIONS_UNIFORM, false, 0};
        if (!w->o->full && level != brief_level) continue;
        for (int k = 0; k < runs; k++) {
            double e = row_run(w, &r, level, (uint64_t)k) / w->exact - 1;
            square += e * e / runs;
        }
        w->error[level] = sqrt(square), w->asked[level] = (double)r.asked / runs;
    }
}

static inline void plot_glossy(const options *o, const brdf_row *row, const double *ns, int n)
{
    plot p = plot_new("A glossy surface, roughness .25", "time of an estimate [us]",
                      "relative error", PLOT_LOG_X | PLOT_LOG_Y);
    for (int i = 0; i < n; i++) {
        if (row[i].surface != GLOSSY) continue;
        int s = plot_series(&p, method_name[row[i].method]);
        for (int l = 0; l < levels; l++)
            plot_add(&p, s, level_samples(l) * ns[i] / 1000, row[i].error[l]);
    }
    plot_slope(&p, -0.5, "slope -1/2"), plot_slope(&p, -1, "slope -1");
    output_plot(o, &p, "23_brdf_time.svg");
}

/* The levels from .. to - 1 of a surface, or of all: surface < 0. */
static inline table methods_table(const char *title, const brdf_row *row, const double *ns, int n,
                                  int surface, int from, int to)
{
    table t = table_new(title, "surface|method|N|asked|error [1]|time [us]");
    for (int i = 0; i < n; i++)
        for (int l = from; l < to && (surface < 0 || row[i].surface == surface); l += 2) {
            table_text(&t, "%s", surface_name[row[i].surface]);
            table_text(&t, "%s", method_name[row[i].method]);
            table_count(&t, level_samples(l)), table_number(&t, row[i].asked[l]);
            table_number(&t, row[i].error[l]);
            table_number(&t, level_samples(l) * ns[i] / 1000);
        }
    return t;
}

static inline void measure_glossy(const options *o)
{
    brdf_row row[surfaces * methods];
    double ns[surfaces * methods];
    int n = brdf_rows(o, row);
    parallel_whole((size_t)n, o->threads, "estimates", row_job, row);
    bench_each(row_timed, row, sizeof *row, n, o->quick ? 3 : 31, 1e9 / level_samples(3), ns);
    table t = methods_table("A glossy surface by 256 directions: relative error (rms), light asked "
                            "for, time", row, ns, n, GLOSSY, brief_level, brief_level + 1);
    output_table(o, &t);
    if (!o->full) return;
    t = methods_table("The reflection equation: relative error (rms), light asked for, time", row,
                      ns, n, -1, 0, levels);
    output_extra_table(o, &t);
    plot_glossy(o, row, ns, n);
}

/* ---- white furnace ---- */

static inline void measure_furnace(const options *o)
{
    static const double cosine[5] = {1, 0.7, 0.4, 0.1, 0.01};
    table t = table_new("White furnace: what single scattering keeps, GGX, F = 1",
                        "roughness|alpha|cos 1|cos .7|cos .4|cos .1|cos .01|lost in all [%]");
    plot p = plot_new("White furnace: albedo of GGX with F = 1", "cos of the angle to n", "albedo",
                      0);
    for (int r = 0; r <= 10; r++) {
        brdf b = brdf_ggx((vec3){1, 1, 1}, (real)r / 10);
        double all = 0;
        table_number(&t, r / 10.0), table_number(&t, r * r / 100.0);
        for (int k = 0; k < 5; k++)  /* no more digits than brdf_albedo has */
            table_text(&t, "%.3f", (double)brdf_albedo(&b, (real)cosine[k]).x);
        for (int k = 0; k < 20; k++) {  /* mean over white light from all sides: 2 a c dc */
            double c = (k + 0.5) / 20;
            all += 2 * c * (double)brdf_albedo(&b, (real)c).x / 20;
        }
        table_text(&t, "%.1f", 100 * fabs(1 - all));
        if (r < 3 || r % 2) continue;
        char name[32];
        snprintf(name, sizeof name, "roughness %.1f", r / 10.0);
        int s = plot_series(&p, name);
        for (int k = 0; k <= 25; k++) {
            double c = k ? k / 25.0 : 0.002;
            plot_add(&p, s, c, (double)brdf_albedo(&b, (real)c).x);
        }
    }
    output_extra_table(o, &t);
    output_plot(o, &p, "23_brdf_albedo.svg");
}

#endif
