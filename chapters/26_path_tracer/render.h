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
#include "../20_monte_carlo/passes.h"
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

/* Some rows of a tile, of n pixels: places in the film, what all samples of each pixel share,
 * hashed once, and their sums. */
enum { render_rows = 4, render_most = render_rows * film_side };
typedef struct {
    int n, x[render_most], y[render_most];
    path_pixel half[2][render_most];
    film_pixel sum[render_most];
} render_strip;

_Static_assert((int)render_most <= (int)path_row_most, "a strip's paths go side by side");

static inline size_t render_place(const render_job *j, const render_strip *p, int i)
{
    return (size_t)p->y[i] * (size_t)j->pass.to->width + (size_t)p->x[i];
}

/* Rows y to y + render_rows - 1, as far as the tile goes. */
static inline void render_begin(const render_job *j, film_window w, int y, render_strip *p)
{
    const film_range now = j->pass.now;
    p->n = 0;
    for (int row = y; row < y + render_rows && row < w.y1; row++)
        for (int x = w.x0; x < w.x1; x++) p->x[p->n] = x, p->y[p->n++] = row;
    for (uint32_t k = now.begin; k < now.end && k < now.begin + 2; k++)  /* one sample: one half */
        for (int i = 0; i < p->n; i++)
            path_pixel_of(&j->tracer->how, j->seed, 2 * render_place(j, p, i) + k % 2,
                          &p->half[k % 2][i]);
    memset(p->sum, 0, (size_t)p->n * sizeof *p->sum);
}

/* Sample k of all pixels. */
static inline size_t render_samples(const render_job *j, render_strip *p, uint32_t k,
                                    path_counts *c)
{
    path_random s[render_most];
    path_walk walk[render_most];
    size_t refused = 0;
    const film *f = j->pass.to;
    path_samples(p->half[k % 2], p->n, k / 2, 1u << 31, s);
    for (int i = 0; i < p->n; i++) {
        point2 u = path_pair(&s[i]);
        path_begin(&walk[i], camera_ray(j->eye, (real)p->x[i] + u.u, (real)p->y[i] + u.v,
                                        f->width, f->height));
    }
    path_row(j->tracer, walk, s, p->n, c);
    for (int i = 0; i < p->n; i++) refused += !film_pixel_add(&p->sum[i], k, walk[i].L);
    return refused;
}

/* From row y on; how many pixels are done: none if it was stopped before its last sample. */
static inline int render_rows_of(const render_job *j, film_window w, int y, path_counts *c,
                                 size_t *refused)
{
    render_strip p;
    render_begin(j, w, y, &p);
    for (uint32_t k = j->pass.now.begin; k < j->pass.now.end; k++) {
        if (parallel_is_stopped()) return 0;
        *refused += render_samples(j, &p, k, c);
    }
    for (int i = 0; i < p.n; i++) film_gather(j->pass.to, render_place(j, &p, i), &p.sum[i]);
    return p.n;
}

static inline void render_tile(size_t tile, void *job)
{
    render_job *j = job;
    film *f = j->pass.to;
    path_counts c = {0};
    size_t refused = 0;
    film_window w = film_window_of(f, tile);
    for (int y = w.y0; y < w.y1; y += render_rows)
        f->done[tile] = (uint16_t)(f->done[tile] + render_rows_of(j, w, y, &c, &refused));
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
