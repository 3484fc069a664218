/* 09_aabb with full mantissas and with something in the box: what is hit has its box hit, and how
 * often the converse is wrong. */
#include "../chapters/03_sphere/sphere.h"
#include "../chapters/07_mesh/scenes/teapot.h"
#include "../chapters/09_aabb/lab/alarms.h"
#include "../chapters/09_aabb/lab/own_box.h"
#include "check.h"

/* What is reported in error passes the box by little: the padding 16 u, 3 u for the entry and 3 u
 * for the exit, 1 u for the product that pads: 23 u < 12 epsilon of t. Half of the rays are turned
 * by some epsilon, so that they pass at all such distances. */
static void test_full_mantissa(void)
{
    size_t missed = 0, late = 0, alarms = 0, others = 0, misses = 0;
    double worst = 0;
    for (size_t i = 0; i < check_count(1000000); i++) {
        trial c = full_trial_of((trial_kind)(i % 4), 1, i);
        if (i & 4) c.r.d.x *= 1 + real_epsilon * (real)((int)(i / 8 % 80) - 40);
        wide_answer w = wide_aabb(c.b, c.r);
        real t, u;
        bool h = aabb_hit(c.b, c.r, &t);
        missed += w.hit && !h, misses += !w.hit;
        others += w.hit && !aabb_hit_inclusive(c.b, c.r, &u);
        late += w.hit && h && wide_sign(wide_sub(wide_of((double)t), w.enter)) > 0;
        alarms += h && !w.hit;
        if (h && !w.hit) worst = fmax(worst, -w.gap);
    }
    check_equal(missed, 0, "false negatives, all digits random");
    check_equal(late, 0, "t_enter behind the exact one");
    check_at_least(others, check_count(1000000) / 100, "the inclusive form loses some of them");
    check_at_most(worst, 12 * (double)real_epsilon, "how far a ray may pass and still be reported");
    check_at_least(worst, 8 * (double)real_epsilon, "that bound is not idle");
    check(alarms > 0 && alarms < misses, "some of the misses are reported, others are not");
}

/* What a triangle test calls a hit, its box must call one, too: corners, edges, inside, needles,
 * flat boxes, near and far. The inclusive form loses some 2 to 10 % of them: a tree with it would
 * lose those triangles. In flat boxes a computed t may come a hair before the box, one in 10000. */
static void test_triangle_in_its_box(void)
{
    const real width[] = {1, 0.001, 0.000001, 1e-9};
    for (int k = 0; k < 8; k++) {
        own_box_count n = own_box_counted(2, check_count(150000), width[k / 2], k % 2);
        check_at_least(n.hits, check_count(150000) / 4, "most rays hit what they are aimed at");
        check_equal(n.lost, 0, "triangles hit whose box is not, of %zu", n.hits);
        check_at_least(n.lost_inclusive, n.hits / 100, "the inclusive form loses some");
        if (k % 2 == 0) check_equal(n.early, 0, "a triangle is not hit before its box");
        else check_at_most(n.early, 1 + n.hits / 2000, "in a flat box hardly ever");
    }
}

/* A count of hits with probability p among n: within 4.5 standard deviations but once in 150000. */
static double allowed(double p, double n) { return 4.5 * sqrt(p * (1 - p) / n); }

/* (9.6) for a ball: 4 pi r^2 / 24 r^2 = pi / 6, so a box hit is wrong in 47.6 % of the cases. */
static void test_ball(void)
{
    aabb box = {{1, 1, 1}, {3, 3, 3}};
    sphere ball = {{2, 2, 2}, 1};
    size_t boxes = 0, balls = 0, lost = 0;
    for (size_t i = 0; i < check_count(1000000); i++) {
        ray r = line_through(box, 3, i);
        real t;
        hit h;
        bool in_box = aabb_hit(box, r, &t), in_ball = sphere_hit(ball, r, &h);
        boxes += in_box, balls += in_ball, lost += in_ball && !in_box;
    }
    double p = 3.14159265358979 / 6;
    check_equal(lost, 0, "no hit without its box");
    check_close((double)balls / (double)boxes, p, allowed(p, (double)boxes), "ball in a cube");
    double q = 24.0 / (4 * 3.14159265358979 * 3);  /* the cube in the sphere round it */
    check_close((double)boxes / (double)check_count(1000000), q,
                allowed(q, (double)check_count(1000000)), "(9.6) for the cube, too");
}

static void test_triangles(void)
{
    triangle slanted = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, flat = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}};
    double side = sqrt(3.0) / 2;  /* area; counted twice; the cube has 6, the rectangle 2 * 2 */
    const triangle t[] = {slanted, flat};
    const double expected[] = {2 * side / 6, 2 * 1.0 / 4};
    for (int k = 0; k < 2; k++) {
        boxed b = boxed_new(&t[k], 1);
        alarm_count c = boxed_count(&b, 4, check_count(300000));
        check_close((double)c.any_triangle / (double)c.any_box, expected[k],
                    allowed(expected[k], (double)c.any_box), "triangle %d in its box", k);
        check_equal(c.vain, c.any_box - c.any_triangle, "one box: vain is hit, but not inside");
        boxed_free(&b);
    }
}

/* In more boxes: the same hits, fewer tests of triangles. */
static void test_teapot(void)
{
    mesh m = teapot_mesh(3);
    triangle *t = allocate(m.triangles, sizeof *t);
    for (size_t i = 0; i < m.triangles; i++) t[i] = mesh_triangle(&m, i);
    boxed whole = boxed_new(t, m.triangles), parts = boxed_new(t, m.triangles);
    size_t rays = check_count(3000), before = SIZE_MAX, differ = 0;
    aabb all = boxed_bounds(&whole, 0, whole.n);
    for (size_t n = 1; n <= 64; n *= 4) {
        boxed_split(&parts, n);
        check_equal(parts.parts, n, "as many boxes as asked for");
        size_t held = 0;
        for (size_t k = 0; k < parts.parts; k++) held += parts.part[k].n;
        check_equal(held, m.triangles, "every triangle is in one box");
        alarm_count c = boxed_count(&parts, 5, rays);
        check(c.triangle_tests < before, "more boxes, fewer tests of triangles");
        check_equal(c.box_tests, n * rays, "every box is tested");
        before = c.triangle_tests;
        for (size_t i = 0; i < rays; i++) {
            ray r = line_through(all, 5, i);
            hit h = hit_none, g = hit_none;
            boxed_hit(&whole, r, &h), boxed_hit(&parts, r, &g);
            differ += h.t != g.t;
        }
    }
    check_equal(differ, 0, "the same closest t, whatever the boxes");
    boxed none = boxed_new(t, 0);
    hit h = {.t = -7};
    check(!boxed_hit(&none, ray_from(all.lo, (vec3){1, 1, 1}), &h) && h.t == -7, "no triangles");
    boxed_free(&whole), boxed_free(&parts), boxed_free(&none), boxed_free(&none);
    free(t);
    mesh_free(&m);
}

int main(void)
{
    test_full_mantissa();
    test_triangle_in_its_box();
    test_ball();
    test_triangles();
    test_teapot();
    return check_report("09_shapes");
}
