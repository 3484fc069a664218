/* Tests of 20_monte_carlo: mean and variance in one pass, sums; and how the naive forms fail. */
#include "../chapters/20_monte_carlo/estimate.h"
#include "../chapters/20_monte_carlo/first.h"
#include "../common/numbers/sum.h"
#include "../common/numbers/wide.h"
#include "../common/random.h"
#include "check.h"

#define eps DBL_EPSILON

static estimate of(const double *x, size_t n)
{
    estimate e = {0};
    for (size_t i = 0; i < n; i++) e = estimate_add(e, x[i]);
    return e;
}

static void test_closed_forms(void)
{
    estimate e = {0};
    check(isinf(estimate_variance(e)) && isinf(estimate_error(e)), "no sample: nothing is known");
    e = estimate_add(e, 7);
    check_equal(e.mean, 7, "one sample is its mean");
    check_equal(e.squares, 0, "one sample has no spread");
    check(isinf(estimate_variance(e)) && isinf(estimate_error(e)), "one sample: spread not known");
    e = estimate_add(e, 9);
    check_equal(e.mean, 8, "mean of 7 and 9");
    check_equal(estimate_variance(e), 2, "(1 + 1) / (2 - 1)");
    check_equal(estimate_error(e), 1, "root of 2 / 2");
    size_t n = 1001;
    e = (estimate){0};
    for (size_t i = 1; i <= n; i++) e = estimate_add(e, (double)i);
    check_close(e.mean, 501, 1001 * 4 * eps, "mean of 1 .. n is (n+1)/2");
    check_close(estimate_variance(e) / (1001.0 * 1002 / 12), 1, 1001 * 4 * eps,
                "variance of 1 .. n is n (n+1) / 12");
    check_close(estimate_error(e), sqrt(1002.0 / 12), 1e-10, "standard error");
}

/* Exact sums in wide numbers: sum of squares about the exact mean. */
static double wide_variance(const double *x, size_t n)
{
    wide sum = wide_of(0), squares = wide_of(0);
    for (size_t i = 0; i < n; i++) sum = wide_add(sum, wide_of(x[i]));
    wide mean = wide_div(sum, wide_of((double)n));
    for (size_t i = 0; i < n; i++) {
        wide d = wide_sub(wide_of(x[i]), mean);
        squares = wide_add(squares, wide_mul(d, d));
    }
    return wide_value(wide_div(squares, wide_of((double)(n - 1))));
}

/* Chan, Golub, LeVeque: Welford's relative error is at most about n kappa eps, with kappa = mean /
 * deviation; roundings of random numbers cancel, and some eps kappa are left. */
static void test_against_wide(void)
{
    enum { n = 200 };
    double x[n];
    for (int k = 0; k <= 12; k++) {
        double mean = pow(10, k), worst = 0;
        for (uint64_t set = 0; set < check_count(100); set++) {
            for (uint64_t i = 0; i < n; i++)
                x[i] = mean + random_double_of(random_bits(1, set, i, (uint64_t)k));
            double right = wide_variance(x, n);
            worst = check_worse(worst, fabs(estimate_variance(of(x, n)) / right - 1));
        }
        check_at_most(worst, 4 * (1 + mean * sqrt(12.0)) * eps, "variance, mean 1e%d", k);
    }
}

/* squares must never fall, whatever comes: the proof above estimate_add, tried. */
static void test_never_negative(void)
{
    size_t fell = 0;
    for (uint64_t set = 0; set < check_count(2000); set++) {
        estimate e = {0};
        double base = ldexp(1 + random_double_of(random_bits(2, set, 0, 0)), (int)(set % 120) - 60);
        for (uint64_t i = 0; i < 100; i++) {
            double u = random_double_of(random_bits(2, set, i, 1)), x = base;
            if (set % 4 == 1) x = base * (1 + eps * floor(4 * u));  /* neighbouring numbers */
            if (set % 4 == 2) x = i % 2 ? base : -base;
            if (set % 4 == 3) x = base + ldexp(u, (int)(i % 60) - 30);
            estimate next = estimate_add(e, x);
            fell += next.squares < e.squares;
            e = next;
        }
        if (set % 4 == 0) check_equal(e.squares, 0, "equal numbers have no spread, exactly");
    }
    check_equal(fell, 0, "sum of squares fell");
    estimate e = estimate_add(estimate_add((estimate){0}, 1), (double)NAN);
    check(isnan(e.mean) && isnan(estimate_variance(e)), "a NaN stays");
    e = estimate_add(estimate_add((estimate){0}, 1), (double)INFINITY);
    check(!isfinite(e.mean), "an infinite sample spoils the mean");
}

