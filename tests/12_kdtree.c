/* The k-d tree against brute force, its invariants and limits; textbook searches losing hits. */
#include "../chapters/12_kdtree/lab/textbook.h"
#include "corner.h"
#include "structure.h"

static kdtree_options options_now;
STRUCTURE_TESTED(kdtree, options_now)

static kdtree_options with(kdtree_strategy strategy, int leaf, bool clip, kdtree_planar planar)
{
    kdtree_options how = kdtree_defaults;
    how.strategy = strategy, how.leaf = leaf, how.clip = clip, how.planar = planar;
    return how;
}

static void test_structures(void)
{
    const struct { const char *name; kdtree_options how; } list[] = {
        {"k-d tree, SAH", kdtree_defaults},
        {"middle", with(KD_MIDDLE, 4, true, KD_THICK)},
        {"median", with(KD_MEDIAN, 4, true, KD_THICK)},
        {"SAH, boxes", with(KD_SAH, 0, false, KD_THICK)},
        {"both sides", with(KD_SAH, 0, true, KD_BOTH)},
        {"middle, one side", with(KD_MIDDLE, 1, true, KD_ONE)},
        {"costly tests", {KD_SAH, 0, 0, 20, 0.8, true, KD_THICK, SIZE_MAX / 4}}};
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        structure s = {list[i].name, STRUCTURE_OF(kdtree)};
        options_now = list[i].how;
        if (i) structure_brief(&s, check_count(240));
        else structure_tests(&s, check_count(400));
    }
}

/* Rays for which no t is rounded, at squares in dyadic planes and at an octahedron. */
typedef bool searcher(const kdtree *t, ray r, hit *out);

static size_t wrong_of(searcher *search, const kdtree *t, const mesh *m, size_t rays, bool dyadic)
{
    size_t wrong = 0;
    for (size_t i = 0; i < rays; i++) {
        random_stream g = random_start(31, i, 0);
        ray r = aimed(m, &g, (int)(i % aimed_kinds), (vec3){0, 0, 0}, 1);
        if (dyadic) r = kd_dyadic_ray(&g);
        if (r.tmin < 0) continue;
        hit a = hit_none, b = hit_none;
        bool ga = mesh_hit(m, r, &a), gb = search(t, r, &b);
        wrong += !same(ga, a, gb, b);
    }
    return wrong;
}

static void test_naive(void)
{
    mesh m = floors_mesh(4);
    items x = items_of_mesh(&m);
    kdtree both = kdtree_made(&x, with(KD_MIDDLE, 1, true, KD_BOTH));
    kdtree one = kdtree_made(&x, with(KD_MIDDLE, 1, true, KD_ONE));
    size_t rays = check_count(4000);
    size_t strict = wrong_of(kdtree_hit_naive_strict, &both, &m, rays, true);
    size_t strict_one = wrong_of(kdtree_hit_naive_strict, &one, &m, rays, true);
    check_equal(wrong_of(kdtree_hit, &both, &m, rays, true), 0, "dyadic rays: padded search");
    check_equal(wrong_of(kdtree_hit_textbook, &both, &m, rays, true), 0,
                "dyadic rays: the textbook loses nothing where nothing is rounded");
    check_at_least(wrong_of(kdtree_hit_naive_final, &both, &m, rays, true), rays / 100,
                   "a hit beyond the cell taken as final is wrong");
    check_at_least(strict, rays / 1000, "one child where t = enter or t = exit loses hits");
    check_at_least(strict_one, 2 * strict, "and twice as many if one child has what is in a plane");
    check_equal(wrong_of(kdtree_hit_textbook, &one, &m, rays, true), 0,
                "one child has it, but both are visited: enough");
    check_at_least(wrong_of(kdtree_hit_textbook, &both, &m, 4000, false), 1,  /* always as many */
                   "aimed rays, rounded: the textbook loses hits");
    check_equal(wrong_of(kdtree_hit, &both, &m, rays, false), 0, "aimed rays: padded search");
    check_equal(wrong_of(kdtree_hit, &one, &m, rays, false), 0, "the same, kept in one child");
    kdtree_free(&both), kdtree_free(&one);
    mesh_free(&m);
}

/* From an eye at 0, o + delta is nothing but delta: what else keeps a ray from slipping between
 * cells, that a float farther out is coarser, is not there. In float also the hits are rough. */
