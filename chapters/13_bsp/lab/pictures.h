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

#include "../../09_aabb/trials/pictures.h"
#include "measure.h"

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

static inline vec3 slice_colour(const void *picture, real x, real y)
{
    const trial_picture *p = picture;
    const bsp *b = p->built;
    int up = vlongest(vabs(p->camera.v));
    vec3 at = b->middle, size = vsub(b->all.hi, b->all.lo);
    real w = (real)p->width, h = (real)p->height;
    real pixel = (real)1.02 * real_max(size.x / w, vaxis(size, up) / h);
    at.x += (x - w / 2) * pixel;
    at = vwith(at, up, vaxis(at, up) + (h / 2 - y) * pixel);
    if (!aabb_contains(b->all, at)) return (vec3){1, 1, 1};
    return cell_tint(b, leaf_of(b, vsub(at, b->middle)));
}

cold_inline bool draw_trees(const trial_scene *s, bool z_up, int threads, image *all)
{
    vec3 lo, hi;
    trial_panel panel[4];
    int gap = all->width > 32 && all->height > 32 ? 4 : 0;
    int w = (all->width - gap) / 2, h = (all->height - gap) / 2, x = w + 12, y = h + 12;
    mesh_bounds(&s->m, &lo, &hi);
    camera c = camera_of(lo, hi, z_up, (real)(all->width - gap) / (real)(all->height - gap));
    for (int k = 0; k < 4; k++)
        panel[k] = (trial_panel){s, &bsp_trial, bsp_row_list[k % 2 ? 3 : 2].how, c, 90,
                                 k < 2 ? 3 : 1, k < 2 ? slice_colour : trial_work_colour};
    bool whole = trial_draw_panels(all, 2, 2, gap, panel, true, threads);
    label_fill(all, w, 0, gap, all->height, vec(0, 0, 0));
    label_fill(all, 0, h, all->width, gap, vec(0, 0, 0));
    if (all->width >= 400) {
        label_tag(all, 8, 8, 11, "k-d tree: cells"), label_tag(all, x, 8, 11, "BSP tree: cells");
        label_tag(all, 8, y, 11, "k-d tree: work"), label_tag(all, x, y, 11, "BSP tree: work");
        label_fill(all, w / 4 - 8, h - 32, w / 2 + 16, 32, vec(1, 1, 1));
        label_bar(all, w / 4, h - 28, w / 2, 7, work_colour, 0, 90,
                  "steps and tests a ray; white: more");
    }
    return whole;
}

#endif
