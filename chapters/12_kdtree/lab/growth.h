/* growth.h: time, work and memory against the number of triangles.
 *
 *   kdtree_grow(o)        a table, a plot of the work, and two lines of exponents
 *
 * Teapots of 64 n^2 - 8 n triangles, ever finer; diffuse rays from where the eye's rays hit. The
 * finest is not asked by brute force.
 */
#ifndef KDTREE_GROWTH_H
#define KDTREE_GROWTH_H

#include "measure.h"

/* ---------------------------------------------------------------------------------------------- */

static inline void kdtree_grow(const options *o)
{
    enum { sizes = 8, width = 280, brute = 64 };  /* for some 20,000 diffuse rays, as in 17 */
    static const int fine[sizes] = {1, 2, 4, 8, 16, 32, 64, 126};
    double x[sizes], build[sizes], search[sizes], nodes[sizes], least = HUGE_VAL, greatest = 0;
    table out = table_new("Growth with n, SAH, one thread",
                          "triangles|build [ms]|build / (n log2 n) [ns]|references a shape|"
                          "nodes a ray|leaves a ray|tests a ray|ray [ns]|brute force [ns]|"
                          "peak bytes a shape");
    plot q = plot_new("Diffuse rays: work against n", "triangles", "number of each, a ray",
                      PLOT_LOG_X);
    plot_series(&q, "nodes"), plot_series(&q, "leaves"), plot_series(&q, "tests");
    for (int i = 0; i < sizes; i++) {
        trial_scene s;
        trial_row r = {.verbs = &kdtree_trial, .how = &kdtree_defaults};
        trial_scene_of(teapot_mesh(fine[i]), &s);
        size_t corners = fine[i] > brute ? 0 : s.m.triangles < 50000 ? 40 : 10;
        trial_rays(&s, trial_camera(&s.m, 1.6), width, width * 5 / 8, corners, o->seed,
                   &kdtree_trial, &kdtree_defaults);
        rays_free(&s.rays[TRIAL_PRIMARY]);
        trials_run(&r, 1, &s, s.m.triangles < 500000 ? 3 : 1);
        search_work w = r.ray[TRIAL_DIFFUSE].work;
        size_t rays = r.ray[TRIAL_DIFFUSE].n;
        double n = (double)s.m.triangles, ns = trial_ns(&r, TRIAL_DIFFUSE), unit;
        x[i] = log2(n), build[i] = log2(r.build), search[i] = log2(ns);
        unit = r.build / (n * x[i]);
        if (n > 900) least = fmin(least, unit), greatest = fmax(greatest, unit);
        const double cell[] = {r.build * 1e3, unit * 1e9,
                               trial_per((double)r.stats.references, r.stats.items),
                               trial_per((double)w.nodes, rays), trial_per((double)w.leaves, rays),
                               trial_per((double)w.tests, rays), ns};
        nodes[i] = cell[3];
        table_count(&out, s.m.triangles);
        for (int k = 0; k < 7; k++) table_number(&out, cell[k]);
        trial_cell(&out, s.brute > 0, s.brute * 1e9);
        table_number(&out, trial_per((double)r.stats.peak, s.m.triangles));
        for (int k = 0; k < 3; k++) plot_add(&q, k, n, cell[3 + k]);
        trial_end(&r, 1), trial_scene_free(&s);
    }
    output_extra_table(o, &out);
    printf("# fitted: build ~ n^%.2f; build / (n log2 n) within a factor %.2f from 1e3 on\n",
           bench_slope(x, build, sizes), greatest / least);
    printf("# fitted: a diffuse ray passes %.2f more nodes for each doubling of n; "
           "time ~ n^%.2f\n\n",
           bench_slope(x, nodes, sizes), bench_slope(x, search, sizes));
    output_plot(o, &q, "12_kdtree_n.svg");
}

#endif
