/* measure.h: the strategies measured.
 *
 *   table_of_strategies(o, &s)    time, memory, work, wrong hits; the main table
 *   table_of_overlap(o, &s)       the formulas of stats.h, and counting
 *   table_of_paying(o, &s)        build + k rays, for k from 1e4 to 1e7; the Pareto front (帕累托前沿):
 *                                 those for which no other is built faster and searched faster
 *   table_of_slivers(o)           where triangles fill little of their boxes: cuts through them
 *   plot_of_pareto(o, &s)         each strategy a curve, leaf sizes 16, 8, 4, 2 its points
 *   bvh_grow(o)                   against the number of triangles, up to a million
 */
#ifndef BVH_MEASURE_H
#define BVH_MEASURE_H

#include "../../09_aabb/trials/growth.h"
#include "candidates.h"
#include "slivers.h"

/* ---------------------------------------------------------------------------------------------- */

static inline void table_of_strategies(const options *o, const trial_scene *s)
{
    int n = o->full ? bvh_candidates : bvh_short;
    char title[160];
    trial_row row[bvh_candidates];
    bvh_rows(bvh_candidate_list, n, row);
    trials_run(row, n, s, o->quick ? 1 : o->full ? 5 : 3);
    table t = trial_table(trial_title(s, title), row, n, s, o->full, NULL);
    output_table(o, &t);
    trial_end(row, n);
}

/* Seven curves, of leaves that are best for each. */
enum { bvh_paying = 7 };
static const bvh_candidate bvh_paying_list[bvh_paying] = {
    {"Morton", &bvh_trial, {"morton", 8, 0.3, SIZE_MAX}, false},
    {"cycling axis", &bvh_trial, {"cycle", 4, 1, SIZE_MAX}, false},
    {"longest axis", &bvh_trial, {"longest", 4, 1, SIZE_MAX}, false},
    {"median", &bvh_trial, {"median", 4, 1, SIZE_MAX}, false},
    {"SAH, bins", &bvh_trial, {"sah", 8, 0.3, SIZE_MAX}, false},
    {"SAH, sweep", &bvh_trial, {"sweep", 8, 0.3, SIZE_MAX}, false},
    {"SAH, spatial", &bvh_trial, {"spatial", 8, 0.3, SIZE_MAX}, false}};

/* The same trees, by the formulas and by counting lines as the heuristic assumes them. */
static inline void table_of_overlap(const options *o, const trial_scene *s)
{
    table out = table_new(
        "Overlap: random lines through the box of the mesh",
        "structure|nodes (14.7)|nodes, lines|tests (14.7)|tests, lines|in both (14.8)");
    for (int i = 1; i < bvh_paying - 1; i++) {
        bvh b;
        search_work w = {0, 0, 0, 0};
        failure f;
        if (!bvh_build(&s->x, bvh_paying_list[i].how, &b, &f)) fail(f);
        tree_cost st = tree_cost_of(bvh_tree_of(&b));
        const float *c = bvh_tree_of(&b)->node[0].box.side;
        aabb box = {{(real)c[0], (real)c[1], (real)c[2]}, {(real)c[3], (real)c[4], (real)c[5]}};
        ray_set lines = rays_uniform(box, 50000, o->seed);
        for (size_t k = 0; k < lines.n; k++) tree_pierced(bvh_tree_of(&b), lines.r[k], &w);
        table_text(&out, "%s", bvh_paying_list[i].name);
        table_number(&out, st.nodes), table_number(&out, trial_per((double)w.nodes, lines.n));
        table_number(&out, st.tests), table_number(&out, trial_per((double)w.tests, lines.n));
        table_number(&out, st.overlap);
        rays_free(&lines);
        bvh_free(&b);
    }
    output_extra_table(o, &out);
}

