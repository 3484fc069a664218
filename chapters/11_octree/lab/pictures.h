/* pictures.h: a mesh with the cells of its octree upon it, the work a pixel, and what goes wrong.
 *
 *   draw_octree(o, &s, path)        the colour of a point: how deep its leaf is; lines: its sides.
 *                                   The book's own scene (path NULL): the work of each pixel, too
 *   draw_faults(o)                  the textbook's walk beside octree_hit; orange where it is wrong
 */
#ifndef OCTREE_PICTURES_H
#define OCTREE_PICTURES_H

#include "../../../common/output.h"
#include "../../09_aabb/trials/pictures.h"
#include "measure.h"

enum { octree_most_work = 100 };  /* nodes and tests: white */

/* ---------------------------------------------------------------------------------------------- */

/* The leaf in which p lies, and its depth; p on a wall: the upper one. */
static inline aabb octree_leaf_at(const octree *t, vec3 p, int *depth)
{
    octree_cell c = {0, 0, 0, 0};
    octree_node n = t->node[0];
    while (n.kind && !(n.kind & octree_is_leaf)) {
        vec3 wall = octree_cell_box(t, octree_child_cell(c, 7)).lo;
        unsigned k = (p.x >= wall.x ? 1u : 0) | (p.y >= wall.y ? 2u : 0) | (p.z >= wall.z ? 4u : 0);
        n = t->node[n.first + k];
        c = octree_child_cell(c, k);
    }
    *depth = c.depth;
    return octree_cell_box(t, c);
}

/* Depth 0 to 15 as a colour: from violet by blue, green and yellow to red, twice. */
static inline vec3 depth_colour(int depth)
{
    static const real c[8][3] = {
        {0.5, 0.4, 0.75}, {0.25, 0.45, 0.85}, {0.25, 0.7, 0.85}, {0.25, 0.75, 0.45},
        {0.6, 0.8, 0.3}, {0.95, 0.85, 0.3}, {0.95, 0.55, 0.2}, {0.85, 0.25, 0.2}};
    const real *k = c[depth % 8];
    return (vec3){k[0], k[1], k[2]};
}

/* How near p is to a side of the box that its surface, of normal n, crosses [as a length]. */
static inline real side_distance(aabb b, vec3 p, vec3 n)
{
    real d = real_infinity;
    for (int k = 0; k < 3; k++) {
        real slope = sqrt(real_max(1 - vaxis(n, k) * vaxis(n, k), 1e-4));
        real side = real_min(vaxis(p, k) - vaxis(b.lo, k), vaxis(b.hi, k) - vaxis(p, k));
        d = real_min(side / slope, d);
    }
    return d;
}

/* With lines, a pixel wide, where a side of a cell meets the surface. */
static inline vec3 cells_colour(const void *picture, real x, real y)
{
    const trial_picture *p = picture;
    const octree *t = p->built;
    real left = floor(x), top = floor(y);
    ray r = trial_eye_ray(p, x, y);
    hit h;
    int depth;
    if (!octree_hit(t, r, &h)) return vec(0.93, 0.93, 0.93);
    real pixel = vlength(vsub(trial_eye_ray(p, left + 1, top).d, trial_eye_ray(p, left, top).d));
    vec3 at = ray_at(r, h.t), n = triangle_normal(mesh_triangle(p->m, h.shape));
    aabb leaf = octree_leaf_at(t, at, &depth);
    vec3 c = headlight(mesh_normal(p->m, h.shape, h.u, h.v), r.d);
    c = vmul(vadd(vscale(c, 0.8), vec(0.2, 0.2, 0.2)), depth_colour(depth));
    return side_distance(leaf, at, n) < (real)0.5 * pixel * h.t ? vscale(c, 0.35) : c;
}

/* What the colours mean, below the picture, where there is room for words: of depths, of work. */
static inline image octree_legend(const image *im, bool depths)
{
    enum { first = 3, last = 10 };
    bool room = im->width >= 400;
    image sheet = label_sheet(im->width, im->height + (room ? 40 : 0));
    image_place(&sheet, 0, 0, im);
    double x = 20, y = im->height + 20;
    if (room && !depths)
        label_bar(&sheet, 20, im->height + 4, im->width - 40, 9, work_colour, 0, octree_most_work,
                  "nodes and tests of a ray");
    if (!room || !depths) return sheet;
    label_text(&sheet, x, y, 10, 0, vec(0, 0, 0), "cuts to the leaf:");
    x += label_width("cuts to the leaf:", 10) + 20;
    for (int d = first; d <= last; d++, x += 45) {
        char text[12];
        snprintf(text, sizeof text, "%d", d);
        label_fill(&sheet, (int)x, (int)y - 11, 16, 14, depth_colour(d));
        label_text(&sheet, x + 21, y, 10, 0, vec(0, 0, 0), text);
    }
    return sheet;
}

