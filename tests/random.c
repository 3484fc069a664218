/* Tests of common/random.h. Each statistical test has a fixed seed and a false-alarm rate: that of
 * rejecting a perfect generator, had the seed been drawn. All together stay below 1e-4. */
#include "check.h"
#include "../common/random.h"
#include <string.h>

/* The value that a chi-square of k degrees of freedom exceeds with probability 1e-6: the cube root
 * is nearly normal (E. Wilson, M. Hilferty, "The distribution of chi-square", PNAS 17, 1931). */
static double chi_square_bound(double k)
{
    double z = 4.7534, c = 2 / (9 * k), root = 1 - c + z * sqrt(c);
    return k * root * root * root;
}

static double chi_square(const size_t *count, size_t bins, double n)
{
    double sum = 0, expected = n / (double)bins;
    for (size_t i = 0; i < bins; i++)
        sum += ((double)count[i] - expected) * ((double)count[i] - expected) / expected;
    return sum;
}

/* Which key counts up from number to number, and which pairs of neighbours get compared. */
typedef enum { BY_SEED, BY_PIXEL, BY_SAMPLE, BY_DIMENSION, BY_STREAM, keys } key_name;
static const char *const name[keys] = {"seed", "pixel", "sample", "dimension", "stream"};

static real number(key_name key, uint64_t i, uint64_t base)
{
    static random_stream s;
    if (key == BY_STREAM) {
        if (i == 0) s = random_start(base, 5, 6);
        return random_next(&s);
    }
    return random_real(key == BY_SEED ? i : base, key == BY_PIXEL ? i : base,
                       key == BY_SAMPLE ? i : base, key == BY_DIMENSION ? i : base);
}

/* One number at a time in 256 bins; overlapping pairs of neighbours in 64 x 64 (serial test). */
static void test_along(key_name key, uint64_t base)
{
    enum { side = 64 };
    static size_t one[256], pair[side * side];
    size_t n = check_count(400000);
    double last = 0, product = 0, sum = 0;
    memset(one, 0, sizeof one), memset(pair, 0, sizeof pair);
    for (uint64_t i = 0; i < 2 * n; i++) {
        double x = (double)number(key, i, base);
        one[(int)(x * 256)]++;
        if (i % 2) pair[(int)(last * side) * side + (int)(x * side)]++;
        product += (last - 0.5) * (x - 0.5), sum += x;
        last = x;
    }
    check_at_most(chi_square(one, 256, 2.0 * (double)n), chi_square_bound(255),
                  "chi-square along %s from %d, false alarm 1e-6", name[key], (int)base);
    check_at_most(chi_square(pair, side * side, (double)n), chi_square_bound(side * side - 1),
                  "serial test along %s from %d, false alarm 1e-6", name[key], (int)base);
    check_at_most(fabs(product) * 12 / sqrt(2.0 * (double)n), 4.9,
                  "correlation of neighbours along %s, in sigmas, false alarm 1e-6", name[key]);
    check_close(sum / (2.0 * (double)n), 0.5, 4.9 * sqrt(1 / (24.0 * (double)n)),
                "mean along %s, false alarm 1e-6", name[key]);
}

/* Two keys at once: the number at key and at key + 1 of a grid of the other keys, 32 x 32 bins. */
static void test_across(key_name key)
{
    enum { side = 32 };
    static size_t pair[side * side];
    size_t n = check_count(400000);
    memset(pair, 0, sizeof pair);
    for (uint64_t i = 0; i < n; i++) {
        uint64_t k[4] = {i % 7, i / 7 % 640, i / 4480, i % 5};
        real x = random_real(k[0], k[1], k[2], k[3]);
        k[key]++;
        real y = random_real(k[0], k[1], k[2], k[3]);
        pair[(int)(x * side) * side + (int)(y * side)]++;
    }
    check_at_most(chi_square(pair, side * side, (double)n), chi_square_bound(side * side - 1),
                  "pairs one %s apart over a grid of keys, false alarm 1e-6", name[key]);
}

static int word_order(const void *a, const void *b)
{
    uint64_t x = *(const uint64_t *)a, y = *(const uint64_t *)b;
    return (x > y) - (x < y);
}

/* All small keys: 2^20 words of 64 bits, of which any two agree with probability 2^39 / 2^64. Keys
 * that are exchanged, or that wrap round, would give the same words. */
