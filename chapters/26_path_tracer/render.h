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

/* A row of a tile: of each of its pixels what all samples share, hashed once, and their sums. */
typedef struct { path_pixel half[film_side][2]; film_pixel sum[film_side]; } render_row;

/* Sample k of all pixels from (x0, y) to before x1. Their random numbers first: each of them is a
 * long chain of products, and side by side they don't wait for one another. Then what they see. */
static inline size_t render_samples(const render_job *j, render_row *row, film_window w, int y,
                                    uint32_t k, path_counts *c)
{
    path_random s[film_side];
    path_first p[film_side];
    size_t refused = 0;
    const film *f = j->pass.to;
    for (int i = 0; i < w.x1 - w.x0; i++)
        s[i] = path_sample(&row->half[i][k % 2], k / 2, 1u << 31);
    for (int i = 0; i < w.x1 - w.x0; i++) {
        point2 u = path_pair(&s[i]);
        ray eye = camera_ray(j->eye, (real)(w.x0 + i) + u.u, (real)y + u.v, f->width, f->height);
        path_see(j->tracer, eye, &p[i], c);
    }
    for (int i = 0; i < w.x1 - w.x0; i++) {
        vec3 L = path_follow(j->tracer, &p[i], &s[i], c);
        refused += !film_pixel_add(&row->sum[i], k, L);
    }
    return refused;
}

/* A row of a tile; how many pixels it has: 0 if it was stopped before its last sample. */
static inline int render_line(const render_job *j, film_window w, int y, path_counts *c,
                              size_t *refused)
{
    render_row row;
    const film_range now = j->pass.now;
    size_t at = (size_t)y * (size_t)j->pass.to->width + (size_t)w.x0, n = (size_t)(w.x1 - w.x0);
    for (uint32_t k = now.begin; k < now.end && k < now.begin + 2; k++)  /* one sample: one half */
        for (size_t i = 0; i < n; i++)
            path_pixel_of(&j->tracer->how, j->seed, 2 * (at + i) + k % 2, &row.half[i][k % 2]);
    memset(row.sum, 0, n * sizeof *row.sum);
    for (uint32_t k = now.begin; k < now.end; k++) {
        if (parallel_is_stopped()) return 0;
        *refused += render_samples(j, &row, w, y, k, c);
    }
    for (size_t i = 0; i < n; i++) film_gather(j->pass.to, at + i, &row.sum[i]);
    return w.x1 - w.x0;
}

static inline void render_tile(size_t tile, void *job)
{
    render_job *j = job;
    film *f = j->pass.to;
    path_counts c = {0};
    size_t refused = 0;
    film_window w = film_window_of(f, tile);
    for (int y = w.y0; y < w.y1; y++)
        f->done[tile] = (uint16_t)(f->done[tile] + render_line(j, w, y, &c, &refused));
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
