/* Tests of 20_monte_carlo: sets of points. What is exact is tested exactly: nets, radical inverses,
 * permutations. What is random has a fixed seed and the false-alarm rate 1e-8 each; there are fewer
 * than 100 such tests. */
#include "../common/lab/chi_square.h"
#include "../chapters/20_monte_carlo/lab/integrands.h"
#include "../common/lab/t_test.h"
#include "check.h"

#define alarm 1e-8
static const real last = 1 - real_epsilon / 2;

/* ---- Sobol's points ---- */

static uint32_t sobol_x(uint32_t i) { return reversed_bits(i); }
static uint32_t sobol_y(uint32_t i) { return reversed_bits(sobol_index_of_y(i)); }

typedef uint32_t scramble(uint32_t x, uint32_t seed);
static uint32_t as_it_is(uint32_t x, uint32_t seed) { return (void)seed, x; }
static uint32_t owen_scramble(uint32_t x, uint32_t seed)
{
    return reversed_bits(owen_reversed(reversed_bits(x), seed));
}

/* Boxes of 2^-a x 2^-b, a + b = m, in all m + 1 shapes, that do not hold exactly one of the points.
 * */
static size_t net_faults(const uint32_t *x, const uint32_t *y, int m)
{
    static unsigned char held[1 << 12];
    size_t faults = 0;
    for (int a = 0; a <= m; a++) {
        memset(held, 0, (size_t)1 << m);
        for (uint32_t i = 0; i < (uint32_t)1 << m; i++)
            held[(uint64_t)x[i] >> (32 - a) << (m - a) | (uint64_t)y[i] >> (32 - (m - a))]++;
        for (uint32_t i = 0; i < (uint32_t)1 << m; i++) faults += held[i] != 1;
    }
    return faults;
}

static void test_nets(void)
{
    static const struct { const char *name; scramble *how; } way[2] = {
        {"unscrambled", as_it_is}, {"owen_scramble", owen_scramble}};
    static uint32_t x[1 << 12], y[1 << 12];
    for (int k = 0; k < 2; k++)
        for (int m = 0; m <= 12; m++) {
            size_t faults = 0;
            for (uint32_t start = 0; start < 3; start++) {  /* also later blocks of 2^m */
                uint32_t block = start * 77777 << m, seed = (uint32_t)random_bits(1, start, 0, 0);
                for (uint32_t i = 0; i < (uint32_t)1 << m; i++) {
                    x[i] = way[k].how(sobol_x(block + i), seed);
                    y[i] = way[k].how(sobol_y(block + i), ~seed);
                }
                faults += net_faults(x, y, m);
            }
            check_equal(faults, 0, "%s, 2^%d points: boxes without exactly one", way[k].name, m);
        }
    for (uint32_t i = 0; i < 256; i++) x[i] = (uint32_t)random_bits(2, i, 0, 0), y[i] = sobol_y(i);
    check_at_least(net_faults(x, y, 8), 100, "random x are no net");
}

/* The pairs that a renderer gets: the first 2^m of them are a net, in any pair. */
static void test_sampler_nets(void)
{
    static uint32_t x[256], y[256];
    for (uint32_t pair = 0; pair < 6; pair++)
        for (uint64_t pixel = 0; pixel < 5; pixel++) {
            for (uint32_t i = 0; i < 256; i++) {
                sampler s = sampler_start(SEQUENCE_SOBOL, 9, pixel, i, 1000);
                for (uint32_t d = 0; d < pair; d++) sampler_pair(&s);
                point2 p = sampler_pair(&s);
                x[i] = (uint32_t)ldexp((double)p.u, 32), y[i] = (uint32_t)ldexp((double)p.v, 32);
            }
            check_equal(net_faults(x, y, 8), 0, "pair %d", (int)pair);
        }
}

/* v_0 = 1/2, v_(k+1) = v_k xor v_k/2: Pascal's triangle modulo 2. */
static void test_sobol_definition(void)
{
    size_t wrong = 0;
    for (uint64_t k = 0; k < check_count(100000); k++) {
        uint32_t i = k < 4096 ? (uint32_t)k : (uint32_t)random_bits(3, k, 0, 0), y = 0;
        uint32_t v = (uint32_t)1 << 31, x = 0;
        for (int bit = 0; bit < 32; bit++, v ^= v >> 1) {
            if (i >> bit & 1) y ^= v;
            x |= (i >> bit & 1) << (31 - bit);
        }
        wrong += x != sobol_x(i) || y != sobol_y(i);
    }
    check_equal(wrong, 0, "points that differ from the definition");
}

/* Owen: two words that agree in exactly k upper bits do so afterwards. And each output bit is a
 * fair coin. */
