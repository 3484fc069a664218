/* The two builders that are not cuts between items: Morton codes (morton.h) and cuts through items
 * (spatial.h). Codes and topology by an independent definition; parts of triangles cover them.
 * And trees that are kept while the mesh moves (refit.h). */
#include "../chapters/14_bvh/bvh_mesh.h"
#include "../chapters/07_mesh/scenes/motion.h"
#include "../chapters/09_aabb/trials/aimed.h"
#include "../chapters/14_bvh/trials/refit.h"
#include "../chapters/07_mesh/scenes/soup.h"
#include "../chapters/07_mesh/scenes/teapot.h"
#include "../common/random.h"
#include "bvh_inspect.h"
#include "check.h"
#include "wrong_ray.h"

/* n triangles (狭长三角形), 4 long and 2 pi / n wide, round an axis at an odd angle, at distance 1:
 * each fills next to nothing of its box. */
static mesh slivers_mesh(size_t n, vec3 move)
{
    mesh m = mesh_room(n);
    vec3 w = vunit(vec(1, 0.8, 0.6)), u, v;
    vbasis(w, &u, &v);
    for (size_t i = 0; i < n; i++) {
        real a = 2 * pi * (real)i / (real)n, b = 2 * pi * (real)(i + 1) / (real)n;
        m.v[3 * i] = vadd(move, vadd(vscale(u, cos(a)), vscale(v, sin(a))));
        m.v[3 * i + 1] = vadd(move, vadd(vscale(u, cos(b)), vscale(v, sin(b))));
        m.v[3 * i + 2] = vmadd(m.v[3 * i], w, 4);
    }
    return m;
}

/* Bit by bit, as (14.9) says. */
static uint64_t code_by_definition(uint32_t x, uint32_t y, uint32_t z)
{
    uint64_t code = 0;
    for (int bit = 20; bit >= 0; bit--) {
        code = code << 1 | (x >> bit & 1);
        code = code << 1 | (y >> bit & 1);
        code = code << 1 | (z >> bit & 1);
    }
    return code;
}

static void test_codes(void)
{
    size_t wrong = 0;
    for (size_t i = 0; i < check_count(100000); i++) {
        uint64_t r = random_bits(1, i, 0, 0);
        uint32_t x = r & 0x1fffff, y = r >> 21 & 0x1fffff, z = r >> 42 & 0x1fffff;
        if (i < 63) x = (uint32_t)(i < 21) << i % 21, y = (uint32_t)(i / 21 == 1) << i % 21,
                    z = (uint32_t)(i > 41) << i % 21;
        wrong += morton_code(x, y, z) != code_by_definition(x, y, z);
    }
    check_equal(wrong, 0, "Morton codes, bit by bit");
}

/* The cut by trying all places: before it all codes share one bit more with the first. */
static void test_cut(void)
{
    size_t wrong = 0;
    for (size_t i = 0; i < check_count(20000); i++) {
        random_stream g = random_start(3, i, 0);
        radix_code p[40];
        size_t n = 2 + (size_t)(random_next_bits(&g) % 39);
        int bits = 1 + (int)(random_next_bits(&g) % 63);
        uint64_t code = random_next_bits(&g) >> 1 & ~(((uint64_t)1 << bits) - 1);
        for (size_t k = 0; k < n; k++) {
            uint64_t x = random_next_bits(&g) & (((uint64_t)1 << bits) - 1);
            p[k].key = code | (i % 3 ? x : x & 3);
            for (size_t j = k; j > 0 && p[j - 1].key > p[j].key; j--) {
                radix_code swap = p[j];
                p[j] = p[j - 1], p[j - 1] = swap;
            }
        }
        size_t cut = morton_cut(p, 0, n), expected = n / 2;
        for (int bit = 62; bit >= 0 && p[0].key != p[n - 1].key; bit--) {
            if ((p[0].key >> bit & 1) == (p[n - 1].key >> bit & 1)) continue;
            for (expected = 0; (p[expected].key >> bit & 1) == 0; ) expected++;
            break;
        }
        wrong += cut != expected || cut == 0 || cut == n;
    }
    check_equal(wrong, 0, "cut where the highest bit changes; equal codes in the middle");
}

