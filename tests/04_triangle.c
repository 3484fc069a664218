/* Tests of 04_triangle: plane, three hit tests, barycentrics; closed forms, an exact oracle,
 * needles and degenerate input. What happens at edges and vertices is in 04_watertight.c. */
#include "check.h"
#include "../chapters/04_triangle/lab/mine.h"
#include "../chapters/04_triangle/lab/triangle_variants.h"

#define eps ((double)real_epsilon)

static const struct { const char *name; triangle_method *hit; } methods[] = {
    {"plane + inside", triangle_hit_plane},
    {"first: Möller-Trumbore", first_triangle_hit},
    {"Möller-Trumbore, divides last", triangle_hit_moller_trumbore},
    {"planes computed beforehand", triangle_hit_planes},
    {"triple products", triangle_hit_triple},
    {"watertight", triangle_hit}};
enum { method_count = 6 };

static real random_integer(random_stream *g, int n)
{
    return floor(random_next(g) * (real)(2 * n + 1)) - (real)n;
}

/* A hit that no test produces: shows whether `out` was touched. */
static const hit untouched = {-77, -77, -77, 77};
static bool same_hit(hit a, hit b)
{
    return a.t == b.t && a.u == b.u && a.v == b.v && a.shape == b.shape;
}

/* ---- plane ---- */

static void test_plane(void)
{
    plane p = {{1, 2, 3}, {0, 0, 2}};
    plane_equation e = plane_equation_of(p);
    check(e.a == 0 && e.b == 0 && e.c == 2 && e.d == -6, "(x - p) . n = 0 is 2 z - 6 = 0");
    hit h = untouched;
    ray r = ray_from((vec3){5, 7, -1}, vec(1, 0, 0.5));
    check(plane_hit(p, r, &h) && h.t == 8, "z: -1 + t/2 = 3");
    check(plane_equation_hit(e, r, &h) && h.t == 8, "the same from the equation");
    r.d = vneg(r.d), h = untouched;
    check(!plane_hit(p, r, &h) && same_hit(h, untouched), "behind the ray; out untouched");
    r.tmin = -8;
    check(plane_hit(p, r, &h) && h.t == -8, "the interval is closed: t = tmin");
    plane q = plane_through((vec3){0, 0, 5}, (vec3){2, 0, 5}, (vec3){0, 2, 5});
    check(q.p.z == 5 && q.n.x == 0 && q.n.y == 0 && q.n.z == 4, "through three points, n up");

    const ray never[] = {
        ray_from((vec3){0, 0, 0}, (vec3){1, 1, 0}),                    /* parallel */
        ray_from((vec3){0, 0, 3}, (vec3){1, 1, 0}),                    /* in the plane: 0/0 */
        ray_from((vec3){0, 0, 3}, vec(1, -1, -0.0)),
        ray_from((vec3){0, 0, 0}, (vec3){0, 0, 0}),
        ray_from(vec(0, 0, NAN), (vec3){0, 0, 1}),
        ray_from((vec3){0, 0, 0}, vec(0, 0, NAN)),
        ray_from((vec3){0, 0, real_infinity}, (vec3){0, 0, 1}),
        ray_from((vec3){0, 0, -real_infinity}, (vec3){0, 0, 1})};
    for (size_t i = 0; i < sizeof never / sizeof *never; i++) {
        h = untouched;
        check(!plane_hit(p, never[i], &h) && !plane_equation_hit(e, never[i], &h)
                  && (i > 5 || !first_plane_hit(p, never[i], &h)) && same_hit(h, untouched),
              "ray %zu meets no plane z = 3", i);
    }
    r = ray_from((vec3){0, 0, 0}, (vec3){0, 0, 1});
    check(!plane_hit((plane){{1, 2, 3}, {0, 0, 0}}, r, &h), "no normal, no plane");
}

/* Far from the origin the equation loses what the point keeps. Planes with a short normal through
 * points near p, |p| = 1e4, seen from a distance of some 1. */
