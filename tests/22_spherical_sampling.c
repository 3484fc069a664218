/* Tests of 22_radiometry: points of triangles and rectangles, uniform in solid angle: chi-square
 * tests against the constant pdf, t-tests against closed forms, tiny, huge, grazing and touching
 * ones. Fixed seeds; a random test alarms falsely once in 1e8 seeds; there are fewer than 100. */
#include "../common/lab/chi_square.h"
#include "../common/lab/t_test.h"
#include "../chapters/22_radiometry/lab/directions.h"
#include "check.h"

#define alarm 1e-8
#define eps ((double)real_epsilon)

static const triangle sail = {{1, -1, 0.5}, {1, 1, 0.5}, {0.5, 0, 2}};

static wide3 wide3_unit(wide3 a)
{
    const wide3 zero = {{0, 0}, {0, 0}, {0, 0}};
    return wide3_madd(zero, a, wide_div(wide_of(1), wide3_length(a)));
}

/* |a - b|^2 is twice 1 - cos of the angle between unit a and b. */
static wide wide3_apart(wide3 a, wide3 b)
{
    wide3 d = wide3_sub(a, b);
    return wide3_dot(d, d);
}

/* How far (u, v) of the sampled point are off, the larger of the two, by 30 digits: the plane
 * through b and x meets the edge a c in c', a b c' has the share u; 1 - cos from b to x is v times
 * that from b to c'. Seen from 0. */
static double uv_off(triangle t, real u, real v)
{
    spherical_triangle k = spherical_triangle_of(t, vec(0, 0, 0));
    vec3 w = spherical_triangle_sample(&k, u, v);
    wide3 a = wide3_of(t.a), b = wide3_of(t.b), c = wide3_of(t.c), zero = {{0, 0}, {0, 0}, {0, 0}};
    wide3 x = wide3_madd(wide3_madd(wide3_madd(zero, a, wide_of((double)w.x)), b,
                                    wide_of((double)w.y)), c, wide_of((double)w.z));
    a = wide3_unit(a), b = wide3_unit(b), c = wide3_unit(c), x = wide3_unit(x);
    wide3 end = wide3_unit(wide3_cross(wide3_cross(b, x), wide3_cross(a, c)));
    if (wide_sign(wide3_dot(end, wide3_madd(a, c, wide_of(1)))) < 0) end = wide3_sub(zero, end);
    double part = (double)wide_solid_angle((wide_corners){a, b, end});
    double whole = (double)wide_solid_angle((wide_corners){a, b, c});
    double share = wide_value(wide_div(wide3_apart(b, x), wide3_apart(b, end)));
    return fmax(fabs(part / whole - (double)u), fabs(share - (double)v));
}

/* (u, v) of sampled points, seen from 0, by 30 digits; weights; and omega is the solid angle. A
 * corner's coordinates are of size 1, so a triangle of the size h knows its points to eps / h; one
 * that nearly touches 0 sees them from the height h, an epsilon along the view eps / h across. */
