/* split.h: where to cut a set of items in two: a rule is one function.
 *
 *   split_cycle            axis x, y, z, x, ... by depth; in the middle of the centres      (14.4)
 *   split_longest          the axis along which the centres extend longest; in the middle
 *   split_cycle_median     axis by depth; as many items left as right, by selection in O(n)
 *   split_median           the longest axis; as many left as right
 *   split_binned           surface area heuristic (表面积启发式): the best of 15 planes an axis (14.6),
 *                          7 of fewer than 16 items; of 32768 and more a sample tells
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
 * Where items are tested eight at once (15), n counts these blocks (15.4). There, near the root,
 * bins are of size, too: walls and what stands between them have middles side by side, and together
 * would make every box as large as the room.
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
    int block;                /* 2^block items are tested at once: 15; elsewhere 0 */
    int by_size;              /* so many levels from the root, bins of size, too: 15; elsewhere 0 */
    int depth;                /* in: of the node; 0: the root */
    bvh_box box, centres;     /* in: around the items; around their centres, twice as large, and
                               * in its spare places their sizes */
    double cost;              /* out: of the best split, HUGE_VAL if there is none */
    float scale[4];           /* bins a unit; 0: all in one place, or too far apart */
    int ways, bins;           /* x, y, z, size: 3 or 4; bins of each */
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

/* (14.4): items whose centre lies below the middle go left. All to one side: halved by number. */
static inline size_t split_middle(const splitter *s, bvh_item *item, size_t n, int axis)
{
    float middle = 0.5f * s->centres.low[axis] + 0.5f * box_high(&s->centres, axis);
    size_t left = 0, right = n;
    while (left < right) {
        if (item_centre(&item[left], axis) < middle) left++;
        else item_swap(&item[left], &item[--right]);
    }
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
typedef struct { double cost; int way, bin; } split_choice;

static inline int bins_for(size_t n) { return n < 16 ? most_bins / 2 : most_bins; }

/* Where a hundred thousand items lie, some ten thousand of them tell: every so many-th goes into
 * the bins, an odd number, since the triangles of a mesh often come in pairs. The boxes of the
 * parts do not come from the bins but are measured. */
static inline size_t sample_step(size_t n) { return n < 32768 ? 1 : n / 16384 | 1; }

/* The sum of its sides. */
static inline float item_size(const bvh_item *i)
{
    return -(i->low[0] + i->minus_high[0]) - (i->low[1] + i->minus_high[1])
         - (i->low[2] + i->minus_high[2]);
}

static inline void split_scale(splitter *s, size_t n)
{
    s->bins = bins_for(n);
    for (int k = 0; k < s->ways; k++) {
        float extent = -s->centres.side[4 + k] - s->centres.side[k];
        float scale = (float)s->bins * 0.9999f / extent;
        s->scale[k] = scale < FLT_MAX ? scale : 0;
    }
}

/* The last one, if inf - inf or 0 times that is no number. */
fast_inline int bin_of(const splitter *s, const bvh_item *i, int way)
{
    float at = way < 3 ? item_centre(i, way) : item_size(i);
    return (int)float_min((at - s->centres.side[way]) * s->scale[way], (float)(s->bins - 1));
}

fast_inline void bin_add(const splitter *s, split_bins *b, const bvh_item *i, int way)
{
    int at = bin_of(s, i, way);
    box_add(&b[way].box[at], i);
    b[way].n[at]++;
}

fast_inline void bins_add(const splitter *s, split_bins *b, const bvh_item *i)
{
    EIGHT_UNROLL
    for (int k = 0; k < 3; k++) bin_add(s, b, i, k);
    if (s->ways > 3) bin_add(s, b, i, 3);
}

/* A side of a cut: its area, times how many tests it takes. */
static inline double split_side(const splitter *s, const bvh_box *box, size_t n)
{
    size_t more = ((size_t)1 << s->block) - 1;
    return n ? box_area(box) * (double)((n + more) >> s->block) : HUGE_VAL;
}

/* From the right, then from the left; the best plane is after bin `best->bin`. */
static inline void sweep_bins(const splitter *s, const split_bins *b, int way, split_choice *best)
{
    double right[most_bins];
    bvh_box box = box_empty();
    size_t n = 0;
    for (int i = s->bins - 1; i > 0; i--) {
        box_add(&box, &b->box[i]);
        n += b->n[i];
        right[i] = split_side(s, &box, n);
    }
    box = box_empty(), n = 0;
    for (int i = 0; i + 1 < s->bins; i++) {
        box_add(&box, &b->box[i]);
        n += b->n[i];
        double cost = split_side(s, &box, n) + right[i + 1];
        if (cost < best->cost) *best = (split_choice){cost, way, i};
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
    split_bins bins[4];
    split_choice best = {HUGE_VAL, 0, 0};
    split_scale(s, n);
    for (int k = 0; k < s->ways; k++)
        for (int i = 0; i < s->bins; i++) bins[k].box[i] = box_empty(), bins[k].n[i] = 0;
    /* From both halves in turn: neighbours share a bin, and the second would wait for the first. */
    size_t step = sample_step(n), half = (n + 2 * step - 1) / (2 * step) * step;
    for (size_t i = 0; i < half; i += step) {
        bins_add(s, bins, &item[i]);
        if (half + i < n) bins_add(s, bins, &item[half + i]);
    }
    for (int k = 0; k < s->ways; k++)
        if (s->scale[k] > 0) sweep_bins(s, &bins[k], k, &best);
    s->cost = split_cost(s, best.cost);
    if (s->cost == HUGE_VAL) return split_by_number(item, n, box_longest(&s->centres));
    size_t left = 0, right = n;
    while (left < right) {
        if (bin_of(s, &item[left], best.way) <= best.bin) left++;
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
    bvh_box box = box_empty(), centres = box;
    s->ways = s->depth < s->by_size ? 4 : 3;
    for (size_t i = 0; i < n; i++) {
        const eight own = item[i].all;
        const bvh_box centre = {.all = own - eight_halves_swapped(&own)};
        box_add(&box, &item[i]), box_add(&centres, &centre);
    }
    centres.side[3] = centres.side[7] = INFINITY;
    for (size_t i = 0; s->ways > 3 && i < n; i++) {
        float size = item_size(&item[i]);
        centres.side[3] = float_min(size, centres.side[3]);
        centres.side[7] = float_min(-size, centres.side[7]);
    }
    s->box = box, s->centres = centres;
}

#endif
