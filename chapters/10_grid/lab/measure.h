/* measure.h: the tables and plots of this chapter (09_aabb/trials/bench.h).
 *
 *   measure_variants(o)          wrong hits, memory and time; the main table, and all of it
 *   measure_density(o)           time against cells a shape, on four scenes
 *   measure_stadium(o)           one level and two, where cells of one size cannot serve
 *   measure_drift(o)             how far a walk of up to 1e5 cells goes astray
 */
#ifndef GRID_MEASURE_H
#define GRID_MEASURE_H

#include "../../../common/lab/report.h"
#include "../first.h"
#include "../nested.h"
#include "drift.h"
#include "scenes.h"
#include "specks.h"

TRIAL_VERBS(grid, grid, grid_hit, grid_hit_counted)
TRIAL_VERBS(nested, nested, nested_hit, nested_hit_counted)
TRIAL_OTHER(grid_early, grid, grid, grid_hit_early)
TRIAL_OTHER(grid_added, grid, grid, grid_hit_added)
TRIAL_FIRST(first_grid, b->s = first_grid_build(&b->m))

#define GRID_HOW(density, exact, mailbox) {density, exact, mailbox, (size_t)1 << 30}

static const grid_options grid_by_27 = GRID_HOW(27, true, true);
static const grid_options grid_by_2 = GRID_HOW(2, true, true);
static const grid_options grid_by_512 = GRID_HOW(512, true, true);
static const grid_options grid_by_bounds = GRID_HOW(27, false, true);
static const grid_options grid_unposted = GRID_HOW(27, true, false);
static const nested_options grid_two_levels = {0.1, 4, true, true, (size_t)1 << 30};

/* ---------------------------------------------------------------------------------------------- */

/* ---- wrong hits, memory and time ---- */

/* The first of them are the short table. */
enum { grid_short = 7, grid_rows = 9 };
static const trial_row grid_row_list[grid_rows] = {
    {.name = "first-grid", .verbs = &first_grid_trial},
    {.name = "t added up", .verbs = &grid_added_trial, .how = &grid_by_27},
    {.name = "first hit accepted", .verbs = &grid_early_trial, .how = &grid_by_27},
    {.name = "grid_hit, 27 cells a shape", .verbs = &grid_trial, .how = &grid_by_27},
    {.name = "grid_hit, 2 cells a shape", .verbs = &grid_trial, .how = &grid_by_2},
    {.name = "marked by bounds", .verbs = &grid_trial, .how = &grid_by_bounds},
    {.name = "two levels", .verbs = &nested_trial, .how = &grid_two_levels},
    {.name = "no mailbox", .verbs = &grid_trial, .how = &grid_unposted},
    {.name = "512 cells a shape", .verbs = &grid_trial, .how = &grid_by_512}};

/* Eye rays, and one on from each of their hits; all of them are judged, too. */
static inline void grid_teapot(const options *o, trial_scene *s)
{
    int width = o->quick ? 40 : o->full ? 130 : 60, height = width * 8 / 13;
    trial_scene_of(teapot_mesh(o->full ? 10 : 4), s);
    trial_rays(s, trial_camera(&s->m, (real)width / (real)height), width, height, 0, o->seed,
               &grid_trial, &grid_by_27);
    ray_set *p = &s->rays[TRIAL_PRIMARY], *d = &s->rays[TRIAL_DIFFUSE];
    ray_set all = {allocate(p->n + d->n, sizeof(ray)), p->n + d->n};
    memcpy(all.r, p->r, p->n * sizeof(ray)), memcpy(all.r + p->n, d->r, d->n * sizeof(ray));
    rays_free(&s->rays[TRIAL_CORNERS]);
    s->rays[TRIAL_CORNERS] = all;
    trial_due(s, false);
}

/* Lines through large triangles: each is in many cells. */
static inline void grid_board_scene(const options *o, trial_scene *s)
{
    trial_scene_of(grid_boards(o->full ? 200 : 100, o->seed), s);
    s->rays[TRIAL_CORNERS] = rays_uniform((aabb){{-1, -1, -1}, {1, 1, 1}}, o->full ? 10000 : 2000,
                                          o->seed);
    trial_due(s, false);
}

/* Specks beside the walls of a grid of 27 cells a shape, rays aimed at them. */
static inline void grid_speck_scene(const options *o, trial_scene *s)
{
    size_t n = o->full ? 20000 : 5000;
    trial_scene_of(specks_mesh(o->full ? 2000 : 1000, grid_by_27, o->seed), s);
    s->rays[TRIAL_CORNERS] = (ray_set){allocate(n, sizeof(ray)), n};
    for (size_t i = 0; i < n; i++)
        s->rays[TRIAL_CORNERS].r[i] = specks_ray(&s->m, o->seed, i);
    trial_due(s, false);
}

