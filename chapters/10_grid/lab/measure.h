/* measure.h: the tables and plots of this chapter (09_aabb/trials/bench.h).
 *
 *   measure_variants(o)          wrong hits and time; the main table
 *   plot_wrong(o)                wrong hits against time, for 1 to 243 cells a shape
 *   measure_density(o)           time against cells an item, on four scenes
 *   measure_stadium(o)           one level and two, where cells of one size cannot serve
 *   measure_drift(o)             how far a walk of up to 1e5 cells goes astray
 */
#ifndef GRID_MEASURE_H
#define GRID_MEASURE_H

#include "../../../common/lab/report.h"
#include "../first.h"
#include "../nested.h"
#include "drift.h"
#include "naive.h"
#include "scenes.h"
#include "specks.h"

TRIAL_VERBS(grid, grid, grid_hit, grid_hit_counted)
TRIAL_VERBS(nested, nested, nested_hit, nested_hit_counted)
TRIAL_OTHER(grid_early, grid, grid, grid_hit_early)
TRIAL_OTHER(grid_naive, grid, grid, grid_hit_naive)
TRIAL_FIRST(first_grid, b->s = first_grid_build(&b->m))

typedef struct { const char *name; const trial_verbs *verbs; grid_options how; } grid_candidate;

#define GRID_HOW(density, exact, mailbox) {density, exact, mailbox, (size_t)1 << 30}

/* The first seven are the short table. */
enum { grid_short = 7, grid_candidates = 11 };
static const grid_candidate grid_candidate_list[grid_candidates] = {
    {"first", &first_grid_trial, GRID_HOW(27, false, false)},
    {"t added up, float", &grid_naive_trial, GRID_HOW(27, true, true)},
    {"first hit accepted", &grid_early_trial, GRID_HOW(27, true, true)},
    {"grid_hit", &grid_trial, GRID_HOW(27, true, true)},
    {"marked by bounds", &grid_trial, GRID_HOW(27, false, true)},
    {"1 cell a shape", &grid_trial, GRID_HOW(1, true, true)},
    {"two levels", &nested_trial, GRID_HOW(27, true, true)},
    {"no mailbox", &grid_trial, GRID_HOW(27, true, false)},
    {"by bounds, no mailbox", &grid_trial, GRID_HOW(27, false, false)},
    {"10 cells a shape", &grid_trial, GRID_HOW(10, true, true)},
    {"100 cells a shape", &grid_trial, GRID_HOW(100, true, true)}};

/* ---------------------------------------------------------------------------------------------- */

static inline trial_row grid_row(const grid_candidate *c)
{
    static nested_options two;
    two = nested_defaults;
    bool nest = c->verbs == &nested_trial;
    return (trial_row){.name = c->name, .verbs = c->verbs,
                       .how = nest ? (const void *)&two : (const void *)&c->how};
}

/* ---- wrong hits against time ---- */

