/* BSP trees: the answers of brute force by every rule, for every ray; sides of planes against twice
 * the precision; areas of cells; limits; and the naive variants, which must go on failing. */
#include "../chapters/13_bsp/lab/naive.h"
#include "structure.h"

static const char *const rule_name[bsp_rules] = {"random", "fewest", "axis", "own", "cost"};

/* ---- the tests that all structures share ---- */

static bsp_options how_now;
STRUCTURE_TESTED(bsp, how_now)

static bool find_naive(const void *b, ray r, hit *out) { return bsp_hit_naive(b, r, out); }
static bool find_first(const void *b, ray r, hit *out) { return bsp_hit_first(b, r, out); }

static void test_rules(void)
{
    for (int k = 0; k < bsp_rules; k++) {
        structure s = {rule_name[k], STRUCTURE_OF(bsp)};
        how_now = bsp_defaults;
        how_now.rule = (bsp_rule)k;
        if (k == BSP_COST) structure_tests(&s, check_count(600));
        else structure_brief(&s, check_count(240));
    }
}

/* Small leaves and deep cuts: many planes between an item and its leaf. And subnormal coordinates:
 * 1 / size is infinite. */
static void test_deep(void)
{
    structure deep = {"cost, deep", STRUCTURE_OF(bsp)}, own = {"own", STRUCTURE_OF(bsp)};
    structure tiny = {"cost, subnormal", STRUCTURE_OF(bsp)};
    how_now = bsp_defaults;
    how_now.axis_cost = how_now.slanted_cost = 0.01;
    structure_mesh(&deep, "torus, moved", torus_mesh(16), check_count(600),
                   (vec3){1000, -2000, 3000}, 1, 0);
    structure_mesh(&deep, "planes", floors_mesh(4), check_count(600), (vec3){0, 0, 0}, 1, 0);
    structure_mesh(&deep, "needles", needles(100, 1e-3), check_count(600), (vec3){0, 0, 0}, 1, 0);
    how_now.rule = BSP_OWN;
    structure_mesh(&own, "needles", needles(100, 1e-7), check_count(600), (vec3){0, 0, 0}, 1, 0);
    how_now = bsp_defaults;
    how_now.most_bytes = (size_t)1 << 22;
    structure_mesh(&tiny, "torus", torus_mesh(12), check_count(240), (vec3){0, 0, 0},
                   real_smallest / 1024, 0);
}

/* ---- naive ---- */

typedef bool search(const void *b, ray r, hit *out);

static size_t wrong_of(search *find, mesh m, real size, size_t rays)
{
    items x = items_of_mesh(&m);
    structure s = {NULL, bsp_built, find, bsp_any, bsp_gone, NULL};
    structure_verdict v = {0, 0, 0, 0};
    void *built = bsp_built(&x, NULL);
    for (size_t i = 0; i < rays; i++) {
        random_stream g = random_start(31, i, 0);
        ray r = aimed(&m, &g, (int)(i % aimed_kinds), (vec3){0, 0, 0}, size);
        structure_compare(&s, built, &x, r, &v);
    }
    bsp_gone(built);
    mesh_free(&m);
    return v.wrong;
}

static mesh scaled(mesh m, real k)
{
    for (size_t i = 0; i < m.vertices; i++) m.v[i] = vscale(m.v[i], k);
    return m;
}

