/* The tree itself: selection, invariants, depth, memory, the heuristic's prediction. */
#include "../chapters/14_bvh/bvh_mesh.h"
#include "../chapters/14_bvh/lab/greed_figure.h"
#include "../chapters/09_aabb/trials/survey.h"
#include "../chapters/07_mesh/scenes/soup.h"
#include "../chapters/07_mesh/scenes/specimens.h"
#include "../chapters/07_mesh/scenes/teapot.h"
#include "../common/random.h"
#include "check.h"
#include "child.h"
#include "bvh_inspect.h"
#include "corner.h"
#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <sys/resource.h>

static int rule_number(const char *name) { return (int)(bvh_rule_find(name) - bvh_rules); }

static bvh_options by_rule(int k, int leaf, double item_cost)
{
    return (bvh_options){bvh_rules[k].name, leaf, item_cost, SIZE_MAX};
}

/* Triangles of size 1/10 in a cube of half side 1. */
static mesh soup(size_t n) { return soup_mesh(n, 1, (real)0.1, 11); }

/* A set that cuts by planes peel one by one: powers of two on a line, then all of them again. */
static mesh spiral(size_t n)
{
    mesh m = mesh_room(n);
    int most = real_is_float ? 120 : 1000;
    for (size_t i = 0; i < n; i++) {
        real x = ldexp((real)1, -(int)(i % (size_t)most));
        vec3 a = {x, i % 2 ? x : 0, i % 3 ? x : 0};
        m.v[3 * i] = a, m.v[3 * i + 1] = vscale(a, 1.25);
        m.v[3 * i + 2] = (vec3){a.x, a.y + x / 4, a.z};
    }
    return m;
}

static bool corner_lost(ray r, vec3 c, bool bare)
{
    float exit;
    bvh_box box = box_between(c, c);
    box_ray q = bare ? box_ray_naive(r, &box, NULL) : box_ray_of(r, &box, NULL);
    return box_enter(&box, &q, INFINITY, &exit) > exit;
}

/* What a ray must have to spare in float for the test of 04, in eps D (14.3): 140 for t, 3 for the
 * corners. Climbing has met 51: no ray sees the rest. In double 2^-21 D is far more. */
static void test_owed(void)
{
    const double eps = (double)real_epsilon;
    const bvh_box box = {.all = EIGHT_ALL(-1)};
    box_ray q = box_ray_of(ray_from((vec3){0, 0, -3}, (vec3){1, 1, 1}), &box, NULL);  /* D = 4 */
    check_at_least((double)q.o_near[0], (140 + 3) * 4 * eps, "what is owed along x");
    check_at_least((double)q.o_far[0], (140 + 3) * 4 * eps, "and on the far side");
}

/* Boxes of points with few or awkward keys. */
static void fill_keys(bvh_item *item, size_t n, int kind)
{
    for (size_t i = 0; i < n; i++) {
        size_t half = n / 2, x = i;
        switch (kind) {
        case 1: x = n - i; break;                                  /* falling */
        case 2: x = 0; break;                                      /* all the same */
        case 3: x = i < half ? i : n - i; break;                   /* organ pipes */
        case 4: x = (size_t)(random_bits(5, i, 0, 0) % 1000003); break;
        case 5: x = i % 3; break;                                  /* three values */
        case 6: x = i % 2 ? i : half + i; break;                   /* against the median of three */
        case 7: x = i % 2 ? 0 : (size_t)(random_bits(6, i, 0, 0) % 7); break;
        default: break;
        }
        float f = (float)x;
        item[i] = (bvh_item){.low = {f, -f, 0}, .minus_high = {-f, f, 0}, .index = (uint32_t)i};
    }
}

