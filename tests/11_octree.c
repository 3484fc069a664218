/* Every hit of the octree equals brute force, whatever its options, and so does the walk by slab
 * tests; the textbook's walk and the one without delta do not. The tree itself: every item is in
 * every leaf that it touches, leaves fill the cube, the bits of inner nodes are right, cuts stop
 * where they should, memory is bounded. The walk: which cells it passes and in which order, by
 * definition and by exact arithmetic. */
#include "../chapters/10_grid/lab/naive.h"
#include "../chapters/11_octree/lab/variants.h"
#include "../chapters/11_octree/octree.h"
#include "structure.h"

static octree_options how;

STRUCTURE_TESTED(octree, how)

static void test_options(void)
{
    const size_t most = (size_t)1 << 30;
    const octree_options list[] = {{1, 6, true, true, most}, {4, 20, false, true, most},
                                   {16, 10, true, false, most}, {3, 1, false, false, most},
                                   {100000, 16, true, true, most}};  /* the root is a leaf */
    structure s = {"octree of other options", STRUCTURE_OF(octree)};
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        how = list[i];
        structure_brief(&s, check_count(240));
    }
}

/* The naive walks fail on dyadic meshes, by kind of ray. `least`: per cent of the rays. */
typedef bool search(const octree *t, ray r, hit *out);

static size_t wrong_of(search *walk, const octree *t, const items *x, const mesh *m, int kind,
                       size_t n)
{
    size_t wrong = 0;
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(17, i, 0);
        ray r = aimed(m, &g, kind, (vec3){0, 0, 0}, 1);
        hit a = hit_none, b = hit_none;
        bool ga = items_hit(x, r, &a), gb = walk(t, r, &b);
        wrong += !same(ga, a, gb, b);
    }
    return wrong;
}

static void test_naive(void)
{
    mesh list[3] = {floors_mesh(4), octahedron_mesh(8), needles(300, 0.1)};
    size_t n = check_count(1000), textbook[3] = {0}, beyond = 0, unpadded = 0, ours = 0;
    for (int i = 0; i < 3; i++) {
        items x = items_of_mesh(&list[i]);
        octree t = octree_made(&x, (octree_options){4, 6, true, true, (size_t)1 << 26});
        if (i == 2) beyond = wrong_of(octree_hit_textbook, &t, &x, &list[i], 3, n);
        else {
            textbook[0] += wrong_of(octree_hit_textbook, &t, &x, &list[i], 4, n);
            textbook[1] += wrong_of(octree_hit_textbook, &t, &x, &list[i], 1, n);
            textbook[2] += wrong_of(octree_hit_textbook, &t, &x, &list[i], 5, n);
        }
        for (int kind = 0; kind < aimed_kinds; kind++) {
            unpadded += wrong_of(octree_hit_unpadded, &t, &x, &list[i], kind, n / 4);
            ours += wrong_of(octree_hit, &t, &x, &list[i], kind, n / 4);
        }
        octree_free(&t);
        mesh_free(&list[i]);
    }
    check_at_least(textbook[0], n / 2, "textbook: (-inf + inf) / 2: rays along axes are lost");
    check_at_least(textbook[1], n / 50, "textbook: rays at corners");
    check_at_least(textbook[2], n / 50, "textbook: rays from corner to corner");
    check_at_least(beyond, n / 50, "textbook: a hit beyond the cell ends the search among needles");
    check_at_least(unpadded, n / 100, "no delta: a ray in a wall is put into one of two cells");
    check_equal(ours, 0, "octree_hit, the same rays");
}

/* Faces a little beyond the walls of cells, hit at a t of few digits: t |d_a|, taken back, may say
 * a place before the wall, by more than delta. All the same the cell behind it must be asked. */
static ray beyond_a_wall(const items *x, random_stream *g, size_t i, const void *context)
{
    vec3 o = random_in_cube(g, 2), d = {0, 0, 0};
    ((real *)&d)[i % 3] = ldexp(1 + random_next(g), real_is_float ? 125 : 1021);
    return (void)x, (void)context, ray_from(vscale(o, 0x1p-20), d);
}