static void test_naive(void)
{
    size_t n = check_count(2400);
    how_now = bsp_defaults;
    how_now.axis_cost = how_now.slanted_cost = 0.5;  /* many planes */
    check_at_least(wrong_of(find_naive, floors_mesh(4), 1, n), n / 100,
                   "planes without padding lose hits on planes, of %zu rays", n);
    check_at_least(wrong_of(find_first, needles(300, 0.1), 1, n), n / 100,
                   "the first leaf's hit is not always the closest, of %zu rays", n);
    for (int k = 0; k < bsp_rules; k++) {
        how_now.rule = (bsp_rule)k;
        how_now.sides = BSP_SIDES_SAFE;
        check_equal(wrong_of(bsp_finds, floors_mesh(4), 1, n), 0, "%s: and with care, none",
                    rule_name[k]);
        how_now.sides = BSP_SIDES_STRICT;
        check_at_least(wrong_of(bsp_finds, floors_mesh(4), 1, n), n / 100,
                       "%s, strict: coplanar triangles get lost, of %zu rays", rule_name[k], n);
    }
    how_now = bsp_defaults;
    how_now.sides = BSP_SIDES_FIXED;
    check_at_least(wrong_of(bsp_finds, scaled(torus_mesh(16), 1e-3), 1e-3, n), n / 100,
                   "a fixed width loses what is small, of %zu rays", n);
    how_now.sides = BSP_SIDES_SAFE;
    check_equal(wrong_of(bsp_finds, scaled(torus_mesh(16), 1e-3), 1e-3, n), 0,
                "the width of side.h loses nothing of it");
}

/* ---- side.h ---- */

static wide side_exactly(split_plane p, vec3 q)
{
    return wide_sub(wide3_dot(wide3_of(p.n), wide3_of(q)), wide_of((double)p.at));
}

/* A needle 1 long and 1e-7 wide: plain products are off by eps, n by eps / 1e-7, and the corners
 * lie up to 1e-7 off their own plane. */
static split_plane plane_by_products(vec3 a, vec3 b, vec3 c)
{
    vec3 n = vunit(vcross(vsub(b, a), vsub(c, a)));
    return (split_plane){n, vdot(n, a), 3};
}

/* (13.7): computed s against the s of the very same numbers; 4.4 eps size without what moved q. */
static void test_sides(void)
{
    double worst = 0, own = 0, naive = 0;
    for (size_t i = 0; i < check_count(200000); i++) {
        random_stream g = random_start(13, i, 0);
        vec3 a = random_in_cube(&g, 1), b = random_in_cube(&g, 1), q = random_in_cube(&g, 1);
        vec3 c = random_in_cube(&g, 1e-7);
        c = vadd(vmadd(a, vsub(b, a), random_next(&g)), c);
        c = vmax((vec3){-1, -1, -1}, vmin((vec3){1, 1, 1}, c));
        split_plane p = plane_of_triangle(a, b, c), w = plane_by_products(a, b, c);
        if (vzero(p.n)) continue;
        wide error = wide_sub(wide_of((double)side_of(&p, q)), side_exactly(p, q));
        worst = check_worse(worst, fabs(wide_value(error)));
        const vec3 corner[3] = {a, b, c};
        for (int k = 0; k < 3; k++) {
            own = check_worse(own, fabs(wide_value(side_exactly(p, corner[k]))));
            naive = fmax(naive, fabs(wide_value(side_exactly(w, corner[k]))));
        }
    }
    double eps = (double)real_epsilon;
    check_at_most(worst, 4.4 * eps, "s is within 4.4 eps size of the exact one");
    check_at_most(own, 6 * eps, "a needle's corners are on its own plane");
    check_at_least(naive, 1000 * eps, "plain products put them off it");
}

