/* Sorting by digits, against the library's qsort: few and many, all keys the same, few values, keys
 * that rise and fall, keys that differ in one digit alone; equal keys keep their order. */
#include "../common/file.h"
#include "../common/numbers/float_round.h"
#include "../common/numbers/radix.h"
#include "../common/random.h"
#include "check.h"

static int by_key(const void *a, const void *b)
{
    uint32_t x = *(const uint32_t *)a, y = *(const uint32_t *)b;
    return (x > y) - (x < y);
}

/* Places differ, so qsort has no choice. */
static int by_pair(const void *a, const void *b)
{
    const radix_pair *x = a, *y = b;
    return x->key != y->key ? (x->key < y->key ? -1 : 1) : x->place > y->place ? 1 : -1;
}

static int by_code(const void *a, const void *b)
{
    const radix_code *x = a, *y = b;
    return x->key != y->key ? (x->key < y->key ? -1 : 1) : x->place > y->place ? 1 : -1;
}

enum { kinds = 8 };

static uint64_t key_of(int kind, size_t i, size_t n)
{
    uint64_t r = random_bits(1, i, n, (uint64_t)kind);
    switch (kind) {
    case 0: return r;
    case 1: return 42;
    case 2: return r & 7;
    case 3: return i;
    case 4: return ~(uint64_t)i;
    case 5: return (r & 7) << 60 | (r >> 3 & 15) << 30 | (r >> 7 & 15);  /* few digits differ */
    case 6: return (r & 255) << (r >> 8 & 1 ? 24 : 8);
    default: return r << 63 | r >> 63;                                   /* the two ends alone */
    }
}

static void compare(size_t n, int kind)
{
    uint32_t *key = allocate(n, sizeof *key), *key_due = allocate(n, sizeof *key);
    radix_pair *pair = allocate(n, sizeof *pair), *pair_due = allocate(n, sizeof *pair);
    radix_code *code = allocate(n, sizeof *code), *code_due = allocate(n, sizeof *code);
    void *spare = allocate(n, sizeof *code);
    size_t wrong[3] = {0, 0, 0};
    for (size_t i = 0; i < n; i++) {
        uint64_t k = key_of(kind, i, n);
        key[i] = key_due[i] = (uint32_t)k;
        pair[i] = pair_due[i] = (radix_pair){(uint32_t)k, (uint32_t)i};
        code[i] = code_due[i] = (radix_code){k, (uint32_t)i};
    }
    qsort(key_due, n, sizeof *key, by_key);
    qsort(pair_due, n, sizeof *pair, by_pair);
    qsort(code_due, n, sizeof *code, by_code);
    radix_sort_keys(key, spare, n);
    radix_sort_pairs(pair, spare, n);
    radix_sort_codes(code, spare, n);
    for (size_t i = 0; i < n; i++) {
        wrong[0] += key[i] != key_due[i];
        wrong[1] += pair[i].key != pair_due[i].key || pair[i].place != pair_due[i].place;
        wrong[2] += code[i].key != code_due[i].key || code[i].place != code_due[i].place;
    }
    check_equal(wrong[0] + wrong[1] + wrong[2], 0,
                "%zu of kind %d: %zu keys, %zu pairs and %zu codes out of place", n, kind, wrong[0],
                wrong[1], wrong[2]);
    free(key), free(key_due), free(pair), free(pair_due), free(code), free(code_due), free(spare);
}

/* Floats in the order of their keys. */
static void test_floats(void)
{
    enum { n = 3000 };
    static uint32_t key[n], spare[n];
    static float x[n];
    size_t wrong = 0;
    for (size_t i = 0; i < n; i++) {
        float f = (float)random_real(2, i, 0, 0) - 0.5f;
        x[i] = f * (i % 3 ? 1 : i % 2 ? 1e-30f : 1e30f);
        key[i] = float_key(x[i]);
    }
    radix_sort_keys(key, spare, n);
    for (size_t i = 0; i < n; i++) {  /* as many are below the i-th as its place says */
        size_t below = 0;
        for (size_t j = 0; j < n; j++) below += float_key(x[j]) < key[i];
        wrong += below > i || (i > 0 && key[i - 1] > key[i]);
    }
    check_equal(wrong, 0, "floats sorted by their keys");
}

int main(void)
{
    size_t most = check_count(120000);
    for (int kind = 0; kind < kinds; kind++)
        for (size_t n = 0; n <= most; n = n < 52 ? n + 1 : 5 * n - 1) compare(n, kind);
    test_floats();
    return check_report("radix");
}
