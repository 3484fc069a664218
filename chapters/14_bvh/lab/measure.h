/* measure.h: the rules by which a set is cut, and the ways to search, measured (09_aabb/trials).
 *
 *   table_of_rules(o, &s)         time, memory, work, wrong hits: the main table. A rule of
 *                                 bvh_rules is a row of it, and of most of the others
 *   table_of_orders(o, &s)        the nearer child first, or always the first; the closest, or any
 *   plot_of_pareto(o, &s)         each rule a curve, leaf sizes 16, 8, 4, 2 its points
 *   draw_rules(o, &s)             what each pixel took, by four of the rules
 */
#ifndef BVH_MEASURE_H
#define BVH_MEASURE_H

#include "../../../common/lab/label.h"
#include "../../../common/lab/report.h"
#include "../../07_mesh/scenes/teapot.h"
#include "../../09_aabb/trials/bench.h"
#include "../../09_aabb/trials/pictures.h"
#include "../bvh.h"
#include "../first.h"
#include "naive.h"

/* ---------------------------------------------------------------------------------------------- */

/* Searches in another order, or of another kind: of the triangles alone. */
#define BVH_ORDER(name, any, nearest)                                                            \
    static bool name##_counted(const bvh *b, ray r, hit *out, search_work *w)                    \
    {                                                                                            \
        return tree_search_by(&b->mesh.tree, r, box_ray_of, bvh_mesh_leaf, &b->mesh, any,        \
                              nearest, out, w);                                                  \
    }                                                                                            \
    static bool name(const bvh *b, ray r, hit *out) { return name##_counted(b, r, out, NULL); }  \
    TRIAL_VERBS(name, bvh, name, name##_counted)

TRIAL_VERBS(bvh, bvh, bvh_hit, bvh_hit_counted)
TRIAL_OTHER(bvh_naive, bvh, bvh, bvh_hit_naive)
TRIAL_FIRST(first_bvh, b->s = first_bvh_build(&b->m, *(const bool *)how))
BVH_ORDER(bvh_as_stored, false, false)
BVH_ORDER(bvh_any_ordered, true, true)
BVH_ORDER(bvh_any_as_stored, true, false)

/* All rules with the same leaves and the same price of a test. */
enum { bvh_rows_most = bvh_rule_count + 6 };
static bvh_options bvh_rule_how[bvh_rule_count];

/* Those of the page (it has no room for more than eight rows), or the others. */
static inline int rows_of_rules(trial_row *row, bool of_page)
{
    int n = 0;
    for (int k = 0; k < bvh_rule_count; k++) {
        if (of_page != (bvh_rules[k].split && !bvh_rules[k].sorts)) continue;
        bvh_rule_how[k] = bvh_defaults;
        bvh_rule_how[k].rule = bvh_rules[k].name;
        row[n++] = (trial_row){.name = bvh_rules[k].name, .verbs = &bvh_trial,
                               .how = &bvh_rule_how[k]};
    }
    return n;
}

static inline void table_of_rules(const options *o, const trial_scene *s)
{
    static const bool yes = true, no = false;
    static const char *const named[4] = {"sah, boxes naive", "sah, leaf 1", "sah, leaf 4",
                                         "sah, leaf 16"};
    bvh_options how[4] = {bvh_defaults, bvh_leaves(1, 0.3), bvh_leaves(4, 0.3),
                          bvh_leaves(16, 0.3)};
    char title[160];
    trial_row row[bvh_rows_most];
    row[0] = (trial_row){.name = "first, SAH", .verbs = &first_bvh_trial, .how = &yes};
    int n = 1 + rows_of_rules(row + 1, true);
    row[n++] = (trial_row){.name = named[0], .verbs = &bvh_naive_trial, .how = &how[0]};
    int of_page = n;
    if (o->full) {
        n += rows_of_rules(row + n, false);
        for (int k = 1; k < 4; k++)
            row[n++] = (trial_row){.name = named[k], .verbs = &bvh_trial, .how = &how[k]};
        row[n++] = (trial_row){.name = "first, middle", .verbs = &first_bvh_trial, .how = &no};
    }
    trials_run(row, n, s, o->quick ? 1 : o->full ? 5 : 3);
    table t = trial_table(trial_title(s, title), row, of_page, s, false, NULL);
    output_table(o, &t);
    if (o->full) {
        t = trial_table(title, row, n, s, true, NULL);
        output_extra_table(o, &t);
    }
    trial_end(row, n);
}

/* One tree, four searches. Any-hit: of each ray whether, not where. */
static inline void table_of_orders(const options *o, const trial_scene *s)
{
    static const struct { const char *name; const trial_verbs *verbs; } list[4] = {
        {"closest, nearer child first", &bvh_trial},
        {"closest, first child first", &bvh_as_stored_trial},
        {"any, nearer child first", &bvh_any_ordered_trial},
        {"any, first child first", &bvh_any_as_stored_trial}};
    const bvh_options how = bvh_defaults;
    trial_row row[4];
    table out = table_new("Order: one tree of the rule sah, searched in four ways",
                          "search|nodes/ray, primary|tests/ray, primary|time primary [ns]|"
                          "nodes/ray, diffuse|tests/ray, diffuse|time diffuse [ns]");
    for (int i = 0; i < 4; i++)
        row[i] = (trial_row){.name = list[i].name, .verbs = list[i].verbs, .how = &how,
                             .again = i > 0};
    trials_run(row, 4, s, 5);
    for (int i = 0; i < 4; i++) {
        table_text(&out, "%s", row[i].name);
        for (trial_rays_kind k = TRIAL_PRIMARY; k <= TRIAL_DIFFUSE; k++) {
            table_number(&out, trial_per((double)row[i].ray[k].work.nodes, row[i].ray[k].n));
            table_number(&out, trial_per((double)row[i].ray[k].work.tests, row[i].ray[k].n));
            table_number(&out, trial_ns(&row[i], k));
        }
    }
    output_extra_table(o, &out);
    trial_end(row, 4);
}

cold_inline void plot_of_pareto(const options *o, const trial_scene *s)
{
    plot p = plot_new("Each rule with leaves of 16, 8, 4, 2", "build [ns a triangle]",
                      "diffuse ray [ns]", PLOT_LOG_X);
    for (int k = 0; k < bvh_rule_count; k++) {
        int series = plot_series(&p, bvh_rules[k].name);
        for (int leaf = 16; leaf > 1; leaf /= 2) {
            bvh_options how = {bvh_rules[k].name, leaf, 0.3, SIZE_MAX};
            trial_row r = {.name = "", .verbs = &bvh_trial, .how = &how};
            trial_time_build(&r, s, 5);
            trial_search(&r, 1, s, TRIAL_DIFFUSE, 9);
            plot_add(&p, series, trial_per(r.build * 1e9, s->m.triangles),
                     trial_ns(&r, TRIAL_DIFFUSE));
            trial_end(&r, 1);
        }
    }
    output_plot(o, &p, "14_bvh_pareto_time.svg");
}

cold_inline void draw_rules(const options *o, const trial_scene *s)
{
    enum { most = 160 };
    static const char *const rule[4] = {"cycle", "longest", "median", "sah"};
    bvh_options how[4];
    const void *list[4];
    for (int k = 0; k < 4; k++) how[k] = bvh_defaults, how[k].rule = rule[k], list[k] = &how[k];
    image im = image_new(o->width, o->height);
    trial_picture p = {.verbs = &bvh_trial, .most = most};
    bool whole = trial_draw_work(s, p, true, 2, list, 4, o->threads, &im);
    trial_label_work(&im, 2, 2, rule, most, "pairs of boxes and triangles a ray");
    output_picture(o, &im, "14_bvh_visits.png", false, whole);
    image_free(&im);
}

#endif
