/* growth.h: time and work against n: teapots of 56 to 999,000 triangles, diffuse rays.
 *
 *   growth_run(&c)         a table, fitted exponents, a plot; false: a wrong hit
 *
 * Who took more than 2 seconds to build the size before (with BENCH_ONCE 0.03), or for a ray a
 * hundred times as long as the fastest, is left out of the larger ones; the quickest to build,
 * which finds where rays begin, stays.
 *
 * time ~ n^a (17.9): 1 for brute force. A tree that does log n steps has an a that falls with n;
 * how many more steps a doubling of n takes is the better number. Least squares against log n.
 */
#ifndef COMPARE_LAB_GROWTH_H
#define COMPARE_LAB_GROWTH_H

#include "../../07_mesh/scenes/named.h"
#include "summary.h"

enum { growth_sizes = 8 };  /* 64 n^2 - 8 n triangles each */
static const int growth_fine[growth_sizes] = {1, 2, 4, 8, 16, 32, 64, 125};

/* ---------------------------------------------------------------------------------------------- */

/* Of structure k, where it took part: log2 of n, of a ray's seconds, and steps; how many. */
static inline int growth_points(const measured_scenes *m, int k, double x[growth_sizes],
                                double y[growth_sizes], double steps[growth_sizes])
{
    int n = 0;
    for (const comparison *s = m->of; s < m->of + m->n && s->entry[k].fits; s++, n++) {
        double nodes, tests;
        cost_work(&s->entry[k], &nodes, &tests);
        x[n] = log2((double)s->x.n), y[n] = log2(cost_mean(s, &s->entry[k]));
        steps[n] = nodes + tests;
    }
    return n;
}

/* Who is too slow for more than the size s; and who did not fit. */
static inline void growth_leave(const comparison *s, line_up *now)
{
    double patience = getenv("BENCH_ONCE") ? 0.03 : 2, least = HUGE_VAL, quick = HUGE_VAL;
    for (const compare_entry *e = s->entry; e < s->entry + s->entries; e++) {
        if (e->fits) least = fmin(least, cost_mean(s, e));
        if (entry_counts(e)) quick = fmin(quick, e->build);
    }
    for (int k = 0; k < now->n; k++) {
        const compare_entry *e = &s->entry[k];
        now->of[k].out = !e->fits || e->build > fmax(patience, quick)
                         || (cost_mean(s, e) > 100 * least && e->c != &brute_contender);
    }
}

/* The next size. */
static inline bool growth_step(const compare_settings *c, measured_scenes *m, line_up *now)
{
    world w;
    comparison s;
    failure f;
    bool quick = c->o->quick;
    if (!mesh_world(&w, "teapot", teapot_mesh(growth_fine[m->n]), true, &f)) fail(f);
    compare_begin(&s, &w, now, c->most_bytes, quick ? 1 : 3);
    compare_rays(&s, quick ? 200 : compare_usual_rays, c->o->seed);
    ray_set some = rays_some(&s.rays[KIND_DIFFUSE], 4000);
    bool ok = prove_rays(&s, &some, PROVE_ALIKE, stdout);
    rays_free(&some);
    cost_kind(&s, KIND_DIFFUSE, quick ? 1 : 5, cost_few);
    snprintf(s.name, sizeof s.name, "%zu", s.x.n);
    growth_leave(measured_add(m, &s), now);
    world_free(&w);
    return ok;
}

/* Brute force is off the scale of the plot, as slope 1 says. */
static inline void growth_print(const measured_scenes *m, html_report *to)
{
    plot p = plot_new("A diffuse ray against n", "triangles", "time [ns]", PLOT_LOG_X | PLOT_LOG_Y);
    summary_table(m, to, "Growth: nanoseconds a diffuse ray, by triangles", false, 1e9, 0);
    for (int k = 0; k < m->chosen->n; k++) {
        double x[growth_sizes], y[growth_sizes], steps[growth_sizes];
        const compare_choice *c = &m->chosen->of[k];
        int n = growth_points(m, k, x, y, steps);
        if (n > 1)  /* first versions count no steps */
            html_note(to, contender_is_first(c->c) ? "%-12s a ray ~ n^%.2f"
                      : "%-12s a ray ~ n^%.2f, %.3g more steps a doubling", c->label,
                      bench_slope(x, y, n), bench_slope(x, steps, n));
        if (!contender_counts(c->c) || p.series == plot_most_series) continue;
        int series = plot_series(&p, c->label);
        for (int i = 0; i < n; i++) plot_add(&p, series, exp2(x[i]), 1e9 * exp2(y[i]));
    }
    printf("\n");
    plot_slope(&p, 1, "slope 1");
    html_plot(to, &p, "17_compare_n_time.svg");
}

static inline bool growth_run(const compare_settings *c)
{
    line_up now = c->chosen;
    measured_scenes m = {.chosen = &c->chosen};
    bool ok = true;
    html_element(c->to, "h2", "Growth");
    while (ok && m.n < (c->o->quick ? 3 : growth_sizes)) ok = growth_step(c, &m, &now);
    if (ok) growth_print(&m, c->to);
    measured_free(&m);
    return ok;
}

#endif