static void test_triangle_shares(void)
{
    const real h = real_is_float ? (real)0x1p-9 : (real)0x1p-20;
    const real m = real_is_float ? (real)0x1p-36 : (real)0x1p-300;
    const struct { triangle t; double bound; const char *what; } list[] = {
        {sail, 16, "a sail"}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 16, "an octant"},
        {{{-9, -9, 1}, {9, -9, 1}, {0, 12, 1}}, 16, "nearly a hemisphere"},
        {{{1, 0, 0}, {1, h, 0}, {1, 0, h}}, 8 / (double)h, "a tiny one"},
        {{{1, 0, h}, {2, 0, h}, {1, 1, h}}, 64, "a grazing one"},
        {{{-1, -1, h}, {2, -1, h}, {-1, 2, h}}, 8 / (double)h, "nearly touching"},
        {{{m, m, m}, {2 * m, m, m}, {m, 3 * m, m}}, 16, "scaled down"}};
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        const triangle t = list[i].t;
        const char *what = list[i].what;
        spherical_triangle k = spherical_triangle_of(t, seen_from);
        double worst = 0, whole = (double)fabs(triangle_solid_angle(t, seen_from));
        check(k.omega == (real)whole && whole > 0, "%s: omega is the solid angle", what);
        for (int j = 0; j <= 32; j++) {
            real u = (real)j / 32, v = j % 2 ? 1 : (real)0.375;
            vec3 b = spherical_triangle_sample(&k, u, v);
            check(b.x >= 0 && b.y >= 0 && b.z >= 0, "%s: barycentrics are not negative", what);
            check_at_most(fabs((double)(b.x + b.y + b.z) - 1), 4 * eps, "%s: their sum", what);
            worst = check_worse(worst, uv_off(t, u, v));
        }
        check_at_most(worst, list[i].bound * eps, "%s: (u, v)", what);
    }
    const triangle nothing[] = {{{1, 0, 0}, {2, 0, 0}, {1, 1, 0}}, {{2, -1, 0}, {-1, 2, 0},
                                {-1, -1, 0}}, {{1, 1, 1}, {1, 1, 1}, {1, 2, 1}}};
    for (int i = 0; i < 3; i++)  /* in its plane, within itself, without area */
        check_equal(spherical_triangle_of(nothing[i], seen_from).omega, 0, "nothing to see: %d", i);
}

/* Two corners that p sees as nearly opposite of each other, each two in turn: their sum has the
 * length `gap`, and an epsilon of a weight turns x by an epsilon / gap. Measured: .26 to .37 of
 * that; with the corners turned, so that the arc is b c, .4; with 1 + a.b, thousands. */
static void test_long_arcs(void)
{
    size_t n = check_sample(24000, 3000);
    double sum[3] = {0, 0, 0};
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(41, i, 0);
        real gap = pow((real)2, -random_between(&s, 1, real_is_float ? 9 : 20)), x, y;
        vec3 e = vunit(random_in_cube(&s, 1)), f, g;
        vbasis(e, &f, &g);
        x = random_between(&s, 0, pi), y = random_between(&s, (real)0.1, 1);
        vec3 far = vunit(vadd(vneg(e), vscale(f, gap)));
        vec3 level = vadd(vscale(e, cos(x)), vscale(f, sin(x)));
        vec3 side = vmadd(vscale(level, sqrt(1 - y * y)), g, y);
        vec3 v[3] = {e, far, side};
        for (int j = 0; j < 3; j++) v[j] = vscale(v[j], pow((real)2, random_between(&s, -3, 3)));
        size_t turn = i % 3;
        triangle t = {v[turn], v[(turn + 1) % 3], v[(turn + 2) % 3]};
        real u = random_next(&s), w = random_next(&s);
        sum[turn] += uv_off(t, u, w) * (double)gap;
    }
    static const char *const arc[3] = {"a b", "c a", "b c"};
    for (int k = 0; k < 3; k++)
        check_at_most(3 * sum[k] / (double)n, eps / 2, "%s nearly pi: (u, v), on average", arc[k]);
}

/* ---- chi-square: directions in 32 x 32 cells, pdf 1 / omega within ---- */

typedef struct { triangle t; spherical_triangle k; } seen_t;
typedef struct { rectangle r; spherical_rectangle k; } seen_r;

static vec3 s_triangle(real u, real v, const void *context)
{
    const seen_t *s = context;
    vec3 b = spherical_triangle_sample(&s->k, u, v);
    return vunit(triangle_at(s->t, b.y, b.z));
}

static real d_triangle(vec3 w, const void *context)
{
    const seen_t *s = context;
    hit h;
    return triangle_hit(s->t, ray_from(seen_from, w), &h) ? 1 / s->k.omega : 0;
}

static vec3 s_halves(real u, real v, const void *context)
{
    const seen_r *s = context;
    return vunit(rectangle_at(s->r, spherical_rectangle_sample_halves(&s->k, u, v)));
}

static real d_rectangle(vec3 w, const void *context)
{
    const seen_r *s = context;
    return rectangle_met(s->r, w) ? 1 / s->k.omega : 0;
}

