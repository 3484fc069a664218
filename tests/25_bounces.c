/* Tests of 25_bounces, second part: paths, branches, terms, in rooms where the answer is known.
 * Fixed seeds; each random test alarms falsely once in 1e8 seeds. */
#include "../chapters/25_bounces/branching.h"
#include "../chapters/25_bounces/lab/furnace.h"
#include "../chapters/25_bounces/lab/notes_shade.h"
#include "../chapters/25_bounces/lab/transport.h"
#include "../chapters/22_radiometry/lab/oracle.h"
#include "../chapters/25_bounces/terms.h"
#include "../common/lab/t_test.h"
#include "../chapters/24_direct_light/scenes/lit_cornell.h"
#include "check.h"

#define alarm 1e-8
#define eps ((double)real_epsilon)
static const vec3 one = {1, 1, 1}, dark = {0, 0, 0};
static const char *const choice_name[] = {"uniform", "cosine", "BRDF"};

static bool same(vec3 a, vec3 b) { return memcmp(&a, &b, sizeof a) == 0; }

/* Sample k of pixel i, its pair 0 spent on the pixel. */
static sampler second_pair(uint64_t i, uint32_t k)
{
    sampler s = sampler_start(SEQUENCE_RANDOM, 25, i, k, 1);
    (void)sampler_pair(&s);
    return s;
}

/* term[k]: a sample of K^k E, by the naive path. */
static void bounce_terms(const naive_path *p, ray eye, sampler *s, vec3 *term, bounce_counts *c)
{
    for (int k = 0; k <= p->depth; k++) term[k] = dark;
    naive_terms(p, eye, s, term, &c->walk);
}

/* From somewhere within .1 of `from`, anywhere: rays that a closed room must stop. */
static ray some_ray(vec3 from, uint64_t i)
{
    vec3 d = sample_sphere(random_real(25, 1, i, 0), random_real(25, 1, i, 1));
    vec3 o = vmadd(from, sample_sphere(random_real(25, 1, i, 2), random_real(25, 1, i, 3)),
                   0.1);
    return (ray){o, 0, vscale(d, 1 + random_real(25, 1, i, 4)), real_infinity};
}

static void furnace(int kind, lit_scene *s, vec3 E, vec3 rho)
{
    if (kind) furnace_box(s, E, rho);
    else furnace_sphere(s, E, rho);
}

/* ---- furnace: with cosine sampling each weight is rho, and there is no variance ---- */

static void test_furnace_exact(void)
{
    static const int depth[] = {0, 1, 2, 7, 40};
    vec3 E = {1, 2, 0.5}, rho = {0.2, 0.8, 0.99};
    for (int kind = 0; kind < 2; kind++) {
        lit_scene s;
        furnace(kind, &s, E, rho);
        for (int k = 0; k < 5; k++) {
            naive_path p = {&s, DIRECTIONS_BRDF, depth[k], false};
            naive_counts c = {{0}, 0, 0};
            size_t n = check_count(500);
            double worst = 0;
            for (size_t i = 0; i < n; i++) {
                sampler r = second_pair(0, (uint32_t)i);
                vec3 L = naive_radiance(&p, some_ray(dark, i), &r, &c);
                for (int j = 0; j < 3; j++) {
                    double sum = (double)series_sum(vaxis(E, j), vaxis(rho, j), (real)depth[k]);
                    worst = check_worse(worst, fabs((double)vaxis(L, j) / sum - 1));
                }
            }
            /* a product and a sum a bounce, eps/2 each; series_sum 8 */
            check_at_most(worst, (depth[k] + 8) * eps, "E (1 - rho^(n+1)) / (1 - rho), n = %d, %s",
                          depth[k], kind ? "box" : "sphere");
            check_equal(c.escaped, 0, "closed: nothing escapes");
            check_equal(naive_rays(&c), n * (size_t)(depth[k] + 1), "one ray a bounce");
        }
        lit_free(&s);
    }
}

