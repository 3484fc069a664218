/* summary.h: all scenes together: tables of a row a structure, a column a scene (nanoseconds a ray,
 * mean of the kinds of rays as the scene has them; milliseconds to build); who wins; bars (柱状图).
 *
 *   measured_add(&m, &s)                a scene that was measured; ends the comparison
 *   summary_print(&m, to)               who wins: fastest without building, and with it; the tables
 *   summary_verdict(&m, to)             at the head of the report: who is fastest, by kind of rays
 *   summary_few(&m, to)                 one: wrong hits, building in all scenes, diffuse rays
 *   summary_chart(&m, to)               in the report, a drawing a scene: a ray, and building, each
 *                                       with its own scale, to the longest or four times the median
 *   measured_free(&m)
 */
#ifndef COMPARE_LAB_SUMMARY_H
#define COMPARE_LAB_SUMMARY_H

#include "costs.h"

/* Scenes, one after the other, of the same line-up. */
typedef struct { const line_up *chosen; comparison *of; size_t n, room; } measured_scenes;
enum { chart_wide = 430, chart_row = 24, chart_bar_most = 170, chart_left = 110 };  /* pixels */

/* ---------------------------------------------------------------------------------------------- */

static inline comparison *measured_add(measured_scenes *m, comparison *s)
{
    compare_end(s);
    m->of = grown(m->of, m->n, &m->room, sizeof *m->of);
    m->of[m->n] = *s;
    return &m->of[m->n++];
}

static inline void measured_free(measured_scenes *m) { free(m->of), m->of = NULL, m->n = 0; }

/* What the columns of summary_few hold before the scenes. */
static inline void summary_all(table *t, const measured_scenes *m, int k)
{
    double build = 0;
    size_t wrong = 0, held = 0, built = 0;
    for (const comparison *s = m->of; s < m->of + m->n; s++) {
        const compare_entry *e = &s->entry[k];
        if (e->fits) build += e->build, built++;
        wrong += e->wrong[0] + e->wrong[1], held += e->held[0] + e->held[1];
    }
    if (held) table_text(t, "%zu of %zu", wrong, held);
    else table_text(t, built ? "none" : "-");
    cost_cell(t, built, build * 1e3);
}

/* Each structure by scenes: of_ray times a ray and of_build times building [s]. few: with wrong
 * hits, and building in all scenes together. Of building alone (of_ray 0) brute force and the first
 * versions are left out. */
static inline void summary_table(const measured_scenes *m, html_report *to, const char *title,
                                 bool few, double of_ray, double of_build)
{
    char columns[1024] = "structure";  /* 15 of 37 bytes each at most */
    const comparison *end = m->of + m->n;
    if (few) text_add(columns, sizeof columns, "|wrong|build all [ms]");
    for (const comparison *s = m->of; s < end; s++)
        text_add(columns, sizeof columns, "|%.31s%s", s->name, few ? " [ns]" : "");
    table t = table_new(title, columns);
    for (int k = 0; k < m->chosen->n; k++) {
        if (of_ray <= 0 && !contender_counts(m->chosen->of[k].c)) continue;
        table_text(&t, "%s", m->chosen->of[k].label);
        if (few) summary_all(&t, m, k);
        for (const comparison *s = m->of; s < end; s++) {
            const compare_entry *e = &s->entry[k];
            cost_cell(&t, e->fits, of_ray * cost_mean(s, e) + of_build * e->build);
        }
    }
    html_table(to, &t);
}

/* The fastest, of_ray and of_build as above; "-": none fits. Three percent are noise: within them
 * the earlier in the list wins. */
static inline const char *summary_fastest(const comparison *s, double of_ray, double of_build)
{
    const char *name = "-";
    double least = HUGE_VAL;
    for (const compare_entry *e = s->entry; e < s->entry + s->entries; e++) {
        double x = of_ray * cost_mean(s, e) + of_build * e->build;
        if (!e->fits || contender_is_first(e->c) || !(x < 0.97 * least)) continue;
        least = x, name = e->choice->label;
    }
    return name;
}

/* Seconds a ray of c without options of its own; 0: it is not there. */
static inline double summary_usual(const comparison *s, const contender *c)
{
    for (const compare_entry *e = s->entry; e < s->entry + s->entries; e++)
        if (e->c == c && e->choice->how.n == 0) return cost_mean(s, e);
    return 0;
}

static inline void summary_print(const measured_scenes *m, html_report *to)
{
    table t = table_new("Who wins", "scene|shapes|least time a ray|least time in all|"
                                    "ratio kdtree / bvh");
    for (const comparison *s = m->of; s < m->of + m->n; s++) {
        double kd = summary_usual(s, &kdtree_contender), boxes = summary_usual(s, &bvh_contender);
        table_text(&t, "%.31s", s->name), table_count(&t, s->x.n);
        table_text(&t, "%s", summary_fastest(s, 1, 0));
        table_text(&t, "%s", summary_fastest(s, 1e6, 1));
        cost_cell(&t, kd > 0 && boxes > 0, kd / boxes);
    }
    html_table(to, &t);
    summary_table(m, to, "All scenes: nanoseconds a ray", false, 1e9, 0);
    summary_table(m, to, "All scenes: milliseconds to build", false, 0, 1e3);
}

