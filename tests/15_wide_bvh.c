/* The tree eight wide against brute force, in every dialect that the machine has; that nothing is
 * lost in it, the same tree for any number of threads, and what the leaky search loses. */
#include "../common/posix.h"
#include <pthread.h>
#include <signal.h>
static int interrupt_at, created;  /* Ctrl-C as this thread is made; the first is 1 */
static int interrupted_create(pthread_t *t, const pthread_attr_t *a, void *(*run)(void *), void *x)
{
    if (++created == interrupt_at) raise(SIGINT);
    return pthread_create(t, a, run, x);
}
#define pthread_create interrupted_create
#include "../chapters/15_wide_bvh/lab/leaky.h"
#include "../chapters/15_wide_bvh/lab/stream.h"
#include "structure.h"

static bvh8_options options_now;
STRUCTURE_TESTED(bvh8, options_now)

static const char *const dialect_name[eight_dialects] = {"plain C", "AVX2", "AVX-512"};

/* Each dialect; smaller leaves in one of them: they are the same to the search. */
static void test_structures(void)
{
    for (int d = EIGHT_PLAIN; d <= (int)eight_best(); d++)
        for (int leaf = d == EIGHT_PLAIN ? 1 : 8; leaf <= 8; leaf *= 2) {
            char name[40];
            structure s = {name, STRUCTURE_OF(bvh8)};
            options_now = bvh8_defaults;
            options_now.dialect = (eight_dialect)d, options_now.leaf = leaf;
            snprintf(name, sizeof name, "%s, leaves of %d", dialect_name[d], leaf);
            structure_tests(&s, check_count(leaf == 8 ? 800 : 160));
        }
}

/* Boxes that are points, which the ray meets, in the tree's frame: corners and origin nearly 1 and
 * on opposite sides, where all roundings of (15.6) are at their largest. */
static void test_corners(void)
{
    const bvh8 w = {.frame.scale = 1};
    size_t lost[2] = {0, 0}, rays = check_count(3000000);
    for (size_t i = 0; i < rays; i++) {
        random_stream g = random_start(82, i, 0);
        real o[3], c[3], t = (1 + random_next(&g) / 16) / 2;
        bvh8_node n;
        for (int k = 0; k < 3; k++) {
            c[k] = (real)(float)(1 - random_next(&g) / 50);
            o[k] = (real)-1.03 + random_next(&g) / 50;
            if (random_next_bits(&g) & 1) c[k] = -c[k], o[k] = -o[k];
            for (int j = 0; j < 8; j++) n.side[k][j] = n.side[k + 3][j] = (float)c[k];
        }
        vec3 from = {o[0], o[1], o[2]}, to = {c[0], c[1], c[2]};
        ray r = ray_from(from, vscale(vsub(to, from), 1 / t));
        bvh8_ray q;
        eight enter;
        bvh8_ray_of(&w, &r, &bvh8_skip_none, &q);
        for (int bare = 0; bare < 2; bare++) {
            for (int k = 0; k < 3 && bare; k++)
                q.near_o[k] = q.far_o[k] = 0.5f * q.near_o[k] + 0.5f * q.far_o[k];
            lost[bare] += __builtin_popcountll(bvh8_boxes_0(&n, &q, &enter)) != 8;
        }
    }
    check_equal(lost[0], 0, "corners of boxes: %zu rays, lost", rays);
    check_at_least(lost[1], rays / 10, "lost without what is added");
}

/* ---- the bounds of ray8.h. No ray has met half of them: roundings do not all conspire. So it is
 * asked where doubt begins, and that must not be nearer than the sum of what is owed. u = 2^-24. */

#define u24 0x1p-24
#define eps ((double)real_epsilon)

/* A triangle in the frame, corners (0, -a), (0, a), (b, 0) and z; a ray along z from z = -1. */
typedef struct { double a, b, z[3], x, tmax; } doubtful;

