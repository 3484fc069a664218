/* radix.h: sorting by digits (基数排序, radix sort): O(n), no two keys are compared.
 *
 *   radix_sort_keys(key, spare, n)       whole numbers of 32 bits
 *   radix_sort_pairs(pair, spare, n)     by a key of 32 bits; equal keys keep their order
 *   radix_sort_codes(code, spare, n)     by a key of 64 bits; equal keys keep their order
 *
 * n < 2^32; spare[n] is overwritten. Floats are sorted by their float_key (float_round.h).
 *
 * The records are thrown into 256 drawers by their last 8 bits, taken out drawer by drawer, thrown
 * again by the next 8 bits, and so on. Each pass keeps the order that those before it have made,
 * where its own digits are the same: after the last pass all digits are in order. All counts come
 * from one reading; a pass in which everything lies in one drawer is left out. Keys of 64 bits take
 * digits of 11 bits, 6 passes instead of 8; few records are sorted by insertion.
 *
 * Source: D. Knuth, "The Art of Computer Programming" 3, 1998, 5.2.5 (sorting by distribution).
 */
#ifndef RADIX_H
#define RADIX_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

typedef struct { uint32_t key, place; } radix_pair;
typedef struct { uint64_t key; uint32_t place; } radix_code;

/* ---------------------------------------------------------------------------------------------- */

enum { radix_few = 48, radix_most_drawers = 6 << 11 };

/* A record begins with its key. `key64`, `size` and `digit` are known where this is called, so that
 * a record is moved by one or two instructions. */
fast_inline uint64_t radix_key(const void *record, bool key64)
{
    uint64_t w;
    uint32_t k;
    if (key64) return memcpy(&w, record, sizeof w), w;
    return memcpy(&k, record, sizeof k), k;
}

fast_inline void radix_insert(char *record, size_t n, size_t size, bool key64)
{
    for (size_t i = 1; i < n; i++) {
        char moved[sizeof(radix_code)];
        size_t j = i;
        memcpy(moved, record + i * size, size);
        uint64_t key = radix_key(moved, key64);
        for (; j > 0 && radix_key(record + (j - 1) * size, key64) > key; j--)
            memcpy(record + j * size, record + (j - 1) * size, size);
        memcpy(record + j * size, moved, size);
    }
}

fast_inline void radix_sort(void *record, void *spare, size_t n, size_t size, bool key64,
                            int digit)
{
    uint32_t start[radix_most_drawers];
    int passes = ((key64 ? 64 : 32) + digit - 1) / digit;
    size_t drawers = (size_t)1 << digit;
    char *from = record, *to = spare;
    if (n <= radix_few) {
        radix_insert(record, n, size, key64);
        return;
    }
    memset(start, 0, (size_t)passes * drawers * sizeof *start);
    for (size_t i = 0; i < n; i++) {
        uint64_t key = radix_key(from + i * size, key64);
        for (int p = 0; p < passes; p++)
            start[(size_t)p * drawers + (key >> (p * digit) & (drawers - 1))]++;
    }
    for (int p = 0; p < passes; p++) {
        uint32_t *at = start + (size_t)p * drawers, sum = 0;
        int shift = p * digit;
        if (at[radix_key(from, key64) >> shift & (drawers - 1)] == n) continue;
        for (size_t d = 0; d < drawers; d++) {
            uint32_t here = at[d];
            at[d] = sum, sum += here;
        }
        for (size_t i = 0; i < n; i++) {
            size_t drawer = radix_key(from + i * size, key64) >> shift & (drawers - 1);
            memcpy(to + at[drawer]++ * size, from + i * size, size);
        }
        char *other = from;
        from = to, to = other;
    }
    if (from != (char *)record) memcpy(record, from, n * size);
}

/* Never inlined: the drawers of all passes would be on the stack of whoever calls, and a builder
 * that calls itself has many such frames. */
__attribute__((noinline, unused))
static void radix_sort_keys(uint32_t *key, uint32_t *spare, size_t n)
{
    radix_sort(key, spare, n, sizeof *key, false, 8);
}

__attribute__((noinline, unused))
static void radix_sort_pairs(radix_pair *pair, radix_pair *spare, size_t n)
{
    radix_sort(pair, spare, n, sizeof *pair, false, 8);
}

__attribute__((noinline, unused))
static void radix_sort_codes(radix_code *code, radix_code *spare, size_t n)
{
    radix_sort(code, spare, n, sizeof *code, true, 11);
}

#endif
