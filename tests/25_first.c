/* 25's first.h: its terms against those of terms.h, and against a furnace; its rays against (25.9);
 * the rows of the main table against its reference. Fixed seeds; each comparison by chance alarms
 * falsely once in 1e8 seeds. */
#include "../common/lab/t_test.h"
#include "../chapters/24_direct_light/scenes/lit_first.h"
#include "../chapters/25_bounces/first.h"
#include "../chapters/25_bounces/lab/furnace.h"
#include "../chapters/25_bounces/lab/measure_branches.h"
#include "../chapters/25_bounces/terms.h"
#include "check.h"
#include "first_cube.h"

static const double false_alarm = 1e-8;
static const double sigmas = 5.8;
/* With N = 1, with N = 2: at 5 bounces it would send 63 rays a sample. */
enum { depth = 5, depth_of_two = 3 };

/* ---- the Cornell box: E, K E, .. K^5 E, mean over the picture, red and blue ---- */

typedef struct { estimate e[2][depth + 1]; } terms_seen;

static void seen(terms_seen *t, int k, vec3 c)
{
    t->e[0][k] = estimate_add(t->e[0][k], (double)c.x);
    t->e[1][k] = estimate_add(t->e[1][k], (double)c.z);
}

static ray eye_ray(uint64_t i, random_stream *random)
{
    *random = random_start(1, i, 0);
    real x = random_next(random), y = random_next(random);
    return first_camera_ray(first_cornell_camera(1, 1), x, y);
}

static terms_seen by_first(int N, size_t n)
{
    static terms_seen t;
    first_scene s = first_cornell();
    memset(&t, 0, sizeof t);
    for (size_t i = 0; i < n; i++)
        for (int k = 0; k <= (N == 1 ? depth : depth_of_two); k++) {
            random_stream random;
            ray r = eye_ray(i, &random);
            random = random_start(2 + (uint64_t)N, i, (uint64_t)k);
            seen(&t, k, first_term(&s, r, k, N, &random));
        }
    return t;
}

static terms_seen by_terms(size_t n)
{
    static terms_seen t;
    first_scene f = first_cornell();
    lit_scene s;
    bounce_counts c = {.direct = {0, 0, 0}};
    naive_path p = {&s, DIRECTIONS_BRDF, depth, false};
    vec3 term[depth + 1];
    memset(&t, 0, sizeof t);
    lit_first(&f, &s);
    for (size_t i = 0; i < n; i++) {
        random_stream random;
        ray r = eye_ray(i, &random);
        sampler q = sampler_start(SEQUENCE_RANDOM, 9, i, 0, 1);
        bounce_terms_lit(&p, r, &q, term, &c);
        for (int k = 0; k <= depth; k++) seen(&t, k, term[k]);
    }
    lit_free(&s);
    return t;
}

/* Both see E along the same rays: the same numbers. The rest differs by chance alone. */
static void test_terms(void)
{
    size_t n = check_count(200000);
    terms_seen lit = by_terms(n);
    for (int N = 1; N <= 2; N++) {
        terms_seen first = by_first(N, n / (size_t)N);
        for (int j = 0; j < 2; j++)
            for (int k = 0; k <= (N == 1 ? depth : depth_of_two); k++) {
                estimate a = first.e[j][k], b = lit.e[j][k];
                if (N == 1 && k == 0) check_equal(a.mean, b.mean, "E, channel %d", j);
                double error = hypot(estimate_error(a), estimate_error(b));
                check_close(a.mean, b.mean, sigmas * error, "K^%d E, N = %d, channel %d", k, N, j);
                if (k) check_at_most(error, 16 / sqrt((double)n) * b.mean, "the noise of both");
            }
    }
}

/* ---- the main table ---- */

/* All rows have the mean of the reference, which asks the lamp by its angle: all are unbiased, and
 * Welch's test allows for the noise of both. Directions meet the lamp once in some hundred: fewer
 * samples than these have no t. */
static void test_rows(void)
{
    branch_survey *b = allocate(1, sizeof *b);
    options o = {.seed = 7};
    trials_begin(b, &o);
    estimate truth[trial_depths] = {{0}};
    uint64_t n = check_sample(60000, 30000);
    for (uint64_t i = 0; i < n; i++) {
        double sum[trial_depths];
        sampler s = sampler_start(SEQUENCE_RANDOM, 8, i, 0, 1);
        trial_truth(b, i % trial_pixels, &s, sum);
        for (int j = 0; j < trial_depths; j++) truth[j] = estimate_add(truth[j], sum[j]);
    }
    for (int k = 0; k < trials; k++) {
        estimate e = {0}, exact = truth[trial_row[k].depth];
        uint64_t few = k >= trial_terms ? n : trial_most_rays(k) > 1000 ? n / 20 : n / 2;
        if (trial_most_rays(k) > 10000) continue;  /* N = 8, five bounces: some ms a sample */
        for (uint64_t i = 0; i < few; i++) {
            trial_counts w = {.first = 0};
            size_t pixel = i % trial_pixels;
            e = estimate_add(e, trial_sample(b, k, pixel, i, &w));
        }
        check_at_least(welch_test(e, exact), false_alarm, "row %d: %g +- %g, reference %g +- %g", k,
                       e.mean, estimate_error(e), exact.mean, estimate_error(exact));
        if (k >= trial_terms)
            check_at_most(estimate_error(e), 1.2 / sqrt((double)n) * exact.mean, "little noise");
    }
    trials_end(b), free(b);
}

/* ---- a closed room ---- */

