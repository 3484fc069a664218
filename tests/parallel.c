/* Tests of common/parallel.h. pthread_create goes through a function that can be told to fail. */
#include "../common/posix.h"
#include <pthread.h>
static int create_limit = 1 << 30, created;
static int counted_create(pthread_t *t, const pthread_attr_t *a, void *(*run)(void *),
                          void *context)
{
    if (created == create_limit) return 11;  /* EAGAIN: no more threads */
    created++;
    return pthread_create(t, a, run, context);
}
#define pthread_create counted_create
#include "check.h"
#include "child.h"
#include "../common/parallel.h"
#include "../common/random.h"

enum { width = 150, height = 70 };
typedef struct { float pixel[height][width]; atomic_int calls[height][width]; } picture;

static void draw(int x, int y, void *context)
{
    picture *p = context;
    double sum = 0;
    uint64_t i = (uint64_t)(y * width + x);
    for (uint64_t s = 0; s < 20; s++) sum += (double)random_real(1, i, s, 0);
    p->pixel[y][x] = (float)sum;
    atomic_fetch_add(&p->calls[y][x], 1);
}

static void test_same(void)
{
    static picture one, many;
    const int threads[] = {2, 3, 7, 100, 0};
    check(parallel_pixels(width, height, 1, "test", draw, &one), "all done");
    for (size_t k = 0; k < sizeof threads / sizeof *threads; k++) {
        memset(&many, 0, sizeof many);
        check(parallel_pixels(width, height, threads[k], "test", draw, &many), "all done");
        check(memcmp(one.pixel, many.pixel, sizeof one.pixel) == 0, "%d threads, byte for byte",
              threads[k]);
        size_t not_once = 0;
        for (int i = 0; i < width * height; i++)
            not_once += atomic_load(&many.calls[i / width][i % width]) != 1;
        check_equal(not_once, 0, "pixels not drawn once by %d threads", threads[k]);
    }
}

static void count(size_t i, void *context)
{
    (void)i;
    atomic_fetch_add((atomic_int *)context, 1);
}

static void test_counts(void)
{
    atomic_int calls = 0;
    check(parallel_for(0, 4, "none", count, &calls) && calls == 0, "nothing to do is done");
    created = 0;
    check(parallel_for(3, 100, "few", count, &calls) && calls == 3, "more threads than pieces");
    check_at_most(created, 2, "threads started for 3 pieces, besides the caller's");
    created = 0, calls = 0;
    check(parallel_for(2000, 100000, "many", count, &calls) && calls == 2000, "too many threads");
    check_at_most(created, 255, "threads started, at most");
    for (int limit = 0; limit < 3; limit++) {
        create_limit = limit, created = 0, calls = 0;
        check(parallel_for(50, 8, "no threads left", count, &calls) && calls == 50,
              "all is done with %d threads besides the caller's", limit);
    }
    create_limit = 1 << 30;
}

static void nest(size_t i, void *context)
{
    (void)i;
    if (!parallel_for(5, 4, "inner", count, context)) abort();
}

static void test_nested(void)
{
    atomic_int calls = 0;
    check(parallel_for(20, 4, "outer", nest, &calls), "all done");
    check_equal(calls, 100, "pieces of loops within loops");
}

static void interrupt_at_10(size_t i, void *context)
{
    count(i, context);
    if (i == 10) raise(SIGINT);
}

static void interrupted(void *context)
{
    atomic_int calls = 0;
    bool whole = parallel_for(1000, 1, "work", interrupt_at_10, &calls);
    printf("%d %d", whole, calls);
    calls = 0;
    whole = parallel_for(10, 1, "more work", count, &calls);
    printf(" %d %d", whole, calls);
    (void)context;
}

static void interrupted_twice(size_t i, void *context)
{
    (void)i, (void)context;
    raise(SIGINT), raise(SIGINT);
}
static void two_signals(void *context)
{
    if (parallel_for(3, 1, "work", interrupted_twice, context)) abort();
}

static void two_signals_and_a_file(void *path)
{
    file_writer w;
    if (!file_begin(&w, path, NULL)) abort();
    printf("%s", w.temporary), fflush(stdout);
    two_signals(NULL);
}

static void ignored(void *context)
{
    signal(SIGINT, SIG_IGN);
    interrupted(context);
}

static void at_the_end(size_t i, void *context) { (void)context; if (i == 4) raise(SIGINT); }
static void last_piece(void *context)
{
    printf("%d", parallel_for(5, 1, "work", at_the_end, context));
}

static void afterwards(void *context)
{
    atomic_int calls = 0;
    if (!parallel_for(5, 2, "work", count, &calls)) abort();
    raise(SIGINT);
    (void)context;
}