/* The expectations of cells that the border cuts are known to 1 / 128 of them only: few samples,
 * n, so that this is less than their noise. Cells that hold a corner of the border have other bins
 * beside them. Of the rectangle's other map test_rectangle_shares knows more. */
static void test_chi_square(void)
{
    const size_t n = 20000;
    static const triangle octant = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    seen_t t = {sail, spherical_triangle_of(sail, seen_from)};
    seen_t whole = {octant, spherical_triangle_of(octant, seen_from)};
    /* four of those make a half of the sphere, with borders on borders of cells */
    chi_square_result r = chi_square_directions(s_triangle, d_triangle, &whole, 1, 1, 10 * n);
    check_at_least(r.p, alarm, "octant: samples follow the pdf");
    check_close(r.integral, 1, 1e-5, "octant: pdf integrates to 1");
    r = chi_square_directions(s_triangle, d_triangle, &t, 1, 2, n);
    check_at_least(r.p, alarm, "sail: samples follow the pdf");
    check_close(r.integral, 1, 0.01, "sail: pdf integrates to 1");
    static const rectangle list[] = {
        {{-1, -1, 2}, {0, 2, 0}, {2, 0, 0}}, {{0.5, -1, 0.5}, {0, 0, 1}, {0, 2, 0}},
        {{-3, -1, 0.01}, {4, 0, 0}, {0, 3, 0}}, {{1, 1, 0.25}, {0, 9, 0}, {9, 0, 0}}};
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        seen_r s = {list[i], spherical_rectangle_of(list[i], seen_from)};
        check_at_least(chi_square_directions(s_halves, d_rectangle, &s, 1, 9 + i, n).p, alarm,
                       "rectangle %d, halves: samples follow the pdf", (int)i);
    }
}

/* ---- E[cos theta Omega] is the irradiance, in closed form ---- */

static void test_expectations(void)
{
    size_t n = check_count(20000);
    static const rectangle list[] = {
        {{-1, -1, 2}, {0, 2, 0}, {2, 0, 0}}, {{0.5, -1, 0.5}, {0, 0, 1}, {0, 2, 0}},
        {{2, -1, -1}, {0, 0, 3}, {0, 2, 0}}, {{-1, -1, (real)0x1p-10}, {0, 2, 0}, {2, 0, 0}},
        {{1, 1, 1}, {0, (real)0x1p-10, 0}, {(real)0x1p-10, 0, 0}},
        {{1, 1, 1}, {0, (real)0x1p-20, 0}, {(real)0x1p-20, 0, 0}},
        {{1, 1, 1}, {0, (real)0x1p-32, 0}, {(real)0x1p-32, 0, 0}},
        {{1, 0, (real)0x1p-16}, {0, 1, 0}, {1, 0, 0}}, {{-500, 1, 1}, {1000, 0, 0}, {0, 0, 1000}}};
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        spherical_rectangle k = spherical_rectangle_of(list[i], seen_from);
        estimate e = {0}, x = {0}, y = {0};
        for (size_t j = 0; j < n; j++) {
            random_stream s = random_start(5, i, j);
            real u = random_next(&s), v = random_next(&s);
            vec3 q = spherical_rectangle_sample(&k, u, v);
            check(q.x >= 0 && q.x <= 1 && q.y >= 0 && q.y <= 1, "rectangle %d: within", (int)i);
            e = estimate_add(e, (double)(real_max(vunit(rectangle_at(list[i], q)).z, 0) * k.omega));
            x = estimate_add(x, (double)q.x), y = estimate_add(y, (double)q.y);
        }
        double exact = rectangle_irradiance_exact(list[i], seen_from, seen_up);
        check_at_least(t_test(e, exact, 64 * eps * exact), alarm, "rectangle %d: irradiance",
                       (int)i);
        if (i >= 4 && i <= 6) {  /* small: uniform in area, but for some 2^-10 */
            check_at_least(t_test(x, 0.5, 0x1p-10), alarm, "rectangle %d: mean x", (int)i);
            check_at_least(t_test(y, 0.5, 0x1p-10), alarm, "rectangle %d: mean y", (int)i);
            check_close(estimate_variance(x), 1.0 / 12, 0.01, "rectangle %d: spread of x", (int)i);
            check_close(estimate_variance(y), 1.0 / 12, 0.01, "rectangle %d: spread of y", (int)i);
        }
    }
}