static void test_plane_far_away(void)
{
    random_stream g = random_start(1, 0, 0);
    double worst = 0, worst_equation = 0;
    for (size_t i = 0, n = check_count(20000); i < n; i++) {
        vec3 far = vadd((vec3){10000, -10000, 10000}, random_in_cube(&g, 1));
        plane p = {far, random_in_cube(&g, 1)};
        vec3 o = vadd(far, random_in_cube(&g, 1));
        ray r = {o, -real_infinity, random_in_cube(&g, 1), real_infinity};
        if (fabs(vdot(vunit(p.n), vunit(r.d))) < (real)0.1) continue;
        wide3 normal = wide3_of(p.n);
        wide t = wide_div(wide3_dot(wide3_sub(wide3_of(p.p), wide3_of(r.o)), normal),
                          wide3_dot(wide3_of(r.d), normal));
        double size = (double)(vlength(vsub(p.p, r.o)) / vlength(r.d));
        hit h = hit_none;
        plane_hit(p, r, &h);
        worst = check_worse(worst, fabs((double)h.t - wide_value(t)) / size);
        plane_equation_hit(plane_equation_of(p), r, &h);
        worst_equation = check_worse(worst_equation, fabs((double)h.t - wide_value(t)) / size);
    }
    /* the difference of points is exact; dot products off by 2 eps |n||v| each, quotient over a
     * cosine 0.1 */
    check_at_most(worst, 50 * eps, "point and normal: t keeps its digits far from the origin");
    check_at_least(worst_equation, 1e3 * eps,
                   "a x + b y + c z + d = 0 loses three digits or more at 1e4");
}

/* ---- triangle: closed forms ---- */

/* A dyadic triangle and rays for which t, u, v are dyadic: every method must be exact. All
 * rotations of the axes, both directions, both orders of the corners. */
static vec3 turned_by(int axis, vec3 p)
{
    return axis == 0 ? p : axis == 1 ? (vec3){p.y, p.z, p.x} : (vec3){p.z, p.x, p.y};
}

static void test_exact_hits(void)
{
    const struct { vec3 o, d; real t, u, v; } c[] = {
        {{1, 1, 3}, {0, 0, -1}, 3, 0.25, 0.25},
        {{1, 2, -4}, {0, 0, 2}, 2, 0.25, 0.5},
        {{3, 1, 4}, {-0.5, 0, -1}, 4, 0.25, 0.25},
        {{1, 1, -8}, {0, 0, 0.125}, 64, 0.25, 0.25}};
    triangle flat = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    for (int k = 0; k < method_count; k++)
        for (int axis = 0; axis < 3; axis++)
            for (size_t i = 0; i < sizeof c / sizeof *c; i++) {
                triangle t = {turned_by(axis, flat.a), turned_by(axis, flat.b),
                              turned_by(axis, flat.c)};
                ray r = ray_from(turned_by(axis, c[i].o), turned_by(axis, c[i].d));
                hit h = untouched;
                check(methods[k].hit(t, r, &h) && h.t == c[i].t && h.u == c[i].u && h.v == c[i].v
                          && h.shape == 0,
                      "%s, axis %d, case %zu: t u v %g %g %g", methods[k].name, axis, i,
                      (double)h.t, (double)h.u, (double)h.v);
                check(methods[k].hit((triangle){t.a, t.c, t.b}, r, &h) && h.t == c[i].t
                          && h.u == c[i].v && h.v == c[i].u,
                      "%s: the same from behind, u and v change places", methods[k].name);
                r.tmin = r.tmax = c[i].t;
                check(methods[k].hit(t, r, &h), "%s: the interval is closed", methods[k].name);
                r.tmin = c[i].t * (1 + real_epsilon), r.tmax = real_infinity, h = untouched;
                check(!methods[k].hit(t, r, &h) && same_hit(h, untouched),
                      "%s: before tmin, out untouched", methods[k].name);
                r.tmin = 0, r.tmax = c[i].t * (1 - real_epsilon);
                check(!methods[k].hit(t, r, &h) && same_hit(h, untouched),
                      "%s: behind tmax, out untouched", methods[k].name);
            }
}

