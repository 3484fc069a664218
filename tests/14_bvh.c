/* Every hit of the tree equals brute force: t, u, v and triangle, bit for bit, and so does
 * "occluded". Rays are aimed where boxes and triangles end: corners, edges, planes of faces,
 * axes. */
#include "../chapters/14_bvh/bvh_mesh.h"
#include "../chapters/14_bvh/bvh_shapes.h"
#include "../chapters/07_mesh/scenes/specimens.h"
#include "../chapters/07_mesh/scenes/teapot.h"
#include "aimed.h"
#include "check.h"

static bvh_options by_rule(int k, int leaf, double item_cost)
{
    return (bvh_options){bvh_rules[k].name, leaf, item_cost, SIZE_MAX};
}


typedef struct { size_t rays, hits, wrong, wrong_naive, wrong_any; } verdict;

/* The first ray whose answer is wrong, with all its digits: enough to ask it again. */
static void print_wrong(const char *what, ray r, bool expected, hit due, bool got, hit found)
{
    static size_t printed;
    if (printed++) return;
    printf("14_bvh: first wrong ray, %s: o %.17g %.17g %.17g,\n", what, (double)r.o.x,
           (double)r.o.y, (double)r.o.z);
    printf("    d %.17g %.17g %.17g, [%.17g, %.17g]\n", (double)r.d.x, (double)r.d.y, (double)r.d.z,
           (double)r.tmin, (double)r.tmax);
    if (expected) printf("    due: t %.17g, triangle %u;", (double)due.t, due.shape);
    else printf("    due: none;");
    if (got) printf(" the tree has: t %.17g, triangle %u\n", (double)found.t, found.shape);
    else printf(" the tree has: none\n");
}

/* Returns the hit of brute force, t = infinity on a miss. */
static hit compare(const mesh *m, const bvh_mesh *b, ray r, verdict *v)
{
    hit brute = hit_none, tree = hit_none, naive = hit_none;
    bool expected = mesh_hit(m, r, &brute), got = bvh_mesh_hit(b, r, &tree);
    bool got_naive = bvh_mesh_hit_naive(b, r, &naive), any = bvh_mesh_occluded(b, r);
    bool wrong = !same(expected, brute, got, tree);
    if (wrong) print_wrong("closest", r, expected, brute, got, tree);
    else if (any != expected) print_wrong("any", r, expected, brute, any, hit_none);
    v->rays++, v->hits += expected;
    v->wrong += wrong, v->wrong_any += any != expected;
    v->wrong_naive += !same(expected, brute, got_naive, naive);
    return brute;
}

static verdict compare_kinds(const mesh *m, const bvh_mesh *b, size_t n, uint64_t seed, vec3 centre,
                             real size)
{
    verdict v = {0, 0, 0, 0, 0};
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(seed, i, 0);
        ray r = aimed(m, &g, (int)(i % aimed_kinds), centre, size);
        hit h = compare(m, b, r, &v);
        if (h.shape == no_shape) continue;
        ray ends = r;
        ends.tmax = h.t;           /* the interval is closed: the hit stays */
        compare(m, b, ends, &v);
        ends.tmin = h.t;           /* [t, t] */
        compare(m, b, ends, &v);
    }
    return v;
}

static void test_mesh(const char *name, mesh m, vec3 move, real scale, bool exhibit)
{
    size_t naive = 0;
    for (size_t i = 0; i < m.vertices; i++) m.v[i] = vadd(vscale(m.v[i], scale), move);
    for (int s = 0; s < bvh_rule_count; s++)
        for (int leaf = 1; leaf <= 16; leaf *= 4) {
            bvh_mesh b;
            check(bvh_mesh_build(&m, by_rule(s, leaf, 1), &b, NULL), "built");
            verdict v = compare_kinds(&m, &b, check_count(720), (uint64_t)(s * 100 + leaf), move,
                                      scale);
            check_equal(v.wrong, 0, "%s, %s, leaves of %d: %zu of %zu rays hit; wrong", name,
                        bvh_rules[s].name, leaf, v.hits, v.rays);
            check_equal(v.wrong_any, 0, "%s, %s: occluded, yet no hit, or the reverse", name,
                        bvh_rules[s].name);
            check_at_least(v.hits, v.rays / 4, "%s: rays aimed at it hit it", name);
            naive += v.wrong_naive;
            bvh_mesh_free(&b);
        }
    check(naive > 0 || !exhibit,
          "%s: boxes rounded to nearest lose no hit: the exhibit shows nothing", name);
    mesh_free(&m);
}