/* p touches the middle of an edge, each in turn: two corners are opposite of each other, and the
 * arc between them goes anywhere. Mean of cos Omega by a t-test; all weights are finite, >= 0. */
static void test_near_edges(void)
{
    static const vec3 corner[3] = {{-1, 0, 0}, {1, 0, 0}, {0.5, 2, 0}};
    const real gap[] = {0, (real)0x1p-12, real_epsilon, -real_epsilon / 4, 0};
    const size_t n = check_count(4000);
    for (int edge = 0; edge < 3; edge++)
        for (size_t g = 0; g < sizeof gap / sizeof *gap; g++) {
            vec3 v[3] = {corner[edge], corner[(edge + 1) % 3], corner[(edge + 2) % 3]};
            vec3 p = {0, gap[g], g == 4 ? real_epsilon / 4 : (real)0x1p-12}, down = {0, 0, -1};
            triangle t = {v[0], v[1], v[2]};
            spherical_triangle k = spherical_triangle_of(t, p);
            estimate e = {0}, inward = {0};
            for (size_t i = 0; i < n; i++) {
                random_stream s = random_start(21, (uint64_t)edge, i);
                real u = random_next(&s), a = random_next(&s);
                vec3 b = spherical_triangle_sample(&k, u, a);
                check(b.x >= 0 && b.y >= 0 && b.z >= 0 && b.x + b.y + b.z < 2, "weights");
                vec3 w = vunit(vsub(triangle_at(t, b.y, b.z), p));
                e = estimate_add(e, (double)(real_max(-w.z, 0) * k.omega));
                inward = estimate_add(inward, (double)(real_max(w.y, 0) * k.omega));
            }
            if (g == 4) continue;  /* too close: directions are noise, weights are weights */
            double down_e = triangle_irradiance_exact(t, p, down);
            double inward_e = triangle_irradiance_exact(t, p, (vec3){0, 1, 0});
            /* points are rounded, by 2^-24 or less: directions from a height of 2^-12 by 2^-12 */
            check_at_least(t_test(e, down_e, 0x1p-9), alarm, "edge %d, gap %d: down", edge, (int)g);
            check_at_least(t_test(inward, inward_e, 0x1p-9), alarm, "edge %d, gap %d: inward", edge,
                           (int)g);
        }
}

/* The part of the rectangle with x <= xu has the solid angle u Omega, the part of its slice at xu
 * with y <= yu the share v of that slice's. Exact, no chance. */
static void check_rectangle_shares(rectangle r, double bound, const char *what)
{
    spherical_rectangle k = spherical_rectangle_of(r, seen_from);
    double worst = 0, slices = 0, whole = (double)k.omega;
    for (int i = 0; i <= 32; i++) {
        real u = (real)i / 32;
        vec3 q = spherical_rectangle_sample_urena(&k, u, 1 - u);
        rectangle below = {r.o, vscale(r.s, q.x), r.t};
        double part = i ? (double)fabs(rectangle_solid_angle(below, seen_from)) : 0;
        worst = check_worse(worst, fabs(part / whole - (double)u));
        vec3 x = vunit(rectangle_at(r, (vec3){q.x, 0, 0}));
        vec3 y = vunit(rectangle_at(r, q)), z = vunit(rectangle_at(r, (vec3){q.x, 1, 0}));
        vec3 along = vunit(r.t);
        double part_y = (double)(vdot(y, along) - vdot(x, along));
        double all_y = (double)(vdot(z, along) - vdot(x, along));
        slices = check_worse(slices, fabs(part_y / all_y - (double)(1 - u)));
    }
    check_at_most(worst, bound, "%s: solid angle up to xu is u Omega", what);
    check_at_most(slices, bound, "%s: share of the slice up to yu is v", what);
}