/* What is below each inner node shares its first bits, and the next one parts left from right. */
static void topology(const bvh_mesh *b, size_t at, const uint64_t *code, uint64_t *all,
                     uint64_t *any, size_t *wrong)
{
    const bvh_node *n = &b->tree.node[at];
    *all = ~(uint64_t)0, *any = 0;
    for (size_t i = n->first; i < n->first + n->count; i++)
        *all &= code[b->triangle[i].index], *any |= code[b->triangle[i].index];
    if (n->count) return;
    uint64_t all1, any1;
    topology(b, n->first, code, all, any, wrong);
    topology(b, n->first + 1, code, &all1, &any1, wrong);
    uint64_t differ = (*any | any1) & ~(*all & all1), top = differ;
    while (top & (top - 1)) top &= top - 1;
    *wrong += differ != 0 && ((*any & top) != 0 || (all1 & top) == 0);
    *all &= all1, *any |= any1;
}

static void test_topology(void)
{
    mesh m = teapot_mesh(12);
    vec3 lo, hi;
    bvh_item *item = allocate(m.triangles, sizeof *item);
    radix_code *pair = allocate(m.triangles, sizeof *pair);
    uint64_t *code = allocate(m.triangles, sizeof *code), all, any;
    size_t wrong = 0, off = 0;
    for (size_t i = 0; i < m.triangles; i++) triangle_item(&m, i, &item[i]);
    morton_codes(item, m.triangles, pair);
    /* Cells as they are meant: the longest side of the box of the centres / 2^21, from its corner.
     * In double; a centre in float is off by 2^-24 of 3.5, and so is its distance: 4 cells. */
    lo = (vec3){9, 9, 9}, hi = vneg(lo);
    for (size_t i = 0; i < m.triangles; i++) {
        vec3 c = {(real)item_centre(&item[i], 0), (real)item_centre(&item[i], 1),
                  (real)item_centre(&item[i], 2)};
        lo = vmin(c, lo), hi = vmax(c, hi);
    }
    double cell = (double)vaxis(vsub(hi, lo), vlongest(vsub(hi, lo))) / 2097151;
    for (size_t i = 0; i < m.triangles; i++) {
        code[i] = pair[i].key;
        for (int k = 0; k < 3; k++) {
            uint32_t x = 0;
            for (int bit = 0; bit < 21; bit++)
                x |= (uint32_t)(code[i] >> (3 * bit + 2 - k) & 1) << bit;
            double c = ((double)item_centre(&item[i], k) - (double)vaxis(lo, k)) / cell;
            off += fabs((double)x - c) > 4;
        }
    }
    check_equal(off, 0, "the code of a triangle is the cell of its centre");
    for (int leaf = 1; leaf <= 8; leaf *= 8) {
        bvh_mesh b = made(&m, (bvh_options){"morton", leaf, 0.3, SIZE_MAX});
        topology(&b, 0, code, &all, &any, &wrong);
        check_equal(wrong, 0, "leaves of %d: each node is cut where its codes first differ", leaf);
        check_at_least(b.tree.nodes, m.triangles / 8, "it is a tree");
        bvh_mesh_free(&b);
    }
    free(item), free(pair), free(code);
    mesh_free(&m);
}

/* No leaf costs more than the subtree that could stand in its place, and none less is left. */
static void test_morton_leaves(void)
{
    mesh m = teapot_mesh(8);
    bvh_mesh one = made(&m, (bvh_options){"morton", 1, 0.3, SIZE_MAX});
    bvh_mesh more = made(&m, (bvh_options){"morton", 8, 0.3, SIZE_MAX});
    tree_cost a = tree_cost_of(&one.tree), b = tree_cost_of(&more.tree);
    check_at_most(b.nodes + 0.3 * b.tests, a.nodes + 0.3 * a.tests,
                  "joining items into leaves never raises the cost");
    check(tree_stats(&more.tree).leaves < m.triangles
              && tree_stats(&one.tree).leaves == m.triangles, "and some are joined");
    bvh_mesh_free(&one), bvh_mesh_free(&more);
    mesh_free(&m);
}