/* t of some ten of the least numbers that there are: they have lost their digits, and an interval
 * that ends at a hit's t must hold the hit. */
static void test_least_t(void)
{
    mesh m = torus_mesh(24);
    bvh_mesh b;
    verdict v = {0, 0, 0, 0, 0};
    real size = real_is_float ? (real)0x1p-21 : (real)0x1p-50, most = real_largest / 16;
    for (size_t i = 0; i < m.vertices; i++) m.v[i] = vscale(m.v[i], size);
    check(bvh_mesh_build(&m, bvh_defaults, &b, NULL), "built");
    for (size_t i = 0; i < check_count(4000); i++) {
        random_stream g = random_start(61, i, 0);
        ray r = ray_from(random_in_cube(&g, 2 * size), vec(0, 0, 0));
        r.d = vscale(vsub(random_in_cube(&g, size), r.o), 1 / size), r.d = vscale(r.d, most);
        hit h = compare(&m, &b, r, &v);
        for (int way = 1; way < aimed_ways && h.shape != no_shape; way++)
            compare(&m, &b, aimed_way(r, h.t, way), &v);
    }
    check_equal(v.wrong + v.wrong_any, 0, "t below the normal numbers: wrong of %zu", v.rays);
    check_at_least(v.hits, v.rays / 5, "and some hit");
    bvh_mesh_free(&b), mesh_free(&m);
}

static void test_no_and_one(void)
{
    mesh m = mesh_room(1);
    ray r = ray_from(vec(0.25, 0.25, -1), (vec3){0, 0, 1});
    hit h = {7, 7, 7, 7};
    bvh_mesh b;
    m.triangles = 0;
    check(bvh_mesh_build(&m, bvh_defaults, &b, NULL), "built");
    check(!bvh_mesh_hit(&b, r, &h) && h.t == 7 && !bvh_mesh_occluded(&b, r),
          "no triangles are never hit");
    bvh_mesh_free(&b);
    m.triangles = 1;
    set_triangle(&m, 0, (vec3){0, 0, 1}, (vec3){1, 0, 1}, (vec3){0, 1, 1});
    for (int s = 0; s < bvh_rule_count; s++) {
        check(bvh_mesh_build(&m, by_rule(s, 1, 1), &b, NULL), "built");
        check(bvh_mesh_hit(&b, r, &h) && h.t == 2 && h.u == (real)0.25 && h.v == (real)0.25
                  && h.shape == 0,
              "one triangle, by %s: hit at t = 2", bvh_rules[s].name);
        check(b.tree.nodes == 2 && b.tree.depth == 0, "one triangle makes one leaf");
        bvh_mesh_free(&b);
    }
    bvh_mesh_free(&b);  /* again */
    mesh_free(&m);
}

/* Triangles on one place: the same t for all, so the lowest index must win, whatever the order of
 * the leaves. Every third one is a shifted copy in front; the lowest of those is number 2. */
static void test_coincident(size_t n)
{
    mesh m = mesh_room(n);
    ray r = ray_from(vec(0.25, 0.25, -1), (vec3){0, 0, 1});
    for (int front = 0; front < 2; front++) {
        for (size_t i = 0; i < n; i++) {
            real z = front && i % 3 == 2 ? 1 : 2;
            set_triangle(&m, i, (vec3){0, 0, z}, (vec3){1, 0, z}, (vec3){0, 1, z});
        }
        for (int s = 0; s < bvh_rule_count; s++) {
            bvh_mesh b;
            hit h = hit_none;
            if (n > 50000 && bvh_rules[s].split != split_binned) continue;  /* "spatial": 10 s */
            check(bvh_mesh_build(&m, by_rule(s, 2, 1), &b, NULL), "built");
            check(bvh_mesh_hit(&b, r, &h), "%zu coincident triangles are hit, %s", n,
                  bvh_rules[s].name);
            check_equal(h.shape, front ? 2 : 0, "lowest index of the nearest, %s",
                        bvh_rules[s].name);
            check(bvh_mesh_occluded(&b, r), "and occlude");
            /* A triangle fills half of its box, so "spatial" cuts: 8 references are 3 more. */
            check_at_most(b.tree.depth, log2_above(n) + (bvh_rules[s].through ? 4 : 1),
                          "halves of halves: depth log2(n), %s", bvh_rules[s].name);
            bvh_mesh_free(&b);
        }
    }
    mesh_free(&m);
}

