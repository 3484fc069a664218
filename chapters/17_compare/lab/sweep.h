/* sweep.h: one option of a structure from end to end, among all structures: who is on the front?
 *
 *   sweep_run(&o, &s, report)      s: measured. A table, sorted as it was chosen, and a plot
 *
 * A point with another point below and to its left loses on both counts, building and searching:
 * that structure is never worth building here. Those that are left form the Pareto front.
 */
#ifndef COMPARE_LAB_SWEEP_H
#define COMPARE_LAB_SWEEP_H

#include "costs.h"
#include "html.h"

/* ---------------------------------------------------------------------------------------------- */

/* Nobody is as quick at both, and quicker at one. */
static inline bool sweep_on_front(const comparison *s, const compare_entry *e)
{
    double build = e->build, mean = cost_mean(s, e);
    for (int k = 0; k < s->entries; k++) {
        const compare_entry *b = &s->entry[k];
        if (!entry_counts(b)) continue;
        double its = cost_mean(s, b);
        if (b->build <= build && its <= mean && (b->build < build || its < mean)) return false;
    }
    return true;
}

static inline int sweep_by_build(const void *a, const void *b)
{
    const compare_entry *p = *(const compare_entry *const *)a;
    const compare_entry *q = *(const compare_entry *const *)b;
    return (p->build > q->build) - (p->build < q->build);
}

static inline void sweep_plot(const options *o, const comparison *s, html_report *to)
{
    plot p = plot_new("Building against searching", "building [ms]", "a ray, time [ns]",
                      PLOT_LOG_X | PLOT_LOG_Y);
    const compare_entry *front[compare_most];
    int swept = plot_series(&p, "swept"), fronts = plot_series(&p, "Pareto front"), n = 0;
    for (int k = 0; k < s->entries; k++) {
        const compare_entry *e = &s->entry[k];
        if (!entry_counts(e)) continue;
        double ns = cost_mean(s, e) * 1e9;
        if (sweep_on_front(s, e)) front[n++] = e;
        if (e->choice->how.n) plot_add(&p, swept, e->build * 1e3, ns);
        else if (p.series < plot_most_series)
            plot_add(&p, plot_series(&p, e->choice->label), e->build * 1e3, ns);
    }
    qsort(front, (size_t)n, sizeof *front, sweep_by_build);
    for (int k = 0; k < n; k++)
        plot_add(&p, fronts, front[k]->build * 1e3, cost_mean(s, front[k]) * 1e9);
    html_plot(to, o, &p, "17_compare_sweep_time.svg");
}

static inline void sweep_run(const options *o, const comparison *s, html_report *to)
{
    char title[120];
    snprintf(title, sizeof title, "Building against searching: %.40s of %zu", s->w->name, s->x.n);
    table t = table_new(title, "structure|B/shape|nodes/ray|tests/ray|build [ms]|a ray [ns]|"
                               "on the front");
    for (int k = 0; k < s->entries; k++) {
        const compare_entry *e = &s->entry[k];
        size_t rays;
        search_work w = cost_work(e, &rays);
        if (!entry_counts(e)) continue;
        table_text(&t, "%s", e->choice->label);
        table_number(&t, per((double)e->stats.bytes, s->x.n));
        table_number(&t, per((double)w.nodes, rays)), table_number(&t, per((double)w.tests, rays));
        table_number(&t, e->build * 1e3), table_number(&t, cost_mean(s, e) * 1e9);
        table_text(&t, "%s", sweep_on_front(s, e) ? "yes" : "");
    }
    html_table(to, o, &t);
    sweep_plot(o, s, to);
}

#endif