/* Edges and corners belong to the triangle: exact input, so exact answers. */
static void test_border_is_inside(void)
{
    triangle t = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    const struct { real x, y; bool inside; } c[] = {
        {0, 0, 1}, {4, 0, 1}, {0, 4, 1}, {2, 0, 1}, {0, 2, 1}, {2, 2, 1},
        {2, -0.25, 0}, {-0.25, 2, 0}, {2, 2.25, 0},
        {5, 0, 0}, {0, 5, 0}, {-1, -1, 0}};
    for (int k = 0; k < method_count; k++)
        for (size_t i = 0; i < sizeof c / sizeof *c; i++) {
            hit h = untouched;
            bool got = methods[k].hit(t, ray_from((vec3){c[i].x, c[i].y, 8}, (vec3){0, 0, -1}), &h);
            check(got == c[i].inside && (got || same_hit(h, untouched)), "%s at (%g, %g)",
                  methods[k].name, (double)c[i].x, (double)c[i].y);
        }
}

/* ---- triangle: exact oracle ---- */

/* Rays well inside or outside of triangle and interval, of all methods: a hit or a miss by (4.8) in
 * 30 digits; t, u and v. And each usual mistake is found. */
static int mistake;

static bool mistaken(triangle tri, ray r, hit *out)
{
    triangle other = {vadd(vsub(tri.b, tri.a), tri.c), tri.c, tri.b};
    if (mistake == 0) r.tmin = -real_infinity;
    if (mistake == 1) r.tmax = real_infinity;
    if (mistake == 4 && vdot(r.d, first_triangle_normal(tri)) > 0) return false;
    bool is = first_triangle_hit(tri, r, out)
              || (mistake == 3 && first_triangle_hit(other, r, out));
    if (is && mistake == 2) *out = (hit){out->t, out->v, out->u, 0};
    return is;
}

static void test_easy_rays(void)
{
    const char *const wrong[] = {"t < tmin", "t > tmax", "u for v", "u, v <= 1", "from one side"};
    size_t n = check_count(200000);
    FILE *nowhere = fopen("/dev/null", "w");
    if (!nowhere) abort();
    for (int k = 0; k < method_count; k++)
        check(triangle_prove(methods[k].hit, "", n, nowhere), "%s: hit or miss, t, or u and v",
              methods[k].name);
    check(triangle_prove(mine_triangle_hit, "", n, nowhere), "mine.h is wrong");
    for (mistake = 0; mistake < 5; mistake++)
        check(!triangle_prove(mistaken, "", 2000, nowhere), "%s: was found right", wrong[mistake]);
    fclose(nowhere);
}

/* Weights of the watertight test, and its three forms. */
static void test_forms_agree(void)
{
    random_stream g = random_start(2, 0, 0);
    size_t different = 0, hits = 0, n = check_count(100000);
    double beyond = 0;
    for (size_t i = 0; i < n; i++) {
        triangle tri = {random_in_cube(&g, 2), random_in_cube(&g, 2), random_in_cube(&g, 2)};
        vec3 o = random_in_cube(&g, 5);
        real u = random_next(&g), v = random_next(&g);
        ray r = ray_from(o, vsub(triangle_at(tri, u, v), o));
        ray_shear s = shear_of(r);
        hit h = untouched, a = untouched, b = untouched;
        bool is = triangle_hit(tri, r, &h);
        different += triangle_hit_sheared(tri, &s, r, &a) != is || !same_hit(a, h)
                     || triangle_hit_corners(&tri.a, &tri.b, &tri.c, &s, r, &b) != is
                     || !same_hit(b, h);
        hits += is;
        if (!is) continue;
        beyond = check_worse(beyond, (double)(h.u + h.v) - 1);
        beyond = check_worse(beyond, (double)-real_min(h.u, h.v));
    }
    check_at_least(hits, n / 3, "the test sees hits");
    check_at_most(beyond, 2 * eps, "watertight: u, v >= 0 and u + v <= 1");
    check_equal(different, 0, "triangle_hit, _sheared and _corners agree to the last bit");
}