static void test_select(void)
{
    size_t most = check_count(200000);
    bvh_item *item = allocate(most, sizeof *item);
    unsigned char *seen = allocate(most, 1);
    for (int kind = 0; kind < 8; kind++)
        for (size_t n = 1; n <= most; n = n < 24 ? n + 1 : 3 * n)
            for (size_t part = 0; part < 3; part++) {
                size_t k = part == 0 ? n / 2 : part == 1 ? 0 : n - 1, wrong = 0;
                int axis = (int)part % 2;
                fill_keys(item, n, kind);
                select_item(item, n, k, axis);
                for (size_t i = 0; i < n; i++)
                    wrong += i < k ? item_key(&item[i], axis) >= item_key(&item[k], axis)
                                   : i > k && item_key(&item[i], axis) <= item_key(&item[k], axis);
                memset(seen, 0, n);
                for (size_t i = 0; i < n; i++) wrong += seen[item[i].index]++ != 0;
                check_equal(wrong, 0, "kind %d: the %zuth of %zu items in its place", kind, k, n);
            }
    /* The slow pivot alone: something on either side, and at most half of the range of keys. */
    for (int kind = 0; kind < 8; kind++) {
        size_t n = most / 2, below = 0;
        uint64_t least = UINT64_MAX, greatest = 0;
        fill_keys(item, n, kind);
        uint64_t pivot = middle_of_all(item, n, 0);
        for (size_t i = 0; i < n; i++) {
            uint64_t key = item_key(&item[i], 0);
            below += key < pivot;
            least = key < least ? key : least, greatest = key > greatest ? key : greatest;
        }
        check(below > 0 && below < n, "kind %d: %zu of %zu below the middle", kind, below, n);
        uint64_t half = (greatest - least) / 2;
        check(pivot - least <= half + 1 && greatest - pivot <= half, "kind %d: both halves", kind);
    }
    free(item), free(seen);
}

/* ---------------------------------------------------------------------------------------------- */

static void test_invariants(const char *name, const mesh *m)
{
    static const int leaves[] = {1, 8, 255};
    for (int s = 0; s < bvh_rule_count; s++)
        for (int l = 0; l < 3; l++) {
            bvh_options how = by_rule(s, leaves[l], 1);
            bvh_mesh b = made(m, how), again = made(m, how);
            size_t n = b.tree.nodes;
            inspection x = inspect(&b, m, (size_t)leaves[l], bvh_rules[s].through);
            check_equal(x.missed, 0, "%s, %s, %d: each triangle in a leaf, uncut in one only",
                        name, bvh_rules[s].name, leaves[l]);
            check_equal(x.unused, 0, "%s, %s, %d: each node reached once", name, bvh_rules[s].name,
                        leaves[l]);
            check_equal(x.outside, 0, "%s, %s, %d: boxes hold their children and triangles", name,
                        bvh_rules[s].name, leaves[l]);
            check_equal(x.overfull + x.odd, 0, "%s, %s, %d: leaves not too full, pairs in place",
                        name, bvh_rules[s].name, leaves[l]);
            check_equal(x.deepest, b.tree.depth, "%s: depth as it is", name);
            check_at_most(b.tree.depth, bvh_most_depth, "%s, %s: depth", name, bvh_rules[s].name);
            check((uintptr_t)b.tree.node % 64 == 0, "a pair of nodes fills one line of the cache");
            check(n == again.tree.nodes
                  && memcmp(b.tree.node + 2, again.tree.node + 2, (n - 2) * sizeof(bvh_node)) == 0
                  && memcmp(b.triangle, again.triangle, b.tree.items * sizeof *b.triangle) == 0,
                  "%s, %s: built twice, the same bytes", name, bvh_rules[s].name);
            /* An item 32, a record 80, two nodes 64, and 64 for growing; references 8 times 32. */
            size_t most = bvh_rules[s].through ? 256 * m->triangles + 272 * b.tree.items
                                               : 176 * m->triangles;
            check_at_most(b.tree.held.peak, most + 4096, "%s, %s, %d: peak memory", name,
                          bvh_rules[s].name, leaves[l]);
            bvh_mesh_free(&b), bvh_mesh_free(&again);
        }
}

/* The same along all three axes, one after the other: Morton codes and bins get as deep, too. */
static mesh comb(void)
{
    mesh m = mesh_room(540);
    for (size_t i = 0; i < m.triangles; i++) {
        real x = ldexp((real)1, 60 - (int)(i / 3));
        vec3 a = {i % 3 == 0 ? x : 0, i % 3 == 1 ? x : 0, i % 3 == 2 ? x : 0};
        m.v[3 * i] = a, m.v[3 * i + 1] = vadd(a, (vec3){x / 64, 0, 0});
        m.v[3 * i + 2] = vadd(a, (vec3){0, x / 64, x / 64});
    }
    return m;
}

/* However bad the input: no leaf deeper than the stack of a search. Who gets how deep is the rule's
 * affair; that one of them would go on is what makes the input bad. */
static void test_depth(void)
{
    mesh input[2] = {spiral(2000), comb()};
    for (int i = 0; i < 2; i++) {
        int deepest = 0;
        for (int s = 0; s < bvh_rule_count; s++) {
            bvh_mesh b = made(&input[i], by_rule(s, 1, 0.01));
            check_at_most(b.tree.depth, bvh_most_depth, "powers of two, %s", bvh_rules[s].name);
            deepest = b.tree.depth > deepest ? b.tree.depth : deepest;
            bvh_mesh_free(&b);
        }
        check_at_least(deepest, 60, "input %d is as bad as it is meant to be", i);
        mesh_free(&input[i]);
    }
}