static bool in_doubt(doubtful c, bvh8_ray *q)
{
    const double v[9] = {0, -c.a, c.z[0], 0, c.a, c.z[1], c.b, 0, c.z[2]};
    bvh8_block one = {.index = {0}};
    const bvh8 w = {.frame.scale = 1, .exact = true, .block = &one};
    for (int j = 0; j < 9; j++) one.corner[j][0] = (float)v[j];
    for (int k = 1; k < 8; k++) one.index[k] = no_shape;
    ray r = {vec(c.x, 0, -1), 0, {0, 0, 1}, (real)c.tmax};
    size_t before = bvh8_asked;
    bvh8_ray_of(&w, &r, &bvh8_skip_none, q);
    bvh8_triangles_0(&w, &one, q, true);
    return bvh8_asked > before;
}

/* *at is a member of c: where between its value, in doubt, and `no` does doubt end? */
static double doubt_ends(doubtful *c, double *at, double no)
{
    bvh8_ray q;
    for (double yes = *at, i = 0; i < 50; i++) {
        *at = (yes + no) / 2;
        if (in_doubt(*c, &q)) yes = *at;
        else no = *at;
    }
    return no;
}

static void test_bounds(void)
{
    bvh8_ray q;
    doubtful c = {1, 1, {0, 0, 0}, 0, 100};
    check(in_doubt(c, &q), "on an edge: in doubt");
    double around = (double)q.around;
    check_at_least(around, 20 * u24 + 16 * eps, "(15.7), S = 1");
    double delta = (double)(q.far_o[2] - q.near_o[2]) / 2;  /* 1 / d = 1; rounded */
    check_at_least(delta, 10 * u24 + 512 * eps - u24, "(15.6)");
    double h = doubt_ends(&c, &c.x, 0.01);  /* e = 2 h, |x|, |y| <= 1 */
    check_at_least(2 * h, 4 * around + 2 * around * around + 16 * u24, "(15.8), a hit");
    c = (doubtful){8 * around, 4 * around, {0, 0, 0}, 0, 100};
    h = -doubt_ends(&c, &c.x, -4 * around);  /* beside a tiny one: e = 2 a h, m = a */
    check_at_least(2 * c.a * h, (4 * 8 + 2) * around * around, "(15.8), a miss");
    c = (doubtful){1, 1, {0, 0, 0}, 0.25, 1};
    double flat = doubt_ends(&c, &c.tmax, 1.1) - 1;
    check_at_least(flat, 17 * u24 + 280 * eps, "(15.9): 17 roundings; t of 04, 140 eps of 2 S");
    c = (doubtful){1, 1, {-0.5, 0.5, 0}, 0.25, 1};
    double tilted = doubt_ends(&c, &c.tmax, 1.1) - 1;  /* spread 1, det 2, m 1 */
    check_at_least(tilted - flat, 0.99 * 4 * (4 * around + 16 * u24) / 2, "(15.9), tilted");
    size_t wrong = 0;
    bvh8_ray unit = {.scale = 1};
    for (size_t i = 0; i < check_count(8000); i++) {
        real x = 1 + random_real_of(random_mix(i));
        double low = (double)x * (1 - 2 * u24), high = (double)x * (1 + 2 * u24);
        bvh8_interval(&unit, &(ray){.tmin = x, .tmax = x});
        wrong += !((double)unit.tmin <= low && (double)unit.sure_max <= low);
        wrong += !((double)unit.limit >= high && (double)unit.sure_min >= high);
        wrong += !((double)bvh8_limit(&unit, x) >= high);
    }
    check_equal(wrong, 0, "the ends of an interval leave two roundings, whatever x");
    const bvh8 w = {.frame.scale = 1};
    ray r = ray_from((vec3){0, 0, -65536}, (vec3){0, 0, 1});
    bvh8_ray_of(&w, &r, &bvh8_skip_none, &q);
    check_at_least(q.slack, 3 * eps * 65536, "far away: the place is off by 3 eps of the way");
    for (int k = 0; k < 6; k++) {  /* S is the farthest coordinate of the origin, on either side */
        ray side = ray_from(vwith(vec(0, 0, 0), k % 3, k < 3 ? 5 : -5), vec(1, 1, 1));
        bvh8_ray_of(&w, &side, &bvh8_skip_none, &q);
        double off = (double)(q.far_o[k % 3] - q.near_o[k % 3]) / 2;
        check_at_least(off, 5 * (10 * u24 + 512 * eps - u24), "(15.6), S = 5, side %d", k);
    }
}