/* t of the watertight test keeps all but its last bits, however narrow the needle: 3 roundings of
 * each depth, and of the picture's coordinates times a slope of at most 10. Only where the needle
 * is not yet a sliver, its determinant just above 1/64 of its products, the weights may be off by
 * 64 times what a product is: half an epsilon. Without the sliver clause of triangle.h the error is
 * 100 epsilon at a width of 0.003, and grows with 1/width as that of the others. Widths near the
 * rounding of the coordinates are left out. */
static void test_needles(void)
{
    for (double width = 1e-1; width > 1e3 * eps; width /= 10) {
        size_t before = triangle_doubts;
        size_t rays = check_sample(5000, 2000);
        triangle_needle_count n = triangle_needles(triangle_hit, width, rays, 3);
        if (width < 2e-4)
            check_at_least((double)(triangle_doubts - before), 0.95 * (double)n.due,
                           "needles of width %.0e take the exact signs", width);
        check_at_most(n.error, (width > 2e-4 ? 64 : 16) * eps, "t of a needle of width %.0e",
                      width);
        check_equal(n.missed, 0, "no needle of width %.0e missed, of %zu", width, n.due);
        triangle_method *const others[] = {first_triangle_hit, triangle_hit_moller_trumbore};
        for (int k = 0; k < 2; k++)
            check_at_least(triangle_needles(others[k], width, check_sample(5000, 2000), 3).error,
                           0.1 * eps / width, "%s loses a digit of t a digit of width",
                           methods[k + 1].name);
    }
    size_t before = triangle_doubts;
    hit h;
    check(triangle_hit((triangle){{0, 0, 0}, {4, 0, 0}, {0, 4, 0}},
                       ray_from(vec(1, 1, 3), vec(0, 0, -1)), &h) && triangle_doubts == before,
          "a plain triangle does not");
}

/* ---- degenerate ---- */

/* Corners that coincide or lie on a line, with integer coordinates, so that they do so exactly;
 * rays aimed at them from anywhere, and from integer points along integer directions. */
static void test_no_area_no_hit(void)
{
    random_stream g = random_start(6, 0, 0);
    size_t hits = 0, naive = 0, n = check_count(500000);
    double length = 0;
    for (size_t i = 0; i < n; i++) {
        vec3 a = {random_integer(&g, 8), random_integer(&g, 8), random_integer(&g, 8)};
        vec3 e = {random_integer(&g, 8), random_integer(&g, 8), random_integer(&g, 8)};
        triangle t = {a, vmadd(a, e, random_integer(&g, 4)), vmadd(a, e, random_integer(&g, 4))};
        vec3 o = random_in_cube(&g, 30), p = vmadd(a, e, random_between(&g, -4, 4));
        if (i % 2) {
            o = (vec3){random_integer(&g, 20), random_integer(&g, 20), random_integer(&g, 20)};
            p = vmadd(a, e, random_integer(&g, 4));
        }
        hit h;
        ray r = ray_from(o, vsub(p, o));
        hits += triangle_hit(t, r, &h);
        naive += first_triangle_hit(t, r, &h);
        length = check_worse(length, (double)vlength(triangle_normal(t)));
    }
    check_equal(hits, 0, "a triangle without area is never hit, of %zu rays aimed at it", n);
    check_equal(length, 0, "and has no normal");
    check_at_least((double)naive, 0.005 * (double)n,
                   "Möller-Trumbore hits some: its det is a rounding error");
}

/* Exactly on a line, though b - a and c - a are rounded and do not look parallel: a, b and c are
 * multiples of one integer direction, a by a last bit of it. And the reverse: a has so large
 * coordinates that b - a and c - a round to the same, yet the triangle has area. */
