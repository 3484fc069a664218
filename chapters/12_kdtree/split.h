/* split.h: where to cut a cell, and what to do with the items that the plane cuts.
 *
 *   KD_MIDDLE   in the middle of the cell's longest side (空间中点)
 *   KD_MEDIAN   at the median of the items' centres along it (物体中位数)
 *   KD_SAH      where the surface area heuristic (表面积启发式) says: of all planes in which the box
 *               of an item begins or ends, along all axes, the cheapest
 *
 *   kd_choice c = kd_choose(&s, item, n, &cell)     c.cost HUGE_VAL: no plane cuts this cell
 *   kd_partition(...)                               in build.h: each item to one child or both
 *
 * The heuristic. A line that meets the cell meets its part L with probability area(L) / area(cell):
 * both are convex. So a cut costs (12.1)
 *
 *    cost = c_t + c_i (area(L) n(L) + area(R) n(R)) / area(cell)
 *
 * c_t for a step of the search, c_i for testing an item; a leaf of n costs c_i n. A cut that leaves
 * a part empty costs 1 - bonus of it.
 *
 *    begin   |  |    |     |             All begins in order, all ends in order. At a plane p:
 *    items   [--]  [-|--]  [----]           n(L) = how many begin before p
 *                    [------]               n(R) = n - how many end at or before p
 *    end        |       |   |   |        and both lists are walked through once, side by side.
 *
 * O(n) for each cell, since floats are sorted in O(n) by their bits (radix.h); O(n log n) for all.
 * In a cell of more than kd_bins_from items not all planes are tried, but two for each of 127
 * borders between 128 equal bins: the last side of an item before the border, and the first behind
 * it. A tree of a million triangles is built in less time, and its rays notice nothing.
 *
 * Sources: J. D. MacDonald, K. S. Booth, "Heuristics for ray tracing using space subdivision", The
 * Visual Computer 6, 1990; V. Havran, "Heuristic Ray Shooting Algorithms", PhD thesis, Prague 2000
 * (ch. 4: empty space, when to stop); I. Wald, V. Havran, "On building fast kd-trees for Ray
 * Tracing, and on doing that in O(N log N)", IEEE Symp. Interactive Ray Tracing 2006.
 */
#ifndef KDTREE_SPLIT_H
#define KDTREE_SPLIT_H

#include "../../common/numbers/float_round.h"
#include "../../common/numbers/radix.h"
#include "clip.h"

enum { kdtree_most_depth = 64 };
typedef enum { KD_MIDDLE, KD_MEDIAN, KD_SAH, kdtree_strategies } kdtree_strategy;

/* How an item that lies in a plane is kept. KD_THICK: its box gets one float more on each side, so
 * that it lies in no plane of its own; where another plane cuts it, it goes to both children. The
 * others keep boxes as they are: exact where coordinates are floats. */
typedef enum { KD_THICK, KD_BOTH, KD_ONE } kdtree_planar;

typedef struct {
    kdtree_strategy strategy;
    int leaf;                 /* most items in one; 0: where no cut pays (KD_SAH only; else 4) */
    int depth;                /* of the deepest leaf [1..64]; 0: 8 + 1.3 log2 n            (12.2) */
    double item_cost, empty_bonus;  /* (12.1), with c_t = 1 */
    bool clip;                /* boxes of parts are those of the part (12.3), not cut boxes */
    kdtree_planar planar;
    size_t most_bytes;        /* while it is built; more: kdtree_build returns false */
} kdtree_options;

typedef struct { kd_box box; uint32_t index; } kd_item;
typedef struct { double cost; int axis; float plane; } kd_choice;

enum { kd_bins = 128, kd_bins_from = 512 };

/* begin, end, spare: room for n numbers each, in one block. */
typedef struct { kdtree_options how; uint32_t *begin, *end, *spare; } kd_splitter;

/* ---------------------------------------------------------------------------------------------- */

static inline int kd_longest(const kd_box *b)
{
    float x = b->hi[0] - b->lo[0], y = b->hi[1] - b->lo[1], z = b->hi[2] - b->lo[2];
    return x >= y ? (x >= z ? 0 : 2) : (y >= z ? 1 : 2);
}

/* Only a plane within the cell cuts it: both parts are smaller than the whole. */
static inline bool kd_cuts(const kd_box *cell, int axis, float at)
{
    return at > cell->lo[axis] && at < cell->hi[axis];
}

static inline kd_choice kd_middle(const kd_box *cell)
{
    int k = kd_longest(cell);
    float p = 0.5f * cell->lo[k] + 0.5f * cell->hi[k];
    return (kd_choice){kd_cuts(cell, k, p) ? 0 : HUGE_VAL, k, p};
}

