/* measure.h: the strategies and the searches measured (09_aabb/trials/bench.h).
 *
 *   table_of_strategies(o, &s)    time, memory, work, wrong hits; the main table
 *   table_of_planes(o)            squares in dyadic planes, where textbook searches lose hits
 *   plots_of_cost(o, &s)          work and time against the cost of a test
 *   plot_of_bonus(o, &s)          work against the bonus for cutting off empty space
 *   kdtree_grow(o)                against the number of triangles
 */
#ifndef KDTREE_MEASURE_H
#define KDTREE_MEASURE_H

#include "../../09_aabb/trials/growth.h"
#include "../first.h"
#include "textbook.h"

typedef struct { const char *name; const trial_verbs *verbs; kdtree_options how; bool again; }
    kdtree_candidate;

TRIAL_VERBS(kdtree, kdtree, kdtree_hit, kdtree_hit_counted)
TRIAL_OTHER(kdtree_textbook, kdtree, kdtree, kdtree_hit_textbook)
TRIAL_OTHER(kdtree_final, kdtree, kdtree, kdtree_hit_naive_final)
TRIAL_OTHER(kdtree_strict, kdtree, kdtree, kdtree_hit_naive_strict)
TRIAL_FIRST(first_kdtree, first_kdtree_build(&b->m, &b->s))

#define KDTREE_HOW(strategy, bonus, clip, planar) \
    {strategy, 4, 0, 1, kdtree_item_cost, bonus, clip, planar, SIZE_MAX / 4}

/* The first seven are the short table, 1 to 4 the picture. */
enum { kdtree_short = 7, kdtree_candidates = 11 };
static const kdtree_candidate kdtree_candidate_list[kdtree_candidates] = {
    {"first", &first_kdtree_trial, KDTREE_HOW(KD_MIDDLE, 0, false, KD_BOTH), false},
    {"middle", &kdtree_trial, KDTREE_HOW(KD_MIDDLE, 0, true, KD_THICK), false},
    {"median", &kdtree_trial, KDTREE_HOW(KD_MEDIAN, 0, true, KD_THICK), false},
    {"SAH, boxes", &kdtree_trial, KDTREE_HOW(KD_SAH, 0, false, KD_THICK), false},
    {"SAH, clipped", &kdtree_trial, KDTREE_HOW(KD_SAH, 0, true, KD_THICK), false},
    {"textbook search", &kdtree_textbook_trial, KDTREE_HOW(KD_SAH, 0.1, true, KD_BOTH), false},
    {"naive: first hit final", &kdtree_final_trial, KDTREE_HOW(KD_SAH, 0.1, true, KD_BOTH), true},
    {"naive: strict", &kdtree_strict_trial, KDTREE_HOW(KD_SAH, 0.1, true, KD_BOTH), true},
    {"naive: strict, one side", &kdtree_strict_trial, KDTREE_HOW(KD_SAH, 0.1, true, KD_ONE), false},
    {"SAH, bonus 0.1", &kdtree_trial, KDTREE_HOW(KD_SAH, 0.1, true, KD_THICK), false},
    {"SAH, bonus 0.5", &kdtree_trial, KDTREE_HOW(KD_SAH, 0.5, true, KD_THICK), false}};

/* ---------------------------------------------------------------------------------------------- */

static inline void kdtree_cells(table *t, const trial_row *r)
{
    table_number(t, 100 * trial_per((double)r->stats.empty, r->stats.leaves));
}

static inline void table_of_strategies(const options *o, const trial_scene *s)
{
    static const trial_columns own = {"|empty leaves [%]", kdtree_cells};
    int n = o->full ? kdtree_candidates : kdtree_short;
    char title[160];
    trial_row row[kdtree_candidates];
    for (int i = 0; i < n; i++) {
        const kdtree_candidate *c = &kdtree_candidate_list[i];
        row[i] = (trial_row){.name = c->name, .verbs = c->verbs, .how = &c->how,
                             .again = c->again};
    }
    trials_run(row, n, s, o->quick ? 1 : 3);
    table t = trial_table(trial_title(s, title), row, n, s, o->full, &own);
    output_table(o, &t);
    trial_end(row, n);
}

/* ---- where textbook searches lose hits ---- */

/* Three planes x, y, z = -1, -1/2, .. 1, of 4 x 4 squares each, cut in two. */
static inline mesh planes_mesh(void)
{
    mesh m = {.vertices = 125, .triangles = 480};
    m.v = allocate(m.vertices, sizeof *m.v);
    m.index = allocate(3 * m.triangles, sizeof *m.index);
    for (int i = 0; i < 125; i++)
        m.v[i] = (vec3){(real)(i % 5) / 2 - 1, (real)(i / 5 % 5) / 2 - 1, (real)(i / 25) / 2 - 1};
    static const uint32_t step[3] = {1, 5, 25};
    uint32_t *at = m.index;
    for (int k = 0; k < 3; k++)
        for (uint32_t i = 0; i < 80; i++) {
            uint32_t u = step[(k + 1) % 3], v = step[(k + 2) % 3];
            uint32_t a = i / 16 * step[k] + i % 4 * u + i / 4 % 4 * v;
            uint32_t corner[6] = {a, a + u, a + u + v, a, a + u + v, a + v};
            memcpy(at, corner, sizeof corner), at += 6;
        }
    return m;
}

