/* measure.h: the rules on one mesh.
 *
 *   table_of_rules(o, &m)       the main table, and the plot of building against searching
 */
#ifndef BSP_MEASURE_H
#define BSP_MEASURE_H

#include "../../../common/lab/report.h"
#include "../../09_aabb/trials/first_row.h"
#include "../first.h"
#include "../bsp.h"

static inline void table_of_rules(const options *o, const mesh *m);

/* ---------------------------------------------------------------------------------------------- */

typedef struct {
    const char *name;
    bsp_options how;
    bool (*hit)(const bsp *, ray, hit *);
    const items *x;
    const ray_set *rays;
    bsp b;
    size_t some;  /* of the rays: what is slow gets fewer */
} trial;

static inline double per(double x, size_t n) { return n ? x / (double)n : 0; }

static inline void run_build(trial *t)
{
    failure f;
    bsp_free(&t->b);
    if (!bsp_build(t->x, t->how, &t->b, &f)) fail(f);
}

static inline double run_search(void *context)
{
    const trial *t = context;
    size_t hits = 0;
    hit h;
    for (size_t i = 0; i < t->rays->n; i += t->some) hits += t->hit(&t->b, t->rays->r[i], &h);
    return (double)hits;
}

/* Once: it takes a hundred times as long as a round of searching. */
static inline void time_builds(trial *t, int n, double *seconds)
{
    for (int i = 0; i < n; i++) {
        double start = clock_seconds();
        run_build(&t[i]);
        seconds[i] = clock_seconds() - start;
    }
}

/* Median seconds of each trial, taken in turn. */
static inline void time_searches(trial *t, int n, int rounds, double *seconds)
{
    clock_variant v[16];
    for (int i = 0; i < n; i++) v[i] = (clock_variant){t[i].name, run_search, &t[i], 0};
    clock_compare(v, n, rounds);
    for (int i = 0; i < n; i++) seconds[i] = v[i].seconds;
}

static inline search_work rays_count(const bsp *b, const ray_set *rays, size_t some)
{
    search_work w = {0, 0, 0, 0};
    hit h;
    for (size_t i = 0; i < rays->n; i += some) bsp_hit_counted(b, rays->r[i], &h, &w);
    return w;
}

static inline size_t rays_asked(const ray_set *rays, size_t some)
{
    return (rays->n + some - 1) / some;
}

static inline size_t rays_wrong(const trial *t, const ray_set *rays, const hit *brute)
{
    size_t wrong = 0;
    for (size_t i = 0; i < rays->n; i++) {
        hit h = hit_none;
        t->hit(&t->b, rays->r[i], &h);
        wrong += h.shape != brute[i].shape || h.t != brute[i].t;
    }
    return wrong;
}

static inline hit *rays_brute(const items *x, const ray_set *rays)
{
    hit *h = allocate(rays->n, sizeof *h);
    for (size_t i = 0; i < rays->n; i++) {
        h[i] = hit_none;
        items_hit(x, rays->r[i], &h[i]);
    }
    return h;
}

static inline trial trial_of(const char *name, bsp_rule rule, int candidates, const items *x)
{
    trial t = {.name = name, .how = bsp_defaults, .hit = bsp_hit, .x = x, .some = 1};
    t.how.rule = rule, t.how.candidates = candidates;
    if (!rule_by_cost(rule)) t.some = 64;
    return t;
}

/* The last two search the tree of the default in their own way: they are not built. */
enum { rule_trials = 11, rule_built = 9, rule_default = 6 };

static inline void rule_trials_of(const items *x, trial t[rule_trials])
{
    t[0] = trial_of("random", BSP_RANDOM, 1, x);
    t[1] = trial_of("fewest of 16", BSP_FEWEST, 16, x);
    t[2] = trial_of("axis", BSP_AXIS, 1, x);
    t[3] = trial_of("own, 16", BSP_OWN, 16, x);
    t[4] = trial_of("cost, 1", BSP_COST, 1, x);
    t[5] = trial_of("cost, 4", BSP_COST, 4, x);
    t[6] = trial_of("cost, 16", BSP_COST, 16, x);
    t[7] = trial_of("cost, 64", BSP_COST, 64, x);
    t[8] = trial_of("sides fixed", BSP_COST, 16, x), t[8].how.sides = BSP_SIDES_FIXED;
    t[9] = trial_of("not padded", BSP_COST, 16, x), t[9].hit = bsp_hit_naive;
    t[10] = trial_of("first leaf", BSP_COST, 16, x), t[10].hit = bsp_hit_first;
}

/* Primary rays; diffuse ones from their hits; rays at corners, and their hits by brute force. */
typedef struct { ray_set primary, diffuse, corners; hit *brute; double brute_seconds; } survey;

static inline survey survey_of(const options *o, const mesh *m, const items *x)
{
    survey s;
    vec3 lo, hi;
    trial t = trial_of("", BSP_COST, 8, x);
    int width = o->quick ? 40 : 160;
    mesh_bounds(m, &lo, &hi);
    camera v = camera_of(lo, hi, true, 1.6);
    s.primary = rays_primary(v, width, width * 5 / 8);
    hit *h = allocate(s.primary.n, sizeof *h);
    run_build(&t);
    for (size_t i = 0; i < s.primary.n; i++)
        if (!bsp_hit(&t.b, s.primary.r[i], &h[i])) h[i] = hit_none;
    s.diffuse = rays_diffuse(m, &s.primary, h, o->seed);
    s.corners = rays_corners(m, v.e, o->quick ? 50 : 2000, o->seed);
    double start = clock_seconds();
    s.brute = rays_brute(x, &s.corners);
    s.brute_seconds = (clock_seconds() - start) / (double)s.corners.n;
    bsp_free(&t.b);
    free(h);
    return s;
}

