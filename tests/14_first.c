/* The first BVH, by both of its rules: brute force's hits; fewer than 2 n nodes; wrong far away. */
#include "../chapters/14_bvh/first.h"
#include "../chapters/14_bvh/bvh.h"
#include "first_structure.h"

STRUCTURE_TESTED(bvh, bvh_defaults)

static bool heuristic;

FIRST_STRUCTURE(first_bvh, *s = first_bvh_build(m, heuristic))
static size_t nodes_of(const void *s) { return (size_t)((const first_bvh *)s)->nodes; }

static int depth_below(const first_bvh *b, int i)
{
    if (b->node[i].left == 0) return 0;
    int l = depth_below(b, b->node[i].left), r = depth_below(b, b->node[i].right);
    return 1 + (l > r ? l : r);
}

static int depth_of(const void *s) { return depth_below(s, 0); }
static double most_depth(double log_n) { return log_n + (heuristic ? 100 : 0); }

/* Flat boards at -1.067^-i, all of one size: each of the heuristic's cuts costs as much as any
 * other, and its first takes one board off. Without a limit the depth would be n. */
static void test_one_by_one(const first_structure *s)
{
    size_t n = real_is_float ? 800 : 5000;
    mesh m = mesh_room(n);
    for (size_t i = 0; i < n; i++) {
        real x = (real)-exp(log(1.067) * -(double)i);
        set_triangle(&m, i, (vec3){x, 0, 0}, (vec3){x, 1, 0}, (vec3){x, 0, 1});
    }
    first_structure_bounds(s, "one by one", m, (vec3){0, 0, 0});
}

/* The nearer child first, and a ray that ends at each hit: structure_plates. */
static void test_one_leaf(const first_structure *s)
{
    enum { plates = 500 };
    mesh m = structure_plates(plates);
    first_mesh f = first_mesh_of(&m);
    void *built = s->build(&f);
    for (int end = 0; end < 2; end++) {
        hit h = hit_none;
        first_tests = 0;
        check(s->hit(built, structure_through(plates, end), &h) && fabs(h.t - 1) < (real)0.5,
              "%s: a hit", s->name);
        check_at_most(first_tests, first_bvh_leaf, "%s: tests of %d plates, end %d", s->name,
                      plates, end);
    }
    s->destroy(built);
    first_mesh_free(&f);
    mesh_free(&m);
}

int main(void)
{
    structure full = {"BVH", STRUCTURE_OF(bvh)};
    first_structure s = {"first BVH, middle", FIRST_VERBS(first_bvh), nodes_of, depth_of, 2,
                         most_depth};
    for (int sah = 0; sah < 2; sah++) {
        heuristic = sah != 0;
        if (sah) s.name = "first BVH, SAH";
        first_structure_tests(&s, &full);
        test_one_by_one(&s);
        test_one_leaf(&s);
    }
    return check_report("14_first");
}
