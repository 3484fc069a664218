/* Every hit of the tree equals brute force, bit for bit, by every rule; what boxes without care
 * lose; ties, and what a search must not look into. */
#include "../chapters/14_bvh/lab/naive.h"
#include "structure.h"

static bvh_options how;
STRUCTURE_TESTED(bvh, how)
static bool find_naive(const void *s, ray r, hit *out)
{
    return bvh_mesh_hit_naive(&((const bvh *)s)->mesh, r, out);
}

static bvh_options by_rule(int k, int leaf, double item_cost)
{
    return (bvh_options){bvh_rules[k].name, leaf, item_cost, SIZE_MAX};
}

static void test_rules(void)
{
    for (int k = 0; k < bvh_rule_count; k++)
        for (int leaf = 1; leaf <= 16; leaf *= 4) {
            char name[60];
            structure s = {name, STRUCTURE_OF(bvh)};
            snprintf(name, sizeof name, "%s, leaves of %d", bvh_rules[k].name, leaf);
            how = by_rule(k, leaf, 1);
            structure_brief(&s, check_count(360));
            if (!bvh_rules[k].by_cost || leaf != 4) continue;
            structure_meshes(&s, check_count(600)), structure_flat(&s, check_count(600));
            structure_none(&s), structure_exponential(&s, check_count(1200));
            structure_lengths(&s, check_count(1200));  /* no coordinate is too large */
        }
}

/* t of some ten of the least numbers that there are: they have lost their digits, and an interval
 * that ends at a hit's t must hold the hit. */
static ray towards_least_t(const items *x, random_stream *g, size_t i, const void *context)
{
    const real size = *(const real *)context;
    ray r = ray_from(random_in_cube(g, 2 * size), vec(0, 0, 0));
    (void)x, (void)i;
    r.d = vscale(vsub(random_in_cube(g, size), r.o), 1 / size);
    r.d = vscale(r.d, real_largest / 16);
    return r;
}

static void test_least_t(void)
{
    const structure s = {"sah", STRUCTURE_OF(bvh)};
    const real size = real_is_float ? (real)0x1p-21 : (real)0x1p-50;
    mesh m = torus_mesh(24);
    for (size_t i = 0; i < m.vertices; i++) m.v[i] = vscale(m.v[i], size);
    items x = items_of_mesh(&m);
    how = bvh_defaults;
    structure_attack(&s, "t below the normal numbers", &x, check_count(4000), 61, towards_least_t,
                     &size);
    mesh_free(&m);
}

/* Dyadic corners give ties and flat boxes; far out a float is coarse; needles have hits far off. */
static void test_hard_meshes(void)
{
    const real tiny = real_is_float ? (real)0x1p-60 : (real)0x1p-400, third = 1 / (real)3;
    const vec3 home = {0, 0, 0}, off = {1000000, -1000000, 1000000};
    const struct { const char *what; mesh m; vec3 move; real scale; bool exhibit; } list[] = {
        {"teapot", teapot_mesh(3), home, 1, true},
        {"octahedron", octahedron_mesh(8), home, 1, true},
        {"octahedron far out", octahedron_mesh(8), off, 1, true},
        {"torus, thirds", torus_mesh(16), {third, -1 / (real)7, (real)0.1}, third, true},
        {"tiny teapot", teapot_mesh(2), home, tiny, false},
        {"huge teapot", teapot_mesh(2), home, 1 / tiny, false},
        {"needles 1e-3", needles(500, 1e-3), home, 1, true},
        {"needles 1e-6", needles(500, 1e-6), home, 1, true}};
    structure s = {"sah", STRUCTURE_OF(bvh)};
    structure naive = {NULL, bvh_built, find_naive, bvh_any, bvh_gone, NULL};
    how = bvh_leaves(1, 0.3);
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        const structure_place place = {list[k].move, list[k].scale, 0};
        mesh m = list[k].m;
        for (size_t i = 0; i < m.vertices; i++)
            m.v[i] = vadd(vscale(m.v[i], place.scale), place.move);
        items x = items_of_mesh(&m);
        structure_attack(&s, list[k].what, &x, check_count(4800), 100, structure_aimed, &place);
        structure_verdict v = {0, 0, 0, 0};
        void *built = bvh_built(&x, NULL);
        for (size_t i = 0; i < check_count(4800); i++) {
            random_stream g = random_start(100, i, 0);
            structure_ray(&naive, built, &x, structure_aimed(&x, &g, i, &place), &v);
        }
        check(v.wrong > 0 || !list[k].exhibit,
              "%s: boxes rounded to nearest lose no hit: the exhibit shows nothing", list[k].what);
        bvh_gone(built);
        mesh_free(&m);
    }
}

/* n triangles on one place, the lowest index wins whatever the order of the leaves: halved by
 * number. A triangle fills half of its box, so "spatial" cuts: 8 references are 3 levels more. */