/* Powers of two: no rounding, and the very last bounce that counts. */
static void test_endless(void)
{
    lit_scene s;
    vec3 half = {0.5, 0.5, 0.5};
    furnace_sphere(&s, one, half);
    naive_path p = {&s, DIRECTIONS_BRDF, naive_endless, false};
    naive_counts c = {{0}, 0, 0};
    sampler r = second_pair(1, 0);
    vec3 L = naive_radiance(&p, some_ray(dark, 1), &r, &c);
    check(L.x == 2 && L.y == 2 && L.z == 2, "E / (1 - 1/2) = 2 to the last bit");
    check_equal(naive_rays(&c), real_is_float ? 127 : 1023, "until 2^-k is no normal number");
    lit_free(&s);

    /* .6 and .8: the smallest number of all, times these, rounds to itself */
    check((real)0.6 * nextafter((real)0, (real)1) > 0, "so at 0 no path would end");
    furnace_box(&s, one, vec(0.6, 0.8, 0.5));
    c = (naive_counts){{0}, 0, 0}, r = second_pair(4, 0);
    L = naive_radiance(&p, some_ray(dark, 3), &r, &c);
    double hits = ceil(log((double)real_smallest) / log((double)(real)0.8));
    check_close((double)L.y, 5, 64 * eps, "E / (1 - .8)");
    check_close((double)naive_rays(&c), hits, 1, "until .8^k is no normal number");
    naive_counts tree = {{0}, 0, 0};
    p.depth = branching_most;
    vec3 T = branching_radiance(&p, 1, some_ray(dark, 3), 25, 4, 0, &tree);
    check_close((double)T.x, 2.5, 64 * eps, "E / (1 - .6)");
    p.depth = 1000, tree = (naive_counts){{0}, 0, 0};
    (void)branching_radiance(&p, 1, some_ray(dark, 3), 25, 4, 0, &tree);
    check_equal(naive_rays(&tree), branching_most + 1, "and no deeper");
    lit_free(&s);

    furnace_sphere(&s, one, one);  /* rho = 1: linear growth */
    for (int n = 10; n <= 1000; n *= 10) {
        p.depth = n;
        r = second_pair(2, 0);
        L = naive_radiance(&p, some_ray(dark, 2), &r, &c);
        check(L.x == (real)(n + 1), "rho = 1: n + 1 terms of 1, n = %d", n);
    }
    lit_free(&s);
}

/* ---- furnace, uniform directions: mean (25.5), variance (25.12), for N = 1, 2, 4 ---- */

static void test_furnace_uniform(void)
{
    vec3 rho = {0.3, 0.6, 0.9};
    for (int kind = 0; kind < 2; kind++)
        for (int N = 1; N <= 4; N *= 2) {
            lit_scene s;
            estimate mean[3] = {{0, 0, 0}}, square[3] = {{0, 0, 0}};
            naive_counts c = {{0}, 0, 0};
            int depth = N == 1 ? 8 : 4;
            furnace(kind, &s, one, rho);
            naive_path p = {&s, DIRECTIONS_UNIFORM, depth, false};
            size_t n = check_sample(N == 4 ? 300 : 6000, N == 4 ? 100 : 2000);
            for (size_t i = 0; i < n; i++) {
                vec3 L = branching_radiance(&p, N, some_ray(dark, i), 7, 0, i, &c);
                for (int j = 0; j < 3; j++) {
                    double x = (double)vaxis(L, j);
                    double d = x - (double)series_sum(1, vaxis(rho, j), (real)depth);
                    mean[j] = estimate_add(mean[j], x), square[j] = estimate_add(square[j], d * d);
                }
            }
            for (int j = 0; j < 3; j++) {
                double S = (double)series_sum(1, vaxis(rho, j), (real)depth);
                double V = furnace_variance(N, (double)vaxis(rho, j), depth);
                check_at_least(t_test(mean[j], S, 100 * eps * S), alarm,
                               "mean %g +- %g, exact %g, N = %d", mean[j].mean,
                               estimate_error(mean[j]), S, N);
                check_at_least(t_test(square[j], V, 100 * eps * V), alarm,
                               "variance %g +- %g, exact %g, N = %d", square[j].mean,
                               estimate_error(square[j]), V, N);
            }
            check_equal((double)naive_rays(&c), (double)n * first_rays_of_branching(N, depth),
                        "(N^(d+1) - 1) / (N - 1) rays, N = %d", N);
            lit_free(&s);
        }
    check_equal(first_rays_of_branching(8, 5), 37449, "N = 8");
    check_close(furnace_variance(1, 0.75, 1), 0.1875, 1e-15, "V_1 = rho^2 / 3");
}

