/* The box and the slab test of 09's first.h: where aabb.h has the same answer, and where not. */
#include "../chapters/09_aabb/aabb.h"
#include "../common/random.h"
#include "check.h"

static aabb random_box(random_stream *g, real size)
{
    aabb b = aabb_grow_point(aabb_empty(), random_in_cube(g, size));
    return aabb_grow_point(b, random_in_cube(g, size));
}

/* Boxes with a volume, rays in no special place: the same answers; t_enter but for rounding. */
static void test_easy(void)
{
    size_t n = check_count(100000), wrong = 0, hits = 0;
    double off = 0;
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(1, i, 0);
        aabb b = random_box(&g, 1);
        vec3 o = random_in_cube(&g, 3);
        ray r = ray_from(o, vsub(random_in_cube(&g, 1), o));
        real t = 0, expected = 0;
        bool got = first_aabb_hit(b, r, &t), due = aabb_hit(b, r, &expected);
        wrong += got != due, hits += due;
        if (got && due) off = check_worse(off, fabs((double)(real_max(t, 0) - expected)));
    }
    check_at_most((double)wrong, real_is_float ? (double)n * 1e-5 : 0, "%zu boxes: answers", n);
    check_at_least((double)hits, (double)n / 10, "boxes are hit");
    check_at_most(off, 40 * (double)real_epsilon, "t_enter of rays up to 5 long");
}

static void test_boxes(void)
{
    size_t n = check_count(20000), wrong = 0;
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(3, i, 0);
        triangle t = {random_in_cube(&g, 9), random_in_cube(&g, 9), random_in_cube(&g, 9)};
        aabb a = first_triangle_box(t), b = random_box(&g, 9), c = aabb_union(a, b);
        aabb same = aabb_grow_point(aabb_grow_point(aabb_grow_point(aabb_empty(), t.a), t.b), t.c);
        real hair = (real)0.25;
        aabb p = first_aabb_pad(a, hair);
        wrong += memcmp(&a, &same, sizeof a) != 0;
        wrong += first_aabb_overlap(a, b) != !aabb_is_empty(aabb_overlap(a, b));
        wrong += !aabb_contains(c, a.lo) || !aabb_contains(c, b.hi) || !aabb_contains(p, a.lo);
        wrong += p.lo.x != a.lo.x - hair || p.hi.z != a.hi.z + hair || p.hi.y != a.hi.y + hair;
    }
    check_equal(wrong, 0, "boxes of triangles, overlap, union, pad: as those of aabb.h");
    aabb left = {{0, 0, 0}, {1, 1, 1}}, right = {{1, 0, 0}, {2, 1, 1}};
    check(first_aabb_overlap(left, right), "boxes that touch overlap");
}

/* The hair is 1e-5 of the farthest coordinate, wherever that is. */
static void test_hair(void)
{
    triangle t[2] = {{vec(0, 0, 0), vec(1, 0, 0), vec(0, -40, 0)},
                     {vec(0, 0, 3), vec(1, 0, 3), vec(0, 2, 3)}};
    real hair = 7;
    aabb b = first_triangles_box(t, 2, &hair);
    check_close(hair, 40e-5, 1e-10, "1e-5 of 40");
    check(b.lo.y == -40 - hair && b.hi.z == 3 + hair && b.lo.x == -hair, "larger on all sides");
    b = first_triangles_box(t, 0, &hair);
    check(hair == 0 && aabb_is_empty(b), "no triangles: an empty box, no hair");
    t[0].a.x = (real)NAN;
    b = first_triangles_box(t, 2, &hair);
    check(hair > 0 && b.hi.z == 3 + hair, "a NaN leaves the others their box");
}

/* What the top of first.h says: all flat boxes are lost, a third of the rays in a face, and those
 * with d = -0.0. A hair, as the structures have it, mends the first two. */
static void test_hard(void)
{
    size_t n = check_count(20000), lost[4] = {0}, due = 0, faces = 0, hair_lost = 0;
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(4, i, 0);
        aabb flat = random_box(&g, 1), cube = {{-1, -1, -1}, {1, 1, 1}};
        int k = (int)(i % 3);
        real t;
        ((real *)&flat.hi)[k] = vaxis(flat.lo, k);
        vec3 o = random_in_cube(&g, 3), at = vscale(vadd(flat.lo, flat.hi), (real)0.5);
        ray r = ray_from(o, vsub(at, o));
        if (aabb_hit(flat, r, &t)) due++, lost[0] += !first_aabb_hit(flat, r, &t);
        hair_lost += !first_aabb_hit(first_aabb_pad(flat, (real)1e-5), r, &t);

        /* In a face of the cube, down another axis. */
        r.o = random_in_cube(&g, 1), r.d = (vec3){0, 0, 0};
        int along = (k + 1 + (int)(i / 3 % 2)) % 3;
        real way = i / 6 % 2 ? 1 : -1;
        ((real *)&r.o)[k] = i / 12 % 2 ? 1 : -1;
        ((real *)&r.o)[along] = -3 * way, ((real *)&r.d)[along] = way;
        if (aabb_hit(cube, r, &t)) faces++, lost[1] += !first_aabb_hit(cube, r, &t);
        hair_lost += !first_aabb_hit(first_aabb_pad(cube, (real)1e-5), r, &t);

        /* The same, inside; and with the zeros negative. */
        ((real *)&r.o)[k] /= 2;
        lost[2] += !first_aabb_hit(cube, r, &t);
        r.d = vneg((vec3){0, 0, 0}), ((real *)&r.d)[along] = way;
        lost[3] += !first_aabb_hit(cube, r, &t) && aabb_hit(cube, r, &t);
    }
    check(due == n && faces == n, "aabb_hit loses none of them");
    check_equal(lost[0], n, "flat boxes: t_enter = t_exit");
    check_close((double)lost[1] / (double)n, 1.0 / 3, 1 / (double)n, "rays in a face: 0/0");
    check_equal(lost[2], 0, "beside the faces all is well");
    check_equal(lost[3], n, "d = -0.0: near and far of (9.1) change places");
    check_equal(hair_lost, 0, "a hair mends what is flat, and faces");
}

/* It knows no interval: the box beyond tmax is hit; and what only touches t = 0 is not. */
static void test_interval(void)
{
    aabb b = {{0, 0, 0}, {1, 1, 1}};
    ray r = {vec(-5, 0.5, 0.5), 0, vec(1, 0, 0), 1};
    real t;
    check(first_aabb_hit(b, r, &t) && t == 5 && !aabb_hit(b, r, &t), "beyond tmax");
    r = ray_from(vec(1, 0.5, 0.5), vec(1, 0, 0));
    check(!first_aabb_hit(b, r, &t) && aabb_hit(b, r, &t), "from a face on, and away");
    r = ray_from(vec(0.5, 0.5, 0.5), vec(0, 0, 0));
    check(first_aabb_hit(b, r, &t), "direction 0, inside: in all slabs at every t");
    r.o = vec(2, 0.5, 0.5);
    check(!first_aabb_hit(b, r, &t), "direction 0, outside: in one slab at no t");
    check(!first_aabb_hit(aabb_empty(), ray_from(vec(0, 0, 0), vec(1, 2, 3)), &t), "nothing");
}

int main(void)
{
    return check_all("09_first", test_easy, test_boxes, test_hair, test_hard, test_interval);
}
