/* parallel.h: the same picture from any number of threads.
 *
 * Threads take the next piece of work from a common counter until none is left. A piece depends on
 * its index alone and writes only where no other one does, so the result is the same byte for byte
 * whoever does what when. Progress and the time left go to stderr, if that is a terminal.
 *
 * Ctrl-C (or SIGTERM) ends the work after the pieces in hand, of which long ones give up where they
 * find parallel_is_stopped(); the caller keeps what there is. A second one kills. Where Ctrl-C is
 * ignored (nohup), it stays ignored.
 */
#ifndef PARALLEL_H
#define PARALLEL_H
#include "clock.h"
#include "file.h"
#include <pthread.h>
#include <stdatomic.h>

typedef void parallel_job(size_t i, void *context);
typedef void pixel_job(int x, int y, void *context);

/* ---------------------------------------------------------------------------------------------- */
static atomic_int parallel_stop;            /* set by Ctrl-C */
static atomic_int parallel_signal = SIGINT; /* the last that stopped anything */
static _Thread_local int parallel_depth;    /* 1: this thread is at work on a piece; 2: within it */
/* Of work in parts, for its time left: when it began, the share done before, that of this part. */
typedef struct { double start, before, share; } parallel_part;
static parallel_part parallel_now = {0, 0, 1};  /* start 0: this is all of it */

typedef struct {
    parallel_job *job;
    void *context;
    const char *what;
    size_t n;
    atomic_size_t next;    /* the first piece that nobody has taken */
    double start, shown;   /* moments */
} parallel_work;

static inline void parallel_on_interrupt(int signal)
{
    atomic_store(&parallel_signal, signal);
    if (atomic_exchange(&parallel_stop, signal)) file_on_signal(signal);
}

static inline bool parallel_is_stopped(void) { return parallel_stop && parallel_depth < 2; }

/* The exit code of a program whose work was stopped: 130 after Ctrl-C, 143 after SIGTERM. */
static inline int parallel_stopped(void) { return 128 + atomic_load(&parallel_signal); }

static inline void parallel_show(parallel_work *w, size_t done)
{
    double now = clock_seconds(), start = parallel_now.start > 0 ? parallel_now.start : w->start;
    double part = parallel_now.before + parallel_now.share * (double)done / (double)w->n;
    if (now - w->shown < 0.2 || now - start < 0.5 || done == 0) return;
    w->shown = now;
    fprintf(stderr, "\r%s: %s %.0f %%, %.0f s left \033[K", program_name, w->what, 100 * part,
            (now - start) * (1 / part - 1));
}

static inline void parallel_run(parallel_work *w, bool show)
{
    parallel_depth = 1;
    for (size_t i; !parallel_is_stopped() && (i = atomic_fetch_add(&w->next, 1)) < w->n;) {
        if (show) parallel_show(w, i);
        w->job(i, w->context);
    }
    parallel_depth = 0;
}

static inline void *parallel_thread(void *work) { return parallel_run(work, false), NULL; }

static inline int parallel_cores(void)
{
    long n = sysconf(_SC_NPROCESSORS_ONLN);
    return n > 1 ? (int)n : 1;
}

/* job(0) ... job(n - 1) on so many threads [0: one a core; at most 256]. True if all were done,
 * false after Ctrl-C. `what` names the work in the progress line. A piece should take 10 us or
 * more. Called from within a job, it does its pieces in that thread, and no Ctrl-C divides them. A
 * caller that has blocked Ctrl-C is interrupted here, and nowhere else. */
__attribute__((warn_unused_result))
static inline bool parallel_for(size_t n, int threads, const char *what, parallel_job *job,
                                void *context)
{
    if (parallel_depth > 0) {
        parallel_depth++;
        for (size_t i = 0; i < n; i++) job(i, context);
        return parallel_depth--, true;
    }
    enum { most = 255 };
    pthread_t others[most];
    int started = 0;
    parallel_work w = {.job = job, .context = context, .what = what, .n = n};
    sigset_t both, mask;
    struct sigaction before, before_term, during = {.sa_handler = parallel_on_interrupt,
                                                            .sa_flags = SA_RESTART};
    w.start = clock_seconds(), atomic_store(&parallel_stop, 0);
    sigaction(SIGINT, NULL, &before), sigaction(SIGTERM, NULL, &before_term);
    if (before.sa_handler != SIG_IGN) sigaction(SIGINT, &during, NULL);
    if (before_term.sa_handler != SIG_IGN) sigaction(SIGTERM, &during, NULL);
    sigemptyset(&both), sigaddset(&both, SIGINT), sigaddset(&both, SIGTERM);
    pthread_sigmask(SIG_UNBLOCK, &both, &mask);
    int wanted = threads > 0 ? threads : parallel_cores();
    while (started + 1 < wanted && started < most && (size_t)started + 1 < n
           && pthread_create(&others[started], NULL, parallel_thread, &w) == 0)
        started++;  /* with fewer threads than wanted it only takes longer */
    parallel_run(&w, isatty(STDERR_FILENO));
    while (started > 0) pthread_join(others[--started], NULL);
    pthread_sigmask(SIG_SETMASK, &mask, NULL);
    sigaction(SIGINT, &before, NULL), sigaction(SIGTERM, &before_term, NULL);
    if (w.shown > 0) fprintf(stderr, "\r\033[K");
    return atomic_load(&w.next) >= n && !atomic_load(&parallel_stop);
}

/* Of a result that is nothing unless whole: Ctrl-C ends the program, with exit 130 (TERM: 143). */
static inline void parallel_whole(size_t n, int threads, const char *what, parallel_job *job,
                                  void *context)
{
    if (!parallel_for(n, threads, what, job, context)) die(parallel_stopped(), "stopped");
}

enum { parallel_side = 16 };  /* of a tile, pixels */
typedef struct { int width, height, across; pixel_job *job; void *context; } parallel_tiles;

static inline void parallel_tile(size_t i, void *tiles)
{
    const parallel_tiles *t = tiles;
    int x0 = (int)(i % (size_t)t->across) * parallel_side;
    int y0 = (int)(i / (size_t)t->across) * parallel_side;
    for (int y = y0; y < y0 + parallel_side && y < t->height; y++)
        for (int x = x0; x < x0 + parallel_side && x < t->width; x++)
            if (!parallel_is_stopped()) t->job(x, y, t->context);
}

/* As parallel_for: job(x, y) for each pixel, by tiles of 16 x 16; Ctrl-C waits for pixels alone. */
__attribute__((warn_unused_result))
static inline bool parallel_pixels(int width, int height, int threads, const char *what,
                                   pixel_job *job, void *context)
{
    int across = (width + parallel_side - 1) / parallel_side;
    int down = (height + parallel_side - 1) / parallel_side;
    parallel_tiles t = {width, height, across, job, context};
    return parallel_for((size_t)across * (size_t)down, threads, what, parallel_tile, &t);
}
#endif