static void test_beyond_a_wall(size_t n)
{
    mesh m = floors_mesh(4);
    real beyond = 1 + (real_is_float ? (real)0x1p-10 : (real)0x1p-36);
    structure s = {"octree", STRUCTURE_OF(octree)};
    for (size_t k = 0; k < 2; k++) {  /* two dots that make the cube a little larger */
        real x = k ? beyond : -beyond;
        set_triangle(&m, k, (vec3){x, x, x}, (vec3){x, x, x}, (vec3){x, x, x});
    }
    for (size_t i = 0; i < m.vertices; i++) m.v[i] = vscale(m.v[i], 0x1p-20);
    items x = items_of_mesh(&m);
    how = (octree_options){1, 6, true, true, (size_t)1 << 26};
    structure_attack(&s, "faces just beyond a wall", &x, n, 31, beyond_a_wall, NULL);
    mesh_free(&m);
}

/* The mailbox saves tests, and no hit (structure_brief); no empty leaf is asked. */
static void test_counted(size_t n)
{
    mesh m = needles(2000, 0.05);
    items x = items_of_mesh(&m);
    search_work w[2] = {{0, 0, 0, 0}, {0, 0, 0, 0}};
    hit h;
    for (int k = 0; k < 2; k++) {
        how = octree_defaults, how.mailbox = k == 0;
        octree t = octree_made(&x, how);
        for (size_t i = 0; i < n; i++) {
            random_stream g = random_start(29, i, 0);
            octree_hit_counted(&t, aimed(&m, &g, 0, (vec3){0, 0, 0}, 1), &h, &w[k]);
        }
        octree_free(&t);
    }
    check(w[0].nodes == w[1].nodes && w[0].leaves == w[1].leaves, "the mailbox changes no walk");
    check_at_most((double)w[0].tests, 0.9 * (double)w[1].tests, "needles: tests saved");
    check(w[0].empty == 0 && w[0].leaves > 0, "no empty leaf is asked");
    mesh_free(&m);
}

/* ---- the tree ---- */

typedef struct {
    const octree *t;
    size_t leaves, empty, inner, references, bad_bits, apart, twice;
    double volume;  /* of the cube, sum over the leaves */
    int depth;
} census;

static bool leaf_holds(const octree *t, octree_node n, uint32_t item)
{
    for (uint32_t i = 0; i < (n.kind & ~octree_is_leaf); i++)
        if (t->reference[n.first + i] == item) return true;
    return false;
}

static void count_cell(census *s, uint32_t node, octree_cell c)
{
    const octree *t = s->t;
    octree_node n = t->node[node];
    if (n.kind && !(n.kind & octree_is_leaf)) {
        s->inner++;
        for (unsigned k = 0; k < 8; k++) {
            bool filled = t->node[n.first + k].kind != 0;
            s->bad_bits += filled != (n.kind >> k & 1);
            count_cell(s, n.first + k, octree_child_cell(c, k));
        }
        return;
    }
    uint32_t count = n.kind & ~octree_is_leaf;
    aabb cell = first_aabb_pad(octree_cell_box(t, c), 8 * real_epsilon * aabb_reach(t->bounds));
    s->leaves++, s->empty += count == 0, s->references += count;
    s->volume += ldexp(1.0, -3 * c.depth);
    if (count && c.depth > s->depth) s->depth = c.depth;
    for (uint32_t i = 0; i < count; i++) {
        uint32_t item = t->reference[n.first + i];
        s->apart += !items_overlap_bounds(&t->x, item, cell);
        for (uint32_t j = i + 1; count < 100 && j < count; j++)
            s->twice += t->reference[n.first + j] == item;
    }
}

/* All leaves whose closed cell holds p, which is a point of the item, must hold the item. */
static size_t leaves_without(const octree *t, uint32_t node, octree_cell c, vec3 p, uint32_t item)
{
    octree_node n = t->node[node];
    if (!aabb_contains(octree_cell_box(t, c), p)) return 0;
    if (n.kind == 0) return 1;
    if (n.kind & octree_is_leaf) return !leaf_holds(t, n, item);
    size_t sum = 0;
    for (unsigned k = 0; k < 8; k++)
        sum += leaves_without(t, n.first + k, octree_child_cell(c, k), p, item);
    return sum;
}

