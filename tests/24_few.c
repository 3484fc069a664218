/* Tests of few.h: the answers of the tree, for meshes that make sorting out hard. */
#include "check.h"
#include "../chapters/21_distributed/scenes/cornell.h"
#include "../chapters/24_direct_light/scenes/lit_cornell.h"
#include "../common/random.h"

static vec3 somewhere(random_stream *s)
{
    real x = random_next(s), y = random_next(s), z = random_next(s);
    return (vec3){2 * x - 1, 2 * y - 1, 2 * z - 1};
}

/* kind 0: any triangles; 1: pairs in a plane; 2: needles; 3: on a lattice, ties; 4: far away;
 * 5: pairs bent along their diagonal, so little that they may still share a lane, or just not. */
static mesh make(int kind, size_t n, random_stream *s)
{
    mesh m = {.v = allocate(3 * n, sizeof *m.v), .vertices = 3 * n, .triangles = n,
              .index = allocate(3 * n, sizeof *m.index)};
    for (size_t i = 0; i < 3 * n; i++) {
        m.index[i] = (uint32_t)i;
        vec3 p = somewhere(s);
        if (kind == 2 && i % 3 == 2) p = vmadd(m.v[i - 1], p, 1e-5);
        if (kind == 3) p = (vec3){floor(p.x * 2), floor(p.y * 2), floor(p.z * 2)};
        if (kind == 4) p = vadd(p, (vec3){1000, -2000, 500});
        m.v[i] = p;
    }
    for (size_t i = 0; (kind == 1 || kind == 5) && i + 1 < n; i += 2) {
        vec3 *a = m.v + 3 * i, e = vsub(a[1], a[0]);
        a[2] = vadd(a[1], vcross(e, (vec3){0, 1, 0}));
        a[3] = a[0], a[4] = a[2], a[5] = vadd(a[0], vsub(a[2], a[1]));
        vec3 across = vcross(e, vsub(a[2], a[1]));
        if (kind == 5) a[5] = vmadd(a[5], across, ldexp((real)1, -(int)(random_next(s) * 60)));
    }
    return m;
}

/* From near the plane of t, or in it, towards p: edge-on, or nearly. */
static ray skim(triangle t, vec3 p, random_stream *s)
{
    vec3 u = vsub(t.b, t.a), v = vsub(t.c, t.a), n = vcross(u, v);
    vec3 o = vadd(p, vadd(vscale(u, 4 * random_next(s) - 2), vscale(v, 4 * random_next(s) - 2)));
    real off = random_next(s) < (real)0.1 ? 0 : ldexp((real)1, -(int)(random_next(s) * 56));
    return ray_between(vmadd(o, n, random_next(s) < (real)0.5 ? off : -off), p);
}

/* A ray from around the mesh, every other one aimed at a triangle, its edge or corner; a third of
 * these skim over it. */
static ray aim(const mesh *m, int k, random_stream *s)
{
    vec3 lo, hi;
    mesh_bounds(m, &lo, &hi);
    vec3 c = vscale(vadd(lo, hi), 0.5), o = vmadd(c, somewhere(s), k % 3 == 0 ? 30 : 1);
    if (k % 2 == 0) return ray_from(o, somewhere(s));
    size_t i = (size_t)(random_next(s) * (real)m->triangles);
    triangle t = mesh_triangle(m, i);
    real u = k % 4 == 1 ? random_next(s) : 0, v = k % 8 < 4 ? (1 - u) * random_next(s) : 0;
    vec3 p = vadd(t.a, vadd(vscale(vsub(t.b, t.a), u), vscale(vsub(t.c, t.a), v)));
    ray r = k % 3 == 1 ? skim(t, p, s) : ray_between(o, p);
    r.tmax = k % 16 < 8 ? real_infinity : 1;
    return r;
}

static void test_same_as_tree(void)
{
    random_stream s = random_start(24, 1, 1);
    size_t different = 0, hits = 0, asked = 0;
    for (int round = 0; round < (int)check_count(200); round++) {
        int kind = round % 6;
        mesh m = make(kind, 1 + (size_t)(random_next(&s) * few_most), &s);
        few f;
        bvh_mesh b;
        check(few_build(&m, &f), "up to 64 triangles are taken");
        check(bvh_mesh_build(&m, bvh_defaults, &b, NULL), "built");
        for (int k = 0; k < 1000; k++) {
            ray r = aim(&m, k, &s);
            hit a = hit_none, h = hit_none;
            int known = few_hit(&f, &m, r, few_skip_none, &h);
            bool met = bvh_mesh_hit(&b, r, &a);
            asked += known < 0 && !vzero(r.d), hits += met;
            if (known < 0) continue;
            different += known != met || a.t != h.t || a.u != h.u || a.v != h.v
                || a.shape != h.shape;
            different += few_occluded(&f, &m, r, few_skip_none) != bvh_mesh_occluded(&b, r);
        }
        few_free(&f), bvh_mesh_free(&b), mesh_free(&m);
    }
    check_equal(different, 0, "hits that are not the tree's, bit by bit");
    check_equal(asked, 0, "rays of usual size that were left to the tree");
    check_at_least(hits, check_count(200) * 200, "rays that hit: something to compare");
}

