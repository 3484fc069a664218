/* Every hit of the grid equals brute force, bit for bit. */
#include "../chapters/10_grid/nested.h"
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

static nested_options nested_how;

static void *build_nested(const items *x, failure *f)
{
    nested *n = allocate(1, sizeof *n);
    if (nested_build(x, nested_how, n, f)) return n;
    free(n);
    return NULL;
}

static bool nested_hit_of(const void *n, ray r, hit *out) { return nested_hit(n, r, out); }
static bool nested_is_occluded(const void *n, ray r) { return nested_occluded(n, r); }

static void destroy_nested(void *n)
{
    nested_free(n);
    free(n);
}

int main(void)
{
    structure s = {"grid", build, hit_of, occluded, destroy};
    structure two = {"two-level grid", build_nested, nested_hit_of, nested_is_occluded,
                     destroy_nested};
    how = grid_defaults;
    structure_tests(&s, check_count(600));
    nested_how = nested_defaults;
    structure_tests(&two, check_count(600));
    return check_report("10_grid");
}