typedef struct { const mesh *m; int rule; } measured_build;

/* In a process of its own: by how much the most that the system has ever held for it grows. A small
 * tree before loads the code, which the system counts, too. glibc learns from what was freed before
 * to keep large arrays, and gaps between them; here it must not. */
static void print_growth(void *context)
{
#ifdef __GLIBC__
    mallopt(M_MMAP_THRESHOLD, 1 << 16);
#endif
    const measured_build *k = context;
    struct rusage before, after;
    bvh_mesh b;
    mesh few = *k->m;
    few.triangles = 500;
    bool built = bvh_mesh_build(&few, by_rule(k->rule, 8, 0.3), &b, NULL);
    bvh_mesh_free(&b);
    getrusage(RUSAGE_SELF, &before);
    built = built && bvh_mesh_build(k->m, by_rule(k->rule, 8, 0.3), &b, NULL);
    getrusage(RUSAGE_SELF, &after);
    printf("%ld %zu", built ? after.ru_maxrss - before.ru_maxrss : -1, b.tree.held.peak);
    bvh_mesh_free(&b);
}

/* The system's count against the tree's own. Memory that was never touched is in the second only,
 * so this bounds from one side. */
static void test_resident(void)
{
    const char *preload = getenv("LD_PRELOAD");
    bool watched = preload && strstr(preload, "vgpreload");  /* by valgrind, which takes a fifth */
#ifdef __SANITIZE_ADDRESS__
    watched = true;
#endif
    if (watched) return;
    mesh m = soup(60000);
    for (int s = 0; s < bvh_rule_count; s++) {
        if (bvh_rules[s].split && !bvh_rules[s].by_cost) continue;  /* the arrays of "sah" */
        measured_build k = {&m, s};
        m.triangles = bvh_rules[s].through ? 15000 : 60000;  /* "spatial" takes its time */
        child_result r = child_run(print_growth, &k);
        double grown = 0, peak = 0;
        /* NOLINTNEXTLINE(cert-err34-c): print_growth printed it */
        check(sscanf(r.out, "%lf %lf", &grown, &peak) == 2 && grown > 0, "%s: measured",
              bvh_rules[s].name);
        check_at_most(1024 * grown, 1.02 * peak + 512 * 1024, "%s: grown by bytes, peak as counted",
                      bvh_rules[s].name);
        check_at_least(1024 * grown, 0.3 * peak, "%s: and not far from it", bvh_rules[s].name);
    }
    mesh_free(&m);
}

static void test_memory(void)
{
    size_t n = check_count(400000);
    mesh m = soup(n);
    bvh_mesh b = made(&m, bvh_defaults), no;
    failure f;
    structure_stats s = tree_stats(&b.tree);
    check_at_most((double)s.peak / (double)n, 172, "peak bytes a triangle of %zu", n);
    check_at_least((double)s.peak, (double)(n * (sizeof(bvh_item) + sizeof *b.triangle)),
                   "items and triangles are held at the same time");
    check_equal(s.bytes, n * sizeof *b.triangle + (b.tree.nodes + b.tree.nodes % 2) * 32,
                "what is held now: 80 bytes a triangle, 32 a node");
    check_equal(s.inner + s.leaves, b.tree.nodes - 1, "a binary tree: all nodes but number 1");
    check_equal(s.leaves, s.inner + 1, "one leaf more than inner nodes");
    bvh_mesh_free(&b);
    m.triangles = n = 1000;
    for (int k = 0; k < bvh_rule_count; k++) {  /* each limit: built within it, or refused */
        bvh_options how = by_rule(k, 2, 0.3);
        b = made(&m, how);
        size_t peak = b.tree.held.peak, over = 0, wrong = 0;
        bvh_mesh_free(&b);
        for (how.most_bytes = 1; how.most_bytes < 2 * peak; how.most_bytes += peak / 41) {
            bool built = bvh_mesh_build(&m, how, &no, &f);
            wrong += !built && (how.most_bytes >= peak || f.exit_code != 1 || no.tree.node
                                || no.triangle || no.tree.items);
            over += built && no.tree.held.peak > how.most_bytes;
            bvh_mesh_free(&no);
        }
        check_equal(over + wrong, 0, "%s: most_bytes is kept (%zu over), or refused cleanly (%zu)",
                    bvh_rules[k].name, over, wrong);
    }
    mesh_free(&m);
}

