/* measure.h: the strategies and the searches measured (09_aabb/trials/bench.h).
 *
 *   table_of_strategies(o, &s)    the page's table; --full: all columns and all rows as well
 *   table_of_planes(o)            squares in dyadic planes, where textbook searches lose hits
 *   table_of_sizes(o)             time, work and memory against the number of triangles: a table, a
 *                                 plot of the work, and two lines of exponents
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

/* Teapots of 64 n^2 - 8 n triangles, ever finer; diffuse rays from where the eye's rays hit. The
 * finest is not asked by brute force. */
static inline void table_of_sizes(const options *o)
{
    enum { sizes = 8, width = 280, brute = 64 };  /* for some 20,000 diffuse rays, as in 17 */
    static const int fine[sizes] = {1, 2, 4, 8, 16, 32, 64, 126};
    double x[sizes], build[sizes], search[sizes], nodes[sizes], least = HUGE_VAL, greatest = 0;
    table out = table_new("Growth with n, SAH, one thread",
                          "triangles|build [ms]|build / (n log2 n) [ns]|references a shape|"
                          "nodes a ray|leaves a ray|tests a ray|ray [ns]|brute force [ns]|"
                          "peak bytes a shape");
    plot q = plot_new("Diffuse rays: work against n", "triangles", "number of each, a ray",
                      PLOT_LOG_X);
    plot_series(&q, "nodes"), plot_series(&q, "leaves"), plot_series(&q, "tests");
    for (int i = 0; i < sizes; i++) {
        trial_scene s;
        trial_row r = {.verbs = &kdtree_trial, .how = &kdtree_defaults};
        trial_scene_of(teapot_mesh(fine[i]), &s);
        size_t corners = fine[i] > brute ? 0 : s.m.triangles < 50000 ? 40 : 10;
        trial_rays(&s, trial_camera(&s.m, 1.6), width, width * 5 / 8, corners, o->seed,
                   &kdtree_trial, &kdtree_defaults);
        rays_free(&s.rays[TRIAL_PRIMARY]);
        trials_run(&r, 1, &s, s.m.triangles < 500000 ? 3 : 1);
        search_work w = r.ray[TRIAL_DIFFUSE].work;
        size_t rays = r.ray[TRIAL_DIFFUSE].n;
        double n = (double)s.m.triangles, ns = trial_ns(&r, TRIAL_DIFFUSE), unit;
        x[i] = log2(n), build[i] = log2(r.build), search[i] = log2(ns);
        unit = r.build / (n * x[i]);
        if (n > 900) least = fmin(least, unit), greatest = fmax(greatest, unit);
        const double cell[] = {r.build * 1e3, unit * 1e9,
                               trial_per((double)r.stats.references, r.stats.items),
                               trial_per((double)w.nodes, rays), trial_per((double)w.leaves, rays),
                               trial_per((double)w.tests, rays), ns};
        nodes[i] = cell[3];
        table_count(&out, s.m.triangles);
        for (int k = 0; k < 7; k++) table_number(&out, cell[k]);
        trial_cell(&out, s.brute > 0, s.brute * 1e9);
        table_number(&out, trial_per((double)r.stats.peak, s.m.triangles));
        for (int k = 0; k < 3; k++) plot_add(&q, k, n, cell[3 + k]);
        trial_end(&r, 1), trial_scene_free(&s);
    }
    output_extra_table(o, &out);
    printf("# fitted: build ~ n^%.2f; build / (n log2 n) within a factor %.2f from 1e3 on\n",
           bench_slope(x, build, sizes), greatest / least);
    printf("# fitted: a diffuse ray passes %.2f more nodes for each doubling of n; "
           "time ~ n^%.2f\n\n",
           bench_slope(x, nodes, sizes), bench_slope(x, search, sizes));
    output_plot(o, &q, "12_kdtree_n.svg");
}

#endif
