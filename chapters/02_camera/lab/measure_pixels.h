/* measure_pixels.h: error and time of a pixel, by filter, placement and number of rays.
 *
 *   measure_filters(..)  box, tent, Gaussian; regular, jittered, random; 1, 4, 16 ... rays a pixel,
 *                        on a checkerboard and a zone plate whose filtered value pattern.h knows
 *   measure_wall(..)     a white wall: divided by the sum of weights, or by what that is on average
 *
 * Errors are root mean squares over 32 x 32 pixels, each against the exact value of its own filter.
 */
#ifndef MEASURE_PIXELS_H
#define MEASURE_PIXELS_H

#include "draw.h"
#include "measure_rays.h"
#include "pattern.h"

enum { measure_side = 32 };
typedef struct { view v; const double *exact; } measure_pixels;

/* ---------------------------------------------------------------------------------------------- */

/* Root mean square error of measure_side^2 pixels. */
static inline double run_pixels(void *context)
{
    const measure_pixels *m = context;
    double square = 0;
    for (int i = 0; i < measure_side * measure_side; i++) {
        vec3 c = view_pixel(&m->v, i % measure_side, i / measure_side);
        square += ((double)c.x - m->exact[i]) * ((double)c.x - m->exact[i]);
    }
    return sqrt(square / (measure_side * measure_side));
}

/* The same of a white wall, which needs no rays to be seen: only weights count. */
static inline double wall_error(const measure_pixels *m, bool naive)
{
    const view *v = &m->v;
    double square = 0;
    for (int i = 0; i < measure_side * measure_side; i++) {
        random_stream s = random_start(v->seed, (uint64_t)i, 0);
        filter_sum sum = {{0, 0, 0}, 0};
        for (int k = 0; k < v->n * v->n; k++) {
            real x, y;
            samples_place(v->how, k, v->n, v->f.radius, &s, &x, &y);
            sum = filter_add(sum, filter_weight(v->f, x, y), (vec3){1, 1, 1});
        }
        vec3 c = naive ? filter_mean_naive(sum, v->f, v->n * v->n) : filter_mean(sum);
        square += ((double)c.x - 1) * ((double)c.x - 1);
    }
    return sqrt(square / (measure_side * measure_side));
}
static inline double run_wall(void *context) { return wall_error(context, false); }
static inline double run_wall_naive(void *context) { return wall_error(context, true); }

/* What a ray meets in the plane z = 0, seen by pixel_grid: one unit a pixel. */
static inline vec3 see_pattern(ray r, double (*pattern)(double x, double y, double knob),
                               double knob)
{
    vec3 p = ray_at(r, -r.o.z / r.d.z);
    real c = (real)pattern((double)p.x, (double)p.y, knob);
    return (vec3){c, c, c};
}

static inline vec3 see_zone_plate(const view *v, ray r)
{
    return see_pattern(r, zone_plate, *(const double *)v->own);
}
static inline vec3 see_checkerboard(const view *v, ray r)
{
    return see_pattern(r, checkerboard, *(const double *)v->own);
}

/* Orthographic, looking down on z = 0; the picture of side x side pixels is as many units wide. */
static inline camera pixel_grid(int side)
{
    camera_frame f;
    camera c = {.kind = CAMERA_PARALLEL};
    real h = (real)side / 2;
    if (frame_look_at((vec3){0, 0, 1}, (vec3){0, 0, 0}, (vec3){0, 1, 0}, &f, NULL))
        (void)camera_orthographic(f, (camera_window){-h, h, -h, h}, &c, NULL);
    return c;
}

typedef struct { const char *name; filter f; sample_placement how; bool zone; } measure_filter;

/* Error and time of a pixel under some filters and placements, with 1, 4, 16 ... rays. */
static inline void measure_filters(table *t, plot *board, plot *zone, plot *time, int finest,
                                   int rounds)
{
    const measure_filter way[] = {
        {"box jittered", filter_box, SAMPLES_JITTERED, false},
        {"tent jittered", filter_tent, SAMPLES_JITTERED, false},
        {"Gaussian jittered", filter_gaussian, SAMPLES_JITTERED, false},
        {"tent regular", filter_tent, SAMPLES_REGULAR, false},
        {"tent random", filter_tent, SAMPLES_RANDOM, false},
        {"Gaussian random", filter_gaussian, SAMPLES_RANDOM, true},
        {"Gaussian jittered", filter_gaussian, SAMPLES_JITTERED, true},
        {"Gaussian regular", filter_gaussian, SAMPLES_REGULAR, true}};
    enum { ways = sizeof way / sizeof way[0], pixels = measure_side * measure_side };
    static const double cell = 1.37, rings = 0.03;  /* no whole numbers of pixels; 2.4 rings */
    static double exact[ways][pixels];
    image grid = {measure_side, measure_side, NULL};  /* only its size is asked for */
    int series[ways], on_time[ways];
    for (int j = 0; j < ways; j++) {
        series[j] = plot_series(way[j].zone ? zone : board, way[j].name);
        if (!way[j].zone) on_time[j] = plot_series(time, way[j].name);
        for (int i = 0; i < pixels; i++) {
            double x = i % measure_side + 0.5 - measure_side / 2;
            double y = measure_side / 2 - 0.5 - i / measure_side;
            exact[j][i] = way[j].zone ? zone_plate_filtered(x, y, rings, (double)way[j].f.sigma)
                                      : checkerboard_filtered(x, y, cell, way[j].f);
        }
    }
    for (int n = 1; n <= finest; n *= 2) {
        measure_pixels m[ways];
        clock_variant v[ways];
        for (int j = 0; j < ways; j++) {
            m[j] = (measure_pixels){{.c = pixel_grid(measure_side), .f = way[j].f, .n = n,
                .how = way[j].how, .seed = 1, .own = way[j].zone ? &rings : &cell, .out = &grid,
                .see = way[j].zone ? see_zone_plate : see_checkerboard}, exact[j]};
            v[j] = (clock_variant){way[j].name, run_pixels, &m[j], 0};
        }
        clock_compare(v, ways, n < 16 ? 3 * rounds : rounds);  /* short ones are disturbed more */
        for (int j = 0; j < ways; j++) {
            double error = run_pixels(&m[j]), ns = 1e9 * v[j].seconds / pixels;
            plot_add(way[j].zone ? zone : board, series[j], n * n, error);
            if (!way[j].zone) plot_add(time, on_time[j], ns, error);
            if (n == 4 || n == 16)
                measure_row(t, way[j].zone ? "zone plate [white = 1]" : "checkerboard [white = 1]",
                            way[j].name, "%g rays", n * n, error, ns);
        }
    }
}

/* A white wall, 16 jittered rays a pixel under the tent. */
static inline void measure_wall(table *t, int rounds)
{
    measure_pixels m = {{.f = filter_tent, .n = 4, .how = SAMPLES_JITTERED, .seed = 1}, NULL};
    clock_variant v[] = {{"sum / expected weight", run_wall_naive, &m, 0},
                         {"sum / weight", run_wall, &m, 0}};
    clock_compare(v, 2, rounds);
    for (int j = 0; j < 2; j++)
        measure_row(t, "white wall [white = 1]", v[j].name, "%g rays", 16, v[j].run(&m),
                    1e9 * v[j].seconds / (measure_side * measure_side));
}

#endif
