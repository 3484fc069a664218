/* chart.h: bars (柱状图) in the report, a drawing a scene: what a ray costs, and what building does.
 *
 *   chart_show(&m, to)                                 of scenes: summary.h
 *
 * Each kind of bar has its own scale in each drawing, linear from 0 to the longest, or to four
 * times the median: what is longer is a broken bar. Brute force and the first versions are left to
 * the tables. Colours as in plot.h.
 */
#ifndef COMPARE_LAB_CHART_H
#define COMPARE_LAB_CHART_H

#include "summary.h"

enum { chart_wide = 430, chart_row = 24, chart_bar_most = 190, chart_left = 90 };

/* ---------------------------------------------------------------------------------------------- */

/* Its end. */
static inline int chart_bar(FILE *out, int y, int down, double value, double most, const char *fill)
{
    const char *rectangle = "<rect x='%d' y='%d' width='%d' height='%d' fill='%s'/>\n";
    int bar = (int)(chart_bar_most * fmin(value / most, 1) + 0.5), end = chart_left + bar;
    fprintf(out, rectangle, chart_left, y, bar, down, fill);
    if (value > most) fprintf(out, rectangle, end - 16, y, 4, down, "white");
    return end;
}

static inline double chart_scale(double *x, int n)
{
    double median = n ? clock_median(x, n) : 1;
    return n ? fmin(x[n - 1], 4 * median) : 1;
}

/* A ray, and building a shape [ns]; the quartiles of the first. */
static inline void chart_row_of(FILE *out, const comparison *s, const compare_entry *e, int y,
                                const double most[2])
{
    char text[72] = "does not fit";
    double its = cost_mean(s, e) * 1e9, build = per(e->build, s->x.n) * 1e9;
    int end = chart_left;
    if (its > 0) {
        end = chart_bar(out, y + 3, 9, its, most[0], "#0072B2");
        double off = (end - chart_left) * cost_spread(e);
        fprintf(out, "<path d='M%.1f,%dH%.1f' stroke='black' stroke-width='2'/>\n", end - off,
                y + 7, end + off);
        int second = chart_bar(out, y + 13, 6, build, most[1], "#E69F00");
        end = second > end ? second : end;
        snprintf(text, sizeof text, "%.*f, %.*f", its < 100, its, build < 100, build);
    }
    plot_text(out, end + 6, y + 15, "font-size=\"11\"", text);
    plot_text(out, chart_left - 6, y + 15, strlen(e->choice->label) > 12
              ? "font-size=\"9\" text-anchor=\"end\"" : "font-size=\"12\" text-anchor=\"end\"",
              e->choice->label);
}

static inline void chart_scene(FILE *out, const comparison *s)
{
    double value[2][compare_most];
    int n = 0, rows = 0, row = 0;
    for (const compare_entry *e = s->entry; e < s->entry + s->entries; e++) {
        rows += contender_counts(e->c);
        if (entry_counts(e) && cost_mean(s, e) > 0)
            value[0][n] = cost_mean(s, e) * 1e9, value[1][n++] = per(e->build * 1e9, s->x.n);
    }
    const double most[2] = {chart_scale(value[0], n), chart_scale(value[1], n)};
    int high = (rows + 1) * chart_row;
    fprintf(out, "<svg xmlns='http://www.w3.org/2000/svg' width='%d' height='%d' "
                 "viewBox='0 0 %d %d' font-family='sans-serif'>\n", chart_wide, high, chart_wide,
            high);
    plot_text(out, chart_left, 16, "font-size=\"13\"", s->name);
    for (const compare_entry *e = s->entry; e < s->entry + s->entries; e++)
        if (contender_counts(e->c)) chart_row_of(out, s, e, ++row * chart_row, most);
    fprintf(out, "</svg>\n");
}

static inline void chart_show(const measured_scenes *m, const html_report *to)
{
    FILE *out = html_file(to);
    html_element(to, "h2", "What a ray costs, and what building costs");
    html_element(to, "p", "Blue: a ray [ns], the median, and how far its quartiles are apart. "
                 "Orange: building [ns a shape]. A broken bar is longer than there is room.");
    for (size_t k = 0; out && k < m->n; k++) chart_scene(out, &m->of[k]);
}

#endif
