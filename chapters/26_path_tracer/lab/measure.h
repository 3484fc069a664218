/* measure.h: what each idea of the chapter is worth, in the Cornell box.
 *
 *   measure_strategies(o)   every strategy at 64 samples; --full: a plot, of 4, 16 and 64
 *
 * Efficiency (效率) = 1 / (error^2 x time): samples twice as fast, or with half the variance, are
 * worth twice as much. Errors: RMSE against a reference of many samples, over the pixels that do
 * not see the light, where nothing is left to do.
 */
#ifndef PATH_MEASURE_H
#define PATH_MEASURE_H

#include "../../../common/lab/report.h"
#include "../../25_bounces/naive_path.h"
#include "command.h"

enum { strategies = 7 };
typedef struct { const char *name; bool naive; path_options how; } strategy;

/* ---------------------------------------------------------------------------------------------- */

static inline void strategy_list(strategy s[strategies])
{
    path_options d = path_defaults, none = d, r = d;
    r.sequence = SEQUENCE_RANDOM;
    none = r, none.roulette = ROULETTE_NONE, none.bounces = 40;
    path_options directions = r, by_lights = r, both = none, fixed = r;
    directions.light_sampling = directions.mis = false;
    by_lights.mis = false;
    fixed.roulette = ROULETTE_FIXED;
    const strategy list[strategies] = {
        {"naive (25)", true, none}, {"directions + roulette", false, directions},
        {"lights + roulette", false, by_lights}, {"lights + MIS, 40 bounces", false, both},
        {"lights + MIS + roulette .8", false, fixed},
        {"lights + MIS + roulette", false, r}, {"the same, Sobol' (default)", false, d}};
    memcpy(s, list, sizeof list);
}

typedef struct {
    showcase c;
    int side;
    image reference;
    bool *dark;            /* [side^2] does not see the light */
    size_t darks;
} measure_place;

static inline image measure_render(const measure_place *m, const strategy *s, uint64_t seed,
                                   uint32_t samples, double *seconds, size_t *rays)
{
    path_tracer t;
    path_tracer_of(&m->c.s, NULL, s->how, &t);
    film f = film_new(m->side, m->side);
    path_counts c = {0};
    naive_counts n = {0};
    naive_path p = {&m->c.s, DIRECTIONS_BRDF, naive_endless, false};
    double start = clock_seconds();
    for (int i = 0; i < m->side * m->side; i++) {
        path_pixel half[2];
        film_pixel sum = {{{{{0, 0}}}}};
        for (uint64_t k = 0; k < 2; k++)
            path_pixel_of(&s->how, seed, 2 * (uint64_t)i + k, &half[k]);
        for (uint32_t k = 0; k < samples; k++) {
            real x = (real)(i % m->side), y = (real)(i / m->side);
            path_random r = path_sample(&half[k % 2], k / 2, 1u << 31);
            point2 u = path_pair(&r);
            ray eye = camera_ray(m->c.eye, x + u.u, y + u.v, m->side, m->side);
            vec3 L = s->naive ? naive_radiance(&p, eye, &r.pairs, &n)
                              : path_radiance(&t, eye, &r, &c);
            film_pixel_add(&sum, k, L);
        }
        film_gather(&f, (size_t)i, &sum);
    }
    *seconds = clock_seconds() - start;
    *rays = s->naive ? naive_rays(&n) : path_rays(&c);
    failure why;
    film_cover(&f, 0, samples, &why);
    image im = film_picture(&f);
    film_free(&f), path_tracer_free(&t);
    return im;
}