/* ---------------------------------------------------------------------------------------------- */

/* Points of triangles: of the leaves that name the triangle, one has the point in its box. */
typedef struct { const bvh_mesh *b; vec3 p; uint32_t index; real slack; bool found; } finder;

static void find_point(finder *f, size_t at)
{
    const bvh_node *n = &f->b->tree.node[at];
    for (int k = 0; k < 3; k++)
        if (!(vaxis(f->p, k) >= (real)n->low[k] - f->slack
              && vaxis(f->p, k) <= (real)box_high(n, k) + f->slack)) return;
    for (size_t i = n->first; i < n->first + n->count; i++)
        f->found |= f->b->triangle[i].index == f->index;
    if (n->count == 0) find_point(f, n->first), find_point(f, n->first + 1);
}

static void test_cover(const char *name, const mesh *m, real size, bool cut)
{
    bvh_mesh b = made(m, (bvh_options){"spatial", 4, 0.3, SIZE_MAX});
    size_t lost = 0, points = check_count(40000);
    check(!cut || b.tree.items > m->triangles + m->triangles / 4, "%s: %zu references to %zu", name,
          b.tree.items, m->triangles);
    check_at_most(b.tree.items, bvh_most_cuts * m->triangles, "%s: no more than there is room",
                  name);
    for (size_t i = 0; i < points; i++) {
        random_stream g = random_start(4, i, 0);
        uint32_t k = (uint32_t)(random_next_bits(&g) % m->triangles);
        triangle t = mesh_triangle(m, k);
        real u = random_next(&g), v = random_next(&g) * (1 - u);
        if (i % 4 == 0) v = 0;              /* on an edge */
        if (i % 16 == 0) u = 0;             /* a corner */
        vec3 p = vmadd(vmadd(t.a, vsub(t.b, t.a), u), vsub(t.c, t.a), v);
        finder f = {&b, p, k, i % 16 == 0 ? 0 : 4 * real_epsilon * size, false};
        find_point(&f, 0);
        lost += !f.found;
    }
    check_equal(lost, 0, "%s: points of triangles, 4 eps of the coordinates off, are in no leaf",
                name);
    bvh_mesh_free(&b);
}

/* A part's box against the closed form: the triangle (0,0) (8,0) (0,8) in the plane z = 1. */
static void test_clip(void)
{
    vec3 v[3] = {{0, 0, 1}, {8, 0, 1}, {0, 8, 1}};
    uint32_t index[3] = {0, 1, 2};
    mesh m = {.v = v, .vertices = 3, .index = index, .triangles = 1};
    bvh_item item;
    bvh_box b;
    float pad = (float)(48 * real_epsilon) + 0x1p-20f;  /* 6 eps of 8, and a float */
    check(triangle_item(&m, 0, &item) && triangle_clip(&m, &item, 0, 2, 4, &b), "it reaches there");
    check(b.low[0] == 2 && box_high(&b, 0) == 4, "from plane to plane");
    check_close(box_high(&b, 1), 6, pad, "at x = 2 it is 6 high");
    check(box_high(&b, 1) >= 6 && b.low[1] <= 0 && b.low[2] <= 1 && box_high(&b, 2) >= 1,
          "never too small");
    check(triangle_clip(&m, &item, 1, 7, INFINITY, &b), "the tip");
    check_close(box_high(&b, 0), 1, pad, "above y = 7 it is 1 wide");
    check(!triangle_clip(&m, &item, 0, 9, 10, &b), "it does not reach beyond 8");
    check(triangle_clip(&m, &item, 0, 8, 9, &b) && b.low[0] == 8 && box_high(&b, 0) == 8
              && b.low[1] <= 0,
          "the corner at 8 belongs to what begins there");
    check(triangle_clip(&m, &item, 0, 0, 4, &b) && box_high(&b, 1) >= 8,
          "and those at 0 to the first");
    item.minus_high[0] = -1;  /* cut before, at x = 1; box kept below y = 3 */
    item.minus_high[1] = -3;
    check(!triangle_clip(&m, &item, 0, 2, 4, &b), "what was cut off does not come back");
    check(triangle_clip(&m, &item, 1, 2, 9, &b) && box_high(&b, 0) == 1
              && box_high(&b, 1) == 3,
          "what is left of it, inside what was left before");
}

