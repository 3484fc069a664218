/* The first grid: brute force's hits; at most 100 items a triangle; wrong far away. */
#include "../chapters/10_grid/first.h"
#include "../chapters/10_grid/grid.h"
#include "first_structure.h"

static void *full_build(const items *x, failure *f)
{
    grid *s = allocate(1, sizeof *s);
    if (grid_build(x, grid_defaults, s, f)) return s;
    free(s);
    return NULL;
}

static bool full_hit(const void *s, ray r, hit *out) { return grid_hit(s, r, out); }
static bool full_occluded(const void *s, ray r) { return grid_occluded(s, r); }
static void full_destroy(void *s) { grid_free(s), free(s); }

static void *build(const first_mesh *m)
{
    first_grid *s = allocate(1, sizeof *s);
    *s = first_grid_build(m);
    return s;
}

static bool hit_of(const void *s, ray r, hit *out) { return first_grid_hit(s, r, out); }
static void destroy(void *s) { first_grid_free(s), free(s); }
static size_t items_of(const void *s) { return ((const first_grid *)s)->items; }
static int depth_of(const void *s) { return (void)s, 0; }
static double most_depth(double log_n) { return log_n; }

int main(void)
{
    structure full = {"grid", full_build, full_hit, full_occluded, full_destroy};
    first_structure s = {"first grid", build, hit_of, destroy, items_of, depth_of, 100,
                         most_depth};
    first_structure_tests(&s, &full);
    return check_report("10_first");
}