static void test_scramble(void)
{
    size_t broken = 0, n = check_count(40000);
    double ones[32] = {0}, sum = 0;
    for (uint64_t i = 0; i < n; i++) {
        uint32_t seed = (uint32_t)random_bits(4, i, 0, 0), x = (uint32_t)random_bits(4, i, 1, 0);
        int equal = (int)(i % 32);  /* bits in common, then one that differs */
        uint32_t other = x ^ ((uint32_t)random_bits(4, i, 2, 0) | (uint32_t)1 << 31) >> equal;
        uint32_t y = owen_scramble(0xa5c30f12, seed);
        broken += !((owen_scramble(x, seed) ^ owen_scramble(other, seed)) >> (31 - equal) == 1);
        for (int bit = 0; bit < 32; bit++) ones[bit] += y >> bit & 1;
    }
    check_equal(broken, 0, "prefixes in common that changed");
    /* each count is binomial: its square over variance, 32 of them, is chi-square */
    for (int bit = 0; bit < 32; bit++) sum += pow(ones[bit] - (double)n / 2, 2) / ((double)n / 4);
    check_at_least(chi_square_p(sum, 32), alarm, "fair coins");
}

/* ---- Halton's ---- */

static void test_radical_inverse(void)
{
    check_equal(radical_inverse(2, 0), 0, "0");
    check_equal(radical_inverse(2, 6), (real)0.375, "110 -> .011");
    check_equal(radical_inverse(3, 5), (real)7 / 9, "12 -> .21 = 7/9");
    check_equal(radical_inverse(10, 1234567), (real)0.7654321, "decimal digits mirrored");
    size_t wrong = 0, base_2 = 0, outside = 0;
    for (uint64_t k = 0; k < check_count(100000); k++) {
        uint32_t i = (uint32_t)(random_bits(5, k, 0, 0) >> (32 + k % 32));
        uint32_t base = halton_base[k % halton_bases];
        uint64_t n = 0, d = 1;
        for (uint32_t j = i; j > 0; j /= base) n = n * base + j % base, d *= base;
        /* both below 2^53: the division is the nearest double of the exact fraction */
        real exact = real_min((real)((double)n / (double)d), last);
        wrong += radical_inverse(base, i) != exact;
        base_2 += (double)radical_inverse(2, i) != fmin(sobol_x(i) * 0x1p-32, (double)last)
                  && !real_is_float;
        outside += !(radical_inverse(base, i) < 1);
    }
    check_equal(wrong, 0, "radical inverse off by any bit");
    check_equal(base_2, 0, "base 2 reverses the bits");
    check_equal(outside, 0, "outside [0,1)");
    check(radical_inverse(3, 3486784400u) < 1, "twenty digits 2 stay below 1");
}

/* ---- jittered ---- */

static void test_permuted(void)
{
    static unsigned char held[5000];
    size_t faults = 0;
    for (uint32_t n = 1; n <= 5000; n += n < 300 ? 1 : 599)
        for (uint64_t key = 0; key < 3; key++) {
            memset(held, 0, sizeof held);
            for (uint32_t i = 0; i < n; i++) {
                uint32_t j = permuted(i, n, random_mix(key));
                if (j < n) held[j]++;
            }
            for (uint32_t i = 0; i < n; i++) faults += held[i] != 1;
        }
    check_equal(faults, 0, "numbers that do not come exactly once");
    check(permuted(UINT32_MAX - 1, UINT32_MAX, 5) < UINT32_MAX, "as many as there are");
    /* over the keys: each place alike, and each pair of places */
    size_t keys = check_count(60000);
    for (uint32_t n = 4; n <= 16; n += 4) {
        double one[16] = {0}, pair[256] = {0}, even[16], apart[256];
        for (uint64_t k = 0; k < keys; k++) {
            uint32_t a = permuted(1, n, random_mix(k)), b = permuted(3, n, random_mix(k));
            one[a]++, pair[a * n + b]++;
        }
        for (uint32_t i = 0; i < n; i++) even[i] = (double)keys / n;
        for (uint32_t i = 0; i < n * n; i++)
            apart[i] = i / n == i % n ? 0 : (double)keys / (n * (n - 1));
        check_at_least(chi_square_test(one, even, n).p, alarm, "places of one of %u", n);
        check_at_least(chi_square_test(pair, apart, n * n).p, alarm, "places of two of %u", n);
    }
}