static void test_distinct(void)
{
    enum { side = 32 };
    size_t n = 0, equal = 0;
    uint64_t *word = malloc(sizeof *word * side * side * side * side);
    for (uint64_t s = 0; s < side; s++)
        for (uint64_t p = 0; p < side; p++)
            for (uint64_t m = 0; m < side; m++)
                for (uint64_t d = 0; d < side; d++) word[n++] = random_bits(s, p, m, d);
    qsort(word, n, sizeof *word, word_order);
    for (size_t i = 1; i < n; i++) equal += word[i] == word[i - 1];
    check_equal(equal, 0, "equal words among all keys below 32, false alarm 3e-8");
    free(word);
}

/* Streams are parts of one cycle: two overlap if their places, in steps, are close. Among m streams
 * pairs closer than D steps are m^2 D / 2^64: here 1e-5. */
static void test_streams_apart(void)
{
    enum { m = 1 << 16 };
    static uint64_t place[m];
    uint64_t inverse = random_step, closest = UINT64_MAX;
    for (int k = 0; k < 5; k++) inverse *= 2 - random_step * inverse;  /* of the step, mod 2^64 */
    check(inverse * random_step == 1, "inverse of the step");
    for (uint64_t i = 0; i < m; i++)
        place[i] = random_start(i % 16, i / 16 % 64, i / 1024).key * inverse;
    qsort(place, m, sizeof *place, word_order);
    for (size_t i = 1; i < m; i++)
        if (place[i] - place[i - 1] < closest) closest = place[i] - place[i - 1];
    check_at_least(closest, 40000, "numbers until the nearest two of 65536 streams meet");
}

/* One bit of a key changes half of the bits: 64 x 64 means over n trials, sigma 0.5 / sqrt(n). */
static void test_avalanche(void)
{
    size_t n = check_count(4000);
    double worst = 0;
    for (int key = 0; key < 4; key++)
        for (int bit = 0; bit < 64; bit++) {
            static size_t flips[64];
            memset(flips, 0, sizeof flips);
            for (uint64_t i = 0; i < n; i++) {
                uint64_t k[4] = {i, 3 * i, i / 2, 7};
                uint64_t a = random_bits(k[0], k[1], k[2], k[3]);
                k[key] ^= (uint64_t)1 << bit;
                uint64_t changed = a ^ random_bits(k[0], k[1], k[2], k[3]);
                for (int j = 0; j < 64; j++) flips[j] += changed >> j & 1;
            }
            for (int j = 0; j < 64; j++)
                worst = fmax(worst, fabs((double)flips[j] / (double)n - 0.5) * 2 * sqrt((double)n));
        }
    check_at_most(worst, 6.2, "sigmas of 16384 avalanche means, false alarm 1e-5");
}

static void test_range(void)
{
    check(random_float_of(UINT64_MAX) < 1, "all ones stay below 1 in float");
    check(random_double_of(UINT64_MAX) < 1, "all ones stay below 1 in double");
    check(random_real_of(UINT64_MAX) < 1, "all ones stay below 1 in real");
    check_equal((float)UINT32_MAX * 0x1p-32f, 1, "the short cut does reach 1");
    check_equal(random_float_of(UINT64_MAX), 1 - FLT_EPSILON / 2, "the largest float below 1");
    check_equal(random_double_of(UINT64_MAX), 1 - DBL_EPSILON / 2, "the largest double below 1");
    check_equal(random_double_of(0), 0, "0 is in");
    check_equal(random_double_of((uint64_t)1 << 63), 0.5, "the highest bit is worth one half");
    check_equal(random_real(1, 2, 3, 4), random_real(1, 2, 3, 4), "the same keys, the same number");
    check(random_bits(random_step, 4, 5, 6) != random_bits(0, 5, 5, 6)
          && random_bits(0, random_step, 4, 5) != random_bits(0, 0, 5, 5)
          && random_bits(0, 0, random_step, 4) != random_bits(0, 0, 0, 5),
          "a step of one key is not a step of the next");
    random_stream s = random_start(1, 2, 3);
    for (uint64_t d = 0; d < 10; d++)
        check_equal(random_next(&s), random_real(1, 2, 3, d), "a stream counts dimensions");
    check(random_mix(1) == 0x5692161d100b05e5u, "variant 13 of 1: by hand with arbitrary integers");
}

int main(void)
{
    test_range();
    for (int key = 0; key < keys; key++)
        test_along((key_name)key, 0), test_along((key_name)key, 41);
    for (int key = 0; key < BY_STREAM; key++) test_across((key_name)key);
    test_distinct();
    test_streams_apart();
    test_avalanche();
    return check_report("random");
}
