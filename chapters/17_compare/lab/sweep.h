/* sweep.h: one option of a structure from end to end, among all structures: who is on the front?
 *
 *   sweep_run(&s, to)              s: measured. A table, sorted as it was chosen, and a plot
 *
 * A point with another point below and to its left loses on both counts, building and searching:
 * that structure is never worth building here. Those that are left form the Pareto front.
 */
#ifndef COMPARE_LAB_SWEEP_H
#define COMPARE_LAB_SWEEP_H

#include "costs.h"

/* ---------------------------------------------------------------------------------------------- */

/* Nobody is as quick at both, and quicker at one. A twentieth is noise: two builds of the same tree
 * differ by that. */
static inline bool sweep_on_front(const comparison *s, const compare_entry *e)
{
    double build = e->build, mean = cost_mean(s, e);
    for (const compare_entry *b = s->entry; b < s->entry + s->entries; b++) {
        double its = cost_mean(s, b);
        if (entry_counts(b) && b->build <= 1.05 * build && its <= 1.05 * mean
            && (b->build < 0.95 * build || its < 0.95 * mean)) return false;
    }
    return true;
}

static inline int sweep_by_build(const void *a, const void *b)
{
    const double *p = a, *q = b;
    return (p[0] > q[0]) - (p[0] < q[0]);
}

static inline void sweep_run(const comparison *s, html_report *to)
{
    char title[120];
    double front[compare_most][2];
    int n = 0;
    snprintf(title, sizeof title, "Building against searching: %.40s of %zu", s->name, s->x.n);
    table t = table_new(title, "structure|B/shape|nodes/ray|tests/ray|build [ms]|a ray [ns]|"
                               "on the front");
    plot p = plot_new("Building against searching", "building [ms]", "a ray, time [ns]",
                      PLOT_LOG_X | PLOT_LOG_Y);
    int swept = plot_series(&p, "swept"), fronts = plot_series(&p, "Pareto front");
    for (const compare_entry *e = s->entry; e < s->entry + s->entries; e++) {
        double nodes, tests, build = e->build * 1e3, ns = cost_mean(s, e) * 1e9;
        bool on = sweep_on_front(s, e);
        if (!entry_counts(e)) continue;
        cost_work(e, &nodes, &tests);
        const double cell[] = {per((double)e->stats.bytes, s->x.n), nodes, tests, build, ns};
        table_text(&t, "%s", e->choice->label);
        for (int k = 0; k < 5; k++) table_number(&t, cell[k]);
        table_text(&t, "%s", on ? "yes" : "");
        if (on) front[n][0] = build, front[n++][1] = ns;
        if (e->choice->how.n) plot_add(&p, swept, build, ns);
        else if (p.series < plot_most_series)
            plot_add(&p, plot_series(&p, e->choice->label), build, ns);
    }
    qsort(front, (size_t)n, sizeof *front, sweep_by_build);
    for (int k = 0; k < n; k++) plot_add(&p, fronts, front[k][0], front[k][1]);
    html_table(to, &t);
    html_plot(to, &p, "17_compare_sweep_time.svg");
}

#endif
