/* pictures.h: a slice through a tree's cells, and what each pixel's ray took.
 *
 *   bool draw_trees(&s, z_up, threads, &im)   four panels: cells across the axes, and of planes of
 *                                             any direction (left, right); below, nodes and tests
 *                                             of each pixel's ray, black 0, white 90 and more
 *
 * Slice: upright, through the middle. Each cell has its own tint, darker the more triangles
 * it names; pale cells name none.
 */
#ifndef BSP_PICTURES_H
#define BSP_PICTURES_H

#include "../../../common/lab/label.h"
#include "../../09_aabb/trials/pictures.h"
#include "measure.h"

typedef struct {
    const bsp *b;
    int width, height, up;   /* of the panel; axis: 1 or 2 */
    real x0, x1, up0, up1;   /* of the slice */
} bsp_slice;

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

static inline vec3 slice_colour(const void *slice, real x, real y)
{
    const bsp_slice *p = slice;
    vec3 at = aabb_centre(p->b->all);
    at.x = p->x0 + x / (real)p->width * (p->x1 - p->x0);
    at = vwith(at, p->up, p->up1 - y / (real)p->height * (p->up1 - p->up0));
    if (!aabb_contains(p->b->all, at)) return (vec3){1, 1, 1};
    return cell_tint(p->b, leaf_of(p->b, vsub(at, p->b->middle)));
}

/* Two panels and four pixels between them; in a tiny picture they touch, or the last one covers. */
static inline int panel_side(int side) { return side > 32 ? side / 2 - 2 : (side + 1) / 2; }

cold_inline bool draw_trees(const trial_scene *s, bool z_up, int threads, image *all)
{
    bool whole = true;
    vec3 lo, hi;
    int x = all->width / 2 + 10, y = all->height / 2 + 10;
    int up = z_up ? 2 : 1, side = 1;
    if (!mesh_bounds(&s->m, &lo, &hi)) lo = hi = (vec3){0, 0, 0};
    if (vzero(vsub(hi, lo)))  /* a point: something to look at all the same */
        lo = vsub(lo, (vec3){1, 1, 1}), hi = vadd(hi, (vec3){1, 1, 1});
    for (int k = 0; k < 2 && whole; k++) {
        trial_row r = bsp_row_list[k ? 3 : 2];  /* cost, axis */
        trial_build(&r, s);
        image im = image_new(panel_side(all->width), panel_side(all->height));
        real aspect = (real)im.width / (real)im.height;
        real tall = vaxis(hi, up) - vaxis(lo, up), low = (vaxis(hi, up) + vaxis(lo, up)) / 2;
        real half = (real)0.51 * real_max(hi.x - lo.x, tall * aspect), left = (lo.x + hi.x) / 2;
        bsp_slice slice = {r.built, im.width, im.height, up, left - half, left + half,
                           low - half / aspect, low + half / aspect};
        camera c = camera_of(lo, hi, z_up, aspect);
        trial_picture p = {&bsp_trial, r.built, &s->m, c, im.width, im.height, 90};
        whole = pixels_draw(&im, 3, threads, "cells", slice_colour, &slice);
        image_place(all, k * (all->width - im.width), 0, &im);
        whole = whole && trial_draw(&im, &side, threads, "work", trial_work_colour, p);
        image_place(all, k * (all->width - im.width), all->height - im.height, &im);
        image_free(&im);
        trial_unbuild(&r);
    }
    if (all->width >= 400) {
        label_tag(all, 8, 8, 11, "k-d tree: cells"), label_tag(all, x, 8, 11, "BSP tree: cells");
        label_tag(all, 8, y, 11, "k-d tree: work"), label_tag(all, x, y, 11, "BSP tree: work");
        int w = panel_side(all->width), bottom = panel_side(all->height);
        label_fill(all, w / 4 - 8, bottom - 32, w / 2 + 16, 32, vec(1, 1, 1));
        label_bar(all, w / 4, bottom - 28, w / 2, 7, work_colour, 0, 90,
                  "steps and tests a ray; white: more");
    }
    return whole;
}

#endif