static void test_tree(const char *name, mesh m, octree_options with, size_t points)
{
    const octree_cell root = {0, 0, 0, 0};
    items x = items_of_mesh(&m);
    octree t = octree_made(&x, with);
    census s = {.t = &t};
    size_t lost = 0;
    count_cell(&s, 0, root);
    check(s.volume == 1, "%s: the leaves fill the cube: %.17g", name, s.volume);
    check_equal(s.bad_bits, 0, "%s: bits of inner nodes tell which children hold something", name);
    check_equal(s.apart, 0, "%s: items in leaves that their boxes do not touch", name);
    check_equal(s.twice, 0, "%s: items twice in one leaf", name);
    structure_stats st = octree_stats(&t);
    check(st.inner == s.inner && st.leaves == s.leaves && st.empty == s.empty
              && st.references == s.references && st.items == m.triangles,
          "%s: octree_stats counts what is there", name);
    check_equal(st.depth, s.depth, "%s: the deepest leaf that holds something", name);
    check_equal(st.bytes, t.nodes * sizeof *t.node + t.stats.references * sizeof *t.reference,
                "%s: what is held is what is counted", name);
    check(st.depth <= with.depth && st.bytes <= st.peak && st.peak <= with.most_bytes,
          "%s: depth and memory within the limits", name);
    size_t nodes = t.nodes * sizeof *t.node, references = t.stats.references * sizeof *t.reference;
    check_at_least(st.peak, st.bytes + (nodes > references ? nodes : references),
                   "%s: an array and what it was copied from", name);
    check_equal(st.leaves, 7 * st.inner + 1, "%s: each cut makes seven more leaves", name);
    for (size_t i = 0; i < points; i++) {  /* corners are points of the triangle, exactly */
        random_stream g = random_start(41, i, 0);
        uint32_t item = (uint32_t)random_below(&g, m.triangles);
        triangle q = mesh_triangle(&m, item);
        real u = random_next(&g), v = random_next(&g) * (1 - u);
        vec3 p = vmadd(vmadd(q.a, vsub(q.b, q.a), u), vsub(q.c, q.a), v);
        vec3 at[5] = {q.a, q.b, q.c, p, vscale(vadd(q.a, q.b), 0.5)};
        for (int k = 0; k < 5; k++) lost += leaves_without(&t, 0, root, at[k], item);
    }
    check_equal(lost, 0, "%s: points of triangles in leaves that do not have them", name);
    octree_free(&t), octree_free(&t);
    mesh_free(&m);
}

/* A point within the triangle is rounded by less than the margin of the cells. */
static void test_trees(void)
{
    const size_t points = check_count(3000), most = (size_t)1 << 28;
    const octree_options fine = {4, 8, true, true, most}, coarse = {4, 6, true, false, most};
    test_tree("octahedron", octahedron_mesh(8), fine, points);
    test_tree("planes", floors_mesh(4), fine, points);
    test_tree("planes, by boxes", floors_mesh(4), coarse, points);
    test_tree("planes, thirds", floors_mesh(3), fine, points);
    test_tree("torus", torus_mesh(24), fine, points);
    test_tree("needles", needles(300, 1e-3), fine, points);
    test_tree("needles, by boxes", needles(300, 1e-3), coarse, points);
    mesh far = torus_mesh(24);  /* as far from 0 as its own size / 1000 */
    for (size_t i = 0; i < far.vertices; i++) far.v[i] = vadd(far.v[i], (vec3){1000, 2000, -3000});
    test_tree("torus, moved", far, fine, points);
}

/* ---- when to stop ---- */

static structure_stats stats_of(mesh *m, octree_options with)
{
    items x = items_of_mesh(m);
    octree t = octree_made(&x, with);
    structure_stats s = octree_stats(&t);
    octree_free(&t);
    return s;
}

