/* 09_aabb with full mantissas and with something in the box: what is hit has its box hit, and how
 * often the converse is wrong; bounding spheres and turned boxes likewise. */
#include "../chapters/09_aabb/lab/exact.h"
#include "../chapters/09_aabb/lab/slabs.h"
#include "../chapters/09_aabb/lab/volumes.h"
#include "../chapters/09_aabb/structure.h"
#include "check.h"

/* What is reported in error passes the box by little: the padding 16 u, 3 u for the entry and 3 u
 * for the exit, 1 u for the product that pads: 23 u < 12 epsilon of t. Half of the rays are turned
 * by some epsilon, so that they pass at all such distances. */
static void test_full_mantissa(void)
{
    size_t missed = 0, late = 0, alarms = 0, others = 0, misses = 0, lanes = 0, lanes_late = 0;
    double worst = 0;
    for (size_t i = 0; i < check_count(1000000); i++) {
        aabb_trial c = aabb_full_trial_of((aabb_trial_kind)(i % 4), 1, i);
        if (i & 4) c.r.d.x *= 1 + real_epsilon * (real)((int)(i / 8 % 80) - 40);
        aabb_wide w = wide_aabb(c.b, c.r);
        real t, u;
        bool h = aabb_hit(c.b, c.r, &t);
        missed += w.hit && !h, misses += !w.hit;
        others += w.hit && !aabb_hit_closed(c.b, c.r, &u);
        bool g = aabb_hit_lanes(c.b, c.r, &u);
        lanes += w.hit && !g;
        lanes_late += w.hit && g && wide_sign(wide_sub(wide_of((double)u), w.enter)) > 0;
        late += w.hit && h && wide_sign(wide_sub(wide_of((double)t), w.enter)) > 0;
        alarms += h && !w.hit;
        if (h && !w.hit) worst = check_worse(worst, -w.gap);
    }
    check_equal(missed, 0, "false negatives, all digits random");
    check_equal(late, 0, "t_enter behind the exact one");
    check_equal(lanes, 0, "aabb8_hit: false negatives");
    check_equal(lanes_late, 0, "aabb8_hit: t_enter behind the exact one");
    check_at_least(others, check_count(1000000) / 100, "<= alone loses some of them");
    check_at_most(worst, 12 * (double)real_epsilon, "how far a ray may pass and still be reported");
    check_at_least(worst, 8 * (double)real_epsilon, "that bound is not idle");
    check(alarms > 0 && alarms < misses, "some of the misses are reported, others are not");
}

/* ---- what a triangle test calls a hit, against the box of that very triangle ---- */

typedef struct { triangle t; ray r; } own_box_case;
typedef struct { size_t hits, lost, lost_kept, early; } own_box_count;

/* A triangle, and a ray at a corner of it, an edge or the inside; width 1: any shape, small: a
 * needle; flat: in a plane z = constant, and so its box. */
static own_box_case own_box_case_of(uint64_t seed, uint64_t i, real width, bool flat)
{
    random_stream s = random_start(seed, i, 0);
    vec3 a = random_in_cube(&s, 1), e = random_in_cube(&s, 1), f = random_in_cube(&s, 1);
    triangle t = {a, vadd(a, e), vadd(vmadd(a, e, random_next(&s)), vscale(f, width))};
    if (flat) t.b.z = t.c.z = t.a.z;
    int aim = random_integer(&s, 0, 2);  /* 0: a corner, 1: an edge, 2: inside */
    real u = aim > 0 ? random_next(&s) : 0, v = aim > 1 ? (1 - u) * random_next(&s) : 0;
    vec3 p = vmadd(vmadd(vscale(t.a, 1 - u - v), t.b, u), t.c, v);
    real far = pow((real)100, 2 * random_next(&s) - 1);
    vec3 o = vscale(random_in_cube(&s, 1), far);
    return (own_box_case){t, ray_from(o, vsub(p, o))};
}

static own_box_count own_box_counted(uint64_t seed, size_t cases, real width, bool flat)
{
    own_box_count n = {0};
    for (size_t i = 0; i < cases; i++) {
        own_box_case c = own_box_case_of(seed, i, width, flat);
        aabb b = first_triangle_box(c.t);
        real t, u;
        hit h;
        if (!triangle_hit(c.t, c.r, &h)) continue;
        n.hits++;
        n.lost_kept += !aabb_hit_kept(b, c.r, &u);
        if (!aabb_hit(b, c.r, &t)) n.lost++;
        else n.early += h.t < t;
    }
    return n;
}

