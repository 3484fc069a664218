/* split.h: where to cut a set of items in two: a rule is one function.
 *
 *   split_cycle            axis x, y, z, x, ... by depth; in the middle of the centres      (14.4)
 *   split_longest          the axis along which the centres extend longest; in the middle
 *   split_cycle_median     axis by depth; as many items left as right, by selection in O(n)
 *   split_median           the longest axis; as many left as right
 *   split_binned           surface area heuristic (表面积启发式): the best of 15 planes an axis (14.6)
 *   split_sweep            the same: the best of all places between two items, along all axes
 *
 *   size_t left = split_median(&s, item, n)
 *       reorders the items: the first `left` of them, 1 .. n-1, go left
 *       s.cost: of that split by the heuristic, if the rule knows it; a leaf costs n * s.item_cost
 *
 * A new rule is such a function and a line in the table of tree.h.
 *
 * The heuristic. A line that meets a convex box meets a box inside it with probability
 * area(inside) / area(box), so a cut into L and R costs (14.5)
 *
 *      cost = 1 + (area(L) n(L) + area(R) n(R)) / area * item_cost       [tests of a pair of boxes]
 *
 * What cannot be cut by planes (all centres the same; areas that overflow) is halved by number.
 *
 * Sources: J. Goldsmith, J. Salmon, "Automatic Creation of Object Hierarchies for Ray Tracing",
 * IEEE CG&A 7(5), 1987; J. D. MacDonald, K. S. Booth, "Heuristics for ray tracing using space
 * subdivision", The Visual Computer 6, 1990; I. Wald, "On fast Construction of SAH-based Bounding
 * Volume Hierarchies", IEEE Symp. Interactive Ray Tracing 2007 (bins).
 */
#ifndef BVH_SPLIT_H
#define BVH_SPLIT_H

#include "../../../common/file.h"
#include "../../../common/numbers/radix.h"
#include "select.h"

typedef struct {
    double item_cost;         /* of testing an item, where testing a pair of boxes costs 1 */
    int depth;                /* in: of the node; 0: the root */
    bvh_box box, centres;     /* in: around the items; around their centres, twice as large */
    double cost;              /* out: of the best split, HUGE_VAL if there is none */
    float scale[3];           /* bins a unit; 0: all centres the same, or too far apart */
    int bins;
    radix_pair *pairs, *spare; /* [n] each, for the sweep alone; NULL otherwise */
    float *areas;             /* [n] */
} splitter;

/* ---------------------------------------------------------------------------------------------- */

static inline int box_longest(const bvh_box *b)
{
    float x = box_high(b, 0) - b->low[0], y = box_high(b, 1) - b->low[1];
    float z = box_high(b, 2) - b->low[2];
    return x >= y ? (x >= z ? 0 : 2) : (y >= z ? 1 : 2);
}

static inline size_t split_by_number(bvh_item *item, size_t n, int axis)
{
    select_item(item, n, n / 2, axis);
    return n / 2;
}

/* Items whose centre lies below `cut` go left. All to one side: halved by number instead. */
static inline size_t split_at_plane(bvh_item *item, size_t n, int axis, float cut)
{
    size_t left = 0, right = n;
    while (left < right) {
        if (item_centre(&item[left], axis) < cut) left++;
        else item_swap(&item[left], &item[--right]);
    }
    return left;
}

static inline size_t split_middle(const splitter *s, bvh_item *item, size_t n, int axis)
{
    float lo = s->centres.low[axis], hi = box_high(&s->centres, axis);
    size_t left = split_at_plane(item, n, axis, 0.5f * lo + 0.5f * hi);
    return left == 0 || left == n ? split_by_number(item, n, box_longest(&s->centres)) : left;
}

static inline size_t split_cycle(splitter *s, bvh_item *item, size_t n)
{
    return split_middle(s, item, n, s->depth % 3);
}

static inline size_t split_longest(splitter *s, bvh_item *item, size_t n)
{
    return split_middle(s, item, n, box_longest(&s->centres));
}

static inline size_t split_cycle_median(splitter *s, bvh_item *item, size_t n)
{
    return split_by_number(item, n, s->depth % 3);
}

static inline size_t split_median(splitter *s, bvh_item *item, size_t n)
{
    return split_by_number(item, n, box_longest(&s->centres));
}

/* ---------------------------------------------------------------------------------------------- */

enum { most_bins = 16 };
typedef struct { bvh_box box[most_bins]; size_t n[most_bins]; } split_bins;
typedef struct { double cost; int axis, bin; } split_choice;

static inline int bins_for(size_t n) { return n < 16 ? most_bins / 2 : most_bins; }

/* Where a hundred thousand items lie, some ten thousand of them tell: every so many-th goes into
 * the bins, an odd number, since the triangles of a mesh often come in pairs. The boxes of the
 * parts do not come from the bins but are measured. */
static inline size_t sample_step(size_t n) { return n < 32768 ? 1 : n / 16384 | 1; }