/* ---- two materials: the linear system of (25.11), whole and term by term ---- */

/* A ball (0) of radius r in the middle of a sphere (1) of radius 1. By symmetry each has one
 * radiance all over. The ball sees the sphere alone; of what leaves the sphere, r^2 goes to the
 * ball:
 *
 *   K = | 0            rho_0       |                                                       (25.11)
 *       | rho_1 r^2    rho_1 (1 - r^2) |
 */
static void furnace_pair(lit_scene *s, real r, const vec3 E[2], const vec3 rho[2])
{
    lit_begin(s);
    for (int k = 0; k < 2; k++) {
        uint16_t m = lit_add_material(s, (material){.kd = rho[k], .ke = E[k]});
        lit_add_shape(s, shape_of_sphere((sphere){{0, 0, 0}, k ? -1 : r}), m);
    }
    lit_end(s);
}

static transport furnace_transport(double r, const vec3 E[2], const vec3 rho[2], int channel)
{
    double a = (double)vaxis(rho[0], channel), b = (double)vaxis(rho[1], channel);
    return (transport){{(double)vaxis(E[0], channel), (double)vaxis(E[1], channel)},
                       {{0, a}, {b * r * r, b * (1 - r * r)}}};
}

static void test_pair(void)
{
    enum { depth = 7 };  /* a product of k weights 2 rho cos has the skewness 2^k / (4/3)^(3k/2) */
    static const direction_choice draws[] = {DIRECTIONS_UNIFORM, DIRECTIONS_COSINE};
    vec3 E[2] = {{1, 0, 3}, {0, 1, 0.25}};
    vec3 rho[2] = {{0.9, 0.5, 0.2}, {0.6, 0.8, 1}};
    lit_scene s;
    furnace_pair(&s, 0.5, E, rho);
    for (int way = 0; way < 2; way++)
        for (int seen = 0; seen < 2; seen++) {
            naive_path p = {&s, draws[way], depth, false};
            estimate e[3][depth + 1], whole[3];
            memset(e, 0, sizeof e), memset(whole, 0, sizeof whole);
            bounce_counts c = {.direct = {0, 0, 0}};
            for (size_t i = 0; i < check_sample(8000, 2000); i++) {
                vec3 o = {0, 0.7, 0}, d = {0, seen ? 1 : -1, 0}, term[depth + 1], L = dark;
                sampler r = second_pair((uint64_t)seen, (uint32_t)i);
                bounce_terms(&p, (ray){o, 0, d, real_infinity}, &r, term, &c);
                for (int k = 0; k <= depth; k++) {
                    L = vadd(L, term[k]);
                    for (int j = 0; j < 3; j++)
                        e[j][k] = estimate_add(e[j][k], (double)vaxis(term[k], j));
                }
                for (int j = 0; j < 3; j++) whole[j] = estimate_add(whole[j], (double)vaxis(L, j));
            }
            for (int j = 0; j < 3; j++) {
                double T[2], S[2];
                transport t = furnace_transport(0.5, E, rho, j);
                for (int k = 0; k <= depth; k++) {
                    transport_bounces(&t, k, false, T);
                    check_at_least(t_test(e[j][k], T[seen], 100 * eps * T[seen]), alarm,
                                   "K^%d E: %g, exact %g", k, e[j][k].mean, T[seen]);
                }
                transport_bounces(&t, depth, true, S);
                check_at_least(t_test(whole[j], S[seen], 100 * eps * S[seen]), alarm,
                               "%s, patch %d, channel %d: %g +- %g, exact %g",
                               choice_name[draws[way]], seen, j, whole[j].mean,
                               estimate_error(whole[j]), S[seen]);
            }
            check_equal(c.walk.escaped, 0, "nothing escapes between two spheres");
        }
    lit_free(&s);
}

/* ---- Cornell box ---- */

static ray cornell_ray(uint64_t i)
{
    return camera_ray(cornell_camera(1), (real)random_real(25, 2, i, 0),
                      (real)random_real(25, 2, i, 1), 1, 1);
}