/* Of a reference whose own error is known to be some part of what is measured. */
static inline void measure_place_of(const options *o, measure_place *m)
{
    *m = (measure_place){.side = o->quick ? 12 : 32};
    failure f;
    if (!showcase_of("cornell", 1, &m->c, &f)) fail(f);
    path_tracer t;
    path_tracer_of(&m->c.s, NULL, path_defaults, &t);
    render_job j = {.tracer = &t, .eye = m->c.eye, .seed = 77, .threads = o->threads};
    film all = film_new(m->side, m->side);
    if (!render_range(&j, &all, 0, o->quick ? 256 : 1500))
        die(parallel_stopped(), "stopped");
    m->reference = film_picture(&all);
    m->dark = allocate((size_t)m->side * (size_t)m->side, sizeof *m->dark);
    for (int i = 0; i < m->side * m->side; i++) {
        bool sees = false;
        for (int k = 0; k < 64; k++) {
            lit_hit h;
            real x = (real)(i % m->side) + (real)(k % 8) / 7;
            real y = (real)(i / m->side) + (real)(k / 8) / 7;
            ray r = camera_ray(m->c.eye, x, y, m->side, m->side);
            sees = sees || (lit_trace(&m->c.s, r, &h) && h.emitter != lit_dark);
        }
        m->dark[i] = !sees, m->darks += !sees;
    }
    film_free(&all), path_tracer_free(&t);
}

static inline void measure_place_free(measure_place *m)
{
    image_free(&m->reference), showcase_free(&m->c), free(m->dark);
}

static inline double measure_error(const measure_place *m, const image *im)
{
    double sum = 0;
    for (int i = 0; i < 3 * m->side * m->side; i++) {
        double d = (double)im->rgb[i] - (double)m->reference.rgb[i];
        if (m->dark[i / 3]) sum += d * d;
    }
    return sqrt(sum / (3 * (double)m->darks));
}

typedef struct { double error, seconds, rays; } measured;

/* The mean square over some pictures. */
static inline measured measure_strategy(const measure_place *m, const strategy *s, uint32_t samples,
                                        int runs)
{
    measured x = {0, 0, 0};
    for (int k = 0; k < runs; k++) {
        double seconds, e;
        size_t rays;
        image im = measure_render(m, s, (uint64_t)k + 1, samples, &seconds, &rays);
        e = measure_error(m, &im);
        x.error += e * e / runs, x.seconds += seconds / runs, x.rays += (double)rays / runs;
        image_free(&im);
    }
    x.error = sqrt(x.error);
    return x;
}

/* 4, 16, 64 samples; --quick ends with 16. Without --full the last alone. */
enum { strategy_levels = 3 };
static inline uint32_t strategy_samples(int level) { return 4u << 2 * level; }

static inline void strategy_row(const measure_place *m, const strategy *s, uint32_t samples,
                                const measured *x, const measured *naive, table *t)
{
    double efficiency = 1 / (x->error * x->error * x->seconds);
    table_text(t, "%s", s->name);
    table_number(t, x->error), table_number(t, x->rays / ((double)m->side * m->side * samples));
    table_number(t, x->seconds * 1e3), table_number(t, efficiency);
    table_number(t, efficiency * naive->error * naive->error * naive->seconds);
}

static inline void measure_strategies(const options *o)
{
    measure_place m;
    strategy s[strategies];
    measured naive = {0, 0, 0};
    int end = o->quick ? 2 : strategy_levels;
    table t = table_new(o->quick
                            ? "Pixels that do not see the light, 16 samples each; one thread"
                            : "Pixels that do not see the light, 64 samples each; one thread",
                        "strategy|error RMSE|rays a path|time [ms]|efficiency|"
                        "time for the naive error [x less]");
    plot error = plot_new("Error and rays", "rays a pixel", "RMSE", PLOT_LOG_X | PLOT_LOG_Y);
    measure_place_of(o, &m);
    strategy_list(s);
    for (int k = 0; k < strategies; k++) {
        plot_series(&error, s[k].name);
        measured x = naive;
        for (int l = o->full ? 0 : end - 1; l < end; l++) {
            x = measure_strategy(&m, &s[k], strategy_samples(l), o->quick ? 1 : l < 2 ? 3 : 1);
            plot_add(&error, k, x.rays / ((double)m.side * m.side), x.error);
        }
        if (k == 0) naive = x;
        strategy_row(&m, &s[k], strategy_samples(end - 1), &x, &naive, &t);
    }
    plot_slope(&error, -0.5, "slope -1/2");
    output_table(o, &t);
    if (o->full) output_plot(o, &error, "26_path_tracer_error.svg");
    else plot_free(&error);
    measure_place_free(&m);
}

#endif
