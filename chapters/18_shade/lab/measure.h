/* measure.h: the tables: ways to leave a surface, near and far.
 *
 *   table_of_spheres(&o)     acne and leaks, with time; the main table
 *   table_of_triangles(&o)   the same of triangles, and a plot of acne and leaks against time
 *   table_of_needles(&o)     pbrt's bounds and ours on 1e5 needles
 */
#ifndef SHADE_LAB_MEASURE_H
#define SHADE_LAB_MEASURE_H

#include "../../../common/lab/bench.h"
#include "../../../common/lab/report.h"
#include "departures.h"

/* ---------------------------------------------------------------------------------------------- */

typedef struct { double self, leak; } leaving_score;  /* per cent */

static inline leaving_score leaving_play(leaving way, departure_kind kind, real size, real T,
                                         uint64_t seed, size_t n)
{
    leaving_score score = {0, 0};
    double one = 100 / (double)n;
    for (size_t i = 0; i < n; i++) {
        departure x;
        departure_make(&x, kind, size, T, seed, i);
        score.self += one * departure_self(&x, way);
        score.leak += one * departure_leak(&x, way, departure_gap(&x));
    }
    return score;
}

enum { leaving_batch = 256 };
typedef struct { const departure *x; leaving way; } leaving_run;

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
    departure *x = allocate(leaving_batch, sizeof *x);
    leaving_run b[leavings];
    for (int i = 0; i < leaving_batch; i++) departure_make(&x[i], kind, 1, 1, seed, (uint64_t)i);
    for (int k = 0; k < leavings; k++) b[k] = (leaving_run){x, ways[k]};
    bench_each(leaving_seconds, b, sizeof *b, leavings, 31, 1e9 / leaving_batch, ns);
    free(x);
}

/* Also gives the times of all ways, as the plot has them. */
static inline table table_of_leaving(const options *o, departure_kind kind, const char *title,
                                     double ns[leavings])
{
    size_t n = o->quick ? 300 : 2000;
    table t = table_new(title, "method|error: acne T=0 [%]|error: acne 1e6|error: leak T=0 [%]|"
                               "error: leak 1e6|time [ns]");
    leaving_time(kind, o->seed, ns);
    for (int k = 0; k < leavings; k++) {
        leaving_score near = leaving_play(ways[k], kind, 1, 0, o->seed, n);
        leaving_score far = leaving_play(ways[k], kind, 1, 1e6, o->seed, n);
        table_text(&t, "%s", ways[k].name);
        table_number(&t, near.self), table_number(&t, far.self);
        table_number(&t, near.leak), table_number(&t, far.leak), table_number(&t, ns[k]);
    }
    return t;
}

static inline void table_of_spheres(const options *o)
{
    double ns[leavings];
    table t = table_of_leaving(o, DEPART_SPHERE,
                               "Leaving a sphere of size 1 at the origin, and T = 1e6 away", ns);
    output_table(o, &t);
}

/* Triangles of one radius to 1e-4 of it: bounds of the point alone, and with those of the test. */
static inline void table_of_needles(const options *o)
{
    static const real far[3] = {0, 1, 100};
    size_t n = o->quick ? 1000 : 100000;
    table t = table_new("Needles, 1e5 of each: rays that meet the one they leave",
                        "method|error: acne T=0|error: acne T=1|error: acne T=100");
    size_t self[2][3] = {{0}};
    for (size_t i = 0; i < 3 * n; i++) {
        departure x;
        departure_make(&x, DEPART_NEEDLE, 1, far[i / n], o->seed, i % n);
        for (int k = 0; k < 2; k++) self[k][i / n] += departure_self(&x, ways[leavings - 2 + k]);
    }
    for (int k = 0; k < 2; k++) {
        table_text(&t, "%s", ways[leavings - 2 + k].name);
        for (int e = 0; e < 3; e++) table_count(&t, self[k][e]);
    }
    output_extra_table(o, &t);
}

static inline void plot_of_leaving(const options *o, const double ns[leavings])
{
    plot time = plot_new("Acne and leaks, triangles of size 100, against time",
                         "time of hit point and ray [ns]", "the larger of acne and leak [%]",
                         PLOT_LOG_Y);
    for (int k = 0; k < leavings; k++) {
        leaving_score s = leaving_play(ways[k], DEPART_TRIANGLE, 100, 0, o->seed,
                                       o->quick ? 300 : 2000);
        plot_add(&time, plot_series(&time, ways[k].name), ns[k], fmax(s.self, s.leak));
    }
    output_plot(o, &time, "18_shade_time.svg");
}

/* And the plot of larger ones, with the same times. */
cold_inline void table_of_triangles(const options *o)
{
    double ns[leavings];
    table t = table_of_leaving(o, DEPART_TRIANGLE,
                               "Leaving a triangle of size 1 at the origin, and T = 1e6 away", ns);
    output_extra_table(o, &t);
    plot_of_leaving(o, ns);
}

#endif