static void test_terms_add_up(void)
{
    enum { depth = 6 };
    lit_scene s;
    lit_cornell(&s);
    s.background = vec(0.1, 0.2, 0.3);
    for (int way = DIRECTIONS_UNIFORM; way <= DIRECTIONS_BRDF; way++) {
        size_t wrong = 0, cut = 0, branch = 0, n = check_count(3000);
        for (size_t i = 0; i < n; i++) {
            naive_path p = {&s, (direction_choice)way, depth, false}, q = p;
            bounce_counts c = {.direct = {0, 0, 0}};
            vec3 term[depth + 1], shorter[depth + 1], sum = dark;
            sampler a = second_pair(i, 0), b = a, d = a;
            bounce_terms(&p, cornell_ray(i), &a, term, &c);
            for (int k = 0; k <= depth; k++) sum = vadd(sum, term[k]);
            vec3 L = naive_radiance(&p, cornell_ray(i), &b, &c.walk);
            wrong += !same(sum, L);
            branch += !same(L, branching_radiance(&p, 1, cornell_ray(i), 25, i, 0, &c.walk));
            q.depth = (int)(i % depth);
            bounce_terms(&q, cornell_ray(i), &d, shorter, &c);
            for (int k = 0; k <= q.depth; k++) cut += !same(term[k], shorter[k]);
        }
        check_equal(wrong, 0, "E + KE + ... + K^6 E is the whole, bit by bit, %s",
                    choice_name[way]);
        check_equal(cut, 0, "a path that ends sooner has the same first terms");
        check_equal(branch, 0, "branching with N = 1 is the path, bit by bit");
    }
    lit_free(&s);
}

/* A point of the floor that sees all of the light: K E = rho / pi L times Lambert's (22.15). */
static void test_direct_closed_form(void)
{
    lit_scene s;
    lit_cornell(&s);
    ray eye = {{400, 100, 150}, 0, {0, -1, 0}, real_infinity};
    rectangle lamp = {cornell_corner, cornell_side_s, cornell_side_t};
    double E = rectangle_irradiance_exact(lamp, (vec3){400, 0, 150}, (vec3){0, 1, 0}) / (double)pi;
    double exact = (double)(cornell_radiance.y * cornell_reflectance[0].y) * E;
    naive_path path = {&s, DIRECTIONS_BRDF, 1, false};
    estimate e = {0, 0, 0};
    bounce_counts c = {.direct = {0, 0, 0}};
    size_t n = check_count(20000);
    for (size_t i = 0; i < n; i++) {
        vec3 term[2];
        sampler r = second_pair(5, (uint32_t)i);
        bounce_terms_lit(&path, eye, &r, term, &c);
        e = estimate_add(e, (double)term[1].y);
    }
    check_at_least(t_test(e, exact, 1000 * eps * exact), alarm, "KE %g +- %g, exact %g", e.mean,
                   estimate_error(e), exact);
    check_at_most(estimate_error(e), 3e-3 * exact, "a test that can tell");
    check_equal(c.direct.shadow, n, "one ray of sight a sample");
    check_equal(naive_rays(&c.walk), n, "and none that goes on: the last K was the light's");
    lit_free(&s);
}

/* Paths that meet light, against rays of sight to it: the same means, term by term. Bright walls
 * of a background make the naive way find something; a mirror makes the lit one look for it. */
