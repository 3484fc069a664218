/* The first BSP tree: brute force's hits; depth 4 + log2 n, few items; wrong far away. */
#include "../chapters/13_bsp/first.h"
#include "../chapters/13_bsp/bsp.h"
#include "first_structure.h"

STRUCTURE_TESTED(bsp, bsp_defaults)

FIRST_STRUCTURE(first_bsp, first_bsp_build(m, s))
FIRST_TREE(first_bsp, first_bsp_node, 2, n->count)
static double most_depth(double log_n) { return 4 + log_n; }

int main(void)
{
    structure full = {"BSP tree", STRUCTURE_OF(bsp)};
    first_structure s = {"first BSP tree", FIRST_VERBS(first_bsp), first_bsp_items_of,
                         first_bsp_depth_of, 128, most_depth};
    first_structure_tests(&s, &full);
    return check_report("13_first");
}
