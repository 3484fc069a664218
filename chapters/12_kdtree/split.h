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
 * both are convex. So a cut costs (12.4)
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

typedef enum { KD_MIDDLE, KD_MEDIAN, KD_SAH, kdtree_strategies } kdtree_strategy;

typedef struct { kd_box box; uint32_t index; } kd_item;
typedef struct { double cost; int axis; float plane; } kd_choice;

typedef struct {
    kdtree_strategy strategy;
    double traversal_cost, item_cost, empty_bonus;
    uint32_t *begin, *end, *spare;  /* room for n numbers each */
} kd_splitter;

/* ---------------------------------------------------------------------------------------------- */

/* The float of a float_key (09). */
static inline float kd_unkey(uint32_t key)
{
    float x;
    key = key & 0x80000000u ? key & 0x7fffffffu : ~key;
    memcpy(&x, &key, sizeof x);
    return x;
}

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
    float p = kd_unkey(s->begin[n / 2]);
    return kd_cuts(cell, k, p) ? (kd_choice){0, k, p} : kd_middle(cell);
}

/* (12.4) without c_t and without the division by the area of the cell. */
typedef struct { double side, ring; float lo, hi; } kd_profile;  /* area(x) = side + x ring */

static inline double kd_sum(const kd_profile *f, float p, size_t below, size_t above)
{
    double l = f->side + ((double)p - (double)f->lo) * f->ring;
    double r = f->side + ((double)f->hi - (double)p) * f->ring;
    return l * (double)below + r * (double)above;
}

static inline void kd_sweep_axis(kd_splitter *s, const kd_item *item, size_t n,
                                 const kd_box *cell, int k, kd_choice *best)
{
    int u = (k + 1) % 3, v = (k + 2) % 3;
    double x = (double)cell->hi[u] - (double)cell->lo[u];
    double y = (double)cell->hi[v] - (double)cell->lo[v], area = kd_area(cell);
    kd_profile f = {x * y, x + y, cell->lo[k], cell->hi[k]};
    for (size_t i = 0; i < n; i++) {
        s->begin[i] = float_key(item[i].box.lo[k]);
        s->end[i] = float_key(item[i].box.hi[k]);
    }
    radix_sort_keys(s->begin, s->spare, n), radix_sort_keys(s->end, s->spare, n);
    for (size_t i = 0, j = 0; j < n; ) {
        uint32_t key = i < n && s->begin[i] < s->end[j] ? s->begin[i] : s->end[j];
        float p = kd_unkey(key);
        while (j < n && s->end[j] == key) j++;
        if (kd_cuts(cell, k, p)) {
            double cost = s->traversal_cost + s->item_cost * kd_sum(&f, p, i, n - j) / area;
            if (i == 0 || j == n) cost *= 1 - s->empty_bonus;
            if (cost < best->cost) *best = (kd_choice){cost, k, p};
        }
        while (i < n && s->begin[i] == key) i++;
    }
}

static inline kd_choice kd_choose(kd_splitter *s, const kd_item *item, size_t n,
                                  const kd_box *cell)
{
    kd_choice best = {HUGE_VAL, 0, 0};
    if (s->strategy == KD_MIDDLE) return kd_middle(cell);
    if (s->strategy == KD_MEDIAN) return n ? kd_median(s, item, n, cell) : best;
    for (int k = 0; k < 3; k++) kd_sweep_axis(s, item, n, cell, k, &best);
    return best;
}

#endif
