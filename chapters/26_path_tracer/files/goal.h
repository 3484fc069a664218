/* goal.h: a picture by passes: until it has so many samples, is so good, or took so long.
 *
 *   bool whole = passes_until(&p, &f, goal);        passes (passes.h), from where the film ends
 *
 *   goal            ends
 *   .samples = N    when every pixel has samples 0 .. N-1
 *   .error = e      at the first pass with film_error <= e, and 16 samples; .samples: most
 *   .seconds = s    when the next pass would take longer than what is left; at least one sample
 *
 * Each pass doubles the samples, so that what it shows is worth showing. Near its end an error
 * needs n (error now / e)^2 samples: that many are next, if less than the double. The number does
 * not depend on time or threads, and neither does a picture with as many samples.
 * goal.shown(&f, user) is called after each pass [may be NULL]; Ctrl-C waits for it.
 */
#ifndef PATH_GOAL_H
#define PATH_GOAL_H

#include "../../20_monte_carlo/passes.h"

typedef struct {
    uint32_t samples;
    double error, seconds;
    void (*shown)(const film *f, void *user);
    void *user;
} passes_goal;

/* ---------------------------------------------------------------------------------------------- */

/* How many samples the picture is to have after the next pass. */
static inline uint32_t passes_next(const film_passes *p, const film *f, const passes_goal *g,
                                   double begun)
{
    uint64_t n = film_samples(f), next = n ? 2 * n : 1;
    double now = g->error > 0 ? film_error(f) : 0;
    if (g->error > 0 && n >= 8 && now > g->error) {
        double wanted = (double)n * (now / g->error) * (now / g->error) * 1.02 + 1;
        if (wanted < (double)next) next = wanted > (double)n + 1 ? (uint64_t)wanted : n + 1;
    }
    if (g->error > 0 && n < 16 && next > 16) next = 16;  /* the first that may suffice */
    if (g->seconds > 0 && n > 0) {  /* what is left, at the speed so far, and a margin */
        double left = g->seconds * 0.97 - (clock_seconds() - begun);
        double more = p->samples > 0 ? left * p->samples / p->seconds : (double)n;
        if (more < (double)(next - n)) next = n + (more >= 1 ? (uint64_t)more : 0);
    }
    return next < g->samples ? (uint32_t)next : g->samples;
}

/* Between passes nothing but this hears Ctrl-C: a state is saved whole, then the work ends. */
static inline bool passes_stopped(const sigset_t *both)
{
    sigset_t pending;
    struct sigaction now;
    int signals[2] = {SIGINT, SIGTERM}, which;
    sigpending(&pending);
    for (int k = 0; k < 2; k++)
        if (sigismember(&pending, signals[k]) && sigaction(signals[k], NULL, &now) == 0
            && now.sa_handler != SIG_IGN && sigwait(both, &which) == 0)
            return parallel_on_interrupt(which), true;
    return false;
}

/* Samples n .. next-1, of those that a goal of samples alone asks for, from `first` on. Else
 * nobody knows how many passes come: what is left is said of each. */
static inline parallel_part passes_part(const passes_goal *g, double begun, uint32_t first,
                                        uint32_t n, uint32_t next)
{
    double all = (double)(g->samples - first);
    if (g->error > 0 || g->seconds > 0) return (parallel_part){0, 0, 1};
    return (parallel_part){begun, (n - first) / all, (next - n) / all};
}

static inline bool passes_until(film_passes *p, film *f, passes_goal goal)
{
    double begun = clock_seconds();
    bool whole = true;
    sigset_t both, before;
    sigemptyset(&both), sigaddset(&both, SIGINT), sigaddset(&both, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &both, &before);
    if (goal.samples == 0) goal.samples = 1u << 30;
    const uint32_t first = (uint32_t)film_samples(f);
    while (whole) {
        uint32_t n = (uint32_t)film_samples(f), next = passes_next(p, f, &goal, begun);
        if (next <= n || (goal.error > 0 && n >= 16 && film_error(f) <= goal.error)) break;
        parallel_now = passes_part(&goal, begun, first, n, next);
        whole = passes_range(p, f, n, next);
        if (whole && goal.shown) goal.shown(f, goal.user);
        whole = whole && !passes_stopped(&both);
    }
    parallel_now = (parallel_part){0, 0, 1};
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    return whole;
}

#endif