static ray from_zero(const items *x, random_stream *g, size_t i, const void *context)
{
    ray r = ray_from((vec3){0, 0, 0}, x->m->v[x->m->index[random_below(g, 3 * x->m->triangles)]]);
    if (i % 2) ((real *)&r.o)[i / 2 % 3] = random_next(g) / 4;
    r.d = vscale(vsub(r.d, r.o), 1 / (1 + random_next(g)));
    return (void)context, r;
}

/* An eye beyond all floats: o + delta is infinite, t of a plane is a NaN or infinite, and no child
 * may be dropped for that. Along an axis even such a ray hits. In float there is no such place. */
static ray from_beyond(const items *x, random_stream *g, size_t i, const void *context)
{
    vec3 o = x->m->v[x->m->index[random_below(g, 3 * x->m->triangles)]], d = {0, 0, 0};
    real far = i % 2 ? (real)1e30 * (real)1e30 : (real)1e30 * (real)1e9;
    if (i / 2 % 2) far = -far;
    ((real *)&o)[i % 3] = far, ((real *)&d)[i % 3] = far < 0 ? 1 : -1;
    return (void)context, ray_from(o, d);
}

static void test_eyes(void)
{
    mesh list[4] = {floors_mesh(7), octahedron_mesh(9), torus_mesh(24), torus_mesh(16)};
    structure s = {"k-d tree", STRUCTURE_OF(kdtree)};
    options_now = with(KD_MIDDLE, 1, true, KD_BOTH);
    for (int k = 0; k < 4; k++) {
        items x = items_of_mesh(&list[k]);
        if (k < 3) structure_attack(&s, "an eye at 0", &x, check_count(3000), 81, from_zero, NULL);
        else if (!real_is_float)
            structure_attack(&s, "beyond floats", &x, check_count(1000), 101, from_beyond, NULL);
        mesh_free(&list[k]);
    }
}

static bool corner_lost(ray r, vec3 c, bool bare)
{
    const aabb_frame home = {{0, 0, 0}, 1};
    kd_box box = {{(float)c.x, (float)c.y, (float)c.z}, {(float)c.x, (float)c.y, (float)c.z}};
    kd_ray q;
    kd_ray_of(r, &home, &box, bare ? 0 : 1, &q);
    return q.enter > q.exit;
}

/* ---------------------------------------------------------------------------------------------- */

typedef struct {
    const kdtree *t;
    size_t seen, leaves, empty, references, outside, bad_range, bad_full;
    int depth;
} walk;

static void walk_node(walk *w, uint32_t at, kd_box cell, int depth)
{
    kd_node n = w->t->node[at];
    w->seen++;
    if (depth > w->depth) w->depth = depth;
    if (kd_is_leaf(n)) {
        uint32_t count = kd_count(n);
        w->leaves++, w->empty += count == 0, w->references += count;
        w->bad_range += n.first + (size_t)count > w->t->stats.references;
        return;
    }
    int k = kd_axis(n);
    kd_box lower = cell, upper = cell;
    w->outside += !(n.plane > cell.lo[k] && n.plane < cell.hi[k]);
    lower.hi[k] = upper.lo[k] = n.plane;
    for (size_t child = 0; child < 2; child++) {
        kd_node c = w->t->node[kd_lower(n) + child];
        w->bad_full += kd_full(n, child) == (kd_is_leaf(c) && kd_count(c) == 0);
    }
    walk_node(w, kd_lower(n), lower, depth + 1);
    walk_node(w, kd_lower(n) + 1, upper, depth + 1);
}

/* Is triangle i in a leaf whose cell has p, or all but 2^-40 of it? */
static bool leaf_lists(const kdtree *t, uint32_t at, const real p[3], uint32_t i)
{
    kd_node n = t->node[at];
    if (kd_is_leaf(n)) {
        for (uint32_t j = 0; j < kd_count(n); j++)
            if (t->triangle[n.first + j].index == i) return true;
        return false;
    }
    real off = p[kd_axis(n)] - (real)n.plane, spare = real_is_float ? (real)1e-5 : (real)0x1p-40;
    return (off <= spare && leaf_lists(t, kd_lower(n), p, i))
           || (off >= -spare && leaf_lists(t, kd_lower(n) + 1, p, i));
}