/* Per cent of the judged rays of s whose hit is not that of brute force. */
static inline double grid_wrong(trial_row r, const trial_scene *s)
{
    r.built = NULL;
    trial_build(&r, s);
    double wrong = 100 * trial_per((double)trial_wrong(&r, s), s->rays[TRIAL_CORNERS].n);
    trial_unbuild(&r);
    return wrong;
}

/* Of primary and diffuse rays together [ns]. */
static inline double grid_ns(const trial_row *r)
{
    return trial_per((r->ray[TRIAL_PRIMARY].seconds + r->ray[TRIAL_DIFFUSE].seconds) * 1e9,
                     r->ray[TRIAL_PRIMARY].n + r->ray[TRIAL_DIFFUSE].n);
}

/* Short: of the first rows, six columns. */
static inline void grid_table(const options *o, const char *title, const trial_row *row, int n,
                              bool at_length, const trial_scene *pot, double wrong[][2])
{
    table t = table_new(title, at_length
        ? "variant|cells|references a shape|cells a ray|tests a ray|error teapot [%]|"
          "error boards [%]|error specks [%]|time [ns a ray]"
        : "variant|bytes a shape|tests a ray|error teapot [%]|error boards [%]|time [ns a ray]");
    for (int i = 0; i < n; i++) {
        structure_stats st = row[i].stats;
        bool first = row[i].verbs->first, counted = row[i].verbs->hit_counted != NULL;
        size_t rays;
        search_work w = trial_sum(&row[i], &rays);
        if (first) {
            const first_grid *g = &((const first_grid_trial_of *)row[i].built)->s;
            st = (structure_stats){.leaves = (size_t)(g->n[0] * g->n[1] * g->n[2]),
                                   .references = g->items, .items = pot->m.triangles};
            st.bytes = st.leaves * sizeof *g->head + g->items * sizeof *g->item;
        }
        table_text(&t, "%s", row[i].name);
        if (at_length) {
            table_count(&t, st.leaves);
            table_number(&t, trial_per((double)st.references, st.items));
            trial_cell(&t, counted && !first, trial_per((double)w.nodes, rays));
        } else table_number(&t, trial_per((double)st.bytes, st.items));
        trial_cell(&t, counted, trial_per((double)w.tests, rays));
        table_number(&t, 100 * trial_per((double)row[i].wrong, rays));
        table_number(&t, wrong[i][0]);
        if (at_length) table_number(&t, wrong[i][1]);
        table_number(&t, grid_ns(&row[i]));
    }
    if (at_length) output_extra_table(o, &t);
    else output_table(o, &t);
}

static inline void measure_variants(const options *o)
{
    int n = o->full ? grid_rows : grid_short;
    char title[160];
    double wrong[grid_rows][2];
    trial_scene pot, boards, specks;
    trial_row row[grid_rows];
    memcpy(row, grid_row_list, sizeof row);
    grid_teapot(o, &pot), grid_board_scene(o, &boards), grid_speck_scene(o, &specks);
    trials_run(row, n, &pot, o->quick ? 3 : o->full ? 25 : 3);
    for (int i = 0; i < n; i++)
        wrong[i][0] = grid_wrong(row[i], &boards), wrong[i][1] = grid_wrong(row[i], &specks);
    snprintf(title, sizeof title, "A teapot of %zu triangles, and boards: wrong hits, work, time",
             pot.m.triangles);
    grid_table(o, title, row, grid_short, false, &pot, wrong);
    snprintf(title, sizeof title, "The same of %zu triangles, at length; specks", pot.m.triangles);
    if (o->full) grid_table(o, title, row, n, true, &pot, wrong);
    trial_end(row, n);
    trial_scene_free(&pot), trial_scene_free(&boards), trial_scene_free(&specks);
}

/* ---- how many cells ---- */

enum { density_first = -3, density_last = 9 };

/* One scene: a point a density in both plots; the row of the table. */
static inline void measure_scene(const options *o, grid_scene kind, table *t, plot *time,
                                 plot *work)
{
    trial_scene s;
    const char *scene_name = grid_scene_name[kind];
    char name[64];
    double best = 0, best_time = 0, at_27 = 0;
    int series = plot_series(time, scene_name), tests, cells;
    snprintf(name, sizeof name, "%s: tests", scene_name), tests = plot_series(work, name);
    snprintf(name, sizeof name, "%s: cells", scene_name), cells = plot_series(work, name);
    grid_scene_of(kind, o->seed, &s);
    for (int k = density_first - 1; k <= density_last; k++) {
        bool notes = k < density_first;  /* 27 first */
        grid_options how = GRID_HOW(notes ? 27 : ldexp(1.0, k), true, true);
        trial_row r = {.name = "", .verbs = &grid_trial, .how = &how};
        trials_run(&r, 1, &s, 9);
        double ns = trial_ns(&r, TRIAL_UNIFORM);
        search_work w = r.ray[TRIAL_UNIFORM].work;
        size_t rays = r.ray[TRIAL_UNIFORM].n;
        trial_end(&r, 1);
        if (notes) { at_27 = ns; continue; }
        if (best == 0 || ns < best_time) best = how.density, best_time = ns;
        plot_add(time, series, how.density, ns);
        plot_add(work, tests, how.density, trial_per((double)w.tests, rays));
        plot_add(work, cells, how.density, trial_per((double)w.nodes, rays));
    }
    trial_row two = grid_row_list[6];
    trials_run(&two, 1, &s, 9);
    table_text(t, "%s", scene_name), table_count(t, s.x.n), table_number(t, best);
    table_number(t, best_time), table_number(t, at_27), table_number(t, at_27 / best_time);
    table_number(t, trial_ns(&two, TRIAL_UNIFORM));
    trial_end(&two, 1), trial_scene_free(&s);
}