/* Corners so far apart that their difference overflows: the slope of an edge is lost, so the box
 * stays as it is. (In double the box in float is infinite anyway.) At x = 0 it is 0.4 L high. */
static void test_clip_overflow(void)
{
    real large = real_largest;
    vec3 v[3] = {{-large, 0, 0}, {large, (real)0.8 * large, 0}, {large, 0, 0}};
    uint32_t index[3] = {0, 1, 2};
    mesh m = {.v = v, .vertices = 3, .index = index, .triangles = 1};
    bvh_item item;
    bvh_box b;
    check(triangle_item(&m, 0, &item) && triangle_clip(&m, &item, 0, -1, 1, &b)
              && (real)box_high(&b, 1) >= (real)0.4 * large && b.low[1] <= 0,
          "no part is lost where b - a overflows");
}

/* Where edges cross a plane, against the exact point: within 5.5 eps of the largest coordinate, so
 * that the box, 6 eps larger, holds it. The float bounds of the box are compared as they are. */
static void test_clip_rounding(void)
{
    /* Climbed to, in double: x and y of both ends, x of the plane. Exactly, they cross a hair above
     * a float, as computed 3.8 and 4 eps below it: that bounds are floats hides nothing there. */
    static const double found[2][5] = {
        {-0x1.bd23e3ed51321p-2, -0x1.06e864dd6e7b2p-1, 0x1.8276b44d4a5d8p-4, 0x1.0c0f890dde7efp-1,
         0x1.7edb1cp-4},
        {-0x1.f3ad298bc80b1p-2, -0x1.0279a15b4426cp-1, 0x1.1f6c224872418p-4, 0x1.0292b95c4c7ddp-1,
         0x1.170ccap-4}};
    size_t outside = 0;
    for (size_t i = 0; i < check_count(200000); i++) {
        random_stream g = random_start(6, i, 0);
        vec3 v[3] = {random_in_cube(&g, 1), random_in_cube(&g, 1), random_in_cube(&g, 1)};
        vec3 move = vscale(random_in_cube(&g, 1), i % 2 ? 100 : 0);
        for (int k = 0; k < 3; k++) v[k] = vadd(v[k], move);
        uint32_t index[3] = {0, 1, 2};
        mesh m = {.v = v, .vertices = 3, .index = index, .triangles = 1};
        bvh_item item;
        bvh_box b;
        float at = (float)((v[0].x + v[1].x) / 2);
        if (i < 2) {
            const double *x = found[i];
            v[0] = vec(x[0], x[1], 0), v[1] = vec(x[2], x[3], 0), v[2] = vec(x[2], x[1], 0);
            at = (float)x[4];
        }
        if (!((real)at > real_min(v[0].x, v[1].x) && (real)at < real_max(v[0].x, v[1].x)))
            continue;
        bool there = triangle_item(&m, 0, &item)
            && triangle_clip(&m, &item, 0, at, at, &b);
        wide s = wide_div(wide_sub(wide_of((double)at), wide_of((double)v[0].x)),
                               wide_sub(wide_of((double)v[1].x), wide_of((double)v[0].x)));
        for (int k = 1; k < 3; k++) {
            wide from = wide_of((double)vaxis(v[0], k)), to = wide_of((double)vaxis(v[1], k));
            wide exact = wide_add(from, wide_mul(wide_sub(to, from), s));
            outside += !there || wide_sign(wide_sub(exact, wide_of((double)b.low[k]))) < 0
                    || wide_sign(wide_sub(exact, wide_of((double)box_high(&b, k)))) > 0;
        }
    }
    check_equal(outside, 0, "the exact crossings of an edge are in the box of the part");
}

