/* The first octree: brute force's hits; 12 levels, few items; wrong far away. */
#include "../chapters/11_octree/first.h"
#include "../chapters/11_octree/octree.h"
#include "first_structure.h"

STRUCTURE_TESTED(octree, octree_defaults)

FIRST_STRUCTURE(first_octree, first_octree_build(m, s))
FIRST_TREE(first_octree, first_octree_node, 8, n->child ? 0 : n->n)

static double most_depth(double log_n) { return (void)log_n, first_octree_depth; }

int main(void)
{
    structure full = {"octree", STRUCTURE_OF(octree)};
    /* A cut may triple the items, but only where triangles are as large as cells: a few levels of
     * the twelve. 16 a triangle is no proof; 15.3 were met, of triangles 2^-60 to 1 long. */
    first_structure s = {"first octree", FIRST_VERBS(first_octree), first_octree_items_of,
                         first_octree_depth_of, 16, most_depth};
    first_structure_tests(&s, &full);
    return check_report("11_first");
}