/* Every item once; every box around what is below it; blocks hold what they name. */
static void count_items(const bvh8 *w, uint32_t at, const float *box, size_t *seen, size_t *outside)
{
    if (at & bvh8_leaf) {
        const bvh8_block *b = &w->block[at & ~bvh8_leaf];
        for (int k = 0; k < 8; k++) {
            if (b->index[k] == no_shape) continue;
            seen[b->index[k]]++;
            triangle t = mesh_triangle(w->x.m, b->index[k]);
            const vec3 p[3] = {frame_into(&w->frame, t.a), frame_into(&w->frame, t.b),
                               frame_into(&w->frame, t.c)};
            for (int j = 0; j < 9; j++) {
                real x = vaxis(p[j / 3], j % 3);
                *outside += x < (real)box[j % 3] || x > (real)box[3 + j % 3];
                *outside += b->corner[j][k] != (float)x;
            }
        }
        return;
    }
    const bvh8_node *n = &w->node[at];
    for (int k = 0; k < 8; k++) {
        float part[6];
        for (int s = 0; s < 6; s++) part[s] = n->side[s][k];
        if (part[0] > part[3]) continue;
        for (int s = 0; s < 3; s++) *outside += part[s] < box[s] || part[3 + s] > box[3 + s];
        count_items(w, n->child[k], part, seen, outside);
    }
}

static int deepest(const bvh8 *w, uint32_t at)
{
    int below = 0;
    if (at & bvh8_leaf) return 0;
    for (int k = 0; k < 8; k++) {
        if (w->node[at].side[0][k] > w->node[at].side[3][k]) continue;
        int d = deepest(w, w->node[at].child[k]);
        below = d > below ? d : below;
    }
    return below + 1;
}

static void invariants_of(const char *what, mesh m)
{
    items x = items_of_mesh(&m);
    failure f;
    bvh8 again;
    bvh8_options how = bvh8_defaults;
    how.threads = 1;
    bvh8 w = bvh8_made(&x, how);
    size_t *seen = allocate(m.triangles, sizeof *seen), outside = 0, wrong = 0, held = 0;
    const float all[6] = {-INFINITY, -INFINITY, -INFINITY, INFINITY, INFINITY, INFINITY};
    count_items(&w, 0, all, seen, &outside);
    bool floats = true;
    for (size_t i = 0; i < m.triangles; i++) {
        triangle t = mesh_triangle(&m, i);
        bool due = !vzero(triangle_cross(t.a, t.b, t.c));
        held += due, wrong += seen[i] != due;
        for (int j = 0; j < 9; j++) {
            real c = vaxis((&t.a)[j / 3], j % 3);
            floats &= !due || (real)(float)c == c;
        }
    }
    check_equal(wrong, 0, "%s: every triangle of some area is in one leaf, others in none", what);
    check_equal(outside, 0, "%s: boxes hold what is below them, and blocks their triangles", what);
    check_equal(w.exact, floats, "%s: blocks hold the very corners, if these are floats", what);
    structure_stats s = bvh8_stats(&w);
    check_equal(s.items, held, "%s: counted", what);
    check_at_most(s.depth, 64, "%s: depth", what);
    check_equal(s.depth, deepest(&w, 0), "%s: the deepest node", what);
    check_equal(s.bytes, w.nodes * sizeof *w.node + w.blocks * sizeof *w.block
                + w.patches * sizeof *w.patch, "%s: bytes", what);
    check_at_least(s.peak, s.bytes + held * (3 * sizeof(bvh_node) + 2 * 8),
                   "%s: items, nodes of two and their picks are held at the same time", what);
    for (size_t i = 0; i < 8 * w.blocks; i++) held -= w.block[i / 8].index[i % 8] != no_shape;
    check_equal(held, 0, "%s: in all blocks together", what);
    for (how.threads = 2; how.threads < 8; how.threads += 3) {
        check(bvh8_build(&x, how, &again, &f), "%s: built by %d threads", what, how.threads);
        bool alike = again.nodes == w.nodes && again.blocks == w.blocks
            && !memcmp(again.block, w.block, w.blocks * sizeof *w.block);
        for (size_t i = 0; alike && i < w.nodes; i++)
            alike = !memcmp(&again.node[i], &w.node[i], offsetof(bvh8_node, child[8]));
        check(alike, "%s: %d threads make the same tree, to the last byte", what, how.threads);
        bvh8_free(&again);
    }
    bvh8_free(&w);
    bvh8_free(&w);
    free(seen);
    mesh_free(&m);
}

