/* pictures.h: the pictures of this chapter.
 *
 *   draw_grid(o)          the teapot in its cells; how many of them each ray passes; large
 *                         triangles, and where the first hit found is not the first hit
 *   draw_walk(o)          a walk in the plane: cells that hold something, cells passed
 *   draw_stadium(o)       what the teapot in the stadium takes: one level, two levels
 *   draw_mesh(o, m, how)  any mesh, and how many cells each ray passes
 */
#ifndef GRID_PICTURES_H
#define GRID_PICTURES_H

#include "../../../common/output.h"
#include "../../../common/parallel.h"
#include "../../../common/headlight.h"
#include "bench.h"
#include "../../../common/lab/heat.h"
#include "naive.h"
#include "../nested.h"

enum { panel_gap = 6 };

typedef struct panel panel;
struct panel {
    image *im;
    int left, width;
    camera eye;
    const mesh *m;
    const grid *g;
    const nested *n;             /* or NULL */
    real most;                   /* of a count that is drawn white */
    int samples;                 /* samples x samples rays a pixel */
    vec3 (*see)(const panel *p, ray r);
};

static inline vec3 rgb(double r, double g, double b) { return (vec3){(real)r, (real)g, (real)b}; }
static inline vec3 mix(vec3 a, vec3 b, real t) { return vmadd(vscale(a, 1 - t), b, t); }
static const vec3 paper = {0.93, 0.93, 0.93};

/* ---------------------------------------------------------------------------------------------- */

static inline void panel_pixel(int x, int y, void *context)
{
    const panel *p = context;
    vec3 sum = {0, 0, 0};
    int n = p->samples;
    for (int k = 0; k < n * n; k++) {
        real u = (real)x + ((real)(k % n) + (real)0.5) / (real)n;
        real v = (real)y + ((real)(k / n) + (real)0.5) / (real)n;
        sum = vadd(sum, p->see(p, camera_ray(p->eye, u, v, p->width, p->im->height)));
    }
    image_set(p->im, p->left + x, y, vscale(sum, 1 / (real)(n * n)));
}

static inline bool panel_draw(panel *p, vec3 (*see)(const panel *, ray), int threads)
{
    p->see = see;
    return parallel_pixels(p->width, p->im->height, threads, "picture", panel_pixel, p);
}

/* Panel k of n in a row, a white gap to its right. */
static inline void panel_place(panel *p, int k, int n)
{
    int all = p->im->width, gap = all >= 12 * n ? panel_gap : 0, w = (all - (n - 1) * gap) / n;
    p->width = w > 1 ? w : 1;
    p->left = k * (p->width + gap) < all ? k * (p->width + gap) : all - 1;
    for (int y = 0; y < p->im->height; y++)
        for (int x = p->left + p->width; x < p->im->width; x++)
            image_set(p->im, x, y, (vec3){1, 1, 1});
}

static inline vec3 see_mesh(const panel *p, ray r)
{
    hit h;
    if (!grid_hit(p->g, r, &h)) return paper;
    return headlight(mesh_normal(p->m, h.shape, h.u, h.v), r.d);
}

static inline vec3 see_work(const panel *p, ray r)
{
    search_work w = {0, 0, 0, 0};
    hit h;
    grid_hit_counted(p->g, r, &h, &w);
    return work_colour((real)(w.nodes + w.tests) / p->most);
}

/* The same on a logarithmic scale. */
static inline vec3 see_work_log(const panel *p, ray r)
{
    search_work w = {0, 0, 0, 0};
    hit h;
    if (p->n) nested_hit_counted(p->n, r, &h, &w);
    else grid_hit_counted(p->g, r, &h, &w);
    return work_colour(log((real)(1 + w.nodes + w.tests)) / log(p->most));
}

/* Orange: the first hit found is not the first. */
static inline vec3 see_early(const panel *p, ray r)
{
    hit h = hit_none, e = hit_none;
    if (!grid_hit(p->g, r, &h)) return paper;
    grid_hit_early(p->g, r, &e);
    vec3 c = headlight(mesh_normal(p->m, h.shape, h.u, h.v), r.d);
    return e.shape == h.shape ? c : rgb(0.95, 0.3, 0);
}

/* The cells on the left of the middle that hold something, as boxes; on the right the mesh. A cell
 * is found as the grid finds it: by walking. */
