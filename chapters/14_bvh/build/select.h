/* select.h: the k-th smallest of n keys in O(n), whatever the keys: introselect.
 *
 *   select_item(item, n, k, axis)     afterwards item[0 .. k-1] <= item[k] <= item[k+1 .. n-1]
 *
 * Quickselect halves the rest on average: n + n/2 + n/4 + ... = 2 n comparisons. A bad choice of
 * pivot again and again makes n^2 of it. So the pivot is the median of three at first; once the
 * rest has not halved within three passes, it is the median of medians of five (Blum et al.),
 * whose rest is at most 7/10 n + 4: the sum stays O(n) for every input.
 *
 * The key of an item is the centre of its box along `axis` (twice, which spares halving it); equal
 * centres are ordered by index, and one that is no number (of a box without end) has its place. So
 * no two keys are equal, a million coincident items are no special case, and which items come
 * first does not depend on the order in which they were given.
 *
 * Sources: C. A. R. Hoare, "Algorithm 65: Find", CACM 4(7), 1961; M. Blum, R. Floyd, V. Pratt,
 * R. Rivest, R. Tarjan, "Time bounds for selection", J. Comp. Syst. Sci. 7, 1973; D. Musser,
 * "Introspective sorting and selection algorithms", Software: Practice and Experience 27(8), 1997.
 */
#ifndef BVH_SELECT_H
#define BVH_SELECT_H

#include "../node.h"
#include <stddef.h>

/* ---------------------------------------------------------------------------------------------- */

static inline float item_centre(const bvh_item *i, int axis)
{
    return i->low[axis] - i->minus_high[axis];
}

static inline bool item_before(const bvh_item *a, const bvh_item *b, int axis)
{
    uint32_t x = float_key(item_centre(a, axis)), y = float_key(item_centre(b, axis));
    return x < y || (x == y && a->index < b->index);
}

static inline void item_swap(bvh_item *a, bvh_item *b)
{
    bvh_item c = *a;
    *a = *b, *b = c;
}

static inline size_t median_of_three(const bvh_item *item, size_t a, size_t b, size_t c, int axis)
{
    if (item_before(&item[b], &item[a], axis)) { size_t s = a; a = b, b = s; }
    if (!item_before(&item[c], &item[b], axis)) return b;
    return item_before(&item[c], &item[a], axis) ? a : c;
}

static inline void insertion_sort(bvh_item *item, size_t n, int axis)
{
    for (size_t i = 1; i < n; i++)
        for (size_t j = i; j > 0 && item_before(&item[j], &item[j - 1], axis); j--)
            item_swap(&item[j], &item[j - 1]);
}

static inline void select_item(bvh_item *item, size_t n, size_t k, int axis);

/* The medians of all fives go to the front; their median is the pivot. Returns its place. */
static inline size_t median_of_medians(bvh_item *item, size_t n, int axis)
{
    size_t fives = n / 5;
    for (size_t i = 0; i < fives; i++) {
        insertion_sort(item + 5 * i, 5, axis);
        item_swap(&item[i], &item[5 * i + 2]);
    }
    select_item(item, fives, fives / 2, axis);
    return fives / 2;
}

/* Items before the pivot to the front, the pivot behind them: its place. Indices differ, so that no
 * two items are equal. */
static inline size_t partition_at(bvh_item *item, size_t n, size_t pivot, int axis)
{
    size_t left = 0;
    item_swap(&item[pivot], &item[n - 1]);
    bvh_item p = item[n - 1];
    for (size_t i = 0; i + 1 < n; i++)
        if (item_before(&item[i], &p, axis)) item_swap(&item[i], &item[left++]);
    item_swap(&item[left], &item[n - 1]);
    return left;
}

static inline void select_item(bvh_item *item, size_t n, size_t k, int axis)
{
    size_t goal = n / 2;  /* the size to be reached within three passes */
    int passes = 0;
    while (n > 10) {
        bool slow = passes == 3;
        size_t pivot = slow ? median_of_medians(item, n, axis)
                            : median_of_three(item, 0, n / 2, n - 1, axis);
        size_t place = partition_at(item, n, pivot, axis);
        if (k == place) return;
        if (k < place) n = place;
        else item += place + 1, n -= place + 1, k -= place + 1;
        if (n <= goal) goal = n / 2, passes = 0;
        else if (!slow) passes++;
    }
    insertion_sort(item, n, axis);
}

#endif
