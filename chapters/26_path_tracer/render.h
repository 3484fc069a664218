/* render.h: a picture by passes: until it has so many samples, is so good, or took so long.
 *
 *   render_job j = {.tracer = &t, .eye = camera, .seed = 1, .threads = 0};
 *   film f = film_new(w, h);
 *   bool whole = render_range(&j, &f, a, b);        samples a .. b-1 of every pixel; false: Ctrl-C
 *   bool whole = render_until(&j, &f, goal);        passes, from where the film ends
 *
 *   goal            ends
 *   .samples = N    when every pixel has samples 0 .. N-1
 *   .error = e      at the first pass with film_error <= e, and 16 samples; .samples: most
 *   .seconds = s    when the next pass would take longer than what is left; at least one sample
 *
 * Each pass doubles the samples, so that what it shows is worth showing. Near its end an error
 * needs n (error now / e)^2 samples: that many are next, if less than the double. The number does
 * not depend on time or threads, and neither does a picture with as many samples.
 * goal.shown(&f, user) is called after each pass [may be NULL].
 *
 * The sample k of pixel i uses the random numbers of (seed, i, k) alone (film.h: halves).
 */
#ifndef PATH_RENDER_H
#define PATH_RENDER_H

#include "../02_camera/camera.h"
#include "../../common/parallel.h"
#include "film.h"
#include "path.h"

typedef struct {
    const path_tracer *tracer;
    camera eye;
    uint64_t seed;
    int threads;
    path_counts counts;     /* of all that was done */
    size_t refused;         /* samples that were not numbers: none, ever */
    double seconds;         /* spent in passes */
    film *to;
    film_range now;
    pthread_mutex_t lock;
} render_job;

typedef struct {
    uint32_t samples;
    double error, seconds;
    void (*shown)(const film *f, void *user);
    void *user;
} render_goal;

/* ---------------------------------------------------------------------------------------------- */

/* The samples of one pixel. What they share is hashed once; their sums are local. */
static inline size_t render_pixel(const render_job *j, film *f, int x, int y, path_counts *c)
{
    size_t i = (size_t)y * (size_t)f->width + (size_t)x, refused = 0;
    path_pixel half[2];
    film_pixel sum = {{{{{0, 0}}}}};
    for (uint64_t k = 0; k < 2; k++)
        path_pixel_of(&j->tracer->how, j->seed, 2 * i + k, &half[k]);
    for (uint32_t k = j->now.begin; k < j->now.end; k++) {
        path_random s = path_sample(&half[k % 2], k / 2, 1u << 31);
        point2 u = path_pair(&s);
        ray eye = camera_ray(j->eye, (real)x + u.u, (real)y + u.v, f->width, f->height);
        refused += !film_pixel_add(&sum, k, path_radiance(j->tracer, eye, &s, c));
    }
    film_gather(f, i, &sum);
    return refused;
}

static inline void render_tile(size_t tile, void *job)
{
    render_job *j = job;
    film *f = j->to;
    path_counts c = {0};
    size_t refused = 0;
    int x0 = (int)(tile % film_across(f)) * film_side;
    int y0 = (int)(tile / film_across(f)) * film_side;
    for (int y = y0; y < y0 + film_side && y < f->height; y++)
        for (int x = x0; x < x0 + film_side && x < f->width; x++)
            refused += render_pixel(j, f, x, y, &c);
    f->tile[tile] = true;
    pthread_mutex_lock(&j->lock);
    path_counts_add(&j->counts, &c);
    j->refused += refused;
    pthread_mutex_unlock(&j->lock);
}

static inline bool render_range(render_job *j, film *f, uint32_t begin, uint32_t end)
{
    failure why;
    double start = clock_seconds();
    if (begin >= end) return true;
    j->to = f, j->now = f->pending = (film_range){begin, end};
    memset(f->tile, 0, film_tiles(f) * sizeof *f->tile);
    pthread_mutex_init(&j->lock, NULL);
    bool whole = parallel_for(film_tiles(f), j->threads, "samples", render_tile, j);
    pthread_mutex_destroy(&j->lock);
    j->seconds += clock_seconds() - start;
    if (!whole) return false;
    memset(f->tile, 0, film_tiles(f) * sizeof *f->tile);
    if (!film_cover(f, begin, end, &why)) fail(why);
    return true;
}

/* How many samples the picture is to have after the next pass. */
static inline uint32_t render_next(const render_job *j, const film *f, const render_goal *g,
                                   double begun)
{
    uint64_t n = film_samples(f), next = n ? 2 * n : 1;
    double now = film_error(f), done = (double)j->counts.paths / ((double)f->width * f->height);
    if (g->error > 0 && n >= 8 && now > g->error) {
        double wanted = (double)n * (now / g->error) * (now / g->error) * 1.02 + 1;
        if (wanted < (double)next) next = wanted > (double)n + 1 ? (uint64_t)wanted : n + 1;
    }
    if (g->seconds > 0 && n > 0) {  /* what is left, at the speed so far, and a margin */
        double left = g->seconds * 0.97 - (clock_seconds() - begun);
        double more = done > 0 ? left * done / j->seconds : (double)n;
        if (more < (double)(next - n)) next = n + (more >= 1 ? (uint64_t)more : 0);
    }
    return next < g->samples ? (uint32_t)next : g->samples;
}

static inline bool render_until(render_job *j, film *f, render_goal goal)
{
    double begun = clock_seconds();
    if (goal.samples == 0) goal.samples = 1u << 30;
    for (;;) {
        uint32_t n = (uint32_t)film_samples(f), next = render_next(j, f, &goal, begun);
        if (next <= n || (goal.error > 0 && n >= 16 && film_error(f) <= goal.error)) return true;
        if (!render_range(j, f, n, next)) return false;
        if (goal.shown) goal.shown(f, goal.user);
    }
}

#endif
