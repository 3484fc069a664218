/* measure.h: the tables: ways to leave a surface, near and far; rays spent.
 *
 *   table_of_leaving(&o)     acne and leaks of spheres and triangles, with time
 *   table_of_needles(&o)     pbrt's bounds and ours on 1e5 needles
 *   plot_of_leaving(&o)      acne and leaks of triangles against time
 *   table_of_rays(&o)        shadow rays, only what is called for and all
 */
#ifndef SHADE_LAB_MEASURE_H
#define SHADE_LAB_MEASURE_H

#include "../../../common/lab/bench.h"
#include "../../../common/lab/report.h"
#include "departures.h"
#include "gallery.h"

/* ---------------------------------------------------------------------------------------------- */

typedef struct { double self, leak; } leaving_score;  /* per cent */

static inline void leaving_play(departure_kind kind, real size, real T, const options *o,
                                leaving_score score[leavings])
{
    departure x;
    size_t n = o->quick ? 300 : 2000;
    double one = 100 / (double)n;
    for (int k = 0; k < leavings; k++) score[k] = (leaving_score){0, 0};
    for (size_t i = 0; i < n; i++) {
        departure_make(&x, kind, size, T, o->seed, i);
        real gap = departure_gap(&x);
        for (int k = 0; k < leavings; k++) {
            score[k].self += one * departure_self(&x, ways[k]);
            score[k].leak += one * departure_leak(&x, ways[k], gap);
        }
    }
}

enum { leaving_batch = 256 };
typedef struct { departure x[leaving_batch]; leaving way; } leaving_run;

/* From the hit to the ray: the point, its normal, the way out. */
static inline double leaving_seconds(void *context)
{
    const leaving_run *b = context;
    double sum = 0;
    for (int i = 0; i < leaving_batch; i++) {
        ray r = departure_ray(&b->x[i], b->way, b->x[i].w);
        sum += (double)(r.o.x + r.o.y + r.o.z + r.tmin);
    }
    return sum;
}

static inline void leaving_time(departure_kind kind, uint64_t seed, double ns[leavings])
{
    leaving_run *b = allocate(leavings, sizeof *b);
    for (int k = 0; k < leavings; k++) {
        for (int i = 0; i < leaving_batch; i++)
            departure_make(&b[k].x[i], kind, 1, 1, seed, (uint64_t)i);
        b[k].way = ways[k];
    }
    bench_each(leaving_seconds, b, sizeof *b, leavings, 31, 1e9 / leaving_batch, ns);
    free(b);
}

static inline void table_of_leaving(const options *o)
{
    static const char *const names[] = {"sphere", "triangle"};
    table t = table_new("Leaving a surface of size 1 at the origin, and T = 1e6 away",
                        "method|shape|error: acne T=0 [%]|error: acne 1e6|error: leak T=0 [%]|"
                        "error: leak 1e6|time [ns]");
    for (int s = 0; s < 2; s++) {
        leaving_score near[leavings], far[leavings];
        double ns[leavings];
        leaving_play((departure_kind)s, 1, 0, o, near);
        leaving_play((departure_kind)s, 1, 1e6, o, far);
        leaving_time((departure_kind)s, o->seed, ns);
        for (int k = 0; k < leavings; k++) {
            table_text(&t, "%s", ways[k].name), table_text(&t, "%s", names[s]);
            table_number(&t, near[k].self), table_number(&t, far[k].self);
            table_number(&t, near[k].leak), table_number(&t, far[k].leak);
            table_number(&t, ns[k]);
        }
    }
    output_table(o, &t);
}

/* Triangles of one radius to 1e-4 of it: bounds of the point alone, and with those of the test. */
static inline void table_of_needles(const options *o)
{
    static const real far[3] = {0, 1, 100};
    size_t n = o->quick ? 1000 : 100000;
    table t = table_new("Needles, 1e5 of each: rays that meet the one they leave; plates passed",
                        "method|error: acne T=0|error: acne T=1|error: acne T=100|"
                        "error: leaks T=0");
    for (int k = leavings - 2; k < leavings; k++) {
        size_t self[3] = {0}, leak = 0;
        for (int e = 0; e < 3; e++)
            for (size_t i = 0; i < n; i++) {
                departure x;
                departure_make(&x, DEPART_NEEDLE, 1, far[e], o->seed, i);
                self[e] += departure_self(&x, ways[k]);
                if (e == 0) leak += departure_leak(&x, ways[k], departure_gap(&x));
            }
        table_text(&t, "%s", ways[k].name);
        for (int e = 0; e < 3; e++) table_count(&t, self[e]);
        table_count(&t, leak);
    }
    output_extra_table(o, &t);
}

static inline void plot_of_leaving(const options *o)
{
    plot time = plot_new("Acne and leaks, triangles of size 100, against time",
                         "time of hit point and ray [ns]", "the larger of acne and leak [%]",
                         PLOT_LOG_Y);
    leaving_score score[leavings];
    double ns[leavings];
    leaving_play(DEPART_TRIANGLE, 100, 0, o, score);
    leaving_time(DEPART_TRIANGLE, o->seed, ns);
    for (int k = 0; k < leavings; k++)
        plot_add(&time, plot_series(&time, ways[k].name), ns[k],
                 fmax(score[k].self, score[k].leak));
    output_plot(o, &time, "18_shade_time.svg");
}

/* One ray a pixel: ours, ours with all shadow rays, and shade() as printed. */
static inline void table_of_rays(const options *o)
{
    static const char *const names[] = {"only what is called for", "all the same",
                                        "as printed, depth 2", "as printed, depth 8"};
    enum { width = 400, height = 225, pixels = width * height };
    image ours = image_new(width, height), im = image_new(width, height);
    gallery *g = gallery_new(o->quick ? 6 : 24, 0);
    camera view = gallery_camera(0, (real)width / height);
    table t = table_new("Rays spent on the gallery, 400 x 225 pixels, one camera ray each",
                        "shadow rays|camera|hits|shadow|stopped|pictures differ [pixels]|time [s]");
    for (int k = 0; k < 4; k++) {
        shading how = gallery_shading(g);
        how.spend_all = k == 1;
        double start = clock_seconds();
        gallery_view v = {.g = g, .how = how, .c = view, .samples = 1, .im = k ? &im : &ours,
                          .printed = k < 2 ? 0 : k == 2 ? 2 : 8};
        gallery_draw(&v, o->threads);
        trace_counts c = v.counts;
        double spent = clock_seconds() - start;
        size_t differ = 0;
        for (size_t i = 0; k && i < pixels; i++)
            differ += memcmp(ours.rgb + 3 * i, im.rgb + 3 * i, 3 * sizeof(float)) != 0;
        table_text(&t, "%s", names[k]);
        table_count(&t, c.rays[RAY_CAMERA]), table_count(&t, c.hits[RAY_CAMERA]);
        table_count(&t, c.rays[RAY_SHADOW]), table_count(&t, c.hits[RAY_SHADOW]);
        table_count(&t, differ), table_number(&t, spent);
    }
    output_extra_table(o, &t);
    image_free(&ours), image_free(&im), gallery_free(g);
}

#endif
