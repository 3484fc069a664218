/* measure.h: tables and a plot: pictures against converged ones, estimates against closed forms.
 *
 *   table_of_pictures(&o)   the main one: error and time of pictures of soft shadows, of motion and
 *                           of all other effects, by way of sampling; its plot
 *   table_of_known(&o)      questions of known.h: estimates, t-tests, slopes
 *   table_of_first(&o)      three of them by first.h: its error and its time
 *   table_of_rays(&o)       rays and random numbers, only what is called for and all
 */
#ifndef DISTRIBUTED_MEASURE_H
#define DISTRIBUTED_MEASURE_H

#include "../../../common/lab/bench.h"
#include "../../../common/lab/report.h"
#include "known_first.h"
#include "pictures.h"

enum { measure_methods = 3, measure_levels = 4 };
static const sequence_kind measure_method[measure_methods] = {SEQUENCE_RANDOM, SEQUENCE_JITTERED,
                                                              SEQUENCE_SOBOL};

/* ---- pictures -------------------------------------------------------------------------------- */

typedef struct { distributed_view v; image im; } distributed_run;
typedef struct { double error[measure_methods][measure_levels], seconds[measure_methods]; }
    distributed_study;

/* Ctrl-C: half a picture must not be measured. */
static inline void measure_unless(bool stopped)
{
    if (stopped) die(parallel_stopped(), "stopped");
}

static inline double picture_seconds(void *context)  /* on one thread */
{
    distributed_run *r = context;
    measure_unless(!distributed_draw(&r->v, &r->im, 1));
    return (double)r->im.rgb[0];
}

/* As a screen shows it: white is white. Else a few reflections of lamps would be all the error. */
static inline void picture_draw(const options *o, distributed_view *v, image *im)
{
    measure_unless(!distributed_draw(v, im, o->threads));
    for (size_t i = 0; i < 3 * (size_t)im->width * (size_t)im->height; i++)
        im->rgb[i] = im->rgb[i] < 1 ? im->rgb[i] : 1;
}

/* The reference has another seed, 8 times as many samples as the best picture, and so an error of
 * 1/4.8 of its, if that falls as N^-3/4: what it adds to the measured one is 2 %. The time is that
 * of 16 samples a pixel: it is proportional to their number. */
static inline distributed_study picture_measure(const options *o, distributed_view v, int levels)
{
    int w = o->quick ? 12 : 20, h = w * 3 / 4;
    image im = image_new(w, h), reference = image_new(w, h);
    distributed_study p = {.seconds = {0}};
    distributed_run run[measure_methods];
    v.samples = o->quick ? 128 : 512, v.seed = o->seed + 1000;
    picture_draw(o, &v, &reference), v.seed = o->seed;
    for (int m = 0; m < measure_methods; m++) {
        v.kind = measure_method[m];
        for (int l = 0; l < levels; l++) {
            v.samples = (uint32_t)1 << 2 * l;
            picture_draw(o, &v, &im);
            p.error[m][l] = image_compare(&im, &reference).rmse;
        }
        run[m] = (distributed_run){v, im}, run[m].v.samples = 16, run[m].v.seed = 1;
    }
    bench_each(picture_seconds, run, sizeof *run, measure_methods, o->quick ? 1 : 3, 1.0 / 16,
               p.seconds);
    image_free(&im), image_free(&reference);
    return p;
}

/* From 4 samples on: one alone is taken in the middle of its pixel. */
static inline line_fit picture_slope(const double *error, int levels)
{
    double x[measure_levels] = {0}, y[measure_levels] = {0};
    for (int l = 1; l < levels; l++) x[l] = 2 * l * log(2.0), y[l] = log(error[l]);
    return fit_line(x + 1, y + 1, (size_t)levels - 1);
}

static inline void table_of_pictures(const options *o)
{
    static const char *const names[3] = {"soft shadow", "motion", "all others"};
    int levels = measure_levels - o->quick;
    showroom *g = showroom_new(o->quick ? 4 : 8);
    pool *balls = pool_new(1);
    showroom_look k[2];
    distributed_view views[3] = {showroom_effect_view(&k[0], g, 0, true, (real)4 / 3),
                                 pool_view(balls, (real)4 / 3),
                                 showroom_effect_view(&k[1], g, 4, true, (real)4 / 3)};
    table t = table_new("Error of three pictures against converged ones; "
                        "time of 64 samples a pixel",
                        "effect|samples|error N=1|error N=4|error N=16|error N=64|slope|+-|"
                        "time [ms]");
    plot time = plot_new("Error of a picture, and time", "time of a picture [ms]", "error (rmse)",
                         PLOT_LOG_X | PLOT_LOG_Y);
    for (int e = 0; e < 3; e++) {
        distributed_study p = picture_measure(o, views[e], levels);
        const char *name = names[e];
        for (int m = 0; m < measure_methods; m++) {
            const char *method = sequence_name[measure_method[m]];
            char both[64];
            snprintf(both, sizeof both, "%s, %s", name, method);
            int series = plot_series(&time, both);
            table_text(&t, "%s", name), table_text(&t, "%s", method);
            for (int l = 0; l < measure_levels; l++)
                if (l < levels) {
                    table_number(&t, p.error[m][l]);
                    plot_add(&time, series, (1 << 2 * l) * 1e3 * p.seconds[m], p.error[m][l]);
                } else table_text(&t, "-");
            line_fit slope = picture_slope(p.error[m], levels);
            table_number(&t, slope.slope);
            table_text(&t, slope.n > 2 ? "%.2f" : "-", slope.slope_error);
            table_number(&t, 64e3 * p.seconds[m]);
        }
    }
    plot_slope(&time, -0.5, "slope -1/2"), plot_slope(&time, -0.75, "slope -3/4");
    output_table(o, &t);
    output_plot(o, &time, "21_distributed_time.svg");
    showroom_free(g), pool_free(balls);
}

