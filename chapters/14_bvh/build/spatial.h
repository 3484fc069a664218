/* spatial.h: cuts through the items (空间划分), where cuts between them leave boxes that overlap.
 *
 *      +-------+               A long thin triangle at an odd angle fills little of its box. Cut by
 *      |      /|   +---|       the plane | it becomes two references (引用), each with the box of
 *      |    /  |   |  /|---+   its part: smaller together, and what lies beside it is no longer
 *      |  /    |   +---| / |   covered. The triangle itself is not touched, only named twice.
 *      |/      |       |---+
 *      +-------+
 *
 *   tree_spatial(&in, how, &t)
 *       in.item[in.room], of which in.n are filled: references are added until there is no room
 *       left. Afterwards t.items of them are in use, in the order of the leaves.
 *
 * At each node the best cut between items is known (split.h). If the boxes of its two sides share
 * more than 0.3 of the node's area, 15 planes an axis are weighed too, by the same (14.6): n(L)
 * counts what reaches to the left of the plane, area(L) is of what is there             (14.11)
 * An item that the plane cuts can also be left whole, on the side where that costs less.
 *
 * Each child gets a part of the room that is left, in proportion to its items: the first cuts do
 * not eat it up. Depth stays bounded as in tree.h: a set at depth d with d + log2(n) = 64 is halved
 * by number, and a cut through items leaves at most n of them on either side.
 *
 * Sources: M. Stich, H. Friedrich, A. Dietrich, "Spatial Splits in Bounding Volume Hierarchies",
 * HPG 2009; M. Ernst, G. Greiner, "Early Split Clipping for Bounding Volume Hierarchies", IEEE
 * Symp. Interactive Ray Tracing 2007; S. Popov, I. Georgiev, R. Dimov, P. Slusallek, "Object
 * Partitioning Considered Harmful: Space Subdivision for BVHs", HPG 2009.
 */
#ifndef BVH_SPATIAL_H
#define BVH_SPATIAL_H

#include "store.h"

/* Of the node's area: from where on cuts through items are weighed. At 0.1 the teapot takes five
 * times as long to build, and its rays test one pair of boxes in seventy less. */
#define spatial_least_overlap 0.3

/* ---------------------------------------------------------------------------------------------- */

typedef struct {
    bvh_tree *tree;
    bvh_item *item;
    bvh_options options;
    splitter split;
    bvh_clip *clip;
    const void *context;
} spatial_builder;

/* cost: as splitter.cost. left, right: what is known of the two sides before the cut. */
typedef struct {
    double cost;
    int axis;
    float plane;
    bvh_box left, right;
    size_t n[2];
} spatial_cut;
typedef struct { bvh_box box; size_t begin, end; } spatial_bin;

static inline float spatial_plane(const bvh_box *b, int axis, int i)
{
    float lo = b->low[axis], hi = box_high(b, axis);
    return i == most_bins ? hi : lo + (hi - lo) * ((float)i / most_bins);
}

static inline int spatial_bin_of(const bvh_box *b, int axis, float scale, float x)
{
    float i = (x - b->low[axis]) * scale;
    return i > most_bins - 1 ? most_bins - 1 : i > 0 ? (int)i : 0;
}

/* What is in each bin, how many items begin there and how many end. */
static inline void spatial_fill(const spatial_builder *b, const bvh_item *item, size_t n, int axis,
                                spatial_bin bin[most_bins])
{
    const bvh_box *all = &b->split.box;
    float scale = most_bins / (box_high(all, axis) - all->low[axis]);
    for (int i = 0; i < most_bins; i++) bin[i] = (spatial_bin){box_empty(), 0, 0};
    for (size_t i = 0; i < n; i++) {
        int first = spatial_bin_of(all, axis, scale, item[i].low[axis]);
        int last = spatial_bin_of(all, axis, scale, box_high(&item[i], axis));
        bin[first].begin++, bin[last].end++;
        for (int k = first; k <= last; k++) {
            bvh_box part = item[i];
            if (first == last || b->clip(b->context, &item[i], axis, spatial_plane(all, axis, k),
                                         spatial_plane(all, axis, k + 1), &part))
                box_add(&bin[k].box, &part);
        }
    }
}

static inline void spatial_sweep(const spatial_builder *b, const spatial_bin *bin, int axis,
                                 spatial_cut *best)
{
    bvh_box right[most_bins], left = box_empty();
    size_t n[2] = {0, 0}, after[most_bins];
    for (int i = most_bins - 1; i > 0; i--) {
        right[i] = i + 1 < most_bins ? right[i + 1] : box_empty();
        box_add(&right[i], &bin[i].box);
        after[i] = n[1] += bin[i].end;
    }
    for (int i = 1; i < most_bins; i++) {
        box_add(&left, &bin[i - 1].box);
        n[0] += bin[i - 1].begin;
        if (n[0] == 0 || after[i] == 0) continue;
        double cost = split_cost(&b->split, box_area(&left) * (double)n[0]
                                 + box_area(&right[i]) * (double)after[i]);
        if (cost < best->cost)
            *best = (spatial_cut){cost, axis, spatial_plane(&b->split.box, axis, i), left, right[i],
                                  {n[0], after[i]}};
    }
}

