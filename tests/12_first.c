/* The first k-d tree: brute force's hits; depth by (12.2), few items; wrong far away. */
#include "../chapters/07_mesh/scenes/teapot.h"
#include "../chapters/12_kdtree/first.h"
#include "../chapters/12_kdtree/kdtree.h"
#include "first_structure.h"

STRUCTURE_TESTED(kdtree, kdtree_defaults)

FIRST_STRUCTURE(first_kdtree, first_kdtree_build(m, s))
FIRST_TREE(first_kdtree, first_kd_node, 2, n->child ? 0 : n->n)
static double most_depth(double log_n) { return 8 + 1.3 * log_n; }

/* Of a coarse teapot most triangles reach across the middle of each half, so both stay leaves: the
 * peak at 240 triangles in 17's table of growth. */
static void test_two_leaves(void)
{
    mesh m = teapot_mesh(2);
    first_mesh f = first_mesh_of(&m);
    first_kdtree t;
    first_kdtree_build(&f, &t);
    check_equal(f.n, 240, "triangles");
    check_equal(t.leaves, 2, "leaves: one cut");
    int axis = t.root.axis, most = (int)fmax(t.root.child[0].n, t.root.child[1].n), reach[2] = {0};
    for (int i = 0; i < f.n; i++) {
        aabb b = first_triangle_box(f.tri[i]);
        reach[0] += vaxis(b.lo, axis) <= t.root.plane;
        reach[1] += vaxis(b.hi, axis) >= t.root.plane;
    }
    check_equal(most, 176, "triangles in the larger, as 17's page says");
    check_equal(most, (int)fmax(reach[0], reach[1]), "as many reach into it");
    first_kdtree_free(&t);
    first_mesh_free(&f);
    mesh_free(&m);
}

int main(void)
{
    structure full = {"k-d tree", STRUCTURE_OF(kdtree)};
    first_structure s = {"first k-d tree", FIRST_VERBS(first_kdtree), first_kdtree_items_of,
                         first_kdtree_depth_of, 32, most_depth};
    first_structure_tests(&s, &full);
    test_two_leaves();
    return check_report("12_first");
}