static void test_invariants(void)
{
    invariants_of("teapot", teapot_mesh(8));
    invariants_of("needles", needles(5000, 1e-4));
    invariants_of("a fan", structure_fan(5000));
    invariants_of("planes", floors_mesh(8));
    invariants_of("one triangle", needles(1, 0.5));
    mesh m = mesh_room(3000);
    for (size_t i = 0; i < m.triangles; i++)
        set_triangle(&m, i, (vec3){0, 0, 1}, (vec3){1, 0, 1},
                     i % 7 ? (vec3){0, 1, i % 3 == 2 ? 2 : 1} : (vec3){2, 0, 1});  /* a line */
    invariants_of("coincident triangles", m);
}

/* Two groups of items: the cut lies between them, and they are parted by it. Area, bins by hand. */
static void test_split(void)
{
    bvh_item item[16], box = box_between(vec(1, 2, 3), vec(2, 4, 6));
    splitter s = {.block = 3, .by_size = 1};
    check_equal(box_area(&box), 1 * 2 + 2 * 3 + 3 * 1, "half the surface of 1 x 2 x 3");
    check_equal(item_centre(&box, 1), 2 + 4, "twice its middle");
    check_equal(item_size(&box), 1 + 2 + 3, "its size");
    check_equal(split_side(&s, &box, 8), 11, "eight are one test");
    check_equal(split_side(&s, &box, 9), 22, "nine are two");
    for (int i = 0; i < 16; i++) {  /* ten on the left, not in order */
        float x = (float)i / 64 + (i * 7 % 16 < 10 ? 0.0f : 0.5f);
        item[i] = (bvh_item){.low = {x, 0, 0}, .minus_high = {-x - 0.01f, -1, -1}};
    }
    split_measure(&s, item, 16);
    check_equal(s.ways, 4, "at the root by size, too");
    check_equal(split_binned(&s, item, 16), 10, "the cut is between the groups");
    size_t beyond = 0, astray = 0;
    for (int i = 0; i < 16; i++)
        beyond += (unsigned)bin_of(&s, &item[i], 0) >= (unsigned)s.bins;
    check(s.bins == bins_for(16) && beyond == 0, "%d bins, items beyond them: %zu", s.bins, beyond);
    for (int i = 0; i < 16; i++) astray += (item[i].low[0] < 0.4f) != (i < 10);
    check_equal(astray, 0, "each group on its side");
    shape one = shape_of_sphere((sphere){{0, 0, 0}, 1});
    scene world = {&one, 1};
    items x = items_of_scene(&world);
    bvh8 w = bvh8_made(&x, bvh8_defaults);
    hit h;
    check(bvh8_hit(&w, ray_from(vec(0, 0, -3), vec(0, 0, 1)), &h) && h.t == 2, "one shape alone");
    bvh8_free(&w);
}

/* Walls, and small things that stand somewhere in the midst: no block holds both, though their
 * middles lie side by side. */