/* Plates one behind another, a ray through all of them from either end: whoever looks at the nearer
 * box first, and ends the ray at each hit, asks the triangles of one leaf and no others. */
static void test_one_leaf(void)
{
    enum { plates = 500 };
    mesh m = mesh_room(plates);
    for (int i = 0; i < plates; i++) {
        real z = (real)i;
        set_triangle(&m, (size_t)i, vec(-0.3, -0.3, z), vec(0.3, -0.3, z), vec(0, 0.3, z));
    }
    for (int s = 0; s < bvh_rule_count; s++) {
        bvh_mesh b;
        check(bvh_mesh_build(&m, by_rule(s, 4, 1), &b, NULL), "built");
        for (int end = 0; end < 2; end++) {
            search_work w = {0, 0, 0, 0};
            hit h = hit_none;
            ray r = {vec(0.01, 0.02, end ? plates : -1), 0, {0, 0, end ? -1 : 1}, real_infinity};
            check(bvh_mesh_hit_counted(&b, r, &h, &w) && fabs(h.t - 1) < (real)0.5, "a hit");
            check_equal(w.leaves, 1, "leaves asked, of %d plates, %s, end %d", plates,
                        bvh_rules[s].name, end);
        }
        bvh_mesh_free(&b);
    }
    mesh_free(&m);
}

/* One triangle of eight is sick: NaN, infinite, a point, a line. None of them is hit, and the
 * others are found as if the sick ones were not there. */
static void test_sick(void)
{
    size_t n = 4000, sick = 0;
    mesh m = needles(n, 0.1), well = needles(n, 0.1);
    for (size_t i = 0; i < n; i += 8) {
        vec3 *v = m.v + 3 * i;
        switch (i / 8 % 6) {
        case 0: v[0].x = (real)NAN; break;
        case 1: v[1].y = real_infinity; break;
        case 2: v[2].z = -real_infinity; break;
        case 3: v[1] = v[2] = v[0]; break;
        case 4: v[2] = v[1]; break;
        default: v[0] = v[1] = v[2] = vec(NAN, NAN, NAN); break;
        }
        well.v[3 * i] = well.v[3 * i + 1] = well.v[3 * i + 2] = (vec3){0, 0, 0};
        sick++;
    }
    for (int s = 0; s < bvh_rule_count; s++) {
        bvh_mesh b, w;
        check(bvh_mesh_build(&m, by_rule(s, 4, 1), &b, NULL), "built");
        check(bvh_mesh_build(&well, by_rule(s, 4, 1), &w, NULL), "built");
        size_t fit = n - (sick + 5) / 6 - (sick + 4) / 6 - (sick + 3) / 6 - sick / 6;
        check(bvh_rules[s].through ? b.tree.items >= fit : b.tree.items == fit,
              "%zu of %zu triangles are finite, the others stay out, %s", fit, n,
              bvh_rules[s].name);
        check(
            vfinite(vec(b.tree.node[0].box.side[0], b.tree.node[0].box.side[3], 0)),
            "the root box is finite");
        verdict v = {0, 0, 0, 0, 0};
        size_t other = 0, hit_sick = 0;
        for (size_t i = 0; i < check_count(1500); i++) {
            random_stream g = random_start(5, i, 0);
            hit x = hit_none, y = hit_none;
            vec3 o = random_in_cube(&g, 3);
            ray r = ray_from(o, vsub(random_in_cube(&g, 1), o));
            compare(&m, &b, r, &v);
            bool gx = bvh_mesh_hit(&b, r, &x), gy = bvh_mesh_hit(&w, r, &y);
            other += !same(gx, x, gy, y), hit_sick += gx && x.shape % 8 == 0;
        }
        check_equal(v.wrong + v.wrong_any, 0, "sick triangles, %s: as brute force",
                    bvh_rules[s].name);
        check_equal(other, 0, "sick triangles, %s: as without them", bvh_rules[s].name);
        check_equal(hit_sick, 0, "sick triangles are not hit");
        check(v.hits > v.rays / 4, "enough rays hit something: %zu of %zu", v.hits, v.rays);
        bvh_mesh_free(&b), bvh_mesh_free(&w);
    }
    mesh_free(&m), mesh_free(&well);
}

