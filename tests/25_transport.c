/* Tests of 25_bounces, first part: the operator on patches, its Neumann series, the furnace's sum.
 * Oracles: 2 x 2 systems and eigenvalues in closed form, sums in double-double, dyadic numbers. */
#include "../chapters/25_bounces/lab/furnace.h"
#include "../chapters/25_bounces/lab/transport.h"
#include "../common/numbers/wide.h"
#include "../common/random.h"
#include "check.h"

#define eps ((double)real_epsilon)

/* ---- (25.5) ---- */

/* E = 1; Horner in double-double: some 1e-31 a step. */
static wide exact_sum(double rho, int n)
{
    wide s = wide_of(1), r = wide_of(rho);
    for (int k = 0; k < n; k++) s = wide_add(wide_mul(s, r), wide_of(1));
    return s;
}

static double off(double measured, wide exact)
{
    return fabs(wide_value(wide_sub(wide_of(measured), exact))) / wide_value(exact);
}

static void test_series(void)
{
    static const int many[] = {0, 1, 2, 5, 30, 1000};
    double worst = 0;
    for (int i = 0; i < 6; i++)
        for (int k = 0; k < 60; k++) {  /* towards 1 from below, from above, towards 0, at random */
            real near = ldexp((real)1, -k % 50), any = random_real(25, 0, (uint64_t)k, 0);
            real rho[] = {1 - near, 1 + near / 1024, near, any};
            for (int j = 0; j < 4; j++)
                worst = check_worse(worst, off((double)series_sum(1, rho[j], (real)many[i]),
                                               exact_sum((double)rho[j], many[i])));
        }
    /* log1p, product, expm1 and quotient are rounded, at most an epsilon each; but for rho = 1 +
     * 2^-10 e^x - 1 multiplies the relative error of x = 1001 log rho by x / (1 - e^-x) < 2 */
    check_at_most(worst, 8 * eps, "series_sum");
    check_equal(series_sum(3, 1, 6), 21, "rho = 1: E (n + 1)");
    check_equal((double)series_sum(1, 0.5, 3), 1.875, "1 + 1/2 + 1/4 + 1/8");
    check_equal(series_sum(2, 0, 9), 2, "black: E");
    check_equal(series_whole(1, 0.75), 4, "E / (1 - rho)");
    check(isinf(series_whole(1, 1)) && isinf(series_whole(1, 2)), "rho >= 1: diverges");
    check_equal(series_whole(0, 1), 0, "no light, no sum");
}

static void test_series_naive(void)
{
    real kept = ldexp((real)1, real_is_float ? -16 : -30);
    check(isnan(series_sum_naive(1, 1, 4)), "naive: 0/0 at rho = 1");
    /* rho^11 = 1 - 11 kept + 55 kept^2 - ..: below half an ulp of rho^11 the third term is dropped,
     * and the sum is off by 5 kept of itself */
    double lost = off((double)series_sum_naive(1, 1 - kept, 10), exact_sum(1 - (double)kept, 10));
    check_close(lost / (double)kept, 5, 16 * (double)kept,
                "naive: half of the digits lost near 1");
    check_at_least(lost, 100 * eps, "and that is a lot");
}

/* ---- operator ---- */

static void test_two_patches(void)
{
    double a = 0.125, b = 0.5, c = 0.25, d = 0.375, L[2], S[2], T[2], sum[2] = {0, 0};
    transport t = {{3, 1}, {{a, b}, {c, d}}};
    check(transport_solve(&t, L), "regular");
    /* Cramer: det = .875 * .625 - .125 = .421875, L = (3 * .625 + .5, .875 + .75) / det */
    check_close(L[0], 2.375 / 0.421875, 1e-14, "(I - K)^-1 E, first");
    check_close(L[1], 1.625 / 0.421875, 1e-14, "(I - K)^-1 E, second");
    for (int k = 0; k <= 12; k++) {
        transport_bounces(&t, k, false, T), transport_bounces(&t, k, true, S);
        for (int i = 0; i < 2; i++) sum[i] += T[i];
        for (int i = 0; i < 2; i++)
            check_close(S[i], sum[i], 1e-14, "%d terms of patch %d add up", k + 1, i);
    }
    transport_bounces(&t, 2, false, T);
    check_equal(T[0], 0.125 * 0.875 + 0.5 * 1.125, "K^2 E by hand, first");
    check_equal(T[1], 0.25 * 0.875 + 0.375 * 1.125, "K^2 E by hand, second");
    check_equal(transport_norm(&t), 0.625, "largest row");
    transport_bounces(&t, 200, false, T), transport_apply(&t, T, S);
    check_close(S[0] / T[0], transport_radius(&t), 1e-14, "late terms shrink by the radius each");
    transport_bounces(&t, 200, true, S);  /* .625^201 = 1e-41 is left out */
    check_close(S[0], L[0], 1e-14, "the series' limit, first");
    check_close(S[1], L[1], 1e-14, "the series' limit, second");
}

static void test_convergence(void)
{
    double L[2], S[2], T[2];
    /* one white, one half black, each seeing the other alone: norm 1, radius sqrt(1/2) */
    transport t = {{1, 1}, {{0, 1}, {0.5, 0}}};
    check_equal(transport_norm(&t), 1, "norm 1");
    transport_bounces(&t, 10, false, S), transport_bounces(&t, 12, false, T);
    check_close(T[0] / S[0], pow(transport_radius(&t), 2), 1e-15, "to and fro: two bounces");
    check(transport_solve(&t, L), "regular all the same");
    check_close(L[0], 4, 1e-14, "L0 = (1 + 1) / (1 - 1/2)");
    transport_bounces(&t, 100, true, S);  /* 2^-50 of it is left */
    check_close(S[0], 4, 1e-13, "and the series gets there");

    t = (transport){{1, 1}, {{0, 1}, {0.25, 0.75}}};  /* closed, white: rows sum to 1 */
    check(!transport_solve(&t, L), "closed and white: singular");
    check_close(transport_radius(&t), 1, 1e-14, "radius 1");
    for (int n = 1; n <= 1000; n *= 10) {
        transport_bounces(&t, n, true, S);
        check_equal(S[0], n + 1, "grows by E each bounce, n = %d", n);
    }
    t = (transport){{1, 1}, {{0.1, 0.9}, {0.3, 0.7}}};  /* the same, but rounded: 1e-16 or so */
    check(!transport_solve(&t, L), "closed and white, nearly: singular");

    t = (transport){{1, 0}, {{2, 0}, {0, 0}}};  /* gives back twice what it gets */
    check(transport_solve(&t, L), "rho = 2 has a solution");
    check_equal(L[0], -1, "L = -1: negative light");
    transport_bounces(&t, 10, true, S);
    check_equal(S[0], 2047, "no sum of positive terms gets there");
}

int main(void)
{
    return check_all("25_transport", test_series, test_series_naive, test_two_patches,
                     test_convergence);
}