static void test_refusals(void)
{
    mesh m = soup(2), huge = {.triangles = (size_t)1 << 31};
    bvh_mesh b;
    failure f;
    check(!bvh_mesh_build(&m, (bvh_options){"best", 4, 1, SIZE_MAX}, &b, &f) && f.exit_code == 2
              && strstr(f.text, "best"), "no such rule");
    bvh_options small = bvh_defaults;
    small.most_bytes = 1 << 20;
    check(!bvh_mesh_build(&huge, small, &b, &f) && f.exit_code == 1, "2^31 triangles in a MB");
    mesh_free(&m);
}

/* Both counts of (14.7) for one line: no item is tested, no hit ends it. */
static void tree_pierced_at(const bvh_tree *t, const bvh_node *n, const box_ray *q, search_work *w)
{
    float exit;
    if (box_enter(n, q, INFINITY, &exit) > exit) return;
    if (n->count) {
        w->leaves++, w->tests += n->count;
        return;
    }
    w->nodes++;
    tree_pierced_at(t, t->node + n->first, q, w);
    tree_pierced_at(t, t->node + n->first + 1, q, w);
}

static void tree_pierced(const bvh_tree *t, ray r, search_work *work)
{
    if (t->items == 0 || !ray_is_usable(r)) return;
    box_ray q = box_ray_of(r, t->node, NULL);
    tree_pierced_at(t, t->node, &q, work);
}

/* (14.7) is a mean over all lines: estimated from N of them it is off by sigma / sqrt N. */
static void test_heuristic(void)
{
    mesh m = soup(2000);
    double cost[bvh_rule_count];
    for (int s = 0; s < bvh_rule_count; s++) {
        bvh_mesh b = made(&m, by_rule(s, 4, 1));
        tree_cost st = tree_cost_of(&b.tree);
        size_t n = check_count(40000);
        const bvh_node *c = b.tree.node;
        aabb box = {{(real)c->low[0], (real)c->low[1], (real)c->low[2]},
                    {(real)box_high(c, 0), (real)box_high(c, 1), (real)box_high(c, 2)}};
        ray_set lines = rays_uniform(box, n, 21);
        double sum[2] = {0, 0}, square[2] = {0, 0}, formula[2] = {st.nodes, st.tests};
        for (size_t i = 0; i < n; i++) {
            search_work w = {0, 0, 0, 0};
            tree_pierced(&b.tree, lines.r[i], &w);
            double x[2] = {(double)w.nodes, (double)w.tests};
            for (int k = 0; k < 2; k++)
                sum[k] += x[k] / (double)n, square[k] += x[k] * x[k] / (double)n;
        }
        for (int k = 0; k < 2; k++) {
            double sigma = sqrt((square[k] - sum[k] * sum[k]) / (double)n);
            check_close(sum[k], formula[k], 4.5 * sigma + 1e-3 * formula[k],  /* 1e-3: delta */
                        "%s: %s a random line, counted and by (14.7), 4.5 standard errors",
                        bvh_rules[s].name, k ? "tests" : "nodes");
        }
        cost[s] = st.nodes + st.tests;
        rays_free(&lines);
        bvh_mesh_free(&b);
    }
    mesh_free(&m);
    /* What minimises the cost at each cut need not have the least in the end, but not much more. */
    double sah = cost[rule_number("sah")];
    check_at_most(cost[rule_number("sweep")], 1.02 * sah, "the sweep is as good as the bins");
    check_at_most(sah, 0.99 * cost[rule_number("median")], "the bins are better than the median");
}

/* Unit cubes in a row: the best tree has one and three, the greedy one pairs; the root is 50. */
static void test_four_cubes(void)
{
    mesh m = greed_cubes();
    bvh_item item[greed_four];
    uint32_t cut[2][greed_sets] = {{0}};
    for (size_t i = 0; i < greed_four; i++) (void)triangle_item(&m, i, &item[i]);
    check_close(greed_best(item, cut[1]), 82 / 50.0, 1e-6, "four cubes, the best tree");
    bvh_mesh b = made(&m, by_rule(rule_number("sah"), 1, 0.3));
    check_close(tree_cost_of(&b.tree).nodes, 86 / 50.0, 1e-6, "four cubes, the greedy tree");
    check_equal(greed_cuts(&b, 0, cut[0]), 15, "all four are in it");
    check_equal(cut[0][15], 3, "greed cuts off the first two");
    check_equal(cut[1][15], 1, "the best tree the first");
    check_equal(cut[1][14], 2, "and then the second");
    bvh_mesh_free(&b), mesh_free(&m);
}