/* What a triangle test calls a hit, its box must call one, too: corners, edges, inside, needles,
 * flat boxes, near and far. aabb_hit_kept loses some of them: a tree with it would lose those
 * triangles. In flat boxes a computed t may come a hair before the box, one in 10000. */
static void test_triangle_in_its_box(void)
{
    const real width[] = {1, 0.001, 0.000001, 1e-9};
    for (int k = 0; k < 8; k++) {
        own_box_count n = own_box_counted(2, check_count(150000), width[k / 2], k % 2);
        check_at_least(n.hits, check_count(150000) / 4, "most rays hit what they are aimed at");
        check_equal(n.lost, 0, "triangles hit whose box is not, of %zu", n.hits);
        check_at_least(n.lost_kept, n.hits / 100, "products n (1/d) without padding lose some");
        if (k % 2 == 0) check_equal(n.early, 0, "a triangle is not hit before its box");
        else check_at_most(n.early, 1 + n.hits / 2000, "in a flat box hardly ever");
    }
}

/* A count of hits with probability p among n: within 4.5 standard deviations but once in 150000. */
static double allowed(double p, double n) { return 4.5 * sqrt(p * (1 - p) / n); }

/* Surface of the hull of a convex shape; a triangle has two sides. */
static double convex_area(const aabb_content *c)
{
    double area = 0;
    for (size_t i = 0; i < c->n; i++) {
        triangle t = c->t[i];
        area += (double)vlength(vcross(vsub(t.b, t.a), vsub(t.c, t.a))) / (c->n == 1 ? 1 : 2);
    }
    return area;
}

/* (9.6) for a needle and a ball in each of their volumes, and nothing is lost; for the
 * volumes of all shapes in the sphere from which the lines come. */
static void test_volumes(void)
{
    size_t n = check_count(60000);
    for (int s = 0; s < content_shapes; s++) {
        aabb_content c = content_of(s);
        double area[content_kinds] = {(double)(4 * pi * c.ball.r * c.ball.r),
                                      (double)aabb_area(c.box),
                                      (double)aabb_area(c.turned.b)};
        double vain[content_kinds];
        check_at_most(area[2], area[1], "shape %d: the turned box is not larger", s);
        aabb room = c.room;
        double whole = (double)pi * (double)vdot(vsub(room.hi, room.lo), vsub(room.hi, room.lo));
        for (int k = 0; k < content_kinds; k++) {
            size_t hits = 0;
            real t;
            for (size_t i = 0; i < n; i++) hits += content_hit(&c, k, line_through(room, 6, i), &t);
            check_close((double)hits / (double)n, area[k] / whole,
                        allowed(area[k] / whole, (double)n), "(9.6) for volume %d of %d", k, s);
        }
        size_t lines = s > 1 ? check_count(3000) : n;
        check_equal(content_in_vain(&c, 4, lines, vain), 0, "shape %d: lost", s);
        for (int k = 0; s < 2 && k < content_kinds; k++) {
            double p = convex_area(&c) / area[k];
            double of = (double)lines * area[k] / whole;  /* so many lines hit it */
            check_close(vain[k], 100 * (1 - p), 100 * allowed(p, of) + 1, "vain: %d in %d", s, k);
        }
        free(c.t);
    }
}

/* Known ones: the sphere round a ball, and the turned box round a turned square. */
static void test_known_volumes(void)
{
    aabb_content ball = content_of(1);
    check_close(ball.ball.r, 1, 0.002, "a sphere round a ball");
    check_at_most((double)vlength(ball.ball.c), 0.002, "its centre");
    free(ball.t);
    const vec3 square[] = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
    aabb_turned u = turned_round(square, 4);
    check_close(aabb_area(u.b), 4, 0.01, "a square on its corner: sides of sqrt 2");
    check_close(ball_round(square, 4).r, 1, 0.002, "half its diagonal");
}

/* Rays aimed at corners, from near and far, touch the volumes or pass within rounding: none lost,
 * and none entered behind the corner. */
