/* growth.h: time and work against n: teapots of 56 to 999,000 triangles.
 *
 *   growth_run(&c)         diffuse rays: a table, fitted exponents, a plot; false: a wrong hit
 *   orders_run(&c)         the two orders of rendering once more (08), primary visibility: each
 *                          triangle on its pixels, or each pixel's ray in a tree? a table
 *
 * Growth: who took more than 2 seconds to build the size before (with BENCH_ONCE 0.03), or for a
 * ray a hundred times as long as the fastest, is left out of the larger ones; the quickest to
 * build, which finds where rays begin, stays. time ~ n^a (17.9): 1 for brute force. A tree that
 * does log n steps has an a that falls with n; how many more steps a doubling of n takes is the
 * better number. Least squares against log n.
 *
 * Orders: both end with a `hit` for each pixel (08 says where these differ). Making the rays
 * counts, and so does projecting the corners and clearing the picture. The tree is built before:
 * what that takes stands in the table, and a thing that moves pays it in each picture.
 */
#ifndef COMPARE_LAB_GROWTH_H
#define COMPARE_LAB_GROWTH_H

#include "../../07_mesh/scenes/named.h"
#include "../../08_object_order/raster.h"
#include "summary.h"

enum { growth_sizes = 8 };  /* 64 n^2 - 8 n triangles each */
static const int growth_fine[growth_sizes] = {1, 2, 4, 8, 16, 32, 64, 125};

/* A teapot, a camera, its wide tree; s: the picture that both draw; what was in it is gone. */
typedef struct { world w; items x; camera c; void *tree; double build; raster s; } race;

/* ---------------------------------------------------------------------------------------------- */

/* Of structure k, where it took part: log2 of n, of a ray's seconds, and steps; how many. */
static inline int growth_points(const measured_scenes *m, int k, double x[growth_sizes],
                                double y[growth_sizes], double steps[growth_sizes])
{
    int n = 0;
    for (const comparison *s = m->of; s < m->of + m->n && s->entry[k].fits; s++, n++) {
        double nodes, tests;
        cost_work(&s->entry[k], &nodes, &tests);
        x[n] = log2((double)s->x.n), y[n] = log2(cost_mean(s, &s->entry[k]));
        steps[n] = nodes + tests;
    }
    return n;
}

/* Who is too slow for more than the size s; and who did not fit. */
static inline void growth_leave(const comparison *s, line_up *now)
{
    double patience = getenv("BENCH_ONCE") ? 0.03 : 2, least = HUGE_VAL, quick = HUGE_VAL;
    for (const compare_entry *e = s->entry; e < s->entry + s->entries; e++) {
        if (e->fits) least = fmin(least, cost_mean(s, e));
        if (entry_counts(e)) quick = fmin(quick, e->build);
    }
    for (int k = 0; k < now->n; k++) {
        const compare_entry *e = &s->entry[k];
        now->of[k].out = !e->fits || e->build > fmax(patience, quick)
                         || (cost_mean(s, e) > 100 * least && e->c != &brute_contender);
    }
}

/* The next size. */
static inline bool growth_step(const compare_settings *c, measured_scenes *m, line_up *now)
{
    world w;
    comparison s;
    failure f;
    bool quick = c->o->quick;
    if (!mesh_world(&w, "teapot", teapot_mesh(growth_fine[m->n]), true, &f)) fail(f);
    compare_begin(&s, &w, now, c->most_bytes, quick ? 1 : 3);
    compare_rays(&s, quick ? 200 : compare_usual_rays, c->o->seed);
    ray_set some = rays_some(&s.rays[KIND_DIFFUSE], 4000);
    bool ok = prove_rays(&s, &some, PROVE_ALIKE, stdout);
    rays_free(&some);
    cost_kind(&s, KIND_DIFFUSE, quick ? 1 : 5, cost_few);
    snprintf(s.name, sizeof s.name, "%zu", s.x.n);
    growth_leave(measured_add(m, &s), now);
    world_free(&w);
    return ok;
}

