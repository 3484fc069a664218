/* The first wide BVH: brute force's hits; fewer nodes than the binary tree; wrong far away. */
#include "../chapters/15_wide_bvh/first.h"
#include "../chapters/15_wide_bvh/bvh8.h"
#include "first_structure.h"

STRUCTURE_TESTED(bvh8, bvh8_defaults)

FIRST_STRUCTURE(first_wide, *s = first_wide_build(m))
static size_t nodes_of(const void *s) { return (size_t)((const first_wide *)s)->nodes; }

static int depth_below(const first_wide *w, int at)
{
    int most = 0;
    for (int i = 0; i < first_width; i++)
        if (w->node[at].child[i] > 0) {
            int d = 1 + depth_below(w, w->node[at].child[i]);
            if (d > most) most = d;
        }
    return most;
}

static int depth_of(const void *s) { return depth_below(s, 0); }
static double most_depth(double log_n) { return log_n; }

/* A node of the binary tree is opened away, or is a leaf, or becomes a node. */
static void test_collapse(void)
{
    first_mesh m = first_knot(60, 12);
    first_wide w = first_wide_build(&m);
    int inner = 0, leaves = 0;
    for (int i = 0; i < w.binary.nodes; i++) inner += w.binary.node[i].left != 0;
    for (int i = 0; i < w.nodes; i++)
        for (int c = 0; c < first_width; c++) leaves += w.node[i].child[c] < 0;
    check_equal(leaves, w.binary.nodes - inner, "every leaf of the binary tree is a child once");
    check_at_most(w.nodes, 0.6 * inner, "four wide: about half of the inner nodes remain");
    first_wide_free(&w);
    first_mesh_free(&m);
}

int main(void)
{
    structure full = {"BVH, eight wide", STRUCTURE_OF(bvh8)};
    first_structure s = {"first wide BVH", FIRST_VERBS(first_wide), nodes_of, depth_of, 1,
                         most_depth};
    first_structure_tests(&s, &full);
    test_collapse();
    return check_report("15_first");
}