static void test_sizes(void)
{
    mesh m = mesh_room(200);
    size_t mixed = 0;
    for (size_t i = 0; i < m.triangles; i++) {
        random_stream g = random_start(15, i, 0);
        vec3 at = random_in_cube(&g, (real)0.5), out = {0, 0, 0};
        if (i >= 12) {
            vec3 side = random_in_cube(&g, (real)0.05);
            set_triangle(&m, i, at, vadd(at, side), vadd(at, random_in_cube(&g, (real)0.05)));
            continue;
        }
        int k = (int)i % 3;  /* two triangles of each of six walls */
        out = vwith(out, k, i < 6 ? 1 : -1);
        vec3 s = vwith((vec3){0, 0, 0}, (k + 1) % 3, i / 3 % 2 ? 1 : -1);
        vec3 t = vwith((vec3){0, 0, 0}, (k + 2) % 3, i / 3 % 2 ? 1 : -1);
        set_triangle(&m, i, vsub(vadd(out, s), t), vadd(vadd(out, s), t), vadd(vsub(out, s), t));
    }
    items x = items_of_mesh(&m);
    bvh8 w = bvh8_made(&x, bvh8_defaults);
    for (size_t i = 0; i < w.blocks; i++) {
        bool large = false, small = false;
        for (int k = 0; k < 8; k++)
            if (w.block[i].index[k] != no_shape)
                *(w.block[i].index[k] < 12 ? &large : &small) = true;
        mixed += large && small;
    }
    check_equal(mixed, 0, "of %zu blocks hold walls and small things", w.blocks);
    bvh8_free(&w), mesh_free(&m);
}

/* Powers of two along three axes, on the one side or the other: as deep as it gets, see 14. */
static void test_depth(void)
{
    bvh8_options how = bvh8_defaults;
    how.width = 2, how.leaf = 1;
    for (int sign = -1; sign < 2; sign += 2) {
        mesh m = mesh_room(360);
        for (size_t i = 0; i < m.triangles; i++) {
            real x = (real)sign * ldexp((real)1, 29 - (int)(i / 3));
            vec3 a = {i % 3 == 0 ? x : 0, i % 3 == 1 ? x : 0, i % 3 == 2 ? x : 0};
            set_triangle(&m, i, a, vadd(a, vec(x / 64, 0, 0)), vadd(a, vec(0, x / 64, x / 64)));
        }
        items x = items_of_mesh(&m);
        bvh8 w = bvh8_made(&x, how);
        check_at_most(w.depth, bvh_most_depth, "powers of two: depth");
        check_at_least(w.depth, 50, "and as bad as they are meant to be");
        bvh8_free(&w), mesh_free(&m);
    }
}

/* Nodes whose own boxes the ray meets, in `real`. */
static size_t nodes_met(const bvh8 *w, uint32_t at, ray r)
{
    size_t n = 1;
    real enter;
    if (at & bvh8_leaf) return 0;
    for (int k = 0; k < 8; k++) {
        aabb b;
        for (int s = 0; s < 3; s++)
            ((real *)&b.lo)[s] = (real)w->node[at].side[s][k],
            ((real *)&b.hi)[s] = (real)w->node[at].side[3 + s][k];
        if (!aabb_is_empty(b) && aabb_hit(b, r, &enter)) n += nodes_met(w, w->node[at].child[k], r);
    }
    return n;
}

/* In counts: a ray that hits nothing opens the nodes that it meets; one that hits, little more than
 * if it ended there from the start; and few triangles are asked in `real`. */