static void test_limits(void)
{
    random_stream s = random_start(24, 2, 1);
    mesh m = make(0, few_most + 1, &s), none = {0};
    few f = {0};
    hit h;
    check(!few_build(&m, &f) && f.lanes == 0, "65 triangles are left to the tree");
    check(!few_build(&none, &f), "no triangles: nothing is built");
    check_equal(few_hit(&f, &m, ray_from(somewhere(&s), somewhere(&s)), few_skip_none, &h), -1,
                "nothing was built: ask the tree");
    mesh_free(&m);
    m = cornell_mesh();
    check(few_build(&m, &f), "the Cornell box is taken");
    check_equal(f.lanes, 24, "lanes: 18 pairs and two walls that are not flat, in eights");
    ray r = ray_from((vec3){278, 273, 100}, (vec3){0, 0, 1});
    r.tmin = -5;
    check_equal(few_hit(&f, &m, r, few_skip_none, &h), -1, "tmin < 0 is left to the tree");
    r.tmin = 0, r.o.x = (real)NAN;
    check_equal(few_hit(&f, &m, r, few_skip_none, &h), -1, "a NaN is left to the tree");
    r = ray_from((vec3){278, 273, 100}, (vec3){0, -1, 0});
    check(few_hit(&f, &m, r, few_skip_none, &h) == 1 && h.shape < 2, "the floor is met");
    few_skip k = few_skip_none;
    k.other = f.lane[h.shape];
    check_equal(few_hit(&f, &m, r, k, &h), 0, "but not if it is left out");
    few_free(&f), few_free(&f), mesh_free(&m);
}

/* A walk through the box: what a ray leaves is left out, and the answers stay the same. */
static void test_leaving(void)
{
    lit_scene s;
    random_stream at = random_start(24, 3, 1);
    size_t different = 0, shadows = 0;
    lit_cornell(&s);
    for (int i = 0; i < (int)check_count(4000); i++) {
        ray r = ray_from((vec3){278, 273, 10}, somewhere(&at));
        lit_hit h, x = {.m = NULL}, y = x;
        for (int k = 0; k < 5 && lit_trace(&s, r, &h); k++) {
            emitter_point e;
            point2 u = {random_next(&at), random_next(&at)};
            if (emitter_by_area(&s.emitter[0], h.s.p, u, &e) && vdot(h.s.n, e.wi) > 0) {
                ray b = leave_between(h.s, e.s);
                bool dark = bvh_mesh_occluded(&s.tree, b);
                shadows += dark;
                different += dark != lit_occluded(&s, b)
                    || dark != lit_occluded_from(&s, b, h.s.shape, 0);
            }
            r = leave(h.s, directed(h.s.n, sample_cosine(u.u, u.v)));
            bool met = lit_trace(&s, r, &x), again = lit_trace_from(&s, r, h.s.shape, &y);
            different += met != again || (met && (x.t != y.t || x.s.shape != y.s.shape));
        }
    }
    check_equal(different, 0, "with what they leave, and without: the same answers");
    check_at_least(shadows, check_count(4000) / 16, "rays in shadow: something to compare");
    lit_free(&s);
}

/* Sixteen triangles round one vertex: a ray through it has all lanes for candidates, none left over
 * to end the search. */
static void test_fan(void)
{
    enum { n = 16 };
    lit_scene s;
    lit_hit h;
    lit_begin(&s);
    uint16_t grey = lit_add_material(&s, (lit_material){.f = brdf_lambert((vec3){1, 1, 1})});
    for (int i = 0; i < n; i++) {
        real a = 2 * pi * (real)i / n, b = 2 * pi * (real)(i + 1) / n;
        triangle t = {{0, 0, 0}, {cos(a), sin(a), 0}, {cos(b), sin(b), 0}};
        lit_add_triangle(&s, t, grey);
    }
    lit_end(&s);
    check(lit_trace(&s, (ray){{0, 0, 5}, 0, {0, 0, -1}, real_infinity}, &h), "the vertex is met");
    check_equal(h.t, 5, "its distance");
    check_equal(h.s.shape, 0, "the first of all that share it");
    lit_free(&s);
}

int main(void)
{
    test_fan();
    test_same_as_tree();
    test_leaving();
    test_limits();
    return check_report("24_few");
}
