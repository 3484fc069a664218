/* measure.h: what each idea of the chapter is worth, in the Cornell box.
 *
 *   measure_strategies(o)   every strategy at 64 samples, and first.h's; --full: a plot, of 4, 16
 *                           and 64
 *
 * The box is first.h's, without leaning walls, so that all are asked about the same light.
 * Efficiency (效率) = 1 / (error^2 x time): samples twice as fast, or with half the variance, are
 * worth twice as much. Errors: RMSE against a reference of many samples, over the pixels that do
 * not see the light, where nothing is left to do.
 */
#ifndef PATH_MEASURE_H
#define PATH_MEASURE_H

#include "../../../common/lab/report.h"
#include "../../24_direct_light/scenes/lit_first.h"
#include "../../25_bounces/naive_path.h"
#include "../first.h"
#include "showcase.h"

enum { strategy_first = 7, strategies, strategy_levels = 3 };
typedef struct { const char *name; path_options how; } strategy;
static const strategy strategy_list[strategies] = {
    {"naive (25)", {SEQUENCE_RANDOM, false, false, ROULETTE_NONE, path_endless, 0, false}},
    {"directions + roulette",
     {SEQUENCE_RANDOM, false, false, ROULETTE_THROUGHPUT, path_endless, 0, false}},
    {"lights + roulette",
     {SEQUENCE_RANDOM, true, false, ROULETTE_THROUGHPUT, path_endless, 0, false}},
    {"lights + MIS, 40 bounces", {SEQUENCE_RANDOM, true, true, ROULETTE_NONE, 40, 0, false}},
    {"lights + MIS + roulette .8",
     {SEQUENCE_RANDOM, true, true, ROULETTE_FIXED, path_endless, 0, false}},
    {"lights + MIS + roulette",
     {SEQUENCE_RANDOM, true, true, ROULETTE_THROUGHPUT, path_endless, 0, false}},
    {"the same, Sobol' (default)",
     {SEQUENCE_SOBOL, true, true, ROULETTE_THROUGHPUT, path_endless, 0, false}},
    {"first", {SEQUENCE_RANDOM, true, false, ROULETTE_FIXED, path_endless, 0, false}}};
typedef struct { double error, seconds, rays; } strategy_result;
typedef struct {
    const options *o;
    int side;
    first_scene first, open;  /* open: nothing hides its lamp */
    image reference, light;  /* light: what the eye sees of it at once */
} measure_place;

/* ---------------------------------------------------------------------------------------------- */

static inline void measure_shot(const measure_place *m, path_options how, uint64_t seed, shot *s)
{
    options o = *m->o;
    o.seed = seed;
    s->c = (showcase){.eye = lit_first_camera()};
    lit_first(&m->first, &s->c.s);
    shot_begin(s, &o, how, film_new(m->side, m->side));
}

static inline image measure_picture(const measure_place *m, path_options how, uint32_t samples)
{
    shot s;
    measure_shot(m, how, 77, &s);
    if (!passes_range(render_passes(&s.j), &s.film, 0, samples)) die(parallel_stopped(), "stopped");
    image im = film_picture(&s.film);
    shot_free(&s);
    return im;
}

/* The mean square over the pixels that do not see the light. */
static inline double measure_square(const measure_place *m, const film *f)
{
    double sum = 0;
    size_t n = 0;
    image im = film_picture(f);
    for (int i = 0; i < 3 * m->side * m->side; i++) {
        double d = (double)im.rgb[i] - (double)m->reference.rgb[i];
        if (m->light.rgb[i] <= 0) sum += d * d, n++;
    }
    image_free(&im);
    return sum / (double)n;
}

/* The rays of first_path, by a walk that takes the same random numbers. Where nothing hides the
 * lamp a point of it brings light if, and only if, a shadow ray is sent to it. */
static inline size_t measure_first_rays(const first_scene *s, const first_scene *open, ray r,
                                        random_stream *random)
{
    size_t rays = 1;
    for (hit h; first_scene_hit(s, r, &h); rays++) {
        first_point x = first_point_at(s, r, h);
        rays += !vzero(first_direct_by_lamp(open, 0, x, random));
        if ((double)random_next(random) >= first_go_on) break;
        r = first_bounce(s, x, random);
    }
    return rays;
}

/* All strategies by the same loop, one thread: naive is 25's path, first that of first.h, whose
 * rays are counted in another run, without its picture. The number of rays. */
