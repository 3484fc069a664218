/* growth.h: time and work against the number of triangles, and where triangles are not alike. */
#ifndef BVH_GROWTH_H
#define BVH_GROWTH_H

#include "../../07_mesh/scenes/stadium.h"
#include "measure.h"

static inline void table_of_stadium(const options *o);
static inline void growth(const options *o, bool full);  /* full: up to 2e6 triangles, else 1e6 */

/* ---------------------------------------------------------------------------------------------- */

static inline void table_of_stadium(const options *o)
{
    static const int shown[5] = {0, 1, 2, 5, 7};
    mesh pot = teapot_mesh(1), m = stadium_mesh(o->quick ? 8 : 32);
    vec3 lo, hi;
    trial t[5];
    double seconds[5];
    bvh b;
    table out = table_new(
        "The teapot in a stadium: diffuse rays from the teapot",
        "structure|depth|nodes/ray|tests/ray|ray [ns]|nodes (14.7)|tests (14.7)|in both (14.8)");
    mesh_bounds(&pot, &lo, &hi);
    subject s = {.m = m, .v = view_of(lo, hi, true, 1.6)};
    s.primary = rays_primary(s.v, o->quick ? 40 : 160, o->quick ? 25 : 100);
    bvh_build(&m, bvh_defaults, &b);
    s.diffuse = rays_on(&b, &m, &s.primary, o->seed);
    bvh_free(&b);
    for (int i = 0; i < 5; i++) {
        t[i] = (trial){&s, &candidate_list[shown[i]], &s.diffuse, {{0}, NULL}};
        run_build(&t[i]);
    }
    time_trials(t, 5, run_search, o->quick ? 1 : 5, seconds);
    for (int i = 0; i < 5; i++) {
        bvh_stats st = bvh_stats_of(&t[i].b.tree);
        bvh_work w = rays_count(&t[i].b, &s.diffuse);
        table_text(&out, "%s", t[i].c->name), table_count(&out, (size_t)st.depth);
        table_number(&out, per((double)w.nodes, s.diffuse.n));
        table_number(&out, per((double)w.tests, s.diffuse.n));
        table_number(&out, per(seconds[i] * 1e9, s.diffuse.n));
        table_number(&out, st.nodes), table_number(&out, st.tests), table_number(&out, st.overlap);
        bvh_free(&t[i].b);
    }
    output_extra_table(o, &out);
    mesh_free(&pot);
    subject_free(&s);
}

/* Time against n: teapots of 64 n^2 - 8 n triangles, ever finer. */
static inline void growth(const options *o, bool full)
{
    static const int fine[] = {1, 2, 4, 8, 16, 32, 64, 125, 177};
    static const candidate binned = {"SAH, bins", {BVH_SAH, 8, 0.3}, false};
    int n = o->quick ? 4 : full ? 9 : 8;
    double x[9], build[9], search[9], nodes[9], least = HUGE_VAL, greatest = 0;
    table out = table_new(
        "Growth with n, SAH, bins, leaves of 8; one thread",
        "triangles|build [ms]|build / (n log2 n) [ns]|nodes/ray|tests/ray|ray [ns]|"
        "brute force [ns]|peak [B/tri]");
    plot p = plot_new("Time against n", "triangles", "time [ns]", PLOT_LOG_X | PLOT_LOG_Y);
    plot q = plot_new("Diffuse rays: work against n", "triangles", "a ray", PLOT_LOG_X);
    int by_build = plot_series(&p, "build, a triangle"), by_ray = plot_series(&p, "BVH, a ray");
    int by_brute = plot_series(&p, "brute force, a ray");
    int by_nodes = plot_series(&q, "pairs of boxes");
    int by_tests = plot_series(&q, "triangles");
    for (int i = 0; i < n; i++) {
        subject s = subject_of(teapot_mesh(fine[i]), 200, 125,
                               fine[i] <= 64 ? 40 : 0, o->seed);
        trial t = {&s, &binned, &s.diffuse, {{0}, NULL}};
        double triangles = (double)s.m.triangles, seconds;
        if (fine[i] < 64) time_trials(&t, 1, run_build, 5, &build[i]);
        else build[i] = time_once(&t, run_build);
        time_trials(&t, 1, run_search, fine[i] < 64 ? 3 : 1, &seconds);
        bvh_work w = rays_count(&t.b, &s.diffuse);
        x[i] = log2(triangles), search[i] = log2(seconds / (double)s.diffuse.n);
        nodes[i] = per((double)w.nodes, s.diffuse.n);
        double unit = build[i] / (triangles * x[i]);
        if (triangles > 900 && unit < least) least = unit;
        if (triangles > 900 && unit > greatest) greatest = unit;
        table_count(&out, s.m.triangles);
        table_number(&out, build[i] * 1e3), table_number(&out, unit * 1e9);
        table_number(&out, nodes[i]), table_number(&out, per((double)w.tests, s.diffuse.n));
        table_number(&out, per(seconds * 1e9, s.diffuse.n));
        if (s.corners.n) table_number(&out, s.brute_seconds * 1e9);
        else table_text(&out, "-");
        table_number(&out, per((double)t.b.tree.peak, s.m.triangles));
        plot_add(&p, by_build, triangles, build[i] * 1e9 / triangles);
        plot_add(&p, by_ray, triangles, per(seconds * 1e9, s.diffuse.n));
        if (s.corners.n) plot_add(&p, by_brute, triangles, s.brute_seconds * 1e9);
        plot_add(&q, by_nodes, triangles, nodes[i]);
        plot_add(&q, by_tests, triangles, per((double)w.tests, s.diffuse.n));
        build[i] = log2(build[i]);
        bvh_free(&t.b);
        subject_free(&s);
    }
    output_extra_table(o, &out);
    printf("# fitted: build ~ n^%.2f; build / (n log2 n) within a factor %.2f from 1e3 on\n",
           slope_of(x, build, n), greatest / least);
    printf("# fitted: a diffuse ray tests %.2f more pairs for each doubling of n; time ~ n^%.2f\n",
           slope_of(x, nodes, n), slope_of(x, search, n));
    plot_slope(&p, 1, "slope 1");
    output_plot(o, &p, "14_bvh_n_time.svg");
    output_plot(o, &q, "14_bvh_n.svg");
}

#endif
