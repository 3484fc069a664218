/* Tests of 20_monte_carlo: mean and variance in one pass, sums; the functions behind tests of
 * statistics against closed forms, and the tests themselves: they must pass what is right as often
 * as they say, and reject what is wrong. */
#include "../common/lab/chi_square.h"
#include "../common/numbers/sum.h"
#include "../common/numbers/wide.h"
#include "../common/lab/t_test.h"
#include "check.h"

#define turn 3.14159265358979323846

/* ---- estimate.h, sum.h ---- */

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
    check_close(e.mean, 501, 501 * 4 * DBL_EPSILON, "mean of 1 .. n is (n+1)/2");
    check_close(estimate_variance(e) / (1001.0 * 1002 / 12), 1, 16 * DBL_EPSILON,
                "variance of 1 .. n is n (n+1) / 12");
    check_close(estimate_error(e), sqrt(1002.0 / 12), 1e-13, "standard error");
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
        check_at_most(worst, 4 * (1 + mean * sqrt(12.0)) * DBL_EPSILON, "variance, mean 1e%d", k);
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
            if (set % 4 == 1) x = base * (1 + DBL_EPSILON * floor(4 * u));  /* neighbours */
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

/* Step i of n rounds the mean at random, and counts i/n in the end: two such means are apart by a
 * sigma of at most 2.1 epsilon; 16 are allowed. */
static void test_merge(void)
{
    enum { n = 300 };
    double x[n];
    for (uint64_t i = 0; i < n; i++) x[i] = 1e6 + random_double_of(random_bits(4, 0, i, 0));
    estimate whole = of(x, n), none = {0};
    for (size_t k = 0; k <= n; k += 25) {
        estimate e = estimate_merge(of(x, k), of(x + k, n - k));
        check_equal(e.n, n, "numbers merged at %zu", k);
        check_close(e.mean, whole.mean, 16 * 1e6 * DBL_EPSILON, "mean merged at %zu", k);
        check_close(e.squares / whole.squares, 1, 8e6 * DBL_EPSILON, "squares merged at %zu", k);
    }
    check_equal(estimate_merge(none, none).n, 0, "nothing and nothing");
    check_equal(estimate_merge(whole, none).squares, whole.squares, "nothing added");
}

static void test_sums(void)
{
    volatile float last = 0x1p24f;
    last += 1;
    check_equal(last, 0x1p24f, "a float that counts by ones stops at 2^24");
    size_t wrong = 0, lossy = 0;
    for (uint64_t i = 0; i < check_count(20000); i++) {
        real a = ldexp(random_real(5, i, 0, 0) - (real)0.5, (int)(i % 40) - 20);
        real b = ldexp(random_real(5, i, 0, 1) - (real)0.5, (int)(i / 40 % 40) - 20);
        real sum = a + b, lost = sum_error(a, b, sum);
        wide d = wide_sub(wide_sum((double)a, (double)b), wide_sum((double)sum, (double)lost));
        wrong += wide_sign(d) != 0, lossy += lost != 0;
    }
    check_equal(wrong, 0, "a + b = sum + lost");
    check_at_least(lossy, check_count(20000) / 2, "and most of the sums did round");
}

/* ---- incomplete.h, t_test.h, chi_square.h ---- */

/* Relative, with the loss that incomplete.h states. */
static void same(double measured, double expected, double size, const char *what, double a,
                 double x)
{
    check_close(measured / expected, 1, 1e-14 * (10 + size), "%s, a = %g, x = %g", what, a, x);
}

/* e^-x (1 + x + ... + x^(n-1)/(n-1)!): the probability of fewer than n events, x being expected. */
static double fewer_than(int n, double x)
{
    double term = 1, sum = 0;
    for (int k = 0; k < n; k++) sum += term, term *= x / (k + 1);
    return exp(-x) * sum;
}