/* What clip leaves holds what belongs there: random points of a triangle, cut 64 times. */
static void test_clip(void)
{
    double worst = 0;
    size_t lost = 0, kept = 0;
    for (size_t i = 0; i < check_count(3000); i++) {
        random_stream g = random_start(17, i, 0);
        vec3 q[2][200], x[20];
        size_t n = 3, at = 0;
        bool in[20];
        for (int k = 0; k < 3; k++) q[0][k] = random_in_cube(&g, 1);
        split_plane face = plane_of_triangle(q[0][0], q[0][1], q[0][2]);
        for (int k = 0; k < 20; k++) {
            real u = random_next(&g), v = random_next(&g) * (1 - u);
            x[k] = vmadd(vmadd(q[0][0], vsub(q[0][1], q[0][0]), u), vsub(q[0][2], q[0][0]), v);
            in[k] = true;
        }
        for (int cut = 0; cut < 64 && n; cut++) {  /* near x[0], which stays */
            split_plane p = {vunit(random_in_cube(&g, 1)), 0, 3};
            p.at = vdot(p.n, x[0]) + random_next(&g) * (real)0.3;
            for (int k = 0; k < 20; k++) in[k] = in[k] && wide_sign(side_exactly(p, x[k])) <= 0;
            n = clip(&p, 1, side_width, q[at], n, q[1 - at]);
            at = 1 - at;
        }
        for (size_t k = 0; k < n; k++)
            worst = check_worse(worst, fabs(wide_value(side_exactly(face, q[at][k]))));
        for (int k = 0; k < 20; k++) {  /* beyond no edge of the polygon by more than r */
            if (!in[k]) continue;
            bool inside = n > 0;
            for (size_t j = 0; j < n && inside; j++) {
                vec3 a = q[at][j], e = vsub(q[at][(j + 1) % n], a);
                real off = vdot(vcross(e, vsub(x[k], a)), face.n);
                inside = off >= -167 * real_epsilon * vlength(e);
            }
            lost += !inside, kept++;
        }
    }
    check_equal(lost, 0, "of %zu points of triangles, what is cut off", kept);
    check_at_most(worst, 170 * (double)real_epsilon, "cut 64 times, corners stay in the plane");
    check_at_least((double)side_width, (64 * 2.6 + 2 * 6) * (double)real_epsilon,
                   "(13.8), of 64 cuts");
}

/* ---- cell.h ---- */

static void test_cells(void)
{
    cell_store s = {0};
    real back, front, eps = real_epsilon;
    convex c = cell_box(&s, (vec3){1, 1, 1});
    check_equal(c.faces, 6, "faces of a box");
    check_equal(cell_area(&s, c), 24, "surface of a cube of 2");
    split_plane x = plane_of_axis(0, 0.5), d = {vunit((vec3){1, 1, 1}), 0, 3};
    cell_areas(&s, c, &x, &back, &front);
    check_equal(back, 8 + 4 * 3, "box of 1.5 x 2 x 2");
    check_equal(front, 8 + 4 * 1, "box of 0.5 x 2 x 2");
    cell_areas(&s, c, &d, &back, &front);  /* a regular hexagon with sides of sqrt 2 */
    check_close(back, 12 + 3 * sqrt(3.0), 50 * eps, "half a cube and a hexagon");
    check_close(front, 12 + 3 * sqrt(3.0), 50 * eps, "the other half");
    convex h = cell_cut(&s, c, &d, 1);
    check_equal(h.faces, 7, "faces of half a cube");
    check_close(cell_area(&s, h), 12 + 3 * sqrt(3.0), 50 * eps, "made, not only measured");

    double worst = 0;
    for (size_t i = 0; i < check_count(500); i++) {
        size_t corners = s.corners, faces = s.faces;
        random_stream g = random_start(3, i, 0);
        vec3 inside = random_in_cube(&g, 1);
        convex whole = c;
        for (int k = 0; k < 12; k++) {
            split_plane p = {vunit(random_in_cube(&g, 1)), 0, 3};
            p.at = vdot(p.n, inside) + random_next(&g) * (real)0.2 + (real)0.1;
            cell_areas(&s, whole, &p, &back, &front);
            convex part = cell_cut(&s, whole, &p, 1), rest = cell_cut(&s, whole, &p, -1);
            worst = check_worse(worst, fabs((double)(cell_area(&s, part) - back)));
            if (rest.faces) worst = check_worse(worst, fabs((double)(cell_area(&s, rest) - front)));
            whole = part;
        }
        vec3 sum = {0, 0, 0};  /* closed: the areas as vectors add up to nothing */
        for (uint32_t k = 0; k < whole.faces; k++) {
            const cell_face *f = &s.face[whole.face + k];
            sum = vadd(sum, polygon_area(s.corner + f->corner, f->corners));
        }
        worst = check_worse(worst, (double)vlength(sum));
        s.corners = corners, s.faces = faces;
    }
    check_at_most(worst, 1000 * (double)eps, "areas as measured, as made, and of a closed surface");
    cells_free(&s);
}

/* ---- limits, and what the tree says about itself ---- */

