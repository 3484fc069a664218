/* Tests of 25_bounces, third part: a box of six different walls by a linear system and by paths.
 * Each random test alarms falsely once in 1e8 seeds. */
#include "../chapters/25_bounces/lab/radiosity_box.h"
#include "../chapters/25_bounces/naive_path.h"
#include "../chapters/20_monte_carlo/t_test.h"
#include "check.h"

#define alarm 1e-8
#define eps ((double)real_epsilon)
static const double light[6] = {0, 0.5, 0, 2, 0, 0};
static const double albedo[6] = {0.8, 0.3, 0.6, 0.5, 0.9, 0.2};

static void test_form_factors(void)
{
    enum { m = 3, n = 6 * m * m };
    static const double grey[6] = {1, 1, 1, 1, 1, 1};
    transport t = radiosity_box(grey, grey, m);
    double row = 0, mirror = 0, S[n];
    for (int i = 0; i < n; i++) {
        double sum = 0;
        for (int j = 0; j < n; j++) sum += t.K[i * n + j];
        row = check_worse(row, fabs(sum - 1));
        mirror = check_worse(mirror, t.K[i * n + i]);
    }
    /* n factors of some 16 epsilon of their size each (22) */
    check_at_most(row, 64 * eps, "closed: what leaves a square arrives somewhere");
    check_equal(mirror, 0, "flat: no square sees itself");
    transport_sum(&t, 50, S);
    check_close(S[7], 51, 51 * 51 * 64 * eps, "white, all shining: a term of 1 a bounce");
    transport_free(&t);
}

/* E = 1 and one albedo everywhere: the furnace, whatever the cut. */
static void test_furnace(void)
{
    enum { m = 2, n = 6 * m * m };
    static const double one[6] = {1, 1, 1, 1, 1, 1}, rho[6] = {0.75, 0.75, 0.75, 0.75, 0.75, 0.75};
    double L[n], worst = 0;
    transport t = radiosity_box(one, rho, m);
    check(transport_solve(&t, L), "regular");
    for (int i = 0; i < n; i++) worst = check_worse(worst, fabs(L[i] / 4 - 1));
    check_at_most(worst, 4 * 64 * eps, "E / (1 - rho) = 4 on every square");
    transport_free(&t);
}

static void box_scene(lit_scene *s)
{
    lit_begin(s);
    for (int k = 0; k < 6; k++) {
        real r = (real)albedo[k], e = (real)light[k];
        uint16_t m = lit_add_material(s, (lit_material){.f = brdf_lambert((vec3){r, r, r}),
                                                        .Le = {e, e, e}});
        lit_add_rectangle(s, furnace_wall(k), m);
    }
    lit_end(s);
}

/* One bounce is closed form; all bounces: the step from m = 5 to 10 bounds what 10 leaves out
 * (errors fall with m^2, so it is some 4 times as large). */
static void test_paths(void)
{
    enum { m = 10, small = 5 };
    static const double x[3][2] = {{0.1, -0.2}, {0.7, 0.6}, {-0.85, 0.1}};
    double *L = allocate(6 * m * m, sizeof *L), coarse[6 * small * small], E[6 * m * m];
    lit_scene s;
    box_scene(&s);
    transport fine = radiosity_box(light, albedo, m), rough = radiosity_box(light, albedo, small);
    transport_sum(&fine, 150, L);  /* .9^150 would leave 1e-7, but the radius is near .55 */
    check_at_most(transport_radius(&fine, 200), 0.7, "so the sum is the whole");
    check(transport_solve(&rough, coarse), "regular");
    for (int i = 0; i < 6 * m * m; i++) E[i] = fine.E[i];
    for (int i = 0; i < 3; i++) {
        vec3 p = {(real)x[i][0], -1, (real)x[i][1]};  /* wall 2, the floor */
        ray eye = {{p.x, -0.5, p.z}, 0, {0, -1, 0}, real_infinity};
        double whole = radiosity_at(light, albedo, m, L, p, 2);
        double step = fabs(whole - radiosity_at(light, albedo, small, coarse, p, 2));
        double direct = radiosity_at(light, albedo, m, E, p, 2);
        check_at_most(step, 2e-3 * whole, "m = 5 and 10 agree");
        check_at_least(whole, 1.3 * direct, "and bounces matter");
        for (int way = DIRECTIONS_UNIFORM; way <= DIRECTIONS_COSINE; way++) {
            estimate all = {0, 0, 0}, one = {0, 0, 0};
            naive_counts c = {{0}, 0, 0};
            size_t n = check_count(15000);
            for (size_t k = 0; k < (n > 1000 ? n : 1000); k++) {
                naive_path path = {&s, (direction_choice)way, 30, false};
                sampler r = sampler_start(SEQUENCE_RANDOM, 25, (uint64_t)i, (uint32_t)k, 1), q = r;
                all = estimate_add(all, (double)naive_radiance(&path, eye, &r, &c).x);
                path.depth = 1;
                one = estimate_add(one, (double)naive_radiance(&path, eye, &q, &c).x);
            }
            check_at_least(t_test(one, direct, 100 * eps), alarm, "E + KE: %g +- %g, exact %g",
                           one.mean, estimate_error(one), direct);
            check_at_least(t_test(all, whole, step + 1e-6), alarm,
                           "whole: %g +- %g, exact %g -+ %g", all.mean, estimate_error(all),
                           whole, step);
            check_at_most(estimate_error(all), n < 1000 ? 0.08 * whole : 0.05 * whole,
                          "a test that can tell");
            check_equal(c.escaped, 0, "closed: nothing gets out, at no edge");
        }
    }
    transport_free(&fine), transport_free(&rough), lit_free(&s), free(L);
}

/* Eye rays at points within 16 eps of an edge, and one bounce from there. Without (18.9) one in 250
 * gets out. */
static void test_edges(void)
{
    lit_scene s;
    naive_counts c = {{0}, 0, 0};
    size_t n = check_count(40000);
    furnace_box(&s, (vec3){1, 1, 1}, (vec3){1, 1, 1});
    naive_path p = {&s, DIRECTIONS_COSINE, 1, false};
    for (size_t i = 0; i < n; i++) {
        sampler r = sampler_start(SEQUENCE_RANDOM, 26, 0, (uint32_t)i, 1);
        point2 a = sampler_pair(&r), b = sampler_pair(&r);
        real x[3], side = i & 1 ? 1 : -1;
        x[i % 3] = 2 * a.u - 1, x[(i + 1) % 3] = side;
        x[(i + 2) % 3] = (i & 2 ? 1 : -1) * (1 - 16 * real_epsilon * a.v);
        vec3 o = {b.u - (real)0.5, b.v - (real)0.5, 0};
        (void)naive_radiance(&p, ray_from(o, vsub((vec3){x[0], x[1], x[2]}, o)), &r, &c);
    }
    check_equal(c.escaped, 0, "nothing gets out where two walls meet");
    check_equal(c.rays[1], n, "one bounce each");
    lit_free(&s);
}

int main(void)
{
    test_edges(), test_form_factors(), test_furnace(), test_paths();
    return check_report("25_radiosity");
}
