/* measure.h: the ladder measured, and what watertight costs.
 *
 *   table_of_rungs(o, &s, large)   each rung: time, work, wrong hits; the main table
 *   table_of_shadows(o, &s)        rays to a light: any hit
 *   table_of_cracks(o)             a closed mesh, aimed at: lost rays, errors and time; a plot
 *   table_of_doubts(o, &s)         how often `real` was asked
 */
#ifndef WIDE_MEASURE_H
#define WIDE_MEASURE_H

#include "../../../common/lab/bench.h"
#include "../../../common/lab/report.h"
#include "../../07_mesh/scenes/as_first.h"
#include "../../07_mesh/scenes/specimens.h"
#include "../../07_mesh/scenes/teapot.h"
#include "../../09_aabb/trials/bench.h"
#include "../../14_bvh/bvh.h"
#include "../first.h"
#include "leaky.h"
#include "rungs.h"

TRIAL_FIRST(first_wide, b->s = first_wide_build(&b->m))
TRIAL_VERBS(two_wide, bvh, bvh_hit, bvh_hit_counted)
TRIAL_VERBS(bvh8, bvh8, bvh8_hit, bvh8_hit_counted)
TRIAL_OTHER(bvh8_one, bvh8, bvh8, bvh8_hit_one)
TRIAL_OTHER(bvh8_any_order, bvh8, bvh8, bvh8_hit_any_order)
TRIAL_OTHER(bvh8_boxes, bvh8, bvh8, bvh8_hit_boxes)
TRIAL_OTHER(bvh8_leaky, bvh8, bvh8, bvh8_hit_leaky)

/* ---------------------------------------------------------------------------------------------- */

enum { rungs = 10 };

/* All rungs on a large mesh; on a small one, in six columns, those of the page. A dialect that this
 * machine lacks is measured as the best that it has. */
static inline void table_of_rungs(const options *o, const trial_scene *s, bool large)
{
    static const bool between[rungs] = {[2] = true, [5] = true, [7] = true};
    bvh_options binary = bvh_defaults;
    bvh8_options four = bvh8_defaults, how[eight_dialects];
    bool first = false;
    char title[160];
    int best = (int)eight_best(), n = 0;
    four.width = 4, four.dialect = EIGHT_PLAIN, four.threads = 1;
    for (int d = 0; d < eight_dialects; d++) {
        how[d] = bvh8_defaults, how[d].threads = 1;  /* as 14 builds: one core */
        how[d].dialect = (eight_dialect)(d < best ? d : best);
    }
    const trial_row list[rungs] = {
        {.name = "first, four wide", &first_wide_trial, &first},
        {.name = "14: two wide", &two_wide_trial, &binary},
        {.name = "four wide, one by one", &bvh8_one_trial, &four},
        {.name = "eight, one by one", &bvh8_one_trial, &how[0]},
        {.name = "eight boxes at once", &bvh8_any_order_trial, &how[0], .again = true},
        {.name = "+ nearest first", &bvh8_boxes_trial, &how[0], .again = true},
        {.name = "+ eight triangles", &bvh8_trial, &how[0], .again = true},
        {.name = "+ AVX2", &bvh8_trial, &how[1]}, {.name = "+ AVX-512", &bvh8_trial, &how[2]},
        {.name = "leaky", &bvh8_leaky_trial, &how[2]}};
    trial_row row[rungs];
    for (int i = 0; i < rungs; i++)
        if (large || !between[i]) row[n++] = list[i];
    trials_run(row, n, s, o->quick ? 1 : large ? 15 : 3);
    table t = trial_table(trial_title(s, title), row, n, s, large, NULL);
    output_table(o, &t);
    trial_end(row, n);
}

/* ---------------------------------------------------------------------------------------------- */

typedef bool wide_search(const void *built, ray r, hit *out);
typedef struct { wide_search *hit; const void *built; const ray_set *rays; size_t hits; } wide_pass;

