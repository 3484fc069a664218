/* measure.h: the tables: ways to leave a surface against position and size; rays spent.
 *
 *   table_of_spheres(&o)     acne and leaks of spheres near and far, with time: the short table
 *   table_of_leaving(&o)     also of triangles, against T, with two plots
 *   table_of_sizes(&o)       against the size of the shapes
 *   table_of_rays(&o)        shadow rays, only what is called for and all
 */
#ifndef SHADE_LAB_MEASURE_H
#define SHADE_LAB_MEASURE_H

#include "../../../common/lab/bench.h"
#include "../../../common/lab/report.h"
#include "departures.h"
#include "gallery.h"
#include "leave_f32.h"

/* ---------------------------------------------------------------------------------------------- */

typedef struct { double self, leak; } leaving_score;  /* per cent */

/* One score for each of `ways`, and one behind them for float with a fixed eps of 1e-4. */
static inline void leaving_play(departure_kind kind, real size, real T, uint64_t seed, size_t n,
                                leaving_score score[leavings + 1])
{
    departure x;
    double one = 100 / (double)n;
    for (int k = 0; k <= leavings; k++) score[k] = (leaving_score){0, 0};
    for (size_t i = 0; i < n; i++) {
        departure_make(&x, kind, size, T, seed, i);
        real gap = departure_gap(&x);
        for (int k = 0; k < leavings; k++) {
            score[k].self += one * departure_self(&x, ways[k]);
            score[k].leak += one * departure_leak(&x, ways[k], gap);
        }
        if (kind != DEPART_SPHERE && kind != DEPART_TRIANGLE) continue;
        score[leavings].self += one * departure_self_f32(&x, 1e-4f);
        score[leavings].leak += one * departure_leak_f32(&x, 1e-4f, gap);
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
    bench_candidate v[leavings];
    for (int k = 0; k < leavings; k++) {
        for (int i = 0; i < leaving_batch; i++)
            departure_make(&b[k].x[i], kind, 1, 1, seed, (uint64_t)i);
        b[k].way = ways[k];
        v[k] = (bench_candidate){ways[k].name, leaving_seconds, &b[k], 0, 0};
    }
    bench_time(v, leavings, 31);
    for (int k = 0; k < leavings; k++) ns[k] = 1e9 * v[k].seconds / leaving_batch;
    free(b);
}

static inline const char *leaving_name(int k)
{
    return k < leavings ? ways[k].name : "float, eps 1e-4";
}

/* Every step-th of the scores. */
static inline void leaving_cells(table *t, leaving_score score[][leavings + 1], int k, int step)
{
    for (int e = 0; e < 4; e++) table_number(t, score[e * step][k].self);
    for (int e = 0; e < 4; e++) table_number(t, score[e * step][k].leak);
}

static inline void table_of_leaving(const options *o)
{
    static const departure_kind kinds[] = {DEPART_SPHERE, DEPART_TRIANGLE};
    size_t n = o->quick ? 300 : 20000;
    plot p = plot_new("Acne and leaks, spheres of radius 1", "distance T from the origin",
                      "acne + leak [%]", PLOT_LOG_X);
    plot against_time = plot_new("Acne and leaks, triangles of size 100, against time",
                                 "time of hit point and ray [ns]", "acne + leak [%]", PLOT_LOG_Y);
    table t = table_new("Leaving a surface of size 1, by its distance T from the origin",
                        "method|shape|error: acne T=0 [%]|error: acne 1e2|error: acne 1e4|"
                        "error: acne 1e6|error: leak T=0 [%]|error: leak 1e2|error: leak 1e4|"
                        "error: leak 1e6|time [ns]");
    for (int s = 0; s < 2; s++) {
        leaving_score score[7][leavings + 1], large[leavings + 1];
        double ns[leavings];
        for (int e = 0; e <= 6; e++)
            leaving_play(kinds[s], 1, e ? pow((real)10, (real)e) : 0, o->seed, n, score[e]);
        leaving_play(kinds[s], 100, 0, o->seed, n, large);
        leaving_time(kinds[s], o->seed, ns);
        for (int k = 0; k <= leavings; k++) {
            table_text(&t, "%s", leaving_name(k)), table_text(&t, s ? "triangle" : "sphere");
            leaving_cells(&t, score, k, 2);
            if (k < leavings) table_number(&t, ns[k]);
            else table_text(&t, "-");
            int all = s ? -1 : plot_series(&p, leaving_name(k));
            for (int e = 0; e <= 6 && !s; e++)
                plot_add(&p, all, e ? pow(10, e) : 1, score[e][k].self + score[e][k].leak);
            if (s && k < leavings)
                plot_add(&against_time, plot_series(&against_time, ways[k].name), ns[k],
                         large[k].self + large[k].leak);
        }
    }
    output_table(o, &t);
    output_plot(o, &p, "18_shade_error.svg");
    output_plot(o, &against_time, "18_shade_time.svg");
}

/* Of spheres alone, with a tenth of the rays. */
static inline void table_of_spheres(const options *o)
{
    size_t n = o->quick ? 300 : 2000;
    leaving_score near[leavings + 1], far[leavings + 1];
    double ns[leavings];
    table t = table_new("Leaving a sphere of radius 1 at the origin, and T = 1e6 away",
                        "method|error: acne T=0 [%]|error: acne 1e6|error: leak T=0 [%]|"
                        "error: leak 1e6|time [ns]");
    leaving_play(DEPART_SPHERE, 1, 0, o->seed, n, near);
    leaving_play(DEPART_SPHERE, 1, 1e6, o->seed, n, far);
    leaving_time(DEPART_SPHERE, o->seed, ns);
    for (int k = 0; k <= leavings; k++) {
        table_text(&t, "%s", leaving_name(k));
        table_number(&t, near[k].self), table_number(&t, far[k].self);
        table_number(&t, near[k].leak), table_number(&t, far[k].leak);
        if (k < leavings) table_number(&t, ns[k]);
        else table_text(&t, "-");
    }
    output_table(o, &t);
}

static inline void table_of_sizes(const options *o)
{
    static const char *const names[departure_kinds] = {"sphere", "triangle", "needle", "cone",
                                                       "polygon"};
    size_t n = o->quick ? 100 : 5000;
    plot p = plot_new("Acne and leaks, triangles at the origin", "size of the triangle",
                      "acne + leak [%]", PLOT_LOG_X | PLOT_LOG_Y);
    table t = table_new("Leaving a surface at the origin, by its size",
                        "method|shape|acne 1e-3 [%]|acne 1|acne 1e3|acne 1e6|"
                        "leak 1e-3 [%]|leak 1|leak 1e3|leak 1e6");
    for (int kind = 0; kind < departure_kinds; kind++) {
        leaving_score score[10][leavings + 1];
        bool drawn = kind == DEPART_TRIANGLE, all = drawn || kind == DEPART_SPHERE;
        for (int e = 0; e < 10; e++)
            if (e % 3 == 0 || drawn)
                leaving_play((departure_kind)kind, pow((real)10, (real)(e - 3)), 0, o->seed, n,
                             score[e]);
        for (int k = 0; k <= leavings; k++) {
            int series = drawn ? plot_series(&p, leaving_name(k)) : -1;
            for (int e = 0; e < 10 && drawn; e++)
                plot_add(&p, series, pow(10, e - 3), score[e][k].self + score[e][k].leak);
            if (!all && (k < leavings - 2 || k == leavings)) continue;
            table_text(&t, "%s", leaving_name(k)), table_text(&t, "%s", names[kind]);
            leaving_cells(&t, score, k, 3);
        }
    }
    output_extra_table(o, &t);
    output_plot(o, &p, "18_shade_size.svg");
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
        trace_counts c;
        how.spend_all = k == 1;
        double start = clock_seconds();
        if (k < 2) gallery_draw(g, how, view, 1, o->threads, k ? &im : &ours, &c);
        else gallery_draw_printed(g, view, k == 2 ? 2 : 8, o->threads, &im, &c);
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