/* How many times as long as the fastest of each scene choice k takes for a ray, the geometric mean;
 * HUGE_VAL: it is a first version, or was not timed everywhere. */
static inline double summary_times(const measured_scenes *m, int k, int kind)
{
    double sum = 0;
    for (const comparison *s = m->of; s < m->of + m->n; s++) {
        double least = HUGE_VAL, its = cost_ns(&s->entry[k], kind);
        for (const compare_entry *e = s->entry; e < s->entry + s->entries; e++) {
            double ns = cost_ns(e, kind);
            if (ns > 0 && !contender_is_first(e->c)) least = fmin(least, ns);
        }
        if (!(its > 0) || contender_is_first(s->entry[k].c)) return HUGE_VAL;
        sum += log(its / least);
    }
    return m->n ? exp(sum / (double)m->n) : HUGE_VAL;
}

static inline void summary_verdict(const measured_scenes *m, const html_report *to)
{
    html_first(to, "h2", "Verdict");
    for (int kind = 0; kind < compare_kinds; kind++) {
        double best = HUGE_VAL, next = HUGE_VAL;
        const char *first = "", *second = "";
        char text[300];
        for (int k = 0; k < m->chosen->n; k++) {
            double its = summary_times(m, k, kind);
            const char *name = m->chosen->of[k].label;
            if (its < best) next = best, second = first, best = its, first = name;
            else if (its < next) next = its, second = name;
        }
        if (next == HUGE_VAL) continue;
        snprintf(text, sizeof text, "Of %s rays %s is the fastest%s; %s, the next, takes %.3g "
                 "times as long.", kind_name[kind], first,
                 m->n > 1 ? " in the mean of all scenes" : "", second, next / best);
        html_first(to, "p", text);
    }
}

static inline void summary_few(const measured_scenes *m, html_report *to)
{
    char title[200] = "A diffuse ray:";
    for (size_t i = 0; i < m->n; i++)
        text_add(title, sizeof title, "%s %.31s of %zu", i ? "," : "", m->of[i].name,
                 m->of[i].x.n);
    summary_table(m, to, title, true, 1e9, 0);
}

/* Its end. */
static inline int chart_bar(FILE *out, int y, int down, double value, double most, const char *fill)
{
    const char *rectangle = "<rect x='%d' y='%d' width='%d' height='%d' fill='%s'/>\n";
    int bar = (int)(chart_bar_most * fmin(value / most, 1) + 0.5), end = chart_left + bar;
    fprintf(out, rectangle, chart_left, y, bar, down, fill);
    if (value > most) fprintf(out, rectangle, end - 16, y, 4, down, "white");
    return end;
}

/* Of n >= 0 values: where bars end. */
static inline double chart_scale(double *x, int n)
{
    double median = n ? clock_median(x, n) : 1;
    return n ? fmin(x[n - 1], 4 * median) : 1;
}

/* A ray, and building a shape [ns]; the quartiles of the first: the mean of the kinds of rays. */
static inline void chart_row_of(FILE *out, const comparison *s, const compare_entry *e, int y,
                                const double most[2])
{
    char text[72] = "does not fit";
    double its = cost_mean(s, e) * 1e9, build = per(e->build, s->x.n) * 1e9, off = 0;
    size_t kinds = 0;
    int end = chart_left;
    for (int k = 0; k < compare_kinds; k++)
        if (e->rays[k]) off += e->spread[k], kinds++;
    if (its > 0) {
        end = chart_bar(out, y + 3, 9, its, most[0], "#0072B2");
        off = (end - chart_left) * per(off, kinds);
        fprintf(out, "<path d='M%.1f,%dH%.1f' stroke='black' stroke-width='2'/>\n", end - off,
                y + 7, end + off);
        int second = chart_bar(out, y + 13, 6, build, most[1], "#E69F00");
        end = second > end ? second : end;
        snprintf(text, sizeof text, "%.*f, %.*f", its < 100, its, build < 100, build);
    }
    plot_text(out, end + 6, y + 15, "font-size=\"12\"", text);
    plot_text(out, chart_left - 6, y + 15, strlen(e->choice->label) > 14
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

static inline void summary_chart(const measured_scenes *m, const html_report *to)
{
    html_element(to, "h2", "What a ray costs, and what building costs");
    html_element(to, "p", "Blue: a ray [ns], the median, and how far its quartiles are apart. "
                 "Orange: building [ns a shape]. A broken bar is longer than there is room.");
    if (!to->body) return;
    fprintf(to->body, "<div class=\"wide\">\n");
    for (size_t k = 0; k < m->n; k++) chart_scene(to->body, &m->of[k]);
    fprintf(to->body, "</div>\n");
}

#endif
