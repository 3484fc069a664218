/* measure.h: the table.
 *
 *   table_of_depths(&o)     error against time over depth and over the cut, and its plot
 */
#ifndef WHITTED_LAB_MEASURE_H
#define WHITTED_LAB_MEASURE_H

#include "../../../common/lab/report.h"
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

#endif
