/* duel.h: the k-d tree against the BVH on the very scenes and rays with which chapters 12 and 14
 * measure them, in turn in one program: their tables stand in two programs, and of two scenes.
 *
 *   duel_run(&o, report)       a table. Counts a ray are, digit for digit, those of 12's row "SAH,
 *                              by cost" and of 14's row "sah"
 */
#ifndef COMPARE_LAB_DUEL_H
#define COMPARE_LAB_DUEL_H

#include "../../09_aabb/trials/bench.h"
#include "costs.h"

TRIAL_VERBS(duel_kdtree, kdtree, kdtree_hit, kdtree_hit_counted)
TRIAL_VERBS(duel_bvh, bvh, bvh_hit, bvh_hit_counted)

/* ---------------------------------------------------------------------------------------------- */

enum { duel_rounds = 9, duel_kinds = TRIAL_DIFFUSE + 1 };

/* Nanoseconds a ray, medians of rounds in turn: of this thread on a processor, as all in 17. */
static inline void duel_times(const trial_row row[2], const trial_scene *s,
                              double ns[2][duel_kinds])
{
    double all[2][duel_kinds][duel_rounds];
    size_t hits = 0;
    for (int i = -1; i < duel_rounds; i++)
        for (int k = 0; k < 2 * duel_kinds; k++) {
            const ray_set *rays = &s->rays[k / 2];
            double start = work_seconds();
            hits += row[k % 2].verbs->search(row[k % 2].built, rays, 1);
            double end = work_seconds();
            if (i >= 0) all[k % 2][k / 2][i] = per((end - start) * 1e9, rays->n);
        }
    for (int k = 0; k < 2 * duel_kinds; k++)
        ns[k % 2][k / 2] = clock_median(all[k % 2][k / 2], duel_rounds);
    clock_kept = (double)hits;
}

static inline void duel_rows(table *t, const char *name, int fine, int width, const options *o)
{
    trial_scene s;
    double ns[2][duel_kinds];
    const kdtree_options planes = kdtree_defaults;
    const bvh_options boxes = bvh_defaults;
    trial_row row[2] = {{.name = "kdtree", .verbs = &duel_kdtree_trial, .how = &planes},
                        {.name = "bvh", .verbs = &duel_bvh_trial, .how = &boxes}};
    trial_scene_of(teapot_mesh(fine), &s);
    trial_rays(&s, trial_camera(&s.m, 1.6), width, width * 5 / 8, o->quick ? 50 : 1000, o->seed,
               row[1].verbs, row[1].how);
    trials_run(row, 2, &s, 1);
    duel_times(row, &s, ns);
    for (int k = 0; k < 2; k++) {
        size_t rays;
        search_work w = trial_sum(&row[k], &rays);
        table_text(t, "%s", name), table_count(t, s.m.triangles), table_text(t, "%s", row[k].name);
        table_number(t, trial_per((double)w.nodes, rays));
        table_number(t, trial_per((double)w.tests, rays)), table_count(t, row[k].wrong);
        for (int i = 0; i < duel_kinds; i++) table_number(t, ns[k][i]);
        for (int i = 0; i < duel_kinds; i++) table_number(t, ns[k][i] / ns[1][i]);
    }
    trial_end(row, 2);
    trial_scene_free(&s);
}

static inline void duel_run(const options *o, html_report *to)
{
    table t = table_new("The k-d tree against the BVH, as 12 and 14 measure them",
                        "scene|triangles|structure|nodes/ray|tests/ray|wrong|primary [ns]|"
                        "diffuse [ns]|ratio primary|ratio diffuse");
    duel_rows(&t, "of 12", o->quick ? 4 : 32, o->quick ? 40 : 160, o);
    duel_rows(&t, "of 14", o->quick ? 5 : 40, o->quick ? 40 : 240, o);
    html_table(to, &t);
    output_extra_table(o, &t);
}

#endif