static inline double wide_pass_run(void *context)
{
    wide_pass *p = context;
    hit h;
    p->hits = 0;
    for (size_t i = 0; i < p->rays->n; i++) p->hits += p->hit(p->built, p->rays->r[i], &h);
    return (double)p->hits;
}

static inline bool any_two(const void *b, ray r, hit *h) { return (void)h, bvh_occluded(b, r); }
static inline bool any_wide(const void *w, ray r, hit *h) { return (void)h, bvh8_occluded(w, r); }
static inline bool any_leaky(const void *w, ray r, hit *h)
{
    return (void)h, bvh8_occluded_leaky(w, r);
}

/* From where the primary rays hit to a light above. */
static inline ray_set shadow_rays(const trial_scene *s, const bvh8 *w)
{
    const ray_set *eye = &s->rays[TRIAL_PRIMARY];
    ray_set out = {allocate(eye->n, sizeof *out.r), 0};
    vec3 lo, hi;
    hit h;
    mesh_bounds(&s->m, &lo, &hi);
    vec3 light = vmadd(hi, vsub(hi, lo), 1);
    for (size_t i = 0; i < eye->n; i++)
        if (bvh8_hit(w, eye->r[i], &h))
            out.r[out.n++] = ray_shadow(ray_at(eye->r[i], h.t), light, (real)1e-4);
    return out;
}

static inline void table_of_shadows(const options *o, const trial_scene *s)
{
    enum { n = 4 };
    bvh8 w;
    bvh b;
    failure f;
    if (!bvh8_build(&s->x, bvh8_defaults, &w, &f) || !bvh_build(&s->x, bvh_defaults, &b, &f))
        fail(f);
    const struct { const char *name; wide_search *ask; const void *built; } list[n] = {
        {"14: two wide", any_two, &b}, {"the closest hit", bvh8_trial.hit, &w},
        {"any hit", any_wide, &w}, {"leaky", any_leaky, &w}};
    ray_set rays = shadow_rays(s, &w);
    char title[120];
    snprintf(title, sizeof title, "%zu triangles: %zu rays to a light, one thread",
             s->m.triangles, rays.n);
    table t = table_new(title, "search|rays in shadow|time [ns]");
    wide_pass p[n];
    bench_candidate v[n];
    for (int i = 0; i < n; i++) {
        p[i] = (wide_pass){list[i].ask, list[i].built, &rays, 0};
        v[i] = (bench_candidate){.name = list[i].name, .run = wide_pass_run, .context = &p[i]};
    }
    bench_time(v, n, o->quick ? 1 : 15);
    for (int i = 0; i < n; i++) {
        table_text(&t, "%s", list[i].name), table_count(&t, p[i].hits);
        table_number(&t, trial_per(v[i].seconds * 1e9, rays.n));
    }
    output_extra_table(o, &t);
    rays_free(&rays), bvh8_free(&w), bvh_free(&b);
}

/* ---------------------------------------------------------------------------------------------- */

static inline bool crack_mesh(const void *m, ray r, hit *out) { return mesh_hit(m, r, out); }

/* Into a closed mesh at its corners and edges, from `away` sizes: each ray must hit. Brute force
 * takes one ray in a hundred; so does 14, but for --full, which also looks from afar. */