/* Bounds: a point is known to an epsilon of the rectangle: seen from the height z, eps / z. */
static void test_rectangle_shares(void)
{
    check_rectangle_shares((rectangle){{-1, -1, 2}, {0, 2, 0}, {2, 0, 0}}, 16 * eps, "overhead");
    check_rectangle_shares((rectangle){{1, 2, 1}, {0, 3, 0}, {2, 0, 0}}, 64 * eps, "aside");
    check_rectangle_shares((rectangle){{-3, -4, 1}, {0, 3, 0}, {2, 0, 0}}, 64 * eps, "behind");
    check_rectangle_shares((rectangle){{1, -2, (real)0x1p-7}, {0, 3, 0}, {4, 0, 0}}, 4096 * eps,
                           "grazing");
    check_rectangle_shares((rectangle){{-4, 1, (real)0x1p-7}, {0, 16, 0}, {16, 0, 0}}, 4096 * eps,
                           "grazing, large");
    real h = real_is_float ? (real)0.5 : (real)0x1p-9;
    check_rectangle_shares((rectangle){{1, 1, 1}, {0, h, 0}, {h, 0, 0}}, 64 * eps / (double)h,
                           "small");
    /* Seen at a flat angle, all at y > 0: two terms of (22.25) would cancel. */
    rectangle low = {{(real)0x1p-7, 1, (real)0x1p-7}, {1, 0, 0}, {0, 1, 0}};
    spherical_rectangle s = spherical_rectangle_of(low, seen_from);
    for (int i = 1; i < 32; i++) {
        vec3 q = spherical_rectangle_sample_urena(&s, (real)i / 32, 0);
        rectangle below = {low.o, vscale(low.s, q.x), low.t};
        check_close((double)(fabs(rectangle_solid_angle(below, seen_from)) / s.omega), i / 32.,
                    64 * eps, "aside, low: up to xu %d / 32 of Omega", i);
    }
    /* p one tiny step above an edge, a corner: squares of it vanish */
    real tiny = real_is_float ? (real)0x1p-90 : (real)0x1p-600;
    for (int i = 0; i < 2; i++) {
        rectangle r = {{i ? 0 : -1, 0, tiny}, {2, 0, 0}, {0, 2, 0}};
        spherical_rectangle k = spherical_rectangle_of(r, seen_from);
        for (int j = 0; j <= 16; j++) {
            vec3 q = spherical_rectangle_sample_urena(&k, (real)j / 16, 0.5);
            check(q.x >= 0 && q.x <= 1 && q.y >= 0 && q.y <= 1, "next to an edge: within");
        }
    }
}

/* Which map: that of two halves below a solid angle of 2^20 epsilon, the other one above. And a
 * length whose square loses digits is no square root. */
static void test_which_map(void)
{
    size_t wrong = 0, halves = 0, n = 2000;
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(11, 0, i);
        real size = sqrt((real)0x1p20 * real_epsilon * pow((real)4, random_between(&s, -2, 1)));
        rectangle r = {{random_between(&s, -1, 1), random_between(&s, -1, 1), 1}, {0, size, 0},
                       {size, 0, 0}};
        spherical_rectangle k = spherical_rectangle_of(r, seen_from);
        real u = random_next(&s), v = random_next(&s);
        bool small = (double)k.omega < 0x1p20 * eps;
        vec3 q = spherical_rectangle_sample(&k, u, v);
        vec3 due = small ? spherical_rectangle_sample_halves(&k, u, v)
                         : spherical_rectangle_sample_urena(&k, u, v);
        halves += small, wrong += q.x != due.x || q.y != due.y;
    }
    check_equal(wrong, 0, "the other map");
    check(halves > n / 10 && halves < n - n / 10, "both are asked: %zu of %zu", halves, n);
    double worst = 0;
    for (int e = real_is_float ? -120 : -1000; e < 0; e++) {
        real one = ldexp((real)1, e);
        worst = check_worse(worst, fabs((double)(urena_length(3 * one, 4 * one) / (5 * one)) - 1));
    }
    check_at_most(worst, 2 * eps, "a small length keeps its digits");
}

