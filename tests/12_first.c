/* The first k-d tree: brute force's hits; depth by (12.2), few items; wrong far away. */
#include "../chapters/12_kdtree/first.h"
#include "../chapters/12_kdtree/kdtree.h"
#include "first_structure.h"

STRUCTURE_TESTED(kdtree, kdtree_defaults)

FIRST_STRUCTURE(first_kdtree, first_kdtree_build(m, s))
FIRST_TREE(first_kdtree, first_kd_node, 2, n->child ? 0 : n->n)
static double most_depth(double log_n) { return 8 + 1.3 * log_n; }

int main(void)
{
    structure full = {"k-d tree", STRUCTURE_OF(kdtree)};
    first_structure s = {"first k-d tree", FIRST_VERBS(first_kdtree), first_kdtree_items_of,
                         first_kdtree_depth_of, 32, most_depth};
    first_structure_tests(&s, &full);
    return check_report("12_first");
}
