/* measure.h: the rules on one mesh; on other scenes; what the naive variants lose; pieces counted.
 *
 *   table_of_rules(o, &m)       the main table, and the plot of building against searching
 *   table_of_scenes(o)          planes across the axes and of any direction, scene by scene
 *   table_of_losses(o)          wrong hits of 6000 rays aimed where planes are
 *   table_of_pieces(o)          of the painter, and their plot
 */
#ifndef BSP_MEASURE_H
#define BSP_MEASURE_H

#include "../../common/output.h"
#include "../07_mesh/specimens.h"
#include "../10_grid/stadium.h"
#include "../10_grid/survey.h"
#include "bsp.h"
#include "painter.h"
#include "puzzles.h"

static inline void table_of_rules(const options *o, const mesh *m);
static inline void table_of_scenes(const options *o);
static inline void table_of_losses(const options *o);
static inline void table_of_pieces(const options *o);

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

static inline double run_build(void *context)
{
    trial *t = context;
    failure f;
    bsp_free(&t->b);
    if (!bsp_build(t->x, t->how, &t->b, &f)) fail(f);
    return (double)t->b.nodes;
}

static inline double run_search(void *context)
{
    const trial *t = context;
    size_t hits = 0;
    hit h;
    for (size_t i = 0; i < t->rays->n; i += t->some) hits += t->hit(&t->b, t->rays->r[i], &h);
    return (double)hits;
}

/* Median seconds of each trial, taken in turn. */
static inline void time_trials(trial *t, int n, double (*run)(void *), int rounds, double *seconds)
{
    clock_variant v[16];
    for (int i = 0; i < n; i++) v[i] = (clock_variant){t[i].name, run, &t[i], 0};
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

/* Primary rays; diffuse ones from their hits; and rays at corners, with the answers of brute force. */
typedef struct { ray_set primary, diffuse, corners; hit *brute; double brute_seconds; } survey;

static inline survey survey_of(const options *o, const mesh *m, const items *x)
{
    survey s;
    vec3 lo, hi;
    trial t = trial_of("", BSP_COST, 8, x);
    int width = o->quick ? 40 : 160;
    mesh_bounds(m, &lo, &hi);
    view v = view_of(lo, hi, true, (real)1.6);
    s.primary = rays_primary(v, width, width * 5 / 8);
    hit *h = allocate(s.primary.n, sizeof *h);
    run_build(&t);
    for (size_t i = 0; i < s.primary.n; i++)
        if (!bsp_hit(&t.b, s.primary.r[i], &h[i])) h[i] = hit_none;
    s.diffuse = rays_diffuse(m, &s.primary, h, o->seed);
    s.corners = rays_corners(m, v.camera.e, o->quick ? 50 : 2000, o->seed);
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
    table out = table_new(title, "rule|time build [ms]|memory [B/tri]|peak [B/tri]|depth|planes/tri|"
                          "slanted [%]|empty [%]|cuts/tri|names/tri|nodes/ray|tests/ray|"
                          "error [wrong]|time primary [ns]|time diffuse [ns]");
    plot p = plot_new("Building against searching", "build [ms]", "a diffuse ray [ns]",
                      PLOT_LOG_X);
    int across = plot_series(&p, "across the axes"), any = plot_series(&p, "and any, by candidates");
    int own = plot_series(&p, "any only");
    time_trials(t, rule_built, run_build, 1, build);
    for (int i = rule_built; i < n; i++) t[i].b = t[rule_default].b, build[i] = build[rule_default];
    for (int i = 0; i < n; i++) t[i].rays = &s.primary;
    time_trials(t, n, run_search, o->quick ? 1 : 7, primary);
    for (int i = 0; i < n; i++) t[i].rays = &s.diffuse;
    time_trials(t, n, run_search, o->quick ? 1 : 7, diffuse);
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

/* ---- other scenes ---- */

static inline mesh splinters(size_t n)  /* 1 long, 0.01 wide, at all angles */
{
    mesh m = puzzle_new(n);
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(77, i, 0);
        real *v = (real *)&m.v[3 * i];
        for (int k = 0; k < 6; k++) v[k] = 2 * random_next(&g) - 1;
        for (int k = 6; k < 9; k++) v[k] = v[k - 6] + (random_next(&g) - (real)0.5) / 50;
    }
    return m;
}

static inline mesh soup(size_t n)  /* 0.05 large, in a cube of 2 */
{
    mesh m = puzzle_new(n);
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(78, i, 0);
        real *v = (real *)&m.v[3 * i];
        for (int k = 0; k < 3; k++) v[k] = 2 * random_next(&g) - 1;
        for (int k = 3; k < 9; k++) v[k] = v[k % 3] + (random_next(&g) - (real)0.5) / 20;
    }
    return m;
}