static inline size_t measure_render(const measure_place *m, shot *s, const strategy *y,
                                    uint32_t samples, bool count)
{
    size_t rays = 0;
    naive_counts n = {0};
    path_counts c = {0};
    const naive_path naive = {&s->c.s, DIRECTIONS_BRDF, naive_endless, false};
    const bool short_book = y == strategy_list + strategy_first;
    for (int i = 0; i < m->side * m->side; i++) {
        path_pixel half[2];
        film_pixel sum = {{{{{0, 0}}}}};
        for (uint64_t k = 0; k < 2; k++)
            path_pixel_of(&y->how, s->j.seed, 2 * (uint64_t)i + k, &half[k]);
        for (uint32_t k = 0; k < samples; k++) {
            path_random r;
            path_sample(&half[k % 2], k / 2, 1u << 31, &r);
            sampler own = sampler_of_keys(&half[k % 2].keys, k / 2, 1u << 31);
            point2 u = path_pair(&r);
            own.pair = 1;
            ray eye = camera_ray(s->c.eye, (real)(i % m->side) + u.u, (real)(i / m->side) + u.v,
                                 m->side, m->side);
            if (count) rays += measure_first_rays(&m->first, &m->open, eye, &r.own);
            else film_pixel_add(&sum, k, short_book ? first_path(&m->first, eye, &r.own)
                           : y == strategy_list ? naive_radiance(&naive, eye, &own, &n)
                           : path_radiance(&s->t, eye, &r, &c));
        }
        film_gather(&s->film, (size_t)i, &sum);
    }
    return rays + path_rays(&c) + naive_rays(&n);
}

/* The root of the mean square over some pictures. */
static inline strategy_result measure_strategy(const measure_place *m, const strategy *y,
                                               uint32_t samples, int runs)
{
    strategy_result x = {0, 0, 0};
    for (int run = 0; run < runs; run++) {
        shot s;
        failure why;
        measure_shot(m, y->how, (uint64_t)run + 1, &s);
        double start = clock_seconds();
        x.rays += (double)measure_render(m, &s, y, samples, false) / runs;
        x.seconds += (clock_seconds() - start) / runs;
        if (y == strategy_list + strategy_first)
            x.rays += (double)measure_render(m, &s, y, samples, true) / runs;
        film_cover(&s.film, 0, samples, &why);
        x.error += measure_square(m, &s.film) / runs;
        shot_free(&s);
    }
    x.error = sqrt(x.error);
    return x;
}

/* 4, 16, 64 samples; --quick ends with 16. Without --full the last alone. */
static inline void measure_strategies(const options *o)
{
    measure_place m = {.o = o, .side = o->quick ? 12 : 32, .first = first_cornell()};
    strategy_result naive = {0, 0, 0};
    path_options seen = path_defaults;
    int end = o->quick ? 2 : strategy_levels;
    char title[80];
    uint32_t most = 4u << 2 * (end - 1);
    snprintf(title, sizeof title, "Pixels that do not see the light, %u samples each; one thread",
             (unsigned)most);
    table t = table_new(title, "strategy|error RMSE|rays a path|time [ms]|efficiency|"
                               "time for the naive error [x less]");
    plot error = plot_new("Error and rays", "rays a pixel", "RMSE", PLOT_LOG_X | PLOT_LOG_Y);
    seen.bounces = 0;
    m.open = m.first, m.open.eps = 1;  /* from 1 to 0 of the way */
    m.reference = measure_picture(&m, path_defaults, o->quick ? 256 : 1500);
    m.light = measure_picture(&m, seen, 1024);
    for (int k = 0; k < strategies; k++) {
        const strategy *s = &strategy_list[k];
        strategy_result x = naive;
        double pixels = (double)m.side * m.side;
        if (k != strategy_first) plot_series(&error, s->name);
        for (int l = o->full ? 0 : end - 1; l < end; l++) {
            x = measure_strategy(&m, s, 4u << 2 * l, o->quick ? 1 : l < 2 ? 3 : 1);
            if (k != strategy_first) plot_add(&error, k, x.rays / pixels, x.error);
        }
        if (k == 0) naive = x;
        double efficiency = 1 / (x.error * x.error * x.seconds);
        table_text(&t, "%s", s->name);
        table_number(&t, x.error);
        table_number(&t, x.rays / (pixels * most));
        table_number(&t, x.seconds * 1e3), table_number(&t, efficiency);
        table_number(&t, efficiency * naive.error * naive.error * naive.seconds);
    }
    plot_slope(&error, -0.5, "slope -1/2");
    output_table(o, &t);
    if (o->full) output_plot(o, &error, "26_path_tracer_error.svg");
    else plot_free(&error);
    image_free(&m.reference), image_free(&m.light);
}

#endif
