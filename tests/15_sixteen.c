/* Nodes of sixteen places: the hits of brute force in every dialect, also where nodes stay narrow;
 * and that nodes are as wide as they may be. */
#define bvh8_places 16
#include "../common/posix.h"
#include "../chapters/07_mesh/scenes/teapot.h"
#include "../chapters/15_wide_bvh/bvh8.h"
#include "structure.h"

static bvh8_options options_now;
STRUCTURE_TESTED(bvh8, options_now)

static void test_structures(void)
{
    for (int d = EIGHT_PLAIN; d <= (int)eight_best(); d++)
        for (int width = d == EIGHT_PLAIN ? 5 : 16; width <= 16; width += 11) {
            char name[40];
            structure s = {name, STRUCTURE_OF(bvh8)};
            options_now = bvh8_defaults;
            options_now.dialect = (eight_dialect)d, options_now.width = width;
            snprintf(name, sizeof name, "dialect %d, %d wide", d, width);
            structure_tests(&s, check_count(400));
        }
}

/* A box alone in its node is met at its own place; and many nodes are full. */
static void test_places(void)
{
    mesh m = teapot_mesh(8);
    items x = items_of_mesh(&m);
    bvh8 w;
    size_t wrong = 0, full = 0;
    check(bvh8_build(&x, bvh8_defaults, &w, NULL), "built");
    for (size_t i = 0; i < w.nodes; i++) {
        int n = 0;
        for (int k = 0; k < 16; k++) {
            const bvh8_node *a = &w.node[i];
            bvh8_node one = *a;
            if (a->side[0][k] > a->side[3][k]) continue;
            n++;
            for (int s = 0; s < 6; s++)
                for (int j = 0; j < 16; j++)
                    one.side[s][j] = (j == k ? 1 : -INFINITY) * (s < 3 ? -1.0f : 1.0f);
            ray r = ray_from((vec3){0, 0, 0}, (vec3){(real)0.3, (real)0.5, 1});
            const bvh8 unit = {.scale = 1};
            bvh8_ray q;
            eight enter[2];
            bvh8_ray_of(&unit, &r, &bvh8_skip_none, &q);
            eight_set mask = bvh8_boxes_0(&one, &q, enter);
            wrong += !mask || (mask & (mask - 1)) || bvh8_first_0(mask) != k;
        }
        full += n == 16;
    }
    check_equal(wrong, 0, "each child is met at its own place");
    check_at_least(full, w.nodes / 8, "nodes with all places taken");
    bvh8_free(&w), mesh_free(&m);
}

int main(void)
{
    test_structures();
    test_places();
    return check_report("15_sixteen");
}
