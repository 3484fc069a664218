/* The first octree: brute force's hits; 12 levels, few items; wrong far away. */
#include "../chapters/11_octree/first.h"
#include "../chapters/11_octree/octree.h"
#include "first_structure.h"

static void *full_build(const items *x, failure *f)
{
    octree *s = allocate(1, sizeof *s);
    if (octree_build(x, octree_defaults, s, f)) return s;
    free(s);
    return NULL;
}

static bool full_hit(const void *s, ray r, hit *out) { return octree_hit(s, r, out); }
static bool full_occluded(const void *s, ray r) { return octree_occluded(s, r); }
static void full_destroy(void *s) { octree_free(s), free(s); }

static void *build(const first_mesh *m)
{
    first_octree *s = allocate(1, sizeof *s);
    first_octree_build(m, s);
    return s;
}

static bool hit_of(const void *s, ray r, hit *out) { return first_octree_hit(s, r, out); }
static void destroy(void *s) { first_octree_free(s), free(s); }

static size_t items_below(const first_octree_node *n)
{
    size_t sum = n->child ? 0 : (size_t)n->n;
    for (int c = 0; n->child && c < 8; c++) sum += items_below(&n->child[c]);
    return sum;
}

static int depth_below(const first_octree_node *n)
{
    int most = 0;
    for (int c = 0; n->child && c < 8; c++) {
        int d = 1 + depth_below(&n->child[c]);
        if (d > most) most = d;
    }
    return most;
}

static size_t items_of(const void *s) { return items_below(&((const first_octree *)s)->root); }
static int depth_of(const void *s) { return depth_below(&((const first_octree *)s)->root); }

static double most_depth(double log_n) { return (void)log_n, first_octree_depth; }

int main(void)
{
    structure full = {"octree", full_build, full_hit, full_occluded, full_destroy};
    /* A cut may triple the items, but only where triangles are as large as cells: a few levels of
     * the twelve. 16 a triangle is no proof; 15.3 were met, of triangles 2^-60 to 1 long. */
    first_structure s = {"first octree", build, hit_of, destroy, items_of, depth_of, 16,
                         most_depth};
    first_structure_tests(&s, &full);
    return check_report("11_first");
}
