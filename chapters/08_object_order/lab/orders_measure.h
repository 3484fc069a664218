/* orders_measure.h: the tables and plots of this chapter. The oracle of what a pixel shows is 07's
 * ray through its middle, which is watertight and rounds nothing to a grid.
 *
 *   orders_measure(&o)       the main table: pixels that differ, time
 *   orders_times(&o)         a plot: both orders against the number of triangles (--full)
 *   orders_shadows(&o)       shadow maps against shadow rays (--full)
 */
#ifndef ORDERS_MEASURE_H
#define ORDERS_MEASURE_H

#include "../../../common/lab/bench.h"
#include "../../../common/lab/report.h"
#include "orders_draw.h"

/* ---------------------------------------------------------------------------------------------- */

/* One way to make the picture: bits > 0 raster.h, 0 first.h, -1 rays. */
typedef struct { const mesh *m; camera c; int nx, ny, bits; size_t asked, covered; } orders_way;

static inline raster orders_by(orders_way *k)
{
    raster_how how = raster_default;
    how.bits = k->bits;
    if (k->bits == 0) {
        first_asked = first_covered = 0;
        raster first = orders_first(k->m, k->c, k->nx, k->ny);
        first.asked = (size_t)first_asked, first.covered = (size_t)first_covered;
        return first;
    }
    raster s = raster_new(k->nx, k->ny);
    if (k->bits > 0) raster_mesh(&s, k->m, k->c, how);
    else (void)orders_rays(&s, k->m, k->c, 1);
    return s;
}

static inline double orders_once(void *context)
{
    raster s = orders_by(context);
    double sum = (double)s.h[s.nx * s.ny / 2].t;
    raster_free(&s);
    return sum;
}

enum { orders_ways = 6 };
static inline void orders_measure(const options *o)
{
    static const int bits[orders_ways] = {0, 1, 4, 8, 16, -1};
    static const char *const name[orders_ways] = {"first", "raster, 1 bit", "raster, 4 bits",
        "raster, 8 bits", "raster, 16 bits", "rays, each triangle"};
    int nx = o->quick ? 40 : o->full ? 320 : 120, ny = nx * 3 / 4;
    mesh m = orders_scene(o->quick ? 2 : 4);
    camera c = orders_camera((real)4 / 3);
    orders_way way[orders_ways];
    double ms[orders_ways];
    raster due = raster_new(nx, ny);
    char title[80];
    (void)orders_rays(&due, &m, c, o->threads);
    snprintf(title, sizeof title, "Two orders, %zu triangles, %d x %d pixels", m.triangles, nx, ny);
    table t = table_new(title, "order|pixels asked|covered|error: another triangle [pixels]|"
                               "error: unexplained|time [ms]");
    for (int k = 0; k < orders_ways; k++)
        way[k] = (orders_way){&m, c, nx, ny, bits[k], 0, 0};
    bench_each(orders_once, way, sizeof *way, orders_ways, o->full ? 9 : 3, 1e3, ms);
    for (int k = 0; k < orders_ways; k++) {
        raster s = bits[k] < 0 ? due : orders_by(&way[k]);
        int step = bits[k] > 0 ? bits[k] : 8;
        orders_difference d = orders_compare(&s, &due, &m, c, step);
        table_text(&t, "%s", name[k]);
        if (bits[k] < 0)
            table_count(&t, (size_t)(nx * ny) * m.triangles), table_text(&t, "-");
        else table_count(&t, s.asked), table_count(&t, s.covered);
        table_count(&t, d.other), table_count(&t, d.unexplained), table_number(&t, ms[k]);
        raster_free(&s);
    }
    output_table(o, &t);
    mesh_free(&m);
}

/* ---------------------------------------------------------------------------------------------- */

/* Rays are few where triangles are many: each asks them all. */
static inline void orders_times(const options *o)
{
    static const int cells[6] = {1, 2, 4, 8, 16, 32};
    plot p = plot_new("The two orders, no structure, 640 x 480 pixels", "triangles", "time [ms]",
                      PLOT_LOG_X | PLOT_LOG_Y);
    enum { nx = 640, ny = 480, n = nx * ny };
    int drawn = plot_series(&p, "object order"), rays = plot_series(&p, "rays");
    camera c = orders_camera((real)nx / ny);
    for (int k = 0; k < 6; k++) {
        mesh m = orders_scene(cells[k]);
        int less = (int)fmax(1, sqrt((double)n * (double)m.triangles / 4e6));
        int few = nx / less > 4 ? nx / less : 4;
        orders_way way[2] = {{&m, c, nx, ny, 8, 0, 0}, {&m, c, few, few * 3 / 4, -1, 0, 0}};
        double ms[2];
        bench_each(orders_once, way, sizeof *way, 2, 3, 1e3, ms);
        plot_add(&p, drawn, (double)m.triangles, ms[0]);
        plot_add(&p, rays, (double)m.triangles, ms[1] * n / (few * (few * 3 / 4)));
        mesh_free(&m);
    }
    output_plot(o, &p, "08_object_order_time.svg");
}

/* ---------------------------------------------------------------------------------------------- */

typedef struct { const raster *s; const mesh *m; int side; real bias; bool *dark; } orders_shadow;

/* All pixels: by a map of side x side made anew, or (0) by rays. */
static inline double orders_shadow_run(void *context)
{
    const orders_shadow *j = context;
    shadow_map t = {0};
    if (j->side) t = shadow_map_new(j->m, orders_lamp(), j->side, raster_default);
    for (int k = 0; k < j->s->nx * j->s->ny; k++)
        j->dark[k] = orders_dark(j->s, j->m, j->side ? &t : NULL, j->bias, k);
    if (j->side) shadow_map_free(&t);
    return j->dark[0];
}

static inline void orders_shadows(const options *o)
{
    static const int sides[4] = {64, 256, 1024, 0};
    static const real bias[3] = {0, (real)0.04, (real)0.004};  /* the last is timed */
    enum { nx = 320, ny = 240 };
    static bool due[nx * ny], dark[nx * ny];
    mesh m = orders_scene(4);
    raster s = raster_new(nx, ny);
    raster_mesh(&s, &m, orders_camera((real)nx / ny), raster_default);
    table t = table_new("Shadow maps against shadow rays", "texels|error: no bias [% of pixels]|"
                        "error: bias 0.04|error: bias 0.004|time [ms]");
    orders_shadow w[4];
    double ms[4];
    for (int k = 0; k < 4; k++) w[k] = (orders_shadow){&s, &m, sides[k], bias[2], dark};
    bench_each(orders_shadow_run, w, sizeof *w, 4, 3, 1e3, ms);
    memcpy(due, dark, sizeof due);  /* of the last: by rays */
    for (int k = 0; k < 4; k++) {
        table_text(&t, sides[k] ? "%d x %d" : "rays", sides[k], sides[k]);
        for (int j = 0; j < 3; j++) {
            size_t wrong = 0;
            w[k].bias = bias[j], orders_shadow_run(&w[k]);
            for (int i = 0; i < nx * ny; i++) wrong += dark[i] != due[i];
            table_number(&t, 100 * (double)wrong / (nx * ny));
        }
        table_number(&t, ms[k]);
    }
    output_extra_table(o, &t);
    raster_free(&s), mesh_free(&m);
}

#endif
