/* measure.h: the tables.
 *
 *   table_of_depths(&o)     error against time over depth and over the cut, and its plot
 *   table_of_first(&o)      first.h on its two balls: time, and what differs
 */
#ifndef WHITTED_LAB_MEASURE_H
#define WHITTED_LAB_MEASURE_H

#include "../../../common/lab/bench.h"
#include "../../../common/lab/report.h"
#include "first_world.h"
#include "../scenes/forty.h"
#include "pictures.h"

/* ---------------------------------------------------------------------------------------------- */

/* [s], the median of 1 to 3 rounds. Of a picture that is not whole no row can tell: Ctrl-C ends the
 * program. */
static inline double measured_draw(const traced_view *v, image *im, int rounds, int threads)
{
    double seconds[3] = {0};
    for (int i = 0; i < rounds; i++) {
        double start = clock_seconds();
        if (v->counts) *v->counts = (trace_counts){0};
        if (!pixels_draw(im, 1, threads, "drawing", traced_colour, v))
            die(parallel_stopped(), "stopped");
        seconds[i] = clock_seconds() - start;
    }
    return clock_median(seconds, rounds);
}

static const struct { int depth; double least; } depths_tried[] = {
    {1, 0},    {2, 0},    {3, 0},     {4, 0},     {5, 0},      {6, 0},      {8, 0},
    {12, 0},   {64, 0.5}, {64, 0.1},  {64, 0.03}, {64, 0.01},  {64, 0.001}, {64, 0.0001}};

/* Against depth 64 and a cut of 1e-10: what that leaves out does not show in a picture of floats,
 * and without any cut depth 64 takes more than a hundred times as long. */
static inline void table_of_depths(const options *o)
{
    whitted_stage *f = forty_new();
    int w = o->quick ? 48 : 160, h = w * 3 / 4;
    image im = image_new(w, h), deep = image_new(w, h);
    trace_counts rays = {0};
    traced_view v = whitted_view(f, forty_camera((real)w / (real)h), w, h);
    table t = table_new("Forty balls: error against depth 64 and a cut of 1e-10; rays a pixel",
                        "knob|depth|cut|shadow|reflection|refraction|error: rmse|error: most|"
                        "time [ns/pixel]");
    plot p = plot_new("What is left out, against time", "time [ns/pixel]", "error, rmse",
                      PLOT_LOG_Y);
    plot_series(&p, "depth 1, 2 .. 12, no cut"), plot_series(&p, "cut 0.5 .. 0.0001");
    f->w.depth = 64, f->w.least = 1e-10;
    measured_draw(&v, &deep, 1, o->threads);
    v.counts = &rays;
    for (size_t k = 0; k < sizeof depths_tried / sizeof *depths_tried; k++) {
        f->w.depth = depths_tried[k].depth, f->w.least = (real)depths_tried[k].least;
        double ns = measured_draw(&v, &im, o->full ? 3 : 1, 1) / ((double)w * h) * 1e9;
        image_difference d = image_compare(&im, &deep);
        table_text(&t, depths_tried[k].least > 0 ? "cut" : "depth");
        table_count(&t, (size_t)depths_tried[k].depth), table_number(&t, depths_tried[k].least);
        for (int i = RAY_SHADOW; i <= RAY_REFRACTION; i++)
            table_number(&t, (double)rays.rays[i] / (w * h));
        table_number(&t, d.rmse), table_number(&t, d.maximum), table_number(&t, ns);
        plot_add(&p, depths_tried[k].least > 0, ns, d.rmse);
    }
    output_table(o, &t);
    output_plot(o, &p, "19_whitted_time.svg");
    image_free(&im), image_free(&deep), stage_end(f), free(f);
}

typedef struct { image im; const first_scene *s; const first_world *x; } first_picture;

/* One ray a pixel, depth 8; x NULL: by first.h. */
static inline double first_picture_draw(void *context)
{
    first_picture *p = context;
    first_camera c = first_two_balls_camera(p->im.width, p->im.height);
    for (int i = 0; i < p->im.width * p->im.height; i++) {
        int x = i % p->im.width, y = i / p->im.width;
        ray r = first_ray_unit(first_pixel_ray(c, x, y, 0, 1));
        image_set(&p->im, x, y, p->x ? first_world_ray(p->x, r) : first_whitted(p->s, r, 8));
    }
    return (double)p->im.rgb[0];
}

/* Five things: a tree has nothing to gain, and `first` is no slower for asking them all. */
static inline void table_of_first(const options *o)
{
    first_scene s = first_two_balls();
    first_world *x = first_world_new(&s, 8);
    int w = o->quick ? 64 : 480, h = w * 5 / 8;
    first_picture p[2] = {{image_new(w, h), &s, NULL}, {image_new(w, h), &s, x}};
    double ns[2];
    bench_each(first_picture_draw, p, sizeof *p, 2, o->quick ? 1 : 5, 1e9 / ((double)w * h), ns);
    table t = table_new("Two balls over a board, one thread, one ray a pixel, depth 8",
                        "method|pixels off by 1e-6|error: rmse|error: most|time [ns/pixel]");
    for (int k = 0; k < 2; k++) {
        image_difference d = image_compare(&p[k].im, &p[1].im);
        size_t off = 0;
        for (int i = 0; i < w * h; i++) {
            vec3 a = image_get(&p[k].im, i % w, i / w), b = image_get(&p[1].im, i % w, i / w);
            vec3 by = vsub(a, b);
            off += fabs(vaxis(by, vlongest(by))) > (real)1e-6;
        }
        table_text(&t, k ? "whitted" : "first"), table_count(&t, off);
        table_number(&t, d.rmse), table_number(&t, d.maximum), table_number(&t, ns[k]);
    }
    output_extra_table(o, &t);
    image_free(&p[0].im), image_free(&p[1].im), first_world_free(x);
}

#endif