/* Brute force is off the scale of the plot, as slope 1 says. */
static inline void growth_print(const measured_scenes *m, html_report *to)
{
    plot p = plot_new("A diffuse ray against n", "triangles", "time [ns]", PLOT_LOG_X | PLOT_LOG_Y);
    summary_table(m, to, "Growth: nanoseconds a diffuse ray, by triangles", false, 1e9, 0);
    for (int k = 0; k < m->chosen->n; k++) {
        double x[growth_sizes], y[growth_sizes], steps[growth_sizes];
        const compare_choice *c = &m->chosen->of[k];
        int n = growth_points(m, k, x, y, steps);
        if (n > 1)  /* first versions count no steps */
            html_note(to, contender_is_first(c->c) ? "%-12s a ray ~ n^%.2f"
                      : "%-12s a ray ~ n^%.2f, %.3g more steps a doubling", c->label,
                      bench_slope(x, y, n), bench_slope(x, steps, n));
        if (!contender_counts(c->c) || p.series == plot_most_series) continue;
        int series = plot_series(&p, c->label);
        for (int i = 0; i < n; i++) plot_add(&p, series, exp2(x[i]), 1e9 * exp2(y[i]));
    }
    printf("\n");
    plot_slope(&p, 1, "slope 1");
    html_plot(to, &p, "17_compare_n_time.svg");
}

static inline bool growth_run(const compare_settings *c)
{
    line_up now = c->chosen;
    measured_scenes m = {.chosen = &c->chosen};
    bool ok = true;
    html_element(c->to, "h2", "Growth");
    while (ok && m.n < (c->o->quick ? 3 : growth_sizes)) ok = growth_step(c, &m, &now);
    if (ok) growth_print(&m, c->to);
    measured_free(&m);
    return ok;
}

/* The two orders. ------------------------------------------------------------------------------ */

/* cells: of each patch, along an edge */
static inline void race_begin(int cells, race *t)
{
    failure f;
    if (!mesh_world(&t->w, "teapot", teapot_mesh(cells), true, &f)
        || !camera_perspective(t->w.frame, 33, (real)4 / 3, &t->c, &f)) fail(f);
    t->x = items_of_mesh(&t->w.mesh);
    double start = work_seconds();
    t->tree = contender_build(&wide_contender, &(contender_settings){.n = 0}, &t->x, SIZE_MAX, &f);
    if (!t->tree) fail(f);
    t->build = work_seconds() - start;
}

static inline void race_end(race *t)
{
    contender_free(&wide_contender, t->tree);
    world_free(&t->w);
}

static inline double race_drawn(void *context)
{
    race *t = context;
    raster *s = &t->s;
    for (int k = 0; k < s->nx * s->ny; k++) s->h[k] = hit_none, s->depth[k] = -1;
    s->asked = s->covered = 0;
    raster_mesh(s, &t->w.mesh, t->c, raster_default);
    return (double)s->h[0].t;
}

/* A row at a time: the search is a loop of its own. */
static inline double race_traced(void *context)
{
    race *t = context;
    size_t nx = (size_t)t->s.nx;
    ray *row = allocate(nx, sizeof *row);
    for (int y = 0; y < t->s.ny; y++) {
        for (int x = 0; x < t->s.nx; x++)
            row[x] = camera_ray(t->c, (real)x + (real)0.5, (real)y + (real)0.5, t->s.nx, t->s.ny);
        wide_contender.search(t->tree, row, nx, false, t->s.h + (size_t)y * nx);
    }
    free(row);
    return (double)t->s.h[0].t;
}

/* One mesh in one size. */
static inline void race_row(race *t, int nx, int rounds, table *to)
{
    bench_candidate c[2] = {{.run = race_drawn, .context = t}, {.run = race_traced, .context = t}};
    int ny = nx * 3 / 4;
    t->s = raster_new(nx, ny);
    bench_time_by(work_seconds, c, 2, rounds);
    table_count(to, t->w.mesh.triangles), table_text(to, "%d x %d", nx, ny);
    table_number(to, (double)t->s.asked / (nx * ny));
    for (int k = 0; k < 2; k++) table_number(to, 1e3 * c[k].seconds);
    table_number(to, c[1].seconds / c[0].seconds), table_number(to, 1e3 * t->build);
    raster_free(&t->s);
}

static inline void orders_run(const compare_settings *c)
{
    bool quick = c->o->quick;
    static const int cells[] = {2, 8, 32, 64, 125}, width[] = {80, 320, 1280};
    table t = table_new("Two orders, one picture", "triangles|pixels|asked a pixel|raster [ms]|"
                        "wide [ms]|ratio wide / raster|build wide [ms]");
    for (int m = 0; m < (quick ? 2 : 5); m++) {
        race track;
        race_begin(cells[m], &track);
        compare_progress("two orders", "timing", "");
        for (int i = 0; i < (quick ? 2 : 3); i++) race_row(&track, width[i], quick ? 1 : 5, &t);
        race_end(&track);
    }
    compare_progress("two orders", NULL, NULL);
    html_element(c->to, "h2", "Two orders");
    html_table(c->to, &t);
}

#endif