static void test_cells(void)
{
    for (uint32_t n = 1; n <= 300; n += n < 40 ? 1 : 13) {
        uint32_t a = jitter_columns(n), b = (n + a - 1) / a, twice = 0, outside = 0, line = 0;
        check(a * b >= n && a * (b - 1) < n, "%u cells are enough, without a row to spare", n);
        check(b <= a && b + 1 >= a, "%u x %u cells are nearly squares", a, b);
        unsigned char held[400] = {0}, held_1[400] = {0};
        for (uint32_t i = 0; i < n; i++) {
            sampler s = sampler_start(SEQUENCE_JITTERED, 3, 5, i, n);
            point2 p = sampler_pair(&s);
            real x = sampler_number(&s);
            outside += !(p.u >= 0 && p.v >= 0 && p.u < 1 && p.v < 1 && x >= 0 && x < 1);
            twice += held[(int)(p.v * (real)b) * (int)a + (int)(p.u * (real)a)]++ > 0;
            line += held_1[(int)(x * (real)n)]++ > 0;
        }
        check_equal(twice, 0, "cells met twice by %u", n);
        check_equal(line, 0, "cells of the line met twice by %u", n);
        check_equal(outside, 0, "outside [0,1)");
    }
    check(jitter_place(999999999, 1000000000, last) < 1, "the last cell ends below 1");
}

/* Halton's points as they are: bases 2 and 3, then 5 and 7; of these keys are no part. */
static void test_plain_halton(void)
{
    for (uint32_t i = 0; i < 100; i++) {
        sampler s = sampler_start(SEQUENCE_HALTON, 3, 5, i, 100);
        point2 p = sampler_pair(&s), q = sampler_pair(&s);
        check(p.u == radical_inverse(2, i) && p.v == radical_inverse(3, i), "bases 2, 3: %u", i);
        check(q.u == radical_inverse(5, i) && q.v == radical_inverse(7, i), "bases 5, 7: %u", i);
    }
}

/* ---- all kinds alike ---- */

static point2 pair_of(sequence_kind kind, uint64_t seed, uint64_t pixel, uint32_t i, uint32_t n,
                      uint32_t pair)
{
    sampler s = sampler_start(kind, seed, pixel, i, n);
    s.pair = pair;
    return sampler_pair(&s);
}

/* One sample, over many pixels: uniform in the square; and its first pair independent of the next.
 * Over many seeds the same. */
static void test_uniform(void)
{
    enum { side = 16, bins = side * side };
    for (int kind = 0; kind < sequence_kinds; kind++) {
        if (kind == SEQUENCE_HALTON) continue;  /* not random */
        double count[3][bins] = {{0}}, even[bins];
        size_t n = check_count(40000);
        for (uint64_t k = 0; k < n; k++) {
            point2 p = pair_of((sequence_kind)kind, 1, k, 3, 10, 0);
            point2 q = pair_of((sequence_kind)kind, 1, k, 3, 10, 1);
            point2 r = pair_of((sequence_kind)kind, k, 1, 9, 10, 9);
            count[0][(int)(p.u * side) * side + (int)(p.v * side)]++;
            count[1][(int)(p.u * side) * side + (int)(q.u * side)]++;
            count[2][(int)(r.u * side) * side + (int)(r.v * side)]++;
        }
        for (int i = 0; i < bins; i++) even[i] = (double)n / bins;
        const char *name = sequence_name[kind];
        check_at_least(chi_square_test(count[0], even, bins).p, alarm, "%s: uniform", name);
        check_at_least(chi_square_test(count[1], even, bins).p, alarm, "%s: pairs 0, 1", name);
        check_at_least(chi_square_test(count[2], even, bins).p, alarm, "%s: over seeds", name);
    }
}

/* Right on average whatever N, also in four dimensions: e^(x+y), and u0 u1 of two pairs: 1/4. The
 * mean of (u0 - 1/2)(u1 - 1/2) has, with random numbers, the variance 1/144 of a sample. Sobol's
 * has 1.6 times that, since points i and i xor 1 stay together in the order of every pair; jittered
 * 1.5 for two points, which are never alike. In one and the same order it would hardly fall. */
static void test_unbiased(void)
{
    uint64_t runs = check_sample(3000, 300);  /* for fewer the bound of 2, below, is too narrow */
    for (int kind = 0; kind < sequence_kinds; kind++) {
        if (kind == SEQUENCE_HALTON) continue;
        for (uint32_t n = 1; n <= 64; n = 4 * n + 3) {  /* 1, 7, 31: no powers of two */
            estimate e = {0}, pairs = {0}, product = {0}, next = {0};
            for (uint64_t run = 0; run < runs; run++) {
                double error[integrands], sum = 0, off = 0, off_1 = 0;
                integrand_errors((sequence_kind)kind, 1, run, n, error);
                e = estimate_add(e, error[SMOOTH]);
                for (uint32_t i = 0; i < n; i++) {
                    sampler s = sampler_start((sequence_kind)kind, 2, run, i, n);
                    double u = (double)sampler_pair(&s).u, v = (double)sampler_number(&s);
                    double w = (double)sampler_number(&s);
                    sum += u * v, off += (u - 0.5) * (v - 0.5), off_1 += (v - 0.5) * (w - 0.5);
                }
                pairs = estimate_add(pairs, sum / n);
                product = estimate_add(product, off * off / n);
                next = estimate_add(next, off_1 * off_1 / n);
            }
            check_at_least(t_test(e, 0, 4 * (double)real_epsilon), alarm, "%s, N = %d: mean of "
                           "e^(x+y)", sequence_name[kind], (int)n);
            check_at_least(t_test(pairs, 0.25, 4 * (double)real_epsilon), alarm,
                           "%s, N = %d: two pairs", sequence_name[kind], (int)n);
            check_at_most(next.mean * 144, 2, "%s, N = %d: two numbers together",
                          sequence_name[kind], (int)n);
            check_at_most(product.mean * 144, 2,
                          "%s, N = %d: two pairs together", sequence_name[kind], (int)n);
        }
    }
}

