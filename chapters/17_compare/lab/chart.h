/* chart.h: bars (柱状图), a panel a scene: what a ray costs, and what building costs, by structure.
 *
 *   chart_write(&m, out)                               of scenes: summary.h
 *   chart_show(&m, to)                                 in the report
 *   output_chart(&o, &m, "17_compare_time.svg")
 *
 * Each kind of bar has its own scale in each panel, linear from 0 to the longest, or to four times
 * the median: what is longer is a broken bar. Brute force and the first versions are left to the
 * tables. Colours as in plot.h.
 */
#ifndef COMPARE_LAB_CHART_H
#define COMPARE_LAB_CHART_H

#include "summary.h"

/* ---------------------------------------------------------------------------------------------- */

enum { chart_columns = 2, chart_wide = 430, chart_row = 24, chart_bar_most = 190 };

static inline void chart_text(FILE *out, int x, int y, int size, const char *anchor,
                              const char *text)
{
    char style[64];
    snprintf(style, sizeof style, "font-size=\"%d\" text-anchor=\"%s\"", size, anchor);
    plot_text(out, x, y, style, text);
}

static inline void chart_rectangle(FILE *out, int x, int y, int across, int down, const char *fill)
{
    fprintf(out, "<rect x='%d' y='%d' width='%d' height='%d' fill='%s'/>\n", x, y, across, down,
            fill);
}

static inline int chart_bar(FILE *out, int x, int y, int down, double value, double most,
                            const char *fill)
{
    int bar = (int)(chart_bar_most * fmin(value / most, 1) + 0.5);
    chart_rectangle(out, x, y, bar, down, fill);
    if (value > most) chart_rectangle(out, x + bar - 16, y, 4, down, "white");
    return bar;
}

/* The bars of a structure: ray [s], spread, and building [s a shape], over the longest. */
static inline void chart_bars(FILE *out, int x, int y, const double of[3], const double most[2])
{
    char text[72];
    if (of[0] <= 0) {
        chart_text(out, x + 6, y + 15, 11, "start", "does not fit");
        return;
    }
    int bar = chart_bar(out, x, y + 3, 9, of[0], most[0], "#0072B2");
    int second = chart_bar(out, x, y + 13, 6, of[2], most[1], "#E69F00");
    double off = bar * of[1];
    const char *digits[2] = {of[0] < 1e-7 ? "%.3g, " : "%.0f, ", of[2] < 1e-7 ? "%.3g" : "%.0f"};
    int n = snprintf(text, sizeof text, digits[0], of[0] * 1e9);  /* three at least, as in tables */
    snprintf(text + n, sizeof text - (size_t)n, digits[1], of[2] * 1e9);
    fprintf(out, "<path d='M%.1f,%dH%.1f' stroke='black' stroke-width='2'/>\n", x + bar - off,
            y + 7, x + bar + off);
    chart_text(out, x + 6 + (bar > second ? bar : second), y + 15, 11, "start", text);
}

static inline double chart_scale(double *x, int n)
{
    double median = n ? clock_median(x, n) : 1;
    return n ? fmin(x[n - 1], 4 * median) : 1;
}

static inline void chart_panel(FILE *out, const comparison *s, int x, int y)
{
    double value[2][compare_most];
    int n = 0;
    for (const compare_entry *e = s->entry; e < s->entry + s->entries; e++)
        if (entry_counts(e) && cost_mean(s, e) > 0)
            value[0][n] = cost_mean(s, e), value[1][n++] = per(e->build, s->x.n);
    const double most[2] = {chart_scale(value[0], n), chart_scale(value[1], n)};
    char title[32];
    snprintf(title, sizeof title, "%.31s", s->name);
    chart_text(out, x + 90, y + 14, 13, "start", title);
    for (const compare_entry *e = s->entry; e < s->entry + s->entries; e++) {
        const double of[3] = {cost_mean(s, e), cost_spread(e), per(e->build, s->x.n)};
        const char *name = e->choice->label;
        if (!contender_counts(e->c)) continue;
        chart_text(out, x + 84, (y += chart_row) + 11, strlen(name) > 12 ? 9 : 12, "end", name);
        chart_bars(out, x + 90, y - 4, of, most);
    }
}

static inline void chart_write(const measured_scenes *m, FILE *out)
{
    int rows = choose_counting(m->chosen).n + 1, scenes_here = (int)m->n;
    int lines = (scenes_here + chart_columns - 1) / chart_columns;
    int across = chart_columns * chart_wide, high = rows * chart_row + 16, all = 60 + lines * high;
    fprintf(out, "<svg xmlns='http://www.w3.org/2000/svg' width='%d' height='%d' "
                 "viewBox='0 0 %d %d' font-family='sans-serif'>\n", across, all, across, all);
    chart_rectangle(out, 0, 0, across, all, "white");
    chart_text(out, across / 2, 22, 15, "middle", "What a ray costs, and what building costs");
    chart_rectangle(out, 94, 34, 20, 9, "#0072B2");
    chart_rectangle(out, 354, 35, 20, 6, "#E69F00");
    chart_text(out, 120, 43, 12, "start", "a ray [ns], median and quartiles");
    chart_text(out, 380, 43, 12, "start", "building [ns a shape]");
    for (int p = 0; p < scenes_here; p++)
        chart_panel(out, &m->of[p], p % chart_columns * chart_wide, 56 + p / chart_columns * high);
    fprintf(out, "</svg>\n");
}

/* In the report alone. */
static inline void chart_show(const measured_scenes *m, const html_report *to)
{
    if (!html_file(to)) return;
    html_element(to, "h2", "What a ray costs, and what building costs");
    fprintf(html_file(to), "<div class=\"wide\">");
    chart_write(m, html_file(to));
    fprintf(html_file(to), "</div>\n");
}

static inline void output_chart(const options *o, const measured_scenes *m, const char *name)
{
    char room[512];
    failure f;
    file_writer w;
    const char *path = output_path(o, name, false, room);
    if (path && !file_begin(&w, path, &f)) fail(f);
    if (path) chart_write(m, w.stream);
    if (path && !file_commit(&w, &f)) fail(f);
    if (path) output_note(path);
}

#endif
