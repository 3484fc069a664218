/* The first BSP tree: brute force's hits; depth 4 + log2 n, few items; wrong far away. */
#include "../chapters/13_bsp/first.h"
#include "../chapters/13_bsp/bsp.h"
#include "first_structure.h"

static void *full_build(const items *x, failure *f)
{
    bsp *s = allocate(1, sizeof *s);
    if (bsp_build(x, bsp_defaults, s, f)) return s;
    free(s);
    return NULL;
}

static bool full_hit(const void *s, ray r, hit *out) { return bsp_hit(s, r, out); }
static bool full_occluded(const void *s, ray r) { return bsp_occluded(s, r); }
static void full_destroy(void *s) { bsp_free(s), free(s); }

static void *build(const first_mesh *m)
{
    first_bsp *s = allocate(1, sizeof *s);
    first_bsp_build(m, s);
    return s;
}

static bool hit_of(const void *s, ray r, hit *out) { return first_bsp_hit(s, r, out); }
static void destroy(void *s) { first_bsp_free(s), free(s); }

static size_t items_below(const first_bsp_node *n)
{
    size_t sum = (size_t)n->count;
    for (int c = 0; n->child && c < 2; c++) sum += items_below(&n->child[c]);
    return sum;
}

static int depth_below(const first_bsp_node *n)
{
    int most = 0;
    for (int c = 0; n->child && c < 2; c++) {
        int d = 1 + depth_below(&n->child[c]);
        if (d > most) most = d;
    }
    return most;
}

static size_t items_of(const void *s) { return items_below(&((const first_bsp *)s)->root); }
static int depth_of(const void *s) { return depth_below(&((const first_bsp *)s)->root); }
static double most_depth(double log_n) { return 4 + log_n; }

int main(void)
{
    structure full = {"BSP tree", full_build, full_hit, full_occluded, full_destroy};
    first_structure s = {"first BSP tree", build, hit_of, destroy, items_of, depth_of, 128,
                         most_depth};
    first_structure_tests(&s, &full);
    return check_report("13_first");
}
