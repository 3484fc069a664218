/* 08's first.h: right where a triangle is parallel to the picture and away from its edges; wrong in
 * depth and weights of a slanted one, at shared edges, behind the eye. */
#include "check.h"
#include "../common/random.h"
#include "../chapters/08_object_order/raster.h"

#define eps ((double)real_epsilon)
enum { side = 16 };

static first_camera first_front(void)  /* window: a unit a pixel at distance 1 */
{
    return (first_camera){{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0, side, 0, side, 1, side,
                          side};
}

static first_raster first_alone(triangle t)
{
    first_camera c = first_front();
    first_raster s = first_raster_new(side, side);
    first_raster_triangle(&s, first_project(c, t.a), first_project(c, t.b),
                          first_project(c, t.c), 0);
    return s;
}

/* Does r pass within 1 % of a weight from an edge of t? The volumes of (4.12). */
static bool near_edge(triangle t, ray r)
{
    real e[3] = {vdot(r.d, vcross(t.a, t.b)), vdot(r.d, vcross(t.b, t.c)),
                 vdot(r.d, vcross(t.c, t.a))};
    real least = (real)0.01 * fabs(e[0] + e[1] + e[2]);
    return fabs(e[0]) < least || fabs(e[1]) < least || fabs(e[2]) < least;
}

/* Two triangles at depths of their own: each pixel as the rays of 04's first.h have it, but where
 * one passes within 1 % of an edge. */
static void test_parallel(void)
{
    random_stream g = random_start(1, 0, 0);
    size_t n = check_count(2000), wrong = 0, judged = 0, hits = 0;
    double off = 0;
    for (size_t i = 0; i < n; i++) {
        triangle tri[2];
        for (int k = 0; k < 2; k++) {
            real z = random_between(&g, 1, 9);
            vec3 *corner[3] = {&tri[k].a, &tri[k].b, &tri[k].c};
            for (int j = 0; j < 3; j++)
                *corner[j] = (vec3){z * side * random_next(&g), z * side * random_next(&g), -z};
        }
        first_mesh m = {tri, 2};
        first_raster s = first_raster_new(side, side);
        first_camera c = first_front();
        first_raster_mesh(&s, &m, c);
        for (int k = 0; k < side * side; k++) {
            ray r = first_camera_ray(c, (real)(k % side) + (real)0.5, (real)(k / side) + (real)0.5);
            hit due = {real_infinity, 0, 0, UINT32_MAX}, is = s.h[k];
            if (near_edge(tri[0], r) || near_edge(tri[1], r)) continue;
            (void)first_mesh_hit(&m, r, &due);
            judged++, hits += due.shape != UINT32_MAX, wrong += is.shape != due.shape;
            if (is.shape != due.shape || due.shape == UINT32_MAX) continue;
            double weights = fabs((double)(is.u - due.u)) + fabs((double)(is.v - due.v));
            off = check_worse(off, fabs((double)(is.t / due.t) - 1) + weights);
        }
        first_raster_free(&s);
    }
    check_equal(wrong, 0, "pixels unlike their ray, of %zu", judged);
    check_at_least((double)hits, 0.1 * (double)judged, "the test sees triangles");
    check_at_most(off, 1e5 * eps, "t, u, v of triangles parallel to the picture");
}

/* From depth 1 to 9: in the middle of the picture of edge a b lies the point that is a tenth of the
 * way, for the near half fills nine tenths of the length. By (8.4): u = (1/9) / (1 + 1/9) = 1/10,
 * z = 1.8; first.h says 1/2 and 5. */
static void test_slanted(void)
{
    triangle t = {{2, 8.5, -1}, {9 * 15, 9 * 8.5, -9}, {2, 0.5, -1}};
    first_raster s = first_alone(t);
    hit h = s.h[7 * side + 8];  /* middle (8.5, 7.5): y upwards from 0 to 16: the line y = 8.5 */
    uint32_t index[3] = {0, 1, 2};
    mesh m = {.v = &t.a, .vertices = 3, .index = index, .triangles = 1};
    camera c = {CAMERA_PERSPECTIVE, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0, side, 0, side, 1,
                {0, 0, 0}};
    hit due = hit_none;
    for (uint32_t k = 3; k-- > 0;) {  /* each corner first: every weight gets its tie back */
        raster full = raster_new(side, side);
        for (uint32_t i = 0; i < 3; i++) index[i] = (k + i) % 3;
        raster_mesh(&full, &m, c, raster_default);
        due = full.h[7 * side + 8];
        real weight[3] = {1 - due.u - due.v, due.u, due.v};
        check_close((double)weight[(4 - k) % 3], 0.1, 32 * eps, "the weight of b, %u first", k);
        raster_free(&full);
    }
    check_close((double)h.u, 0.5, 32 * eps, "first.h: half the way in the picture");
    check_close((double)h.t, 5, 200 * eps, "first.h: half the depth");
    check_close((double)due.u, 0.1, 32 * eps, "raster.h: a tenth of the way in space");
    check_close((double)due.t, 1.8, 64 * eps, "raster.h: the depth");
    first_raster_free(&s);
}

/* Two triangles with the edge along middles of pixels: first.h draws these twice. */
static void test_shared(void)
{
    triangle p = {{0, 0, -1}, {16, 0, -1}, {0, 16, -1}};
    triangle q = {{16, 0, -1}, {16, 16, -1}, {0, 16, -1}};
    long before = first_covered;
    first_raster a = first_alone(p), b = first_alone(q);
    check_equal(first_covered - before, side * side + side, "16 pixels of 256 are drawn twice");
    first_raster_free(&a), first_raster_free(&b);
}

static void test_behind(void)
{
    triangle t = {{0, 0, -1}, {16, 0, -1}, {8, 16, 1}};
    long before = first_covered;
    first_raster s = first_alone(t);
    check_equal(first_covered, before, "a corner behind the eye: left out");
    first_raster_free(&s);
    triangle one = {{0, 0, -1}, {16, 0, -1}, {0, 16, -1}}, same[2] = {one, one};
    first_mesh twice = {same, 2};
    s = first_raster_new(side, side);
    first_raster_mesh(&s, &twice, first_front());
    check_equal(s.h[15 * side].shape, 0, "of two at the same depth the first one stays");
    first_raster_free(&s), before = first_covered;
    triangle bad = {{0, 0, -1}, {(real)NAN, 0, -1}, {8, 16, -1}};
    s = first_alone(bad);
    check_equal(first_covered, before, "NaN: nothing covered");
    first_raster_free(&s), first_raster_free(&s);
}

int main(void)
{
    test_parallel();
    test_slanted();
    test_shared();
    test_behind();
    return check_report("08_first");
}