/* From 1/sqrt(epsilon) on the difference is noise, of either sign. */
static void test_naive_variance(void)
{
    size_t sets = check_count(1000), negative = 0, fine = 0;
    real mean = 4 / sqrt(real_epsilon);
    for (uint64_t set = 0; set < sets; set++) {
        first_samples m = {0, 0, 0}, small = {0, 0, 0};
        for (uint64_t i = 0; i < 100; i++) {
            real x = 2 * random_real(3, set, i, 0) - 1;
            first_sample(&m, mean + x), first_sample(&small, x);
        }
        negative += first_variance(m) < 0;
        fine += fabs(first_variance(small) - 1 / (real)3) < (real)0.2;
    }
    check_at_least(negative, sets / 5, "naive variances below 0, of %zu", sets);
    check_equal(fine, sets, "around 0 the naive form does no harm");
}

static void test_merge(void)
{
    enum { n = 300 };
    double x[n];
    for (uint64_t i = 0; i < n; i++) x[i] = 1e6 + random_double_of(random_bits(4, 0, i, 0));
    estimate whole = of(x, n), none = {0};
    for (size_t k = 0; k <= n; k += 25) {
        estimate e = estimate_merge(of(x, k), of(x + k, n - k));
        check_equal(e.n, n, "numbers merged at %zu", k);
        check_close(e.mean, whole.mean, 4 * 1e6 * eps, "mean merged at %zu", k);
        check_close(e.squares / whole.squares, 1, 8 * 1e6 * eps, "squares merged at %zu", k);
    }
    check_equal(estimate_merge(none, none).n, 0, "nothing and nothing");
    check_equal(estimate_merge(whole, none).squares, whole.squares, "nothing added");
}

static void test_sums(void)
{
    float naive = 0;
    running_sum_f32 kept = {0, 0};
    for (int i = 0; i < (1 << 24) + 1000; i++)
        naive = sum_add_naive_f32(naive, 1), kept = sum_add_f32(kept, 1);
    check_equal(naive, 0x1p24f, "a float that counts by ones stops at 2^24");
    check_equal(kept.sum, (1 << 24) + 1000, "with what was lost it goes on");
    /* the same at the end of real's digits: adding 1 to 2 / epsilon changes nothing */
    real stuck = 2 / real_epsilon;
    running_sum s = {2 / real_epsilon, 0};
    for (int i = 0; i < 1000; i++) stuck = sum_add_naive(stuck, 1), s = sum_add(s, 1);
    check_equal(stuck, 2 / real_epsilon, "adding ones to 2 / epsilon");
    check_equal(s.sum, 2 / real_epsilon + 1000, "sum_add counts on");
    /* one addition loses nothing: sum + lost is exact, whichever is larger */
    size_t wrong = 0, lossy = 0;
    for (uint64_t i = 0; i < check_count(20000); i++) {
        real a = ldexp(random_real(5, i, 0, 0) - (real)0.5, (int)(i % 40) - 20);
        real b = ldexp(random_real(5, i, 0, 1) - (real)0.5, (int)(i / 40 % 40) - 20);
        running_sum t = sum_add((running_sum){a, 0}, b);
        wide d = wide_sub(wide_sum((double)a, (double)b), wide_sum((double)t.sum, (double)t.lost));
        wrong += wide_sign(d) != 0, lossy += t.lost != 0;
    }
    check_equal(wrong, 0, "a + b = sum + lost");
    check_at_least(lossy, check_count(20000) / 2, "and most of the sums did round");
    /* n numbers of one sign: within 2 epsilon (Knuth, 4.2.2, exercise 19), whatever n */
    s = (running_sum){0, 0};
    wide right = wide_of(0);
    for (uint64_t i = 0; i < check_count(200000); i++) {
        real x = random_real(6, i, 0, 0);
        s = sum_add(s, x), right = wide_add(right, wide_of((double)x));
    }
    check_close((double)s.sum / wide_value(right), 1, 2 * (double)real_epsilon, "a long sum");
}

int main(void)
{
    test_closed_forms();
    test_against_wide();
    test_never_negative();
    test_naive_variance();
    test_merge();
    test_sums();
    return check_report("20_estimate");
}
