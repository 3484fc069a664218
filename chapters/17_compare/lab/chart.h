/* chart.h: bars (柱状图), a panel a scene: what a ray costs, and what building costs, by structure.
 *
 *   compare_chart c = chart_new("A ray and its share of building");
 *   int p = chart_panel(&c, "balls");
 *   chart_bar(&c, p, "bvh", 212, 0.02, 300);    ns a ray, half of what lies between its quartiles,
 *                                relative; ns of building a shape; ns a ray 0 or less: does not fit
 *   output_chart(&o, &c, "17_compare_time.svg");       frees it
 *
 * Each kind of bar has its own scale in each panel, linear from 0 to the longest; brute force, a
 * hundred times as long, is left to the tables. Colours as in plot.h.
 */
#ifndef COMPARE_LAB_CHART_H
#define COMPARE_LAB_CHART_H

#include "../../../common/lab/report.h"

typedef struct { int panel; char name[44]; double ray, spread, build; } chart_value;
typedef struct {
    const char *title;
    int panels;
    char name[16][32];
    chart_value *value;
    size_t n, room;
} compare_chart;

/* ---------------------------------------------------------------------------------------------- */

enum { chart_columns = 2, chart_wide = 430, chart_row = 24, chart_bar_most = 190 };

static inline compare_chart chart_new(const char *title) { return (compare_chart){.title = title}; }

static inline int chart_panel(compare_chart *c, const char *name)  /* -1: there are 16 */
{
    if (c->panels == 16) return -1;
    snprintf(c->name[c->panels], sizeof c->name[0], "%.31s", name);
    return c->panels++;
}

static inline void chart_bar(compare_chart *c, int panel, const char *name, double ray,
                             double spread, double build)
{
    c->value = grown(c->value, c->n, &c->room, sizeof *c->value);
    chart_value *v = &c->value[c->n++];
    *v = (chart_value){panel, "", ray, spread, build};
    snprintf(v->name, sizeof v->name, "%.43s", name);
}

static inline void chart_text(FILE *out, int x, int y, int size, const char *anchor,
                              const char *text)
{
    char style[64];
    snprintf(style, sizeof style, "font-size=\"%d\" text-anchor=\"%s\"", size, anchor);
    plot_text(out, x, y, style, text);
}

/* Three digits, as in tables: 0.123, 12.3, 1234. */
static inline void chart_number(char text[32], double x)
{
    snprintf(text, 32, x >= 100 ? "%.0f" : "%.3g", x);
}

static inline void chart_row_of(FILE *out, const chart_value *v, int x, int y, double most_ray,
                                double most_build)
{
    char text[72] = "does not fit";
    chart_text(out, x + 84, y + 15, strlen(v->name) > 12 ? 9 : 12, "end", v->name);
    int ray = 0, build = 0;
    if (v->ray > 0) {
        ray = (int)(chart_bar_most * v->ray / most_ray + 0.5);
        build = (int)(chart_bar_most * v->build / most_build + 0.5);
        char a[32], b[32];
        chart_number(a, v->ray), chart_number(b, v->build);
        snprintf(text, sizeof text, "%s, %s", a, b);
    }
    fprintf(out, "<rect x='%d' y='%d' width='%d' height='9' fill='#0072B2'/>\n", x + 90, y + 3,
            ray);
    fprintf(out, "<rect x='%d' y='%d' width='%d' height='6' fill='#E69F00'/>\n", x + 90, y + 13,
            build);
    double off = chart_bar_most * v->ray * v->spread / most_ray;
    if (v->ray > 0)
        fprintf(out, "<path d='M%.1f,%dH%.1f' stroke='black' stroke-width='2'/>\n",
                x + 90 + ray - off, y + 7, x + 90 + ray + off);
    chart_text(out, x + 96 + (ray > build ? ray : build), y + 15, 11, "start", text);
}

static inline void chart_draw_panel(FILE *out, const compare_chart *c, int panel, int x, int y)
{
    double most_ray = 0, most_build = 0;
    for (size_t i = 0; i < c->n; i++) {
        const chart_value *v = &c->value[i];
        if (v->panel != panel) continue;
        if (v->ray > most_ray) most_ray = v->ray;
        if (v->build > most_build) most_build = v->build;
    }
    chart_text(out, x + 90, y + 14, 13, "start", c->name[panel]);
    for (size_t i = 0; i < c->n; i++) {
        if (c->value[i].panel != panel) continue;
        y += chart_row;
        chart_row_of(out, &c->value[i], x, y - 4, most_ray > 0 ? most_ray : 1,
                     most_build > 0 ? most_build : 1);
    }
}

static inline void chart_write(const compare_chart *c, FILE *out)
{
    int rows = 0, high, lines = (c->panels + chart_columns - 1) / chart_columns;
    for (int p = 0; p < c->panels; p++) {
        int n = 0;
        for (size_t i = 0; i < c->n; i++) n += c->value[i].panel == p;
        if (n > rows) rows = n;
    }
    high = (rows + 1) * chart_row + 16;
    fprintf(out, "<svg xmlns='http://www.w3.org/2000/svg' width='%d' height='%d' "
                 "viewBox='0 0 %d %d' font-family='sans-serif'>\n"
                 "<rect width='100%%' height='100%%' fill='white'/>\n",
            chart_columns * chart_wide, 60 + lines * high, chart_columns * chart_wide,
            60 + lines * high);
    chart_text(out, chart_columns * chart_wide / 2, 22, 15, "middle", c->title);
    fprintf(out, "<rect x='94' y='34' width='20' height='9' fill='#0072B2'/>\n"
                 "<rect x='354' y='35' width='20' height='6' fill='#E69F00'/>\n");
    chart_text(out, 120, 43, 12, "start", "a ray [ns], median and quartiles");
    chart_text(out, 380, 43, 12, "start", "building [ns a shape]");
    for (int p = 0; p < c->panels; p++)
        chart_draw_panel(out, c, p, p % chart_columns * chart_wide, 56 + p / chart_columns * high);
    fprintf(out, "</svg>\n");
}

static inline void output_chart(const options *o, compare_chart *c, const char *name)
{
    char room[512];
    failure f;
    file_writer w;
    const char *path = output_path(o, name, false, room);
    if (path && !file_begin(&w, path, &f)) fail(f);
    if (path) chart_write(c, w.stream);
    if (path && !file_commit(&w, &f)) fail(f);
    if (path) output_note(path);
    free(c->value);
    *c = (compare_chart){0};
}

#endif
