/* select.h: the k-th smallest of n keys in O(n), whatever the keys: introselect.
 *
 *   select_item(item, n, k, axis)     afterwards item[0 .. k-1] <= item[k] <= item[k+1 .. n-1]
 *
 * Quickselect halves the rest on average: n + n/2 + n/4 + ... = 2 n comparisons. A bad choice of
 * pivot again and again makes n^2 of it. So the pivot is the median of three at first; once the
 * rest has not halved within three passes, it is the middle of the least and the greatest key. As
 * keys are whole numbers of 64 bits, no more than 64 such cuts are possible: the sum stays O(n) for
 * every input.
 *
 * The key of an item is the centre of its box along `axis` (twice, which spares halving it); equal
 * centres are ordered by index, and one that is no number (of a box without end) has its place. So
 * no two keys are equal, a million coincident items are no special case, and which items come
 * first does not depend on the order in which they were given.
 *
 * Sources: C. A. R. Hoare, "Algorithm 65: Find", CACM 4(7), 1961; D. Musser, "Introspective sorting
 * and selection algorithms", Software: Practice and Experience 27(8), 1997.
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

static inline uint64_t item_key(const bvh_item *i, int axis)
{
    return (uint64_t)float_key(item_centre(i, axis)) << 32 | i->index;
}

static inline void item_swap(bvh_item *a, bvh_item *b)
{
    bvh_item c = *a;
    *a = *b, *b = c;
}

/* A key above the least and below the greatest of a, b, c. */
static inline uint64_t middle_of_three(uint64_t a, uint64_t b, uint64_t c)
{
    if (a > b) { uint64_t s = a; a = b, b = s; }
    return c <= a ? a : c >= b ? b : c;
}

/* Halfway between the least key and the greatest, rounded up. */
static inline uint64_t middle_of_all(const bvh_item *item, size_t n, int axis)
{
    uint64_t least = UINT64_MAX, most = 0;
    for (size_t i = 0; i < n; i++) {
        uint64_t key = item_key(&item[i], axis);
        least = key < least ? key : least, most = key > most ? key : most;
    }
    return most - (most - least) / 2;
}

static inline void insertion_sort(bvh_item *item, size_t n, int axis)
{
    for (size_t i = 1; i < n; i++) {
        bvh_item x = item[i];
        uint64_t key = item_key(&x, axis);
        size_t j = i;
        for (; j > 0 && key < item_key(&item[j - 1], axis); j--) item[j] = item[j - 1];
        item[j] = x;
    }
}

static inline void select_item(bvh_item *item, size_t n, size_t k, int axis)
{
    size_t goal = n / 2;  /* the size to be reached within three passes */
    int passes = 0;
    while (n > 6) {
        uint64_t pivot = passes == 3 ? middle_of_all(item, n, axis)
                         : middle_of_three(item_key(&item[0], axis), item_key(&item[n / 2], axis),
                                           item_key(&item[n - 1], axis));
        size_t left = 0;
        for (size_t i = 0; i < n; i++)
            if (item_key(&item[i], axis) < pivot) item_swap(&item[i], &item[left++]);
        if (k < left) n = left;
        else item += left, n -= left, k -= left;
        if (n <= goal) goal = n / 2, passes = 0;
        else if (passes < 3) passes++;
    }
    insertion_sort(item, n, axis);
}

#endif
