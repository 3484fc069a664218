/* The first grid: brute force's hits; at most 100 items a triangle; wrong far away. */
#include "../chapters/10_grid/first.h"
#include "../chapters/10_grid/grid.h"
#include "first_structure.h"

STRUCTURE_TESTED(grid, grid_defaults)

FIRST_STRUCTURE(first_grid, *s = first_grid_build(m))
static size_t items_of(const void *s) { return ((const first_grid *)s)->items; }
static int depth_of(const void *s) { return (void)s, 0; }
static double most_depth(double log_n) { return log_n; }

int main(void)
{
    structure full = {"grid", STRUCTURE_OF(grid)};
    first_structure s = {"first grid", FIRST_VERBS(first_grid), items_of, depth_of, 100,
                         most_depth};
    first_structure_tests(&s, &full);
    return check_report("10_first");
}
