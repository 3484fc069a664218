/* 04's first.h: planes and triangles in clear cases. That it slips at the seams of a closed mesh is
 * seen in 04_watertight.c. */
#include "check.h"
#include "../chapters/04_triangle/lab/mine.h"

#define eps ((double)real_epsilon)

static const hit untouched = {-77, -77, -77, 77};
static bool same_hit(hit a, hit b)
{
    return a.t == b.t && a.u == b.u && a.v == b.v && a.shape == b.shape;
}

/* Rays at least 0.1 off a plane's own direction: first_plane_hit is plane_hit, but for the rounding
 * of one sign. */
static void test_planes(void)
{
    random_stream g = random_start(1, 0, 0);
    size_t wrong = 0, hits = 0, n = check_count(100000);
    for (size_t i = 0; i < n; i++) {
        plane p = {random_in_cube(&g, 10), random_in_cube(&g, 1)};
        ray r = ray_from(random_in_cube(&g, 10), random_in_cube(&g, 2));
        r.tmin = random_next(&g), r.tmax = 10 * random_next(&g);
        if (fabs(vdot(vunit(p.n), vunit(r.d))) < (real)0.1) continue;
        hit a = untouched, b = untouched;
        bool is = first_plane_hit(p, r, &a), due = plane_hit(p, r, &b);
        hits += is, wrong += is != due || !same_hit(a, b);
    }
    check_equal(wrong, 0, "first_plane_hit against plane_hit, of %zu", n);
    check_at_least((double)hits, 0.1 * (double)n, "the test sees hits");
    plane level = {{0, 0, 3}, {0, 0, 1}};
    hit h = untouched;
    check(!first_plane_hit(level, ray_from((vec3){0, 0, 0}, (vec3){1, 1, 0}), &h)
              && !first_plane_hit(level, ray_from((vec3){0, 0, 3}, (vec3){1, 1, 0}), &h)
              && !first_plane_hit(level, ray_from((vec3){0, 0, 0}, (vec3){0, 0, 0}), &h)
              && !first_plane_hit(level, ray_from((vec3){0, 0, 0}, (vec3){0, 0, (real)NAN}), &h)
              && same_hit(h, untouched),
          "along the plane, in it, without direction: no hit, out untouched");
    ray steep = ray_from((vec3){0, 0, 0}, (vec3){1, 1, real_smallest / 8});
    check(first_plane_hit(level, steep, &h) && !plane_hit(level, steep, &h),
          "nearly along it: a hit at infinity, that plane_hit refuses");
}

/* Easy rays against (4.8) in 30 digits, t, u and v; then what is made of u and v. */
static void test_triangles(void)
{
    random_stream g = random_start(2, 0, 0);
    size_t hits = 0, n = check_count(100000);
    double point = 0, normal = 0;
    FILE *nowhere = fopen("/dev/null", "w");
    if (!nowhere) abort();
    check(triangle_prove(first_triangle_hit, "", n, nowhere), "hit or miss, or t, u and v");
    fclose(nowhere);
    for (size_t i = 0; i < n; i++) {
        triangle tri = {random_in_cube(&g, 2), random_in_cube(&g, 2), random_in_cube(&g, 2)};
        vec3 n1 = vcross(vsub(tri.b, tri.a), vsub(tri.c, tri.a));
        vec3 o = random_in_cube(&g, 5);
        ray r = ray_from(o, vsub(triangle_at(tri, random_next(&g), random_next(&g)), o));
        hit h;
        if (vlength(n1) < 1 || fabs(vdot(vunit(n1), vunit(r.d))) < (real)0.1) continue;
        vec3 other = vsub(first_triangle_normal(tri), triangle_normal(tri));
        normal = check_worse(normal, (double)vlength(other));
        if (!first_triangle_hit(tri, r, &h)) continue;
        vec3 mixed = barycentric_mix(tri.a, tri.b, tri.c, h.u, h.v);
        point = check_worse(point, (double)vlength(vsub(ray_at(r, h.t), mixed)));
        hits++;
    }
    check_at_least(hits, n / 20, "the test sees hits");
    /* numbers below 10, area 1/2 and cosine 0.1 at least */
    check_at_most(point, 1e5 * eps, "o + t d is the mix of the corners by u and v");
    check_at_most(normal, 100 * eps, "the normal");
    vec3 a = {1, 2, 3}, b = {4, 6, 5}, c = {9, 7, 8};
    check(vzero(vsub(barycentric_mix(a, b, c, 0, 0), a))
              && vzero(vsub(barycentric_mix(a, b, c, 1, 0), b))
              && vzero(vsub(barycentric_mix(a, b, c, 0, 1), c)), "corners are met exactly");
}

/* What has no area is not hit, if its edges are exact. What is not finite: 04_triangle.c. */
static void test_degenerate(void)
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
    test_planes();
    test_triangles();
    test_degenerate();
    return check_report("04_first");
}
