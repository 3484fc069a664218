/* measure.h: what each knob costs: time, memory, work, wrong hits (09_aabb/trials/bench.h).
 *
 *   table_of_knobs(o)         the main table
 *   table_of_stadium(o)       the teapot, and the teapot in a stadium: grid and octree
 *   plot_of_depth(o)          work against depth, on three scenes
 */
#ifndef OCTREE_MEASURE_H
#define OCTREE_MEASURE_H

#include "../../../common/lab/report.h"
#include "../../07_mesh/scenes/soup.h"
#include "../../07_mesh/scenes/stadium.h"
#include "../../09_aabb/trials/bench.h"
#include "../../10_grid/trials/nested.h"
#include "../first.h"
#include "../octree.h"
#include "variants.h"

TRIAL_VERBS(octree, octree, octree_hit, octree_hit_counted)
TRIAL_OTHER(octree_textbook, octree, octree, octree_hit_textbook)
TRIAL_OTHER(octree_unpadded, octree, octree, octree_hit_unpadded)
TRIAL_FIRST(first_octree, first_octree_build(&b->m, &b->s))
TRIAL_VERBS(octree_rival, grid, grid_hit, grid_hit_counted)
TRIAL_VERBS(octree_rival_2, nested, nested_hit, nested_hit_counted)

#define OCTREE_HOW(leaf, depth, mailbox, exact)                                                  \
    (&(const octree_options){leaf, depth, mailbox, exact, (size_t)1 << 30})

static const octree_options octree_usual = {16, 16, true, true, (size_t)1 << 30};

/* The first six are the short table. */
enum { octree_short = 6, octree_rows = 11 };
static const trial_row octree_row_list[octree_rows] = {
    {.name = "first-octree", .verbs = &first_octree_trial},
    {.name = "octree", .verbs = &octree_trial, .how = &octree_usual},
    {.name = "textbook", .verbs = &octree_textbook_trial, .again = true},
    {.name = "no delta", .verbs = &octree_unpadded_trial, .again = true},
    {.name = "by boxes", .verbs = &octree_trial, .how = OCTREE_HOW(16, 16, true, false)},
    {.name = "depth 4", .verbs = &octree_trial, .how = OCTREE_HOW(16, 4, true, true)},
    {.name = "no mailbox", .verbs = &octree_trial, .how = OCTREE_HOW(16, 16, false, true)},
    {.name = "leaf 1", .verbs = &octree_trial, .how = OCTREE_HOW(1, 16, true, true)},
    {.name = "leaf 4", .verbs = &octree_trial, .how = OCTREE_HOW(4, 16, true, true)},
    {.name = "leaf 32", .verbs = &octree_trial, .how = OCTREE_HOW(32, 16, true, true)},
    {.name = "leaf 64", .verbs = &octree_trial, .how = OCTREE_HOW(64, 16, true, true)}};

/* ---------------------------------------------------------------------------------------------- */

/* Half at corners from the eye, half along the axes through corners. */
static inline ray_set octree_hard_rays(const mesh *m, vec3 eye, real far, size_t n, uint64_t seed)
{
    ray_set s = rays_corners(m, eye, n, seed);
    for (size_t i = 0; i < n; i += 2) {
        vec3 at = ray_at(s.r[i], 1), axis = {0, 0, 0};
        ((real *)&axis)[i / 2 % 3] = i / 6 % 2 ? 1 : -1;
        s.r[i] = ray_from(vmadd(at, axis, -far), axis);
    }
    return s;
}

static inline void table_of_knobs(const options *o)
{
    int n = o->full ? octree_rows : octree_short, width = o->quick ? 40 : o->full ? 160 : 60;
    char title[200], rays[160];
    vec3 lo, hi;
    trial_scene s;
    trial_row row[octree_rows];
    memcpy(row, octree_row_list, sizeof row);
    trial_scene_of(teapot_mesh(o->quick ? 6 : o->full ? 40 : 8), &s);
    mesh_bounds(&s.m, &lo, &hi);
    camera c = trial_camera(&s.m, 1.6);
    trial_rays(&s, c, width, width * 5 / 8, 0, o->seed, &octree_trial, row[1].how);
    rays_free(&s.rays[TRIAL_CORNERS]);
    s.rays[TRIAL_CORNERS] = octree_hard_rays(&s.m, c.e, 2 * vlength(vsub(hi, lo)),
                                             o->full ? 1000 : 100, o->seed);
    trial_due(&s, true);
    trials_run(row, n, &s, o->quick ? 1 : o->full ? 9 : 3);
    snprintf(title, sizeof title, "%s and along axes", trial_title(&s, rays));
    table out = trial_table(title, row, octree_short, &s, false, NULL);
    output_table(o, &out);
    if (o->full) {
        out = trial_table("The same rays, all variants and all columns", row, n, &s, true, NULL);
        output_extra_table(o, &out);
    }
    trial_end(row, n), trial_scene_free(&s);
}