static void test_terms_lit(void)
{
    enum { depth = 3 };
    for (int more = 0; more < 2; more++) {
        lit_scene s;
        lit_cornell_begin(&s);
        uint16_t shine = lit_add_material(&s, (material){
            .mirror = vec(0.9, 0.8, 0.7)});
        uint16_t lamp = lit_add_material(&s, (material){
            .kd = vec(0.1, 0.2, 0.3), .ke = {3, 2, 1}});
        if (more) {
            s.background = vec(0.5, 0.25, 1);
            lit_add_rectangle(&s, (rectangle){{100, 1, 50}, {0, 0, 300}, {300, 0, 0}}, shine);
        }
        lit_add_shape(&s, shape_of_sphere((sphere){{300, 420, 250}, 90}), lamp);
        lit_end(&s);
        naive_path p = {&s, DIRECTIONS_BRDF, depth, false};
        /* into a corner; or into the mirror, where the lamp's image stands */
        ray eye = {{278, 273, -800}, 0, {40, -273, 1000}, real_infinity};
        if (more) eye = (ray){{350, 100, 60}, 0, {-50, -518, 190}, real_infinity};
        estimate naive[depth + 1][3], lit[depth + 1][3];
        memset(naive, 0, sizeof naive), memset(lit, 0, sizeof lit);
        bounce_counts c = {.direct = {0, 0, 0}};
        for (size_t i = 0; i < check_sample(20000, 2000); i++) {
            vec3 a[depth + 1], b[depth + 1];
            sampler r = second_pair(6, (uint32_t)i), q = second_pair(7, (uint32_t)i);
            bounce_terms(&p, eye, &r, a, &c), bounce_terms_lit(&p, eye, &q, b, &c);
            for (int k = 0; k <= depth; k++)
                for (int j = 0; j < 3; j++) {
                    naive[k][j] = estimate_add(naive[k][j], (double)vaxis(a[k], j));
                    lit[k][j] = estimate_add(lit[k][j], (double)vaxis(b[k], j));
                }
        }
        for (int k = 0; k <= depth; k++)
            for (int j = 0; j < 3; j++) {
                estimate a = naive[k][j], b = lit[k][j];
                bool same_number = fabs(a.mean - b.mean) <= 1000 * eps * a.mean;
                check_at_least(same_number ? 1 : welch_test(a, b), alarm,
                               "scene %d, K^%d E, channel %d: %g and %g", more, k, j, a.mean,
                               b.mean);
                if (k) check_at_least(a.mean, 1e-3, "and it is something");
            }
        lit_free(&s);
    }
}

/* ---- shade() as printed: fails where it must ---- */

static void test_notes(void)
{
    lit_scene s;
    naive_counts c = {{0}, 0, 0};
    vec3 half = {0.5, 0.5, 0.5};
    furnace_sphere(&s, one, half);
    naive_path p = {&s, DIRECTIONS_BRDF, 100, false};
    sampler r = second_pair(9, 0);
    check_equal((double)notes_shade(&p, some_ray(dark, 9), &r, &c).x, 0.5, "rho E, not 2");
    lit_free(&s);
    /* the ball is no light: its one term is the sphere's E, and nothing that the sphere reflects */
    furnace_pair(&s, 0.5, (vec3[]){dark, one}, (vec3[]){half, half});
    ray down = {{0, 0.7, 0}, 0, {0, -1, 0}, real_infinity};
    r = second_pair(9, 1);
    check_equal((double)notes_shade(&p, down, &r, &c).x, 0.5, "rho_0 E_1: the light's K is lost");
    transport t = furnace_transport(0.5, (vec3[]){dark, one}, (vec3[]){half, half}, 0);
    double L[2];
    check(transport_solve(&t, L) && L[0] > 0.75, "of %g", L[0]);
    lit_free(&s);
    /* no emitter but the background, seen past a grey ball: there it is right */
    lit_begin(&s);
    lit_add_shape(&s, shape_of_sphere((sphere){dark, 0.5}),
                  lit_add_material(&s, (material){.kd = half}));
    lit_end(&s);
    s.background = one, r = second_pair(9, 2);
    check_equal((double)notes_shade(&p, down, &r, &c).x, 0.5, "a convex grey thing under a sky");
    lit_free(&s);
}

/* ---- only what is called for ---- */

/* A box of pure red walls and a pure green lamp, a white lamp that reflects nothing, a black
 * sphere, a glossy wall that sends directions below itself. */