static void test_stop(void)
{
    const octree_options with = {4, 20, true, true, (size_t)1 << 26};
    /* Half of a side of the cube, and all of its diagonal. */
    mesh same_place = structure_copies(1000, (vec3){0, 0, 0}, (vec3){1, 0, 1}, (vec3){0, 1, 1}, 1);
    structure_stats s = stats_of(&same_place, with);
    check_at_most(s.references, 64 * 1000, "one place: two cuts in vain, each into eight, at most");
    mesh_free(&same_place);

    /* By their boxes 20 plates are in four of eight, at any depth: 80 tests, a quarter of which is
     * no less than 20 and the price. One thing above makes the cube higher than they lie. */
    mesh plates = mesh_room(21);
    for (size_t i = 0; i < 20; i++)
        set_triangle(&plates, i, vec(-1, -1, -0.8), vec(1, -1, -0.8), vec(-1, 1, -0.8));
    set_triangle(&plates, 20, vec(0.1, 0.1, 1), vec(0.2, 0.1, 1), vec(0.1, 0.2, 1));
    s = stats_of(&plates, (octree_options){4, 6, true, false, (size_t)1 << 26});
    check(s.depth == 1 && s.references == 4 * 20 + 1, "plates: one cut in vain, and no second");
    mesh_free(&plates);

    /* A fan of 1000 round the middle of the cube: all cells touch all, and yet a cut helps. */
    mesh fan = mesh_room(1000);
    for (size_t i = 0; i < 1000; i++) {
        real a = 2 * pi * (real)i / 1000, b = 2 * pi * (real)(i + 1) / 1000;
        vec3 p = {cos(a), sin(a), cos(3 * a)}, q = {cos(b), sin(b), cos(3 * b)};
        set_triangle(&fan, i, (vec3){0, 0, 0}, p, q);
    }
    items x = items_of_mesh(&fan);
    octree t = octree_made(&x, with);
    search_work w = {0, 0, 0, 0};
    for (size_t i = 0; i < 1000; i++) {  /* past the middle, by 0.3 */
        real a = 2 * pi * (real)i / 1000, z = (real)0.7 * cos(3 * a);
        hit h;
        octree_hit_counted(&t, ray_from((vec3){(real)0.7 * cos(a), (real)0.7 * sin(a), z - 3},
                                        vec(0.01, 0.02, 1)), &h, &w);
    }
    check_at_most(w.tests, 40 * 1000, "a fan of 1000: some forty tests a ray at most");
    octree_free(&t);
    mesh_free(&fan);

    mesh m = teapot_mesh(6);
    structure_stats cut = stats_of(&m, (octree_options){8, 20, true, true, (size_t)1 << 28});
    structure_stats box = stats_of(&m, (octree_options){8, 20, true, false, (size_t)1 << 28});
    check(cut.references < box.references, "exact overlap: fewer references than by boxes");
    s = stats_of(&m, (octree_options){8, 0, true, true, (size_t)1 << 28});
    check(s.inner == 0 && s.leaves == 1 && s.references == m.triangles && s.depth == 0,
          "depth 0: one leaf of all");
    s = stats_of(&m, (octree_options){8, 99, true, true, (size_t)1 << 28});
    check_at_most(s.depth, octree_most_depth, "more than the most depth is the most depth");
    mesh_free(&m);
}

/* ---- the walk ---- */

/* (11.6) against its definition: child c is passed if max(in, l_k beyond) <= min(out, h_k before).
 * Comparisons do not round, so the two agree exactly, ties included. */
