/* measure.h: the rules that pick planes, measured (09_aabb/trials/bench.h).
 *
 *   table_of_choices(o)     the main table, and the plot of building against searching
 *   table_of_scenes(o)      planes across the axes and of any direction, scene by scene
 *   table_of_losses(o)      wrong hits of 6000 rays aimed where planes are
 */
#ifndef BSP_MEASURE_H
#define BSP_MEASURE_H

#include "../../../common/lab/report.h"
#include "../../07_mesh/scenes/specimens.h"
#include "../../07_mesh/scenes/teapot.h"
#include "../../09_aabb/trials/bench.h"
#include "../first.h"
#include "naive.h"
#include "puzzles.h"

TRIAL_VERBS(bsp, bsp, bsp_hit, bsp_hit_counted)
TRIAL_OTHER(bsp_naive, bsp, bsp, bsp_hit_naive)
TRIAL_OTHER(bsp_first_leaf, bsp, bsp, bsp_hit_first)
TRIAL_FIRST(first_bsp, first_bsp_build(&b->m, &b->s))

/* cost: of a step, in tests; the defaults have 4 and 4.5. */
#define BSP_COSTING(its_rule, tries, its_sides, axis, slanted)                                   \
    (&(const bsp_options){.rule = (its_rule), .candidates = (tries), .sides = (its_sides),       \
                          .leaf = 4, .depth = bsp_most_depth, .axis_cost = (axis),               \
                          .slanted_cost = (slanted), .seed = 1, .most_bytes = (size_t)1 << 31})
#define BSP_HOW(rule, candidates, sides) BSP_COSTING(rule, candidates, sides, 4, 4.5)
#define BSP_MANY(sides) BSP_COSTING(BSP_COST, 16, sides, 0.5, 0.5)  /* many planes */

/* The first seven are the short table. Blind planes make searches slow. */
enum { bsp_short = 7, bsp_candidates = 12, bsp_slow = 64 };
static const trial_row bsp_row_list[bsp_candidates] = {
    {.name = "first", .verbs = &first_bsp_trial},
    {.name = "random", &bsp_trial, BSP_HOW(BSP_RANDOM, 1, BSP_SIDES_SAFE), .step = bsp_slow},
    {.name = "axis", &bsp_trial, BSP_HOW(BSP_AXIS, 1, BSP_SIDES_SAFE)},
    {.name = "cost, 16", &bsp_trial, BSP_HOW(BSP_COST, 16, BSP_SIDES_SAFE)},
    {.name = "not padded", .verbs = &bsp_naive_trial, .again = true},
    {.name = "first leaf", .verbs = &bsp_first_leaf_trial, .again = true},
    {.name = "sides fixed", &bsp_trial, BSP_HOW(BSP_COST, 16, BSP_SIDES_FIXED)},
    {.name = "fewest of 16", &bsp_trial, BSP_HOW(BSP_FEWEST, 16, BSP_SIDES_SAFE), .step = bsp_slow},
    {.name = "own, 16", &bsp_trial, BSP_HOW(BSP_OWN, 16, BSP_SIDES_SAFE)},
    {.name = "cost, 1", &bsp_trial, BSP_HOW(BSP_COST, 1, BSP_SIDES_SAFE)},
    {.name = "cost, 4", &bsp_trial, BSP_HOW(BSP_COST, 4, BSP_SIDES_SAFE)},
    {.name = "cost, 64", &bsp_trial, BSP_HOW(BSP_COST, 64, BSP_SIDES_SAFE)}};

/* ---------------------------------------------------------------------------------------------- */

static inline void bsp_cells(table *t, const trial_row *r)
{
    table_number(t, 100 * trial_per((double)((bsp *)r->built)->normals, r->stats.inner));
}

/* Of the trees that are well cut. */
static inline void plot_of_rules(const options *o, const trial_row *row)
{
    static const struct { int row, series; } shown[] = {{2, 0}, {9, 2}, {10, 2}, {8, 1}, {3, 2},
                                                        {11, 2}};
    plot p = plot_new("Building against searching", "build [ms]", "a diffuse ray [ns]",
                      PLOT_LOG_X);
    plot_series(&p, "across the axes"), plot_series(&p, "along triangles only");
    plot_series(&p, "both; 1, 4, 16, 64 candidates");
    for (size_t k = 0; k < sizeof shown / sizeof *shown; k++) {
        const trial_row *r = &row[shown[k].row];
        plot_add(&p, shown[k].series, r->build * 1e3, trial_ns(r, TRIAL_DIFFUSE));
    }
    output_plot(o, &p, "13_bsp_time.svg");
}

static inline void table_of_choices(const options *o)
{
    static const trial_columns own = {"|slanted [%]", bsp_cells};
    int n = o->full ? bsp_candidates : bsp_short, width = o->quick ? 40 : o->full ? 160 : 80;
    char title[160], brief[200];
    trial_scene s;
    trial_row row[bsp_candidates];
    memcpy(row, bsp_row_list, sizeof row);
    trial_scene_of(teapot_mesh(o->quick ? 3 : o->full ? 14 : 7), &s);
    trial_rays(&s, trial_camera(&s.m, 1.6), width, width * 5 / 8, o->quick ? 50 : 2000, o->seed,
               &bsp_trial, row[2].how);
    trials_run(row, n, &s, o->quick ? 1 : o->full ? 15 : 3);
    snprintf(brief, sizeof brief, "Which plane: %s", trial_title(&s, title));
    table out = trial_table(brief, row, bsp_short, &s, false, NULL);
    output_table(o, &out);
    if (o->full) {
        out = trial_table(trial_title(&s, title), row, n, &s, true, &own);
        output_extra_table(o, &out);
        plot_of_rules(o, row);
    }
    trial_end(row, n), trial_scene_free(&s);
}

