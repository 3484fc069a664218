/* greed.h: the best tree there is, and by how much the rules miss it.
 *
 *   greed_best(item, n, cut)    the least sum of the areas of all inner boxes, over that of the
 *                               root, of all trees with one item in a leaf                  (14.7)
 *       uint32_t cut[1 << n]    out: of each set of two items or more, the part that its best tree
 *                               cuts off; bit i: item i; NULL: not wanted
 *   greed_cubes()               four unit cubes in a row: each a triangle that has it as its box
 *   table_of_greed(o)           sets of ten triangles by chance: each rule against the best
 *
 * A set of n items has (2n - 3)!! trees: 34459425 for n = 10. But the best tree of a set is a best
 * cut of it with the best trees of its two parts, whatever is around it, so 2^n sets and 3^n cuts
 * do (dynamic programming over subsets, 动态规划): some 30000 for n = 10. Leaves of one item cost
 * the same in every tree, so nodes are all that differs.
 */
#ifndef BVH_GREED_H
#define BVH_GREED_H

#include "../../../common/lab/report.h"
#include "../../07_mesh/scenes/soup.h"
#include "../bvh_mesh.h"
#include "cost.h"

enum { greed_items = 10 };

/* ---------------------------------------------------------------------------------------------- */

static inline double greed_best(const bvh_item *item, int n, uint32_t *cut)
{
    uint32_t sets = (uint32_t)1 << n;
    double *best = allocate(sets, sizeof *best), *area = allocate(sets, sizeof *area);
    for (uint32_t set = 1; set < sets; set++) {
        bvh_box box = box_empty();
        for (int i = 0; i < n; i++)
            if (set >> i & 1) box_add(&box, &item[i]);
        area[set] = box_area(&box);
        if (!(set & (set - 1))) continue;  /* one item: a leaf */
        double least = HUGE_VAL;
        for (uint32_t left = (set - 1) & set; left > (set & ~left); left = (left - 1) & set) {
            double sum = best[left] + best[set & ~left];
            if (cut && sum < least) cut[set] = set & ~left;
            least = fmin(least, sum);
        }
        best[set] = area[set] + least;
    }
    double sum = best[sets - 1] / area[sets - 1];
    free(best), free(area);
    return sum;
}

static inline mesh greed_cubes(void)
{
    static const real at[] = {0, 6, 11, 11};
    mesh m = mesh_room(sizeof at / sizeof *at);
    for (size_t i = 0; i < m.triangles; i++) {
        m.v[3 * i] = vec(at[i], 0, 0), m.v[3 * i + 1] = vec(at[i] + 1, 1, 0);
        m.v[3 * i + 2] = vec(at[i], 0, 1);
    }
    return m;
}

/* Ten triangles of a tenth to the whole of the cube's size. */
static inline mesh greed_mesh(uint64_t seed)
{
    mesh m = mesh_room(greed_items);
    for (size_t i = 0; i < greed_items; i++) {
        random_stream g = random_start(seed, i, 0);
        vec3 a = random_in_cube(&g, 1);
        real size = (real)exp2((double)(-3 * random_next(&g)));
        m.v[3 * i] = a;
        m.v[3 * i + 1] = vadd(a, random_in_cube(&g, size));
        m.v[3 * i + 2] = vadd(a, random_in_cube(&g, size));
    }
    return m;
}

static inline void table_of_greed(const options *o)
{
    enum { sets = 300 };
    double mean[bvh_rule_count] = {0}, worst[bvh_rule_count] = {0};
    size_t best[bvh_rule_count] = {0};
    table out = table_new("300 sets of ten triangles: nodes (14.7) above those of the best tree",
                          "rule|on average [%]|at worst [%]|the best tree [sets]");
    for (uint64_t seed = 0; seed < sets; seed++) {
        mesh m = greed_mesh(seed);
        bvh_item item[greed_items];
        for (size_t i = 0; i < greed_items; i++) (void)triangle_item(&m, i, &item[i]);
        double least = greed_best(item, greed_items, NULL);
        for (int k = 0; k < bvh_rule_count; k++) {
            bvh_mesh b;
            failure f;
            if (bvh_rules[k].through) continue;
            if (!bvh_mesh_build(&m, (bvh_options){bvh_rules[k].name, 1, 0.3, SIZE_MAX}, &b, &f))
                fail(f);
            double over = 100 * (tree_cost_of(&b.tree).nodes / least - 1);
            mean[k] += over / sets, worst[k] = fmax(worst[k], over), best[k] += over < 1e-6;
            bvh_mesh_free(&b);
        }
        mesh_free(&m);
    }
    for (int k = 0; k < bvh_rule_count; k++) {
        if (bvh_rules[k].through) continue;
        table_text(&out, "%s", bvh_rules[k].name);
        table_number(&out, mean[k]), table_number(&out, worst[k]), table_count(&out, best[k]);
    }
    output_extra_table(o, &out);
}

#endif
