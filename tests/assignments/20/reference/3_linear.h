/* A number x of [0, 1] whose density falls or rises evenly: p(x) is proportional to a + (b - a)
 * x, with a, b >= 0, not both 0. By inversion of u in [0, 1): x rises with u. Writes p(x), a
 * density: its integral over [0, 1] is 1. It has to hold for a = b, for a near b, for a = 0 and
 * for b = 0. */
static inline real sample_linear(real a, real b, real u, real *p)
{
    /* P(x) = (a x + (b - a) x^2 / 2) / ((a + b) / 2) = u. Of the forms of the root the one
     * without a difference of near numbers: a = b does not divide by 0. */
    real root = sqrt(a * a + u * (b - a) * (b + a));
    real x = u == 0 ? 0 : u * (a + b) / (a + root);
    x = real_min(x, 1);
    *p = 2 * (a + (b - a) * x) / (a + b);
    return x;
}
