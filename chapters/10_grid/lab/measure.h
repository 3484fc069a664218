/* measure.h: the tables and plots of this chapter (09_aabb/trials/bench.h).
 *
 *   measure_variants(o)          wrong hits, memory and time; the main table
 *   measure_density(o)           the plot of time against cells a shape, on three scenes
 *   measure_drift(o)             how far a walk of up to 1e5 cells goes astray
 */
#ifndef GRID_MEASURE_H
#define GRID_MEASURE_H

#include "../../../common/lab/report.h"
#include "../../07_mesh/scenes/soup.h"
#include "../../07_mesh/scenes/stadium.h"
#include "../../09_aabb/trials/bench.h"
#include "../first.h"
#include "../trials/nested.h"
#include "drift.h"

TRIAL_VERBS(grid, grid, grid_hit, grid_hit_counted)
TRIAL_VERBS(nested, nested, nested_hit, nested_hit_counted)
TRIAL_OTHER(grid_early, grid, grid, grid_hit_early)
TRIAL_OTHER(grid_added, grid, grid, grid_hit_added)
TRIAL_FIRST(first_grid, b->s = first_grid_build(&b->m))

#define GRID_HOW(density, exact, mailbox) {density, exact, mailbox, (size_t)1 << 30}

static const grid_options grid_by_27 = GRID_HOW(27, true, true);
static const grid_options grid_by_2 = GRID_HOW(2, true, true);
static const grid_options grid_by_bounds = GRID_HOW(27, false, true);
static const grid_options grid_unposted = GRID_HOW(27, true, false);
static const nested_options grid_two_levels = {0.1, 4, true, true, (size_t)1 << 30};

enum { grid_rows = 8 };
static const trial_row grid_row_list[grid_rows] = {
    {.name = "first-grid", .verbs = &first_grid_trial},
    {.name = "t added up", .verbs = &grid_added_trial, .how = &grid_by_27},
    {.name = "first hit accepted", .verbs = &grid_early_trial, .how = &grid_by_27},
    {.name = "grid_hit, 27 cells a shape", .verbs = &grid_trial, .how = &grid_by_27},
    {.name = "grid_hit, 2 cells a shape", .verbs = &grid_trial, .how = &grid_by_2},
    {.name = "marked by bounds", .verbs = &grid_trial, .how = &grid_by_bounds},
    {.name = "no mailbox", .verbs = &grid_trial, .how = &grid_unposted},
    {.name = "two levels", .verbs = &nested_trial, .how = &grid_two_levels}};

/* ---------------------------------------------------------------------------------------------- */

/* n large triangles across the cube of side 2: each passes through many cells, and through many
 * others. */
static inline mesh grid_boards(size_t n, uint64_t seed)
{
    mesh m = mesh_room(n);
    for (size_t i = 0; i < 3 * n; i++) {
        random_stream g = random_start(seed, i, 4);
        m.v[i] = random_in_cube(&g, 1);
    }
    return m;
}

/* So near to the small teapot of a stadium that it fills the picture. */
static inline camera grid_stadium_camera(void)
{
    mesh pot = teapot_mesh(4);
    camera c = trial_camera(&pot, 1);
    mesh_free(&pot);
    return c;
}

/* ---- wrong hits, memory and time ---- */

/* Bytes: of lists and cells. */
static inline double grid_bytes(const trial_row *r, const trial_scene *s)
{
    if (!r->verbs->first) return trial_per((double)r->stats.bytes, r->stats.items);
    const first_grid *g = &((const first_grid_trial_of *)r->built)->s;
    size_t cells = (size_t)g->n[0] * (size_t)g->n[1] * (size_t)g->n[2];
    return trial_per((double)(cells * sizeof *g->head + g->items * sizeof *g->item), s->x.n);
}

/* Of the judged rays of s, those whose hit is not that of brute force [%]. */
static inline double grid_wrong(const trial_row *r, const trial_scene *s)
{
    return 100 * trial_per((double)trial_wrong(r, s), s->rays[TRIAL_CORNERS].n);
}