/* Rays that are not rays: no hit, and no endless search. */
static void test_sick_rays(void)
{
    mesh m = teapot_mesh(3);
    bvh_mesh b;
    hit h;
    check(bvh_mesh_build(&m, bvh_defaults, &b, NULL), "built");
    for (size_t i = 0; i < sick_count; i++) {
        check(!mesh_hit(&m, sick_ray[i], &h), "brute force has no hit for sick ray %zu", i);
        check(!bvh_mesh_hit(&b, sick_ray[i], &h) && !bvh_mesh_occluded(&b, sick_ray[i]),
              "nor has the tree: sick ray %zu", i);
        search_work w = {0, 0, 0, 0};
        bvh_mesh_hit_counted(&b, sick_ray[i], &h, &w);
        check(w.nodes == 0 || i > 4, "what is no ray at all is not searched for: sick ray %zu", i);
    }
    bvh_mesh_free(&b);
    mesh_free(&m);
}

/* Triangles 2^k apart and 2^k large: a cut in the middle peels off one at a time. */
static void test_exponential(void)
{
    int most = real_is_float ? 100 : 900;
    size_t n = (size_t)most, rays = check_count(1500);
    mesh m = mesh_room(n);
    for (size_t i = 0; i < n; i++) {
        real x = ldexp((real)1, (int)i - most / 2);
        set_triangle(&m, i, (vec3){x, 0, 0}, (vec3){x, x / 8, 0}, (vec3){x, 0, x / 8});
    }
    for (int s = 0; s < bvh_rule_count; s++) {
        bvh_mesh b;
        size_t wrong = 0, hits = 0;
        check(bvh_mesh_build(&m, by_rule(s, 1, 1), &b, NULL), "built");
        check_at_most(b.tree.depth, bvh_most_depth, "depth of exponentially spaced triangles, %s",
                      bvh_rules[s].name);
        for (size_t i = 0; i < rays; i++) {
            random_stream g = random_start(6, i, 0);
            triangle t = mesh_triangle(&m, random_below(&g, n));
            vec3 o = {-t.a.x * random_next(&g), t.b.y * random_next(&g), t.b.y * random_next(&g)};
            vec3 at = vadd(t.a, vscale((vec3){0, random_next(&g), random_next(&g)}, t.b.y / 2));
            ray r = ray_from(o, vsub(at, o));
            hit x = hit_none, y = hit_none;
            bool gx = mesh_hit(&m, r, &x), gy = bvh_mesh_hit(&b, r, &y);
            hits += gx, wrong += !same(gx, x, gy, y) || (bvh_mesh_occluded(&b, r) != gx);
        }
        check_equal(wrong, 0, "exponentially spaced triangles, %s: %zu hits", bvh_rules[s].name,
                    hits);
        check(hits > rays / 4, "they are hit: %zu", hits);
        bvh_mesh_free(&b);
    }
    mesh_free(&m);
}

static void test_shapes(void)
{
    enum { n = 600 };
    shape *s = allocate(n, sizeof *s);
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(8, i, 0);
        vec3 a = random_in_cube(&g, 1), b = vadd(a, random_in_cube(&g, 0.2));
        real r = (real)0.1 * random_next(&g);
        switch (i % 3) {
        case 0: s[i] = shape_of_sphere((sphere){a, r}); break;
        case 1: s[i] = shape_of_cone((cone){a, r, b, r / 2}); break;
        default:
            s[i] = shape_of_triangle((triangle){a, b, vadd(a, random_in_cube(&g, 0.2))});
            break;
        }
        if (i % 100 == 99) s[i] = shape_of_sphere((sphere){{(real)NAN, 0, 0}, 1});
        if (i % 100 == 98) s[i] = s[i - 1];  /* a tie: the lower index wins */
    }
    scene all = {s, n};
    for (int k = 0; k < bvh_rule_count; k++) {
        bvh_shapes b;
        size_t wrong = 0, hits = 0, rays = check_count(10000);
        check(bvh_shapes_build(&all, by_rule(k, 4, 1), &b, NULL), "built");
        for (size_t i = 0; i < rays; i++) {
            random_stream g = random_start(9, i, 0);
            vec3 o = random_in_cube(&g, i % 2 ? 2 : 100);
            ray r = ray_from(o, vsub(random_in_cube(&g, 1), o));
            hit x = hit_none, y = hit_none;
            bool gx = scene_hit(&all, r, &x), gy = bvh_shapes_hit(&b, r, &y);
            hits += gx, wrong += !same(gx, x, gy, y) || (bvh_shapes_occluded(&b, r) != gx);
        }
        check_equal(wrong, 0, "spheres, cones, triangles, by %s: as brute force",
                    bvh_rules[k].name);
        check(hits > rays / 4, "they are hit: %zu of %zu", hits, rays);
        bvh_shapes_free(&b);
    }
    bvh_shapes none;
    hit h;
    check(bvh_shapes_build(&(scene){s, 0}, bvh_defaults, &none, NULL), "built");
    check(!bvh_shapes_hit(&none, ray_from((vec3){0, 0, 0}, (vec3){1, 0, 0}), &h),
          "no shapes are never hit");
    bvh_shapes_free(&none);
    free(s);
}

