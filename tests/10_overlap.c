/* Overlap of items and cells: never "no" when they touch, against points that are known exactly to
 * lie on both; and equal to the exact answer in whole numbers where the gaps are whole numbers. */
#include "../chapters/10_grid/lab/naive.h"
#include "../common/numbers/wide.h"
#include "aimed.h"
#include "check.h"

/* Whole numbers below 2^bits, so that a quarter of a sum of four is exact. */
static real whole(random_stream *g, int bits)
{
    real k = floor(ldexp(random_next(g), bits - 2)) * 4;
    return random_next_bits(g) & 1 ? -k : k;
}

static vec3 whole_vector(random_stream *g, int bits)
{
    real x = whole(g, bits), y = whole(g, bits), z = whole(g, bits);
    return (vec3){x, y, z};
}

/* A box that holds p: on each axis p is its low side, its high side, both, or between them. */
static aabb box_about(vec3 p, random_stream *g, real size)
{
    aabb b = {p, p};
    for (int k = 0; k < 3; k++) {
        int where = (int)(random_next_bits(g) % 8);
        if (where != 0 && where < 5) ((real *)&b.lo)[k] -= size * random_next(g);
        if (where != 0 && where != 4) ((real *)&b.hi)[k] += size * random_next(g);
    }
    return b;
}

/* A corner, an edge or the inside of a triangle is a corner, in an edge or in a side of the box. */
static vec3 witness_of_corners(const vec3 *q, random_stream *g)
{
    static const int weight[][3] = {{4, 0, 0}, {2, 2, 0}, {0, 1, 3}, {1, 0, 3}, {1, 1, 2},
                                    {2, 1, 1}, {1, 2, 1}};
    const int *w = weight[random_below(g, sizeof weight / sizeof *weight)];
    vec3 s = {0, 0, 0};
    for (int k = 0; k < 3; k++) s = vmadd(s, q[k], (real)w[k] / 4);
    return s;
}

/* Corners with all their digits: projections are rounded, and only the margin saves the answer. */
static void test_touching_triangles(void)
{
    size_t n = check_count(400000), lost = 0, lost_item = 0, lost_polygon = 0;
    int bits = real_is_float ? 20 : 48;
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(1, i, 0);
        int wide_by = i % 3 == 0 ? bits : i % 3 == 1 ? bits / 2 : 8;  /* size against distance */
        vec3 c = whole_vector(&g, bits - 1), q[4];
        for (int k = 0; k < 3; k++) q[k] = vadd(c, whole_vector(&g, wide_by - 1));
        q[3] = vadd(q[0], vsub(q[2], q[1]));
        triangle t = {q[0], q[1], q[2]};
        shape s[2] = {shape_of_triangle(t), shape_of_polygon(polygon_of(q, 4))};
        scene world = {s, 2};
        items x = items_of_scene(&world);
        aabb b = box_about(witness_of_corners(q, &g), &g, ldexp((real)1, wide_by - (int)(i % 7)));
        lost += !items_overlap_bounds(&x, 0, b);
        lost_item += !items_overlap_box(&x, 0, b), lost_polygon += !items_overlap_box(&x, 1, b);
    }
    check_equal(lost, 0, "bounds say no to a box that holds a point of the triangle, of %zu", n);
    check_equal(lost_item, 0, "the axes say no to a box that holds a point of the triangle");
    check_equal(lost_polygon, 0, "the axes say no to a box that holds a point of the polygon");
}

/* Triangles climbed to: a corner of a box at a point of the triangle (a weighted mean of corners,
 * exactly) that the normal, rounded, puts 2 of the 4 epsilon beyond all three corners. The first in
 * double, the second in float. */
static void test_touching_climbed_to(void)
{
    static const double list[2][9] = {
        {0x1.5cd20390a634p-2, 0x1.ff5414528494p-1, -0x1.1be9ee2ff52ap-1,
         0x1.ccebc8e78b7ep-1, 0x1.fe911456837p-1, -0x1.85be22462c8p-3,
         0x1.435861a2152ap-1, 0x1.ff3c182e6408p-1, 0x1.616228dd705p-4},
        {-0x1.9ce5p-1, 0x1.7cf7p-1, 0x1.75e8p-3, -0x1.9ccap-1, -0x1.865d8p-1, -0x1.88b18p-1,
         -0x1.9cd84p-1, 0x1.4e67cp-1, -0x1.65628p-1}};
    static const int weight[][3] = {{2, 2, 0}, {0, 1, 3}, {1, 0, 3}, {1, 1, 2}, {2, 1, 1},
                                    {1, 2, 1}};
    const double *x = list[real_is_float];
    vec3 q[3];
    for (int k = 0; k < 3; k++)
        q[k] = (vec3){(real)x[3 * k], (real)x[3 * k + 1], (real)x[3 * k + 2]};
    shape s = shape_of_triangle((triangle){q[0], q[1], q[2]});
    scene world = {&s, 1};
    items one = items_of_scene(&world);
    vec3 n = vcross(vsub(q[1], q[0]), vsub(q[2], q[0])), far = {2, 2, 2};
    for (int i = 0; i < 12; i++) {  /* the box lies to the one side of the plane, or the other */
        vec3 p = {0, 0, 0}, to = i % 2 ? far : vneg(far);
        for (int k = 0; k < 3; k++) p = vmadd(p, q[k], (real)weight[i / 2][k] / 4);
        to = (vec3){copysign(to.x, n.x * to.x), copysign(to.y, n.y * to.y),
                    copysign(to.z, n.z * to.z)};
        check(items_overlap_box(&one, 0, (aabb){vmin(p, to), vmax(p, to)}),
              "no to a box whose corner is on the triangle, %d", i);
    }
}

