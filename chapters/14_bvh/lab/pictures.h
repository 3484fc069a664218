/* pictures.h: a mesh under the headlight, and what each pixel's ray took to find it. */
#ifndef BVH_PICTURES_H
#define BVH_PICTURES_H

#include "../../../common/image.h"
#include "../../../common/parallel.h"
#include "../../../common/headlight.h"
#include "../../../common/lab/heat.h"
#include "survey.h"

typedef struct { const bvh *b; const mesh *m; view v; image *im; int samples; real most; } picture;

static inline bool draw_mesh(picture p, int threads);    /* samples x samples rays a pixel */
static inline bool draw_visits(picture p, int threads);  /* black 0, white `most` nodes and tests */
static inline bool draw_all_visits(const mesh *m, int threads, image *all);  /* z up */

/* ---------------------------------------------------------------------------------------------- */

static inline ray picture_ray(const picture *p, real x, real y)
{
    return camera_ray(p->v.camera, x, y, p->im->width, p->im->height);
}

static inline void mesh_pixel(int x, int y, void *context)
{
    const picture *p = context;
    vec3 sum = {0, 0, 0}, background = {0.93, 0.93, 0.93};
    int n = p->samples;
    for (int k = 0; k < n * n; k++) {
        ray r = picture_ray(p, (real)x + ((real)(k % n) + (real)0.5) / (real)n,
                            (real)y + ((real)(k / n) + (real)0.5) / (real)n);
        hit h;
        bool found = bvh_hit(p->b, r, &h);
        sum = vadd(sum, found ? headlight(mesh_normal(p->m, h.shape, h.u, h.v), r.d) : background);
    }
    image_set(p->im, x, y, vscale(sum, 1 / (real)(n * n)));
}

static inline void visits_pixel(int x, int y, void *context)
{
    const picture *p = context;
    bvh_work w = {0, 0, 0, 0, 0};
    hit h;
    bvh_hit_counted(p->b, picture_ray(p, (real)x + (real)0.5, (real)y + (real)0.5), &h, &w);
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

/* Four panels: cycling axis, longest axis; median, SAH; leaves of four. */
static inline bool draw_all_visits(const mesh *m, int threads, image *all)
{
    vec3 lo, hi;
    bool whole = true;
    mesh_bounds(m, &lo, &hi);
    for (int k = 0; k < 4; k++) {
        bvh b;
        image im = image_new(all->width / 2, all->height / 2);
        bvh_build(m, (bvh_options){(bvh_strategy)k, 4, 1}, &b);
        view v = view_of(lo, hi, true, (real)im.width / (real)im.height);
        whole = draw_visits((picture){&b, m, v, &im, 1, 160}, threads) && whole;
        image_place(all, k % 2 * im.width, k / 2 * im.height, &im);
        bvh_free(&b), image_free(&im);
    }
    return whole;
}

#endif