static void test_cost(void)
{
    mesh m = teapot_mesh(8);
    items x = items_of_mesh(&m);
    bvh8 w = bvh8_made(&x, bvh8_defaults);
    search_work missed = {0, 0, 0, 0}, whole = missed, ended = missed;
    size_t met = 0, hits = 0, asked_any = 0, before = bvh8_asked;
    for (size_t i = 0; i < check_count(8000); i++) {
        ray r = structure_across(47, i, 6, 2);
        search_work work = {0, 0, 0, 0};
        hit h;
        if (!bvh8_hit_counted(&w, r, &h, &work)) {
            missed.nodes += work.nodes;
            r.o = frame_into(&w.frame, r.o), met += nodes_met(&w, 0, r);
            continue;
        }
        whole.nodes += work.nodes, whole.tests += work.tests, hits++;
        size_t asked = bvh8_asked;
        bvh8_occluded(&w, r), asked_any += bvh8_asked - asked, bvh8_asked = asked;
        r.tmax = h.t, bvh8_hit_counted(&w, r, &h, &ended);
    }
    check_at_least(missed.nodes, met, "nodes of rays that hit nothing");
    check_at_most(missed.nodes, met + met / 50, "and not more than they meet");
    check_at_most(whole.nodes, ended.nodes + ended.nodes / 20, "nodes, and of rays that end there");
    check_at_most(bvh8_asked - before, 2 * hits + hits / 5, "one triangle a hit asked in `real`");
    check_at_most(asked_any, hits / 5, "and hardly one of shadow rays");
    bvh8_free(&w), mesh_free(&m);
}

/* Into a closed mesh at its corners and edges: brute force hits always, the leaky search does not;
 * where it hits, t is right to six digits or so. */
static void test_leaks(void)
{
    mesh m = octahedron_mesh(16);
    items x = items_of_mesh(&m);
    bvh8 w = bvh8_made(&x, bvh8_defaults);
    size_t lost = 0, rays = check_count(20000), far = 0, lost_any = 0;
    for (size_t i = 0; i < rays; i++) {
        random_stream g = random_start(41, i, 0);
        vec3 o = vscale(random_in_cube(&g, 1), 4);
        triangle t = mesh_triangle(&m, random_below(&g, m.triangles));
        vec3 at = vmadd(t.a, vsub(t.b, t.a), i % 2 ? random_next(&g) : 0);
        ray r = ray_from(o, vsub(at, o));
        hit a = hit_none, b = hit_none;
        bool due = mesh_hit(&m, r, &a), got = bvh8_hit_leaky(&w, r, &b);
        lost += due && !got, lost_any += due && !bvh8_occluded_leaky(&w, r);
        if (due && got) far += fabs(a.t - b.t) > (real)1e-3;
    }
    check_at_least(lost, rays / 2000, "the leaky search loses rays at edges and corners");
    check_at_least(lost_any, rays / 2000, "and so does its shadow");
    check_at_most(far, rays / 20, "but where it hits, t is near the true one, or on the far side");
    bvh8_free(&w);
    mesh_free(&m);
}

/* Rays that have nothing in common, some of them none, one to eight together: each gets its own
 * hit; an empty tree gives none. */
static void test_streams(void)
{
    mesh m = octahedron_mesh(16), none = {0};
    items x = items_of_mesh(&m), nothing = items_of_mesh(&none);
    bvh8 w = bvh8_made(&x, bvh8_defaults), empty = bvh8_made(&nothing, bvh8_defaults);
    size_t wrong = 0, rays = check_count(4000), hits = 0, any = 0;
    for (size_t i = 0; i < rays; i++) {
        random_stream g = random_start(42, i, 0);
        ray r[stream_rays];
        hit out[stream_rays];
        stream_work work = {0, 0};
        int n = 1 + (int)(i % stream_rays);
        for (int k = 0; k < n; k++) {
            vec3 o = vscale(random_in_cube(&g, 1), k == 5 ? 2000 : 4);
            triangle t = mesh_triangle(&m, random_below(&g, m.triangles));
            r[k] = ray_from(o, k == 3 && i % 5 == 0 ? vec(0, 0, 0) : vsub(t.a, o));
            if (k == 6) r[k].tmax = (real)0.99;
        }
        bvh8_hit_stream(&w, r, n, out, &work);
        for (int k = 0; k < n; k++) {
            hit h;
            bool due = bvh8_hit(&w, r[k], &h);
            hits += due;
            wrong += !same(due, h, out[k].shape != no_shape, out[k]);
        }
        bvh8_hit_stream(&empty, r, n, out, &work);
        for (int k = 0; k < n; k++) any += out[k].shape != no_shape;
    }
    check_at_least(hits, rays, "most of them hit");
    check_equal(wrong, 0, "together or one by one: the same hits");
    check_equal(any, 0, "nothing is hit where nothing is");
    bvh8_free(&w), bvh8_free(&empty);
    mesh_free(&m);
}

