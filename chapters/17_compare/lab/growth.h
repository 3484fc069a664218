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

#include "costs.h"
#include "html.h"
#include "../../07_mesh/scenes/named.h"

enum { growth_sizes = 8 };  /* 64 n^2 - 8 n triangles each */
static const int growth_fine[growth_sizes] = {1, 2, 4, 8, 16, 32, 64, 125};

/* ---------------------------------------------------------------------------------------------- */

typedef struct {
    int n;
    double x[growth_sizes], ray[growth_sizes], steps[growth_sizes], build;  /* build: the last */
} growth_curve;

static inline void growth_note(growth_curve *c, const comparison *s, const compare_entry *e)
{
    int i = c->n++;
    c->x[i] = log2((double)s->x.n);
    c->build = e->build;
    c->ray[i] = cost_ns(e, KIND_DIFFUSE);
    c->steps[i] = per((double)(e->work[KIND_DIFFUSE].nodes + e->work[KIND_DIFFUSE].tests),
                      e->counted[KIND_DIFFUSE]);
}

/* who[k]: which of the curves entry k continues. */
static inline bool growth_step(growth_curve *c, const int *who, const line_up *now, int fine,
                               const options *o, size_t most_bytes)
{
    world w;
    comparison s;
    failure f;
    if (!mesh_world(&w, "teapot", teapot_mesh(fine), true, &f)) fail(f);
    compare_begin(&s, &w, now, most_bytes, o->quick ? 1 : 3);
    compare_rays(&s, o->quick ? 200 : compare_usual_rays, o->seed);
    ray_set some = rays_some(&s.rays[KIND_DIFFUSE], 4000);
    bool ok = prove_rays(&s, &some, false, false, stdout);
    rays_free(&some);
    cost_kind(&s, KIND_DIFFUSE, o->quick ? 1 : 5, cost_few);
    for (int k = 0; k < s.entries; k++)
        if (s.entry[k].s) growth_note(&c[who[k]], &s, &s.entry[k]);
    compare_end(&s);
    world_free(&w);
    return ok;
}

static inline void growth_table(const options *o, const growth_curve *c, const line_up *all,
                                html_report *to)
{
    char columns[512] = "structure";
    int longest = 0;
    for (int k = 0; k < all->n; k++)
        if (c[k].n > c[longest].n) longest = k;
    for (int i = 0; i < c[longest].n; i++) {
        size_t n = strlen(columns);
        snprintf(columns + n, sizeof columns - n, "|%.0f", floor(exp2(c[longest].x[i]) + 0.5));
    }
    table t = table_new("Growth: nanoseconds a diffuse ray, by triangles", columns);
    for (int k = 0; k < all->n; k++) {
        table_text(&t, "%s", all->of[k].label);
        for (int i = 0; i < c[longest].n; i++)
            if (i < c[k].n) table_number(&t, c[k].ray[i]);
            else table_text(&t, "-");
    }
    html_table(to, o, &t);
    for (int k = 0; k < all->n; k++) {
        double search[growth_sizes];
        for (int i = 0; i < c[k].n; i++) search[i] = log2(c[k].ray[i]);
        if (c[k].n > 1)
            printf("# %-12s a ray ~ n^%.2f, %.3g more steps a doubling\n", all->of[k].label,
                   bench_slope(c[k].x, search, c[k].n), bench_slope(c[k].x, c[k].steps, c[k].n));
    }
    printf("\n");
}

/* Brute force is off the scale, as slope 1 says. */
static inline void growth_plot(const options *o, const growth_curve *c, const line_up *all,
                               html_report *to)
{
    plot p = plot_new("A diffuse ray against n", "triangles", "time [ns]", PLOT_LOG_X | PLOT_LOG_Y);
    for (int k = 0; k < all->n && p.series < plot_most_series; k++) {
        if (!contender_counts(all->of[k].c)) continue;
        int series = plot_series(&p, all->of[k].label);
        for (int i = 0; i < c[k].n; i++) plot_add(&p, series, exp2(c[k].x[i]), c[k].ray[i]);
    }
    plot_slope(&p, 1, "slope 1");
    html_plot(to, o, &p, "17_compare_n_time.svg");
}

static inline bool growth_run(const options *o, const line_up *all, size_t most_bytes,
                              html_report *to)
{
    growth_curve c[compare_most] = {{0}};
    int sizes = o->quick ? 3 : growth_sizes;
    double patience = getenv("BENCH_ONCE") ? 0.03 : 0.7;
    for (int i = 0; i < sizes; i++) {
        line_up now = {.n = 0};
        int who[compare_most];
        double least = HUGE_VAL, quick = HUGE_VAL;
        for (int k = 0; k < all->n && i > 0; k++) {
            if (c[k].n == i) least = fmin(least, c[k].ray[i - 1]);
            if (c[k].n == i && contender_counts(all->of[k].c)) quick = fmin(quick, c[k].build);
        }
        for (int k = 0; k < all->n; k++) {  /* and who did not fit is out */
            bool slow = i > 0 && c[k].n == i && (c[k].build > fmax(patience, quick)
                || (c[k].ray[i - 1] > 100 * least && all->of[k].c != &brute_contender));
            if (c[k].n == i && !slow) who[now.n] = k, now.of[now.n++] = all->of[k];
        }
        if (!growth_step(c, who, &now, growth_fine[i], o, most_bytes)) return false;
    }
    growth_table(o, c, all, to);
    growth_plot(o, c, all, to);
    return true;
}

#endif