static inline void split_scale(splitter *s, size_t n)
{
    s->bins = bins_for(n);
    for (int k = 0; k < 3; k++) {
        float extent = box_high(&s->centres, k) - s->centres.low[k];
        float scale = (float)s->bins * 0.9999f / extent;
        s->scale[k] = scale < FLT_MAX ? scale : 0;
    }
}

/* The last one, if inf - inf or 0 times that is no number. */
static inline int bin_of(const splitter *s, const bvh_item *i, int axis)
{
    float at = (item_centre(i, axis) - s->centres.low[axis]) * s->scale[axis];
    return (int)float_min(at, (float)(s->bins - 1));
}

/* Areas times numbers from the right, then from the left; the best plane is after bin
 * `best->bin`. */
static inline void sweep_bins(const splitter *s, const split_bins *b, int axis, split_choice *best)
{
    double right[most_bins];
    bvh_box box = box_empty();
    size_t n = 0;
    for (int i = s->bins - 1; i > 0; i--) {
        box_add(&box, &b->box[i]);
        n += b->n[i];
        right[i] = n ? box_area(&box) * (double)n : HUGE_VAL;
    }
    box = box_empty(), n = 0;
    for (int i = 0; i + 1 < s->bins; i++) {
        box_add(&box, &b->box[i]);
        n += b->n[i];
        double cost = n ? box_area(&box) * (double)n + right[i + 1] : HUGE_VAL;
        if (cost < best->cost) *best = (split_choice){cost, axis, i};
    }
}

/* area = 0 (all in one point) or infinite leaves no number to compare: no split by cost. */
static inline double split_cost(const splitter *s, double sum)
{
    double cost = 1 + sum / box_area(&s->box) * s->item_cost;
    return cost < HUGE_VAL ? cost : HUGE_VAL;
}

static inline size_t split_binned(splitter *s, bvh_item *item, size_t n)
{
    split_bins bins[3];
    split_choice best = {HUGE_VAL, 0, 0};
    split_scale(s, n);
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < s->bins; i++) bins[k].box[i] = box_empty(), bins[k].n[i] = 0;
    for (size_t i = 0; i < n; i += sample_step(n))
        EIGHT_UNROLL
        for (int k = 0; k < 3; k++) {
            int at = bin_of(s, &item[i], k);
            box_add(&bins[k].box[at], &item[i]);
            bins[k].n[at]++;
        }
    for (int k = 0; k < 3; k++)
        if (s->scale[k] > 0) sweep_bins(s, &bins[k], k, &best);
    s->cost = split_cost(s, best.cost);
    if (s->cost == HUGE_VAL) return split_by_number(item, n, box_longest(&s->centres));
    size_t left = 0, right = n;
    while (left < right) {
        if (bin_of(s, &item[left], best.axis) <= best.bin) left++;
        else item_swap(&item[left], &item[--right]);
    }
    return left;
}

/* ---------------------------------------------------------------------------------------------- */

static inline void sort_along(splitter *s, const bvh_item *item, size_t n, int axis)
{
    for (size_t i = 0; i < n; i++)
        s->pairs[i] = (radix_pair){float_key(item_centre(&item[i], axis)), (uint32_t)i};
    radix_sort_pairs(s->pairs, s->spare, n);
}

static inline size_t split_sweep(splitter *s, bvh_item *item, size_t n)
{
    double best = HUGE_VAL;
    size_t left = 0;
    int axis = 0;
    for (int k = 0; k < 3; k++) {
        if (!(s->centres.low[k] < box_high(&s->centres, k))) continue;  /* nothing to cut between */
        sort_along(s, item, n, k);
        bvh_box box = box_empty();
        for (size_t i = n - 1; i > 0; i--) {
            box_add(&box, &item[s->pairs[i].place]);
            s->areas[i] = (float)box_area(&box);
        }
        box = box_empty();
        for (size_t i = 1; i < n; i++) {
            box_add(&box, &item[s->pairs[i - 1].place]);
            double cost = box_area(&box) * (double)i + (double)s->areas[i] * (double)(n - i);
            if (cost < best) best = cost, left = i, axis = k;
        }
    }
    s->cost = split_cost(s, best);
    if (s->cost == HUGE_VAL) return split_by_number(item, n, box_longest(&s->centres));
    sort_along(s, item, n, axis);
    /* Marks, then a partition in place: there is no room for a second array of items. */
    for (size_t i = 0; i < n; i++) s->spare[s->pairs[i].place].key = i < left;
    size_t l = 0, r = n;
    while (l < r) {
        if (s->spare[l].key) { l++; continue; }
        item_swap(&item[l], &item[--r]);
        s->spare[l].key = s->spare[r].key;
    }
    return left;
}

static inline void split_measure(splitter *s, const bvh_item *item, size_t n)
{
    s->box = s->centres = box_empty();
    for (size_t i = 0; i < n; i++) {
        bvh_box centre;
        for (int k = 0; k < 8; k++) centre.side[k] = item[i].side[k] - item[i].side[k ^ 4];
        box_add(&s->box, &item[i]), box_add(&s->centres, &centre);
    }
}

#endif
