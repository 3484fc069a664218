/* growth.h: time, work and memory against the number of triangles.
 *
 *   trial_growth g = {.title = "..", .plot = "12_kdtree_n.svg",
 *                     .work = {"nodes", "leaves", "tests"}, ..};
 *   trial_grow(&o, &g);               a table, a plot of the work, and two lines of exponents
 *
 * Teapots of 64 n^2 - 8 n triangles, ever finer; diffuse rays from where the eye's rays hit.
 */
#ifndef TRIALS_GROWTH_H
#define TRIALS_GROWTH_H

#include "../../../common/lab/report.h"
#include "../../07_mesh/scenes/teapot.h"
#include "bench.h"

typedef struct {
    const char *title, *plot;
    const char *work[3];         /* names of nodes, leaves and tests in the plot; NULL: not drawn */
    const trial_verbs *verbs;
    const void *how;
    const int *fine;             /* the n of each teapot */
    int sizes;                   /* [2, 16] */
    int width;                   /* of the picture whose rays are taken; 8 : 5 */
    int brute;                   /* finer teapots: brute force is not asked */
} trial_growth;

/* ---------------------------------------------------------------------------------------------- */

static inline void trial_grow(const options *o, const trial_growth *g)
{
    double x[16], build[16], search[16], nodes[16], least = HUGE_VAL, greatest = 0;
    table out = table_new(g->title, "triangles|build [ms]|build / (n log2 n) [ns]|"
                          "references a shape|nodes a ray|leaves a ray|tests a ray|ray [ns]|"
                          "brute force [ns]|peak bytes a shape");
    plot q = plot_new("Diffuse rays: work against n", "triangles", "number of each, a ray",
                      PLOT_LOG_X);
    int by_work[3];
    for (int k = 0; k < 3; k++) by_work[k] = g->work[k] ? plot_series(&q, g->work[k]) : -1;
    for (int i = 0; i < g->sizes; i++) {
        trial_scene s;
        trial_row r = {.verbs = g->verbs, .how = g->how};
        trial_scene_of(teapot_mesh(g->fine[i]), &s);
        size_t corners = g->fine[i] > g->brute ? 0 : s.m.triangles < 50000 ? 40 : 10;
        trial_rays(&s, trial_camera(&s.m, 1.6), g->width, g->width * 5 / 8, corners, o->seed,
                   g->verbs, g->how);
        rays_free(&s.rays[TRIAL_PRIMARY]);
        trials_run(&r, 1, &s, s.m.triangles < 500000 ? 3 : 1);
        search_work w = r.ray[TRIAL_DIFFUSE].work;
        size_t rays = r.ray[TRIAL_DIFFUSE].n;
        double n = (double)s.m.triangles, ns = trial_ns(&r, TRIAL_DIFFUSE), unit;
        double work[3] = {trial_per((double)w.nodes, rays), trial_per((double)w.leaves, rays),
                          trial_per((double)w.tests, rays)};
        x[i] = log2(n), build[i] = log2(r.build), search[i] = log2(ns), nodes[i] = work[0];
        unit = r.build / (n * x[i]);
        if (n > 900) least = fmin(least, unit), greatest = fmax(greatest, unit);
        const double cell[] = {r.build * 1e3, unit * 1e9,
                               trial_per((double)r.stats.references, r.stats.items), work[0],
                               work[1], work[2], ns};
        table_count(&out, s.m.triangles);
        for (int k = 0; k < 7; k++) table_number(&out, cell[k]);
        trial_cell(&out, s.brute > 0, s.brute * 1e9);
        table_number(&out, trial_per((double)r.stats.peak, s.m.triangles));
        for (int k = 0; k < 3; k++) if (by_work[k] >= 0) plot_add(&q, by_work[k], n, work[k]);
        trial_end(&r, 1), trial_scene_free(&s);
    }
    output_extra_table(o, &out);
    printf("# fitted: build ~ n^%.2f; build / (n log2 n) within a factor %.2f from 1e3 on\n",
           bench_slope(x, build, g->sizes), greatest / least);
    printf("# fitted: a diffuse ray passes %.2f more nodes for each doubling of n; "
           "time ~ n^%.2f\n\n",
           bench_slope(x, nodes, g->sizes), bench_slope(x, search, g->sizes));
    output_plot(o, &q, g->plot);
}

#endif