static inline void survey_free(survey *s)
{
    rays_free(&s->primary), rays_free(&s->diffuse), rays_free(&s->corners);
    free(s->brute);
}

static inline void rule_row(table *out, const trial *t, const survey *s, double build,
                            double primary, double diffuse)
{
    structure_stats st = bsp_stats(&t->b);
    search_work p = rays_count(&t->b, &s->primary, t->some);
    search_work d = rays_count(&t->b, &s->diffuse, t->some);
    size_t np = rays_asked(&s->primary, t->some), nd = rays_asked(&s->diffuse, t->some);
    table_text(out, "%s", t->name);
    table_number(out, build * 1e3);
    table_number(out, per((double)st.bytes, st.items));
    table_number(out, per((double)st.peak, st.items));
    table_count(out, (size_t)st.depth);
    table_number(out, per((double)st.inner, st.items));
    table_number(out, 100 * per((double)t->b.normals, st.inner));
    table_number(out, 100 * per((double)st.empty, st.leaves));
    table_number(out, per((double)t->b.cuts, st.items));
    table_number(out, per((double)st.references, st.items));
    table_number(out, per((double)(p.nodes + d.nodes), np + nd));
    table_number(out, per((double)(p.tests + d.tests), np + nd));
    table_count(out, rays_wrong(t, &s->corners, s->brute));
    table_number(out, per(primary * 1e9, np));
    table_number(out, per(diffuse * 1e9, nd));
}

static inline bool first_bsp_search(const void *b, ray r, hit *out)
{
    return first_bsp_hit(b, r, out);
}

static inline void first_rule_row(table *out, const mesh *m, const survey *s, int rounds)
{
    first_bsp b;
    first_mesh f = first_mesh_of(m);
    double start = clock_seconds();
    first_bsp_build(&f, &b);
    double build = clock_seconds() - start;
    table_text(out, "first"), table_number(out, build * 1e3);
    for (int k = 0; k < 9; k++) table_text(out, "-");
    first_cells(out, (first_search){&b, first_bsp_search}, &s->primary, &s->diffuse, &s->corners,
                s->brute, rounds);
    first_bsp_free(&b), first_mesh_free(&f);
}

static inline void table_of_rules(const options *o, const mesh *m)
{
    items x = items_of_mesh(m);
    enum { n = rule_trials };
    trial t[n];
    double build[n], primary[n], diffuse[n];
    rule_trials_of(&x, t);
    survey s = survey_of(o, m, &x);
    char title[160];
    snprintf(title, sizeof title, "%zu triangles: %zu primary and %zu diffuse rays, one thread; "
             "wrong of %zu at corners", m->triangles, s.primary.n, s.diffuse.n, s.corners.n);
    table out = table_new(title, "rule|time build [ms]|memory [B/tri]|peak [B/tri]|depth|"
                          "planes/tri|slanted [%]|empty [%]|cuts/tri|names/tri|nodes/ray|tests/ray|"
                          "error [wrong]|time primary [ns]|time diffuse [ns]");
    plot p = plot_new("Building against searching", "build [ms]", "a diffuse ray [ns]",
                      PLOT_LOG_X);
    int across = plot_series(&p, "across the axes"), own = plot_series(&p, "any only");
    int any = plot_series(&p, "both, by candidates");
    time_builds(t, rule_built, build);
    for (int i = rule_built; i < n; i++) t[i].b = t[rule_default].b, build[i] = build[rule_default];
    for (int i = 0; i < n; i++) t[i].rays = &s.primary;
    time_searches(t, n, o->quick ? 1 : 15, primary);
    for (int i = 0; i < n; i++) t[i].rays = &s.diffuse;
    time_searches(t, n, o->quick ? 1 : 15, diffuse);
    first_rule_row(&out, m, &s, o->quick ? 1 : 15);
    for (int i = 0; i < n; i++) {
        rule_row(&out, &t[i], &s, build[i], primary[i], diffuse[i]);
        double ns = per(diffuse[i] * 1e9, rays_asked(&s.diffuse, t[i].some));
        bool plain = t[i].hit == bsp_hit && t[i].how.sides == BSP_SIDES_SAFE;
        if (plain && rule_by_cost(t[i].how.rule))
            plot_add(&p, t[i].how.rule == BSP_AXIS ? across : t[i].how.rule == BSP_OWN ? own : any,
                     build[i] * 1e3, ns);
    }
    for (int i = 0; i < rule_built; i++) bsp_free(&t[i].b);
    table_text(&out, "brute force"), table_number(&out, 0);
    for (int k = 0; k < 8; k++) table_text(&out, "-");
    table_number(&out, 0), table_count(&out, m->triangles), table_count(&out, 0);
    table_number(&out, s.brute_seconds * 1e9), table_number(&out, s.brute_seconds * 1e9);
    output_table(o, &out);
    output_plot(o, &p, "13_bsp_time.svg");
    survey_free(&s);
}

#endif