static void test_gamma(void)
{
    double factorial = 1;
    for (int n = 1; n <= 100; n++) {
        check_close(log_gamma(n), log(factorial), 4e-15 * (1 + log(factorial)), "(%d - 1)!", n);
        factorial *= n;
    }
    same(log_gamma(0.5), log(turn) / 2, 0, "Gamma(1/2) = sqrt pi", 0.5, 0);
    same(log_gamma(1.5), log(turn) / 2 - log(2), 100, "Gamma(3/2)", 1.5, 0);
    for (int k = -30; k <= 30; k++) {
        double x = pow(10, k / 10.0 - 1);
        same(gamma_above(0.5, x), erfc(sqrt(x)), x, "erfc", 0.5, x);
        for (int n = 1; n <= 64; n *= 2)
            if (x < 600) same(gamma_above(n, x), fewer_than(n, x), x + n, "fewer than n", n, x);
    }
    same(gamma_above(0.5, 650), erfc(sqrt(650.0)), 650, "a tail of 1e-284", 0.5, 650);
    /* the median lies between a - 1/3 and a (Chen, Rubin 1986): no closed form, but two bounds */
    for (double a = 1; a < 1e7; a *= 10) {
        check_at_most(gamma_above(a, a), 0.5, "above the mean %g", a);
        check_at_least(gamma_above(a, a - 1.0 / 3), 0.5 - 1e-14 * (10 + a),
                       "above the mean less 1/3, %g", a);
    }
    check_equal(gamma_above(3, -1), 1, "all above -1");
    check_equal(gamma_above(3, (double)INFINITY), 0, "nothing above infinity");
    check(isnan(gamma_above(3, (double)NAN)) && isnan(beta_below(1, 1, (double)NAN, 0)), "NaN");
}

static void test_beta(void)
{
    for (int k = 1; k < 40; k++) {
        double x = k / 40.0, y = 1 - x;
        same(beta_below(0.5, 0.5, x, y), 2 / turn * asin(sqrt(x)), 1, "arcsine law", 0.5, x);
        for (double a = 0.25; a < 300; a *= 2) {
            if (a * log(x) > -700) same(beta_below(a, 1, x, y), pow(x, a), 10 * a, "x^a", a, x);
            same(beta_below(1, a, x, y), -expm1(a * log1p(-x)), 10 * a, "1 - (1-x)^b", a, x);
            check_close(beta_below(a, 2.5, x, y) + beta_below(2.5, a, y, x), 1, 1e-14 * (10 + a),
                        "both ends, a = %g, x = %g", a, x);
        }
    }
    check_equal(beta_below(2, 3, 0, 1), 0, "nothing below 0");
    check_equal(beta_below(2, 3, 1, 0), 1, "all below 1");
    same(beta_below(3, 1, 1e-100, 1), 1e-300, 1000, "a tiny x", 3, 1e-100);
}

static void test_tails(void)
{
    for (double t = 0.125; t < 1e6; t *= 2) {
        same(t_above(t, 1), 2 / turn * atan(1 / t), 1, "Cauchy", 1, t);
        same(t_above(t, 2), 2 / (sqrt(t * t + 2) * (sqrt(t * t + 2) + t)), 1, "two degrees", 2, t);
        if (t < 30) check_close(t_above(t, 1e8) / erfc(t / sqrt(2.0)), 1, pow(1 + t, 4) * 1e-7,
                                "many degrees: normal, t = %g", t);
    }
    check_equal(t_above(0, 5), 1, "t = 0");
    check_equal(t_above((double)INFINITY, 5), 0, "t infinite");
    same(chi_square_p(2 * 3.5, 2), exp(-3.5), 1, "two degrees: exponential", 2, 7);
    check_equal(chi_square_p(5, 0), 1, "no degree of freedom proves nothing");
}

/* Normal numbers (Box, Muller), without any of the code above. */
static double normal(uint64_t seed, uint64_t i, uint64_t k)
{
    double u = random_double_of(random_bits(seed, i, k, 0));
    return sqrt(-2 * log1p(-u)) * cos(2 * turn * random_double_of(random_bits(seed, i, k, 1)));
}