static void test_coincident(size_t n, bool all)
{
    mesh m = structure_copies(n, (vec3){0, 0, 2}, (vec3){1, 0, 2}, (vec3){0, 1, 2}, 1);
    ray r = ray_from(vec(0.25, 0.25, -1), (vec3){0, 0, 1});
    for (int s = 0; s < bvh_rule_count; s++) {
        bvh_mesh b;
        hit h = hit_none;
        if (!all && bvh_rules[s].split != split_binned) continue;  /* "spatial": 10 s */
        check(bvh_mesh_build(&m, by_rule(s, 2, 1), &b, NULL), "built");
        check(bvh_mesh_hit(&b, r, &h) && h.shape == 0 && bvh_mesh_occluded(&b, r),
              "%zu coincident triangles, %s: the first is hit", n, bvh_rules[s].name);
        check_at_most(b.tree.depth, log2_above(n) + (bvh_rules[s].through ? 4 : 1),
                      "halves of halves: depth log2(n), %s", bvh_rules[s].name);
        bvh_mesh_free(&b);
    }
    mesh_free(&m);
}

/* What is not finite stays out, and spoils no box; what is no ray at all is not searched for. */
static void test_sick(void)
{
    mesh m = needles(400, 0.1);
    bvh_mesh b;
    hit h;
    for (size_t i = 0; i < 400; i += 8)
        ((real *)&m.v[3 * i + i / 8 % 3])[i / 24 % 3] = i % 16 ? (real)NAN : -real_infinity;
    for (int s = 0; s < bvh_rule_count; s++) {
        check(bvh_mesh_build(&m, by_rule(s, 4, 1), &b, NULL), "built");
        check(bvh_rules[s].through ? b.tree.items >= 350 : b.tree.items == 350,
              "350 of 400 triangles are finite, %s: %zu", bvh_rules[s].name, b.tree.items);
        check(box_reach(b.tree.node, (vec3){0, 0, 0}) < 3, "the box of the others");
        for (size_t i = 0; i < sick_count; i++) {
            search_work w = {0, 0, 0, 0};
            check(!bvh_mesh_hit_counted(&b, sick_ray[i], &h, &w) && (w.nodes == 0 || i > 4),
                  "what is no ray is not searched for: sick ray %zu", i);
        }
        bvh_mesh_free(&b);
    }
    mesh_free(&m);
    bvh none;
    items nothing = items_of_scene(&(scene){NULL, 0});
    check(bvh_build(&nothing, bvh_defaults, &none, NULL)
              && !bvh_hit(&none, ray_from((vec3){0, 0, 0}, (vec3){1, 0, 0}), &h),
          "no shapes are never hit");
    bvh_free(&none);
}

/* The nearer child first, and a ray that ends at each hit: structure_plates. */
static void test_one_leaf(void)
{
    enum { plates = 500 };
    mesh m = structure_plates(plates);
    for (int s = 0; s < bvh_rule_count; s++) {
        bvh_mesh b;
        check(bvh_mesh_build(&m, by_rule(s, 4, 1), &b, NULL), "built");
        for (int end = 0; end < 2; end++) {
            search_work w = {0, 0, 0, 0};
            hit h = hit_none;
            check(bvh_mesh_hit_counted(&b, structure_through(plates, end), &h, &w)
                      && fabs(h.t - 1) < (real)0.5, "a hit");
            check_equal(w.leaves, 1, "leaves asked, of %d plates, %s, end %d", plates,
                        bvh_rules[s].name, end);
        }
        bvh_mesh_free(&b);
    }
    mesh_free(&m);
}

/* Rays that are not aimed: boxes rounded to nearest lose none, so such rays prove nothing. */
static void test_random_rays_show_nothing(void)
{
    mesh m = teapot_mesh(6);
    bvh_mesh b;
    size_t rays = check_count(150000), hits = 0, differ = 0;
    check(bvh_mesh_build(&m, bvh_defaults, &b, NULL), "built");
    for (size_t i = 0; i < rays; i++) {
        ray r = structure_across(10, i, 8, 2);
        hit x = hit_none, y = hit_none;
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
        ray r = structure_across(71, i, 3, 1);
        hit h;
        bvh_mesh_hit_counted(&b, r, &h, &near);
        tree_search_by(&b.tree, r, box_ray_of, bvh_mesh_leaf, &b, false, false, &h, &stored);
    }
    check(near.nodes > 0, "nodes are counted");
    check_at_most((double)near.nodes, 0.95 * (double)stored.nodes, "nodes, the nearer first");
    check_at_most((double)near.tests, 0.9 * (double)stored.tests, "tests, the nearer first");
    bvh_mesh_free(&b), mesh_free(&m);
}

int main(void)
{
    test_coincident(check_count(1000000), false);
    test_coincident(check_count(30000), true);
    test_coincident(7, true);
    return check_all("14_bvh", test_least_t, test_rules, test_hard_meshes, test_one_leaf, test_sick,
                     test_random_rays_show_nothing, test_order_in_counts);
}
