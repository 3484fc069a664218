/* scenes.h: where an octree is better than a grid, and how deep it has to be.
 *
 *   table_of_stadium(o)       the teapot, and the teapot in a stadium: grid and octree
 *   plots_of_depth(o)         work, time and memory against depth, on three scenes
 */
#ifndef OCTREE_SCENES_H
#define OCTREE_SCENES_H

#include "../../10_grid/grid.h"
#include "../../07_mesh/scenes/stadium.h"
#include "measure.h"

static inline void table_of_stadium(const options *o);
static inline void plots_of_depth(const options *o);

/* ---------------------------------------------------------------------------------------------- */

typedef struct { const grid *g; const ray_set *rays; } grid_trial;

static inline double octree_run_grid(void *context)
{
    const grid_trial *t = context;
    size_t hits = 0;
    hit h;
    for (size_t i = 0; i < t->rays->n; i++) hits += grid_hit(t->g, t->rays->r[i], &h);
    return (double)hits;
}

static inline void octree_row(table *out, const char *what, const char *name, double build,
                              structure_stats s, search_work w, double seconds, size_t rays)
{
    table_text(out, "%s", what), table_text(out, "%s", name), table_number(out, build * 1e3);
    table_number(out, octree_per((double)s.bytes, s.items));
    table_number(out, octree_per((double)s.references, s.items));
    table_number(out, octree_per((double)w.nodes, rays));
    table_number(out, octree_per((double)w.tests, rays));
    table_number(out, octree_per(seconds * 1e9, rays));
}

/* The same diffuse rays, from the teapot, with and without a stadium of 4032 triangles round it. */
static inline void table_of_stadium(const options *o)
{
    static const char *const what[2] = {"teapot", "stadium"};
    table out = table_new("The teapot and the teapot in a stadium: diffuse rays from the teapot",
                          "scene|structure|build [ms]|memory [B/item]|refs/item|cells or nodes/ray|"
                          "tests/ray|ray [ns]");
    mesh pot = teapot_mesh(1);
    vec3 lo, hi;
    mesh_bounds(&pot, &lo, &hi);
    for (int k = 0; k < 2; k++) {
        int fine = o->quick ? 4 : 24;
        mesh m = k ? stadium_mesh(fine) : teapot_mesh(fine);
        items x = items_of_mesh(&m);
        octree t;
        grid g;
        failure f;
        search_work w = {0, 0, 0, 0};
        hit h;
        double start = clock_seconds();
        if (!octree_build(&x, octree_defaults, &t, &f)) fail(f);
        double octree_built = clock_seconds() - start;
        start = clock_seconds();
        if (!grid_build(&x, grid_defaults, &g, &f)) fail(f);
        double grid_built = clock_seconds() - start;
        ray_set p = rays_primary(camera_of(lo, hi, true, 1.6), o->quick ? 24 : 80,
                                 o->quick ? 15 : 50);
        ray_set d = octree_rays_on(&t, &m, &p, o->seed);
        grid_trial by_grid = {&g, &d};
        octree_trial by_octree = {t, octree_hit, &d};
        clock_variant v[2] = {{"grid", octree_run_grid, &by_grid, 0},
                              {"octree", octree_run, &by_octree, 0}};
        for (size_t i = 0; i < d.n; i++) grid_hit_counted(&g, d.r[i], &h, &w);
        clock_compare(v, 2, o->quick ? 1 : 3);
        octree_row(&out, what[k], "grid, 27 n", grid_built, grid_stats(&g), w, v[0].seconds, d.n);
        octree_row(&out, what[k], "octree", octree_built, octree_stats(&t), octree_count(&t, &d),
                   v[1].seconds, d.n);
        octree_free(&t), grid_free(&g);
        rays_free(&p), rays_free(&d);
        mesh_free(&m);
    }
    output_extra_table(o, &out);
    mesh_free(&pot);
}

static inline void plots_of_depth(const options *o)
{
    static const char *const name[3] = {"teapot", "teapot in a stadium", "soup"};
    plot work = plot_new("Work a ray against depth, leaves of 8", "depth", "nodes and tests a ray",
                         PLOT_LOG_Y);
    plot memory = plot_new("Memory against depth, leaves of 8", "depth", "bytes an item",
                           PLOT_LOG_Y);
    plot seconds = plot_new("Time of a diffuse ray against depth, leaves of 8", "depth",
                            "time [ns]", PLOT_LOG_Y);
    int fine = o->quick ? 4 : 16;
    for (int k = 0; k < 3; k++) {
        mesh pot = teapot_mesh(1);
        mesh m = k == 0 ? teapot_mesh(fine) : k == 1 ? stadium_mesh(fine)
                                            : octree_soup((size_t)(64 * fine * fine), 0.1, 3);
        items x = items_of_mesh(&m);
        vec3 lo, hi;
        octree t;
        failure f;
        ray_set d = {NULL, 0};
        mesh_bounds(k == 1 ? &pot : &m, &lo, &hi);
        ray_set p = rays_primary(camera_of(lo, hi, true, 1.6), o->quick ? 24 : 72,
                                 o->quick ? 15 : 45);
        int by_work = plot_series(&work, name[k]), by_memory = plot_series(&memory, name[k]);
        int by_time = plot_series(&seconds, name[k]);
        if (!octree_build(&x, octree_defaults, &t, &f)) fail(f);
        d = octree_rays_on(&t, &m, &p, o->seed);
        octree_free(&t);
        for (int depth = 1; depth <= 16; depth++) {
            if (!octree_build(&x, (octree_options){8, depth, true, true, (size_t)1 << 30}, &t, &f))
                fail(f);
            octree_trial trial = {t, octree_hit, &d};
            clock_variant v = {name[k], octree_run, &trial, 0};
            search_work w = octree_count(&t, &d);
            clock_compare(&v, 1, o->quick || depth < 3 ? 1 : 3);
            plot_add(&work, by_work, depth, octree_per((double)(w.nodes + w.tests), d.n));
            plot_add(&memory, by_memory, depth, octree_per((double)t.bytes, t.items));
            plot_add(&seconds, by_time, depth, octree_per(v.seconds * 1e9, d.n));
            octree_free(&t);
        }
        rays_free(&p), rays_free(&d);
        mesh_free(&m), mesh_free(&pot);
    }
    output_plot(o, &work, "11_octree_depth.svg");
    output_plot(o, &memory, "11_octree_memory.svg");
    output_plot(o, &seconds, "11_octree_time.svg");
}

#endif
