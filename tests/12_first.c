/* The first k-d tree: brute force's hits; depth by (12.2), few items; wrong far away. */
#include "../chapters/12_kdtree/first.h"
#include "../chapters/12_kdtree/kdtree.h"
#include "first_structure.h"

static void *full_build(const items *x, failure *f)
{
    kdtree *s = allocate(1, sizeof *s);
    if (kdtree_build(x, kdtree_defaults, s, f)) return s;
    free(s);
    return NULL;
}

static bool full_hit(const void *s, ray r, hit *out) { return kdtree_hit(s, r, out); }
static bool full_occluded(const void *s, ray r) { return kdtree_occluded(s, r); }
static void full_destroy(void *s) { kdtree_free(s), free(s); }

static void *build(const first_mesh *m)
{
    first_kdtree *s = allocate(1, sizeof *s);
    first_kdtree_build(m, s);
    return s;
}

static bool hit_of(const void *s, ray r, hit *out) { return first_kdtree_hit(s, r, out); }
static void destroy(void *s) { first_kdtree_free(s), free(s); }

static size_t items_below(const first_kd_node *n)
{
    size_t sum = n->child ? 0 : (size_t)n->n;
    for (int c = 0; n->child && c < 2; c++) sum += items_below(&n->child[c]);
    return sum;
}

static int depth_below(const first_kd_node *n)
{
    int most = 0;
    for (int c = 0; n->child && c < 2; c++) {
        int d = 1 + depth_below(&n->child[c]);
        if (d > most) most = d;
    }
    return most;
}

static size_t items_of(const void *s) { return items_below(&((const first_kdtree *)s)->root); }
static int depth_of(const void *s) { return depth_below(&((const first_kdtree *)s)->root); }
static double most_depth(double log_n) { return 8 + 1.3 * log_n; }

int main(void)
{
    structure full = {"k-d tree", full_build, full_hit, full_occluded, full_destroy};
    first_structure s = {"first k-d tree", build, hit_of, destroy, items_of, depth_of, 32,
                         most_depth};
    first_structure_tests(&s, &full);
    return check_report("12_first");
}