/* What the cuts are for: triangles that fill their boxes are left alone, slivers are cut, and then
 * a ray tests few of them. */
static void test_worth(void)
{
    mesh m = slivers_mesh(4000, (vec3){0, 0, 0}), pot = teapot_mesh(8);
    const bvh_options spatial = {"spatial", 8, 0.3, SIZE_MAX};
    bvh_mesh a = made(&m, bvh_defaults), b = made(&m, spatial);
    search_work wa = {0, 0, 0, 0}, wb = {0, 0, 0, 0};
    size_t differ = 0, hits = 0;
    for (size_t i = 0; i < check_count(2000); i++) {
        random_stream g = random_start(5, i, 0);
        vec3 o = random_in_cube(&g, 6);
        vec3 at = vmadd(random_in_cube(&g, 1), vunit((vec3){5, 4, 3}), 2);
        hit x = hit_none, y = hit_none;
        hits += bvh_mesh_hit_counted(&a, ray_between(o, at), &x, &wa);
        bvh_mesh_hit_counted(&b, ray_between(o, at), &y, &wb);
        differ += x.t != y.t || x.shape != y.shape || x.u != y.u || x.v != y.v;
    }
    check_equal(differ, 0, "slivers: the same hits with and without cuts");
    check_at_least(hits, check_count(2000) / 4, "and there are some");
    check_at_most((double)wb.tests, (double)wa.tests / 3, "a third of the tests");
    check_at_most((double)wb.nodes, (double)wa.nodes / 2, "and half of the nodes");
    bvh_mesh_free(&a), bvh_mesh_free(&b);
    b = made(&pot, spatial);
    check_at_most((double)b.tree.items, 1.1 * (double)pot.triangles, "the teapot's are left alone");
    bvh_mesh_free(&b);
    mesh_free(&m), mesh_free(&pot);
}

/* ---- a mesh that moves: the tree refitted and rotated is a right tree, and gives the very hits of
 * a tree built anew; what each way does to its cost ---- */

enum { frames = 60 };

static double cost_of(const bvh_mesh *b)
{
    tree_cost c = tree_cost_of(&b->tree);
    return c.nodes + bvh_defaults.item_cost * c.tests;
}

/* Every triangle once, corners where they are now, every box around what it holds. */
static void check_tree(const bvh_mesh *b, const mesh *m, const char *what)
{
    inspection x = inspect(b, m, 255, false);
    check_equal(x.outside + x.odd, 0, "%s: boxes hold their children and triangles of now", what);
    check_equal(x.missed, 0, "%s: each triangle in one leaf", what);
    check_equal(b->tree.depth, x.deepest, "%s: the depth it says", what);
    check_at_most(x.deepest, bvh_most_depth, "%s: a search can remember that", what);
}

/* The very hits of a tree built of the same mesh, at rays aimed where trees go wrong. */
static void check_hits(const bvh_mesh *b, const bvh_mesh *anew, const mesh *m, const char *what)
{
    size_t wrong = 0, hits = 0;
    for (size_t i = 0; i < check_count(2400); i++) {
        random_stream g = random_start(9, i, 0);
        ray r = aimed(m, &g, (int)(i % aimed_kinds), vec(0, 0, 1), 3);
        hit due = hit_none;
        bool found = bvh_mesh_hit(anew, r, &due);
        hits += found;
        for (int way = 0; way < (found ? aimed_ways : 1); way++) {
            ray q = aimed_way(r, due.t, way);
            hit h = hit_none;
            bool got = bvh_mesh_hit(b, q, &h), off = !same(got, h, found, due);
            if (off) print_wrong(what, q, due, h);
            wrong += off || bvh_mesh_occluded(b, q) != found;
        }
    }
    check_equal(wrong, 0, "%s: the hits of a tree built anew", what);
    check_at_least(hits, check_count(2400) / 4, "%s: enough rays hit", what);
}

