/* pictures.h: a mesh under the headlight, and what each pixel's ray took to find it.
 *
 *   draw_mesh(p, threads), draw_visits(p, threads)   into p.im; visits: black 0, white `most` nodes
 *                                                    and tests together
 *   draw_strategies(&m, z_up, threads, &all)         four panels: middle, median; SAH by boxes,
 *                                                    SAH clipped
 */
#ifndef KDTREE_PICTURES_H
#define KDTREE_PICTURES_H

#include "../../../common/image.h"
#include "../../../common/parallel.h"
#include "../../../common/headlight.h"
#include "../../../common/lab/heat.h"
#include "measure.h"

typedef struct { const kdtree *t; const mesh *m; camera v; image *im; real most; } picture;

/* ---------------------------------------------------------------------------------------------- */

static inline void mesh_pixel(int x, int y, void *context)
{
    enum { n = 3 };
    const picture *p = context;
    vec3 sum = {0, 0, 0}, background = {0.93, 0.93, 0.93};
    for (int k = 0; k < n * n; k++) {
        ray r = camera_ray(p->v, (real)x + ((real)(k % n) + (real)0.5) / n,
                           (real)y + ((real)(k / n) + (real)0.5) / n, p->im->width, p->im->height);
        hit h;
        bool found = kdtree_hit(p->t, r, &h);
        sum = vadd(sum, found ? headlight(mesh_normal(p->m, h.shape, h.u, h.v), r.d) : background);
    }
    image_set(p->im, x, y, vscale(sum, 1 / (real)(n * n)));
}

static inline void visits_pixel(int x, int y, void *context)
{
    const picture *p = context;
    search_work w = {0, 0, 0, 0};
    hit h;
    kdtree_hit_counted(p->t, camera_ray(p->v, (real)x + (real)0.5, (real)y + (real)0.5,
                                        p->im->width, p->im->height), &h, &w);
    image_set(p->im, x, y, work_colour((real)(w.nodes + w.tests) / p->most));
}

static inline bool draw_mesh(picture p, int threads)
{
    return parallel_pixels(p.im->width, p.im->height, threads, "picture", mesh_pixel, &p);
}

static inline bool draw_visits(picture p, int threads)
{
    return parallel_pixels(p.im->width, p.im->height, threads, "visits", visits_pixel, &p);
}

static inline bool draw_strategies(const mesh *m, bool z_up, int threads, image *all)
{
    vec3 lo, hi;
    bool whole = true;
    items x = items_of_mesh(m);
    mesh_bounds(m, &lo, &hi);
    for (int k = 0; k < 4; k++) {
        kdtree t;
        image im = image_new(all->width > 1 ? all->width / 2 : 1,
                             all->height > 1 ? all->height / 2 : 1);
        build_or_fail(&x, candidate_list[k].options, &t);
        camera v = camera_of(lo, hi, z_up, (real)im.width / (real)im.height);
        whole = draw_visits((picture){&t, m, v, &im, 120}, threads) && whole;
        image_place(all, k % 2 * im.width, k / 2 * im.height, &im);
        kdtree_free(&t), image_free(&im);
    }
    return whole;
}

#endif
