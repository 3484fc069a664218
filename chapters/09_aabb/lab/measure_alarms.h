/* measure_alarms.h: what a box hit is worth, counted and timed: the tables of alarms.h.
 *
 *   count_alarms(o)     shapes in 1 to 64 boxes: which part of the rays that hit a box hits nothing
 *   measure_teapot(o)   the teapot in 1, 2, 4, ... boxes: tests and time a ray
 *   count_own_boxes(o)  triangles that are hit, against their own boxes
 */
#ifndef MEASURE_ALARMS_H
#define MEASURE_ALARMS_H

#include "../../../common/clock.h"
#include "../../../common/lab/report.h"
#include "../../04_triangle/scenes/icosphere.h"
#include "../../07_mesh/scenes/specimens.h"
#include "../../07_mesh/scenes/teapot.h"
#include "own_box.h"

/* ---------------------------------------------------------------------------------------------- */

static inline double per_cent(size_t part, size_t whole)
{
    return whole ? 100 * (double)part / (double)whole : 0;
}

enum { specimens = 6, cuts = 4 };
static const char *const specimen_name[specimens] = {
    "needle on the diagonal", "triangle, slanted", "triangle in a flat box", "ball of triangles",
    "ring", "teapot"};

static inline boxed boxed_mesh(mesh m)
{
    triangle *t = allocate(m.triangles, sizeof *t);
    for (size_t i = 0; i < m.triangles; i++) t[i] = mesh_triangle(&m, i);
    boxed b = boxed_new(t, m.triangles);
    free(t);
    mesh_free(&m);
    return b;
}

static inline boxed boxed_ball(int levels)
{
    icosphere m = icosphere_new(levels, (vec3){0, 0, 0}, 1);
    triangle *t = allocate(m.triangles, sizeof *t);
    for (uint32_t i = 0; i < m.triangles; i++) t[i] = icosphere_triangle(&m, i);
    boxed b = boxed_new(t, m.triangles);
    free(t);
    icosphere_free(&m);
    return b;
}

static inline boxed specimen(int k)
{
    static const triangle t[] = {{{0, 0, 0}, {1, 1, 1}, {0.51, 0.49, 0.5}},
                                 {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                 {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}}};
    if (k < 3) return boxed_new(&t[k], 1);
    return k == 3 ? boxed_ball(3) : boxed_mesh(k == 4 ? torus_mesh(20) : teapot_mesh(5));
}

/* (9.6); not for the ring and the teapot, which are not convex. */
static inline double expected_share(const boxed *b)
{
    double area = 0;
    for (size_t i = 0; i < b->n; i++) {
        triangle t = b->t[i].t;
        area += (double)vlength(vcross(vsub(t.b, t.a), vsub(t.c, t.a))) / 2;
    }
    return (b->n == 1 ? 2 : 1) * area / (double)aabb_area(boxed_bounds(b, 0, b->n));
}

static inline void count_alarms(const options *o)
{
    const size_t parts[cuts] = {1, 2, 8, 64}, n = o->quick ? 300 : 10000;
    table t = table_new("Of the rays that hit a box, how many hit nothing in any box [%]",
                        "in the box|triangles|by (9.6)|in 1 box|2 boxes|8 boxes|64 boxes");
    for (int k = 0; k < specimens; k++) {
        boxed b = specimen(k);
        table_text(&t, "%s", specimen_name[k]), table_count(&t, b.n);
        if (k < 4) table_number(&t, 100 * (1 - expected_share(&b)));
        else table_text(&t, "-");
        for (int c = 0; c < cuts; c++) {
            if (parts[c] > b.n) { table_text(&t, "-"); continue; }
            boxed_split(&b, parts[c]);
            alarm_count a = boxed_count(&b, o->seed, n);
            table_number(&t, per_cent(a.any_box - a.any_triangle, a.any_box));
        }
        boxed_free(&b);
    }
    output_extra_table(o, &t);
}

typedef struct { const boxed *b; const ray *r; size_t n; } search;

static inline double run_search(void *context)
{
    const search *s = context;
    double sum = 0;
    for (size_t i = 0; i < s->n; i++) {
        hit h = {.t = 0};
        if (boxed_hit(s->b, s->r[i], &h)) sum += (double)h.t;
    }
    return sum;
}

/* The closest hit, and no other rays than those counted. */
static inline void measure_teapot(const options *o)
{
    const size_t n = o->quick ? 200 : 2000;
    table t = table_new("The teapot in ever tighter boxes, all of them tested: per ray",
                        "boxes|box tests|triangle tests|boxes hit|in vain|time [us]");
    plot p = plot_new("The teapot in ever tighter boxes", "boxes", "tests a ray",
                      PLOT_LOG_X | PLOT_LOG_Y);
    plot q = plot_new("The teapot in ever tighter boxes", "boxes", "time of a ray [us]",
                      PLOT_LOG_X | PLOT_LOG_Y);
    int of_boxes = plot_series(&p, "boxes"), of_triangles = plot_series(&p, "triangles");
    int both = plot_series(&p, "both"), times = plot_series(&q, "closest hit");
    boxed b = boxed_mesh(teapot_mesh(o->quick ? 4 : 8));
    ray *r = allocate(n, sizeof *r);
    aabb all = boxed_bounds(&b, 0, b.n);
    for (size_t i = 0; i < n; i++) r[i] = line_through(all, o->seed, i);
    for (size_t parts = 1; parts <= b.n; parts *= 2) {
        boxed_split(&b, parts);
        alarm_count a = boxed_count(&b, o->seed, n);
        search s = {&b, r, n};
        clock_variant v = {"search", run_search, &s, 0};
        clock_compare(&v, 1, o->quick ? 1 : 5);
        double per = 1 / (double)n, x = (double)b.parts, time = v.seconds * per * 1e6;
        table_count(&t, b.parts);
        table_number(&t, (double)a.box_tests * per);
        table_number(&t, (double)a.triangle_tests * per);
        table_number(&t, (double)a.box_hits * per), table_number(&t, (double)a.vain * per);
        table_number(&t, time);
        plot_add(&p, of_boxes, x, (double)a.box_tests * per);
        plot_add(&p, of_triangles, x, (double)a.triangle_tests * per);
        plot_add(&p, both, x, (double)(a.box_tests + a.triangle_tests) * per);
        plot_add(&q, times, x, time);
    }
    output_extra_table(o, &t);
    output_plot(o, &p, "09_aabb_tighter.svg");
    output_plot(o, &q, "09_aabb_tighter_time.svg");
    boxed_free(&b);
    free(r);
}

static inline void count_own_boxes(const options *o)
{
    const real width[] = {1, 0.001, 0.000001};
    table t = table_new("Triangles that are hit, and their own boxes",
                        "width|box|hits|lost, inclusive [%]|lost, aabb_hit [%]|before t_enter [%]");
    for (int k = 0; k < 6; k++) {
        own_box_count n = own_box_counted(o->seed, o->quick ? 5000 : 200000, width[k / 2], k % 2);
        table_text(&t, "%g", (double)width[k / 2]), table_text(&t, k % 2 ? "flat" : "any");
        table_count(&t, n.hits);
        table_number(&t, per_cent(n.lost_inclusive, n.hits));
        table_number(&t, per_cent(n.lost, n.hits)), table_number(&t, per_cent(n.early, n.hits));
    }
    output_extra_table(o, &t);
}

#endif