/* A part of four pieces, of which two are done, is the second half of what began 30 s ago. */
static void show_part(void *unused)
{
    (void)unused;
    parallel_work w = {.what = "work", .n = 4, .start = clock_seconds() - 1};
    parallel_now = (parallel_part){clock_seconds() - 30, 0.5, 0.5};
    parallel_show(&w, 2);
    exit(0);
}

/* Blocked before and after, so that no moment is left in which Ctrl-C kills. */
static void blocked(void *context)
{
    sigset_t interrupt, left;
    sigemptyset(&interrupt), sigaddset(&interrupt, SIGINT);
    pthread_sigmask(SIG_BLOCK, &interrupt, NULL);
    interrupted(context);
    raise(SIGINT);
    sigpending(&left);
    printf(" %d", sigismember(&left, SIGINT));
    atomic_int calls = 0;
    bool whole = parallel_for(10, 2, "what waited is heard", count, &calls);
    printf(" %d", whole);
}

static void for_a_table(void *context)
{
    atomic_int calls = 0;
    (void)context;
    parallel_whole(10, 2, "work", count, &calls);
    printf("%d", calls);
    fflush(stdout);
    parallel_whole(1000, 1, "work", interrupt_at_10, &calls);
    printf(" a table of what is not there");
}

static void stop_then_nest(size_t i, void *context)
{
    if (i == 3) raise(SIGINT);
    nest(i, context);
}

static void nested_interrupt(void *context)
{
    atomic_int calls = 0;
    (void)context;
    bool whole = parallel_for(20, 1, "outer", stop_then_nest, &calls);
    printf("%d %d", whole, calls);
}

static void interrupt_at_pixel(int x, int y, void *context)
{
    count(0, context);
    if (x == 5 && y == 3) raise(SIGINT);
}

static void within_a_tile(void *context)
{
    atomic_int calls = 0;
    (void)context;
    bool whole = parallel_pixels(width, height, 1, "picture", interrupt_at_pixel, &calls);
    printf("%d %d", whole, calls);
}

static void draw_within(size_t i, void *context)
{
    (void)i;
    if (!parallel_pixels(20, 10, 2, "inner", interrupt_at_pixel, context)) abort();
}

static void picture_within(void *context)
{
    atomic_int calls = 0;
    (void)context;
    bool whole = parallel_for(7, 1, "outer", draw_within, &calls);
    printf("%d %d", whole, calls);
}

static void test_interrupt(void)
{
    char in_tmp[] = "/tmp/parallel_test.out";
    signal(SIGINT, SIG_DFL);  /* the background jobs of a shell begin with Ctrl-C ignored */
    child_result r = child_run(interrupted, NULL);
    check_text(r.out, "0 11 1 10", "Ctrl-C ends after the piece in hand; the next loop is whole");
    check_equal(r.status, 0, "Ctrl-C does not kill");
    check_equal(child_run(two_signals, NULL).status, 128 + SIGINT, "a second one does");
    r = child_run(two_signals_and_a_file, in_tmp);
    check_equal(r.status, 128 + SIGINT, "while a file is written, too");
    check(strstr(r.out, in_tmp) == r.out && access(r.out, F_OK) != 0, "half a file: %s", r.out);
    check_text(child_run(ignored, NULL).out, "1 1000 1 10", "where Ctrl-C is ignored it stays so");
    check_text(child_run(blocked, NULL).out, "0 11 1 10 1 0", "blocked: heard in the loop alone");
    check_text(child_run(last_piece, NULL).out, "0", "Ctrl-C in the last piece is not forgotten");
    check_text(child_run(nested_interrupt, NULL).out, "0 20",
               "a loop within a job is done in full, and does not forget the Ctrl-C");
    check_text(child_run(within_a_tile, NULL).out, "0 54", "a picture ends after that pixel");
    check_text(child_run(picture_within, NULL).out, "0 200", "but not a picture within a job");
    r = child_run(for_a_table, NULL);
    check_text(r.out, "10", "no table of half the work");
    check(strstr(r.err, ": stopped\n") != NULL, "it says so: %s", r.err);
    check_equal(r.status, 128 + SIGINT, "Ctrl-C where only the whole counts");
    check_equal(child_run(afterwards, NULL).status, 128 + SIGINT, "after the loop it kills again");
}

static void slow(size_t i, void *context)
{
    (void)i, (void)context;
    double start = clock_seconds();
    while (clock_seconds() - start < 0.3) continue;
}

static void silent(void *context)
{
    if (!parallel_for(6, 2, "work", slow, context)) abort();
}

static void test_silent(void)
{
    check(strstr(child_run(show_part, NULL).err, "work 75 %, 10 s left"), "all parts count");
    check_text(child_run(silent, NULL).err, "", "no progress where stderr is no terminal");
}

int main(void)
{
    test_same();
    test_counts();
    test_nested();
    test_interrupt();
    test_silent();
    check_at_least(parallel_cores(), 1, "processors");
    return check_report("parallel");
}
