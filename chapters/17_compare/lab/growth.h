/* growth.h: time, work and building against n: teapots of 56 to 2e6 triangles, diffuse rays.
 *
 *   growth_run(&o, chosen, most_bytes, large)    tables, fitted exponents, three plots
 *
 * Without `large`, structures whose building takes long are left out of the larger ones.
 *
 * time ~ n^a (17.9): 1 for brute force. A tree that does log n steps has an a that falls with n;
 * how many more steps a doubling of n takes is the better number. Least squares against log n.
 */
#ifndef COMPARE_LAB_GROWTH_H
#define COMPARE_LAB_GROWTH_H

#include "costs.h"
#include "scenes.h"

enum { growth_sizes = 9 };  /* 64 n^2 - 8 n triangles each */
static const int growth_fine[growth_sizes] = {1, 2, 4, 8, 16, 32, 64, 125, 177};

/* ---------------------------------------------------------------------------------------------- */

typedef struct { int n; double x[growth_sizes], build[growth_sizes], ray[growth_sizes],
                 steps[growth_sizes]; } growth_curve;

static inline void growth_note(growth_curve *c, const comparison *s, const compare_entry *e)
{
    int i = c->n++;
    c->x[i] = log2((double)s->x.n);
    c->build[i] = e->build;
    c->ray[i] = cost_ns(e, KIND_DIFFUSE);
    c->steps[i] = per((double)(e->work[KIND_DIFFUSE].nodes + e->work[KIND_DIFFUSE].tests),
                      e->rays[KIND_DIFFUSE]);
}

static inline bool growth_step(growth_curve *c, int fine, int edge, const options *o,
                               unsigned chosen, size_t most_bytes)
{
    world w;
    comparison s;
    failure f;
    if (!mesh_world(&w, "teapot", teapot_mesh(fine), true, &f)) fail(f);
    compare_begin(&s, &w, chosen, most_bytes, o->quick ? 1 : 3);
    compare_rays(&s, whole_view, edge, o->seed);
    bool ok = prove_rays(&s, s.rays[KIND_DIFFUSE].r, s.rays[KIND_DIFFUSE].n, false, stdout);
    cost_kind(&s, KIND_DIFFUSE, o->quick ? 1 : 3);
    for (int k = 0, i = 0; k < contenders; k++) {
        if (!(chosen >> k & 1)) continue;
        const compare_entry *e = &s.entry[i++];
        if (e->s) growth_note(&c[k], &s, e);
    }
    compare_end(&s);
    world_free(&w);
    return ok;
}

static inline void growth_table(const options *o, const growth_curve *c, unsigned chosen)
{
    char columns[512] = "triangles";
    size_t length = strlen(columns);
    int longest = 0;
    for (int k = 0; k < contenders; k++) {
        if (!(chosen >> k & 1)) continue;
        length += (size_t)snprintf(columns + length, sizeof columns - length, "|%s",
                                   contender_list[k]->name);
        if (c[k].n > c[longest].n) longest = k;
    }
    for (int pass = 0; pass < 2; pass++) {
        table t = table_new(pass ? "Growth: nanoseconds a diffuse ray"
                                 : "Growth: milliseconds to build", columns);
        for (int i = 0; i < c[longest].n; i++) {
            table_count(&t, (size_t)(exp2(c[longest].x[i]) + 0.5));
            for (int k = 0; k < contenders; k++)
                if (!(chosen >> k & 1)) continue;
                else if (i >= c[k].n) table_text(&t, "-");
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
    if (c->n < 2) return;
    printf("# %-11s a ray ~ n^%.2f, %.3g more steps a doubling", name,
           bench_slope(c->x, search, c->n), bench_slope(c->x, c->steps, c->n));
    if (strcmp(name, brute_contender.name) == 0) printf("\n");
    else printf("; building ~ n^%.2f\n", bench_slope(c->x, build, c->n));
}

static inline void growth_plots(const options *o, const growth_curve *c, unsigned chosen)
{
    int log_log = PLOT_LOG_X | PLOT_LOG_Y;
    plot search = plot_new("A diffuse ray against n", "triangles", "time [ns]", log_log);
    plot build = plot_new("Building against n", "triangles", "time [ns a triangle]", log_log);
    plot steps = plot_new("Work against n", "triangles", "steps and tests, a ray", PLOT_LOG_X);
    plot *all[3] = {&search, &steps, &build};
    for (int j = 1; j <= contenders; j++) {  /* brute force last: one colour each in all plots */
        int k = j % contenders;
        bool slow = contender_list[k] == &brute_contender;  /* off the scale of the others */
        for (int p = 0; p < (slow ? 1 : 3) && chosen >> k & 1; p++) {
            bool keep = p == 0 && !slow && chosen & 1;  /* a place for brute force */
            if (all[p]->series + keep == plot_most_series) continue;
            int series = plot_series(all[p], contender_list[k]->name);
            for (int i = 0; i < c[k].n; i++) {
                double x = exp2(c[k].x[i]), build_ns = c[k].build[i] * 1e9 / x;
                plot_add(all[p], series, x, p == 0 ? c[k].ray[i] : p == 1 ? c[k].steps[i]
                                                                           : build_ns);
            }
        }
    }
    plot_slope(&search, 1, "slope 1");
    output_plot(o, &search, "17_compare_n_time.svg");
    output_plot(o, &build, "17_compare_build_time.svg");
    output_plot(o, &steps, "17_compare_n.svg");
}

/* False: a difference was found, and explained. */
static inline bool growth_run(const options *o, unsigned chosen, size_t most_bytes, bool large)
{
    growth_curve c[contenders] = {{0}};
    int sizes = o->quick ? 3 : large ? growth_sizes : growth_sizes - 1;
    for (int i = 0; i < sizes; i++) {
        size_t fine = (size_t)growth_fine[i], n = 64 * fine * fine - 8 * fine;
        unsigned now = 0;
        for (int k = 0; k < contenders; k++)  /* and who did not fit is out */
            if ((large || contender_list[k]->most >= n) && c[k].n == i) now |= chosen & 1u << k;
        if (!growth_step(c, (int)fine, o->quick ? 16 : 96, o, now, most_bytes)) return false;
    }
    growth_table(o, c, chosen);
    for (int k = 0; k < contenders; k++) growth_fit(&c[k], contender_list[k]->name);
    printf("\n");
    growth_plots(o, c, chosen);
    return true;
}

#endif