/* ---- closed forms ---------------------------------------------------------------------------- */

enum { known_runs = 64 };

typedef struct {
    known k[known_kinds];
    uint64_t seed;
    estimate mean[known_kinds][measure_methods][measure_levels];    /* of the runs' means */
    estimate square[known_kinds][measure_methods][measure_levels];  /* of their squared errors */
} known_study;

static inline uint32_t known_samples(int level) { return (uint32_t)16 << 2 * level; }

static inline void known_job(size_t i, void *context)
{
    known_study *s = context;
    size_t level = measure_levels - 1 - i / (known_kinds * measure_methods);
    size_t kind = i / measure_methods % known_kinds, method = i % measure_methods;
    for (int run = 0; run < known_runs; run++) {
        estimate e = known_mean(&s->k[kind], measure_method[method], s->seed + level * 100,
                                (uint64_t)run, known_samples((int)level));
        double off = e.mean - s->k[kind].truth;
        estimate *mean = &s->mean[kind][method][level], *square = &s->square[kind][method][level];
        *mean = estimate_add(*mean, e.mean), *square = estimate_add(*square, off * off);
    }
}

/* All that is no chance: sheets that end somewhere, glossy_above to 1e-7, and in float the sum of
 * a thousand weights. */
static inline double known_rounding(void) { return 2.0 / known_far + 4 * (double)real_epsilon; }

/* NaN where the points are exact: from some N on there is no error. Its own standard error follows
 * from that of each mean square: log rms is off by half of the mean square's relative error. */
static inline line_fit known_slope(const known_study *s, int kind, int method)
{
    double x[measure_levels] = {0}, y[measure_levels] = {0}, off = 0, middle = 0, xx = 0;
    for (int l = 0; l < measure_levels; l++) {
        double rms = sqrt(s->square[kind][method][l].mean);
        if (rms < known_rounding()) return (line_fit){.slope = (double)NAN};
        x[l] = log((double)known_samples(l)), y[l] = log(rms), middle += x[l] / measure_levels;
    }
    for (int l = 0; l < measure_levels; l++) {
        estimate square = s->square[kind][method][l];
        double own = estimate_error(square) / square.mean / 2 * (x[l] - middle);
        off += own * own, xx += (x[l] - middle) * (x[l] - middle);
    }
    line_fit f = fit_line(x, y, measure_levels);
    f.slope_error = sqrt(off) / xx;
    return f;
}

static inline void table_of_known(const options *o)
{
    known_study *s = allocate(1, sizeof *s);
    s->seed = o->seed;
    for (int i = 0; i < known_kinds; i++) known_make((known_kind)i, &s->k[i]);
    measure_unless(!parallel_for(known_kinds * measure_methods * measure_levels, o->threads,
                                 "closed forms", known_job, s));
    table t = table_new("Questions with known answers: means, standard errors, t-tests, slopes",
                        "question|answer|random|+-|Sobol'|+-|p random|p jittered|"
                        "p Sobol'|slope random|jittered|Sobol'");
    for (int i = 0; i < known_kinds; i++) {
        int top = measure_levels - 1;
        table_text(&t, "%s", s->k[i].name), table_text(&t, "%.6f", s->k[i].truth);
        for (int m = 0; m < measure_methods; m += 2) {
            table_text(&t, "%.6f", s->mean[i][m][top].mean);
            table_text(&t, "%.6f", estimate_error(s->mean[i][m][top]));
        }
        for (int m = 0; m < measure_methods; m++)
            table_text(&t, "%.3f", t_test(s->mean[i][m][top], s->k[i].truth, known_rounding()));
        for (int m = 0; m < measure_methods; m++) {
            line_fit f = known_slope(s, i, m);
            if (isnan(f.slope)) table_text(&t, "exact");
            else table_text(&t, "%.2f +-%.2f", f.slope, f.slope_error);
        }
    }
    output_extra_table(o, &t);
    for (int i = 0; i < known_kinds; i++) known_free(&s->k[i]);
    free(s);
}

