/* pictures.h: a slice through a tree's cells, and what each pixel's ray took.
 *
 *   bool draw_trees(&m, lo, hi, z_up, how, threads, &im)   four panels: cells across the axes, and
 *                                                    as `how` says (left, right); below, nodes and
 *                                                    tests of each pixel's ray, black 0, white 90
 *
 * Slice: upright, through the middle. Each cell has its own tint, darker the more triangles
 * it names; white cells name none.
 */
#ifndef BSP_PICTURES_H
#define BSP_PICTURES_H

#include "../bsp.h"
#include "../../../common/lab/heat.h"
#include "../../09_aabb/trials/survey.h"
#include "../../../common/image.h"
#include "../../../common/parallel.h"

typedef struct {
    const bsp *b;
    camera v;
    image *im;
    int up;                  /* axis: 1 or 2 */
    real x0, x1, up0, up1;   /* of the slice */
} tree_picture;

static inline bool draw_trees(const mesh *m, vec3 lo, vec3 hi, bool z_up, bsp_options how,
                              int threads, image *all);

/* ---------------------------------------------------------------------------------------------- */

/* The leaf that p, relative to the middle, lies in. */
static inline uint32_t leaf_of(const bsp *b, vec3 p)
{
    uint32_t at = 0;
    while (!(b->node[at].kind & bsp_leaf_bit)) {
        const bsp_node *n = &b->node[at];
        real s = n->kind < 3 ? vaxis(p, (int)n->kind)
                             : vdot(b->normal[n->kind & ~bsp_slanted_bit], p);
        at = n->first + (s > n->at);
    }
    return at;
}

static inline vec3 cell_tint(const bsp *b, uint32_t leaf)
{
    uint64_t bits = random_bits(5, leaf, 0, 0);
    uint32_t n = b->node[leaf].kind & ~bsp_leaf_bit;
    real tint[3], dark = n == 0 ? 1 : n < 3 ? (real)0.6 : n < 6 ? (real)0.4 : (real)0.22;
    for (int k = 0; k < 3; k++)
        tint[k] = dark * ((real)0.8 + (real)0.2 * (real)(bits >> (20 * k) & 255) / 255);
    if (n) tint[0] *= (real)0.45, tint[1] *= (real)0.75;  /* blue */
    return (vec3){tint[0], tint[1], tint[2]};
}

static inline void slice_pixel(int x, int y, void *context)
{
    const tree_picture *p = context;
    vec3 sum = {0, 0, 0};
    for (int k = 0; k < 9; k++) {
        real u = ((real)x + ((real)(k % 3) + (real)0.5) / 3) / (real)p->im->width;
        real v = ((real)y + ((real)(k / 3) + (real)0.5) / 3) / (real)p->im->height;
        vec3 at = aabb_center(p->b->all);
        at.x = p->x0 + u * (p->x1 - p->x0);
        *(p->up == 1 ? &at.y : &at.z) = p->up1 - v * (p->up1 - p->up0);
        if (!aabb_contains(p->b->all, at)) continue;
        sum = vmadd(sum, cell_tint(p->b, leaf_of(p->b, vsub(at, p->b->middle))), (real)1 / 9);
    }
    image_set(p->im, x, y, sum);
}

static inline void work_pixel(int x, int y, void *context)
{
    const tree_picture *p = context;
    search_work w = {0, 0, 0, 0};
    hit h;
    ray r = camera_ray(p->v, (real)x + (real)0.5, (real)y + (real)0.5, p->im->width,
                       p->im->height);
    bsp_hit_counted(p->b, r, &h, &w);
    image_set(p->im, x, y, work_colour((real)(w.nodes + w.tests) / 90));
}

/* Two panels and four pixels between them; in a tiny picture they touch, or the last one covers. */
static inline int panel_side(int side) { return side > 32 ? side / 2 - 2 : (side + 1) / 2; }

static inline bool draw_trees(const mesh *m, vec3 lo, vec3 hi, bool z_up, bsp_options how,
                              int threads, image *all)
{
    bool whole = true;
    int up = z_up ? 2 : 1;
    items x = items_of_mesh(m);
    failure f;
    for (int k = 0; k < 2; k++) {
        bsp b;
        bsp_options across = how;
        across.rule = BSP_AXIS;
        if (!bsp_build(&x, k ? how : across, &b, &f)) fail(f);
        image im = image_new(panel_side(all->width), panel_side(all->height));
        real aspect = (real)im.width / (real)im.height;
        real tall = vaxis(hi, up) - vaxis(lo, up), low = (vaxis(hi, up) + vaxis(lo, up)) / 2;
        real half = (real)0.51 * real_max(hi.x - lo.x, tall * aspect), left = (lo.x + hi.x) / 2;
        tree_picture p = {&b, camera_of(lo, hi, z_up, aspect), &im, up, left - half, left + half,
                          low - half / aspect, low + half / aspect};
        whole = parallel_pixels(im.width, im.height, threads, "cells", slice_pixel, &p) && whole;
        image_place(all, k * (all->width - im.width), 0, &im);
        whole = parallel_pixels(im.width, im.height, threads, "work", work_pixel, &p) && whole;
        image_place(all, k * (all->width - im.width), all->height - im.height, &im);
        image_free(&im);
        bsp_free(&b);
    }
    return whole;
}

#endif