/* In a furnace all walls shine, and first_term asks thing 0 alone. But K is linear: K of the sum is
 * the sum of six rooms, in each of which another wall shines, K E_1 + ... + K E_6 = rho E. One hit,
 * off the edges: a lamp that touches the wall has no finite variance by area, averaged over it. */
static void test_furnace(void)
{
    const vec3 E = {1, 2, 3}, rho = {(real)0.5, (real)0.9, 1};
    estimate e[3] = {{0, 0, 0}};
    for (uint64_t i = 0; i < check_count(40000); i++) {
        vec3 emitted = {0, 0, 0}, sum = {0, 0, 0};
        for (int w = 0; w < 6; w++) {
            first_scene s = first_cube(w, (first_material){.kd = rho}, E, (real)1e-5);
            random_stream random = random_start(3, i, (uint64_t)w);
            ray r = ray_from(vec(0, 0, 0), vec(1, 0.3, -0.4));
            emitted = vadd(emitted, first_term(&s, r, 0, 1, &random));
            sum = vadd(sum, first_term(&s, r, 1, 1, &random));
        }
        if (i == 0) check(emitted.x == 1 && emitted.y == 2 && emitted.z == 3, "E is seen once");
        for (int k = 0; k < 3; k++) e[k] = estimate_add(e[k], (double)vaxis(sum, k));
    }
    for (int k = 0; k < 3; k++) {
        double exact = (double)(vaxis(E, k) * vaxis(rho, k));
        check_at_least(t_test(e[k], exact, 64 * (double)real_epsilon * exact), false_alarm,
                       "K E = rho E: %g, is %g", exact, e[k].mean);
        check_at_most(estimate_error(e[k]), 0.01 * exact, "known to 1 %%");
    }
}

/* Nothing escapes: each term takes (25.9), whatever the walls do. eps as small as can be: where it
 * reaches across an edge, a ray that leaves there passes the next wall by. Float's has to be
 * larger, and loses a few. */
static void test_rays(void)
{
    first_material m = {.kd = {1, 1, 1}};
    first_scene s = first_cube(2, m, (vec3){1, 1, 1}, real_is_float ? (real)1e-5 : (real)1e-13);
    double rays = 0, due = 0;
    for (int N = 1; N <= 3; N++)
        for (int k = 0; k <= 5; k++)
            for (uint64_t i = 0; i < check_count(1000); i++) {
                random_stream random = random_start(4, i, (uint64_t)(8 * N + k));
                real x = random_next(&random), y = random_next(&random);
                long before = first_bounce_rays;
                first_term(&s, ray_from(vec(0, 0, 0), (vec3){1, x, y}), k, N, &random);
                rays += (double)(first_bounce_rays - before);
                due += first_rays_of_branching(N, k);
            }
    check_close(rays / due, 1, real_is_float ? 1e-3 : 0, "rays of K^k E, N a hit: %g, due %g",
                rays, due);
    check_equal(first_rays_of_branching(1, 5), 6, "N = 1");
    check_equal(first_rays_of_branching(4, 5), 1365, "N = 4");
    check_equal(first_rays_of_branching(16, 5), 1118481, "N = 16: more than a million");
}

/* (25.5), and "what comes after the last term is missing": of the whole, the part rho^(n+1). */
static void test_sums(void)
{
    double worst = 0, missing = 0;
    for (uint64_t i = 0; i < check_count(10000); i++) {
        real E = random_real(5, i, 0, 0), rho = random_real(5, i, 0, 1) * (real)0.99;
        int n = (int)(100 * random_real(5, i, 0, 2));
        double sum = first_furnace((double)E, (double)rho, n);
        double whole = (double)E / (1 - (double)rho), full = (double)series_sum(E, rho, (real)n);
        double left = 1 - sum / whole;
        worst = check_worse(worst, fabs(sum - full) / full);
        missing = check_worse(missing, fabs(left - pow((double)rho, n + 1.0)));
    }
    check_at_most(worst, 64 * (double)real_epsilon, "first_furnace against series_sum");
    check_at_most(missing, 1e-13, "the part that is missing, rho^(n+1)");
    check_close(first_furnace(1, 0.9, 3), 3.439, 1e-12, "four terms of rho = .9; the whole is 10");
    check_equal(first_furnace(1, 1, 9), 10, "rho = 1 has partial sums, and no whole");
}

/* One level of recursion a bounce: a thousand are no danger for the stack. */
static void test_odd_input(void)
{
    first_scene empty = {.eps = (real)1e-5}, s = first_cube(0, (first_material){.kd = {1, 1, 1}},
                                                      (vec3){1, 1, 1}, (real)1e-5);
    random_stream random = random_start(6, 0, 0);
    ray r = ray_from(vec(0, 0, 0), vec(-1, 0, 0));
    check(vzero(first_term(&empty, r, 3, 2, &random)), "an empty scene is black");
    check(vfinite(first_term(&s, r, 1000, 1, &random)), "a thousand bounces");
    check_equal(first_term(&s, r, -5, 1, &random).x, 1, "fewer than none are none");
    r.d = vec((double)NAN, 0, 0);
    check(vzero(first_term(&s, r, 3, 2, &random)), "a ray of NaN meets nothing");
    r.d = vec(0, 0, 0);
    check(vzero(first_term(&s, r, 3, 2, &random)), "a ray without direction meets nothing");
}

int main(void)
{
    return check_all("25_first", test_terms, test_rows, test_furnace, test_rays,
                     test_sums, test_odd_input);
}