static void hard_scene(lit_scene *s, bool lamps)
{
    lit_begin(s);
    uint16_t m[6], k = 0;
    vec3 red = {0.8, 0, 0}, grey = {0.6, 0.6, 0.6};
    m[k++] = lit_add_material(s, (material){.kd = red});
    m[k++] = lit_add_material(s, (material){.kd = grey});
    m[k++] = lit_add_material(s, (material){.mirror = grey, .alpha = 1});
    m[k++] = lit_add_material(s, (material){.kd = vec(0, 0.8, 0)});
    m[k++] = lit_add_material(s, (material){.kd = dark});
    m[k++] = lit_add_material(s, (material){.kd = dark, .ke = {1, 2, 3}});
    for (int i = 0; i < 6; i++) lit_add_rectangle(s, furnace_wall(i), m[i % 4]);
    lit_add_shape(s, shape_of_sphere((sphere){{0.4, 0.4, 0.4}, 0.2}), m[4]);
    if (lamps) {
        sphere lamp = {{-0.4, -0.4, 0.4}, 0.3};
        lit_add_shape(s, shape_of_sphere(lamp), m[5]);
    }
    lit_end(s);
}

static void test_called_for(void)
{
    lit_scene s;
    vec3 o = {0, 0.5, 0};
    for (int lamps = 0; lamps < 2; lamps++) {
        hard_scene(&s, lamps);
        for (int way = DIRECTIONS_UNIFORM; way <= DIRECTIONS_BRDF; way++) {
            naive_path p = {&s, (direction_choice)way, 5, false}, all = p;
            naive_counts called = {{0}, 0, 0}, many = called;
            naive_counts tree_called = called, tree_many = called;
            size_t wrong = 0, wrong_tree = 0, bright = 0, n = check_sample(1500, 300);
            all.spend_all = true;
            for (size_t i = 0; i < n; i++) {
                sampler a = second_pair(i, 1), b = a;
                vec3 L = naive_radiance(&p, some_ray(o, i), &a, &called);
                wrong += !same(L, naive_radiance(&all, some_ray(o, i), &b, &many));
                bright += !vzero(L);
                if (i % 10) continue;
                vec3 T = branching_radiance(&p, 3, some_ray(o, i), 25, i, 1, &tree_called);
                wrong_tree += !same(T, branching_radiance(&all, 3, some_ray(o, i), 25, i, 1,
                                                          &tree_many));
            }
            check_equal(wrong, 0, "%s: the same with every ray spent", choice_name[way]);
            check_equal(wrong_tree, 0, "%s, N = 3: the same", choice_name[way]);
            check_equal(naive_rays(&many), 6 * n, "spend_all: every ray, to the end");
            if (!lamps) check_equal(naive_rays(&called), 0, "no light, no ray");
            if (!lamps) check_equal(naive_rays(&tree_called), 0, "no light, no tree");
            if (!lamps) continue;
            check_at_least((double)bright, (double)n / 20, "there is something to see");
            check_at_most((double)naive_rays(&called), 0.75 * (double)naive_rays(&many),
                          "a path ends where nothing can follow");
            check_at_most((double)naive_rays(&tree_called), 0.5 * (double)naive_rays(&tree_many),
                          "a branch, too");
            check_at_least(called.black, 1, "black surfaces were met");
        }
        lit_free(&s);
    }
}

/* Rays counted one by one where one knows what must happen. */
static void test_counts(void)
{
    lit_scene s;
    vec3 red = {1, 0, 0}, green = {0, 1, 0};
    naive_counts c = {{0}, 0, 0};
    ray eye = {{0, 0.7, 0}, 0, {0, -3, 0}, real_infinity};
    /* a shining black ball: what the eye sees of it, one ray, and no random number asked for */
    furnace_pair(&s, 0.5, (vec3[]){{5, 6, 7}, dark}, (vec3[]){dark, one});
    naive_path p = {&s, DIRECTIONS_BRDF, 50, false};
    sampler r = second_pair(0, 0);
    check(same(naive_radiance(&p, eye, &r, &c), (vec3){5, 6, 7}), "the eye's own view of a light");
    check_equal(naive_rays(&c), 1, "black: the path ends");
    check_equal(c.black, 1, "and that was why");
    check_equal(r.pair, 1, "no direction drawn");
    c = (naive_counts){{0}, 0, 0};
    (void)branching_radiance(&p, 8, eye, 1, 1, 1, &c);
    check_equal(naive_rays(&c), 1, "no branch from what is black");
    lit_free(&s);
    /* a red ball in a green sphere: nothing survives the second reflection */
    furnace_pair(&s, 0.5, (vec3[]){one, one}, (vec3[]){red, green});
    c = (naive_counts){{0}, 0, 0}, r = second_pair(0, 0);
    vec3 L = naive_radiance(&p, eye, &r, &c);
    check_equal(naive_rays(&c), 2, "red, then green: two rays, the third would bring nothing");
    check_close(L.x, 2, 4 * eps, "E + rho E in red"), check_equal(L.y, 1, "E in green");
    lit_free(&s);
    /* depth 0: only what the eye sees; a background without emitters is light, too */
    lit_begin(&s), lit_end(&s);
    s.background = (vec3){1, 2, 3};
    c = (naive_counts){{0}, 0, 0}, p.depth = 0;
    check(same(naive_radiance(&p, eye, &r, &c), s.background), "an empty scene: the background");
    check_equal(c.escaped, 1, "the ray escaped"), check_equal(c.rays[0], 1, "counted as a ray");
    lit_free(&s);
}

