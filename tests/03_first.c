/* 03's first.h: the answers of sphere.h from nearby, and noise from afar. */
#include "../chapters/03_sphere/lab/sphere_oracle.h"
#include "check.h"

static const double eps = (double)real_epsilon;

typedef struct { sphere ball; ray r; double unit; } shot;  /* unit: R in lengths of d */

/* A ray from 1 to 10 R, every other time from somewhere on the way, that passes at 0 to 1.2 R, and
 * 1 % of R at least away from a tangent; false for the few that do not. */
static bool shot_nearby(size_t i, shot *out)
{
    random_stream s = random_start(1, i, 0);
    real R = pow((real)10, 6 * random_next(&s) - 3), far = 1 + 9 * random_next(&s);
    out->r = sphere_aim(&s, R, far, (real)1.2 * random_next(&s), i % 3 == 0, &out->ball);
    if (i % 2) out->r.o = ray_at(out->r, random_next(&s) / 2 + (real)0.25);
    out->unit = (double)(R / vlength(out->r.d));
    return fabs(sphere_clearance(out->ball, out->r)) > 0.01;
}

/* sqrt(D) is 0.14 R |d| at least, and D off by a few epsilon times 100 R^2 |d|^2: t by some 400
 * epsilon of R / |d| for each of them. */
static void test_roots(void)
{
    size_t wrong = 0, judged = 0, n = check_count(200000);
    double worst = 0;
    for (size_t i = 0; i < n; i++) {
        shot x;
        if (!shot_nearby(i, &x)) continue;
        real t0 = 0, t1 = 0, u0 = 0, u1 = 0;
        judged++;
        wrong += first_sphere_roots(x.ball, x.r, &t0, &t1) != sphere_roots(x.ball, x.r, &u0, &u1);
        worst = check_worse(worst, fabs((double)(t0 - u0)) / x.unit);
        worst = check_worse(worst, fabs((double)(t1 - u1)) / x.unit);
    }
    check_at_least((double)judged, 0.9 * (double)n, "nearly all rays are judged");
    check_equal(wrong, 0, "hit or miss against sphere_roots, of %zu", n);
    check_at_most(worst, 2000 * eps, "roots, in units of R / |d|");
}

static void test_hits(void)
{
    size_t wrong = 0, hits = 0, exits = 0, n = check_count(200000);
    double off = 0, normal = 0;
    for (size_t i = 0; i < n; i++) {
        shot x;
        real u0 = 7, u1 = 7;
        hit a = {7, 7, 7, 7}, b = {7, 7, 7, 7};
        if (!shot_nearby(i, &x)) continue;
        (void)sphere_roots(x.ball, x.r, &u0, &u1);
        if (fabs((double)u0) < x.unit / 100) continue;  /* next to o: in front or not? */
        if (fabs((double)u1) < x.unit / 100) continue;
        bool is = first_sphere_hit(x.ball, x.r, &a), due = sphere_hit(x.ball, x.r, &b);
        wrong += is != due || a.u != b.u || a.v != b.v || a.shape != b.shape;
        hits += is, exits += due && b.t == u1;
        off = check_worse(off, fabs((double)(a.t - b.t)) / x.unit);
        if (!due) continue;
        vec3 p = sphere_point(x.ball, ray_at(x.r, b.t));
        vec3 apart = vsub(first_sphere_normal(x.ball, p), sphere_normal(x.ball, p));
        normal = check_worse(normal, (double)vlength(apart));
    }
    check_at_least((double)hits, 0.4 * (double)n, "the test sees hits");
    check_at_least((double)exits, 0.04 * (double)n, "and exits, from inside");
    check_equal(wrong, 0, "hit or miss, u, v and shape against sphere_hit, of %zu", n);
    check_at_most(off, 2000 * eps, "t of the hit");
    check_at_most(normal, 100 * eps, "the normal, centres up to 10 R from the origin");
}

/* Closed, and the exit where the entry lies before tmin: as tests/03_sphere.c has it. */
static void test_interval(void)
{
    sphere s = {{0, 0, 0}, 1};
    const struct { real tmin, tmax, t; } in[] = {
        {2, 4, 2}, {2, 2, 2}, {3, 4, 4}, {4, 4, 4}, {-1, real_infinity, 2}, {0, 3, 2}};
    for (size_t i = 0; i < sizeof in / sizeof *in; i++) {
        hit h = {0, 0, 0, 0};
        ray r = {{0, 0, 3}, in[i].tmin, {0, 0, -1}, in[i].tmax};
        check(first_sphere_hit(s, r, &h) && h.t == in[i].t, "interval %zu", i);
    }
    const struct { real tmin, tmax; } out[] = {
        {0, 2 * (1 - real_epsilon)}, {3, (real)3.5}, {5, 9}, {3, 1}, {(real)NAN, 9}};
    for (size_t i = 0; i < sizeof out / sizeof *out; i++) {
        hit h = {7, 7, 7, 7};
        ray r = {{0, 0, 3}, out[i].tmin, {0, 0, -1}, out[i].tmax};
        check(!first_sphere_hit(s, r, &h) && h.t == 7 && h.shape == 7, "outside %zu", i);
    }
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
    test_roots();
    test_hits();
    test_interval();
    test_far_away();
    test_degenerate();
    return check_report("03_first");
}
