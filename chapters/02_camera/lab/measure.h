/* measure.h: error and time of a pixel.
 *
 *   camera_measure_filters(&o)  box, tent, Gaussian; regular, jittered, random; 4, 16, 256 rays a
 *                               pixel, on patterns whose filtered value is known: the main
 *                               table; with --full a plot of 1 to 1024 rays
 *
 * Errors of pixels are root mean squares over 32 x 32, each against the exact value of its own
 * filter.
 *
 * The patterns:
 *   checkerboard   1/2 + 1/2 s(x) s(y), s = +1 and -1 in turn, on stretches of length `cell`
 *   zone plate     1/2 + 1/2 cos(a (x^2 + y^2)): rings that get finer outward (波带片);
 *                  at distance R they are pi / (a R) apart, so a grid of pixels can show them up to
 *                  R = pi / (2 a), and nothing but grey should remain beyond
 *
 *   checkerboard(x, y, cell)   checkerboard_filtered(x, y, cell, f)       f: box or tent
 *   zone_plate(x, y, a)        zone_plate_filtered(x, y, a, sigma)       under a Gaussian
 *
 * (x, y) in pixels. A separable filter turns s(x) s(y) into the product of two integrals:
 * differences of the first antiderivative of s under the box, of the second under the tent. The
 * zone plate is the real part of exp(i a x^2) exp(i a y^2), and under a Gaussian without cut-off,
 * with g = 1 - 2 i a sigma^2,
 *   E exp(i a X^2) = g^(-1/2) exp(i a x^2 / g)                                 (2.12)
 * These are oracles: always in double, right to 1e-12 for |x|, |y| up to 1000, but for the zone
 * plate unfiltered: to an epsilon of its phase a (x^2 + y^2).
 */
#ifndef CAMERA_LAB_MEASURE_H
#define CAMERA_LAB_MEASURE_H

#include "../../../common/lab/bench.h"
#include "../../../common/lab/report.h"
#include "draw.h"

/* ---------------------------------------------------------------------------------------------- */

/* s(x): +1 on [0, cell), -1 on [cell, 2 cell), and so on, both ways. */
static inline double square_wave(double x, double cell)
{
    double k = floor(x / cell);
    return k - 2 * floor(k / 2) == 0 ? 1 : -1;
}

/* Its first antiderivative without the mean, and the antiderivative of that: periodic. */
static inline double square_wave_integral(double x, double cell)
{
    double p = x - 2 * cell * floor(x / (2 * cell));
    return p < cell ? p - cell / 2 : 3 * cell / 2 - p;
}

static inline double square_wave_integral_2(double x, double cell)
{
    double p = x - 2 * cell * floor(x / (2 * cell)), y = p < cell ? p : p - cell;
    return (p < cell ? 1 : -1) * (y * y - cell * y) / 2;
}

static inline double square_wave_filtered(double x, double cell, filter f)
{
    double R = (double)f.radius;
    if (f.kind == FILTER_BOX)
        return (square_wave_integral(x + R, cell) - square_wave_integral(x - R, cell)) / (2 * R);
    return (square_wave_integral_2(x + R, cell) - 2 * square_wave_integral_2(x, cell)
            + square_wave_integral_2(x - R, cell)) / (R * R);
}

static inline double checkerboard(double x, double y, double cell)
{
    return 0.5 + 0.5 * square_wave(x, cell) * square_wave(y, cell);
}

static inline double checkerboard_filtered(double x, double y, double cell, filter f)
{
    return 0.5 + 0.5 * square_wave_filtered(x, cell, f) * square_wave_filtered(y, cell, f);
}

static inline double zone_plate(double x, double y, double a)
{
    return 0.5 + 0.5 * cos(a * (x * x + y * y));
}

/* (2.12) for both axes: g^-1 exp(i a r^2 / g), 1 / g = (1 + i q) / (1 + q^2), q = 2 a sigma^2. */
static inline double zone_plate_filtered(double x, double y, double a, double sigma)
{
    double q = 2 * a * sigma * sigma, h = 1 / (1 + q * q), phase = a * (x * x + y * y) * h;
    return 0.5 + 0.5 * h * exp(-q * phase) * (cos(phase) - q * sin(phase));
}

/* ---- trials ---- */

enum { camera_side = 32, camera_pixels = camera_side * camera_side };

typedef struct { camera_view v; const double *exact; } camera_trial;

/* Root mean square error of camera_side^2 pixels. */
static inline double camera_run_pixels(void *context)
{
    const camera_trial *m = context;
    double square = 0;
    for (int i = 0; i < camera_pixels; i++) {
        vec3 c = camera_view_pixel(&m->v, i % camera_side, i / camera_side);
        square += ((double)c.x - m->exact[i]) * ((double)c.x - m->exact[i]);
    }
    return sqrt(square / camera_pixels);
}

typedef struct { double (*at)(double x, double y, double knob), knob; } camera_pattern;