static inline void table_of_paying(const options *o, const trial_scene *s)
{
    enum { n = bvh_paying };
    trial_row row[n];
    double build[n], search[n];
    table out = table_new("Build and k diffuse rays together, one thread; "
                          "front: none is faster in both",
                          "structure|build [ms]|ray [ns]|front|1e4 rays [ms]|1e5 rays [ms]|"
                          "1e6 rays [ms]|1e7 rays [ms]");
    bvh_rows(bvh_paying_list, n, row);
    trials_run(row, n, s, 5);
    for (int i = 0; i < n; i++)
        build[i] = row[i].build, search[i] = trial_ns(&row[i], TRIAL_DIFFUSE) * 1e-9;
    for (int i = 0; i < n; i++) {
        bool front = true;
        for (int j = 0; j < n; j++) front &= !(build[j] < build[i] && search[j] < search[i]);
        table_text(&out, "%s", row[i].name);
        table_number(&out, build[i] * 1e3), table_number(&out, search[i] * 1e9);
        table_text(&out, front ? "yes" : "-");
        for (double k = 1e4; k < 2e7; k *= 10) table_number(&out, (build[i] + k * search[i]) * 1e3);
    }
    output_extra_table(o, &out);
    trial_end(row, n);
}

static inline void table_of_slivers(const options *o)
{
    trial_row row[bvh_paying];
    trial_scene s;
    table out = table_new(
        "4000 slivers round an axis at an odd angle: primary rays",
        "structure|build [ms]|references|nodes/ray|tests/ray|ray [ns]|nodes (14.7)|tests (14.7)");
    trial_scene_of(slivers_mesh(4000, (vec3){0, 0, 0}), &s);
    s.rays[TRIAL_PRIMARY] = rays_primary(trial_camera(&s.m, 1.6), 80, 50);
    bvh_rows(bvh_paying_list, bvh_paying, row);
    trials_run(row, bvh_paying, &s, 5);
    for (int i = 0; i < bvh_paying; i++) {
        const bvh_tree *t = bvh_tree_of(row[i].built);
        tree_cost st = tree_cost_of(t);
        search_work w = row[i].ray[TRIAL_PRIMARY].work;
        size_t rays = row[i].ray[TRIAL_PRIMARY].n;
        table_text(&out, "%s", row[i].name), table_number(&out, row[i].build * 1e3);
        table_number(&out, trial_per((double)t->items, s.m.triangles));
        table_number(&out, trial_per((double)w.nodes, rays));
        table_number(&out, trial_per((double)w.tests, rays));
        table_number(&out, trial_ns(&row[i], TRIAL_PRIMARY));
        table_number(&out, st.nodes), table_number(&out, st.tests);
    }
    output_extra_table(o, &out);
    trial_end(row, bvh_paying), trial_scene_free(&s);
}

static inline void plot_of_pareto(const options *o, const trial_scene *s)
{
    plot p = plot_new("Leaves of 16, 8, 4, 2", "build [ns a triangle]", "diffuse ray [ns]",
                      PLOT_LOG_X);
    for (int k = 0; k < bvh_paying; k++) {
        int series = plot_series(&p, bvh_paying_list[k].name);
        for (int leaf = 16; leaf > 1; leaf /= 2) {
            bvh_options how = {bvh_paying_list[k].how.rule, leaf, 0.8 / leaf, SIZE_MAX};
            trial_row r = {.name = "", .verbs = &bvh_trial, .how = &how};
            trial_time_build(&r, s, 1);
            trial_search(&r, 1, s, TRIAL_DIFFUSE, 3);
            plot_add(&p, series, trial_per(r.build * 1e9, s->m.triangles),
                     trial_ns(&r, TRIAL_DIFFUSE));
            trial_end(&r, 1);
        }
    }
    output_plot(o, &p, "14_bvh_pareto_time.svg");
}

static inline void bvh_grow(const options *o)
{
    static const int fine[] = {1, 2, 4, 8, 16, 32, 64, 125};
    static const bvh_options how = {"sah", 8, 0.3, SIZE_MAX};
    const trial_growth g = {.title = "Growth with n, SAH, bins, leaves of 8; one thread",
                            .plots = {"14_bvh_n_time.svg", "14_bvh_n.svg"}, .name = "BVH",
                            .work = {"pairs of boxes", NULL, "triangles"}, .verbs = &bvh_trial,
                            .how = &how, .fine = fine, .sizes = 8, .width = 200, .brute = 64};
    trial_grow(o, &g);
}

#endif