/* A ray from far away is moved to where it is near (ray8.h), and its interval with it: the nearest
 * of three faces is asked in `real`, and no other; a shadow ray asks none. */
static void test_far(void)
{
    mesh m = mesh_room(3);
    for (size_t i = 0; i < m.triangles; i++) {
        real z = (real)i / 4;
        set_triangle(&m, i, (vec3){-1, -1, z}, (vec3){1, -1, z}, (vec3){0, 1, z});
    }
    items x = items_of_mesh(&m);
    bvh8 w = bvh8_made(&x, bvh8_defaults);
    size_t rays = check_count(800), met = 0, asked = 0, asked_any = 0;
    for (size_t i = 0; i < rays; i++) {
        random_stream g = random_start(43, i, 0);
        vec3 at = vscale(random_in_cube(&g, 1), (real)0.2);
        ray r = ray_from((vec3){at.x, at.y, -1000}, (vec3){0, 0, 1});
        hit h = hit_none;
        size_t before = bvh8_asked;
        met += bvh8_hit(&w, r, &h) && h.shape == 0;
        asked += bvh8_asked - before, before = bvh8_asked;
        met += bvh8_occluded(&w, r);
        asked_any += bvh8_asked - before;
    }
    check_equal(met, 2 * rays, "from far away: the nearest face");
    check_equal(asked, rays, "from far away: one face asked a ray");
    check_equal(asked_any, 0, "from far away: no face asked by shadow rays");
    bvh8_free(&w);
    mesh_free(&m);
}

/* Origins and directions of any size, along axes or nearly: where a product with them overflows,
 * a box is in doubt, and an empty place is still none. Beside every item. */
static void test_wild(void)
{
    const double most = real_is_float ? 37 : 307;
    mesh m = mesh_room(100);
    for (size_t i = 0; i < m.triangles; i++) {
        random_stream g = random_start(44, i, 0);
        vec3 a = random_in_cube(&g, 1), b = random_in_cube(&g, 1), c = random_in_cube(&g, 1);
        set_triangle(&m, i, a, b, c);
    }
    items x = items_of_mesh(&m);
    size_t rays = check_count(40000), wrong[eight_dialects] = {0}, hits = 0;
    for (int d = EIGHT_PLAIN; d <= (int)eight_best(); d++) {
        bvh8_options how = bvh8_defaults;
        how.dialect = (eight_dialect)d;
        bvh8 w = bvh8_made(&x, how);
        for (size_t i = 0; i < rays; i++) {
            random_stream g = random_start(45, i, 0);
            real o[3], to[3];
            for (int k = 0; k < 3; k++) {
                double u[5];
                for (int j = 0; j < 5; j++) u[j] = (double)random_next(&g);
                o[k] = (real)(u[0] < 0.5 ? pow(10, most * u[1]) : u[1]);
                to[k] = (real)(u[2] < 0.7 ? pow(10, -most * u[3]) : u[3]);
                if (u[4] < 0.3) to[k] = -o[k];
            }
            ray r = ray_from((vec3){o[0], o[1], o[2]}, (vec3){to[0], to[1], to[2]});
            hit h = hit_none, all = hit_none;
            bool met = bvh8_hit(&w, r, &h), truth = items_hit(&x, r, &all);
            hits += truth;
            wrong[d] += met != truth || h.shape != all.shape || bvh8_occluded(&w, r) != truth;
        }
        check_equal(wrong[d], 0, "%s: any origin, any direction", dialect_name[d]);
        bvh8_free(&w);
    }
    check_at_least(hits, rays / 20, "some hit");
    mesh_free(&m);
}

