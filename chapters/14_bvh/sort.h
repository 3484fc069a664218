/* sort.h: floats sorted in O(n), by their digits (基数排序, radix sort).
 *
 *   sort_pairs(pair, spare, n)        by key; equal keys keep their order; spare[n] is overwritten
 *
 * The key of a float is float_key of 09.
 *
 * No two keys are compared. They are thrown into 256 drawers by their last 8 bits, taken out drawer
 * by drawer, thrown again by the next 8 bits, and so on: four passes. Each keeps the order that the
 * ones before it have made, where its own digits are the same.
 *
 * Source: D. Knuth, "The Art of Computer Programming" 3, 1998, 5.2.5 (sorting by distribution).
 */
#ifndef BVH_SORT_H
#define BVH_SORT_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

typedef struct { uint32_t key, place; } sort_pair;

/* ---------------------------------------------------------------------------------------------- */

/* Few are sorted by insertion. */
static inline void sort_pairs(sort_pair *pair, sort_pair *spare, size_t n)
{
    if (n <= 32) {
        for (size_t i = 1; i < n; i++) {
            sort_pair p = pair[i];
            size_t j = i;
            for (; j > 0 && pair[j - 1].key > p.key; j--) pair[j] = pair[j - 1];
            pair[j] = p;
        }
        return;
    }
    for (int shift = 0; shift < 32; shift += 8) {  /* four passes: ends where it began */
        size_t start[257] = {0};
        for (size_t i = 0; i < n; i++) start[(pair[i].key >> shift & 255) + 1]++;
        for (int i = 0; i < 256; i++) start[i + 1] += start[i];
        for (size_t i = 0; i < n; i++) spare[start[pair[i].key >> shift & 255]++] = pair[i];
        sort_pair *p = pair;
        pair = spare, spare = p;
    }
}

#endif
