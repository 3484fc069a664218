/* Tests of common/clock.h and common/lab/bench.h. */
#include "check.h"
#include "../common/lab/bench.h"

static char order[64];

static void spin(double seconds)
{
    double start = clock_seconds();
    while (clock_seconds() - start < seconds) continue;
}

/* A variant that notes its turn, and takes as many ms as the turn says. */
typedef struct { char letter; const double *ms; int turn; } fake;

static double run_fake(void *context)
{
    fake *f = context;
    size_t n = strlen(order);
    order[n] = f->letter;
    spin(1e-3 * f->ms[f->turn++]);
    return (double)n;
}

static void warm_fake(void *context)
{
    (void)context;
    order[strlen(order)] = 'w';
    spin(40e-3);
}

static void test_median(void)
{
    double odd[] = {3, 1, 2}, even[] = {4, 1, 3, 2}, one[] = {7}, far[] = {1e300, -1e300, 0};
    check_equal(clock_median(odd, 3), 2, "median of 3");
    check_equal(clock_median(even, 4), 2.5, "median of 4: between the middle two");
    check_equal(clock_median(one, 1), 7, "median of one");
    check_equal(clock_median(far, 3), 0, "differences that overflow");
}

/* 1 2 3 4 9: the quartiles are 2 and 4. */
static void test_spread(void)
{
    double x[] = {9, 1, 4, 2, 3}, zero[] = {0, 0}, spread;
    check_equal(bench_median(x, 5, &spread), 3, "median of 5");
    check_close(spread, 1 / 3.0, 1e-15, "half of 4 - 2, over 3");
    check(bench_median(zero, 2, &spread) == 0 && spread == 0, "no time, no spread");
}

/* The first turn warms up; one slow turn of five does not move the median. */
static void test_turns(void)
{
    const double a_ms[] = {0, 1, 1, 40, 1, 1}, b_ms[] = {30, 8, 8, 8, 8, 8};
    fake a = {'A', a_ms, 0}, b = {'B', b_ms, 0};
    bench_candidate v[] = {{.run = run_fake, .context = &a},
                           {.run = run_fake, .context = &b, .warm = warm_fake}};
    bench_time(v, 2, 5);
    check_text(order, "AwBAwBAwBAwBAwBAwB", "in turn, after one round; B is warmed");
    check_at_least(v[0].seconds, 0.001, "median of 1 ms");
    check_at_least(v[1].seconds, 0.008, "median of 8 ms");
    check_at_most(v[1].seconds, 0.030, "what warms does not count");
    check_at_most(v[0].seconds, 0.030, "one slow turn does not count");
    check_equal(clock_kept, 17, "the last result was kept");
}

int main(void)
{
    double last = clock_seconds();
    int back = 0;
    for (size_t i = 0; i < check_count(200000); i++) {
        double now = clock_seconds();
        back += now < last, last = now;
    }
    check_equal(back, 0, "times the clock was set back");
    test_median();
    test_spread();
    test_turns();
    return check_report("clock");
}
