/* measure.h: the strategies and the searches measured (09_aabb/trials/bench.h).
 *
 *   table_of_strategies(o, &s)    the page's table; --full: all columns and all rows as well
 *   table_of_planes(o)            squares in dyadic planes, where textbook searches lose hits
 */
#ifndef KDTREE_MEASURE_H
#define KDTREE_MEASURE_H

#include "../../../common/lab/report.h"
#include "../../07_mesh/scenes/specimens.h"
#include "../../07_mesh/scenes/teapot.h"
#include "../../09_aabb/trials/bench.h"
#include "../first.h"
#include "textbook.h"

TRIAL_VERBS(kdtree, kdtree, kdtree_hit, kdtree_hit_counted)
TRIAL_OTHER(kdtree_textbook, kdtree, kdtree, kdtree_hit_textbook)
TRIAL_OTHER(kdtree_final, kdtree, kdtree, kdtree_hit_naive_final)
TRIAL_OTHER(kdtree_strict, kdtree, kdtree, kdtree_hit_naive_strict)
TRIAL_FIRST(first_kdtree, first_kdtree_build(&b->m, &b->s))

TRIAL_OTHER(kdtree_no_delta, kdtree, kdtree, kdtree_hit_no_delta)

#define KDTREE_HOW(strategy, leaf, bonus, clip, planar)                                          \
    (&(const kdtree_options){strategy, leaf, 0, kdtree_item_cost, bonus, clip, planar,           \
                             SIZE_MAX / 4})

/* The first seven are the page's table, 1 to 4 the picture. */
enum { kdtree_short = 7, kdtree_candidates = 16 };
static const trial_row kdtree_row_list[kdtree_candidates] = {
    {.name = "first", &first_kdtree_trial, KDTREE_HOW(KD_MIDDLE, 8, 0, false, KD_BOTH)},
    {.name = "middle, 16", &kdtree_trial, KDTREE_HOW(KD_MIDDLE, 16, 0, true, KD_THICK)},
    {.name = "median, 16", &kdtree_trial, KDTREE_HOW(KD_MEDIAN, 16, 0, true, KD_THICK)},
    {.name = "SAH, 16", &kdtree_trial, KDTREE_HOW(KD_SAH, 16, 0.1, true, KD_THICK)},
    {.name = "SAH, by cost", &kdtree_trial, KDTREE_HOW(KD_SAH, 0, 0.1, true, KD_THICK)},
    {.name = "no delta", &kdtree_no_delta_trial, .again = true},
    {.name = "textbook search", &kdtree_textbook_trial, KDTREE_HOW(KD_SAH, 0, 0.1, true, KD_BOTH)},
    {.name = "first hit final", &kdtree_final_trial, .again = true},
    {.name = "strict", &kdtree_strict_trial, .again = true},
    {.name = "strict, one side", &kdtree_strict_trial, KDTREE_HOW(KD_SAH, 0, 0.1, true, KD_ONE)},
    {.name = "middle, 4", &kdtree_trial, KDTREE_HOW(KD_MIDDLE, 4, 0, true, KD_THICK)},
    {.name = "median, 4", &kdtree_trial, KDTREE_HOW(KD_MEDIAN, 4, 0, true, KD_THICK)},
    {.name = "SAH, 4", &kdtree_trial, KDTREE_HOW(KD_SAH, 4, 0.1, true, KD_THICK)},
    {.name = "by cost, boxes", &kdtree_trial, KDTREE_HOW(KD_SAH, 0, 0.1, false, KD_THICK)},
    {.name = "by cost, no bonus", &kdtree_trial, KDTREE_HOW(KD_SAH, 0, 0, true, KD_THICK)},
    {.name = "20 : 15, bonus 0.2", &kdtree_trial,
     &(const kdtree_options){KD_SAH, 0, 0, 4.0 / 3, 0.2, true, KD_THICK, SIZE_MAX / 4}}};

/* ---------------------------------------------------------------------------------------------- */

static inline void kdtree_cells(table *t, const trial_row *r)
{
    table_number(t, 100 * trial_per((double)r->stats.empty, r->stats.leaves));
}

static inline void table_of_strategies(const options *o, const trial_scene *s)
{
    static const trial_columns own = {"|empty leaves [%]", kdtree_cells};
    int n = o->full ? kdtree_candidates : kdtree_short;
    char title[160], brief[200];
    trial_row row[kdtree_candidates];
    memcpy(row, kdtree_row_list, sizeof row);
    trials_run(row, n, s, o->quick ? 1 : o->full ? 9 : 3);
    snprintf(brief, sizeof brief, "Where to cut: %s", trial_title(s, title));
    table t = trial_table(brief, row, kdtree_short, s, false, NULL);
    output_table(o, &t);
    if (o->full) {
        t = trial_table(trial_title(s, title), row, n, s, true, &own);
        output_extra_table(o, &t);
    }
    trial_end(row, n);
}

/* ---- where textbook searches lose hits ---- */

/* Rays on which nothing is rounded, or rays from anywhere at corners of floors_mesh(4). */
static inline ray_set rays_at_planes(size_t n, bool dyadic, uint64_t seed)
{
    ray_set s = {allocate(n, sizeof(ray)), n};
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(seed, i, 4);
        uint64_t k = random_next_bits(&g) % 125;
        vec3 at = {(real)(k % 5) / 2 - 1, (real)(k / 5 % 5) / 2 - 1, (real)(k / 25) / 2 - 1};
        vec3 o = {4 * random_next(&g) - 2, 4 * random_next(&g) - 2, 4 * random_next(&g) - 2};
        s.r[i] = dyadic ? kd_dyadic_ray(&g) : ray_from(o, vsub(at, o));
    }
    return s;
}

static inline void table_of_planes(const options *o)
{
    static const trial_verbs *const verbs[4] = {&kdtree_final_trial, &kdtree_strict_trial,
                                                &kdtree_textbook_trial, &kdtree_trial};
    static const char *const name[4] = {"first hit final", "strict", "textbook", "padded"};
    const size_t n = 20000;
    char title[100];
    snprintf(title, sizeof title, "Squares in dyadic planes, cut in the middle: wrong of %zu rays",
             n);
    table out = table_new(title, "search|dyadic rays, both sides|dyadic rays, one side|"
                                 "rays at corners, both sides|rays at corners, one side");
    size_t wrong[4][4];
    for (int k = 0; k < 4; k++) {
        trial_scene s;
        const kdtree_options *how = KDTREE_HOW(KD_MIDDLE, 1, 0, true, k % 2 ? KD_ONE : KD_BOTH);
        trial_scene_of(floors_mesh(4), &s);
        s.rays[TRIAL_CORNERS] = rays_at_planes(n, k < 2, o->seed);
        trial_due(&s, false);
        for (int i = 0; i < 4; i++) {
            trial_row r = {.verbs = verbs[i], .how = how};
            trials_run(&r, 1, &s, 1);
            wrong[i][k] = r.wrong;
            trial_end(&r, 1);
        }
        trial_scene_free(&s);
    }
    for (int i = 0; i < 4; i++) {
        table_text(&out, "%s", name[i]);
        for (int k = 0; k < 4; k++) table_count(&out, wrong[i][k]);
    }
    output_extra_table(o, &out);
}

#endif