static inline kd_choice kd_median(kd_splitter *s, const kd_item *item, size_t n,
                                  const kd_box *cell)
{
    int k = kd_longest(cell);
    for (size_t i = 0; i < n; i++)
        s->begin[i] = float_key(0.5f * item[i].box.lo[k] + 0.5f * item[i].box.hi[k]);
    radix_sort_keys(s->begin, s->spare, n);
    float p = float_of_key(s->begin[n / 2]);
    return kd_cuts(cell, k, p) ? (kd_choice){0, k, p} : kd_middle(cell);
}

/* (12.1) without c_t and without the division by the area of the cell. */
typedef struct { double side, ring; float lo, hi; } kd_profile;  /* area(x) = side + x ring */

static inline kd_profile kd_profile_of(const kd_box *cell, int k)
{
    int u = (k + 1) % 3, v = (k + 2) % 3;
    double x = (double)cell->hi[u] - (double)cell->lo[u];
    double y = (double)cell->hi[v] - (double)cell->lo[v];
    return (kd_profile){x * y, x + y, cell->lo[k], cell->hi[k]};
}

/* Takes the plane at p if it cuts the cell and is cheaper than the best so far. */
static inline void kd_weigh(const kd_splitter *s, const kd_profile *f, double area, int k, float p,
                            size_t below, size_t above, kd_choice *best)
{
    if (!(p > f->lo && p < f->hi)) return;
    double l = f->side + ((double)p - (double)f->lo) * f->ring;
    double r = f->side + ((double)f->hi - (double)p) * f->ring;
    double sum = l * (double)below + r * (double)above;
    double cost = 1 + s->how.item_cost * sum / area;
    if (below == 0 || above == 0) cost *= 1 - s->how.empty_bonus;
    if (cost < best->cost) *best = (kd_choice){cost, k, p};
}

static inline void kd_sweep_axis(kd_splitter *s, const kd_item *item, size_t n,
                                 const kd_box *cell, int k, kd_choice *best)
{
    kd_profile f = kd_profile_of(cell, k);
    double area = kd_area(cell);
    for (size_t i = 0; i < n; i++) {
        s->begin[i] = float_key(item[i].box.lo[k]);
        s->end[i] = float_key(item[i].box.hi[k]);
    }
    radix_sort_keys(s->begin, s->spare, n), radix_sort_keys(s->end, s->spare, n);
    for (size_t i = 0, j = 0; j < n; ) {
        uint32_t key = i < n && s->begin[i] < s->end[j] ? s->begin[i] : s->end[j];
        float p = float_of_key(key);
        while (j < n && s->end[j] == key) j++;
        kd_weigh(s, &f, area, k, p, i, n - j, best);
        while (i < n && s->begin[i] == key) i++;
    }
}

/* Of the item sides in one bin: how many begin, how many end; the lowest and the highest. */
typedef struct { size_t begin, end; float low, high; } kd_bin;

static inline void kd_bin_add(kd_bin *bin, float lo, float scale, float x, bool end)
{
    float at = (x - lo) * scale;
    kd_bin *b = &bin[at > kd_bins - 1 ? kd_bins - 1 : at > 0 ? (int)at : 0];
    if (end) b->end++;
    else b->begin++;
    b->low = x < b->low ? x : b->low, b->high = x > b->high ? x : b->high;
}

static inline void kd_sweep_bins(const kd_splitter *s, const kd_item *item, size_t n,
                                 const kd_box *cell, int k, kd_choice *best)
{
    kd_bin bin[kd_bins];
    kd_profile f = kd_profile_of(cell, k);
    float scale = kd_bins / (f.hi - f.lo);
    double area = kd_area(cell);
    size_t begun = 0, ended = 0;
    if (!(scale <= FLT_MAX)) return;  /* flat */
    for (int i = 0; i < kd_bins; i++) bin[i] = (kd_bin){0, 0, INFINITY, -INFINITY};
    for (size_t i = 0; i < n; i++) {
        kd_bin_add(bin, f.lo, scale, item[i].box.lo[k], false);
        kd_bin_add(bin, f.lo, scale, item[i].box.hi[k], true);
    }
    for (int i = 0; i + 1 < kd_bins; i++) {
        begun += bin[i].begin, ended += bin[i].end;
        for (int side = 0; side < 2; side++)
            kd_weigh(s, &f, area, k, side ? bin[i + 1].low : bin[i].high, begun, n - ended, best);
    }
}

static inline kd_choice kd_choose(kd_splitter *s, const kd_item *item, size_t n,
                                  const kd_box *cell)
{
    kd_choice best = {HUGE_VAL, 0, 0};
    if (s->how.strategy == KD_MIDDLE) return kd_middle(cell);
    if (s->how.strategy == KD_MEDIAN) return n ? kd_median(s, item, n, cell) : best;
    for (int k = 0; k < 3; k++)
        if (n > kd_bins_from) kd_sweep_bins(s, item, n, cell, k, &best);
        else kd_sweep_axis(s, item, n, cell, k, &best);
    return best;
}

#endif