/* Rays on which nothing is rounded, or rays from anywhere at corners. */
static inline ray_set rays_at_planes(const mesh *m, size_t n, bool dyadic, uint64_t seed)
{
    ray_set s = {allocate(n, sizeof(ray)), n};
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(seed, i, 4);
        vec3 at = m->v[random_next_bits(&g) % m->vertices];
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
        kdtree_options how = KDTREE_HOW(KD_MIDDLE, 0, true, k % 2 ? KD_ONE : KD_BOTH);
        how.leaf = 1;
        trial_scene_of(planes_mesh(), &s);
        s.rays[TRIAL_CORNERS] = rays_at_planes(&s.m, n, k < 2, o->seed);
        trial_due(&s, false);
        for (int i = 0; i < 4; i++) {
            trial_row r = {.verbs = verbs[i], .how = &how};
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

/* ---- knobs ---- */

/* b and c of ns = b nodes + c tests, by least squares: two normal equations. */
static inline void fit_costs(const double (*row)[3], int n, double *b, double *c)
{
    double xx = 0, xy = 0, yy = 0, xz = 0, yz = 0;
    for (int i = 0; i < n; i++) {
        double x = row[i][0], y = row[i][1], z = row[i][2];
        xx += x * x, xy += x * y, yy += y * y, xz += x * z, yz += y * z;
    }
    *b = (xz * yy - yz * xy) / (xx * yy - xy * xy);
    *c = (yz * xx - xz * xy) / (xx * yy - xy * xy);
}

/* c_i from 1/16 to 2: the trees go from coarse to fine; c_t is 1 throughout. */
static inline void plots_of_cost(const options *o, const trial_scene *s)
{
    enum { most = 6 };
    plot p = plot_new("Cost of a test: work", "c_i / c_t", "a diffuse ray", PLOT_LOG_X);
    plot q = plot_new("Cost of a test: time", "c_i / c_t", "[ns], [B/tri]", PLOT_LOG_X);
    int nodes = plot_series(&p, "nodes"), tests = plot_series(&p, "tests");
    int leaves = plot_series(&p, "leaves"), primary = plot_series(&q, "primary ray [ns]");
    int diffuse = plot_series(&q, "diffuse ray [ns]"), bytes = plot_series(&q, "memory [B/tri]");
    double fit[most][3], node, test, rays = (double)s->rays[TRIAL_DIFFUSE].n;
    kdtree_options how[most];
    trial_row row[most];
    for (int i = 0; i < most; i++) {
        how[i] = kdtree_defaults, how[i].item_cost = ldexp(1.0, i - 4);
        row[i] = (trial_row){.name = "", .verbs = &kdtree_trial, .how = &how[i]};
    }
    trials_run(row, most, s, 5);
    for (int i = 0; i < most; i++) {
        search_work w = row[i].ray[TRIAL_DIFFUSE].work;
        double at = how[i].item_cost;
        fit[i][0] = (double)w.nodes / rays, fit[i][1] = (double)w.tests / rays;
        fit[i][2] = trial_ns(&row[i], TRIAL_DIFFUSE);
        plot_add(&p, nodes, at, fit[i][0]), plot_add(&p, tests, at, fit[i][1]);
        plot_add(&p, leaves, at, (double)w.leaves / rays);
        plot_add(&q, primary, at, trial_ns(&row[i], TRIAL_PRIMARY));
        plot_add(&q, diffuse, at, fit[i][2]);
        plot_add(&q, bytes, at, trial_per((double)row[i].stats.bytes, row[i].stats.items));
    }
    trial_end(row, most);
    fit_costs((const double (*)[3])fit, most, &node, &test);
    printf("# fitted: a diffuse ray takes %.1f ns a node and %.1f ns a test\n\n", node, test);
    output_plot(o, &p, "12_kdtree_cost.svg");
    output_plot(o, &q, "12_kdtree_cost_time.svg");
}

static inline void plot_of_bonus(const options *o, const trial_scene *s)
{
    plot p = plot_new("Bonus for cutting off empty space", "bonus", "a diffuse ray", 0);
    int nodes = plot_series(&p, "nodes"), leaves = plot_series(&p, "leaves");
    int tests = plot_series(&p, "tests");
    static const double bonus[6] = {0, 0.1, 0.2, 0.3, 0.5, 0.8};
    for (int i = 0; i < 6; i++) {
        kdtree_options how = kdtree_defaults;
        trial_row r = {.verbs = &kdtree_trial, .how = &how};
        const ray_set *rays = &s->rays[TRIAL_DIFFUSE];
        how.empty_bonus = bonus[i];
        trial_build(&r, s);
        search_work w = trial_work(&r, rays, 1);
        plot_add(&p, nodes, how.empty_bonus, trial_per((double)w.nodes, rays->n));
        plot_add(&p, leaves, how.empty_bonus, trial_per((double)w.leaves, rays->n));
        plot_add(&p, tests, how.empty_bonus, trial_per((double)w.tests, rays->n));
        trial_unbuild(&r);
    }
    output_plot(o, &p, "12_kdtree_bonus.svg");
}

static inline void kdtree_grow(const options *o)
{
    static const int fine[] = {1, 2, 4, 8, 16, 32, 50};
    const trial_growth g = {.title = "Growth with n, SAH, one thread",
                            .plots = {"12_kdtree_n_time.svg", "12_kdtree_n.svg"},
                            .name = "k-d tree", .work = {"nodes", "leaves", "tests"},
                            .verbs = &kdtree_trial, .how = &kdtree_defaults, .fine = fine,
                            .sizes = 7, .width = 160, .brute = 50};
    trial_grow(o, &g);
}

#endif
