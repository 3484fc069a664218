/* Every hit of the octree equals brute force. */
#include "../chapters/11_octree/octree.h"
#include "structure.h"

static octree_options how;

static void *build(const items *x, failure *f)
{
    octree *t = allocate(1, sizeof *t);
    if (octree_build(x, how, t, f)) return t;
    free(t);
    return NULL;
}

static bool find(const void *s, ray r, hit *out) { return octree_hit(s, r, out); }
static bool occluded(const void *s, ray r) { return octree_occluded(s, r); }
static void destroy(void *s) { octree_free(s), free(s); }

int main(void)
{
    how = octree_defaults;
    structure s = {"octree", build, find, occluded, destroy};
    structure_tests(&s, check_count(600));
    return check_report("11_octree");
}