/* What a ray meets in the plane z = 0, seen by camera_grid: one unit a pixel. v->own: a pattern. */
static inline vec3 see_pattern(const camera_view *v, ray r)
{
    const camera_pattern *own = v->own;
    vec3 p = ray_at(r, -r.o.z / r.d.z);
    real c = (real)own->at((double)p.x, (double)p.y, own->knob);
    return (vec3){c, c, c};
}

/* Orthographic, looking down on z = 0; the picture of side x side pixels is as many units wide. */
static inline camera camera_grid(int side)
{
    camera_frame f = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    real h = (real)side / 2;
    camera c;
    failure why;
    if (!camera_orthographic(f, (camera_window){-h, h, -h, h}, &c, &why)) fail(why);
    return c;
}

typedef struct { const char *name; filter f; sample_placement how; } camera_way;
static const camera_way camera_ways[] = {
    {"box jittered", {FILTER_BOX, 0.5, 0}, SAMPLES_JITTERED},
    {"tent jittered", {FILTER_TENT, 1, 0}, SAMPLES_JITTERED},
    {"tent regular", {FILTER_TENT, 1, 0}, SAMPLES_REGULAR},
    {"tent random", {FILTER_TENT, 1, 0}, SAMPLES_RANDOM},
    {"Gaussian random", {FILTER_GAUSSIAN, 2, 0.5}, SAMPLES_RANDOM},
    {"Gaussian jittered", {FILTER_GAUSSIAN, 2, 0.5}, SAMPLES_JITTERED},
    {"Gaussian regular", {FILTER_GAUSSIAN, 2, 0.5}, SAMPLES_REGULAR}};
/* The first four see a checkerboard, the others a zone plate. */
enum { camera_way_count = sizeof camera_ways / sizeof camera_ways[0], camera_boards = 4 };

/* Trials with n x n rays a pixel; exact values are found once. */
static inline void camera_trials(camera_trial m[camera_way_count], int n)
{
    /* no whole numbers of pixels; 2.4 rings */
    static const camera_pattern cells = {checkerboard, 1.37}, rings = {zone_plate, 0.03};
    static double exact[camera_way_count][camera_pixels];
    for (int j = 0; j < camera_way_count; j++) {
        const camera_way *k = &camera_ways[j];
        bool zone = j >= camera_boards;
        for (int i = 0; i < camera_pixels; i++) {
            double x = i % camera_side + 0.5 - camera_side / 2;
            double y = camera_side / 2 - 0.5 - i / camera_side;
            exact[j][i] = zone ? zone_plate_filtered(x, y, rings.knob, (double)k->f.sigma)
                               : checkerboard_filtered(x, y, cells.knob, k->f);
        }
        m[j].v = (camera_view){.c = camera_grid(camera_side), .f = k->f, .n = n, .how = k->how,
            .seed = 1, .own = zone ? &rings : &cells, .nx = camera_side, .ny = camera_side,
            .see = see_pattern};
        m[j].exact = exact[j];
    }
}

static inline void camera_plot_filters(const options *o)
{
    plot p = plot_new("Checkerboard", "rays a pixel", "rms error [white = 1]",
                      PLOT_LOG_X | PLOT_LOG_Y);
    for (int j = 0; j < camera_boards; j++) plot_series(&p, camera_ways[j].name);
    for (int n = 1; n <= 32; n *= 2) {
        camera_trial m[camera_way_count];
        camera_trials(m, n);
        for (int j = 0; j < camera_boards; j++) plot_add(&p, j, n * n, camera_run_pixels(&m[j]));
    }
    plot_slope(&p, -0.5, "slope -1/2"), plot_slope(&p, -0.75, "slope -3/4");
    output_plot(o, &p, "02_camera_checkerboard.svg");
}

static inline void camera_measure_filters(const options *o)
{
    camera_trial m[camera_way_count];
    double error[3][camera_way_count], ns[camera_way_count];
    const int side[] = {2, 16, 4};  /* the last one is timed */
    for (int k = 0; k < 3; k++) {
        camera_trials(m, side[k]);
        for (int j = 0; j < camera_way_count; j++) error[k][j] = camera_run_pixels(&m[j]);
    }
    bench_each(camera_run_pixels, m, sizeof *m, camera_way_count, o->quick ? 1 : o->full ? 9 : 3,
               1e9 / camera_pixels, ns);
    table t = table_new("A pixel of several rays: rms error [white = 1] of 32 x 32, time of one",
                        "pattern|filter, positions|error 4 rays|error 16 rays|error 256 rays|"
                        "time 16 rays [ns]");
    for (int j = 0; j < camera_way_count; j++) {
        table_text(&t, "%s", j < camera_boards ? "checkerboard" : "zone plate");
        table_text(&t, "%s", camera_ways[j].name);
        table_number(&t, error[0][j]), table_number(&t, error[2][j]);
        table_number(&t, error[1][j]), table_number(&t, ns[j]);
    }
    output_table(o, &t);
    if (o->full) camera_plot_filters(o);
}

#endif