static void test_passed(size_t n)
{
    size_t wrong = 0, more = 0;
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(51, i, 0);
        bool ties = i % 2;  /* values on a small grid: many are equal */
        real v[8];
        for (int k = 0; k < 8; k++)
            v[k] = ties ? (real)random_below(&g, 5) : random_next(&g);
        octree_ray o = {{1, 1, 1}, {v[5] / 8, v[6] / 8, v[7] / 8}, 1, 0};
        if (i % 4 < 2) o.pad = (vec3){0, 0, 0};
        vec3 m = {v[0], v[1], v[2]};
        real in = real_min(v[3], v[4]), out = real_max(v[3], v[4]);
        unsigned expected = 0, got = octree_passed(&o, m, in, out);
        for (unsigned c = 0; c < 8; c++) {
            real from = in, to = out;
            for (int k = 0; k < 3; k++) {
                if (c >> k & 1) from = real_max(vaxis(m, k) - vaxis(o.pad, k), from);
                else to = real_min(vaxis(m, k) + vaxis(o.pad, k), to);
            }
            expected |= (unsigned)(from <= to) << c;
        }
        wrong += got != expected, more += (got & (got - 1)) != 0;
    }
    check_equal(wrong, 0, "(11.6): children passed");
    check_at_least(more, n / 4, "several children are passed");
    real nan = (real)NAN;
    octree_ray lost = {{1, 1, 1}, {0, 0, 0}, 1, 0};
    check_equal(octree_passed(&lost, (vec3){nan, nan, nan}, 0, 1), 255, "NaN: all are passed");

    wrong = 0;
    for (unsigned flip = 0; flip < 8; flip++)
        for (unsigned mask = 0; mask < 256; mask++) {
            unsigned expected = 0;
            for (unsigned c = 0; c < 8; c++) expected |= (mask >> c & 1) << (c ^ flip);
            wrong += octree_flipped(mask, flip) != expected;
        }
    check_equal(wrong, 0, "(11.4): bits in the ray's order, all 8 x 256");
}

/* t of entry and exit of the closed cell, by slabs in twice the digits or more. */
static bool cell_span(aabb b, ray r, long double *enter, long double *leave)
{
    *enter = (long double)r.tmin, *leave = (long double)r.tmax;
    for (int k = 0; k < 3; k++) {
        long double d = (long double)vaxis(r.d, k), o = (long double)vaxis(r.o, k);
        long double lo = (long double)vaxis(b.lo, k), hi = (long double)vaxis(b.hi, k);
        if (d == 0 && (o < lo || o > hi)) return false;
        if (d == 0) continue;
        long double t0 = (lo - o) / d, t1 = (hi - o) / d;
        if (t0 > t1) { long double swap = t0; t0 = t1, t1 = swap; }
        if (t0 > *enter) *enter = t0;
        if (t1 < *leave) *leave = t1;
    }
    return *enter <= *leave;
}

typedef struct { uint32_t node; aabb box; } found_leaf;

static size_t list_leaves(const octree *t, uint32_t node, octree_cell c, found_leaf *out, size_t n)
{
    octree_node v = t->node[node];
    if (v.kind & octree_is_leaf) {
        if (out) out[n] = (found_leaf){node, octree_cell_box(t, c)};
        return n + 1;
    }
    for (unsigned k = 0; v.kind && k < 8; k++)
        n = list_leaves(t, v.first + k, octree_child_cell(c, k), out, n);
    return n;
}

/* Rays that miss all items: the leaves asked are those that they pass, in order. Cells are dyadic,
 * so the oracle's cells are exact; rays aimed at corners of cells pass up to eight at once. A ray
 * in a wall, or nearly so (one of three here), is in the cells on both sides at once: these come
 * one side after the other. */
