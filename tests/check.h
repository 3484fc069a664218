/* check.h: checks that count themselves. A failure prints measured, expected, bound and why.
 *
 *   int main(void)
 *   {
 *       check(vfinite(p), "a point on a finite ray is finite");
 *       check_at_most(error, 4 * eps, "hit point off the sphere");
 *       return check_report("03_sphere");          prints "03_sphere: 12 passed, 0 failed"
 *   }
 *   int main(void) { return check_all("03_sphere", test_hits, test_normals, ..); }   of functions
 *
 * check_count(n) is an eighth of n, so that `make test` is quick; with CHECK_SOAK=1 in the
 * environment (`make soak`) it is n; with CHECK_DIVISOR=d, for slow builds (sanitizers, valgrind),
 * n / d. check_sample(n, least) is the same and never below `least`: for a share that is judged.
 *
 * CHECK_SLACK=1 prints what part of its bound each check_at_most and check_close reached. A line
 * that never gets to a hundredth has a bound that says little:
 *   CHECK_SLACK=1 build/test_09_aabb | awk '/^slack/ && !($3 < m[$2]) { m[$2] = $3 }
 *                                           END { for (k in m) if (m[k] < .01) print k, m[k] }'
 */
#ifndef CHECK_H
#define CHECK_H

#include "../common/posix.h"
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int check_passed, check_failed;

static inline bool check_result(bool ok, const char *file, int line)
{
    if (ok) check_passed++;
    else {
        check_failed++;
        printf("%s:%d: FAILED: ", file, line);
    }
    return ok;
}

#define check(ok, ...) \
    ((void)(check_result((ok), __FILE__, __LINE__) || (printf(__VA_ARGS__), printf("\n"))))

/* A NaN fails all of these. */
#define check_relation(ok, measured, word, bound, ...) \
    ((void)(check_result((ok), __FILE__, __LINE__) \
            || (printf("measured %.17g, expected " word " %.17g: ", (double)(measured), \
                       (double)(bound)), printf(__VA_ARGS__), printf("\n"))))

static inline void check_slack(double measured, double bound, const char *file, int line)
{
    if (bound > 0 && getenv("CHECK_SLACK"))
        printf("slack %s:%d %.3g\n", file, line, fabs(measured) / bound);
}

#define check_at_most(measured, bound, ...) \
    (check_slack((double)(measured), (double)(bound), __FILE__, __LINE__), \
     check_relation((measured) <= (bound), measured, "at most", bound, __VA_ARGS__))
#define check_at_least(measured, bound, ...) \
    check_relation((measured) >= (bound), measured, "at least", bound, __VA_ARGS__)
#define check_equal(measured, expected, ...) \
    check_relation((measured) == (expected), measured, "exactly", expected, __VA_ARGS__)

/* |measured - expected| <= bound */
#define check_close(measured, expected, bound, ...) \
    (check_slack((double)(measured) - (double)(expected), (double)(bound), __FILE__, __LINE__), \
     (void)(check_result(fabs((double)(measured) - (double)(expected)) <= (double)(bound), \
                         __FILE__, __LINE__) \
            || (printf("measured %.17g, expected %.17g within %.3g: ", (double)(measured), \
                       (double)(expected), (double)(bound)), printf(__VA_ARGS__), printf("\n"))))

#define check_text(measured, expected, ...) \
    ((void)(check_result(strcmp((measured), (expected)) == 0, __FILE__, __LINE__) \
            || (printf("measured \"%s\", expected \"%s\": ", (measured), (expected)), \
                printf(__VA_ARGS__), printf("\n"))))

/* The larger of two errors; a NaN stays, and fails the check at the end (fmax would drop it). */
static inline double check_worse(double a, double b) { return isnan(a) || b <= a ? a : b; }

static inline size_t check_count(size_t n)
{
    const char *divisor = getenv("CHECK_DIVISOR");
    size_t d = divisor ? (size_t)strtoul(divisor, NULL, 10) : getenv("CHECK_SOAK") ? 1 : 8;
    return d > 1 ? (n + d - 1) / d : n;
}

static inline size_t check_sample(size_t n, size_t least)
{
    size_t some = check_count(n);
    return some > least ? some : least;
}

/* Prints "name: N passed, N failed"; returns the exit status. */
static inline int check_report(const char *name)
{
    if (getenv("CHECK_DIVISOR")) printf("%s: %zu %% of the counts\n", name, check_count(100));
    printf("%s: %d passed, %d failed\n", name, check_passed, check_failed);
    return check_failed != 0;
}

/* Runs the tests, up to a NULL, and reports. */
static inline int check_run(const char *name, void (*const *test)(void))
{
    for (; *test; test++) (*test)();
    return check_report(name);
}
#define check_all(name, ...) check_run(name, (void (*const[])(void)){__VA_ARGS__, NULL})

#endif