static void test_refused(void)
{
    bsp_options how[] = {bsp_defaults, bsp_defaults, bsp_defaults, bsp_defaults, bsp_defaults,
                         bsp_defaults, bsp_defaults, bsp_defaults};
    how[0].depth = -1, how[1].depth = bsp_most_depth + 1, how[2].leaf = 0;
    how[3].candidates = 0, how[4].candidates = 10001;
    how[5].axis_cost = -1, how[6].slanted_cost = (double)NAN, how[7].axis_cost = (double)NAN;
    mesh m = octahedron_mesh(2);
    items x = items_of_mesh(&m);
    for (size_t i = 0; i < sizeof how / sizeof *how; i++) {
        bsp b;
        failure f;
        check(!bsp_build(&x, how[i], &b, &f) && f.exit_code == 2 && strstr(f.text, "allowed"),
              "options out of range, %zu: refused", i);
        bsp_free(&b);
    }
    how[0] = how[1] = bsp_defaults;
    how[0].candidates = 1, how[0].axis_cost = how[0].slanted_cost = 0, how[1].candidates = 10000;
    for (size_t i = 0; i < 2; i++) {
        bsp b = bsp_made(&x, how[i]);
        bsp_free(&b);
    }
    mesh_free(&m);
}

static void test_limits(void)
{
    mesh m = teapot_mesh(6);
    items x = items_of_mesh(&m);
    bsp_options how = bsp_defaults;
    for (int depth = 0; depth <= 8; depth += 4) {
        how = bsp_defaults;
        how.depth = depth;
        bsp b = bsp_made(&x, how);
        structure_stats s = bsp_stats(&b);
        check_equal(s.depth, depth, "no leaf is deeper than it may be, and some are as deep");
        check_equal(s.leaves, s.inner + 1, "each plane makes one cell more");
        check(s.references >= s.items && s.items == m.triangles, "all triangles are in leaves");
        check(s.peak >= s.bytes && s.bytes > 0, "memory");
        bsp_free(&b);
    }
    mesh_free(&m);
}

/* Copies of one triangle: all lie on their own plane, and none through an edge parts them. Tiles in
 * a row, in one plane: that one used up, planes through edges part them all. */
static void test_in_one_plane(void)
{
    mesh copies = mesh_room(8), tiles = mesh_room(8);
    for (size_t i = 0; i < 8; i++) {
        real at = 2 * (real)i;
        set_triangle(&copies, i, vec(0, 0, 0), vec(1, 0, 0.5), vec(0, 1, 0.25));
        set_triangle(&tiles, i, (vec3){at, 0, 0}, (vec3){at + 1, 0, 0}, (vec3){at, 1, 0});
    }
    items x = items_of_mesh(&copies), y = items_of_mesh(&tiles);
    for (int k = 0; k < 2; k++) {
        bsp_options how = bsp_defaults;
        how.rule = k ? BSP_FEWEST : BSP_RANDOM, how.leaf = 1, how.candidates = 100;
        bsp a = bsp_made(&x, how), b = bsp_made(&y, how);
        structure_stats s = bsp_stats(&b);
        check_equal(bsp_stats(&a).inner, 1, "%s: one plane, as no other parts copies",
                    rule_name[how.rule]);
        check(s.references == 8 && s.leaves - s.empty == 8, "%s: each tile is alone, and whole",
              rule_name[how.rule]);
        bsp_free(&a), bsp_free(&b), bsp_free(&b);
    }
    mesh_free(&copies), mesh_free(&tiles);
}

/* 16 triangles in one plane, across 8 that stand each in its own: the one cuts 8, the others 16. */
static void test_fewest(void)
{
    mesh m = mesh_room(24);
    for (size_t i = 0; i < 24; i++) {
        real k = (real)i, x = (real)0.1 * (k - 20);
        if (i < 16) set_triangle(&m, i, (vec3){-4, -4, 0}, (vec3){4, -4, 0}, (vec3){0, k + 4, 0});
        else set_triangle(&m, i, (vec3){x, -1, -1}, (vec3){x, 1, -1}, (vec3){x, 0, 1});
    }
    items x = items_of_mesh(&m);
    for (uint64_t seed = 0; seed < 20; seed++) {
        bsp_options how = bsp_defaults;
        how.rule = BSP_FEWEST, how.depth = how.leaf = 1, how.candidates = 64, how.seed = seed;
        bsp b = bsp_made(&x, how);
        check_equal(b.cuts, 8, "the plane that cuts least");
        bsp_free(&b);
    }
    mesh_free(&m);
}