static void test_rounded_edges(void)
{
    random_stream g = random_start(13, 0, 0);
    size_t hits = 0, unequal = 0, n = check_count(200000);
    for (size_t i = 0; i < n; i++) {
        vec3 d = {random_integer(&g, 4), random_integer(&g, 4), random_integer(&g, 4)};
        if (vzero(d)) continue;
        real tiny = floor(1 + 999 * random_next(&g)) * real_epsilon / 2;
        triangle t = {vscale(d, tiny), d, vscale(d, 3)};
        vec3 o = random_in_cube(&g, 10), p = vscale(d, 3 * random_next(&g)), e1 = vsub(t.b, t.a);
        hit h;
        hits += triangle_hit(t, ray_from(o, vsub(p, o)), &h) || !vzero(triangle_normal(t));
        unequal += !vzero(vcross(e1, vsub(t.c, t.a)));
    }
    check_equal(hits, 0, "corners exactly on a line, edges rounded: no hit, no normal");
    check_at_least((double)unequal, 0.1 * (double)n, "the rounded edges often look unparallel");

    real far = real_is_float ? (real)1e9 : (real)1e17;
    const vec3 corner[3] = {{far, far, far}, {1, 0, 0}, {0, 1, 0}};
    for (int k = 0; k < 3; k++) {
        triangle t = {corner[k], corner[(k + 1) % 3], corner[(k + 2) % 3]};
        hit h = untouched;
        /* n = (1, 1, 1/far - 2): at x = y = 3/4 the plane has z = 1/4 within 1/far */
        check(triangle_hit(t, ray_from(vec(0.75, 0.75, -1), (vec3){0, 0, 1}), &h),
              "a triangle from 1 to %g, corner %d first, is hit", (double)far, k);
        check_close(h.t, 1.25, 8 * eps, "where it is");
        vec3 normal = triangle_normal(t);
        check_close(normal.x, 1 / sqrt(6.0), 2 * eps, "and has its normal");
        check_close(normal.z, -2 / sqrt(6.0), 2 * eps, "and has its normal");
    }
}

/* A ray in the plane of the triangle. */
static void test_edge_on(void)
{
    triangle t = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    hit h;
    check(!triangle_hit(t, ray_from((vec3){-1, 1, 0}, (vec3){1, 0, 0}), &h),
          "exactly edge-on, along an axis");
    check(!triangle_hit(t, ray_from((vec3){-1, -1, 0}, (vec3){1, 1, 0}), &h),
          "exactly edge-on, along a diagonal");
    check(!triangle_hit(t, ray_from((vec3){-1, 0, 0}, (vec3){1, 0, 0}), &h), "along its edge");
}

/* NaN, infinities, zeros and extremes in every place of the input: no hit with a NaN in it. */
static void test_no_nan(void)
{
    const real odd[] = {0, -0.0, 1, -1, 0.5, (real)NAN, real_infinity,
                        -real_infinity, real_largest, -real_largest, real_smallest,
                        real_smallest * real_epsilon};
    const size_t kinds = sizeof odd / sizeof *odd;
    random_stream g = random_start(8, 0, 0);
    size_t bad = 0, touched = 0, bad_plane = 0;
    for (size_t i = 0, n = check_count(1000000); i < n; i++) {
        real x[15];
        uint64_t bits = random_next_bits(&g), more = random_next_bits(&g);
        for (int k = 0; k < 15; k++, bits >>= 4) {
            x[k] = more >> k & 1 ? random_between(&g, -2, 2) : odd[(bits & 15) % kinds];
        }
        triangle t = {{x[0], x[1], x[2]}, {x[3], x[4], x[5]}, {x[6], x[7], x[8]}};
        ray r = {{x[9], x[10], x[11]}, -real_infinity, {x[12], x[13], x[14]}, real_infinity};
        if (i % 3 == 0)  /* so that the ray alone is odd */
            t = (triangle){{-1, -1, 2}, {1, -1, 2}, {0, 2, 2}};
        hit h = untouched;
        if (triangle_hit(t, r, &h)) bad += !(isfinite(h.t) && isfinite(h.u) && isfinite(h.v));
        else touched += !same_hit(h, untouched);
        h = untouched;
        if (first_triangle_hit(t, r, &h)) bad += !(isfinite(h.t) && isfinite(h.u + h.v));
        else touched += !same_hit(h, untouched);
        h = untouched;
        if (plane_hit((plane){t.a, t.b}, r, &h)) bad_plane += isfinite(h.t) ? 0 : 1;
        else touched += !same_hit(h, untouched);
        bool odd_ray = !vfinite(r.o) || !vfinite(r.d) || !isfinite(1 / vaxis(r.d, vlongest(r.d)));
        bool odd_corner = !vfinite(t.a) || !vfinite(t.b) || !vfinite(t.c);
        bad += (odd_ray || odd_corner) && triangle_hit(t, r, &h);
        vec3 normal = triangle_normal(t);
        bad += !vfinite(normal);
    }
    check_equal(bad, 0, "no NaN or infinity in a hit or normal, no hit on or by one");
    check_equal(bad_plane, 0, "nor in a plane's hit");
    check_equal(touched, 0, "out untouched on every miss");
    hit h;
    triangle t = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    ray r = {{1, 1, 4}, (real)NAN, {0, 0, -1}, real_infinity};
    check(!triangle_hit(t, r, &h), "a NaN in the interval covers nothing");
    r.tmin = 0, r.d = vec(-0.0, -0.0, -1);
    check(triangle_hit(t, r, &h) && h.t == 4, "-0.0 in a direction is 0");
}

