/* summary.h: all scenes in three tables. A row a structure, a column a scene: nanoseconds a ray,
 * mean of the kinds of rays as the scene has them; milliseconds to build. And who wins: who is
 * fastest, without building and with it, and how many times as long a ray takes in the k-d tree as
 * in the BVH.
 *
 *   measured_scenes m = {.chosen = &chosen};
 *   measured_add(&m, &s)                a scene that was measured; ends the comparison
 *   summary_print(&m, to)               the three
 *   summary_verdict(&m, to)             at the head of the report: who is fastest, by kind of rays
 *   summary_few(&m, to)                 one: wrong hits, building in all scenes, diffuse rays
 *   measured_free(&m)
 */
#ifndef COMPARE_LAB_SUMMARY_H
#define COMPARE_LAB_SUMMARY_H

#include "costs.h"
#include "../../07_mesh/scenes/named.h"

/* Scenes, one after the other, of the same line-up. */
typedef struct { const line_up *chosen; comparison *of; size_t n, room; } measured_scenes;

/* ---------------------------------------------------------------------------------------------- */

static inline comparison *measured_add(measured_scenes *m, comparison *s)
{
    compare_end(s);
    m->of = grown(m->of, m->n, &m->room, sizeof *m->of);
    m->of[m->n] = *s;
    return &m->of[m->n++];
}

static inline void measured_free(measured_scenes *m) { free(m->of), m->of = NULL, m->n = 0; }

/* Each structure by scenes: of_ray times a ray and of_build times building [s]. few: with wrong
 * hits, and building in all scenes together. Of building alone (of_ray 0) brute force and the first
 * versions are left out. */
static inline void summary_table(const measured_scenes *m, html_report *to, const char *title,
                                 bool few, double of_ray, double of_build)
{
    char columns[1024];
    const comparison *end = m->of + m->n;
    int n = snprintf(columns, sizeof columns, "structure%s", few ? "|wrong|build all [ms]" : "");
    for (const comparison *s = m->of; s < end; s++)  /* 15 of 37 bytes each at most */
        n += snprintf(columns + n, sizeof columns - (size_t)n, "|%.31s%s", s->name,
                      few ? " [ns]" : "");
    table t = table_new(title, columns);
    for (int k = 0; k < m->chosen->n; k++) {
        double build = 0;
        size_t wrong = 0, held = 0, built = 0;
        if (of_ray <= 0 && !contender_counts(m->chosen->of[k].c)) continue;
        for (const comparison *s = m->of; s < end; s++) {
            const compare_entry *e = &s->entry[k];
            if (e->fits) build += e->build, built++;
            wrong += e->wrong[0] + e->wrong[1], held += e->held[0] + e->held[1];
        }
        table_text(&t, "%s", m->chosen->of[k].label);
        if (few && held) table_text(&t, "%zu of %zu", wrong, held);
        if (few && !held) table_text(&t, built ? "none" : "-");
        if (few && built) table_number(&t, build * 1e3);
        if (few && !built) table_text(&t, "-");
        for (const comparison *s = m->of; s < end; s++) {
            const compare_entry *e = &s->entry[k];
            if (!e->fits) table_text(&t, "-");
            else table_number(&t, of_ray * cost_mean(s, e) + of_build * e->build);
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
        if (kd > 0 && boxes > 0) table_number(&t, kd / boxes);
        else table_text(&t, "-");
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
    for (size_t i = 0; i < m->n; i++) {
        size_t at = strlen(title);
        snprintf(title + at, sizeof title - at, "%s %.31s of %zu", i ? "," : "", m->of[i].name,
                 m->of[i].x.n);
    }
    summary_table(m, to, title, true, 1e9, 0);
}

#endif