cold_inline void draw_octree(const options *o, const trial_scene *s, const char *path)
{
    const octree_options how = octree_defaults;
    vec3 lo, hi;
    char name[512];
    int side = o->quick ? 1 : 3;
    trial_row r = {.verbs = &octree_trial, .how = &how};
    image im = image_new(o->width, o->height);
    trial_time_build(&r, s, 1);
    mesh_bounds(&s->m, &lo, &hi);
    camera c = camera_of(lo, hi, !path, (real)o->width / (real)o->height);
    trial_picture p = {&octree_trial, r.built, &s->m, c, im.width, im.height,
                       octree_most_work};
    bool whole = trial_draw(&im, &side, o->threads, "cells", cells_colour, p);
    structure_stats st = octree_stats(r.built);
    printf("# %zu triangles: octree of depth %d in %.3f s, %zu leaves, %.1f %% of them empty, "
           "%.2f references a shape, %.1f bytes\n", s->m.triangles, st.depth, r.build, st.leaves,
           100 * (double)st.empty / (double)st.leaves,
           trial_per((double)st.references, st.items), trial_per((double)st.bytes, st.items));
    image sheet = octree_legend(&im, true);
    output_picture(o, &sheet, picture_name("11_octree.png", path, name), true, whole);
    if (!o->out && !o->own) {
        whole = pixels_draw(&im, 1, o->threads, "work", trial_work_colour, &p);
        image_free(&sheet), sheet = octree_legend(&im, false);
        output_picture(o, &sheet, "11_octree_work.png", false, whole);
    }
    trial_unbuild(&r), image_free(&im), image_free(&sheet);
}

/* ---- textbook beside octree_hit ---- */

/* Through the upper left corners of the pixels, where rays meet corners of the mesh. */
static inline vec3 fault_colour(const void *picture, real x, real y)
{
    const trial_picture *p = picture;
    ray r = trial_eye_ray(p, floor(x), floor(y));
    hit h = hit_none, truth = hit_none;
    vec3 c = {0.93, 0.93, 0.93};
    p->verbs->hit(p->built, r, &h), octree_hit(p->built, r, &truth);
    if (h.shape != truth.shape || h.t != truth.t) return vec(0.95, 0.3, 0);
    if (h.shape != no_shape) {
        vec3 grey = headlight(triangle_normal(mesh_triangle(p->m, h.shape)), r.d);
        c = vmul(vec(0.35, 0.6, 0.9), grey);
    }
    return c;
}

/* Above 60 large triangles in perspective, below the teapot along an axis, by orthographic rays:
 * left the textbook's walk, right octree_hit. */
cold_inline void draw_faults(const options *o)
{
    static const octree_options how = {4, 6, true, true, (size_t)1 << 28};
    static const char *const title[4] = {
        "large triangles, textbook: orange is wrong", "octree_hit",
        "the teapot, rays along y, textbook", "octree_hit"};
    image all = image_new(774, 518);
    trial_scene s[2];
    trial_panel panel[4];
    camera_frame frame;
    failure f;
    camera c[2] = {camera_of((vec3){-1.4, -1.4, -1.4}, (vec3){1.4, 1.4, 1.4}, true, 1.5)};
    if (!frame_look_at(vec(0, -10, 1.5), vec(0, 0, 1.5), (vec3){0, 0, 1}, &frame, &f)
        || !camera_orthographic(frame, (camera_window){-4, 4, -2.5, 2.83}, &c[1], &f)) fail(f);
    trial_scene_of(soup_mesh(60, 1, 1, 5), &s[0]), trial_scene_of(teapot_mesh(10), &s[1]);
    for (int k = 0; k < 4; k++)
        panel[k] = (trial_panel){&s[k / 2], k % 2 ? &octree_trial : &octree_textbook_trial, &how,
                                 c[k / 2], 0, 1, fault_colour};
    bool whole = trial_draw_panels(&all, 2, 2, 6, panel, false, o->threads);
    label_titles(&all, 2, 2, 6, title);
    output_picture(o, &all, "11_octree_faults.png", false, whole);
    trial_scene_free(&s[0]), trial_scene_free(&s[1]), image_free(&all);
}

#endif