/* ---- scenes ---- */

static inline void table_of_scenes(const options *o)
{
    const struct { const char *name; mesh m; } shown[] = {
        {"teapot", teapot_mesh(16)}, {"torus", torus_mesh(100)}, {"town", town_mesh(30, 0)},
        {"town, turned", town_mesh(30, 0.6)},
        {"soup", soup_mesh(8000, 1, (real)0.025, 78)},  /* 0.05 large */
        {"needles", needle_mesh(2000, (real)0.01, 77)}};
    table out = table_new("Planes across the axes, and of any direction: lines through the box",
                          "scene|triangles|rule|time build [ms]|bytes a shape|slanted [%]|"
                          "references a shape|nodes a ray|tests a ray|error [wrong]|time [ns]|"
                          "time gained [%]");
    for (int k = 0; k < 6; k++) {
        trial_scene s;
        failure f;
        aabb box;
        trial_row row[2] = {bsp_row_list[2], bsp_row_list[3]};
        trial_scene_of(shown[k].m, &s);
        if (!items_all_bounds(&s.x, &box, &f)) fail(f);
        s.rays[TRIAL_UNIFORM] = rays_uniform(box, 4000, o->seed);
        s.rays[TRIAL_CORNERS] = rays_uniform(box, 200, o->seed);
        trial_due(&s, false);
        trials_run(row, 2, &s, 21);
        for (int i = 0; i < 2; i++) {
            structure_stats *st = &row[i].stats;
            search_work w = row[i].ray[TRIAL_UNIFORM].work;
            const double cell[] = {
                row[i].build * 1e3, trial_per((double)st->bytes, st->items),
                100 * trial_per((double)((bsp *)row[i].built)->normals, st->inner),
                trial_per((double)st->references, st->items), trial_per((double)w.nodes, 4000),
                trial_per((double)w.tests, 4000)};
            table_text(&out, "%s", shown[k].name), table_count(&out, s.m.triangles);
            table_text(&out, i ? "cost" : "axis");
            for (size_t c = 0; c < sizeof cell / sizeof *cell; c++) table_number(&out, cell[c]);
            table_count(&out, row[i].wrong), table_number(&out, trial_ns(&row[i], TRIAL_UNIFORM));
            double gain = trial_ns(&row[0], TRIAL_UNIFORM) / trial_ns(&row[1], TRIAL_UNIFORM);
            trial_cell(&out, i > 0, 100 * (gain - 1));
        }
        trial_end(row, 2), trial_scene_free(&s);
    }
    output_extra_table(o, &out);
}

/* ---- what gets lost ---- */

/* At points of the mesh, one third each: at a corner, at an edge, and along an axis at a corner. */
static inline ray_set rays_at(const mesh *m, size_t n, uint64_t seed)
{
    ray_set s = {allocate(n, sizeof(ray)), n};
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(seed, i, 1);
        triangle t = mesh_triangle(m, (size_t)(random_next_bits(&g) % m->triangles));
        vec3 o = {4 * random_next(&g) - 2, 4 * random_next(&g) - 2, 4 * random_next(&g) - 2};
        vec3 axis = {i % 9 < 3, i % 9 >= 3 && i % 9 < 6, i % 9 >= 6};
        vec3 on_edge = vmadd(t.a, vsub(t.b, t.a), random_next(&g)), lo, hi;
        mesh_bounds(m, &lo, &hi);
        o = vmul(o, vsub(hi, lo));
        s.r[i] = i % 3 == 0 ? ray_from(o, vsub(t.a, o)) : i % 3 == 1 ? ray_from(o, vsub(on_edge, o))
               : ray_from(vsub(t.a, vscale(axis, 4 * vlength(vsub(hi, lo)))), axis);
    }
    return s;
}

static inline void table_of_losses(const options *o)
{
    const trial_row list[5] = {
        {.name = "SAFE, padded", &bsp_trial, BSP_MANY(BSP_SIDES_SAFE)},
        {.name = "not padded", .verbs = &bsp_naive_trial, .again = true},
        {.name = "first leaf", .verbs = &bsp_first_leaf_trial, .again = true},
        {.name = "STRICT, e = 0", &bsp_trial, BSP_MANY(BSP_SIDES_STRICT)},
        {.name = "FIXED, e = 1e-4", &bsp_trial, BSP_MANY(BSP_SIDES_FIXED)}};
    table out = table_new("Wrong hits of 6000 rays at corners, edges and along axes",
                          "variant|error town|error torus|error torus of 0.001|error needles");
    mesh m[4] = {town_mesh(8, 0), torus_mesh(24), torus_mesh(24), needle_mesh(500, (real)0.01, 77)};
    for (size_t i = 0; i < m[2].vertices; i++) m[2].v[i] = vscale(m[2].v[i], 0.001);
    size_t wrong[5][4];
    for (int k = 0; k < 4; k++) {
        trial_scene s;
        trial_row row[5];
        memcpy(row, list, sizeof row);
        trial_scene_of(m[k], &s);
        s.rays[TRIAL_CORNERS] = rays_at(&s.m, 6000, o->seed);
        trial_due(&s, false);
        trials_run(row, 5, &s, 1);
        for (int i = 0; i < 5; i++) wrong[i][k] = row[i].wrong;
        trial_end(row, 5), trial_scene_free(&s);
    }
    for (int i = 0; i < 5; i++) {
        table_text(&out, "%s", list[i].name);
        for (int k = 0; k < 4; k++) table_count(&out, wrong[i][k]);
    }
    output_extra_table(o, &out);
}

#endif