static inline void measure_variants(const options *o)
{
    int width = o->quick ? 40 : o->full ? 130 : 50;
    char title[160];
    trial_scene pot, boards;
    trial_row row[grid_rows], other[grid_rows];
    memcpy(row, grid_row_list, sizeof row), memcpy(other, grid_row_list, sizeof other);

    /* Rays from the eye, and one on from each of their hits; the latter are judged. */
    trial_scene_of(teapot_mesh(o->full ? 10 : 4), &pot);
    trial_rays(&pot, trial_camera(&pot.m, 1.625), width, width * 8 / 13, 0, o->seed, &grid_trial,
               &grid_by_27);
    trials_run(row, grid_rows, &pot, o->quick ? 3 : o->full ? 25 : 3);
    rays_free(&pot.rays[TRIAL_CORNERS]);
    pot.rays[TRIAL_CORNERS] = pot.rays[TRIAL_DIFFUSE], pot.rays[TRIAL_DIFFUSE] = (ray_set){0};
    trial_due(&pot, false);

    /* Lines through large triangles: each is in many cells. */
    trial_scene_of(grid_boards(o->full ? 200 : 100, o->seed), &boards);
    boards.rays[TRIAL_CORNERS] = rays_uniform((aabb){{-1, -1, -1}, {1, 1, 1}},
                                              o->full ? 10000 : 2000, o->seed);
    trial_due(&boards, false), trials_run(other, grid_rows, &boards, 1);

    snprintf(title, sizeof title, "A teapot of %zu triangles, and boards: wrong hits, work, time",
             pot.m.triangles);
    table t = table_new(title, "variant|bytes a shape|tests a ray|error teapot [%]|"
                        "error boards [%]|time [ns a ray]");
    for (int i = 0; i < grid_rows; i++) {
        size_t rays;
        search_work w = trial_sum(&row[i], &rays);
        double seconds = row[i].ray[TRIAL_PRIMARY].seconds + row[i].ray[TRIAL_DIFFUSE].seconds;
        table_text(&t, "%s", row[i].name), table_number(&t, grid_bytes(&row[i], &pot));
        trial_cell(&t, row[i].verbs->hit_counted != NULL, trial_per((double)w.tests, rays));
        table_number(&t, grid_wrong(&row[i], &pot));
        table_number(&t, grid_wrong(&other[i], &boards));
        table_number(&t, trial_per(seconds * 1e9, rays));
    }
    output_table(o, &t);
    trial_end(row, grid_rows), trial_end(other, grid_rows);
    trial_scene_free(&pot), trial_scene_free(&boards);
}

/* ---- how many cells ---- */

/* 1/8 to 512 cells a shape: lines from everywhere through the teapot and through small triangles in
 * any place; the stadium as a camera at its small teapot sees it. */
static inline void measure_density(const options *o)
{
    static const char *const name[3] = {"teapot", "triangles", "stadium"};
    const real edge = (real)cbrt(1 / 20000.0) / 2;  /* half as long as 20000 triangles are apart */
    plot time = plot_new("Time against cells", "cells a shape", "time [ns a ray]",
                         PLOT_LOG_X | PLOT_LOG_Y);
    for (int k = 0; k < 3; k++) {
        trial_scene s;
        vec3 lo, hi;
        trial_scene_of(k == 0 ? teapot_mesh(24) : k == 1 ? soup_mesh(20000, 0.5, edge, o->seed)
                                                         : stadium_mesh(16), &s);
        mesh_bounds(&s.m, &lo, &hi);
        s.rays[TRIAL_UNIFORM] = k == 2 ? rays_primary(grid_stadium_camera(), 14, 14)
                                       : rays_uniform((aabb){lo, hi}, 1500, o->seed);
        int series = plot_series(&time, name[k]);
        for (double density = 0.125; density <= 512; density *= 2) {
            grid_options how = GRID_HOW(density, true, true);
            trial_row r = {.verbs = &grid_trial, .how = &how};
            trials_run(&r, 1, &s, 9);
            plot_add(&time, series, density, trial_ns(&r, TRIAL_UNIFORM));
            trial_end(&r, 1);
        }
        trial_scene_free(&s);
    }
    output_plot(o, &time, "10_grid_time.svg");
}

/* ---- how far a walk goes astray ---- */

static inline void measure_drift(const options *o)
{
    table t = table_new("1000 walks past an edge: which miss a cell, and how far off the next "
                        "wall is", "cells passed|error added [% of walks]|error added [cells]|"
                        "error counted [% of walks]|error counted [cells]|margin [cells]");
    for (size_t n = 10; n <= 100000; n *= 10) {
        drift added = drift_after(walk_step_naive, n, 1000, o->seed);
        drift counted = drift_after(walk_step, n, 1000, o->seed);
        table_count(&t, n);
        table_number(&t, 100 * added.missed), table_number(&t, added.error);
        table_number(&t, 100 * counted.missed), table_number(&t, counted.error);
        table_number(&t, drift_margin(n));
    }
    output_extra_table(o, &t);
}

#endif