/* Triangles seen along +z from the origin, with corners a few ulps off the diagonal: x and y are
 * their coordinates in the frame of the ray, unrounded. The exact signs come from double-double
 * products. Plain products cancel to three zeros for many of them; the answer must still be right:
 * never a miss of one that contains the ray, edges included, and has area. */
static void test_exact_signs(void)
{
    random_stream g = random_start(9, 0, 0);
    size_t missed = 0, all_zero = 0, wrong = 0;
    for (size_t i = 0, n = check_sample(500000, 100000); i < n; i++) {
        real x[3], y[3];
        for (int k = 0; k < 3; k++) {
            real s = random_between(&g, -1, 1);
            s = floor(s * 1024) / 1024;
            x[k] = s * (1 + random_integer(&g, 3) * real_epsilon),
            y[k] = s * (1 + random_integer(&g, 3) * real_epsilon);
        }
        int sign[3], zeros = 0;
        for (int k = 0; k < 3; k++) {
            int p = (k + 2) % 3, q = (k + 1) % 3;
            sign[k] = wide_sign(wide_sub(wide_product((double)x[p], (double)y[q]),
                                         wide_product((double)y[p], (double)x[q])));
            zeros += x[p] * y[q] - y[p] * x[q] == 0;
        }
        bool inside = (sign[0] >= 0 && sign[1] >= 0 && sign[2] >= 0)
                      || (sign[0] <= 0 && sign[1] <= 0 && sign[2] <= 0);
        bool area = sign[0] || sign[1] || sign[2];
        hit h;
        ray r = ray_from((vec3){0, 0, 0}, (vec3){0, 0, 1});
        bool got =
            triangle_hit((triangle){{x[0], y[0], 1}, {x[1], y[1], 1}, {x[2], y[2], 2}}, r, &h);
        missed += inside && area && !got;
        if (zeros == 3) all_zero += inside && area, wrong += got != (inside && area);
    }
    check_equal(missed, 0, "slivers that contain the ray are hit");
    check_at_least((double)all_zero, 0.0003 * (double)check_sample(500000, 100000),
                   "some of them by their exact signs alone");
    check_equal(wrong, 0, "where plain products are all zero, the answer is the exact one");
}

/* The other half of the argument for watertightness, in plain sight: swapping the corners of an
 * edge negates its function exactly. A contracted multiply-add breaks this. */
static void test_edge_functions_are_antisymmetric(void)
{
    random_stream g = random_start(10, 0, 0);
    size_t wrong = 0;
    for (size_t i = 0, n = check_count(1000000); i < n; i++) {
        vec3 a = random_in_cube(&g, 1), b = vmadd(a, random_in_cube(&g, 1), 16 * real_epsilon);
        real forth = b.x * a.y - b.y * a.x, back = a.x * b.y - a.y * b.x;
        wrong += forth != -back;
        wrong += (difference_of_products(b.x, a.y, b.y, a.x) > 0)
                 != (difference_of_products(a.x, b.y, a.y, b.x) < 0);
    }
    check_equal(wrong, 0, "edge function of P Q is minus that of Q P (needs -ffp-contract=off)");
}

