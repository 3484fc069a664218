/* Tests of common/vec3.h. */
#include "check.h"
#include "../common/numbers/wide.h"
#include "../common/random.h"
#include "../common/vec3.h"

static random_stream stream;
static real uniform(void) { return 2 * random_next(&stream) - 1; }
static vec3 random_vec3(void) { return random_in_cube(&stream, 1); }

static double exact_length(vec3 a) { return wide_value(wide3_length(wide3_of(a))); }

static bool same(vec3 a, vec3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

static void test_plain(void)
{
    vec3 a = {1, -2, 3}, b = {4, 5, -6};
    check(same(vadd(a, b), (vec3){5, 3, -3}), "a + b");
    check(same(vsub(a, b), (vec3){-3, -7, 9}), "a - b");
    check(same(vmul(a, b), (vec3){4, -10, -18}), "component by component");
    check(same(vneg(a), (vec3){-1, 2, -3}), "-a");
    check(same(vscale(a, 2), (vec3){2, -4, 6}), "2 a");
    check(same(vmadd(a, b, 2), (vec3){9, 8, -9}), "a + 2 b");
    check_equal(vdot(a, b), -24, "a . b");
    check(same(vcross(a, b), (vec3){-3, 18, 13}), "a x b");
    check(same(vcross((vec3){1, 0, 0}, (vec3){0, 1, 0}), (vec3){0, 0, 1}), "right-handed");
    check(same(vmin(a, b), (vec3){1, -2, -6}) && same(vmax(a, b), (vec3){4, 5, 3}), "min, max");
    check(vaxis(b, 0) == 4 && vaxis(b, 1) == 5 && vaxis(b, 2) == -6, "axes");
    check(vlongest((vec3){1, -3, 2}) == 1 && vlongest((vec3){-3, 3, 2}) == 0
          && vlongest((vec3){0, 1, -1}) == 1 && vlongest((vec3){0, 0, 1}) == 2, "longest axis");
    check(vzero(vec(0, -0.0, 0)) && !vzero(a), "zero");
    check(vfinite(a) && !vfinite(vec(0, NAN, 0)) && !vfinite((vec3){0, 0, real_infinity}),
          "finite");
    check(real_clamp(2, 0, 1) == 1 && real_clamp(-2, 0, 1) == 0 && real_clamp(0.5, 0, 1)
          == (real)0.5, "clamp");
    check(real_min((real)NAN, 3) == 3 && real_max((real)NAN, 3) == 3,
          "a NaN gives the second argument");
    check(real_clamp((real)NAN, 0, 1) == 0, "a NaN clamps to the lower end");
    check(1 + real_epsilon > 1 && 1 + real_epsilon / 2 == 1, "epsilon is that of real");
}

/* Lengths of vectors whose squares overflow or vanish. */
static void test_extremes(void)
{
    const real e[] = {1, real_largest / 4, real_smallest * 4, real_smallest * real_epsilon * 4,
                      real_smallest * real_epsilon, sqrt(real_smallest), sqrt(real_largest) / 2,
                      sqrt(real_smallest) / real_epsilon,
                      ldexp((real)1, real_is_float ? -40 : -459)};
    double eps = (double)real_epsilon;
    for (size_t i = 0; i < sizeof e / sizeof *e; i++) {
        vec3 a = {2 * e[i], -1 * e[i], 2 * e[i]};  /* length 3 e exactly */
        check_close((double)(vlength(a) / e[i]), 3, 4 * eps, "|(2,-1,2)| at %g", (double)e[i]);
        vec3 u = vunit(a);
        check_close(exact_length(u), 1, 2 * eps, "unit length at %g", (double)e[i]);
        check_close(u.y, -1.0 / 3, eps, "direction at %g", (double)e[i]);
        vec3 one = vunit((vec3){0, -e[i], 0});
        check(one.x == 0 && fabs(one.y + 1) <= real_epsilon && one.z == 0, "axis at %g",
              (double)e[i]);
        vec3 lopsided = vunit((vec3){e[i], real_smallest * real_epsilon, 0});
        check_close(exact_length(lopsided), 1, 2 * eps, "with a denormal beside %g", (double)e[i]);
    }
    real inf = real_infinity, nan = (real)NAN;
    check(same(vunit((vec3){0, 0, 0}), (vec3){0, 0, 0}), "unit of zero");
    check(same(vunit((vec3){inf, 1, 0}), (vec3){0, 0, 0}), "unit of infinity");
    check(same(vunit((vec3){1, nan, 0}), (vec3){0, 0, 0}), "unit of NaN");
    check(vlength((vec3){0, 0, 0}) == 0, "length of zero");
    check(isinf(vlength((vec3){-inf, 0, 0})), "length of infinity");
    check(isnan(vlength((vec3){nan, 0, 0})), "length of NaN");
    check_close((double)vlength((vec3){real_smallest * real_epsilon, 0, 0}),
                (double)(real_smallest * real_epsilon), 0, "the smallest denormal has its length");
}

/* Products: 3 squares and 2 sums, each within eps/2, half of it under the root; then root, division
 * and product: less than 2.25 eps/2 + ... < 2 epsilon. */
static void test_unit(void)
{
    double worst = 0, worst_length = 0;
    for (size_t i = 0; i < check_count(200000); i++) {
        int shift = (int)(i % 60) - 30;
        vec3 a = random_vec3();
        a = (vec3){ldexp(a.x, shift), ldexp(a.y, shift / 2), a.z};
        double exact = exact_length(a);
        worst = check_worse(worst, fabs(exact_length(vunit(a)) - 1));
        worst_length = check_worse(worst_length, fabs((double)vlength(a) - exact) / exact);
    }
    check_at_most(worst, 2 * (double)real_epsilon, "|vunit(a)| - 1");
    check_at_most(worst_length, 2 * (double)real_epsilon, "relative error of |a|");
}

static double basis_error(vec3 n)
{
    vec3 s, t;
    vbasis(n, &s, &t);
    wide3 w[3] = {wide3_of(s), wide3_of(t), wide3_of(n)};
    double worst = 0;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            worst = check_worse(worst, fabs(wide_value(wide3_dot(w[i], w[j])) - (i == j)));
    vec3 c = vcross(s, t);
    wide3 d = wide3_sub(wide3_of(c), w[2]);  /* right-handed: s x t = n */
    return check_worse(worst, wide_value(wide3_length(d)));
}

static void test_basis(void)
{
    const real zeros[] = {0, -0.0};
    double worst = 0;
    for (int k = 0; k < 3; k++)
        for (int bits = 0; bits < 8; bits++) {
            real v[3] = {zeros[bits & 1], zeros[bits >> 1 & 1], zeros[bits >> 1 & 1]};
            v[k] = bits & 4 ? -1 : 1;
            vec3 n = {v[0], v[1], v[2]};
            check_at_most(basis_error(n), 0, "an axis, zeros of sign %d", bits);
        }
    for (size_t i = 0; i < check_count(200000); i++) {
        real near = ldexp((real)1, -(int)(i % 60));  /* near -z and z, where Frisvad's form fails */
        vec3 a = random_vec3(), n = vunit((vec3){a.x * near, a.y * near, a.z});
        worst = check_worse(worst, basis_error(n));
    }
    check_at_most(worst, 4 * (double)real_epsilon, "basis of random and near-axis normals");
}

/* Error in units in the last place of the exact a b - c d. */
static double ulps(real computed, real a, real b, real c, real d)
{
    wide exact = wide_sub(wide_mul(wide_of((double)a), wide_of((double)b)),
                          wide_mul(wide_of((double)c), wide_of((double)d)));
    if (wide_sign(exact) == 0) return computed == 0 ? 0 : HUGE_VAL;
    int e;
    (void)frexp((real)wide_value(exact), &e);
    double ulp = ldexp((double)real_epsilon, e - 1);
    return fabs(wide_value(wide_sub(wide_of((double)computed), exact))) / ulp;
}

static void test_products(void)
{
    double robust = 0, naive = 0;
    for (size_t i = 0; i < check_count(400000); i++) {
        real a = uniform(), b = uniform(), c = uniform(), d = uniform();
        if (i % 2) d = a * b / c * (1 + (real)(i % 7) * real_epsilon);  /* they nearly cancel */
        robust = check_worse(robust, ulps(difference_of_products(a, b, c, d), a, b, c, d));
        naive = check_worse(naive, ulps(a * b - c * d, a, b, c, d));
    }
    check_at_most(robust, 1.5, "ulps of ab - cd (Jeannerod et al. 2013, theorem 1.1)");
    check_at_least(naive, 1000, "the plain form loses its digits where the products cancel");
    real x = 1 + real_epsilon, y = 1 - real_epsilon;
    check_equal(difference_of_products(x, y, 1, 1), -real_epsilon * real_epsilon,
                "(1 + e)(1 - e) - 1 = -e^2, where the plain form gives 0");
}

int main(void)
{
    stream = random_start(2, 0, 0);
    test_plain();
    test_extremes();
    test_unit();
    test_basis();
    test_products();
    return check_report("vec3");
}