/* ---- the notes' own way ---------------------------------------------------------------------- */

typedef struct { known full; known_first first; bool is_first; uint64_t seed; } known_ask;
enum { known_ask_samples = 1024 };

static inline estimate known_asked(const known_ask *a, uint64_t run)
{
    if (a->is_first) return known_first_mean(&a->first, a->seed, run, known_ask_samples);
    return known_mean(&a->full, SEQUENCE_RANDOM, a->seed, run, known_ask_samples);
}

static inline double known_ask_run(void *context) { return known_asked(context, 0).mean; }

static inline void first_row(table *t, const known_ask *a, double seconds)
{
    estimate mean = {0};
    double square = 0;
    for (int run = 0; run < known_runs; run++) {
        double off = known_asked(a, (uint64_t)run).mean - a->full.truth;
        mean = estimate_add(mean, off + a->full.truth), square += off * off / known_runs;
    }
    table_text(t, "%s", a->full.name), table_text(t, a->is_first ? "first" : "random");
    table_text(t, "%.6f", a->full.truth), table_text(t, "%.6f", mean.mean);
    table_text(t, "%.6f", estimate_error(mean));
    table_number(t, sqrt(square)), table_number(t, 1e9 * seconds / known_ask_samples);
}

static inline void table_of_first(const options *o)
{
    static const known_kind kinds[3] = {KNOWN_SQUARE, KNOWN_PENUMBRA, KNOWN_HORIZON};
    char title[96];
    snprintf(title, sizeof title, "Three of them by first.h: runs of %d samples, time of one",
             (int)known_ask_samples);
    table t = table_new(title, "question|samples|answer|error mean|error +-|error rms|time [ns]");
    for (int i = 0; i < 3; i++) {
        known_ask *a = allocate(2, sizeof *a);
        double seconds[2];
        for (int k = 0; k < 2; k++) {
            known_make(kinds[i], &a[k].full);
            a[k].first = known_first_of(kinds[i]), a[k].is_first = k == 0, a[k].seed = o->seed;
        }
        bench_each(known_ask_run, a, sizeof *a, 2, 51, 1, seconds);
        for (int k = 0; k < 2; k++)
            first_row(&t, &a[k], seconds[k]), known_free(&a[k].full);
        free(a);
    }
    output_extra_table(o, &t);
}

/* ---- what is called for ---------------------------------------------------------------------- */

static inline void rays_row(const options *o, table *t, const showroom *g, int effects,
                            const char *name)
{
    enum { w = 96, h = 54 };
    image a = image_new(w, h), b = image_new(w, h);
    for (int all = 0; all < 2; all++) {
        showroom_look k;
        showroom_set(&k, g, effects);
        k.how.spend_all = all;
        distributed_view v = showroom_view(&k, SHOWROOM_ALL, (real)w / h);
        v.samples = 4;
        measure_unless(!distributed_draw(&v, all ? &b : &a, o->threads));
        table_text(t, "%s%s", name, all ? ", all the same" : "");
        const size_t *n = v.spent.rays.rays, *d = v.spent.drawn;
        table_count(t, n[RAY_CAMERA]), table_count(t, n[RAY_SHADOW]);
        table_count(t, n[RAY_REFLECTION]), table_count(t, n[RAY_SIGHT]);
        table_count(t, d[DRAWN_LENS]), table_count(t, d[DRAWN_LIGHT]);
        table_count(t, d[DRAWN_SKY]), table_count(t, d[DRAWN_LOBE]);
        int differ = 0;
        for (int i = 0; i < w * h && all; i++)
            differ += memcmp(a.rgb + 3 * i, b.rgb + 3 * i, 3 * sizeof *a.rgb) != 0;
        table_text(t, all ? "%d" : "-", differ);
    }
    image_free(&a), image_free(&b);
}

static inline void table_of_rays(const options *o)
{
    showroom *g = showroom_new(8);
    table t = table_new("Rays and pairs of random numbers, 96 x 54 pixels, 4 samples each",
                        "effects|camera|shadow|reflection|sky|lens numbers|light|sky|lobe|"
                        "pictures differ [pixels]");
    rays_row(o, &t, g, 0, "Whitted"), rays_row(o, &t, g, EFFECT_SOFT, "soft");
    rays_row(o, &t, g, EFFECT_GLOSSY, "gloss"), rays_row(o, &t, g, EFFECT_SKY, "occlusion");
    rays_row(o, &t, g, EFFECT_LENS, "lens"), rays_row(o, &t, g, EFFECT_ALL, "all");
    output_extra_table(o, &t);
    showroom_free(g);
}

#endif
