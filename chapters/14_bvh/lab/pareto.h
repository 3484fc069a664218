/* pareto.h: what a better tree costs to build, and when it has paid for itself.
 *
 *   table_of_paying(o, s)     build + k rays, for k from 1e4 to 1e7; the Pareto front (帕累托前沿):
 *                             those for which no other is built faster and searched faster
 *   table_of_slivers(o)       where triangles fill little of their boxes: cuts through them
 *   plot_of_pareto(o, s)      each strategy a curve, leaf sizes 16, 8, 4, 2 its points
 */
#ifndef BVH_PARETO_H
#define BVH_PARETO_H

#include "measure.h"
#include "slivers.h"

enum { pareto_candidates = 7 };
static const candidate pareto_list[pareto_candidates] = {
    {"Morton", {BVH_MORTON, 8, 0.3}, false}, {"cycling axis", {BVH_CYCLE, 4, 1}, false},
    {"longest axis", {BVH_LONGEST, 4, 1}, false}, {"median", {BVH_MEDIAN, 4, 1}, false},
    {"SAH, bins", {BVH_SAH, 8, 0.3}, false}, {"SAH, sweep", {BVH_SAH_SWEEP, 8, 0.3}, false},
    {"SAH, spatial", {BVH_SPATIAL, 8, 0.3}, false}};

/* ---------------------------------------------------------------------------------------------- */

/* Median seconds of a build, and of one ray of `rays`. */
static inline void pareto_times(const options *o, const subject *s, const ray_set *rays, trial *t,
                                double *build, double *search)
{
    for (int i = 0; i < pareto_candidates; i++)
        t[i] = (trial){s, &pareto_list[i], rays, {{0}, NULL}};
    time_trials(t, pareto_candidates, run_build, o->quick ? 1 : 2, build);
    time_trials(t, pareto_candidates, run_search, o->quick ? 1 : 3, search);
    for (int i = 0; i < pareto_candidates; i++) search[i] /= (double)(rays->n ? rays->n : 1);
}

static inline void table_of_paying(const options *o, const subject *s)
{
    trial t[pareto_candidates];
    double build[pareto_candidates], search[pareto_candidates];
    table out = table_new(
        "Build and k diffuse rays together, one thread; front: none is faster in both",
        "structure|build [ms]|ray [ns]|front|1e4 rays [ms]|1e5 rays [ms]|1e6 rays [ms]|"
        "1e7 rays [ms]");
    pareto_times(o, s, &s->diffuse, t, build, search);
    for (int i = 0; i < pareto_candidates; i++) {
        bool front = true;
        for (int j = 0; j < pareto_candidates; j++)
            if (build[j] < build[i] && search[j] < search[i]) front = false;
        table_text(&out, "%s", t[i].c->name);
        table_number(&out, build[i] * 1e3), table_number(&out, search[i] * 1e9);
        table_text(&out, front ? "yes" : "-");
        for (double k = 1e4; k < 2e7; k *= 10) table_number(&out, (build[i] + k * search[i]) * 1e3);
        bvh_free(&t[i].b);
    }
    output_extra_table(o, &out);
}

static inline void table_of_slivers(const options *o)
{
    trial t[pareto_candidates];
    double build[pareto_candidates], search[pareto_candidates];
    subject s = {.m = slivers_mesh(o->quick ? 500 : 4000, (vec3){0, 0, 0})};
    vec3 lo, hi;
    table out = table_new(
        "4000 slivers round an axis at an odd angle: primary rays",
        "structure|build [ms]|references|nodes/ray|tests/ray|ray [ns]|nodes (14.7)|tests (14.7)");
    mesh_bounds(&s.m, &lo, &hi);
    s.v = view_of(lo, hi, true, 1.6);
    s.primary = rays_primary(s.v, o->quick ? 20 : 80, o->quick ? 13 : 50);
    pareto_times(o, &s, &s.primary, t, build, search);
    for (int i = 0; i < pareto_candidates; i++) {
        bvh_stats st = bvh_stats_of(&t[i].b.tree);
        bvh_work w = rays_count(&t[i].b, &s.primary);
        table_text(&out, "%s", t[i].c->name), table_number(&out, build[i] * 1e3);
        table_number(&out, per((double)st.items, s.m.triangles));
        table_number(&out, per((double)w.nodes, s.primary.n));
        table_number(&out, per((double)w.tests, s.primary.n));
        table_number(&out, search[i] * 1e9);
        table_number(&out, st.nodes), table_number(&out, st.tests);
        bvh_free(&t[i].b);
    }
    output_extra_table(o, &out);
    subject_free(&s);
}

static inline void plot_of_pareto(const options *o, const subject *s)
{
    plot p = plot_new("Leaves of 16, 8, 4, 2", "build [ns a triangle]", "diffuse ray [ns]",
                      PLOT_LOG_X);
    for (int k = 0; k < pareto_candidates; k++) {
        int series = plot_series(&p, pareto_list[k].name);
        for (int leaf = 16; leaf > 1; leaf /= 2) {
            candidate c = {pareto_list[k].name,
                           {pareto_list[k].options.strategy, leaf, 0.8 / leaf}, false};
            trial t = {s, &c, &s->diffuse, {{0}, NULL}};
            double build = time_once(&t, run_build), search;
            time_trials(&t, 1, run_search, 3, &search);
            plot_add(&p, series, per(build * 1e9, s->m.triangles), per(search * 1e9, s->diffuse.n));
            bvh_free(&t.b);
        }
    }
    output_plot(o, &p, "14_bvh_pareto_time.svg");
}

#endif