static inline void table_of_cracks(const options *o)
{
    enum { ways = 5 };
    int all = o->full ? ways - 1 : ways - 2;
    const char *title = o->full
        ? "Into a closed mesh at its corners and edges, from so many sizes away"
        : "Into a closed mesh at its corners and edges; 14: one ray in a hundred";
    table t = table_new(title, "search|distance|rays|error [lost]|error t, largest|time [ns]");
    plot p = plot_new("Lost at corners and edges, against time", "time of a ray [ns]",
                      "lost rays [of 1000]", PLOT_LOG_X | PLOT_LOG_Y);
    mesh m = octahedron_mesh(48);
    items x = items_of_mesh(&m);
    first_wide_trial_of w4 = {.m = first_mesh_of(&m)};
    bvh8 w;
    bvh b2;
    failure f;
    size_t n = o->quick ? 500 : 20000;
    w4.s = first_wide_build(&w4.m);
    if (!bvh8_build(&x, bvh8_defaults, &w, &f) || !bvh_build(&x, bvh_defaults, &b2, &f)) fail(f);
    const struct { const char *name; wide_search *hit; const void *built; } list[ways] = {
        {"first, four wide", first_wide_trial.hit, &w4}, {"leaky", bvh8_leaky_trial.hit, &w},
        {"watertight", bvh8_trial.hit, &w}, {"14: two wide", two_wide_trial.hit, &b2},
        {"brute force", crack_mesh, &m}};
    for (int i = 0; i < ways; i++) plot_series(&p, list[i].name);
    for (double away = 4; away < (o->full ? 1e7 : 5); away *= 500) {
        ray_set rays = rays_corners(&m, vec(0.6 * away, 0.5 * away, 0.7 * away), n, o->seed);
        ray_set few = {rays.r, rays.n / 100};
        bench_candidate c[ways];
        wide_pass q[ways];
        for (int i = 0; i < ways; i++) {
            q[i] = (wide_pass){list[i].hit, list[i].built, i < all ? &rays : &few, 0};
            c[i] = (bench_candidate){.name = list[i].name, .run = wide_pass_run, .context = &q[i]};
        }
        bench_time(c, ways, o->full ? 5 : 1);
        for (int i = 0; i < ways; i++) {
            size_t due = 0, lost = 0;
            double error = 0, ns = trial_per(c[i].seconds * 1e9, q[i].rays->n);
            for (size_t k = 0; k < q[i].rays->n; k++) {
                hit a, b;
                if (!bvh8_hit(&w, rays.r[k], &a)) continue;
                due++;
                if (!list[i].hit(list[i].built, rays.r[k], &b)) lost++;
                else error = fmax(error, (double)(fabs(b.t - a.t) / a.t));
            }
            table_text(&t, "%s", list[i].name), table_number(&t, away), table_count(&t, due);
            table_count(&t, lost), table_number(&t, error), table_number(&t, ns);
            plot_add(&p, i, ns, trial_per(1000 * (double)lost, due));
        }
        rays_free(&rays);
    }
    output_table(o, &t);
    if (o->full) output_plot(o, &p, "15_wide_bvh_time.svg");
    else plot_free(&p);
    bvh8_free(&w), bvh_free(&b2), first_wide_trial.free(&w4), mesh_free(&m);
}

/* How often a ray asked `real`, by kinds. */
static inline void table_of_doubts(const options *o, const trial_scene *s)
{
    table t = table_new("Tests of a ray: in float by eight, and in real one by one",
                        "rays|number|nodes a ray|blocks a ray|triangles a ray|in real a ray|hits");
    bvh8 w;
    failure f;
    if (!bvh8_build(&s->x, bvh8_defaults, &w, &f)) fail(f);
    ray_set shadow = shadow_rays(s, &w);
    for (int k = 0; k < 4; k++) {
        const ray_set *rays = k < 2 ? &s->rays[k] : k == 2 ? &s->rays[TRIAL_CORNERS] : &shadow;
        search_work work = {0, 0, 0, 0};
        size_t before = bvh8_asked, hits = 0;
        hit h;
        for (size_t i = 0; i < rays->n; i++)
            hits += k < 3 ? bvh8_hit_counted(&w, rays->r[i], &h, &work)
                          : bvh8_occluded_counted(&w, rays->r[i], &work);
        table_text(&t, k < 2 ? "%s" : k == 2 ? "at corners" : "shadow", trial_kind_name[k & 1]);
        table_count(&t, rays->n), table_number(&t, trial_per((double)work.nodes, rays->n));
        table_number(&t, trial_per((double)work.leaves, rays->n));
        table_number(&t, trial_per((double)work.tests, rays->n));
        table_number(&t, trial_per((double)(bvh8_asked - before), rays->n));
        table_count(&t, hits);
    }
    output_extra_table(o, &t);
    rays_free(&shadow), bvh8_free(&w);
}

#endif