static inline spatial_cut spatial_find(const spatial_builder *b, const bvh_item *item, size_t n)
{
    spatial_cut best = {.cost = HUGE_VAL};
    spatial_bin bin[most_bins];
    for (int k = 0; k < 3; k++) {
        float extent = box_high(&b->split.box, k) - b->split.box.low[k];
        if (!(extent <= FLT_MAX && most_bins / extent <= FLT_MAX)) continue;  /* 0 is left out */
        spatial_fill(b, item, n, k, bin);
        spatial_sweep(b, bin, k, &best);
    }
    return best;
}

/* 0: goes left whole; 1: goes right whole; 2: is cut. By (14.11), of which only the sum matters. */
static inline int spatial_side(spatial_cut *cut, const bvh_item *item)
{
    if (box_high(item, cut->axis) <= cut->plane) return 0;
    if (item->low[cut->axis] >= cut->plane) return 1;
    bvh_box l = cut->left, r = cut->right;
    box_add(&l, item), box_add(&r, item);
    double nl = (double)cut->n[0], nr = (double)cut->n[1];
    double both = box_area(&cut->left) * nl + box_area(&cut->right) * nr;
    double left = box_area(&l) * nl + box_area(&cut->right) * (nr - 1);
    double right = box_area(&cut->left) * (nl - 1) + box_area(&r) * nr;
    if (left < both && left <= right) return cut->left = l, cut->n[1]--, 0;
    if (right < both) return cut->right = r, cut->n[0]--, 1;
    return 2;
}

/* Reorders the items; new references come behind them. Returns how many go left; *n becomes the
 * number of all. */
static inline size_t spatial_apply(const spatial_builder *b, spatial_cut *cut, bvh_item *item,
                                   size_t *n, size_t room)
{
    size_t left = 0, right = *n, total = *n;
    while (left < right) {
        bvh_item *at = &item[left], r = *at;
        int side = spatial_side(cut, at);
        if (side == 2 && total < room) {
            bvh_item l = r;
            bool in_l = b->clip(b->context, at, cut->axis, -INFINITY, cut->plane, &l);
            bool in_r = b->clip(b->context, at, cut->axis, cut->plane, INFINITY, &r);
            side = in_r && !in_l;
            if (in_l) *at = l;
            if (in_l && in_r) item[total++] = r;
            if (side) *at = r;
        }
        if (side == 1) item_swap(at, &item[--right]);
        else left++;
    }
    *n = total;
    return left > 0 && left < total ? left
                                    : split_by_number(item, total, box_longest(&b->split.box));
}

/* What the boxes of the first `left` items and of the others share, as a part of the node's. */
static inline double spatial_overlap(const splitter *s, const bvh_item *item, size_t n, size_t left)
{
    bvh_box l = box_empty(), r = box_empty();
    for (size_t i = 0; i < left; i++) box_add(&l, &item[i]);
    for (size_t i = left; i < n; i++) box_add(&r, &item[i]);
    return box_shared_area(&l, &r) / box_area(&s->box);
}

/* Node `at`: n items from `begin` on, with room for more of them. A leaf's items move to the front,
 * where nothing is left but what other leaves have left behind. */
static inline void spatial_node(spatial_builder *b, size_t at, size_t begin, size_t n, size_t room,
                                int depth)
{
    bvh_tree *t = b->tree;
    bvh_item *item = b->item + begin;
    splitter *s = &b->split;
    split_measure(s, item, n);
    t->node[at] = box_numbered(&s->box, t->items, n);
    if (depth > t->depth) t->depth = depth;
    bool fits = n <= (size_t)b->options.leaf, deep = depth + log2_above(n) >= bvh_most_depth;
    double all = (double)n * s->item_cost;  /* cost without any cut */
    spatial_cut cut = {.cost = HUGE_VAL};
    size_t left = 0;
    if (n > 1 && deep && !fits) left = split_by_number(item, n, box_longest(&s->centres));
    if (n > 1 && !deep) {
        left = split_binned(s, item, n);
        if (room > n && !fits && spatial_overlap(s, item, n, left) > spatial_least_overlap)
            cut = spatial_find(b, item, n);
        if (cut.cost < s->cost && cut.cost < all) left = spatial_apply(b, &cut, item, &n, room);
        else if (fits && s->cost >= all) left = 0;
    }
    size_t first = t->nodes;
    if (left == 0 || !tree_pair(t)) {
        memmove(b->item + t->items, item, n * sizeof *item);
        t->items += n;
        return;
    }
    size_t right = n - left, spare = room - n;
    size_t left_room = left + (size_t)((double)spare * ((double)left / (double)n));
    memmove(item + left_room, item + left, right * sizeof *item);
    t->node[at].first = (uint32_t)first, t->node[at].count = 0;
    spatial_node(b, first, begin, left, left_room, depth + 1);
    spatial_node(b, first + 1, begin + left_room, right, room - left_room, depth + 1);
}

static inline void tree_spatial(const bvh_input *in, bvh_options how, bvh_tree *out)
{
    if (!tree_begin(out, 2 * in->n + 2)) return;
    spatial_builder b = {out, in->item, how, {.item_cost = how.item_cost}, in->clip, in->context};
    out->items = 0;
    if (in->n) spatial_node(&b, 0, 0, in->n, in->room, 0);
}

#endif