static inline mesh scene_of(int k, bool quick, const char **name)
{
    int s = quick ? 4 : 1;
    switch (k) {
    case 0: *name = "teapot"; return teapot_mesh(16 / s);
    case 1: *name = "torus"; return torus_mesh(100 / s);
    case 2: *name = "town"; return town_mesh((size_t)(30 / s), 0);
    case 3: *name = "town, turned"; return town_mesh((size_t)(30 / s), (real)0.6);
    case 4: *name = "soup"; return soup((size_t)(8000 / s));
    case 5: *name = "splinters"; return splinters((size_t)(2000 / s));
    default: *name = "stadium"; return stadium_mesh(14 / s);
    }
}

static inline void table_of_scenes(const options *o)
{
    table out = table_new("Planes across the axes, and of any direction: lines through the box",
                          "scene|triangles|rule|time build [ms]|memory [B/tri]|slanted [%]|"
                          "names/tri|nodes/ray|tests/ray|error [wrong]|time [ns]|gain [%]");
    for (int k = 0; k < 7; k++) {
        const char *name;
        mesh m = scene_of(k, o->quick, &name);
        items x = items_of_mesh(&m);
        trial t[2] = {trial_of("axis", BSP_AXIS, 1, &x), trial_of("cost", BSP_COST, 16, &x)};
        double build[2], search[2];
        time_trials(t, 2, run_build, 1, build);
        ray_set rays = rays_uniform(t[0].b.all, o->quick ? 500 : 8000, o->seed);
        ray_set few = {rays.r, o->quick ? 20 : 200};
        hit *brute = rays_brute(&x, &few);
        for (int i = 0; i < 2; i++) t[i].rays = &rays;
        time_trials(t, 2, run_search, o->quick ? 1 : 7, search);
        for (int i = 0; i < 2; i++) {
            structure_stats st = bsp_stats(&t[i].b);
            search_work w = rays_count(&t[i].b, &rays, 1);
            table_text(&out, "%s", name), table_count(&out, m.triangles);
            table_text(&out, "%s", t[i].name), table_number(&out, build[i] * 1e3);
            table_number(&out, per((double)st.bytes, st.items));
            table_number(&out, 100 * per((double)t[i].b.normals, st.inner));
            table_number(&out, per((double)st.references, st.items));
            table_number(&out, per((double)w.nodes, rays.n));
            table_number(&out, per((double)w.tests, rays.n));
            table_count(&out, rays_wrong(&t[i], &few, brute));
            table_number(&out, per(search[i] * 1e9, rays.n));
            if (i) table_number(&out, 100 * (search[0] / search[1] - 1));
            else table_text(&out, "-");
            bsp_free(&t[i].b);
        }
        rays_free(&rays);
        mesh_free(&m);
        free(brute);
    }
    output_extra_table(o, &out);
}

/* ---- what gets lost ---- */

/* At points of the mesh, one third each: at a corner, at an edge, and along an axis at a corner. */
static inline ray_set rays_at(const mesh *m, size_t n, uint64_t seed)
{
    ray_set s = {allocate(n, sizeof(ray)), n};
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(seed, i, 1);
        triangle t = mesh_triangle(m, (size_t)(random_next_bits(&g) % m->triangles));
        vec3 o = {4 * random_next(&g) - 2, 4 * random_next(&g) - 2, 4 * random_next(&g) - 2};
        vec3 axis = {i % 9 < 3, i % 9 >= 3 && i % 9 < 6, i % 9 >= 6};
        vec3 on_edge = vmadd(t.a, vsub(t.b, t.a), random_next(&g)), lo, hi;
        mesh_bounds(m, &lo, &hi);
        o = vmul(o, vsub(hi, lo));
        s.r[i] = i % 3 == 0 ? ray_from(o, vsub(t.a, o)) : i % 3 == 1 ? ray_from(o, vsub(on_edge, o))
               : ray_from(vsub(t.a, vscale(axis, 4 * vlength(vsub(hi, lo)))), axis);
    }
    return s;
}

