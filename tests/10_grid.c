/* Every hit of the grid equals brute force, bit for bit. */
#include "../chapters/10_grid/grid.h"
#include "structure.h"

static grid_options how;

static void *build(const items *x, failure *f)
{
    grid *g = allocate(1, sizeof *g);
    if (grid_build(x, how, g, f)) return g;
    free(g);
    return NULL;
}

static bool hit_of(const void *g, ray r, hit *out) { return grid_hit(g, r, out); }
static bool occluded(const void *g, ray r) { return grid_occluded(g, r); }

static void destroy(void *g)
{
    grid_free(g);
    free(g);
}

int main(void)
{
    structure s = {"grid", build, hit_of, occluded, destroy};
    how = grid_defaults;
    structure_tests(&s, check_count(600));
    return check_report("10_grid");
}
