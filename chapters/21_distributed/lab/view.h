/* view.h: a picture of distributed rays, by all threads, and what was spent on it.
 *
 *   distributed_view v = {.w = &world, .how = &how, .c = camera, .lens = lens, ..};
 *   bool whole = distributed_draw(&v, &im, threads)     sums v.spent; false: Ctrl-C
 */
#ifndef DISTRIBUTED_VIEW_H
#define DISTRIBUTED_VIEW_H

#include "../../../common/image.h"
#include "../../../common/parallel.h"
#include "../distributed.h"

typedef struct { trace_counts rays; size_t drawn[drawn_kinds]; } distributed_counts;

typedef struct {
    const trace_world *w;
    const distributed *how;
    camera c;
    thin_lens lens;
    sequence_kind kind;
    uint64_t seed;
    uint32_t samples;
    distributed_counts spent; /* sums */
    pthread_mutex_t lock;     /* set by distributed_draw */
    image *im;
} distributed_view;

/* ---------------------------------------------------------------------------------------------- */

/* Sample k of pixel (x, y). A single sample is taken in the middle, as without a lens or a film. */
static inline vec3 distributed_camera(const distributed_view *v, distributor *d, int x, int y,
                                      uint32_t k)
{
    uint64_t pixel = (uint64_t)y * (uint64_t)v->im->width + (uint64_t)x;
    distributed_sample q = {v->kind, v->seed, pixel, k, v->samples};
    point2 film = distributed_pair(d, q, DRAWN_FILM, PAIR_FILM), lens = {0, 0};
    if (v->samples == 1) film = (point2){0.5, 0.5};
    if (v->lens.radius != 0 || d->how->spend_all)
        lens = distributed_pair(d, q, DRAWN_LENS, PAIR_LENS);
    ray r = lens_ray(v->c, v->lens, (real)x + film.u, (real)y + film.v, v->im->width,
                     v->im->height, lens);
    return distributed_ray(d, r, q);
}

static inline void distributed_pixel(int x, int y, void *context)
{
    distributed_view *v = context;
    distributor d = distributor_of(v->w, v->how);
    vec3 sum = {0, 0, 0};
    for (uint32_t k = 0; k < v->samples; k++) {
        if (parallel_is_stopped()) return;
        sum = vadd(sum, distributed_camera(v, &d, x, y, k));
    }
    image_set(v->im, x, y, vscale(sum, 1 / (real)v->samples));
    pthread_mutex_lock(&v->lock);
    trace_counts_add(&v->spent.rays, &d.t.counts);
    for (int i = 0; i < drawn_kinds; i++) v->spent.drawn[i] += d.drawn[i];
    pthread_mutex_unlock(&v->lock);
}

static inline bool distributed_draw(distributed_view *v, image *im, int threads)
{
    v->im = im;
    v->spent = (distributed_counts){.drawn = {0}};
    pthread_mutex_init(&v->lock, NULL);
    bool whole = parallel_pixels(im->width, im->height, threads, "drawing", distributed_pixel, v);
    pthread_mutex_destroy(&v->lock);
    return whole;
}

#endif