static void invariants_of(const char *what, mesh m, kdtree_options how)
{
    items x = items_of_mesh(&m);
    kdtree t = kdtree_made(&x, how);
    walk w = {&t, 0, 0, 0, 0, 0, 0, 0, 0};
    walk_node(&w, 0, t.box, 0);
    structure_stats s = kdtree_stats(&t);
    check_equal(w.seen, t.nodes - 1, "%s: each node but the unused one is reached once", what);
    check_equal(w.leaves, s.leaves, "%s: leaves counted", what);
    check_equal(s.inner + 1, s.leaves, "%s: a binary tree has one inner node less", what);
    check_equal(w.empty, s.empty, "%s: empty leaves counted", what);
    check_equal(w.references, s.references, "%s: references counted", what);
    check_equal(w.depth, s.depth, "%s: depth", what);
    check_at_most(w.depth, kd_default_depth(m.triangles), "%s: depth bounded (12.2)", what);
    check_equal(w.outside, 0, "%s: every plane cuts its cell", what);
    check_equal(w.bad_range, 0, "%s: leaves name references that are there", what);
    check_equal(w.bad_full, 0, "%s: a node says which of its children are empty leaves", what);
    check_at_least(s.references, s.items, "%s: every item is somewhere", what);
    check_at_least(s.peak, s.bytes, "%s: peak", what);
    check_equal(s.bytes, t.nodes * 8 + (t.stats.references + 1) * 16,
                "%s: 8 bytes a node, 16 a reference", what);
    size_t lost = 0, points = check_count(40000);
    for (size_t i = 0; i < points; i++) {
        random_stream g = random_start(41, i, 0);
        uint32_t k = (uint32_t)random_below(&g, m.triangles);
        triangle tri = mesh_triangle(&m, k);
        real u = random_next(&g), v = random_next(&g) * (1 - u);
        if (i % 4 == 0) u = 0;
        if (i % 8 == 0) v = 0;
        vec3 p = vmadd(vmadd(tri.a, vsub(tri.b, tri.a), u), vsub(tri.c, tri.a), v);
        p = frame_into(&t.frame, p);
        lost += !leaf_lists(&t, 0, (real[3]){p.x, p.y, p.z}, k);
    }
    check_equal(lost, 0, "%s: every point of a triangle is in a cell that lists it", what);
    kdtree_free(&t);
    mesh_free(&m);
}

static void test_invariants(void)
{
    invariants_of("teapot", teapot_mesh(8), kdtree_defaults);
    invariants_of("teapot, middle", teapot_mesh(8), with(KD_MIDDLE, 2, true, KD_THICK));
    invariants_of("teapot, median", teapot_mesh(8), with(KD_MEDIAN, 2, true, KD_THICK));
    invariants_of("teapot, boxes", teapot_mesh(8), with(KD_SAH, 0, false, KD_THICK));
    invariants_of("planes", floors_mesh(5), kdtree_defaults);
    invariants_of("planes, one side", floors_mesh(4), with(KD_MIDDLE, 1, true, KD_ONE));
    invariants_of("needles", needles(2000, 1e-5), kdtree_defaults);
    invariants_of("stadium", stadium_mesh(8), kdtree_defaults);
}

/* Clipping only takes references away; what it leaves is tested less. */
static void test_clip_pays(void)
{
    mesh m = needles(1000, 0.01);
    items x = items_of_mesh(&m);
    kdtree with_clip = kdtree_made(&x, kdtree_defaults);
    kdtree without = kdtree_made(&x, with(KD_SAH, 0, false, KD_THICK));
    search_work a = {0, 0, 0, 0}, b = {0, 0, 0, 0};
    size_t rays = check_count(5000);
    for (size_t i = 0; i < rays; i++) {
        ray r = structure_across(51, i, 3, 1);
        hit h;
        kdtree_hit_counted(&with_clip, r, &h, &a), kdtree_hit_counted(&without, r, &h, &b);
    }
    check_at_most(2 * a.tests, b.tests, "needles: clipping saves more than half of the tests");
    check_at_least(a.nodes + rays, a.leaves, "inner nodes that a ray meets, and 1: its leaves");
    kdtree_free(&with_clip), kdtree_free(&without);
    mesh_free(&m);
}