/* Of three faces in a row, or two with a ball between: one that the ray starts on, a few that its
 * end lies on, both. */
static void test_left_out(void)
{
    static const struct { bvh8_skip but; uint32_t first; } list[] = {
        {{no_shape, no_shape, no_shape}, 0}, {{0, no_shape, no_shape}, 1}, {{2, 0, 1}, no_shape},
        {{1, 0, 0}, 2}, {{no_shape, 0, 1}, 2}, {{1, 2, 2}, 0}, {{no_shape, 0, 2}, no_shape}};
    mesh m = mesh_room(3);
    for (size_t i = 0; i < m.triangles; i++)
        set_triangle(&m, i, (vec3){-1, -1, (real)i}, (vec3){1, -1, (real)i}, (vec3){0, 1, (real)i});
    shape in_row[3] = {shape_of_triangle(mesh_triangle(&m, 0)),
                       shape_of_sphere((sphere){{0, 0, 1}, (real)0.25}),
                       shape_of_triangle(mesh_triangle(&m, 2))};
    scene s = {in_row, 3};
    ray r = ray_from((vec3){0, 0, -1}, (vec3){0, 0, 1});
    for (int d = 2 * EIGHT_PLAIN; d <= 2 * (int)eight_best() + 1; d++) {
        items x = d % 2 ? items_of_scene(&s) : items_of_mesh(&m);
        bvh8_options how = bvh8_defaults;
        how.dialect = (eight_dialect)(d / 2);
        bvh8 w = bvh8_made(&x, how);
        for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
            hit h = hit_none;
            bool met = bvh8_ask(&w, r, list[i].but, &h, NULL);
            check_equal(h.shape, list[i].first, "%s, left out %zu: the next", dialect_name[d / 2],
                        i);
            check(met == (list[i].first != no_shape)
                  && bvh8_ask(&w, r, list[i].but, NULL, NULL) == met,
                  "left out %zu: met at all", i);
        }
        bvh8_free(&w);
    }
    mesh_free(&m);
}

static void test_options(void)
{
    mesh m = octahedron_mesh(2);
    items x = items_of_mesh(&m);
    failure f;
    bvh8 w;
    for (int i = 0; i < 4; i++) {
        bvh8_options how = bvh8_defaults;
        int *member = i < 2 ? &how.leaf : &how.width;
        *member = i % 2 ? 33 : i == 2 ? 1 : 0;
        check(!bvh8_build(&x, how, &w, &f), "option %d out of range: refused", i);
        bvh8_free(&w);
    }
    mesh_free(&m);
}

/* Half a tree is none, whichever step Ctrl-C meets: 1, boxes; 2, binary tree; 3, blocks; 4, after
 * all of them. */
static void test_interrupted(void)
{
    mesh m = octahedron_mesh(32);
    items x = items_of_mesh(&m);
    bvh8_options how = bvh8_defaults;
    how.threads = 2;
    signal(SIGINT, SIG_DFL);  /* in the background it may be ignored, and stays so (parallel.h) */
    for (interrupt_at = 1; interrupt_at <= 4; interrupt_at++) {
        failure f = {0};
        bvh8 w;
        created = 0;
        bool built = bvh8_build(&x, how, &w, &f);
        check(built == (interrupt_at == 4), "Ctrl-C in step %d: built or not", interrupt_at);
        if (!built) check_equal(f.exit_code, 130, "Ctrl-C in step %d: exit code", interrupt_at);
        check_equal(w.held, built ? x.n : 0, "Ctrl-C in step %d: triangles held", interrupt_at);
        bvh8_free(&w);
    }
    interrupt_at = 0;
    mesh_free(&m);
}

int main(void)
{
    structure_limited(bvh8, bvh8_defaults, octahedron_mesh(16), 1);
    return check_all("15_wide_bvh", test_options, test_interrupted, test_structures, test_corners,
                     test_bounds, test_invariants, test_leaks, test_streams, test_far,
                     test_wild, test_left_out, test_split, test_sizes, test_depth, test_cost);
}