/* ---- normals, barycentrics, small triangles ---- */

static void test_normals(void)
{
    triangle t = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    vec3 n = triangle_normal(t), first = first_triangle_normal(t);
    check(n.x == 0 && n.y == 0 && n.z == 1, "counter-clockwise: towards the viewer");
    check(vzero(vsub(first, n)), "so is that of first.h");
    const double sizes[2][4] = {{1e-300, 1e-170, 1e150, 1e300}, {1e-36, 1e-25, 1e18, 1e36}};
    for (int k = 0; k < 4; k++) {
        real s = (real)sizes[real_is_float][k];
        n = triangle_normal((triangle){{s, s, s}, {2 * s, s, s}, {s, s, 2 * s}});
        check_close(n.y, -1, 2 * eps, "normal at size %g", (double)s);
    }
}

static void test_barycentrics(void)
{
    triangle t = {{0, 0, 1}, {4, 0, 1}, {0, 4, 1}};
    vec3 k = triangle_weights(t, (vec3){1, 2, 1});
    check(k.x == (real)0.25 && k.y == (real)0.25 && k.z == (real)0.5, "weights of a point");
    k = triangle_weights(t, (vec3){1, 2, 9});
    check(k.x == (real)0.25 && k.y == (real)0.25 && k.z == (real)0.5,
          "a point off the plane: of its foot");
    k = triangle_weights(t, (vec3){6, 6, 1});
    check(k.x + k.y + k.z == 1 && k.x == -2, "outside: they sum to one all the same");
    vec3 a = triangle_at(t, 0, 0), b = triangle_at(t, 1, 0), c = triangle_at(t, 0, 1);
    check(vzero(vsub(a, t.a)) && vzero(vsub(b, t.b)) && vzero(vsub(c, t.c)),
          "corners are met exactly");
    k = triangle_weights((triangle){{1, 1, 1}, {1, 1, 1}, {2, 2, 2}}, (vec3){1, 1, 1});
    check(!(k.x >= 0 || k.y >= 0 || k.z >= 0), "no area, no inside");
}

/* Flattened along y by a power of two, down to a few units of the smallest real: the same t, to the
 * last bit, since all numbers are small whole ones. */
static void test_flattened(void)
{
    real tiny = real_is_float ? (real)0x1p-145 : (real)0x1p-500 * (real)0x1p-570;
    size_t n = check_count(3000), hits = 0, wrong = 0;
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(91, i, 0);
        real p[3][3];
        for (int k = 0; k < 9; k++) p[k / 3][k % 3] = (real)(random_next_bits(&g) % 129) - 64;
        hit tall = hit_none, flat = hit_none;
        vec3 v[2][3];
        for (int k = 0; k < 3; k++) {
            v[0][k] = (vec3){p[k][0], p[k][1], p[k][2] + 65};
            v[1][k] = (vec3){p[k][0], p[k][1] * tiny, p[k][2] + 65};
        }
        ray r = ray_from((vec3){0, 0, 0}, (vec3){0, 0, 1});
        bool a = triangle_hit((triangle){v[0][0], v[0][1], v[0][2]}, r, &tall);
        bool b = triangle_hit((triangle){v[1][0], v[1][1], v[1][2]}, r, &flat);
        hits += a, wrong += a != b || tall.t != flat.t;
    }
    check_equal(wrong, 0, "triangles flattened to subnormal numbers: other answers");
    check_at_least(hits, n / 8, "they are hit");
}

/* Slivers whose area is some roundings of the edges: plain products are off by 2 epsilon |e1| |e2|
 * at most, and taken if the result is twice that, so it turns by no more than 1/2. That all
 * roundings conspire is not met: half of it is asked. */