/* References to items that do not touch the cell of their leaf. */
static size_t listed_in_vain(const kdtree *t, uint32_t at, kd_box cell)
{
    kd_node n = t->node[at];
    size_t vain = 0;
    if (kd_is_leaf(n)) {
        aabb box = {vec(cell.lo[0], cell.lo[1], cell.lo[2]),
                    vec(cell.hi[0], cell.hi[1], cell.hi[2])};
        for (uint32_t k = 0; k < kd_count(n); k++)
            vain += !items_overlap_box(&t->x, t->index[n.first + k], box);
        return vain;
    }
    kd_box lower = cell, upper = cell;
    lower.hi[kd_axis(n)] = upper.lo[kd_axis(n)] = n.plane;
    return listed_in_vain(t, kd_lower(n), lower) + listed_in_vain(t, kd_lower(n) + 1, upper);
}

/* Balls and rods at all angles: a leaf lists only what touches its cell. That nothing is missing,
 * structure_tests asks of scenes with round shapes. */
static void test_round(void)
{
    enum { n = 2000 };
    shape *s = allocate(n, sizeof *s);
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(53, i, 0);
        vec3 p = random_in_cube(&g, 1), q = vadd(p, random_in_cube(&g, 0.3));
        real r = (real)0.2 * random_next(&g);
        s[i] = i % 2 ? shape_of_sphere((sphere){p, r})
                     : shape_of_cone((cone){.a = p, .b = q, .ra = r / 10, .rb = r / 10});
    }
    scene all = {s, n};
    items x = items_of_scene(&all);
    kdtree t = kdtree_made(&x, kdtree_defaults);
    check_equal(listed_in_vain(&t, 0, t.box), 0, "round shapes that miss the cell of their leaf");
    kdtree_free(&t);
    free(s);
}

static void test_limits(void)
{
    check_equal(kd_default_depth(1), 9, "8 + 1.3 log2(1 + 1)");
    check_equal(kd_default_depth((1 << 20) - 1), 34, "8 + 1.3 * 20");
    mesh m = teapot_mesh(4);
    items x = items_of_mesh(&m);
    kdtree_options how = kdtree_defaults;
    for (int depth = 1; depth <= 12; depth++) {
        how.depth = depth;
        kdtree t = kdtree_made(&x, how);
        check_equal(t.stats.depth, depth, "the depth asked for");
        kdtree_free(&t);
    }
    mesh row = mesh_room(40);  /* each half as large as the one before: a cell in a cell */
    for (size_t i = 0; i < 40; i++) {
        real s = ldexp((real)1, -(int)i);
        set_triangle(&row, i, (vec3){s, 0, 0}, (vec3){s, s, 0}, (vec3){s, 0, s});
    }
    x = items_of_mesh(&row), how.depth = kdtree_most_depth;
    kdtree t = kdtree_made(&x, how);
    check(t.stats.depth > kd_default_depth(40), "the most is allowed");
    kdtree_free(&t), mesh_free(&row);
    kdtree none = {0};
    kdtree_free(&none);
    kdtree_free(&none);
    mesh_free(&m);
}

/* Far from 0, tiny, huge: the tree's own coordinates keep its planes apart: as good a tree. */
static void test_frame(void)
{
    const struct { const char *what; vec3 move; real scale; } list[] = {
        {"moved by 1e6 times its size", {1000000, -3000000, 2000000}, 1},
        {"tiny", {0, 0, 0}, real_is_float ? (real)1e-15 : (real)1e-60},
        {"huge", {0, 0, 0}, real_is_float ? (real)1e8 : (real)1e70}};
    mesh m = teapot_mesh(6);
    items x = items_of_mesh(&m);
    kdtree t = kdtree_made(&x, kdtree_defaults);
    for (size_t i = 0; i < 3; i++) {
        if (real_is_float && i == 0) continue;  /* the corners themselves would move */
        mesh c = teapot_mesh(6);
        for (size_t j = 0; j < c.vertices; j++)
            c.v[j] = vadd(vscale(c.v[j], list[i].scale), list[i].move);
        items y = items_of_mesh(&c);
        kdtree u = kdtree_made(&y, kdtree_defaults);
        check_close(u.stats.references, t.stats.references, 0.02 * (double)t.stats.references,
                    "%s: as many references, but for planes that rounding moved", list[i].what);
        kdtree_free(&u);
        mesh_free(&c);
    }
    kdtree_free(&t);
    mesh_free(&m);
}

