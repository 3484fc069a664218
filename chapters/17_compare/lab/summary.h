/* summary.h: all scenes in four tables. A row a scene, a column a structure: nanoseconds a ray,
 * mean of the four kinds as the scene has them; milliseconds to build; seconds in all for building
 * and a million rays. And who wins: who is fastest, and how many times as long a ray takes in the
 * k-d tree as in the BVH. Or in one: a row a structure, a column a scene.
 *
 *   compare_summary m = {.chosen = chosen};
 *   summary_add(&m, &s)                 a stage that was measured
 *   summary_print(&o, &m)               the four
 *   summary_few(&o, &m)                 the one
 */
#ifndef COMPARE_LAB_SUMMARY_H
#define COMPARE_LAB_SUMMARY_H

#include "costs.h"
#include "scenes.h"

typedef struct {
    char name[32];
    size_t shapes;
    double ray[contenders], build[contenders];
} summary_row;
typedef struct { unsigned chosen; summary_row row[scenes]; int rows; } compare_summary;

/* ---------------------------------------------------------------------------------------------- */

static inline void summary_add(compare_summary *m, const comparison *s)
{
    if (m->rows == scenes) return;
    summary_row *r = &m->row[m->rows++];
    snprintf(r->name, sizeof r->name, "%.31s", s->w->name);
    r->shapes = s->x.n;
    for (int k = 0, i = 0; k < contenders; k++) {
        if (!(m->chosen >> k & 1)) continue;
        const compare_entry *e = &s->entry[i++];
        r->ray[k] = e->s ? cost_mean(s, e) : -1;
        r->build[k] = e->build;
    }
}

static inline void summary_table(const options *o, const compare_summary *m, const char *title,
                                 double of_ray, double of_build)
{
    char columns[512] = "scene";
    for (int k = 0; k < contenders; k++)
        if (m->chosen >> k & 1)
            snprintf(columns + strlen(columns), sizeof columns - strlen(columns), "|%s",
                     contender_list[k]->name);
    table t = table_new(title, columns);
    for (int i = 0; i < m->rows; i++) {
        table_text(&t, "%s", m->row[i].name);
        for (int k = 0; k < contenders; k++) {
            const summary_row *r = &m->row[i];
            if (!(m->chosen >> k & 1)) continue;
            if (r->ray[k] < 0) table_text(&t, "does not fit");
            else table_number(&t, of_ray * r->ray[k] + of_build * r->build[k]);
        }
    }
    output_extra_table(o, &t);
}

/* The fastest, of_ray and of_build as above; "-": none fits. Three percent are noise: within them
 * the earlier in the list wins. */
static inline const char *summary_fastest(const compare_summary *m, const summary_row *r,
                                          double of_ray, double of_build)
{
    const char *name = "-";
    double least = HUGE_VAL;
    for (int k = 0; k < contenders; k++) {
        double x = of_ray * r->ray[k] + of_build * r->build[k];
        if (!(m->chosen >> k & 1) || r->ray[k] < 0 || !(x < 0.97 * least)) continue;
        least = x, name = contender_list[k]->name;
    }
    return name;
}

static inline void summary_winners(const options *o, const compare_summary *m)
{
    int kd = contender_number(&kdtree_contender), boxes = contender_number(&bvh_contender);
    bool chosen = m->chosen >> kd & m->chosen >> boxes & 1;
    table t = table_new("Who wins", "scene|least time a ray|least time in all|ratio kdtree / bvh");
    for (int i = 0; i < m->rows; i++) {
        const summary_row *r = &m->row[i];
        bool both = chosen && r->ray[kd] >= 0 && r->ray[boxes] > 0;
        table_text(&t, "%s", r->name);
        table_text(&t, "%s", summary_fastest(m, r, 1, 0));
        table_text(&t, "%s", summary_fastest(m, r, 1e6, 1));
        if (both) table_number(&t, r->ray[kd] / r->ray[boxes]);
        else table_text(&t, "-");
    }
    output_extra_table(o, &t);
}

static inline void summary_print(const options *o, const compare_summary *m)
{
    summary_table(o, m, "All scenes: nanoseconds a ray", 1e9, 0);
    summary_table(o, m, "All scenes: milliseconds to build", 0, 1e3);
    summary_table(o, m, "All scenes: seconds to build and to search for a million rays", 1e6, 1);
    summary_winners(o, m);
}

/* Building counts in all scenes together. */
static inline void summary_few(const options *o, const compare_summary *m)
{
    char title[200] = "A ray, mean of four kinds:", columns[200] = "structure|build all [ms]";
    for (int i = 0; i < m->rows; i++) {
        size_t at = strlen(title), to = strlen(columns);
        snprintf(title + at, sizeof title - at, "%s %s of %zu", i ? "," : "", m->row[i].name,
                 m->row[i].shapes);
        snprintf(columns + to, sizeof columns - to, "|%s [ns]", m->row[i].name);
    }
    table t = table_new(title, columns);
    for (int k = 0; k < contenders; k++) {
        double build = 0;
        if (!(m->chosen >> k & 1)) continue;
        for (int i = 0; i < m->rows; i++) build += m->row[i].build[k];
        table_text(&t, "%s", contender_list[k]->name), table_number(&t, build * 1e3);
        for (int i = 0; i < m->rows; i++)
            if (m->row[i].ray[k] < 0) table_text(&t, "does not fit");
            else table_number(&t, m->row[i].ray[k] * 1e9);
    }
    output_extra_table(o, &t);
}

#endif