/* A wall that leans by its shading normals alone, a lamp behind it: no light comes through. */
static void test_shading_normals(void)
{
    vec3 v[4] = {{-1, 0, -1}, {-1, 0, 1}, {1, 0, 1}, {1, 0, -1}};
    vec3 n = vunit(vec(1, 0.3, 0));
    uint32_t index[6] = {0, 1, 2, 0, 2, 3}, of[6] = {0, 0, 0, 0, 0, 0};
    mesh m = {.v = v, .vertices = 4, .index = index, .triangles = 2, .n = &n, .normals = 1,
              .normal_index = of};
    lit_scene s;
    vec3 white = {0.9, 0.9, 0.9};
    bounce_counts c = {.direct = {0, 0, 0}};
    ray eye = {{0, 1, 0}, 0, {-0.1, -1, 0}, real_infinity};
    lit_begin(&s);
    uint16_t wall = lit_add_material(&s, (material){.kd = white});
    uint16_t lamp = lit_add_material(&s, (material){.kd = dark, .ke = one});
    lit_add_mesh(&s, &m, wall);
    lit_add_rectangle(&s, (rectangle){{-9, -1, -9}, {0, 0, 18}, {18, 0, 0}}, lamp);
    lit_end(&s);
    for (int way = DIRECTIONS_UNIFORM; way <= DIRECTIONS_BRDF; way++) {
        naive_path p = {&s, (direction_choice)way, 2, false};
        size_t bright = 0, k = check_sample(1000, 100);
        for (size_t i = 0; i < k; i++) {
            vec3 term[3];
            sampler a = second_pair(8, (uint32_t)i), b = a;
            bright += !vzero(naive_radiance(&p, eye, &a, &c.walk));
            bounce_terms_lit(&p, eye, &b, term, &c);
            bright += !vzero(term[1]);
        }
        check_equal(bright, 0, "%s: nothing shines through a wall", choice_name[way]);
    }
    check_at_least((double)c.walk.rays[1], 10, "though directions above it were taken");
    check_equal(c.direct.shadow, 0, "no ray of sight through it");
    lit_free(&s);
}

/* How long the eye's direction is does not matter: times 4 is exact. Glossy walls see wo. */
static void test_eye_length(void)
{
    lit_scene s;
    size_t wrong = 0;
    hard_scene(&s, true);
    naive_path p = {&s, DIRECTIONS_BRDF, 3, false};
    naive_counts c = {{0}, 0, 0};
    for (size_t i = 0; i < check_sample(500, 100); i++) {
        ray r = some_ray(vec(0, 0.5, 0), i), far = r;
        far.d = vscale(r.d, 4);
        sampler a = second_pair(i, 2), b = a;
        vec3 L = naive_radiance(&p, r, &a, &c);
        wrong += !same(L, naive_radiance(&p, far, &b, &c));
        wrong += !same(branching_radiance(&p, 2, r, 1, i, 0, &c),
                       branching_radiance(&p, 2, far, 1, i, 0, &c));
    }
    check_equal(wrong, 0, "the same light along a longer direction");
    lit_free(&s);
}

int main(void)
{
    return check_all("25_bounces", test_furnace_exact, test_endless, test_furnace_uniform,
                     test_pair, test_terms_add_up, test_direct_closed_form,
                     test_terms_lit, test_notes, test_called_for, test_counts,
                     test_shading_normals, test_eye_length);
}
