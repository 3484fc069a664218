/* 03's first.h: right from nearby, and noise from afar. Its interval:
 * test_interval in 03_sphere.c. */
#include "../chapters/03_sphere/lab/mine.h"
#include "check.h"

static const double eps = (double)real_epsilon;

/* Easy rays against the roots in 30 digits. */
static void test_hits(void)
{
    size_t hits = 0, n = check_count(100000);
    double normal = 0;
    FILE *nowhere = fopen("/dev/null", "w");
    if (!nowhere) abort();
    check(sphere_prove(first_sphere_hit, "", n, nowhere), "hit or miss, or t of the hit");
    fclose(nowhere);
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(1, i, 0);
        sphere ball;
        hit h;
        real R = pow((real)10, 6 * random_next(&s) - 3), far = 1 + 9 * random_next(&s);
        ray r = sphere_aim(&s, R, far, (real)1.2 * random_next(&s), i % 3 == 0, &ball);
        if (!first_sphere_hit(ball, r, &h)) continue;
        vec3 p = sphere_point(ball, ray_at(r, h.t));
        vec3 apart = vsub(first_sphere_normal(ball, p), sphere_normal(ball, p));
        normal = check_worse(normal, (double)vlength(apart)), hits++;
    }
    check_at_least((double)hits, 0.4 * (double)n, "the test sees hits");
    check_at_most(normal, 100 * eps, "the normal, centres up to 10 R from the origin");
}

/* Percent of the rays aimed at a disc of 1.2 R from `far` R that are misclassified. */
static double misclassified(real far, bool first)
{
    size_t wrong = 0, n = check_count(20000);
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(2, i, (uint64_t)far);
        sphere ball;
        ray r = sphere_aim(&s, 1, far, (real)1.2 * sqrt(random_next(&s)), i % 2, &ball);
        double clear = sphere_clearance(ball, r);
        hit h;
        if (fabs(clear) < 1e-12) continue;
        bool is = first ? first_sphere_hit(ball, r, &h) : sphere_hit(ball, r, &h);
        wrong += is != (clear < 0);
    }
    return 100 * (double)wrong / (double)n;
}

/* "from 3000 radii in float, 7e7 in double, b^2 - 4ac is the noise of two huge numbers": its error
 * is epsilon (l/R)^2, 1 there. "sphere.h holds it together". */
static void test_far_away(void)
{
    real noise = real_is_float ? 3000 : (real)7e7;
    check_at_least(misclassified(noise, true), 5, "from %g radii the sphere falls apart",
                   (double)noise);
    check_at_least(misclassified(10 * noise, true), 30, "from ten times as far nothing is left");
    check_at_most(misclassified(noise / 100, true), 0.1, "at a hundredth of it few rays are wrong");
    check_equal(misclassified(noise, false), 0, "sphere_hit is right from there");
    check_equal(misclassified(10 * noise, false), 0, "and from ten times as far");
}

/* Answers without meaning, but answers. */
static void test_degenerate(void)
{
    const real strange[] = {0, (real)NAN, real_infinity, -real_infinity, real_largest};
    size_t untouched = 0, cases = 0;
    for (int k = 0; k < 10; k++)
        for (int what = 0; what < 5; what++) {
            real v[10] = {0, 0, 0, 1, 0, 0, 3, 0, 0, -1};
            hit h = {7, 7, 7, 7};
            v[k] = strange[what];
            bool is = first_sphere_hit((sphere){{v[0], v[1], v[2]}, v[3]},
                                       ray_from((vec3){v[4], v[5], v[6]}, (vec3){v[7], v[8], v[9]}),
                                       &h);
            cases++, untouched += is != (h.t == 7);
        }
    check_equal(untouched, cases, "a miss leaves *out alone, a hit does not");
    ray still = ray_from((vec3){0, 0, 3}, (vec3){0, 0, 0}), inside = still;
    inside.o.z = 0;
    sphere unit = {{0, 0, 0}, 1};
    check(!first_sphere_hit(unit, still, &(hit){0}) && !first_sphere_hit(unit, inside, &(hit){0}),
          "no direction: a miss, from inside, too");
    still.d.z = (real)NAN;
    real t0 = 7, t1 = 7;
    check(!first_sphere_hit(unit, still, &(hit){0}), "nor does a NaN hit");
    check(!first_sphere_roots(unit, still, &t0, &t1) && t0 == 7 && t1 == 7, "it has no roots");
}

int main(void)
{
    test_hits();
    test_far_away();
    test_degenerate();
    return check_report("03_first");
}
