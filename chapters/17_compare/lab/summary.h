/* summary.h: all scenes together: tables of a row a structure, a column a scene (nanoseconds a ray,
 * mean of the kinds of rays as the scene has them; milliseconds to build); who wins; bars (柱状图).
 *
 *   measured_add(&m, &s)                a scene that was measured; ends the comparison
 *   summary_print(&m, to)               who wins: fastest without building, and with it; the tables
 *   summary_verdict(&m, to)             at the head of the report: who is fastest
 *   summary_few(&m, to)                 one: wrong hits, building in all scenes, diffuse rays
 *   summary_chart(&m, to)               in the report, bars for each scene: a ray, and building,
 *                                       each to the longest or four times the median
 *   measured_free(&m)
 */
#ifndef COMPARE_LAB_SUMMARY_H
#define COMPARE_LAB_SUMMARY_H

#include "costs.h"

/* Scenes, one after the other, of the same line-up. */
typedef struct { const line_up *chosen; comparison *of; size_t n, room; } measured_scenes;
enum { chart_wide = 200 };  /* pixels, of the longest bar */

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

static inline void summary_verdict(const measured_scenes *m, const html_report *to)
{
    char text[1000] = "The least time a ray:";  /* 24 scenes of 35 bytes at most */
    for (const comparison *s = m->of; s < m->of + m->n; s++)
        text_add(text, sizeof text, "%s %.31s %s", s > m->of ? "," : "", s->name,
                 summary_fastest(s, 1, 0));
    html_first(to, "h2", "Verdict");
    html_first(to, "p", text);
}

static inline void summary_few(const measured_scenes *m, html_report *to)
{
    char title[200] = "A diffuse ray:";
    for (size_t i = 0; i < m->n; i++)
        text_add(title, sizeof title, "%s %.31s of %zu", i ? "," : "", m->of[i].name,
                 m->of[i].x.n);
    summary_table(m, to, title, true, 1e9, 0);
}

/* Of n >= 0 values: where bars end. */
static inline double chart_scale(double *x, int n)
{
    double median = n ? clock_median(x, n) : 1;
    return n ? fmin(x[n - 1], 4 * median) : 1;
}

/* A bar, its quartiles upon it, and the number. */
static inline void chart_bar(FILE *out, double x, double most, double spread, const char *fill)
{
    double end = chart_wide * fmin(x / most, 1);
    fprintf(out, "<td><svg width='%d' height='12'><rect width='%.1f' height='12' fill='%s'/>",
            (int)chart_wide, end, fill);
    if (x > most) fprintf(out, "<rect x='%.1f' width='4' height='12' fill='white'/>", end - 16);
    if (spread > 0)
        fprintf(out, "<path d='M%.1f,6H%.1f' stroke='black' stroke-width='2'/>",
                end * (1 - spread), end * (1 + spread));
    fprintf(out, "</svg> %.*f</td>", x < 100, x);
}

/* A ray, and building a shape; of the first the quartiles, the mean of the kinds of rays. */
static inline void chart_row(FILE *out, const comparison *s, const compare_entry *e,
                             const double most[2])
{
    double its = cost_mean(s, e) * 1e9, off = 0;
    size_t kinds = 0;
    for (int k = 0; k < compare_kinds; k++)
        if (e->rays[k]) off += e->spread[k], kinds++;
    fprintf(out, "<tr><td>%s</td>", e->choice->label);
    if (its > 0) {
        chart_bar(out, its, most[0], per(off, kinds), "#0072B2");
        chart_bar(out, per(e->build * 1e9, s->x.n), most[1], 0, "#E69F00");
    } else fprintf(out, "<td>does not fit</td>");
    fprintf(out, "</tr>\n");
}

static inline void chart_scene(const html_report *to, const comparison *s)
{
    double value[2][compare_most];
    int n = 0;
    const compare_entry *end = s->entry + s->entries;
    for (const compare_entry *e = s->entry; e < end; e++)
        if (entry_counts(e) && cost_mean(s, e) > 0)
            value[0][n] = cost_mean(s, e) * 1e9, value[1][n++] = per(e->build * 1e9, s->x.n);
    const double most[2] = {chart_scale(value[0], n), chart_scale(value[1], n)};
    html_element(to, "h3", s->name);
    fprintf(to->body, "<div class=\"wide\"><table>\n");
    for (const compare_entry *e = s->entry; e < end; e++)
        if (contender_counts(e->c)) chart_row(to->body, s, e, most);
    fprintf(to->body, "</table></div>\n");
}

static inline void summary_chart(const measured_scenes *m, const html_report *to)
{
    html_element(to, "h2", "What a ray costs, and what building costs");
    html_element(to, "p", "Blue: a ray [ns], the median, and how far its quartiles are apart. "
                 "Orange: building [ns a shape]. A broken bar is longer than there is room.");
    for (size_t k = 0; to->body && k < m->n; k++) chart_scene(to, &m->of[k]);
}

#endif
