/* parallel.h: the same picture from any number of threads.
 *
 * Threads take the next piece of work from a common counter until none is left. A piece depends on
 * its index alone and writes only where no other one does, so the result is the same byte for byte
 * whoever does what when. Progress and the time left go to stderr, if that is a terminal.
 *
 * Ctrl-C ends the work after the pieces in hand; the caller keeps what there is. A second one
 * kills.
 */
#ifndef PARALLEL_H
#define PARALLEL_H

#include "clock.h"
#include "file.h"
#include <pthread.h>
#include <signal.h>
#include <stdatomic.h>

typedef void parallel_job(size_t i, void *context);
typedef void pixel_job(int x, int y, void *context);

/* ---------------------------------------------------------------------------------------------- */

typedef struct {
    parallel_job *job;
    void *context;
    const char *what;
    size_t n;
    atomic_size_t next, done;
    double start, shown;
} parallel_work;

static atomic_int parallel_stop;  /* set by Ctrl-C */

static inline void parallel_on_interrupt(int signal_number)
{
    (void)signal_number;
    atomic_store(&parallel_stop, 1);
}

static inline void parallel_show(parallel_work *w)
{
    double now = clock_seconds(), spent = now - w->start;
    size_t done = atomic_load(&w->done);
    if (now - w->shown < 0.2 || spent < 0.5 || done == 0) return;
    w->shown = now;
    double part = (double)done / (double)w->n;
    fprintf(stderr, "\r%s: %s %.0f %%, %.0f s left \033[K", program_name, w->what, 100 * part,
            spent * (1 / part - 1));
}

static inline void parallel_run(parallel_work *w, bool show)
{
    for (size_t i; !atomic_load(&parallel_stop) && (i = atomic_fetch_add(&w->next, 1)) < w->n;) {
        w->job(i, w->context);
        atomic_fetch_add(&w->done, 1);
        if (show) parallel_show(w);
    }
}

static inline void *parallel_thread(void *work)
{
    parallel_run(work, false);
    return NULL;
}

static inline int parallel_cores(void)
{
    long n = sysconf(_SC_NPROCESSORS_ONLN);
    return n < 1 ? 1 : n > 256 ? 256 : (int)n;
}

/* job(0) ... job(n - 1) on so many threads (0: one a core). True if all were done, false after
 * Ctrl-C. `what` names the work in the progress line. */
static inline bool parallel_for(size_t n, int threads, const char *what, parallel_job *job,
                                void *context)
{
    pthread_t others[256];
    int started = 0, wanted = threads > 0 ? threads : parallel_cores();
    bool show = isatty(STDERR_FILENO);
    parallel_work w = {.job = job, .context = context, .what = what, .n = n};
    struct sigaction before, during = {.sa_handler = parallel_on_interrupt};
    during.sa_flags = (int)SA_RESETHAND;
    w.start = clock_seconds();
    atomic_store(&parallel_stop, 0);
    sigaction(SIGINT, NULL, &before);
    if (before.sa_handler != SIG_IGN) sigaction(SIGINT, &during, NULL);
    while (started < wanted - 1 && started < 256 && (size_t)started + 1 < n
           && pthread_create(&others[started], NULL, parallel_thread, &w) == 0)
        started++;  /* with fewer threads than wanted it only takes longer */
    parallel_run(&w, show);
    while (started > 0) pthread_join(others[--started], NULL);
    sigaction(SIGINT, &before, NULL);
    if (w.shown > 0) fprintf(stderr, "\r\033[K");
    return atomic_load(&w.done) == n;
}

typedef struct { int width, height, across; pixel_job *job; void *context; } parallel_tiles;

static inline void parallel_tile(size_t i, void *tiles)
{
    enum { side = 16 };
    const parallel_tiles *t = tiles;
    int x0 = (int)(i % (size_t)t->across) * side, y0 = (int)(i / (size_t)t->across) * side;
    for (int y = y0; y < y0 + side && y < t->height; y++)
        for (int x = x0; x < x0 + side && x < t->width; x++) t->job(x, y, t->context);
}

/* job(x, y) for each pixel, by tiles of 16 x 16, from the top. Otherwise as above. */
static inline bool parallel_pixels(int width, int height, int threads, const char *what,
                                   pixel_job *job, void *context)
{
    parallel_tiles t = {width, height, (width + 15) / 16, job, context};
    size_t n = (size_t)t.across * (size_t)((height + 15) / 16);
    return parallel_for(n, threads, what, parallel_tile, &t);
}

#endif
