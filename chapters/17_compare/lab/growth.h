/* growth.h: time and work against n: teapots of 56 to 999,000 triangles, diffuse rays.
 *
 *   growth_run(&o, &chosen, most_bytes, report)    a table, fitted exponents, a plot
 *
 * Who took more than 0.7 seconds to build the size before, or for a ray a hundred times as long as
 * the fastest, is left out of the larger ones; with BENCH_ONCE, 0.03 seconds. The quickest to
 * build, which finds where rays begin, stays.
 *
 * time ~ n^a (17.9): 1 for brute force. A tree that does log n steps has an a that falls with n;
 * how many more steps a doubling of n takes is the better number. Least squares against log n.
 */
#ifndef COMPARE_LAB_GROWTH_H
#define COMPARE_LAB_GROWTH_H

#include "summary.h"

enum { growth_sizes = 8 };  /* 64 n^2 - 8 n triangles each */
static const int growth_fine[growth_sizes] = {1, 2, 4, 8, 16, 32, 64, 125};

/* A row a size: diffuse rays alone, and building. Who is left out has ray < 0. */
typedef struct { compare_summary m; double steps[growth_sizes][compare_most]; } growth_result;

/* ---------------------------------------------------------------------------------------------- */

/* Of structure k, where it took part: log2 of n, of a ray's seconds, and steps; how many. */
static inline int growth_points(const growth_result *g, int k, double x[growth_sizes],
                                double y[growth_sizes], double steps[growth_sizes])
{
    int n = 0;
    for (; n < g->m.rows && g->m.row[n].ray[k] >= 0; n++) {
        x[n] = log2((double)g->m.row[n].shapes), y[n] = log2(g->m.row[n].ray[k]);
        steps[n] = g->steps[n][k];
    }
    return n;
}

/* The next size. who[k]: number of entry k among all that were chosen. */
static inline bool growth_step(growth_result *g, const int *who, const line_up *now,
                               const options *o, size_t most_bytes)
{
    world w;
    comparison s;
    failure f;
    int size = g->m.rows++;
    summary_row *r = &g->m.row[size];
    if (!mesh_world(&w, "teapot", teapot_mesh(growth_fine[size]), true, &f)) fail(f);
    compare_begin(&s, &w, now, most_bytes, o->quick ? 1 : 3);
    compare_rays(&s, o->quick ? 200 : compare_usual_rays, o->seed);
    ray_set some = rays_some(&s.rays[KIND_DIFFUSE], 4000);
    bool ok = prove_rays(&s, &some, false, false, stdout);
    rays_free(&some);
    cost_kind(&s, KIND_DIFFUSE, o->quick ? 1 : 5, cost_few);
    snprintf(r->name, sizeof r->name, "%zu", s.x.n);
    r->shapes = s.x.n;
    for (int k = 0; k < g->m.chosen->n; k++) r->ray[k] = -1;
    for (int k = 0; k < s.entries; k++) {
        const compare_entry *e = &s.entry[k];
        search_work sum = e->work[KIND_DIFFUSE];
        if (!e->s) continue;
        r->ray[who[k]] = 1e-9 * cost_ns(e, KIND_DIFFUSE), r->build[who[k]] = e->build;
        g->steps[size][who[k]] = per((double)(sum.nodes + sum.tests), e->counted[KIND_DIFFUSE]);
    }
    compare_end(&s);
    world_free(&w);
    return ok;
}

/* Brute force is off the scale of the plot, as slope 1 says. */
static inline void growth_print(const options *o, const growth_result *g, html_report *to)
{
    plot p = plot_new("A diffuse ray against n", "triangles", "time [ns]", PLOT_LOG_X | PLOT_LOG_Y);
    summary_table(o, &g->m, to, "Growth: nanoseconds a diffuse ray, by triangles", false, 1e9, 0);
    for (int k = 0; k < g->m.chosen->n; k++) {
        double x[growth_sizes], y[growth_sizes], steps[growth_sizes];
        const compare_choice *c = &g->m.chosen->of[k];
        int n = growth_points(g, k, x, y, steps);
        if (n > 1)
            printf("# %-12s a ray ~ n^%.2f, %.3g more steps a doubling\n", c->label,
                   bench_slope(x, y, n), bench_slope(x, steps, n));
        if (!contender_counts(c->c) || p.series == plot_most_series) continue;
        int series = plot_series(&p, c->label);
        for (int i = 0; i < n; i++) plot_add(&p, series, exp2(x[i]), 1e9 * exp2(y[i]));
    }
    printf("\n");
    plot_slope(&p, 1, "slope 1");
    html_plot(to, o, &p, "17_compare_n_time.svg");
}

static inline bool growth_run(const options *o, const line_up *all, size_t most_bytes,
                              html_report *to)
{
    growth_result g = {.m = {.chosen = all}};
    double patience = getenv("BENCH_ONCE") ? 0.03 : 0.7;
    for (int i = 0; i < (o->quick ? 3 : growth_sizes); i++) {
        line_up now = {.n = 0};
        const summary_row *r = i ? &g.m.row[i - 1] : NULL;
        int who[compare_most];
        double least = HUGE_VAL, quick = HUGE_VAL;
        for (int k = 0; k < all->n && r; k++) {
            if (r->ray[k] >= 0) least = fmin(least, r->ray[k]);
            if (r->ray[k] >= 0 && contender_counts(all->of[k].c)) quick = fmin(quick, r->build[k]);
        }
        for (int k = 0; k < all->n; k++) {  /* and who did not fit is out */
            bool slow = r && (r->ray[k] < 0 || r->build[k] > fmax(patience, quick)
                || (r->ray[k] > 100 * least && all->of[k].c != &brute_contender));
            if (!slow) who[now.n] = k, now.of[now.n++] = all->of[k];
        }
        if (!growth_step(&g, who, &now, o, most_bytes)) return false;
    }
    growth_print(o, &g, to);
    return true;
}

#endif