static inline vec3 see_cells(const panel *p, ray r)
{
    const grid *g = p->g;
    grid_line a = line_of(r);
    real t = 0, to = real_largest, middle = (g->box.lo.x + g->box.hi.x) / 2;
    hit h = {real_infinity, 0, 0, 0};
    bool found = grid_hit(g, r, &h);
    vec3 shown = found ? headlight(mesh_normal(p->m, h.shape, h.u, h.v), r.d) : paper;
    if (!grid_span(g->box, &a, &t, &to)) return shown;
    grid_walk w = walk_from(&g->cells, &a, t);
    for (; t <= to && t <= h.t; t = walk_next_t(&w), t <= to ? walk_step(&w, t) : (void)0) {
        if (!cell_marked(&g->lists, (size_t)w.cell)) continue;
        vec3 at = ray_at(r, t), f = vmul(vsub(at, g->cells.lo), g->cells.per), n = {0, 0, 0};
        if (walk_index(&g->cells, &w, 0) >= (int)((middle - g->cells.lo.x) * g->cells.per.x))
            continue;
        real off[3] = {fabs(f.x - floor(f.x + (real)0.5)), fabs(f.y - floor(f.y + (real)0.5)),
                       fabs(f.z - floor(f.z + (real)0.5))};
        int k = off[0] <= off[1] && off[0] <= off[2] ? 0 : off[1] <= off[2] ? 1 : 2;
        ((real *)&n)[k] = 1;
        real edge = real_min(off[(k + 1) % 3], off[(k + 2) % 3]);
        real light = edge < (real)0.07 ? (real)0.3 : 1;
        return vscale(vmul(headlight(n, r.d), rgb(0.65, 0.8, 1)), light);
    }
    return shown;
}

static inline void panel_mesh(panel *p, const mesh *m, grid *g, grid_options how, camera v)
{
    items x = items_of_mesh(m);
    failure f;
    if (!grid_build(&x, how, g, &f)) fail(f);
    p->m = m, p->g = g, p->n = NULL, p->eye = v;
}

static inline camera panel_view(const panel *p, const mesh *m, bool z_up)
{
    vec3 lo, hi;
    mesh_bounds(m, &lo, &hi);
    return camera_of(lo, hi, z_up, (real)p->width / (real)p->im->height);
}

static inline void draw_grid(const options *o, grid_options how)
{
    image im = image_new(o->width, o->height);
    panel p = {.im = &im, .most = 160, .samples = o->quick ? 1 : 2};
    mesh pot = teapot_mesh(o->quick ? 4 : 16), many = bench_boards(60, o->seed);
    grid_options coarse = how;
    grid g;
    coarse.density = how.density / 27;
    panel_place(&p, 0, 3);
    panel_mesh(&p, &pot, &g, coarse, panel_view(&p, &pot, true));
    bool whole = panel_draw(&p, see_cells, o->threads);
    grid_free(&g), panel_place(&p, 1, 3);
    panel_mesh(&p, &pot, &g, how, panel_view(&p, &pot, true));
    whole = whole && panel_draw(&p, see_work, o->threads);
    grid_free(&g), panel_place(&p, 2, 3);
    panel_mesh(&p, &many, &g, how, panel_view(&p, &many, true));
    whole = whole && panel_draw(&p, see_early, o->threads);
    output_picture(o, &im, "10_grid.png", true, whole);
    grid_free(&g), mesh_free(&pot), mesh_free(&many), image_free(&im);
}

static inline void draw_mesh(const options *o, const mesh *m, grid_options how, const char *name)
{
    image im = image_new(o->width, o->height);
    panel p = {.im = &im, .most = 120, .samples = 2};
    grid g;
    panel_place(&p, 0, 2);
    double start = clock_seconds();
    panel_mesh(&p, m, &g, how, panel_view(&p, m, false));
    printf("# %zu triangles, %zu cells, %zu references: built in %.3f s\n", m->triangles,
           lattice_cells(&g.cells), g.lists.references, clock_seconds() - start);
    bool whole = panel_draw(&p, see_mesh, o->threads);
    panel_place(&p, 1, 2);
    whole = whole && panel_draw(&p, see_work, o->threads);
    output_picture(o, &im, name, true, whole);
    grid_free(&g), image_free(&im);
}

static inline void draw_stadium(const options *o)
{
    image im = image_new(o->quick ? 100 : 560, o->quick ? 50 : 240);
    panel p = {.im = &im, .most = 5000, .samples = 1};
    mesh m = stadium_mesh(o->quick ? 4 : 8);
    nested n;
    grid g;
    failure f;
    panel_place(&p, 0, 2);
    panel_mesh(&p, &m, &g, grid_defaults, bench_stadium_view((real)p.width / (real)im.height));
    bool whole = panel_draw(&p, see_work_log, o->threads);
    items x = items_of_mesh(&m);
    if (!nested_build(&x, nested_defaults, &n, &f)) fail(f);
    panel_place(&p, 1, 2), p.n = &n;
    whole = whole && panel_draw(&p, see_work_log, o->threads);
    output_picture(o, &im, "10_grid_stadium.png", false, whole);
    grid_free(&g), nested_free(&n), mesh_free(&m), image_free(&im);
}

#endif
