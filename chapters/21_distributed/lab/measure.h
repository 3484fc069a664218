/* measure.h: the table and the plot: pictures against converged ones.
 *
 *   table_of_pictures(&o)   error and time of pictures of soft shadows, of motion and of all other
 *                           effects, by way of sampling, and of the first by first.h; its plot
 */
#ifndef DISTRIBUTED_MEASURE_H
#define DISTRIBUTED_MEASURE_H

#include "../../../common/lab/bench.h"
#include "../../../common/lab/report.h"
#include "../../../common/lab/t_test.h"
#include "balls.h"
#include "pictures.h"

enum { picture_methods = 3, picture_first = picture_methods, picture_ways, measure_levels = 4 };
static const sequence_kind picture_method[picture_methods] = {SEQUENCE_RANDOM, SEQUENCE_JITTERED,
                                                              SEQUENCE_SOBOL};

/* first: NULL, or it is drawn by first.h, with v's seed and samples. */
typedef struct { distributed_view v; image im; const distributed_balls *first; } distributed_run;
typedef struct {
    double error[measure_levels], seconds;
    estimate slope;           /* of the repetitions' slopes */
} distributed_study;

/* Ctrl-C: half a picture must not be measured. */
static inline void picture_draw(distributed_run *r, int threads)
{
    if (r->first) balls_draw_first(r->first, r->v.seed, r->v.samples, &r->im);
    else if (!distributed_draw(&r->v, &r->im, threads)) die(parallel_stopped(), "stopped");
}

static inline double picture_seconds(void *context)
{
    distributed_run *r = context;
    picture_draw(r, 1);
    return (double)r->im.rgb[0];
}

/* From 4 samples on: one alone is taken in the middle of its pixel. */
static inline double picture_slope(const double *square, int levels)
{
    double x[measure_levels] = {0}, y[measure_levels] = {0};
    for (int l = 1; l < levels; l++) x[l] = 2 * l * log(2.0), y[l] = log(square[l]) / 2;
    return fit_line(x + 1, y + 1, (size_t)levels - 1).slope;
}

/* How sure a slope is, pictures of other seeds tell; three points of one line do not. Nothing is
 * cut at white: a mean that is cut is none, and the slope of random points would not be -1/2. The
 * reference has 8 times as many samples as the best picture (--full: 32 times), another seed, and
 * so at most a third of its error. The time is that of 16 samples a pixel: it is proportional to
 * their number. */
static inline void picture_measure(const options *o, distributed_view v,
                                   const distributed_balls *first, int levels, distributed_study *p)
{
    int w = o->full ? 20 : 12, h = w * 3 / 4, repetitions = o->full ? 16 : o->quick ? 2 : 5;
    int ways = first ? picture_ways : picture_methods;
    image im = image_new(w, h), reference = image_new(w, h);
    distributed_run run[picture_ways];
    double seconds[picture_ways];
    v.samples = o->full ? 2048 : o->quick ? 128 : 512, v.seed = o->seed;
    picture_draw(&(distributed_run){v, reference, NULL}, o->threads);
    for (int m = 0; m < ways; m++) {
        double sum[measure_levels] = {0}, square[measure_levels];
        if (m < picture_methods) v.kind = picture_method[m];
        run[m] = (distributed_run){v, im, m == picture_first ? first : NULL};
        p[m].slope = (estimate){0, 0, 0};
        for (int k = 1; k <= repetitions; k++) {
            run[m].v.seed = o->seed + 1000 * (uint64_t)k;
            for (int l = 0; l < levels; l++) {
                run[m].v.samples = (uint32_t)1 << 2 * l;
                picture_draw(&run[m], o->threads);
                square[l] = pow(image_compare(&im, &reference).rmse, 2), sum[l] += square[l];
            }
            p[m].slope = estimate_add(p[m].slope, picture_slope(square, levels));
        }
        for (int l = 0; l < levels; l++) p[m].error[l] = sqrt(sum[l] / repetitions);
        run[m].v.samples = 16, run[m].v.seed = 1;
    }
    bench_each(picture_seconds, run, sizeof *run, ways, 3, 1.0 / 16, seconds);
    for (int m = 0; m < ways; m++) p[m].seconds = seconds[m];
    image_free(&im), image_free(&reference);
}

static inline void table_of_pictures(const options *o)
{
    enum { effects = 3 };
    static const char *const names[effects] = {"soft shadow", "motion", "all others"};
    int levels = measure_levels - o->quick;
    showroom *g = showroom_new(o->quick ? 4 : 8);
    pool *moves = pool_new(1);
    distributed_balls *balls = balls_new(false);
    showroom_look k;
    showroom_set(&k, g, LOOK_ALL);
    distributed_view views[effects] = {balls_view(balls, (real)4 / 3),
                                       pool_view(moves, (real)4 / 3),
                                       showroom_view(&k, SHOWROOM_ALL, (real)4 / 3)};
    table t = table_new(o->full ? "Error of three pictures, each with 16 seeds; time of 64 samples "
                                  "a pixel"
                                : "Error of three small pictures, each with a few seeds; time of "
                                  "64 samples a pixel",
                        "effect|samples|error N=1|error N=4|error N=16|error N=64|slope|+-|"
                        "time [ms]");
    plot time = plot_new("Error of a picture, and time", "time of a picture [ms]", "error (rmse)",
                         PLOT_LOG_X | PLOT_LOG_Y);
    for (int e = 0; e < effects; e++) {
        distributed_study p[picture_ways];
        picture_measure(o, views[e], e ? NULL : balls, levels, p);
        for (int m = 0; m < (e ? picture_methods : picture_ways); m++) {
            const char *method = m == picture_first ? "first" : sequence_name[picture_method[m]];
            char name[64];
            snprintf(name, sizeof name, "%s, %s", names[e], method);
            int series = plot_series(&time, name);
            table_text(&t, "%s", names[e]), table_text(&t, "%s", method);
            for (int l = 0; l < measure_levels; l++)
                if (l < levels) {
                    table_number(&t, p[m].error[l]);
                    plot_add(&time, series, (1 << 2 * l) * 1e3 * p[m].seconds, p[m].error[l]);
                } else table_text(&t, "-");
            table_number(&t, p[m].slope.mean), table_number(&t, estimate_error(p[m].slope));
            table_number(&t, 64e3 * p[m].seconds);
        }
    }
    plot_slope(&time, -0.5, "slope -1/2"), plot_slope(&time, -0.75, "slope -3/4");
    output_table(o, &t);
    output_plot(o, &time, "21_distributed_time.svg");
    showroom_free(g), pool_free(moves), balls_free(balls);
}

#endif
