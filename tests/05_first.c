/* 05's first.h: the answers of implicit.h where f changes its sign; what it misses. */
#include "../chapters/05_implicit/lab/implicit_trials.h"
#include "check.h"

static const double eps = (double)real_epsilon;

/* Two balls that overlap: |p|^2 - 1 and its like at (1, 0, 0), the lesser of the two. */
static real pair(vec3 p)
{
    vec3 q = vsub(p, vec(1, 0, 0));
    return real_min(vdot(p, p), vdot(q, q)) - 1;
}

/* A disc of radius 1 and of so little thickness: |z| - 1/200 inside of the cylinder. */
static real plate(vec3 p)
{
    return real_max(p.x * p.x + p.y * p.y - 1, fabs(p.z) - (real)0.005);
}

/* Its hits: 05_implicit.c. */
static void test_normal(void)
{
    vec3 n = first_implicit_normal(pair, vec(0, 0, 1), (real)0.001);
    check_close(n.z, 1, 1e-6, "the normal points outwards");
    n = first_implicit_normal(pair, vec(2, 0, 0), (real)0.001);
    check_close(n.x, 1, 1e-6, "of the other ball, too");
}

/* Exercise 1: f and two of its points in the plane z = 0, (1, 1, 0) and (-1, 1, 0): x^6 = x^2; and
 * over (0, 1): (9/4 z^2)^3 = 9/80 z^2, so z^4 = 4/405. */
static real heart(vec3 p)
{
    real xx = p.x * p.x, yyy = p.y * p.y * p.y, zz = p.z * p.z;
    real a = xx + (real)2.25 * zz + p.y * p.y - 1;
    return a * a * a - xx * yyy - (real)0.1125 * zz * yyy;
}

static void test_heart(void)
{
    const struct { ray r; real t; } in[] = {
        {{{3, 1, 0}, 0, {-1, 0, 0}, 6}, 2}, {{{-3, 1, 0}, 0, {1, 0, 0}, 6}, 2},
        {{{0, 1, 3}, 0, {0, 0, -1}, 6}, 3 - pow((real)4 / 405, (real)0.25)}};
    for (size_t i = 0; i < sizeof in / sizeof *in; i++) {
        hit h = hit_none;
        check(first_implicit_hit(heart, in[i].r, 200, &h), "ray %zu meets the heart", i);
        check_close(h.t, in[i].t, 100 * eps, "ray %zu", i);  /* slope 4, 1 and .2 there */
    }
}

static size_t asked;
static real counted(vec3 p) { return asked++, pair(p); }

/* n steps are n + 1 places, no fewer and no more; and every one of them counts. */
static void test_steps(void)
{
    for (int n = 1; n <= 4096; n *= 2) {
        hit h;
        asked = 0;
        check(!first_implicit_hit(counted, (ray){{0, 3, 0}, 0, {1, 0, 0}, 9}, n, &h), "a miss");
        check_equal(asked, (size_t)n + 1, "%d steps", n);
        /* a plate thinner than two steps, thicker than one */
        real lo = (real)2.5 - (real)0.005, tmax = (real)0.0075 * (real)n;
        if (n < 512) continue;
        for (int k = 0; k < 50; k++) {
            ray r = {{0, 0, lo + (real)0.0003 * (real)k}, 0, {0, 0, -1}, tmax};
            check(first_implicit_hit(plate, r, n, &h), "steps of .0075 see .01, %d of 50", k);
        }
    }
}

/* Rays anywhere: nearly all are right, none is made up, t but for the rounding of f. */
static void test_easy(void)
{
    for (int q = IMPLICIT_SPHERE; q <= IMPLICIT_BARTH; q++) {
        implicit_subject u = implicit_subject_of((implicit_name)q);
        implicit_survey y = implicit_survey_of(&u, (implicit_how){IMPLICIT_FIRST, 512, 0}, 12,
                                               IMPLICIT_ANYWHERE, check_count(4000), 1);
        check_at_least(y.due, check_count(4000) / 3, "%s: the test sees hits", implicit_name_of[q]);
        check_at_most(y.missed, 0.5, "%s: missed by 512 steps [%%]", implicit_name_of[q]);
        check_equal(y.made_up, 0, "%s: made up", implicit_name_of[q]);
        check_at_most(y.off, real_is_float ? 1e-3 : 1e-10, "%s: t", implicit_name_of[q]);
    }
}

/* "Wrong where f touches 0 between two steps, or crosses it twice: thin parts, ..." Rims:
 * test_nothing_missed in 05_implicit.c. */
static void test_thin(void)
{
    size_t seen[2] = {0}, ring[2] = {0}, n = 400 + check_count(4000);
    const implicit_ring k = {1, (real)0.005};
    const implicit_surface thin = implicit_torus(&k);
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(13, i, 0);
        real x = random_between(&s, (real)-0.6, (real)0.6), a = 2 * pi * random_next(&s);
        ray r = {{x, 0, 2 + random_next(&s)}, 0, {0, 0, -1}, 5};
        hit h;
        for (int j = 0; j < 2; j++)  /* 5 / 50 is ten times the plate, 5 / 1000 half of it */
            seen[j] += first_implicit_hit(plate, r, j ? 1000 : 50, &h);
        real far = random_between(&s, (real)0.9955, (real)1.0045);
        r = ray_from(vec(0, 0, 3), vec(far * cos(a), far * sin(a), -3));
        ring[0] += implicit_first_hit(&thin, r, 32, &h), ring[1] += implicit_hit(&thin, r, &h);
    }
    check_at_most(seen[0], n / 5, "50 steps pass most of a thin plate, of %zu", n);
    check_equal(seen[1], n, "1000 steps do not");
    check_at_most(ring[0], n / 2, "32 steps see less than half of a thin ring, of %zu", n);
    check_equal(ring[1], n, "implicit_hit sees all of it");
    hit h = {7, 7, 7, 7};
    ray touch = {{-2, 0, 1}, 0, {1, 0, 0}, 4};
    check(!first_implicit_hit(pair, touch, 1001, &h) && h.t == 7, "no change of sign");
}

/* Answers without meaning, but answers. */
static void test_degenerate(void)
{
    const real strange[] = {0, (real)NAN, real_infinity, -real_infinity, real_largest};
    size_t untouched = 0, cases = 0;
    for (int k = 0; k < 8; k++)
        for (int what = 0; what < 5; what++) {
            real v[8] = {0, 0, 3, 0, 0, -1, 0, 9};
            hit h = {7, 7, 7, 7};
            v[k] = strange[what];
            ray r = {{v[0], v[1], v[2]}, v[6], {v[3], v[4], v[5]}, v[7]};
            bool is = first_implicit_hit(pair, r, 50, &h);
            cases++, untouched += is == (h.u == 0);
        }
    check_equal(untouched, cases, "a miss leaves *out alone, a hit does not");
}

int main(void)
{
    return check_all("05_first", test_normal, test_heart, test_steps, test_easy, test_thin,
                     test_degenerate);
}