/* Parallel triangles, none of which cuts another: the fewest are cut in the middle; a cell of as
 * many as a leaf may hold is none. */
static void test_even(void)
{
    enum { sheets = 15 };
    mesh m = mesh_room(sheets);
    for (size_t i = 0; i < sheets; i++) {
        real x = (real)i;
        set_triangle(&m, i, (vec3){x, -1, -1}, (vec3){x, 1, -1}, (vec3){x, 0, 1});
    }
    items x = items_of_mesh(&m);
    for (uint64_t seed = 0; seed < 20; seed++) {
        bsp_options how = bsp_defaults;
        how.rule = BSP_FEWEST, how.leaf = 1, how.candidates = 256, how.seed = seed;
        bsp b = bsp_made(&x, how);
        check_at_most(b.stats.depth, 4, "15 sheets, halved");
        bsp_free(&b);
        how.leaf = sheets, b = bsp_made(&x, how);
        check_equal(b.stats.depth, 0, "a leaf of 15");
        bsp_free(&b);
    }
    mesh_free(&m);
}

/* Planes right on a surface keep little empty space before it. */
static void test_slanted(void)
{
    mesh m = torus_mesh(24);
    items x = items_of_mesh(&m);
    size_t work[2];
    for (int k = 0; k < 2; k++) {
        bsp_options how = bsp_defaults;
        search_work w = {0, 0, 0, 0};
        how.rule = k ? BSP_AXIS : BSP_COST;
        bsp b = bsp_made(&x, how);
        for (size_t i = 0; i < check_count(2000); i++) {
            hit h;
            bsp_hit_counted(&b, structure_across(4, i, 3, 1), &h, &w);
        }
        work[k] = w.nodes + w.tests;
        bsp_free(&b);
    }
    check_at_most(10 * work[0], 9 * work[1], "a torus costs less with slanted planes");
    mesh_free(&m);
}

/* What lies in a plane goes to the smaller part, (13.4): a wall of 128 triangles at x = 1/2 in a
 * cube of side 2, and rays that stay at x < 1/4: none of them is tested against the wall. */
static void test_wall_goes_to_the_smaller_part(void)
{
    enum { n = 8, walls = 2 * n * n };
    mesh m = mesh_room(walls + 2);
    for (int i = 0; i < walls; i++) {
        real y = (real)(i / 2 % n) / 4 - 1, z = (real)(i / 2 / n) / 4 - 1, s = (real)0.25;
        vec3 q[4] = {{(real)0.5, y, z}, {(real)0.5, y + s, z}, {(real)0.5, y + s, z + s},
                     {(real)0.5, y, z + s}};
        set_triangle(&m, (size_t)i, q[0], q[1 + i % 2], q[2 + i % 2]);
    }
    for (int k = 0; k < 2; k++) {
        real x = k ? 1 : -1;
        set_triangle(&m, walls + (size_t)k, vec(x, -1, -1), vec(x, -1, 1), vec(x, 1, 0));
    }
    items x = items_of_mesh(&m);
    bsp b = bsp_made(&x, bsp_defaults);
    search_work work = {0, 0, 0, 0};
    size_t rays = check_count(2000);
    for (size_t i = 0; i < rays; i++) {
        random_stream g = random_start(16, i, 0);
        vec3 o = random_in_cube(&g, (real)0.9), to = random_in_cube(&g, 9);
        o.x = (real)0.5 - (real)0.25 - fabs(o.x), to.x = 0;
        hit h;
        bsp_hit_counted(&b, ray_from(o, to), &h, &work);
    }
    check_at_most(work.tests, rays, "tests of %zu rays beside the wall", rays);
    bsp_free(&b), mesh_free(&m);
}

