/* The tree of a mesh that moves: refitted and rotated, it is a right tree, and gives the very hits
 * of a tree built anew; what each way does to its cost. */
#include "../chapters/07_mesh/scenes/motion.h"
#include "../chapters/09_aabb/trials/aimed.h"
#include "../chapters/14_bvh/cost.h"
#include "../chapters/14_bvh/refit.h"
#include "check.h"

enum { frames = 60 };

static double cost_of(const bvh_mesh *b)
{
    tree_cost c = tree_cost_of(&b->tree);
    return c.nodes + bvh_defaults.item_cost * c.tests;
}

/* From the root: bounds that fail to contain what they should; triangles seen; the deepest leaf. */
typedef struct { const bvh_mesh *b; const mesh *m; size_t outside; unsigned char *seen; } look;

static int look_at(look *x, uint32_t at)
{
    const bvh_node *node = x->b->tree.node, *n = &node[at];
    int deepest = 0;
    for (uint32_t c = n->first; n->count == 0 && c < n->first + 2; c++) {
        for (int k = 0; k < 3; k++)
            x->outside += !(n->box.side[k] <= node[c].box.side[k]
                            && node[c].box.side[3 + k] <= n->box.side[3 + k]);
        int below = 1 + look_at(x, c);
        deepest = below > deepest ? below : deepest;
    }
    for (uint32_t i = n->first; i < n->first + n->count; i++) {
        uint32_t index = x->b->triangle[i].index;
        triangle t = mesh_triangle(x->m, index);
        const vec3 own[3] = {t.a, t.b, t.c};
        x->seen[index]++;
        for (int c = 0; c < 3; c++)
            for (int k = 0; k < 3; k++) {
                real p = vaxis(own[c], k);
                x->outside += p != vaxis(x->b->triangle[i].corner[c], k);
                x->outside += !((real)n->box.side[k] <= p && p <= (real)n->box.side[3 + k]);
            }
    }
    return deepest;
}

/* Every triangle once, corners where they are now, every box around what it holds. */
static void check_tree(const bvh_mesh *b, const mesh *m, const char *what)
{
    look x = {b, m, 0, allocate(m->triangles, 1)};
    size_t odd = 0;
    int deepest = look_at(&x, 0);
    for (size_t i = 0; i < m->triangles; i++) odd += x.seen[i] != 1;
    check_equal(x.outside, 0, "%s: boxes hold their children and their triangles of now", what);
    check_equal(odd, 0, "%s: each triangle in one leaf", what);
    check_equal(b->tree.depth, deepest, "%s: the depth it says", what);
    check_at_most(deepest, bvh_most_depth, "%s: a search can remember that", what);
    free(x.seen);
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
            bool got = bvh_mesh_hit(b, q, &h);
            wrong += !same(got, h, found, due) || bvh_mesh_occluded(b, q) != found;
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
    bvh_mesh fitted, rotated, anew;
    size_t rotations = 0, dearer = 0;
    check(bvh_mesh_build(&rest, bvh_defaults, &fitted, NULL)
          && bvh_mesh_build(&rest, bvh_defaults, &rotated, NULL), "%s: built", name);
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
        check(bvh_mesh_build(&m, bvh_defaults, &anew, NULL), "%s: built anew", name);
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
    bvh_mesh t;
    check(bvh_mesh_build(&a, bvh_leaves(1, 0.3), &t, NULL), "three triangles");
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
    mesh m;
    bvh_mesh t;
    size_t rotations = 0;
    for (int i = 0; i < n; i++) place[i] = ldexp((real)1, i % 100);
    m = line_of(place, n);
    check(bvh_mesh_build(&m, (bvh_options){"longest", 1, 0.01, SIZE_MAX}, &t, NULL), "built");
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
    bvh_mesh t, anew;
    check(bvh_mesh_build(&none, bvh_defaults, &t, NULL), "an empty tree");
    check_equal(bvh_mesh_refit(&t, &none, true), 0, "stays empty");
    bvh_mesh_free(&t);
    check(bvh_mesh_build(&m, bvh_leaves(1, 0.01), &t, NULL), "built");
    for (int round = 0; round < 4; round++) {
        if (round % 2) m.v[7] = was;
        else m.v[7].x = round ? real_infinity : (real)NAN;
        for (int k = 0; k < 2; k++) {
            bvh_mesh_refit(&t, &m, k);
            check(bvh_mesh_build(&m, bvh_defaults, &anew, NULL), "built anew");
            check_hits(&t, &anew, &m, round % 2 ? "whole again" : "a corner that is no number");
            check(memcmp(&t.tree.node[0].box, &anew.tree.node[0].box, sizeof(bvh_box)) == 0,
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
    bvh_mesh t, anew;
    how.rule = "spatial";
    check(bvh_mesh_build(&rest, how, &t, NULL), "built");
    motion_frame(MOTION_TWIST, &rest, 0.25, &m);
    bvh_mesh_refit(&t, &m, true);
    check(bvh_mesh_build(&m, how, &anew, NULL), "built anew");
    check_hits(&t, &anew, &m, "spatial");
    bvh_mesh_free(&t), bvh_mesh_free(&anew);
    mesh_free(&rest), mesh_free(&m);
}

int main(void)
{
    test_one_rotation();
    test_motion(MOTION_TWIST, 6);
    test_motion(MOTION_SCATTER, 2);
    test_depth();
    test_odd();
    test_spatial();
    return check_report("14_refit");
}