/* (1,2,2) is 3 long, (2,3,6) 7, and so on: c + k (1,2,2) is exactly 3 k from c. And w square to it
 * is the axis of a cylinder and of a cone. */
static void test_touching_round(void)
{
    static const int unit[][7] = {{1, 2, 2, 3, 2, 1, -2}, {2, 3, 6, 7, 3, -6, 2},
                                  {4, 4, 7, 9, 1, -8, 4}, {6, 2, 9, 11, 6, -9, -2},
                                  {0, 0, 1, 1, 3, 5, 0}};
    size_t n = check_count(300000), lost = 0, lost_cone = 0, inside = 0;
    int bits = real_is_float ? 14 : 40;
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(2, i, 0);
        const int *u = unit[i % 5];
        real k = floor(ldexp(random_next(&g), bits)) + 1, h = floor(8 * random_next(&g)) + 1;
        real end = floor(8 * random_next(&g));
        vec3 c = whole_vector(&g, bits), d = {(real)u[0], (real)u[1], (real)u[2]};
        vec3 w = {(real)u[4], (real)u[5], (real)u[6]}, p = vmadd(c, d, k);
        cone side = {vmadd(c, w, -h), k * (real)u[3] * 2, vmadd(c, w, h), 0};  /* r = k u3 at c */
        if (i % 6 > 3) side.ra = -side.ra;  /* with rb = 0: the same */
        if (i % 2) side.ra = side.rb = k * (real)u[3] * (i % 3 ? 1 : -1);
        if (i % 2) p = vmadd(p, w, -real_min(end, h));
        shape s[2] = {shape_of_sphere((sphere){c, k * (real)u[3]}), shape_of_cone(side)};
        scene world = {s, 2};
        items x = items_of_scene(&world);
        lost += !items_overlap_box(&x, 0, box_about(vmadd(c, d, k), &g, k));
        lost_cone += !items_overlap_box(&x, 1, box_about(p, &g, k));
        real half = k * (real)u[3] / 2;
        vec3 e = {half, half, half};  /* reaches sqrt(3)/2 of the radius */
        inside += items_overlap_box(&x, 0, (aabb){vsub(c, e), vadd(c, e)});
    }
    check_equal(lost, 0, "no to a box that holds a point of the sphere, of %zu", n);
    check_equal(lost_cone, 0, "no to a box that holds a point of the cone");
    check_equal(inside, 0, "a sphere is hollow: yes to a box within it");
}

/* A corner as near the sphere as a rounding, on it or beyond, by all digits. Differences and
 * squares just above a power of two, which round the worst. */
static void test_touching_spheres(void)
{
    size_t n = check_count(1600000), lost = 0, tried = 0;
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(5, i, 0);
        vec3 c = random_in_cube(&g, 1), p = vadd(vadd(c, vec(1, 1, 1)),
            vscale(vec(random_next(&g), random_next(&g), random_next(&g)), (real)0.03));
        real r = vlength(vsub(p, c)) * (1 + (real)((int)(i % 5) - 2) * real_epsilon / 2);
        wide3 d = wide3_sub(wide3_of(p), wide3_of(c));
        wide rr = wide_product((double)r, (double)r);
        int beyond = wide_sign(wide_sub(wide3_dot(d, d), rr));
        aabb out = {p, vadd(p, vec(1, 1, 1))}, in = {c, p};
        overlap_plan plan = {.is_sphere = true, .ball = {c, r}, .box = beyond > 0 ? in : out};
        lost += !overlap_box(&plan, plan.box), tried += beyond <= 0;
    }
    check_equal(lost, 0, "no to a box whose corner is on the sphere's other side, of %zu", n);
    check(tried > n / 4 && tried < 3 * n / 4, "corners within and beyond: %zu of %zu", tried, n);
}

/* Is there an axis between triangle and box? In whole numbers, all thirteen. */
static bool apart_on(const int64_t a[3], const int64_t q[3][3], const int64_t lo[3],
                     const int64_t hi[3])
{
    int64_t from = INT64_MAX, to = INT64_MIN, box_from = 0, box_to = 0;
    for (int i = 0; i < 3; i++) {
        int64_t at = a[0] * q[i][0] + a[1] * q[i][1] + a[2] * q[i][2];
        from = at < from ? at : from, to = at > to ? at : to;
        box_from += a[i] * (a[i] > 0 ? lo[i] : hi[i]), box_to += a[i] * (a[i] > 0 ? hi[i] : lo[i]);
    }
    return from > box_to || to < box_from;
}

