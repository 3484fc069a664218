/* pictures.h: the pictures of this chapter.
 *
 *   draw_grid(o, &s, how, path)   a mesh, half of it in its cells; what each ray takes;
 *                                 path: where the mesh is from, y up; NULL: the book's, z up
 *   draw_early(o)         large triangles, where the first hit found is not the first hit
 *   draw_stadium(o)       what the teapot in the stadium takes: one level, two levels
 */
#ifndef GRID_PICTURES_H
#define GRID_PICTURES_H

#include "../../../common/output.h"
#include "../../09_aabb/trials/pictures.h"
#include "measure.h"

static const vec3 grid_paper = {0.93, 0.93, 0.93};

/* ---------------------------------------------------------------------------------------------- */

/* The boards in blue. */
static inline vec3 see_boards(const void *picture, real x, real y)
{
    const trial_picture *p = picture;
    ray r = trial_eye_ray(p, x, y);
    hit h = hit_none;
    if (!grid_hit(p->built, r, &h)) return grid_paper;
    return vmul(vec(0.35, 0.6, 0.9), headlight(mesh_normal(p->m, h.shape, h.u, h.v), r.d));
}

/* Orange: the first hit found is not the first. */
static inline vec3 see_early(const void *picture, real x, real y)
{
    const trial_picture *p = picture;
    ray r = trial_eye_ray(p, x, y);
    hit h = hit_none, e = hit_none;
    grid_hit(p->built, r, &h), grid_hit_early(p->built, r, &e);
    return e.shape == h.shape ? see_boards(picture, x, y) : vec(0.95, 0.3, 0);
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

/* The stadium's last triangles are the hall: grey, and the small teapot copper. */
static inline vec3 see_stadium(const void *picture, real x, real y)
{
    const trial_picture *p = picture;
    ray r = trial_eye_ray(p, x, y);
    hit h;
    if (!p->verbs->hit(p->built, r, &h)) return grid_paper;
    bool hall = h.shape >= p->m->triangles - 4032;  /* stadium.h */
    vec3 light = headlight(mesh_normal(p->m, h.shape, h.u, h.v), r.d);
    return vmul(vmul(light, light), hall ? vec(0.3, 0.4, 0.52) : vec(0.95, 0.62, 0.4));
}

/* Cells and tests, of which p.most is white, on a logarithmic scale. */
static inline vec3 see_work_log(const void *picture, real x, real y)
{
    const trial_picture *p = picture;
    search_work w = trial_eye_work(p, x, y);
    return work_colour(log((real)(1 + w.nodes + w.tests)) / log(p->most));
}

/* Panels in a row, titles above, and below the last `bars` of them a bar of colours, where words
 * find room. */
typedef struct {
    int width, height, panels, bars;
    const char *title[3];
    trial_panel panel[3];
} grid_sheet;

static inline void grid_draw(const options *o, const grid_sheet *g, const char *name, bool is_main)
{
    enum { bar = 44 };
    image im = image_new(g->width, g->height);
    int n = g->panels, gap = g->width >= 24 ? 6 : 0, w = (g->width + gap) / n * g->bars - gap;
    real most = g->panel[n - 1].most;
    bool whole = trial_draw_panels(&im, n, 1, gap, g->panel, is_main, o->threads);
    bool log = most > 1000;
    if (g->width >= 200 * n) label_titles(&im, n, 1, gap, g->title);
    if (g->width >= 200 * n && g->bars) {
        label_below(&im, bar);
        label_bar(&im, im.width - w + 4, im.height - bar + 6, w - 8, 9, work_colour, log,
                  (double)most, log ? "cells and tests, logarithmic" : "cells and tests");
    }
    output_picture(o, &im, name, is_main, whole);
    image_free(&im);
}

cold_inline void draw_grid(const options *o, const trial_scene *s, grid_options how,
                             const char *path)
{
    char name[512];
    vec3 lo, hi;
    int n = o->quick ? 1 : 2, gap = o->width >= 24 ? 6 : 0, width = (o->width - gap) / 2;
    grid_options coarse = how;
    coarse.density = real_max((real)how.density / 27, (real)1e-3);
    mesh_bounds(&s->m, &lo, &hi);
    camera c = camera_of(lo, hi, !path, (real)(width > 1 ? width : 1) / (real)o->height);
    const grid_sheet g = {
        o->width, o->height, 2, 1,
        {"cells that triangles touch, half of them taken off", "what each ray takes"},
        {{s, &grid_trial, &coarse, c, 1, n, see_cells},
         {s, &grid_trial, &how, c, 160, n, trial_work_colour}}};
    grid_draw(o, &g, picture_name("10_grid.png", path, name), true);
}

cold_inline void draw_early(const options *o)
{
    int width = o->quick ? 120 : 760, height = o->quick ? 60 : 330, n = o->quick ? 1 : 2;
    trial_scene s;
    trial_scene_of(grid_boards(60, o->seed), &s);
    camera c = trial_camera(&s.m, (real)(width / 2 - 3) / (real)height);
    const grid_sheet g = {width, height, 2, 0,
                          {"the first hit found: orange is wrong", "grid_hit"},
                          {{&s, &grid_trial, &grid_by_27, c, 1, n, see_early},
                           {&s, &grid_trial, &grid_by_27, c, 1, n, see_boards}}};
    grid_draw(o, &g, "10_grid_early.png", false);
    trial_scene_free(&s);
}

cold_inline void draw_stadium(const options *o)
{
    const real most = 1e5;
    int side = o->quick ? 60 : 240;
    trial_scene s;
    trial_scene_of(stadium_mesh(o->quick ? 4 : 5), &s);
    const camera c = grid_stadium_camera();
    const grid_sheet g = {
        3 * side + 12, side, 3, 2,
        {"the small teapot, near", "one level: work a ray", "two levels: work a ray"},
        {{&s, &nested_trial, &grid_two_levels, c, most, 2, see_stadium},
         {&s, &grid_trial, &grid_by_27, c, most, 1, see_work_log},
         {&s, &nested_trial, &grid_two_levels, c, most, 1, see_work_log}}};
    grid_draw(o, &g, "10_grid_stadium.png", false);
    trial_scene_free(&s);
}

#endif