/* Each key matters, but that Halton's points are the same for all pixels and seeds. */
static void test_keys(void)
{
    static const struct { uint64_t seed, pixel; uint32_t i, pair; const char *what; } other[] = {
        {1, 2, 3, 1, "dimension"}, {1, 2, 4, 0, "sample"}, {1, 3, 3, 0, "pixel"},
        {2, 2, 3, 0, "seed"}};
    for (int kind = 0; kind < sequence_kinds; kind++) {
        sequence_kind k = (sequence_kind)kind;
        const char *name = sequence_name[kind];
        point2 p = pair_of(k, 1, 2, 3, 16, 0), q;
        for (int j = 0; j < 4; j++) {
            q = pair_of(k, other[j].seed, other[j].pixel, other[j].i, 16, other[j].pair);
            bool same = k == SEQUENCE_HALTON && j >= 2;
            check((p.u == q.u && p.v == q.v) == same, "%s: another %s", name, other[j].what);
        }
        for (uint32_t i = 0; i < 16 && k != SEQUENCE_RANDOM; i++)
            check(sampler_start(k, 1, 2, i, 16).key != random_start(1, 2, i).key,
                  "%s: what samples share are not the numbers of sample %d", name, (int)i);
        sampler_keys of;
        sampler_keys_of(k, 1, 2, &of);
        sampler once = sampler_of_keys(&of, 3, 16), each = sampler_start(k, 1, 2, 3, 16);
        for (int d = 0; d < 2 * sampler_hashed; d++) {  /* beyond what was hashed, too */
            p = sampler_pair(&once), q = sampler_pair(&each);
            check(p.u == q.u && p.v == q.v, "%s, pair %d: hashed once a pixel", name, d);
        }
        sampler_keys many[sampler_rows];
        const sampler_keys *from[sampler_rows];
        point2 row[sampler_rows][sampler_row], *to[sampler_rows];
        for (uint64_t j = 0; j < sampler_rows; j++)
            sampler_keys_of(k, 1, j, &many[j]), from[j] = &many[j], to[j] = row[j];
        sampler_rows_of(from, 3, 16, to);
        for (uint64_t j = 0; j < sampler_rows; j++)
            for (uint32_t d = 0; d < sampler_row; d++) {
                p = row[j][d], q = pair_of(k, 1, j, 3, 16, d);
                check(p.u == q.u && p.v == q.v, "%s, pair %u: many pixels at once", name, d);
            }
        sampler s = sampler_start(k, 1, 2, 3, 16);
        for (int d = 0; d < 40 && k != SEQUENCE_HALTON; d++) {
            real x = d % 3 ? sampler_number(&s) : sampler_pair(&s).v;
            check(x >= 0 && x < 1, "%s: dimension %d in [0,1)", name, d);
        }
    }
    check(real_of_fraction(UINT32_MAX, 5) < 1 && real_of_fraction(0, 5) >= 0, "fractions in [0,1)");
    sampler s = sampler_start(SEQUENCE_RANDOM, 4, 5, 6, 7);
    check_equal(sampler_pair(&s).v, random_real(4, 5, 6, 1), "random: the numbers of random.h");
    check_equal(sampler_number(&s), random_real(4, 5, 6, 2), "and in their order");
}

/* In double the digits of Sobol's points go on below 2^-32. */
static void test_digits(void)
{
    size_t n = check_count(60000), coarse = 0;
    for (uint64_t k = 0; k < n && !real_is_float; k++) {
        uint32_t coin = (uint32_t)random_bits(6, k, 0, 0);
        double u = ldexp((double)real_of_fraction(coin, (uint32_t)k), 32);
        coarse += u == floor(u);
    }
    check_at_most(coarse, n / 1000, "fractions that end at 2^-32");
}

int main(void)
{
    return check_all("20_sequences", test_digits, test_nets, test_sampler_nets,
                     test_sobol_definition, test_scramble, test_radical_inverse, test_permuted,
                     test_cells, test_plain_halton, test_uniform, test_unbiased, test_keys);
}