/* At most 1e-8, where tests raise the alarm; how far below says nothing. */
static void test_rejects(void)
{
    estimate e = {0};
    for (uint64_t k = 0; k < 1000; k++) e = estimate_add(e, normal(5, 0, k));
    check_at_most(t_test(e, 0.3, 0), 1e-8, "a mean that is 0, not 0.3: 9 standard errors");
    check_at_least(t_test(e, 0.3, 0.3), 1e-8, "unless 0.3 is said to be rounding");
    check_equal(t_test((estimate){0}, 1, 0), 1, "no samples prove nothing");
    /* 0 and 2: mean 1, standard error 1, so t = 1 for a truth of 0: Cauchy's law says 1/2 */
    check_close(t_test((estimate){2, 1, 2}, 0, 0), 0.5, 1e-14, "two samples: one degree");
    check_equal(t_test((estimate){3, 2, 0}, 2, 0), 1, "samples all alike, and right");
    check_equal(t_test((estimate){3, 2, 0}, 2.1, 0), 0, "samples all alike, and wrong");
    check_equal(t_test((estimate){3, 2, 0}, 2.1, 0.2), 1, "samples all alike, within rounding");
    check_equal(t_test((estimate){3, (double)NAN, 1}, 2, 0), 0, "a NaN is wrong");
    check_equal(t_test((estimate){1, 2, 0}, 1, 0), 1, "nor does one");

    double die[6] = {1000, 1000, 1000, 1000, 1000, 1000}, fair[6], loaded[6];
    for (int k = 0; k < 6; k++) fair[k] = 1000, loaded[k] = k ? 960 : 1200;
    check_equal(chi_square_test(die, fair, 6).p, 1, "exactly as expected");
    check_equal(chi_square_test(die, fair, 6).degrees, 5, "degrees of freedom");
    check_close(chi_square_test(loaded, fair, 6).statistic, 40 + 5 * 1.6, 1e-13, "by hand");
    check_close(chi_square_test(loaded, fair, 6).p / chi_square_p(48, 5), 1, 1e-12, "a loaded die");
    double seen[3] = {100, 0, 1}, due[3] = {100, 1, 0};
    check_equal(chi_square_test(seen, due, 3).p, 0, "a count where nothing can be");
    due[2] = -1;
    check_equal(chi_square_test(seen, due, 3).p, 0, "a negative expectation");
    /* Ten bins that expect 0.001 each, and one count in one of them, as happens once in 100 times.
     * By itself it would contribute (1 - .001)^2 / .001 = 998: p below 1e-200. */
    double rare[11] = {0}, few[11];
    for (int k = 0; k < 10; k++) few[k] = 0.001;
    rare[3] = 1, rare[10] = few[10] = 500;
    check_at_least(chi_square_test(rare, few, 11).p, 0.01, "rare bins are put together");

    /* And what is left over counts as a bin, too: 60 where 1 is due. */
    double many[2] = {100, 60}, one[2] = {100, 1};
    check_equal(chi_square_test(many, one, 2).degrees, 1, "two bins");
    check_at_most(chi_square_test(many, one, 2).p, 1e-8, "60 where 1 is due");

    double x[3] = {1, 2, 4}, y[3] = {5, 3, -1};
    line_fit f = fit_line(x, y, 3);
    check_close(f.slope, -2, 1e-15, "slope of 7 - 2x");
    check_close(f.intercept, 7, 1e-15, "intercept of 7 - 2x");
    check_at_most(f.slope_error, 1e-14, "an exact line has no doubt");
    check(isinf(fit_line(x, y, 2).slope_error), "two points always lie on a line");
    /* 0, 0, 3 at 0, 1, 2: residuals 1/2, -1, 1/2 from 1.5 x - 0.5; sqrt((3/2) / (3 - 2) / 2) */
    double bent_x[3] = {0, 1, 2}, bent[3] = {0, 0, 3};
    check_close(fit_line(bent_x, bent, 3).slope_error, sqrt(0.75), 1e-15, "error of a slope");
}

int main(void)
{
    return check_all("20_statistics", test_closed_forms, test_against_wide, test_never_negative,
                     test_merge, test_sums, test_gamma, test_beta, test_tails, test_rejects);
}
