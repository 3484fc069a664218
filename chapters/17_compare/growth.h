/* growth.h: time, work and building against n: teapots of 56 to 2e6 triangles, diffuse rays.
 *
 *   growth_run(&o, chosen, most_bytes, full)    a table, fitted exponents, three plots
 *
 * time ~ n^a: a = 1 for brute force. A tree that does log n steps has an a that falls with n; how
 * many more steps a doubling of n takes is the better number. Fitted by least squares to log n.
 */
#ifndef COMPARE_GROWTH_H
#define COMPARE_GROWTH_H

#include "bench.h"
#include "meshes.h"

enum { growth_sizes = 9 };
static const int growth_fine[growth_sizes] = {1, 2, 4, 8, 16, 32, 64, 125, 177};

/* ---------------------------------------------------------------------------------------------- */

typedef struct { int n; double x[growth_sizes], build[growth_sizes], ray[growth_sizes],
                 steps[growth_sizes]; } growth_curve;

static inline void growth_note(growth_curve *c, const stage *s, const entry *e)
{
    int i = c->n++;
    c->x[i] = log2((double)s->x.n);
    c->build[i] = e->build;
    c->ray[i] = bench_ns(e, KIND_DIFFUSE);
    c->steps[i] = per((double)(e->work[KIND_DIFFUSE].nodes + e->work[KIND_DIFFUSE].tests),
                      e->rays[KIND_DIFFUSE]);
}

static inline bool growth_step(growth_curve *c, int fine, int edge, const options *o,
                               unsigned chosen, size_t most_bytes)
{
    world w;
    stage s;
    failure f;
    if (!mesh_world(&w, "teapot", teapot_mesh(fine), true, &f)) fail(f);
    stage_begin(&s, &w, chosen, most_bytes, fine < 64 ? 3 : 1);
    stage_rays(&s, whole_view, edge, o->seed);
    bool ok = prove_rays(&s, s.rays[KIND_DIFFUSE].r, s.rays[KIND_DIFFUSE].n, false, stdout);
    bench_kind(&s, KIND_DIFFUSE, 3);
    for (int k = 0; k < s.entries; k++)
        if (s.entry[k].s) growth_note(&c[k], &s, &s.entry[k]);
    stage_end(&s);
    world_free(&w);
    return ok;
}

static inline void growth_table(const options *o, const growth_curve *c, const contender **who,
                                int n)
{
    char columns[512] = "triangles";
    for (int pass = 0; pass < 2; pass++) {
        size_t length = strlen("triangles");
        for (int k = 0; k < n; k++)
            length += (size_t)snprintf(columns + length, sizeof columns - length, "|%s",
                                       who[k]->name);
        table t = table_new(pass ? "Growth: nanoseconds a diffuse ray"
                                 : "Growth: milliseconds to build", columns);
        for (int i = 0; i < c[0].n; i++) {
            table_count(&t, (size_t)(exp2(c[0].x[i]) + 0.5));
            for (int k = 0; k < n; k++)
                if (i >= c[k].n) table_text(&t, "-");
                else table_number(&t, pass ? c[k].ray[i] : c[k].build[i] * 1e3);
        }
        output_extra_table(o, &t);
    }
}

static inline void growth_fit(const growth_curve *c, const char *name)
{
    double build[growth_sizes], search[growth_sizes];
    for (int i = 0; i < c->n; i++)
        build[i] = log2(c->build[i] + 1e-12), search[i] = log2(c->ray[i]);
    int last = c->n > 4 ? 4 : c->n;
    printf("# %-9s ray ~ n^%.2f (last %d: n^%.2f), %.3g more steps a doubling; build ~ n^%.2f\n",
           name, slope_of(c->x, search, c->n), last,
           slope_of(c->x + c->n - last, search + c->n - last, last),
           slope_of(c->x, c->steps, c->n), slope_of(c->x, build, c->n));
}

static inline void growth_plots(const options *o, const growth_curve *c, const contender **who,
                                int n)
{
    int log_log = PLOT_LOG_X | PLOT_LOG_Y;
    plot search = plot_new("A diffuse ray against n", "triangles", "time [ns]", log_log);
    plot build = plot_new("Building against n", "triangles", "time [ns a triangle]", log_log);
    plot steps = plot_new("Work against n", "triangles", "steps and tests, a ray", log_log);
    for (int k = 0; k < n && k < plot_most_series; k++) {
        int a = plot_series(&search, who[k]->name), b = plot_series(&build, who[k]->name);
        int d = plot_series(&steps, who[k]->name);
        for (int i = 0; i < c[k].n; i++) {
            double x = exp2(c[k].x[i]);
            plot_add(&search, a, x, c[k].ray[i]);
            plot_add(&steps, d, x, c[k].steps[i]);
            if (who[k] != &brute_contender) plot_add(&build, b, x, c[k].build[i] * 1e9 / x);
        }
    }
    plot_slope(&search, 1, "slope 1");
    output_plot(o, &search, "17_compare_n_time.svg");
    output_plot(o, &build, "17_compare_build_time.svg");
    output_plot(o, &steps, "17_compare_n.svg");
}

/* False: a difference was found, and explained. */
static inline bool growth_run(const options *o, unsigned chosen, size_t most_bytes, bool full)
{
    growth_curve c[contenders] = {{0}};
    const contender *who[contenders];
    int n = 0, sizes = o->quick ? 4 : full ? growth_sizes : growth_sizes - 1;
    bool ok = true;
    for (int k = 0; k < contenders; k++)
        if (chosen >> k & 1) who[n++] = contender_list[k];
    for (int i = 0; ok && i < sizes; i++) {
        progress("growth", (size_t)i, (size_t)sizes);
        ok = growth_step(c, growth_fine[i], o->quick ? 16 : 96, o, chosen, most_bytes);
    }
    progress("growth", 1, 1);
    if (!ok) return false;
    growth_table(o, c, who, n);
    for (int k = 0; k < n; k++) growth_fit(&c[k], who[k]->name);
    printf("\n");
    growth_plots(o, c, who, n);
    return true;
}

#endif