/* Two trees built at rest, then 60 frames: one refitted, one rotated, too. */
static void test_motion(motion kind, int fine)
{
    const char *name = motion_name[kind];
    mesh rest = motion_mesh(kind, fine), m = motion_mesh(kind, fine);
    bvh_mesh fitted = made(&rest, bvh_defaults), rotated = made(&rest, bvh_defaults);
    size_t rotations = 0, dearer = 0;
    double at_rest = cost_of(&fitted);
    check_equal(bvh_mesh_refit(&fitted, &rest, false), 0, "%s: nothing to rotate", name);
    check_equal(cost_of(&fitted), at_rest, "%s: at rest, refitting changes no box", name);
    for (int frame = 1; frame <= frames; frame++) {
        motion_frame(kind, &rest, (real)frame / frames, &m);
        bvh_mesh_refit(&fitted, &m, false);
        bvh_mesh_refit(&rotated, &m, false);
        double before = cost_of(&rotated);
        rotations += bvh_mesh_refit(&rotated, &m, true);
        dearer += !(cost_of(&rotated) <= before * (1 + 1e-12));  /* sums of other orders */
        if (frame % 20) continue;
        bvh_mesh anew = made(&m, bvh_defaults);
        check_tree(&fitted, &m, "refitted"), check_tree(&rotated, &m, "rotated");
        check_hits(&fitted, &anew, &m, "refitted"), check_hits(&rotated, &anew, &m, "rotated");
        check(cost_of(&anew) < cost_of(&rotated) && cost_of(&rotated) < cost_of(&fitted),
              "%s, frame %d: cost %g built anew < %g rotated < %g refitted", name, frame,
              cost_of(&anew), cost_of(&rotated), cost_of(&fitted));
        bvh_mesh_free(&anew);
    }
    check_equal(dearer, 0, "%s: no rotation raises the cost", name);
    check_at_least(rotations, frames, "%s: there were some", name);
    bvh_mesh_free(&fitted), bvh_mesh_free(&rotated);
    mesh_free(&rest), mesh_free(&m);
}

/* (14.12) by hand: four triangles at 0, 10, 1, 11 on a line, two pairs by number; moved, the pairs
 * that are near are 0 with 1. One rotation puts them side by side. */
static mesh line_of(const real *place, size_t n)
{
    mesh m = mesh_room(n);
    for (size_t i = 0; i < n; i++) {
        m.v[3 * i] = vec(place[i], 0, 0), m.v[3 * i + 1] = vec(place[i] + 1, 0, 0);
        m.v[3 * i + 2] = vec(place[i], 1, 0);
    }
    return m;
}

static void test_one_rotation(void)
{
    static const real before[3] = {0, 20, 24}, after[3] = {0, 2, 200};
    mesh a = line_of(before, 3), b = line_of(after, 3);
    bvh_mesh t = made(&a, bvh_leaves(1, 0.3));
    bvh_mesh_refit(&t, &b, false);
    /* The pair of 20 and 24 is now 2 to 201, 199 by 1: half a surface of 199. With the third
     * instead it is 0 to 3: 3. The root's is 201. */
    check_close(tree_cost_of(&t.tree).nodes, 1 + 199. / 201, 1e-6, "stretched");
    check_equal(bvh_mesh_refit(&t, &b, true), 1, "one rotation");
    check_close(tree_cost_of(&t.tree).nodes, 1 + 3. / 201, 1e-6, "the two that are near, paired");
    check_equal(bvh_mesh_refit(&t, &b, true), 0, "and then there is nothing to gain");
    check_tree(&t, &b, "three triangles");
    bvh_mesh_free(&t);
    mesh_free(&a), mesh_free(&b);
}