/* What the drawing says, its marks left out, which is what the page says of it. */
static void test_greed_drawn(void)
{
    static const char *const says[] = {
        "= 60 + 12 = 72<", "= 6 + 78 = 84, dearer<", "(50 + 30 + 6) / 50 = 1.72<",
        "(50 + 26 + 6) / 50 = 1.64, cheaper<", "only 6 / 26 reach C", "(B) = 30<", "(B) = 26<"};
    static char svg[20000];
    figure g = {.out = tmpfile()};
    if (!g.out) abort();
    draw_greed_on(&g);
    child_slurp(g.out, svg, sizeof svg);
    for (size_t k = 0; k < sizeof says / sizeof *says; k++)
        check(strstr(svg, says[k]) != NULL, "the drawing of greed says %s", says[k]);
}

static void test_shared_area(void)
{
    bvh_box a = box_between(vec(0, 0, 0), vec(2, 2, 2));
    bvh_box b = box_between(vec(1, 1, 0), vec(3, 3, 2));
    bvh_box c = box_between(vec(0, 0, 3), vec(2, 2, 4));
    bvh_box d = box_between(vec(0, 5, 0), vec(2, 6, 2));
    bvh_box e = box_between(vec(2, 0, 0), vec(3, 2, 2));
    check_equal(box_shared_area(&a, &b), 1 * 1 + 1 * 2 + 2 * 1, "a box of 1 x 1 x 2 is shared");
    check_equal(box_shared_area(&a, &c), 0, "apart along z");
    check_equal(box_shared_area(&a, &d), 0, "apart along y");
    check_equal(box_shared_area(&a, &e), 4, "a side is shared: half the surface of a flat box");
}

/* The farthest corner, along its longest axis; o on any side of the box, or within. */
static void test_reach(void)
{
    size_t wrong = 0, n = 2000;
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(51, i, 0);
        bvh_box b;
        vec3 o = vec(0, 0, 0);
        real due = 0;
        for (int k = 0; k < 3; k++) {
            b.low[k] = (float)random_between(&s, -4, 4);
            b.minus_high[k] = -b.low[k] - (float)random_between(&s, 0, 2);
            o = vwith(o, k, random_between(&s, -8, 8));
        }
        for (int side = 0; side < 6; side++) {
            real off = (real)(side < 3 ? b.low[side] : box_high(&b, side - 3)) - vaxis(o, side % 3);
            due = off > due ? off : -off > due ? -off : due;
        }
        wrong += box_reach(&b, o) != due;
    }
    check_equal(wrong, 0, "how far a box reaches, of %zu", n);
}

/* Two groups of four, far apart: every rule must cut between them, and the cost follows by hand. */
static void test_closed_form(void)
{
    mesh m = mesh_room(8);
    for (size_t i = 0; i < 8; i++) {  /* triangles that fill boxes of 1 x 1 x 0, stacked in z */
        real x = i < 4 ? 0 : 15, z = (real)(i % 4) / 3;
        m.v[3 * i] = (vec3){x, 0, z}, m.v[3 * i + 1] = (vec3){x + 1, 0, z};
        m.v[3 * i + 2] = (vec3){x, 1, z};
    }
    for (int s = 0; s < bvh_rule_count; s++) {
        bvh_mesh b = made(&m, by_rule(s, 4, 0.01));
        check_equal(b.tree.nodes, 4, "two leaves of four, %s", bvh_rules[s].name);
        check(b.tree.node[2].count == 4 && b.tree.node[3].count == 4, "four and four");
        tree_cost st = tree_cost_of(&b.tree);
        /* root 16 x 1 x 1: half surface 33; a leaf 1 x 1 x 1: 3; tests 2 * 4 * 3 / 33 */
        check_close(st.tests, 24.0 / 33, 1e-6, "tests by (14.7), %s", bvh_rules[s].name);
        check_equal(st.nodes, 1, "one inner node, the root");
        bvh_mesh_free(&b);
    }
    mesh_free(&m);
}

int main(void)
{
    mesh meshes[] = {teapot_mesh(3), octahedron_mesh(6), soup(1500), spiral(1500), soup(1),
                     soup(2)};
    const char *const names[] = {"teapot", "octahedron", "soup", "spiral", "one", "two"};
    corner_test(corner_lost);
    for (size_t i = 0; i < sizeof meshes / sizeof *meshes; i++) {
        test_invariants(names[i], &meshes[i]);
        mesh_free(&meshes[i]);
    }
    bvh_mesh none = {.triangle = NULL};
    bvh_mesh_free(&none);
    return check_all("14_tree", test_owed, test_select, test_depth, test_resident, test_memory,
                     test_refusals, test_heuristic, test_closed_form, test_reach,
                     test_four_cubes, test_greed_drawn, test_shared_area);
}
