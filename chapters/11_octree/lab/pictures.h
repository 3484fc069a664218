/* pictures.h: a mesh with the cells of its octree upon it, the work a pixel, and what goes wrong.
 *
 *   draw_cells(p, threads)      the colour of a point: how deep its leaf is; lines: its sides
 *   draw_work(p, threads)       black nothing, white p.most nodes and tests of items
 *   draw_faults(o)              the textbook's walk beside octree_hit; orange where it is wrong
 */
#ifndef OCTREE_PICTURES_H
#define OCTREE_PICTURES_H

#include "../../../common/parallel.h"
#include "../../../common/headlight.h"
#include "../../../common/lab/heat.h"
#include "measure.h"

typedef struct {
    const octree *t;
    const mesh *m;
    camera camera;
    image *im;
    int samples;  /* a pixel, along each side */
    real most;
} octree_picture;

static inline bool draw_cells(octree_picture p, int threads);
static inline bool draw_work(octree_picture p, int threads);
static inline void draw_faults(const options *o);

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
        {0.5, 0.4, 0.75}, {0.25, 0.45, 0.85},
        {0.25, 0.7, 0.85}, {0.25, 0.75, 0.45},
        {0.6, 0.8, 0.3}, {0.95, 0.85, 0.3},
        {0.95, 0.55, 0.2}, {0.85, 0.25, 0.2}};
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

static inline ray octree_picture_ray(const octree_picture *p, real x, real y)
{
    return camera_ray(p->camera, x, y, p->im->width, p->im->height);
}

static inline void cells_pixel(int x, int y, void *context)
{
    const octree_picture *p = context;
    vec3 sum = {0, 0, 0};
    int s = p->samples;
    real pixel = vlength(vsub(octree_picture_ray(p, (real)x + 1, (real)y).d,
                              octree_picture_ray(p, (real)x, (real)y).d));
    for (int k = 0; k < s * s; k++) {
        ray r = octree_picture_ray(p, (real)x + ((real)(k % s) + (real)0.5) / (real)s,
                                   (real)y + ((real)(k / s) + (real)0.5) / (real)s);
        vec3 c = {0.93, 0.93, 0.93};
        hit h;
        int depth;
        if (octree_hit(p->t, r, &h)) {
            vec3 at = ray_at(r, h.t), n = triangle_normal(mesh_triangle(p->m, h.shape));
            aabb leaf = octree_leaf_at(p->t, at, &depth);
            bool line = side_distance(leaf, at, n) < (real)0.5 * pixel * h.t;
            c = headlight(mesh_normal(p->m, h.shape, h.u, h.v), r.d);
            c = vmul(vadd(vscale(c, 0.8), vec(0.2, 0.2, 0.2)),
                     depth_colour(depth));
            if (line) c = vscale(c, 0.35);
        }
        sum = vmadd(sum, c, 1 / (real)(s * s));
    }
    image_set(p->im, x, y, sum);
}

static inline bool draw_cells(octree_picture p, int threads)
{
    return parallel_pixels(p.im->width, p.im->height, threads, "cells", cells_pixel, &p);
}

static inline void work_pixel(int x, int y, void *context)
{
    const octree_picture *p = context;
    search_work w = {0, 0, 0, 0};
    hit h;
    octree_hit_counted(p->t, octree_picture_ray(p, (real)x + (real)0.5, (real)y + (real)0.5), &h,
                       &w);
    image_set(p->im, x, y, work_colour((real)(w.nodes + w.tests) / p->most));
}

static inline bool draw_work(octree_picture p, int threads)
{
    return parallel_pixels(p.im->width, p.im->height, threads, "work", work_pixel, &p);
}

/* ---- textbook beside octree_hit ---- */

typedef struct { octree_picture p; octree_search *search; } faulty_picture;

static inline void fault_pixel(int x, int y, void *context)
{
    const faulty_picture *f = context;
    const vec3 background = {0.93, 0.93, 0.93};
    const vec3 wrong = {0.85, 0.25, 0};
    ray r = octree_picture_ray(&f->p, (real)x, (real)y);
    hit h = hit_none, truth = hit_none;
    f->search(f->p.t, r, &h), octree_hit(f->p.t, r, &truth);
    vec3 c = background;
    if (h.shape != no_shape) c = headlight(triangle_normal(mesh_triangle(f->p.m, h.shape)), r.d);
    if (h.shape != truth.shape || h.t != truth.t) c = vmadd(vscale(c, 0.3), wrong, 0.8);
    image_set(f->p.im, x, y, c);
}

/* Above 60 large triangles in perspective, below the teapot along an axis, by orthographic rays:
 * left the textbook's walk, right octree_hit. */
static inline void draw_faults(const options *o)
{
    enum { panel_width = 384, panel_height = 256, gap = 6 };
    octree_search *search[2] = {octree_hit_textbook, octree_hit};
    image all = image_new(2 * panel_width + gap, 2 * panel_height + gap);
    image im = image_new(panel_width, panel_height);
    mesh m[2] = {octree_soup(60, 2, 5), teapot_mesh(10)};
    camera c[2];
    camera_frame frame;
    failure f;
    bool whole = true;
    c[0] = camera_of((vec3){0, 0, 0}, (vec3){4, 4, 4}, true, 1.5);
    if (!frame_look_at(vec(0, -10, 1.5), vec(0, 0, 1.5), (vec3){0, 0, 1}, &frame,
                       &f)
        || !camera_orthographic(frame, (camera_window){-4, 4, -2.5, 2.83}, &c[1], &f))
        fail(f);
    for (int y = 0; y < all.height; y++)
        for (int i = 0; i < all.width; i++) image_set(&all, i, y, (vec3){1, 1, 1});
    for (int row = 0; row < 2; row++) {
        items x = items_of_mesh(&m[row]);
        octree t;
        if (!octree_build(&x, (octree_options){4, 6, true, true, (size_t)1 << 28}, &t, &f)) fail(f);
        for (int k = 0; k < 2; k++) {
            faulty_picture p = {{&t, &m[row], c[row], &im, 1, 0}, search[k]};
            whole = parallel_pixels(panel_width, panel_height, o->threads, "faults", fault_pixel,
                                    &p) && whole;
            image_place(&all, k * (panel_width + gap), row * (panel_height + gap), &im);
        }
        octree_free(&t);
        mesh_free(&m[row]);
    }
    output_picture(o, &all, "11_octree_faults.png", false, whole);
    image_free(&all), image_free(&im);
}

#endif
