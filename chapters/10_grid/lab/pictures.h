/* pictures.h: the pictures of this chapter.
 *
 *   draw_grid(o, how)     the teapot in its cells; how many of them each ray passes; large
 *                         triangles, and where the first hit found is not the first hit
 *   draw_stadium(o)       what the teapot in the stadium takes: one level, two levels
 *   draw_model(o, &s, how, path)   any mesh, and how many cells each ray passes
 */
#ifndef GRID_PICTURES_H
#define GRID_PICTURES_H

#include "../../../common/lab/label.h"
#include "../../../common/output.h"
#include "../../09_aabb/trials/pictures.h"
#include "measure.h"

static const vec3 grid_paper = {0.93, 0.93, 0.93};

/* ---------------------------------------------------------------------------------------------- */

/* Orange: the first hit found is not the first. */
static inline vec3 see_early(const void *picture, real x, real y)
{
    const trial_picture *p = picture;
    ray r = trial_eye_ray(p, x, y);
    hit h = hit_none, e = hit_none;
    if (!grid_hit(p->built, r, &h)) return grid_paper;
    grid_hit_early(p->built, r, &e);
    vec3 c = headlight(mesh_normal(p->m, h.shape, h.u, h.v), r.d);
    return e.shape == h.shape ? c : vec(0.95, 0.3, 0);
}

/* The cells on the left of the middle that hold something, as boxes; on the right the mesh. A cell
 * is found as the grid finds it: by walking. */
static inline vec3 see_cells(const void *picture, real x, real y)
{
    const trial_picture *p = picture;
    const grid *g = p->built;
    ray r = trial_eye_ray(p, x, y);
    grid_line a = line_of(r);
    real t = 0, to = real_largest, middle = (g->box.lo.x + g->box.hi.x) / 2;
    hit h = {real_infinity, 0, 0, 0};
    bool found = grid_hit(g, r, &h);
    vec3 shown = found ? headlight(mesh_normal(p->m, h.shape, h.u, h.v), r.d) : grid_paper;
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
        return vscale(vmul(headlight(n, r.d), vec(0.65, 0.8, 1)), light);
    }
    return shown;
}

/* Panel k of n in a row, a white gap to its right: a mesh in a grid, seen by `colour`. */
static inline bool grid_panel(image *all, int k, int n, const trial_scene *s, grid_options how,
                              bool z_up, real most, int samples, int threads,
                              pixels_colour *colour)
{
    int gap = all->width >= 12 * n ? 6 : 0, w = (all->width - (n - 1) * gap) / n;
    trial_row r = {.verbs = &grid_trial, .how = &how};
    vec3 lo, hi;
    image im = image_new(w > 1 ? w : 1, all->height);
    int left = k * (im.width + gap) < all->width ? k * (im.width + gap) : all->width - 1;
    mesh_bounds(&s->m, &lo, &hi);
    trial_build(&r, s);
    camera c = camera_of(lo, hi, z_up, (real)im.width / (real)im.height);
    trial_picture p = {&grid_trial, r.built, &s->m, c, im.width, im.height, most};
    bool whole = pixels_draw(&im, samples, threads, "picture", colour, &p);
    image_place(all, left, 0, &im);
    for (int y = 0; y < all->height; y++)
        for (int x = left + im.width; x < all->width; x++)
            image_set(all, x, y, (vec3){1, 1, 1});
    trial_unbuild(&r), image_free(&im);
    return whole;
}

static inline void draw_grid(const options *o, grid_options how)
{
    image im = image_new(o->width, o->height);
    trial_scene pot, many;
    int n = o->quick ? 1 : 2;
    grid_options coarse = how;
    trial_scene_of(teapot_mesh(o->quick ? 4 : 16), &pot);
    trial_scene_of(grid_boards(60, o->seed), &many);
    coarse.density = how.density / 27;
    bool whole = grid_panel(&im, 0, 3, &pot, coarse, true, 1, n, o->threads, see_cells)
                 && grid_panel(&im, 1, 3, &pot, how, true, 160, n, o->threads, trial_work_colour)
                 && grid_panel(&im, 2, 3, &many, how, true, 1, n, o->threads, see_early);
    output_picture(o, &im, "10_grid.png", true, whole);
    trial_scene_free(&pot), trial_scene_free(&many), image_free(&im);
}

static inline void draw_model(const options *o, const trial_scene *s, grid_options how,
                              const char *path)
{
    char name[512];
    image im = image_new(o->width, o->height);
    trial_row r = {.verbs = &grid_trial, .how = &how};
    trial_time_build(&r, s, 1);
    structure_stats st = grid_stats(r.built);
    printf("# %zu triangles, %zu cells, %zu references: built in %.3f s\n", s->m.triangles,
           st.leaves, st.references, r.build);
    trial_unbuild(&r);
    bool whole = grid_panel(&im, 0, 2, s, how, false, 1, 2, o->threads, trial_mesh_colour)
                 && grid_panel(&im, 1, 2, s, how, false, 120, 2, o->threads, trial_work_colour);
    output_picture(o, &im, picture_name("10_grid.png", path, name), true, whole);
    image_free(&im);
}

/* Cells and tests, of which p.most is white, on a logarithmic scale. */
static inline vec3 see_work_log(const void *picture, real x, real y)
{
    const trial_picture *p = picture;
    search_work w = {0, 0, 0, 0};
    hit h;
    p->verbs->hit_counted(p->built, trial_eye_ray(p, x, y), &h, &w);
    return work_colour(log((real)(1 + w.nodes + w.tests)) / log(p->most));
}

/* Three panels, and below them the colours: the teapot; a grid; two levels. */
static inline void draw_stadium(const options *o)
{
    enum { gap = 6, bar = 44 };
    static const char *const title[3] = {"the small teapot, near", "one level: work a ray",
                                         "two levels: work a ray"};
    const real most = 1e5;
    int side = o->quick ? 60 : 300;
    image im = image_new(3 * side + 2 * gap, side), panel = image_new(side, side);
    trial_scene s;
    trial_row row[2] = {grid_row(&grid_candidate_list[3]), grid_row(&grid_candidate_list[6])};
    bool whole = true;
    trial_scene_of(stadium_mesh(o->quick ? 4 : 6), &s);
    for (int k = 0; k < 2; k++) trial_build(&row[k], &s);
    for (int k = 0; k < 3; k++) {
        const trial_row *r = &row[k != 1];
        trial_picture p = {r->verbs, r->built, &s.m, grid_stadium_camera(1), side, side, most};
        whole = pixels_draw(&panel, k ? 1 : 2, o->threads, "stadium",
                            k ? see_work_log : trial_mesh_colour, &p) && whole;
        image_place(&im, k * (side + gap), 0, &panel);
    }
    image sheet = label_panels(&im, 3, 1, gap, title);
    image all = image_new(sheet.width, sheet.height + bar);
    label_fill(&all, 0, 0, all.width, all.height, vec(1, 1, 1));
    image_place(&all, 0, 0, &sheet);
    label_bar(&all, side + gap, sheet.height + 6, 2 * side + gap, 9, work_colour, 1, (double)most,
              "cells and tests, logarithmic");
    output_picture(o, &all, "10_grid_stadium.png", false, whole);
    for (int k = 0; k < 2; k++) trial_unbuild(&row[k]);
    trial_scene_free(&s), image_free(&im), image_free(&panel), image_free(&sheet), image_free(&all);
}

#endif