static void test_volumes_touched(void)
{
    for (int s = 0; s < content_shapes; s++) {
        aabb_content c = content_of(s);
        size_t lost[content_kinds] = {0}, late[content_kinds] = {0};
        for (size_t i = 0; i < check_count(100000); i++) {
            random_stream g = random_start(9, i, 0);
            triangle t = c.t[random_next_bits(&g) % c.n];
            vec3 p = i % 3 == 0 ? t.a : i % 3 == 1 ? t.b : t.c;
            real far = pow((real)1000, random_next(&g));
            vec3 o = vmadd(p, random_in_cube(&g, 1), far);
            ray r = ray_from(o, vsub(p, o));
            for (int k = 0; k < content_kinds; k++) {
                real enter = 0;
                lost[k] += !content_hit(&c, k, r, &enter);
                late[k] += enter > 1 + 4 * real_epsilon;
            }
        }
        for (int k = 0; k < content_kinds; k++) {
            check_equal(lost[k], 0, "shape %d, volume %d: corners aimed at and lost", s, k);
            check_equal(late[k], 0, "shape %d, volume %d: entered behind the corner", s, k);
        }
        free(c.t);
    }
}

/* (10.1) by its sum: a hit is off its item by up to 256 epsilon D, a plane's t by 4; what is left
 * is for the building of cells. D by the corners of the box, each along each axis. */
static void test_delta(void)
{
    double least = HUGE_VAL, most = 0;
    for (size_t i = 0; i < 3000; i++) {
        random_stream s = random_start(23, i, 0);
        real size = pow((real)10, random_between(&s, -3, 3));
        real far = pow((real)10, random_between(&s, -3, 6));
        vec3 at = random_in_cube(&s, far), side = vscale(random_in_cube(&s, 1), size);
        vec3 other = i % 7 ? vadd(at, side) : at;
        aabb box = {vmin(at, other), vmax(at, other)};
        vec3 o = i % 3 ? random_in_cube(&s, far) : vmadd(at, side, random_next(&s));
        ray r = ray_from(o, vec(0, 0, 1));
        double D = 0;
        for (int corner = 0; corner < 8; corner++)
            for (int k = 0; k < 3; k++) {
                real c = vaxis(corner >> k & 1 ? box.hi : box.lo, k);
                D = fmax(D, fabs((double)c - (double)vaxis(r.o, k)));
            }
        if (D == 0) continue;
        double part = (double)query_delta(r, box) / ((double)real_epsilon * D);
        least = fmin(least, part), most = check_worse(most, part);
    }
    check_at_least(least, 260, "delta, in epsilon D: 256 and 4 are owed");
    check_at_most(most, 513, "and no more than twice that");
    ray still = ray_from(vec(1, 2, 3), vec(1, 0, 0));
    check(query_delta(still, (aabb){still.o, still.o}) > 0, "a little even where all is one point");
}

/* A cell without room of its own is cut for as long as less than half of all room is gone. */
static void test_room(void)
{
    structure_stats s = {.items = 1000, .references = (size_t)structure_room(1000) / 2};
    check(!structure_is_full(&s, 2, 1), "no room in the cell, but half of all");
    s.references++;
    check(structure_is_full(&s, 2, 1), "less than half");
    check(!structure_is_full(&s, 1, 1), "room in the cell");
}

/* Of every power of two and the largest number: a power of two, finite as 1 / it is, that leaves
 * [1/2, 1) where the exponent is within 1000 (100 in float). */
static void test_direction_scale(void)
{
    int most = real_is_float ? 100 : 1000, last = real_is_float ? 128 : 1024;
    for (int e = real_is_float ? -148 : -1073; e <= last; e++) {
        real d = e < last ? ldexp((real)0.5, e) : real_largest, s = direction_scale(d);
        int of;
        check(frexp(s, &of) == (real)0.5 && isfinite(s) && isfinite(1 / s), "2^%d", e - 1);
        int due = abs(e - 1) <= 20 ? 0 : e > most ? most : e < -most ? -most : e;
        check_equal(of - 1, due, "exponent of the scale of 2^%d", e - 1);
    }
}

int main(void)
{
    return check_all("09_shapes", test_full_mantissa, test_triangle_in_its_box, test_volumes,
                     test_known_volumes, test_volumes_touched, test_delta, test_direction_scale,
                     test_room);
}
