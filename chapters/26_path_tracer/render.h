/* render.h: the passes of a film (passes.h) by paths.
 *
 *   render_job j = {.tracer = &t, .eye = camera, .seed = 1, .threads = 0};
 *   film f = film_new(w, h);
 *   bool whole = passes_range(render_passes(&j), &f, a, b);     and passes_until
 *
 * The sample k of pixel i uses the random numbers of (seed, i, k) alone (film.h: halves).
 */
#ifndef PATH_RENDER_H
#define PATH_RENDER_H

#include "../02_camera/camera.h"
#include "passes.h"
#include "path.h"

typedef struct {
    const path_tracer *tracer;
    camera eye;
    uint64_t seed;
    int threads;
    path_counts counts;     /* of all that was done */
    size_t refused;         /* samples that were not numbers: none, ever */
    film_passes pass;
} render_job;

/* ---------------------------------------------------------------------------------------------- */

/* The samples of one pixel; false: stopped before the last. What they share is hashed once; their
 * sums are local. */
static inline bool render_pixel(const render_job *j, film *f, int x, int y, path_counts *c,
                                size_t *refused)
{
    size_t i = (size_t)y * (size_t)f->width + (size_t)x;
    path_pixel half[2];
    film_pixel sum = {{{{{0, 0}}}}};
    const film_range now = j->pass.now;
    for (uint32_t k = now.begin; k < now.end && k < now.begin + 2; k++)  /* one sample: one half */
        path_pixel_of(&j->tracer->how, j->seed, 2 * i + k % 2, &half[k % 2]);
    for (uint32_t k = now.begin; k < now.end; k++) {
        if (parallel_is_stopped()) return false;
        path_random s = path_sample(&half[k % 2], k / 2, 1u << 31);
        point2 u = path_pair(&s);
        ray eye = camera_ray(j->eye, (real)x + u.u, (real)y + u.v, f->width, f->height);
        *refused += !film_pixel_add(&sum, k, path_radiance(j->tracer, eye, &s, c));
    }
    film_gather(f, i, &sum);
    return true;
}

static inline void render_tile(size_t tile, void *job)
{
    render_job *j = job;
    film *f = j->pass.to;
    path_counts c = {0};
    size_t refused = 0;
    film_window w = film_window_of(f, tile);
    for (int y = w.y0; y < w.y1; y++)
        for (int x = w.x0; x < w.x1; x++)
            f->done[tile] += render_pixel(j, f, x, y, &c, &refused);
    pthread_mutex_lock(&j->pass.lock);
    path_counts_add(&j->counts, &c);
    j->refused += refused;
    pthread_mutex_unlock(&j->pass.lock);
}

static inline film_passes *render_passes(render_job *j)
{
    j->pass.tile = render_tile, j->pass.job = j, j->pass.threads = j->threads;
    return &j->pass;
}

#endif