static void test_order(size_t n)
{
    mesh m = octahedron_mesh(8);
    items x = items_of_mesh(&m);
    octree t = octree_made(&x, (octree_options){8, 4, true, true, (size_t)1 << 26});
    size_t missing = 0, strange = 0, behind = 0, passed = 0;
    int longest = 0;
    size_t leaves = list_leaves(&t, 0, (octree_cell){0, 0, 0, 0}, NULL, 0);
    found_leaf *leaf = allocate(leaves, sizeof *leaf);
    list_leaves(&t, 0, (octree_cell){0, 0, 0, 0}, leaf, 0);
    m.triangles = t.x.n = 0;
    for (size_t i = 0; i < 3 * 512; i++) m.index[i] = 0;  /* no triangle is hit: all points */
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(61, i, 0);
        vec3 o = random_in_cube(&g, 3), corner = random_in_cube(&g, 1);
        octree_trail trail = {{0}, 0};
        hit h;
        if (i % 3) corner = vscale((vec3){rint(8 * corner.x), rint(8 * corner.y),
                                          rint(8 * corner.z)}, 0.125);
        if (i % 3 == 2) o = vscale((vec3){rint(o.x), rint(o.y), rint(o.z)}, 3);
        ray r = ray_from(o, vsub(corner, o));
        if (vzero(r.d)) continue;
        octree_walk(&t, r, false, 1, &h, NULL, &trail);
        real a = fabs(r.d.x), b = fabs(r.d.y), c = fabs(r.d.z), size = vlength(r.d);
        bool in_a_wall = i % 3 == 2 || real_min(a, real_min(b, c)) < size / 32;
        long double before = 0, slack = (long double)(32 * 4096 * real_epsilon / size);
        for (int k = 0; k < trail.n; k++) {
            long double in = 0, out = 0;
            size_t at = 0;
            while (leaf[at].node != trail.node[k]) at++;
            aabb near = first_aabb_pad(leaf[at].box, 16384 * real_epsilon);
            strange += !cell_span(near, r, &in, &out);
            cell_span(leaf[at].box, r, &in, &out);
            behind += !in_a_wall && out < before - slack;
            if (in > before) before = in;
        }
        for (size_t k = 0; k < leaves; k++) {
            long double in, out;
            bool asked = false;
            if (!cell_span(leaf[k].box, r, &in, &out)) continue;
            for (int j = 0; j < trail.n; j++) asked |= trail.node[j] == leaf[k].node;
            missing += !asked, passed++;
        }
        if (trail.n > longest) longest = trail.n;
    }
    check(longest < octree_trail_room && longest > 8, "room for the trail: %d", longest);
    check_equal(missing, 0, "leaves that a ray touches and that were not asked");
    check_equal(strange, 0, "leaves that were asked and that no ray comes near");
    check_equal(behind, 0, "leaves out of order: left before the one before them was entered");
    check_at_least(passed, n, "leaves passed");
    free(leaf);
    octree_free(&t);
    mesh_free(&m);
}

/* Two squares that are the ends of the cube along x: low end + size, rounded, may lie before the
 * high end, and what lies there must be in some cell. */
static void test_ends(void)
{
    size_t lost = 0, n = check_count(16000);
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(43, i, 0);
        mesh m = mesh_room(2);
        real u = random_next(&g) * (real)0.45;  /* size just above 2, the ends on both sides of 1 */
        real end[2] = {-1 - u, 1 - u * random_next(&g)};
        real w = (end[1] - end[0]) * (real)0.9;  /* in two children, so each is asked */
        for (size_t k = 0; k < 2; k++)
            set_triangle(&m, k, (vec3){end[k], 0, 0}, (vec3){end[k], w, 0}, (vec3){end[k], 0, 0.5});
        items x = items_of_mesh(&m);
        octree t = octree_made(&x, (octree_options){1, 4, true, true, (size_t)1 << 20});
        hit h = {.shape = 0};
        ray r = ray_from((vec3){end[1] + 1, 0.125, 0.125}, (vec3){-1, 0, 0});
        lost += !octree_hit(&t, r, &h) || h.shape != 1;
        octree_free(&t), mesh_free(&m);
    }
    check_equal(lost, 0, "the high end of the cube is missed, of %zu", n);
}

int main(void)
{
    structure s = {"octree", STRUCTURE_OF(octree)};
    how = octree_defaults;
    structure_tests(&s, check_count(600));
    structure_limited(octree, octree_defaults, teapot_mesh(8), 1);
    structure_ends(octree, octree_defaults, check_count(4000));
    test_passed(check_count(200000));
    test_order(check_count(3000));
    test_beyond_a_wall(check_count(3000));
    test_counted(check_count(4000));
    structure_piled(octree, octree_defaults, 400, 1.2 * structure_room(400));
    return check_all("11_octree", test_options, test_naive, test_trees, test_ends,
                     test_stop);
}