static inline void measure_density(const options *o)
{
    table t = table_new("How many cells a shape are best? Lines from everywhere; stadium: eye rays",
                        "scene|shapes|best of times|time best [ns]|time at 27 [ns]|"
                        "time 27 / best|time two levels [ns]");
    plot time = plot_new("Time against cells", "cells a shape", "time a ray [ns]",
                         PLOT_LOG_X | PLOT_LOG_Y);
    plot work = plot_new("Work against cells", "cells a shape", "a ray", PLOT_LOG_X | PLOT_LOG_Y);
    for (int k = 0; k < grid_scenes; k++) measure_scene(o, (grid_scene)k, &t, &time, &work);
    output_extra_table(o, &t);
    output_plot(o, &time, "10_grid_time.svg");
    output_plot(o, &work, "10_grid_density.svg");
}

/* ---- one level and two ---- */

static inline void measure_stadium(const options *o)
{
    table t = table_new("One level and two: the teapot alone, and in a stadium",
                        "scene|structure|build [ms]|bytes a shape|cells a ray|tests a ray|"
                        "time [ns]");
    static const trial_row list[4] = {
        {.name = "grid, 2 cells a shape", .verbs = &grid_trial, .how = &grid_by_2},
        {.name = "grid, 27 cells a shape", .verbs = &grid_trial, .how = &grid_by_27},
        {.name = "grid, 512 cells a shape", .verbs = &grid_trial, .how = &grid_by_512},
        {.name = "two levels", .verbs = &nested_trial, .how = &grid_two_levels}};
    for (int both = 0; both < 2; both++) {
        grid_scene kind = both ? GRID_STADIUM : GRID_TEAPOT;
        trial_scene s;
        trial_row row[4];
        grid_scene_of(kind, o->seed, &s);
        memcpy(row, list, sizeof row);
        trials_run(row, 4, &s, 9);
        for (int i = 0; i < 4; i++) {
            const structure_stats *st = &row[i].stats;
            search_work w = row[i].ray[TRIAL_UNIFORM].work;
            size_t rays = row[i].ray[TRIAL_UNIFORM].n;
            table_text(&t, "%s", grid_scene_name[kind]), table_text(&t, "%s", row[i].name);
            table_number(&t, row[i].build * 1e3);
            table_number(&t, trial_per((double)st->bytes, st->items));
            table_number(&t, trial_per((double)w.nodes, rays));
            table_number(&t, trial_per((double)w.tests, rays));
            table_number(&t, trial_ns(&row[i], TRIAL_UNIFORM));
        }
        trial_end(row, 4), trial_scene_free(&s);
    }
    output_extra_table(o, &t);
}

/* ---- how far a walk goes astray ---- */

static inline void measure_drift(const options *o)
{
    static const char *const name[3] = {"t added up", "walls counted", "the margin of the lists"};
    table t = table_new("1000 walks past an edge: which miss a cell, and how far off the next "
                        "wall is", "cells passed|error added [% of walks]|error added [cells]|"
                        "error counted [% of walks]|error counted [cells]|margin [cells]");
    plot p = plot_new("How far off is the next wall?", "cells passed", "error [cells]",
                      PLOT_LOG_X | PLOT_LOG_Y);
    for (int k = 0; k < 3; k++) plot_series(&p, name[k]);
    plot_slope(&p, 2, "slope 2"), plot_slope(&p, 1, "slope 1");
    for (size_t n = 10; n <= 100000; n *= 10) {
        drift added = drift_after(walk_step_naive, n, 1000, o->seed);
        drift counted = drift_after(walk_step, n, 1000, o->seed);
        table_count(&t, n);
        table_number(&t, 100 * added.missed), table_number(&t, added.error);
        table_number(&t, 100 * counted.missed), table_number(&t, counted.error);
        table_number(&t, drift_margin(n));
        plot_add(&p, 0, (double)n, added.error), plot_add(&p, 1, (double)n, counted.error);
        plot_add(&p, 2, (double)n, drift_margin(n));
    }
    output_extra_table(o, &t);
    output_plot(o, &p, "10_grid_drift.svg");
}

#endif