/* Neighbours stay neighbours: a 1024th of u moves the point by four 1024ths of a side at most. Two
 * triangles have a seam: where u passes from one to the other, the point leaps by half a side. */
static void test_seam(void)
{
    rectangle r = {{-1, -1, 1}, {0, 2, 0}, {3, 0, 0}};
    spherical_rectangle k = spherical_rectangle_of(r, seen_from);
    for (int j = 1; j < 8; j++) {
        double step = 0, leap = 0;
        for (int i = 0; i < 1024; i++) {
            real u = (real)i / 1024, next = (real)(i + 1) / 1024, v = (real)j / 8;
            vec3 one = vsub(spherical_rectangle_sample(&k, next, v),
                            spherical_rectangle_sample(&k, u, v));
            vec3 two = vsub(spherical_rectangle_sample_halves(&k, next, v),
                            spherical_rectangle_sample_halves(&k, u, v));
            step = check_worse(step, (double)vlength(one));
            leap = check_worse(leap, (double)vlength(two));
        }
        check_at_most(step, 4.0 / 1024, "v = %d/8: no seam", j);
        check_at_least(leap, 0.5, "v = %d/8: the seam of two triangles", j);
    }
}

/* The map of Ureña et al. on a small rectangle: the difference of two sines. */
static void test_urena_fails(void)
{
    real h = real_is_float ? (real)0x1p-20 : (real)0x1p-48;
    rectangle r = {{1, 1, 1}, {0, h, 0}, {h, 0, 0}};
    spherical_rectangle k = spherical_rectangle_of(r, seen_from);
    double worst = 0;  /* points of the halves are right: test_expectations */
    for (int i = 0; i <= 16; i++) {
        real v = (real)i / 16;
        vec3 a = spherical_rectangle_sample_urena(&k, 0.5, v);
        worst = check_worse(worst, fabs((double)(a.y - v)));
    }
    check_at_least(worst, 0.01, "small: y is noise");
    double area = (double)(h * h);
    check_close((double)k.omega, area / pow(3, 1.5), (2 * (double)h + 16 * eps) * area,
                "small: omega is area cos / r^2");
    r = (rectangle){{-1, -1, 1}, {0, 2, 0}, {2, 0, 0}};
    k = spherical_rectangle_of(r, seen_from);
    /* one of six sides of a cube about p: 4 pi / 6 */
    check_close((double)k.omega, 2.09439510239319549, 8 * eps, "side of a cube");
}

/* Far, near, an ulp away, on it, from inside: mean of cos Omega. */
static void test_sphere_cones(void)
{
    const real distance[] = {1000000, 10, 2, 1.0625, 1 + 4 * real_epsilon, 1,
                             0.5};
    for (size_t k = 0; k < sizeof distance / sizeof *distance; k++) {
        sphere b = {{0, 0, distance[k]}, 1};
        direction_cone c = sphere_cone(b, seen_from);
        estimate e = {0};
        for (uint64_t i = 0; i < check_count(20000); i++) {
            random_stream s = random_start(10, k, i);
            real u = random_next(&s), v = random_next(&s);
            vec3 w = sample_cone(c, u, v);
            check_close((double)(pdf_cone(c, w) * sphere_solid_angle(b, seen_from)), 1, 8 * eps,
                        "distance %g: pdf is 1 / Omega", (double)distance[k]);
            e = estimate_add(e, (double)real_max(w.z, 0) * (double)(4 * pi * c.half_sine2));
        }
        double exact = (double)sphere_irradiance(b, seen_from, seen_up);
        check_at_least(t_test(e, exact, 16 * eps * exact), alarm, "sphere at %g",
                       (double)distance[k]);
    }
}

int main(void)
{
    return check_all("22_spherical_sampling", test_triangle_shares, test_long_arcs,
                     test_chi_square, test_expectations, test_near_edges, test_rectangle_shares,
                     test_which_map, test_seam, test_urena_fails, test_sphere_cones);
}