/* Leaves with items in them that the ray meets before t: each cell made larger by `spare`. */
static size_t leaves_met(const kdtree *t, uint32_t at, kd_box cell, ray r, real until, real spare)
{
    kd_node n = t->node[at];
    real enter = r.tmin, exit = until;
    for (int k = 0; k < 3; k++) {
        real o = vaxis(r.o, k), d = vaxis(r.d, k);
        real a = ((real)cell.lo[k] - spare - o) / d, b = ((real)cell.hi[k] + spare - o) / d;
        enter = real_max(real_min(a, b), enter), exit = real_min(real_max(a, b), exit);
    }
    if (enter > exit) return 0;
    if (kd_is_leaf(n)) return kd_count(n) > 0;
    kd_box lower = cell, upper = cell;
    lower.hi[kd_axis(n)] = upper.lo[kd_axis(n)] = n.plane;
    return leaves_met(t, kd_lower(n), lower, r, until, spare)
           + leaves_met(t, kd_lower(n) + 1, upper, r, until, spare);
}

/* No leaf is asked that the ray does not meet, or only behind its hit. The spare room is twice the
 * delta of (12.6), D < 32: o + delta is rounded up. Floats serve also for t: 2^-20 of it more. */
static void test_no_more(void)
{
    mesh m = teapot_mesh(8);
    items x = items_of_mesh(&m);
    kdtree t = kdtree_made(&x, kdtree_defaults);
    size_t asked_not_met = 0, asked = 0, empty = 0;
    for (size_t i = 0; i < check_count(3000); i++) {
        random_stream g = random_start(91, i, 0);
        vec3 o = vscale(random_in_cube(&g, 1), 8);
        ray r = ray_from(o, vsub(random_in_cube(&g, 3), o));
        hit h = hit_none;
        search_work w = {0, 0, 0, 0};
        real until = kdtree_hit_counted(&t, r, &h, &w) ? h.t * (1 + (real)0x1p-20) : r.tmax;
        real spare = 32 * ((real)0x1p-20 + 1024 * real_epsilon);
        asked += w.leaves, empty += w.leaves > w.tests;
        asked_not_met += w.leaves > leaves_met(&t, 0, t.box, r, until, spare);
    }
    check_equal(asked_not_met, 0, "rays that ask more leaves than they meet; %zu asked", asked);
    check_equal(empty, 0, "no empty leaf is asked");
    kdtree_free(&t);
    mesh_free(&m);
}

/* What a ray must have to spare (12.6): 256 eps D for a hit that lies off its item (14.3), 4 for t
 * of planes. Climbing has met 51 of the 256: no ray sees the rest. In double 2^-21 D is more. */
static void test_owed(void)
{
    const double eps = (double)real_epsilon;
    const aabb_frame here = {{0, 0, 0}, 1};
    const kd_box box = {{-1, -1, -1}, {1, 1, 1}};
    kd_ray q;
    kd_ray_of(ray_from((vec3){0, 0, -3}, (vec3){1, 1, 1}), &here, &box, 1, &q);  /* D = 4 */
    check_at_least((double)q.o_near[0], (256 + 4) * 4 * eps, "what is owed along x");
    check_at_most((double)q.o_far[0], -(256 + 4) * 4 * eps, "and on the far side");

    /* D is the way to the farthest of six planes: from 3 off the middle it is four times as far. */
    kd_ray_of(ray_from((vec3){0, 0, 0}, (vec3){1, 1, 1}), &here, &box, 1, &q);
    double one = (double)q.o_near[0];
    for (int k = 0; k < 6; k++) {
        vec3 o = vwith((vec3){0, 0, 0}, k / 2, k % 2 ? 3 : -3);
        kd_ray_of(ray_from(o, (vec3){1, 1, 1}), &here, &box, 1, &q);
        check_close((double)q.o_near[(k / 2 + 1) % 3], 4 * one, 1e-6 * one, "four times the way");
    }
}

int main(void)
{
    corner_test(corner_lost);
    structure_limited(kdtree, kdtree_defaults, teapot_mesh(4), 1);
    structure_piled(kdtree, kdtree_defaults, 3000, 1.2 * structure_room(3000));
    return check_all("12_kdtree", test_structures, test_naive, test_eyes, test_invariants,
                     test_clip_pays, test_round, test_limits, test_frame, test_owed, test_no_more);
}
