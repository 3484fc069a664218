/* Rounding down and up to floats, against the neighbours that the C library names; keys against the
 * order of the floats. */
#include "../common/numbers/float_round.h"
#include "../common/random.h"
#include "check.h"

static float float_of_bits(uint32_t bits)
{
    float f;
    memcpy(&f, &bits, sizeof f);
    return f;
}

/* Any finite float, by its bits: all exponents alike, numbers below FLT_MIN among them. */
static float any_float(random_stream *g)
{
    float f = float_of_bits((uint32_t)random_next_bits(g));
    return isfinite(f) ? f : 0;
}

/* The float just above or below, stepped by nextafterf: not by bits. */
static bool is_below(float f, real x)
{
    return (real)f <= x && (real)nextafterf(f, INFINITY) > x;
}

static bool is_above(float f, real x)
{
    return (real)f >= x && (real)nextafterf(f, -INFINITY) < x;
}

/* A float, and what lies between it and the next: exactly there, halfway, a hair beside both. */
static void test_nearest_on_its_side(void)
{
    size_t n = check_count(1000000), below = 0, above = 0, beyond = 0, between = 0, moved = 0;
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(1, i, 0);
        float f = any_float(&g), next = nextafterf(f, INFINITY);
        real x = (real)f, gap = (real)next - x;
        if (isinf(next)) continue;
        switch (i % 4) {
        case 0: x += gap / 2; break;
        case 1: x += gap * random_next(&g); break;
        case 2: x = nextafter(x, real_infinity); break;
        default: break;
        }
        below += !is_below(float_below(x), x), above += !is_above(float_above(x), x);
        beyond += (real)float_beyond(x) <= x;  /* NaN is allowed */
        between += (real)(float)x != x;
        moved += i % 4 == 3 && (float_below(x) != f || float_above(x) != f);
    }
    check_equal(below, 0, "float_below is the largest float <= x, of %zu", n);
    check_equal(above, 0, "float_above is the smallest float >= x");
    check_equal(beyond, 0, "float_beyond > x, or it leaves the plane out");
    check_equal(moved, 0, "what is a float stays as it is");
    if (!real_is_float) check_at_least(between, n / 2, "most of them are no floats");
}

static void test_ends(void)
{
    const real inf = real_infinity, tiny = real_is_float ? (real)0x1p-149f : (real)1e-50;
    check(float_below(inf) == INFINITY && float_above(-inf) == -INFINITY, "infinity stays");
    check(float_below(-inf) == -INFINITY && float_above(inf) == INFINITY, "infinity stays");
    check(float_below(real_largest) == FLT_MAX, "the largest float is below the largest real");
    check(float_above(-real_largest) == -FLT_MAX, "and its negative above the least");
    check(float_above(real_largest) >= FLT_MAX, "FLT_MAX, or infinity in double");
    check(real_is_float || isinf(float_above(real_largest)), "no float is above 1e308");
    check(float_below(0) == 0 && float_above(0) == 0, "0 stays");
    check(float_below(-(real)0) == 0 && float_above(-(real)0) == 0, "-0 stays");
    check(float_below(-tiny) == -0x1p-149f && float_above(tiny) == 0x1p-149f, "away from 0");
    check(float_below(tiny) == (real_is_float ? 0x1p-149f : 0), "towards 0");
    check(float_above(-tiny) == (real_is_float ? -0x1p-149f : 0), "towards 0");
    check(isnan(float_below((real)NAN)) && isnan(float_above((real)NAN)), "NaN stays");
}

/* To the nearest, what was in the box need not be in its float copy. */
static void test_nearest_is_not_enough(void)
{
    real x = 1 - (real)0x1p-30;  /* in float it is 1 already */
    check((float)x == 1, "the nearest float is 1");
    check(real_is_float || (real)(float)x > x, "so a low side of 1 would leave x outside");
    check((real)float_below(x) <= x, "rounded down it holds x");
}

static void check_order(float a, float b, size_t *wrong)
{
    uint32_t j = float_key(a), k = float_key(b);
    *wrong += (a < b) != (j < k) || (a > b) != (j > k) || float_of_key(j) != a;
}

static void test_keys(void)
{
    static const float some[] = {-INFINITY, -FLT_MAX, -1, -FLT_MIN, -0x1p-149f, -0.0f, 0,
                                 0x1p-149f, FLT_MIN, 1, FLT_MAX, INFINITY};
    const size_t k = sizeof some / sizeof *some, n = check_count(1000000);
    size_t wrong = 0, ends = 0;
    for (size_t i = 0; i < k * k; i++) check_order(some[i / k], some[i % k], &ends);
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(2, i, 0);
        float a = any_float(&g), b = any_float(&g);
        if (i % 2) b = nextafterf(a, b);
        check_order(a, b, &wrong), check_order(a, a, &wrong), check_order(a, -a, &wrong);
    }
    check_equal(ends, 0, "keys ascend from -infinity to infinity, the two zeros alike");
    check_equal(wrong, 0, "keys ascend as the floats do, of %zu", n);
}

int main(void)
{
    test_nearest_on_its_side();
    test_ends();
    test_nearest_is_not_enough();
    test_keys();
    return check_report("float_round");
}