/* ---- where triangles are not alike ---- */

/* Diffuse rays from the teapot, as a camera before it sees it. */
static inline void octree_pot_rays(trial_scene *s, bool in_stadium, int width, uint64_t seed)
{
    mesh pot = teapot_mesh(1);
    trial_rays(s, trial_camera(in_stadium ? &pot : &s->m, 1.6), width, width * 5 / 8, 0, seed,
               &octree_trial, &octree_defaults);
    rays_free(&s->rays[TRIAL_PRIMARY]);
    mesh_free(&pot);
}

/* The same rays, with and without a stadium of 4032 triangles round it. */
static inline void table_of_stadium(const options *o)
{
    enum { rivals = 5 };
    static const grid_options cells_2 = {2, true, true, (size_t)1 << 30};
    static const grid_options cells_27 = {27, true, true, (size_t)1 << 30};
    static const grid_options cells_512 = {512, true, true, (size_t)1 << 30};
    static const nested_options two_levels = {0.1, 4, true, true, (size_t)1 << 30};
    static const trial_row list[rivals] = {
        {.name = "grid, 2 n", .verbs = &octree_rival_trial, .how = &cells_2},
        {.name = "grid, 27 n", .verbs = &octree_rival_trial, .how = &cells_27},
        {.name = "grid, 512 n", .verbs = &octree_rival_trial, .how = &cells_512},
        {.name = "grid, two levels", .verbs = &octree_rival_2_trial, .how = &two_levels},
        {.name = "octree", .verbs = &octree_trial, .how = &octree_usual}};
    table out = table_new("The teapot and the teapot in a stadium: diffuse rays from the teapot",
                          "scene|structure|build [ms]|bytes a shape|references a shape|"
                          "cells or nodes a ray|tests a ray|time [ns a ray]");
    for (int k = 0; k < 2; k++) {
        trial_scene s;
        trial_row row[rivals];
        trial_scene_of(k ? stadium_mesh(24) : teapot_mesh(24), &s);
        octree_pot_rays(&s, true, 80, o->seed);
        memcpy(row, list, sizeof row);
        trials_run(row, rivals, &s, 3);
        for (int i = 0; i < rivals; i++) {
            structure_stats *st = &row[i].stats;
            search_work w = row[i].ray[TRIAL_DIFFUSE].work;
            size_t rays = row[i].ray[TRIAL_DIFFUSE].n;
            table_text(&out, k ? "stadium" : "teapot"), table_text(&out, "%s", row[i].name);
            table_number(&out, row[i].build * 1e3);
            table_number(&out, trial_per((double)st->bytes, st->items));
            table_number(&out, trial_per((double)st->references, st->items));
            table_number(&out, trial_per((double)w.nodes, rays));
            table_number(&out, trial_per((double)w.tests, rays));
            table_number(&out, trial_ns(&row[i], TRIAL_DIFFUSE));
        }
        trial_end(row, rivals), trial_scene_free(&s);
    }
    output_extra_table(o, &out);
}

cold_inline void plot_of_depth(const options *o)
{
    static const char *const name[3] = {"teapot", "teapot in a stadium", "soup"};
    plot work = plot_new("Work a ray against depth, leaves of 8", "depth", "nodes and tests a ray",
                         PLOT_LOG_Y);
    for (int k = 0; k < 3; k++) {
        trial_scene s;
        trial_scene_of(k == 0 ? teapot_mesh(16) : k == 1 ? stadium_mesh(16)
                                                        : soup_mesh(64 * 16 * 16, 1, 0.05, 3), &s);
        octree_pot_rays(&s, k == 1, 72, o->seed);
        int series = plot_series(&work, name[k]);
        for (int depth = 1; depth <= 16; depth++) {
            trial_row r = {.name = name[k], .verbs = &octree_trial,
                           .how = OCTREE_HOW(8, depth, true, true)};
            trials_run(&r, 1, &s, 1);
            search_work w = r.ray[TRIAL_DIFFUSE].work;
            plot_add(&work, series, depth,
                     trial_per((double)(w.nodes + w.tests), r.ray[TRIAL_DIFFUSE].n));
            trial_end(&r, 1);
        }
        trial_scene_free(&s);
    }
    output_plot(o, &work, "11_octree_depth.svg");
}

#endif
