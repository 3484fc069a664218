/* summary.h: all scenes in three tables. A row a structure, a column a scene: nanoseconds a ray,
 * mean of the kinds of rays as the scene has them; milliseconds to build. And who wins: who is
 * fastest, without building and with it, and how many times as long a ray takes in the k-d tree as
 * in the BVH.
 *
 *   compare_summary m = {.chosen = &chosen};
 *   summary_add(&m, &s)                 a scene that was measured
 *   summary_print(&o, &m, report)       the three
 *   summary_few(&o, &m, report)         one: wrong hits, building in all scenes, diffuse rays
 */
#ifndef COMPARE_LAB_SUMMARY_H
#define COMPARE_LAB_SUMMARY_H

#include "costs.h"
#include "html.h"
#include "../../07_mesh/scenes/named.h"

typedef struct {
    char name[32];
    size_t shapes;
    double ray[compare_most], build[compare_most];  /* seconds; ray < 0: does not fit */
    double spread[compare_most];                    /* of ray: half of what lies between its */
                                                    /* quartiles, relative */
    size_t wrong[compare_most], held[compare_most];
} summary_row;
enum { summary_most = 15 };
typedef struct { const line_up *chosen; summary_row row[summary_most]; int rows; } compare_summary;

/* ---------------------------------------------------------------------------------------------- */

static inline void summary_add(compare_summary *m, const comparison *s)
{
    if (m->rows == summary_most) return;
    summary_row *r = &m->row[m->rows++];
    snprintf(r->name, sizeof r->name, "%.31s", s->w->name);
    r->shapes = s->x.n;
    for (int k = 0; k < s->entries; k++) {
        const compare_entry *e = &s->entry[k];
        r->ray[k] = e->s ? cost_mean(s, e) : -1;
        r->build[k] = e->s ? e->build : 0, r->spread[k] = cost_spread(e);
        r->wrong[k] = e->wrong[0] + e->wrong[1], r->held[k] = e->held[0] + e->held[1];
    }
}

/* few: with wrong hits, and building in all scenes together. Of building alone (of_ray 0) brute
 * force and the first versions are left out. */
static inline void summary_table(const options *o, const compare_summary *m, html_report *to,
                                 const char *title, bool few, double of_ray, double of_build)
{
    char columns[512];
    snprintf(columns, sizeof columns, "structure%s", few ? "|wrong|build all [ms]" : "");
    for (int i = 0; i < m->rows; i++) {
        size_t at = strlen(columns);
        snprintf(columns + at, sizeof columns - at, "|%s%s", m->row[i].name, few ? " [ns]" : "");
    }
    table t = table_new(title, columns);
    for (int k = 0; k < m->chosen->n; k++) {
        double build = 0;
        size_t wrong = 0, held = 0;
        if (of_ray <= 0 && !contender_counts(m->chosen->of[k].c)) continue;
        for (int i = 0; i < m->rows; i++) {
            const summary_row *r = &m->row[i];
            build += r->build[k], wrong += r->wrong[k], held += r->held[k];
        }
        table_text(&t, "%s", m->chosen->of[k].label);
        if (few && held) table_text(&t, "%zu of %zu", wrong, held);
        if (few && !held) table_text(&t, "none");
        if (few) table_number(&t, build * 1e3);
        for (int i = 0; i < m->rows; i++) {
            const summary_row *r = &m->row[i];
            if (r->ray[k] < 0) table_text(&t, "-");
            else table_number(&t, of_ray * r->ray[k] + of_build * r->build[k]);
        }
    }
    html_table(to, o, &t);
}

/* The fastest, of_ray and of_build as above; "-": none fits. Three percent are noise: within them
 * the earlier in the list wins. */
static inline const char *summary_fastest(const compare_summary *m, const summary_row *r,
                                          double of_ray, double of_build)
{
    const char *name = "-";
    double least = HUGE_VAL;
    for (int k = 0; k < m->chosen->n; k++) {
        double x = of_ray * r->ray[k] + of_build * r->build[k];
        if (contender_is_first(m->chosen->of[k].c)) continue;
        if (r->ray[k] < 0 || !(x < 0.97 * least)) continue;
        least = x, name = m->chosen->of[k].label;
    }
    return name;
}

/* Number of the first choice of c without options of its own; -1: none. */
static inline int summary_place(const line_up *all, const contender *c)
{
    for (int k = 0; k < all->n; k++)
        if (all->of[k].c == c && all->of[k].how.n == 0) return k;
    return -1;
}

static inline void summary_winners(const options *o, const compare_summary *m, html_report *to)
{
    int kd = summary_place(m->chosen, &kdtree_contender);
    int boxes = summary_place(m->chosen, &bvh_contender);
    table t = table_new("Who wins", "scene|shapes|least time a ray|least time in all|"
                                    "ratio kdtree / bvh");
    for (int i = 0; i < m->rows; i++) {
        const summary_row *r = &m->row[i];
        bool both = kd >= 0 && boxes >= 0 && r->ray[kd] >= 0 && r->ray[boxes] > 0;
        table_text(&t, "%s", r->name), table_count(&t, r->shapes);
        table_text(&t, "%s", summary_fastest(m, r, 1, 0));
        table_text(&t, "%s", summary_fastest(m, r, 1e6, 1));
        if (both) table_number(&t, r->ray[kd] / r->ray[boxes]);
        else table_text(&t, "-");
    }
    html_table(to, o, &t);
}

static inline void summary_print(const options *o, const compare_summary *m, html_report *to)
{
    summary_winners(o, m, to);
    summary_table(o, m, to, "All scenes: nanoseconds a ray", false, 1e9, 0);
    summary_table(o, m, to, "All scenes: milliseconds to build", false, 0, 1e3);
}

static inline void summary_few(const options *o, const compare_summary *m, html_report *to)
{
    char title[200] = "A diffuse ray:";
    for (int i = 0; i < m->rows; i++) {
        size_t at = strlen(title);
        snprintf(title + at, sizeof title - at, "%s %s of %zu", i ? "," : "", m->row[i].name,
                 m->row[i].shapes);
    }
    summary_table(o, m, to, title, true, 1e9, 0);
}

#endif
