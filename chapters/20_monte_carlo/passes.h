/* passes.h: the samples of a film, a pass at a time, by all threads.
 *
 *   film_passes p = {.tile = f, .job = &job, .threads = 0};
 *   film f = film_new(w, h);
 *   bool whole = passes_range(&p, &f, a, b);        samples a .. b-1 [a < b]; false: Ctrl-C
 *
 *   f(k, &job)      samples p.now of each pixel in film_window_of(p.to, k), by rows, gathered once
 *                   and counted in p.to->done[k]. Once stopped, it counts no more: a pixel is left
 *                   between two samples. p.lock is for what all threads add to
 *
 * Pass after pass until a picture is good enough: files/goal.h of 26.
 */
#ifndef MONTE_CARLO_PASSES_H
#define MONTE_CARLO_PASSES_H

#include "../../common/parallel.h"
#include "film.h"

typedef struct {
    parallel_job *tile;
    void *job;
    int threads;
    film *to;
    film_range now;
    double samples, seconds;  /* of a pixel, that whole passes did; spent in passes */
    pthread_mutex_t lock;
} film_passes;

/* ---------------------------------------------------------------------------------------------- */

static inline bool passes_range(film_passes *p, film *f, uint32_t begin, uint32_t end)
{
    failure why;
    double start = clock_seconds();
    p->to = f, p->now = f->pending = (film_range){begin, end};
    pthread_mutex_init(&p->lock, NULL);
    bool whole = parallel_for(film_tiles(f), p->threads, "samples", p->tile, p->job);
    pthread_mutex_destroy(&p->lock);
    p->seconds += clock_seconds() - start;
    if (!whole) return false;
    p->samples += end - begin;
    memset(f->done, 0, film_tiles(f) * sizeof *f->done);
    if (!film_cover(f, begin, end, &why)) fail(why);
    return true;
}

#endif