static bool touches_exactly(const vec3 *v, aabb b)
{
    int64_t q[3][3], e[3][3], lo[3], hi[3], n[3];
    for (int k = 0; k < 3; k++) {
        lo[k] = (int64_t)vaxis(b.lo, k), hi[k] = (int64_t)vaxis(b.hi, k);
        for (int i = 0; i < 3; i++) q[i][k] = (int64_t)vaxis(v[i], k);
    }
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) e[i][k] = q[(i + 1) % 3][k] - q[i][k];
    for (int k = 0; k < 3; k++)
        n[k] = e[0][(k + 1) % 3] * e[1][(k + 2) % 3] - e[0][(k + 2) % 3] * e[1][(k + 1) % 3];
    if (apart_on(n, (const int64_t(*)[3])q, lo, hi)) return false;
    for (int k = 0; k < 3; k++) {
        int64_t axis[3] = {0, 0, 0};
        axis[k] = 1;
        if (apart_on(axis, (const int64_t(*)[3])q, lo, hi)) return false;
        for (int i = 0; i < 3; i++) {
            int64_t cross[3];
            for (int j = 0; j < 3; j++)
                cross[j] = e[i][(j + 1) % 3] * axis[(j + 2) % 3]
                           - e[i][(j + 2) % 3] * axis[(j + 1) % 3];
            if (apart_on(cross, (const int64_t(*)[3])q, lo, hi)) return false;
        }
    }
    return true;
}

/* Whole numbers so small that a gap of 1 is more than the margin: the answer must be exact, both
 * ways. 4 epsilon |a|1 S < 1 for S = 32 in float, 1024 in double. */
static void test_equals_exact(void)
{
    size_t n = check_count(300000), wrong = 0, yes = 0, cheap = 0;
    real size = real_is_float ? 32 : 1024;
    mesh m = mesh_room(1);
    items x = items_of_mesh(&m);
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(3, i, 0);
        aabb b = aabb_empty();
        real small = i % 2 ? size : 8;  /* small numbers touch often */
        for (int k = 0; k < 3; k++) {
            vec3 v = random_in_cube(&g, small), c = random_in_cube(&g, small);
            m.v[k] = (vec3){trunc(v.x), trunc(v.y), trunc(v.z)};
            if (k < 2) b = aabb_grow_point(b, (vec3){trunc(c.x), trunc(c.y), trunc(c.z)});
        }
        if (i % 5 == 0) m.v[1] = m.v[0];           /* a line */
        if (i % 7 == 0) m.v[1] = m.v[2] = m.v[0];  /* a point */
        bool touches = touches_exactly(m.v, b);
        wrong += items_overlap_box(&x, 0, b) != touches;
        yes += touches, cheap += items_overlap_bounds(&x, 0, b);
    }
    check_equal(wrong, 0, "axes against whole numbers, of %zu", n);
    check(yes > n / 5 && n - yes > n / 5, "both answers occur: %zu of %zu are yes", yes, n);
    check_at_least(cheap, yes + n / 20, "bounds alone say yes more often: that is their price");
    mesh_free(&m);
}

static void test_sick(void)
{
    shape s[] = {shape_of_sphere((sphere){{(real)NAN, 0, 0}, 1}),
                 shape_of_triangle((triangle){{0, 0, 0}, {(real)NAN, 0, 0}, {0, 1, 0}}),
                 shape_of_polygon(polygon_of(NULL, 0)),
                 shape_of_sphere((sphere){{0, 0, 0}, 0}),
                 shape_of_cone((cone){{0, 0, 0}, 0, {0, 0, 0}, 0}),
                 shape_of_triangle((triangle){{0, 0, 0}, {0, 0, 0}, {0, 0, 0}})};
    scene world = {s, sizeof s / sizeof *s};
    items x = items_of_scene(&world);
    aabb about = {{-1, -1, -1}, {0, 0, 0}}, beside = {{1, 1, 1}, {2, 2, 2}};
    for (size_t i = 0; i < 3; i++) {
        overlap_plan p;
        check(i == 1 || !overlap_plan_of(&x, i, &p), "sick shape %zu: no plan", i);
    }
    for (size_t i = 3; i < world.n; i++) {
        check(items_overlap_box(&x, i, about), "a point touches a box with it as a corner, %zu", i);
        check(!items_overlap_box(&x, i, beside), "and none beside it, %zu", i);
    }
    real tiny = sqrt(real_smallest) / 64;  /* squares underflow */
    s[0] = shape_of_sphere((sphere){{0, 0, 0}, tiny});
    s[1] = shape_of_triangle((triangle){{tiny, 0, 0}, {0, tiny, 0}, {0, 0, tiny}});
    for (size_t i = 0; i < 2; i++)
        check(items_overlap_box(&x, i, (aabb){{0, 0, 0}, {tiny, tiny, tiny}}),
              "items of size %g touch", (double)tiny);
}

int main(void)
{
    return check_all("10_overlap", test_touching_triangles, test_touching_climbed_to,
                     test_touching_round, test_touching_spheres, test_equals_exact,
                     test_sick);
}