/* Eye rays, and one on from each of their hits; all of them are judged, too. */
static inline void grid_teapot(const options *o, trial_scene *s)
{
    int width = o->quick ? 40 : o->full ? 130 : 60, height = width * 8 / 13;
    trial_scene_of(teapot_mesh(o->full ? 10 : 4), s);
    trial_rays(s, trial_camera(&s->m, (real)width / (real)height), width, height, 0, o->seed,
               &grid_trial, &grid_candidate_list[3].how);
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

/* Specks beside the walls of a grid that is built with `how`, rays aimed at them. */
static inline void grid_speck_scene(const options *o, grid_options how, trial_scene *s)
{
    size_t n = o->full ? 20000 : 5000;
    trial_scene_of(specks_mesh(o->full ? 2000 : 1000, how, o->seed), s);
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

static inline void measure_variants(const options *o)
{
    int n = o->full ? grid_candidates : grid_short;
    char title[160];
    trial_scene pot, boards, specks;
    trial_row row[grid_candidates];
    grid_teapot(o, &pot), grid_board_scene(o, &boards);
    grid_speck_scene(o, grid_candidate_list[3].how, &specks);
    snprintf(title, sizeof title,
             "Wrong hits on three scenes; work and time a ray on the teapot of "
             "%zu triangles", pot.m.triangles);
    table t = table_new(title, o->full
        ? "variant|cells|references a shape|cells a ray|tests a ray|error teapot [%]|"
          "error boards [%]|error specks [%]|time [ns]"
        : "variant|cells|tests a ray|error boards [%]|error specks [%]|time [ns]");
    for (int i = 0; i < n; i++) row[i] = grid_row(&grid_candidate_list[i]);
    trials_run(row, n, &pot, o->quick ? 3 : o->full ? 25 : 4);
    for (int i = 0; i < n; i++) {
        const structure_stats *st = &row[i].stats;
        const first_grid *g = &((const first_grid_trial_of *)row[i].built)->s;
        bool first = row[i].verbs->first, counted = row[i].verbs->hit_counted != NULL;
        size_t rays, cells = first ? (size_t)(g->n[0] * g->n[1] * g->n[2]) : st->leaves;
        double references = first ? (double)g->items : (double)st->references;
        search_work w = trial_sum(&row[i], &rays);
        table_text(&t, "%s", row[i].name), table_count(&t, cells);
        if (o->full) {
            table_number(&t, references / (double)pot.m.triangles);
            trial_cell(&t, counted && !first, trial_per((double)w.nodes, rays));
        }
        trial_cell(&t, counted, trial_per((double)w.tests, rays));
        if (o->full) table_number(&t, 100 * trial_per((double)row[i].wrong, rays));
        table_number(&t, grid_wrong(row[i], &boards));
        table_number(&t, grid_wrong(row[i], &specks));
        table_number(&t, grid_ns(&row[i]));
    }
    output_table(o, &t);
    trial_end(row, n);
    trial_scene_free(&pot), trial_scene_free(&boards), trial_scene_free(&specks);
}

/* Each variant a curve through 1, 3, .. 243 cells a shape: the worse of boards and specks. */
static inline void plot_wrong(const options *o)
{
    enum { shown = 3 };
    plot p = plot_new("Wrong hits against time, 1, 3, 9 .. 243 cells a shape",
                      "time a ray, teapot [ns]", "wrong, boards or specks [%]", 0);
    trial_scene pot, boards;
    grid_teapot(o, &pot), grid_board_scene(o, &boards);
    for (int i = 1; i <= shown; i++) plot_series(&p, grid_candidate_list[i].name);
    for (double density = 1; density < 300; density *= 3) {
        trial_scene specks;
        trial_row row[shown];
        grid_candidate c[shown];
        for (int i = 0; i < shown; i++) {
            c[i] = grid_candidate_list[i + 1], c[i].how.density = density;
            row[i] = grid_row(&c[i]);
        }
        grid_speck_scene(o, c[0].how, &specks);
        trials_run(row, shown, &pot, 9);
        for (int i = 0; i < shown; i++)
            plot_add(&p, i, grid_ns(&row[i]),
                     fmax(grid_wrong(row[i], &boards), grid_wrong(row[i], &specks)));
        trial_end(row, shown), trial_scene_free(&specks);
    }
    output_plot(o, &p, "10_grid_wrong_time.svg");
    trial_scene_free(&pot), trial_scene_free(&boards);
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
    trial_row two = grid_row(&grid_candidate_list[6]);
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
    static const grid_candidate list[4] = {
        {"grid, 1 cells a shape", &grid_trial, GRID_HOW(1, true, true)},
        {"grid, 27 cells a shape", &grid_trial, GRID_HOW(27, true, true)},
        {"grid, 512 cells a shape", &grid_trial, GRID_HOW(512, true, true)},
        {"two levels", &nested_trial, GRID_HOW(27, true, true)}};
    for (int both = 0; both < 2; both++) {
        grid_scene kind = both ? GRID_STADIUM : GRID_TEAPOT;
        trial_scene s;
        trial_row row[4];
        grid_scene_of(kind, o->seed, &s);
        for (int i = 0; i < 4; i++) row[i] = grid_row(&list[i]);
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
    table t = table_new("Walks in a wrong cell, and how far off the next wall is",
                        "cells passed|float, added: wrong [%]|off [cells]|added: wrong [%]|"
                        "off [cells]|counted: wrong [%]|off [cells]");
    plot p = plot_new("How far off is the next wall?", "cells passed", "error [cells]",
                      PLOT_LOG_X | PLOT_LOG_Y);
    for (int k = 0; k < drift_kinds; k++) plot_series(&p, drift_name[k]);
    plot_slope(&p, 2, "slope 2"), plot_slope(&p, 1, "slope 1");
    for (size_t n = 10; n <= 100000; n *= 10) {
        table_count(&t, n);
        for (int k = 0; k < drift_kinds; k++) {
            drift d = drift_after((drift_kind)k, n, 200, o->seed);
            table_number(&t, 100 * d.wrong), table_number(&t, d.error);
            plot_add(&p, k, (double)n, d.error);
        }
    }
    output_extra_table(o, &t);
    output_plot(o, &p, "10_grid_drift.svg");
}

#endif