/* Rotations move subtrees down. A tree as deep as can be must not get deeper. */
static void test_depth(void)
{
    enum { n = 300 };
    real place[n];
    size_t rotations = 0;
    for (int i = 0; i < n; i++) place[i] = ldexp((real)1, i % 100);
    mesh m = line_of(place, n);
    bvh_mesh t = made(&m, (bvh_options){"longest", 1, 0.01, SIZE_MAX});
    check_at_least(t.tree.depth, 60, "deep");
    for (uint64_t frame = 0; frame < 200; frame++) {
        for (size_t i = 0; i < n; i++) {
            random_stream g = random_start(5, frame, i);
            vec3 way = vscale(random_in_cube(&g, 1), ldexp((real)1, (int)(i + frame) % 100));
            for (size_t k = 0; k < 3; k++) m.v[3 * i + k] = vmadd(way, random_in_cube(&g, 1), 1);
        }
        rotations += bvh_mesh_refit(&t, &m, true);
    }
    check_at_least(rotations, 1000, "much was rotated");
    check_tree(&t, &m, "deep and shuffled");
    bvh_mesh_free(&t);
    mesh_free(&m);
}

/* Corners that are no longer numbers, and that are again. */
static void test_odd(void)
{
    mesh m = teapot_mesh(2), none = {.triangles = 0};
    vec3 was = m.v[7];
    bvh_mesh t = made(&none, bvh_defaults);
    check_equal(bvh_mesh_refit(&t, &none, true), 0, "stays empty");
    bvh_mesh_free(&t);
    t = made(&m, bvh_leaves(1, 0.01));
    for (int round = 0; round < 4; round++) {
        if (round % 2) m.v[7] = was;
        else m.v[7].x = round ? real_infinity : (real)NAN;
        for (int k = 0; k < 2; k++) {
            bvh_mesh_refit(&t, &m, k);
            bvh_mesh anew = made(&m, bvh_defaults);
            check_hits(&t, &anew, &m, round % 2 ? "whole again" : "a corner that is no number");
            check(memcmp(t.tree.node->low, anew.tree.node->low, sizeof(float[3])) == 0
                      && memcmp(t.tree.node->minus_high, anew.tree.node->minus_high,
                                sizeof(float[3])) == 0,
                  "round %d: what is no number widens no box", round);
            bvh_mesh_free(&anew);
        }
    }
    check_tree(&t, &m, "whole again");
    bvh_mesh_free(&t);
    mesh_free(&m);
}

/* References of cut triangles become whole ones: larger boxes, the same hits. */
static void test_spatial(void)
{
    mesh rest = teapot_mesh(4), m = teapot_mesh(4);
    bvh_options how = bvh_defaults;
    how.rule = "spatial";
    bvh_mesh t = made(&rest, how);
    motion_frame(MOTION_TWIST, &rest, 0.25, &m);
    bvh_mesh_refit(&t, &m, true);
    bvh_mesh anew = made(&m, how);
    check_hits(&t, &anew, &m, "spatial");
    bvh_mesh_free(&t), bvh_mesh_free(&anew);
    mesh_free(&rest), mesh_free(&m);
}

int main(void)
{
    mesh near = slivers_mesh(600, (vec3){0, 0, 0});
    mesh far = slivers_mesh(600, (vec3){1000, -1000, 3000});
    mesh pot = teapot_mesh(6);
    test_cover("slivers", &near, 8, true);
    test_cover("slivers far out", &far, 3000, true);
    test_cover("teapot", &pot, 4, false);
    test_motion(MOTION_TWIST, 6);
    test_motion(MOTION_SCATTER, 2);
    mesh_free(&near), mesh_free(&far), mesh_free(&pot);
    return check_all("14_build", test_codes, test_cut, test_topology,
                     test_morton_leaves, test_clip, test_clip_overflow, test_clip_rounding,
                     test_worth, test_one_rotation, test_depth, test_odd, test_spatial);
}