/* Rays that are not aimed: boxes rounded to nearest lose none, so such rays prove nothing. */
static void test_random_rays_show_nothing(void)
{
    mesh m = teapot_mesh(8);
    bvh_mesh b;
    size_t rays = check_count(300000), hits = 0, differ = 0;
    check(bvh_mesh_build(&m, bvh_defaults, &b, NULL), "built");
    for (size_t i = 0; i < rays; i++) {
        random_stream g = random_start(10, i, 0);
        hit x = hit_none, y = hit_none;
        vec3 o = random_in_cube(&g, 8);
        ray r = ray_from(o, vsub(random_in_cube(&g, 2), o));
        bool gx = bvh_mesh_hit(&b, r, &x), gy = bvh_mesh_hit_naive(&b, r, &y);
        hits += gx, differ += !same(gx, x, gy, y);
    }
    check(hits > rays / 4, "they hit: %zu of %zu", hits, rays);
    check_at_most(differ, rays / 100000, "naive boxes are wrong for random rays, in double never");
    bvh_mesh_free(&b);
    mesh_free(&m);
}

/* The nearer child first pays: in nodes and in tests, against always the first one. Were it the
 * farther one, it would cost more than that. */
static void test_order_in_counts(void)
{
    mesh m = torus_mesh(24);
    bvh_mesh b;
    search_work near = {0, 0, 0, 0}, stored = near;
    check(bvh_mesh_build(&m, bvh_defaults, &b, NULL), "built");
    for (size_t i = 0; i < check_count(8000); i++) {
        random_stream g = random_start(71, i, 0);
        vec3 o = random_in_cube(&g, 3);
        ray r = ray_from(o, vsub(random_in_cube(&g, 1), o));
        hit h;
        bvh_mesh_hit_counted(&b, r, &h, &near);
        tree_search_by(&b.tree, r, box_ray_of, bvh_mesh_leaf, &b, false, false, &h, &stored);
    }
    check_at_most((double)near.nodes, 0.95 * (double)stored.nodes, "nodes, the nearer first");
    check_at_most((double)near.tests, 0.9 * (double)stored.tests, "tests, the nearer first");
    bvh_mesh_free(&b), mesh_free(&m);
}

int main(void)
{
    real tiny = real_is_float ? (real)0x1p-60 : (real)0x1p-400;
    test_least_t();
    test_no_and_one();
    test_mesh("teapot", teapot_mesh(3), (vec3){0, 0, 0}, 1, true);
    test_mesh("octahedron", octahedron_mesh(8), (vec3){0, 0, 0}, 1,
              true); /* dyadic: ties, flat boxes */
    test_mesh("octahedron far out", octahedron_mesh(8), (vec3){1000000, -1000000, 1000000}, 1,
              true);
    test_mesh("torus, thirds", torus_mesh(16), vec(1 / (real)3, -1 / (real)7, 0.1),
              1 / (real)3, true);
    test_mesh("tiny teapot", teapot_mesh(2), (vec3){0, 0, 0}, tiny, false);
    test_mesh("huge teapot", teapot_mesh(2), (vec3){0, 0, 0}, 1 / tiny, false);
    test_mesh("needles 1e-3", needles(500, 1e-3), (vec3){0, 0, 0}, 1, true);
    test_mesh("needles 1e-6", needles(500, 1e-6), (vec3){0, 0, 0}, 1, true);
    test_coincident(check_count(1000000));
    test_coincident(check_count(30000));
    test_coincident(7);
    test_one_leaf();
    test_sick();
    test_sick_rays();
    test_exponential();
    test_shapes();
    test_random_rays_show_nothing();
    test_order_in_counts();
    return check_report("14_bvh");
}