static inline void table_of_losses(const options *o)
{
    static const struct { const char *name; bsp_sides sides; bool (*hit)(const bsp *, ray, hit *); }
        variant[5] = {{"SAFE, padded", BSP_SIDES_SAFE, bsp_hit},
                      {"not padded", BSP_SIDES_SAFE, bsp_hit_naive},
                      {"first leaf", BSP_SIDES_SAFE, bsp_hit_first},
                      {"STRICT, e = 0", BSP_SIDES_STRICT, bsp_hit},
                      {"FIXED, e = 1e-4", BSP_SIDES_FIXED, bsp_hit}};
    table out = table_new("Wrong hits of 6000 rays at corners, edges and along axes",
                          "variant|error town|error torus|error torus of 0.001|error splinters");
    mesh m[4] = {town_mesh(8, 0), torus_mesh(24), torus_mesh(24), splinters(500)};
    for (size_t i = 0; i < m[2].vertices; i++) m[2].v[i] = vscale(m[2].v[i], (real)0.001);
    size_t wrong[5][4];
    for (int k = 0; k < 4; k++) {
        items x = items_of_mesh(&m[k]);
        ray_set rays = rays_at(&m[k], o->quick ? 300 : 6000, o->seed);
        hit *brute = rays_brute(&x, &rays);
        trial t = trial_of("", BSP_COST, o->quick ? 2 : 16, &x);
        t.how.axis_cost = t.how.slanted_cost = 0.5;  /* many planes */
        for (int i = 0; i < 5; i++) {
            bool other = i == 0 || variant[i].sides != variant[i - 1].sides;
            t.how.sides = variant[i].sides, t.hit = variant[i].hit;
            if (other) run_build(&t);
            wrong[i][k] = rays_wrong(&t, &rays, brute);
        }
        bsp_free(&t.b);
        rays_free(&rays), mesh_free(&m[k]);
        free(brute);
    }
    for (int i = 0; i < 5; i++) {
        table_text(&out, "%s", variant[i].name);
        for (int k = 0; k < 4; k++) table_count(&out, wrong[i][k]);
    }
    output_extra_table(o, &out);
}

/* ---- pieces ---- */

static inline size_t pieces_of(const mesh *m, painter_rule rule, uint64_t seed)
{
    painter p;
    failure f;
    painter_options how = painter_defaults;
    how.rule = rule, how.seed = seed;
    if (!painter_build(m, how, &p, &f)) fail(f);
    size_t n = p.pieces;
    painter_free(&p);
    return n;
}

static inline void table_of_pieces(const options *o)
{
    static const char *const names[4] = {"comb", "crossing walls", "torus", "teapot"};
    table out = table_new("The painter's pieces, by the rule that picks planes",
                          "scene|triangles|first|random|fewest of 16|(13.8)|n^2 / 4");
    plot p = plot_new("Triangles, and the pieces that they are cut into", "triangles", "pieces",
                      PLOT_LOG_X | PLOT_LOG_Y);
    int series[6] = {plot_series(&p, "comb, first"), plot_series(&p, "comb, random"),
                     plot_series(&p, "comb, fewest"), plot_series(&p, "crossing, fewest"),
                     plot_series(&p, "teapot, random"), plot_series(&p, "teapot, fewest")};
    for (int k = 0; k < 4; k++)
        for (int n = 4; n <= (o->quick ? 4 : k == 0 ? 256 : 64); n *= k == 0 ? 4 : 2) {
            if (k >= 2 && n > 16) continue;
            size_t s = (size_t)n;
            mesh m = k == 0 ? comb_mesh(s) : k == 1 ? crossing_mesh(s)
                   : k == 2 ? torus_mesh(4 * n) : teapot_mesh(n / 2);
            size_t first = pieces_of(&m, PAINTER_FIRST, 1);
            size_t random = pieces_of(&m, PAINTER_RANDOM, o->seed);
            size_t fewest = pieces_of(&m, PAINTER_FEWEST, o->seed);
            double all = (double)m.triangles;
            table_text(&out, "%s", names[k]), table_count(&out, m.triangles);
            table_count(&out, first), table_count(&out, random), table_count(&out, fewest);
            table_number(&out, all + 2 * all * log(all)), table_number(&out, all * all / 4);
            if (k == 0) plot_add(&p, series[0], all, (double)first);
            if (k == 0 || k == 3) plot_add(&p, series[k ? 4 : 1], all, (double)random);
            if (k != 2) plot_add(&p, series[k == 0 ? 2 : k == 1 ? 3 : 5], all, (double)fewest);
            mesh_free(&m);
        }
    plot_slope(&p, 1, "slope 1"), plot_slope(&p, 2, "slope 2");
    output_extra_table(o, &out);
    output_plot(o, &p, "13_bsp_pieces.svg");
}

#endif