/* What a ray must have to spare, in eps D: bsp.h has the sum. Of its first term, a hit 256 off its
 * item, climbing has met 51: no ray sees the rest. And half the box must not be rounded down. */
static void test_owed(void)
{
    const bsp b = {.all = {{-1, -1, -1}, {1, 1, 1}}, .half = {1, 1, 1}};
    const real owed = 4 * real_epsilon;  /* D = 4 */
    bsp_ray s;
    check(bsp_ray_of(&b, ray_from((vec3){0, 0, -3}, (vec3){0, 0, 1}), 2, &s), "through the box");
    check_at_least(s.pad, (443 + 358 + 25) * owed, "planes");
    check_at_most(s.t0, 2 - (256 + 3) * owed, "the box is entered so much too early");
    check_at_least(s.t1, 4 + (256 + 3) * owed, "and left so much too late");
    size_t outside = 0;
    for (size_t i = 0; i < check_count(8000); i++) {
        random_stream g = random_start(17, i, 0);
        vec3 p = random_in_cube(&g, 1), q = random_in_cube(&g, 1);
        p = vscale(p, (real)0.3), q = vscale(q, (real)0.3);  /* with all their digits */
        bsp t = {.all = {vmin(p, q), vmax(p, q)}};
        workshop w = {.sides = BSP_SIDES_SAFE};
        bsp_frame(&t, &w);
        wide above = wide_sum((double)t.all.hi.x, -(double)t.middle.x);
        wide below = wide_sum((double)t.middle.x, -(double)t.all.lo.x);
        outside += wide_sign(wide_sub(wide_of((double)t.half.x), above)) < 0;
        outside += wide_sign(wide_sub(wide_of((double)t.half.x), below)) < 0;
    }
    check_equal(outside, 0, "half the box, in all digits");
}

/* Of the plane x = v in a box 1 x 2 across: half the area of each part times what reaches in. */
static double swept_cost(const axis_sweep *s, double a, double b, double v)
{
    size_t before = 0, behind = 0;
    const real x = (real)v;  /* whole: the same */
    for (size_t i = 0; i < s->n; i++) before += s->lo[0][i] < x, behind += s->hi[0][i] > x;
    return (2 + 3 * (v - a)) * (double)before + (2 + 3 * (b - v)) * (double)behind;
}

/* All places, whole numbers, are tried: the sweep has found one of the cheapest. */
static void test_sweep(void)
{
    size_t dearer = 0, found = 0;
    for (size_t k = 0; k < 500; k++) {
        random_stream g = random_start(19, k, 0);
        axis_sweep s = {.n = 1 + k % 4};
        for (size_t i = 0; i < s.n; i++) {
            s.lo[0][i] = (real)(1 + random_below(&g, 11));
            s.hi[0][i] = s.lo[0][i] + (real)random_below(&g, 5);
        }
        sort_reals(s.lo[0], s.n), sort_reals(s.hi[0], s.n);
        double least = INFINITY;
        real at = 0;
        for (int v = 1; v < 16; v++) least = fmin(least, swept_cost(&s, 0, 16, v));
        if (!sweep_axis(&s, 0, vec(0, 5, -7), vec(16, 6, -5), &at)) continue;
        found++, dearer += swept_cost(&s, 0, 16, (double)at) > least;
    }
    check_equal(dearer, 0, "places dearer than the cheapest");
    check_equal(found, 500, "places found");
}

int main(void)
{
    structure_ends(bsp, bsp_defaults, check_count(2000));
    structure_limited(bsp, bsp_defaults, teapot_mesh(6), 2);
    structure_piled(bsp, bsp_defaults, 3000, 1.05 * structure_room(3000));
    return check_all("13_bsp", test_wall_goes_to_the_smaller_part, test_sides, test_clip, test_owed,
                     test_cells, test_refused, test_limits, test_in_one_plane, test_fewest,
                     test_even, test_slanted, test_naive, test_deep, test_rules, test_sweep);
}
