/* measure_scenes.h: other scenes; what the naive variants lose; the painter's pieces counted.
 *
 *   table_of_scenes(o)          planes across the axes and of any direction, scene by scene
 *   table_of_losses(o)          wrong hits of 6000 rays aimed where planes are
 *   table_of_pieces(o)          of the painter, and their plot
 */
#ifndef BSP_MEASURE_SCENES_H
#define BSP_MEASURE_SCENES_H

#include "measure.h"
#include "../../07_mesh/scenes/specimens.h"
#include "../../07_mesh/scenes/stadium.h"
#include "../painter.h"
#include "puzzles.h"

/* ---------------------------------------------------------------------------------------------- */

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
    case 3: *name = "town, turned"; return town_mesh((size_t)(30 / s), 0.6);
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
        time_builds(t, 2, build);
        ray_set rays = rays_uniform(t[0].b.all, o->quick ? 500 : 4000, o->seed);
        ray_set few = {rays.r, o->quick ? 20 : 200};
        hit *brute = rays_brute(&x, &few);
        for (int i = 0; i < 2; i++) t[i].rays = &rays;
        time_searches(t, 2, o->quick ? 1 : 21, search);
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
    for (size_t i = 0; i < m[2].vertices; i++) m[2].v[i] = vscale(m[2].v[i], 0.001);
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