static void test_sliver_normals(void)
{
    double worst = 0;
    size_t plain = 0, n = check_count(400000);
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(9, i, 0);
        vec3 a = random_in_cube(&g, 1), d = random_in_cube(&g, 1), b = vadd(a, d);
        vec3 c = random_in_cube(&g, 4 * real_epsilon);
        c = vadd(vmadd(a, d, 2 * random_next(&g) - 1), c);
        if (i % 2) b = vmadd(a, d, (real)1e-3);
        if (i % 8 > 5) {  /* from 0, one edge so short that its square vanishes, the other long */
            vec3 tiny = vscale(d, sqrt(real_smallest)), e = vmadd(c, a, -1);
            a = (vec3){0, 0, 0}, c = vscale(e, sqrt(sqrt(real_largest))), b = tiny;
            if (i % 8 == 7) b = c, c = tiny;
        }
        vec3 s = triangle_cross(a, b, c), p = vcross(vsub(b, a), vsub(c, a));
        wide3 w = wide3_cross(wide3_sub(wide3_of(b), wide3_of(a)),
                              wide3_sub(wide3_of(c), wide3_of(a)));
        plain += s.x == p.x && s.y == p.y && s.z == p.z;
        s = vunit(s);
        double l = wide_value(wide3_length(w));
        if (l == 0 || vzero(s)) continue;
        worst = check_worse(worst, wide_value(wide3_length(wide3_cross(w, wide3_of(s)))) / l);
        if (wide_sign(wide3_dot(w, wide3_of(s))) < 0) worst = 2;
    }
    check_at_most(worst, 0.25, "slivers: the normal is turned by");
    check(plain > n / 2 && plain < n, "plain products and exact ones: %zu of %zu", plain, n);
}

/* ---- first.h in clear cases; its slips are in 04_watertight.c ---- */

/* Rays at least 0.1 off a plane's own direction: first_plane_hit is plane_hit, but for the rounding
 * of one sign. */
static void test_first_planes(void)
{
    random_stream g = random_start(1, 0, 0);
    size_t wrong = 0, hits = 0, n = check_count(100000);
    for (size_t i = 0; i < n; i++) {
        plane p = {random_in_cube(&g, 10), random_in_cube(&g, 1)};
        vec3 d = random_in_cube(&g, 2);
        ray r = {random_in_cube(&g, 10), random_next(&g), d, 10 * random_next(&g)};
        if (fabs(vdot(vunit(p.n), vunit(r.d))) < (real)0.1) continue;
        hit a = untouched, b = untouched;
        bool is = first_plane_hit(p, r, &a), due = plane_hit(p, r, &b);
        hits += is, wrong += is != due || !same_hit(a, b);
    }
    check_equal(wrong, 0, "first_plane_hit against plane_hit, of %zu", n);
    check_at_least((double)hits, 0.1 * (double)n, "the test sees hits");
    plane level = {{0, 0, 3}, {0, 0, 1}};
    hit h;
    ray steep = ray_from((vec3){0, 0, 0}, (vec3){1, 1, real_smallest / 8});
    check(first_plane_hit(level, steep, &h) && !plane_hit(level, steep, &h),
          "nearly along it: a hit at infinity, that plane_hit refuses");
}

/* What has no area is not hit, if its edges are exact. What is not finite: test_no_nan. */
static void test_first_no_area(void)
{
    triangle none = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, dot = {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}};
    hit h;
    check(!first_triangle_hit(none, ray_from((vec3){1, 0, 3}, (vec3){0, 0, -1}), &h)
              && !first_triangle_hit(dot, ray_from((vec3){1, 1, 3}, (vec3){0, 0, -1}), &h),
          "no area: no hit");
    check(vzero(first_triangle_normal(none)) && vzero(first_triangle_normal(dot)), "nor a normal");
}

int main(void)
{
    return check_all("04_triangle", test_sliver_normals, test_first_planes, test_first_no_area,
                     test_plane, test_plane_far_away, test_exact_hits, test_border_is_inside,
                     test_easy_rays, test_forms_agree, test_needles, test_no_area_no_hit,
                     test_rounded_edges, test_edge_on, test_no_nan, test_exact_signs,
                     test_edge_functions_are_antisymmetric, test_normals, test_barycentrics,
                     test_flattened);
}
