/* bench.h: acceleration structures on the same items and the same equal rays: what each costs.
 *
 *   trial_scene s;                                        must stay where it is: s.x points into it
 *   trial_scene_of(teapot_mesh(8), &s);                   takes the mesh; no rays yet
 *   s.rays[TRIAL_PRIMARY] = rays_primary(camera, 160, 100);                rays of your own, or:
 *   trial_rays(&s, camera, 160, 100, 1000, seed, &v, &how);   primary ones; diffuse ones from where
 *                                     they hit, as v finds it; 1000 at corners, and what is due
 *   trial_row row[] = {{.name = "middle", .verbs = &v, .how = &how}, ..};
 *   trials_run(row, n, &s, 5);        builds, counts, compares with brute force; then all in
 *                                     turn, 5 rounds and one to warm up, for each kind of rays
 *   table t = trial_table("..", row, n, &s, o.full, NULL);     a row each, and one of brute force
 *   trial_end(row, n), trial_scene_free(&s);
 *
 * Kinds of rays (survey.h): primary, diffuse, uniform; corners only judge, and are not timed. What
 * is compared, as data: contender.h. How it is built and timed: run.h.
 */
#ifndef TRIALS_BENCH_H
#define TRIALS_BENCH_H

#include "../../../common/lab/table.h"
#include "run.h"

/* Columns of a chapter's own, behind those of size: names with | before each, and their cells. */
typedef struct { const char *names; void (*cells)(table *t, const trial_row *r); } trial_columns;

/* ---------------------------------------------------------------------------------------------- */

/* Work of all kinds that were timed, and how many rays these were. */
static inline search_work trial_sum(const trial_row *r, size_t *rays)
{
    search_work w = {0, 0, 0, 0};
    *rays = 0;
    for (int k = 0; k < TRIAL_CORNERS; k++) {
        w.nodes += r->ray[k].work.nodes, w.leaves += r->ray[k].work.leaves;
        w.tests += r->ray[k].work.tests, *rays += r->ray[k].n;
    }
    return w;
}

static inline double trial_ns(const trial_row *r, trial_rays_kind k)
{
    return trial_per(r->ray[k].seconds * 1e9, r->ray[k].n);
}

/* A number, or "-" where nobody knows. */
static inline void trial_cell(table *t, bool known, double x)
{
    if (known) table_number(t, x);
    else table_text(t, "-");
}

/* In six columns of two kinds of rays only the second has room. */
static inline bool trial_shown(const trial_scene *s, int kind, bool full)
{
    return s->rays[kind].n && (full || kind != TRIAL_PRIMARY || !s->rays[TRIAL_DIFFUSE].n);
}

static inline void trial_cells(table *t, const trial_row *r, const trial_scene *s, bool full,
                               const trial_columns *own)
{
    const structure_stats *st = &r->stats;
    bool known = r->verbs->stats != NULL, counted = r->verbs->hit_counted && !r->verbs->first;
    double spread = 0;
    size_t rays;
    search_work w = trial_sum(r, &rays);
    table_text(t, "%s", r->name), table_number(t, r->build * 1e3);
    trial_cell(t, known, trial_per((double)st->bytes, st->items));
    if (full) {
        trial_cell(t, known, trial_per((double)st->peak, st->items));
        trial_cell(t, known, st->depth);
        trial_cell(t, known, trial_per((double)st->references, st->items));
        if (own && r->verbs->first)
            for (const char *c = own->names; *c; c++) *c == '|' ? table_text(t, "-") : (void)0;
        else if (own) own->cells(t, r);
        trial_cell(t, counted, trial_per((double)w.nodes, rays));
        trial_cell(t, counted, trial_per((double)w.leaves, rays));
    }
    trial_cell(t, r->verbs->hit_counted != NULL, trial_per((double)w.tests, rays));
    table_count(t, r->wrong);
    for (int k = 0; k < TRIAL_CORNERS; k++) {
        if (!trial_shown(s, k, full)) continue;
        table_number(t, trial_ns(r, (trial_rays_kind)k));
        spread = fmax(spread, r->ray[k].spread);
    }
    if (full) table_number(t, 100 * spread);
}

/* Not full: six columns. The title is not copied. */
static inline table trial_table(const char *title, const trial_row *row, int n,
                                const trial_scene *s, bool full, const trial_columns *own)
{
    char names[600];
    int at = snprintf(names, sizeof names, "structure|time build [ms]|bytes a shape%s%s%s"
                      "|tests a ray|error [wrong]",
                      full ? "|peak bytes a shape|depth|references a shape" : "",
                      full && own ? own->names : "", full ? "|nodes a ray|leaves a ray" : "");
    for (int k = 0; k < TRIAL_CORNERS; k++)
        if (trial_shown(s, k, full))
            at += snprintf(names + at, sizeof names - (size_t)at, "|time %s [ns]",
                           trial_kind_name[k]);
    snprintf(names + at, sizeof names - (size_t)at, "%s", full ? "|time spread [%]" : "");
    table t = table_new(title, names);
    for (int i = 0; i < n; i++) trial_cells(&t, &row[i], s, full, own);
    if (s->brute <= 0) return t;
    size_t before = 0;  /* columns between the name and the tests */
    while (strncmp(t.cell[before], "tests", 5) != 0) before++;
    table_text(&t, "brute force");
    for (size_t k = 1; k < before; k++) table_text(&t, "-");
    table_number(&t, (double)s->x.n), table_count(&t, 0);
    for (int k = 0; k < TRIAL_CORNERS; k++)
        if (trial_shown(s, k, full)) table_number(&t, s->brute * 1e9);
    if (full) table_text(&t, "-");
    return t;
}

/* "65280 triangles: 16000 primary and 3881 diffuse rays, one thread; wrong of 1000 at corners" */
static inline const char *trial_title(const trial_scene *s, char room[160])
{
    snprintf(room, 160, "%zu triangles: %zu primary and %zu diffuse rays, one thread; wrong of %zu "
             "at corners", s->m.triangles, s->rays[TRIAL_PRIMARY].n, s->rays[TRIAL_DIFFUSE].n,
             s->rays[TRIAL_CORNERS].n);
    return room;
}

#endif
