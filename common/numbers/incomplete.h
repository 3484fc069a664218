/* incomplete.h: the two functions behind all tests of statistics.
 *
 *   gamma_above(a, x)         integral of t^(a-1) e^-t from x to infinity, over the whole (20.14)
 *   beta_below(a, b, x, 1-x)  integral of t^(a-1) (1-t)^(b-1) from 0 to x, over the whole  (20.15)
 *   log_gamma(a)              log Gamma(a), Gamma(a) being the whole of (20.14)
 *
 * All for a, b > 0; the first two lie between 0 and 1. x < 0 counts as 0, and a NaN gives NaN.
 * beta_below takes x and 1-x, since near 1 the second has the digits that the first has lost: a
 * t-test asks for x = 1 - 1e-12. No p-value of 1e-300 is 1 minus something: it is right in all
 * digits but the last few. Relative error some 1e-14 times a + b + x.
 *
 * The C library has lgamma, but it may store a sign in a variable that all threads share.
 *
 * Sources: M. Abramowitz, I. Stegun, Handbook of Mathematical Functions, 1964, 6.1.41 (Stirling),
 * 6.5.29, 6.5.31 (gamma), 26.5.8 (beta); W. Lentz, "Generating Bessel functions in Mie scattering
 * calculations using continued fractions", Applied Optics 15(3), 1976.
 */
#ifndef INCOMPLETE_H
#define INCOMPLETE_H

#include "../vec3.h"

/* ---------------------------------------------------------------------------------------------- */

/* Stirling's series; below 12, where it is not good enough, from Gamma(a) = Gamma(a+1) / a. */
static inline double log_gamma(double a)
{
    double shift = 1;
    for (; a < 12; a++) shift *= a;
    double i = 1 / a, ii = i * i;
    double series = i * (1.0 / 12 - ii * (1.0 / 360 - ii * (1.0 / 1260 - ii * (1.0 / 1680
                    - ii / 1188))));
    return (a - 0.5) * log(a) - a + 0.918938533204672742 + series - log(shift);  /* log(2 pi)/2 */
}

/* One step of Lentz's way through a continued fraction f = b0 + a1/(b1 + a2/(b2 + ...)): c and d
 * are ratios of neighbouring numerators and denominators, kept away from 0. Returns the factor of
 * f. */
static inline double lentz_step(double a, double b, double *c, double *d)
{
    const double tiny = 1e-300;
    *d = b + a * *d, *c = b + a / *c;
    if (fabs(*d) < tiny) *d = tiny;
    if (fabs(*c) < tiny) *c = tiny;
    *d = 1 / *d;
    return *c * *d;
}

enum { incomplete_steps = 1000000 };  /* about 5 sqrt(a) are needed */

/* x^a e^-x / Gamma(a) times: below the bend x = a + 1 a power series of P, above it a continued
 * fraction of Q = 1 - P; so neither is 1 minus a number that is close to 1. */
static inline double gamma_above(double a, double x)
{
    if (isnan(a) || isnan(x)) return (double)NAN;
    if (x <= 0) return 1;
    if (isinf(x)) return 0;
    double front = exp(a * log(x) - x - log_gamma(a));
    if (x < a + 1) {
        double term = 1 / a, sum = term;
        for (int k = 1; k < incomplete_steps && term > sum * DBL_EPSILON / 8; k++)
            sum += term *= x / (a + k);
        return 1 - front * sum;
    }
    double f = x + 1 - a, c = f, d = 0, step = 0;
    for (int k = 1; k < incomplete_steps && fabs(step - 1) > DBL_EPSILON; k++)
        f *= step = lentz_step(k * (a - k), x + 2 * k + 1 - a, &c, &d);
    return front / f;
}

static inline double beta_below(double a, double b, double x, double one_minus_x)
{
    if (isnan(a) || isnan(b) || isnan(x) || isnan(one_minus_x)) return (double)NAN;
    if (x <= 0) return 0;
    if (one_minus_x <= 0) return 1;
    if (x > (a + 1) / (a + b + 2))  /* the fraction would converge slowly: from the other end */
        return 1 - beta_below(b, a, one_minus_x, x);
    double front = exp(a * log(x) + b * log(one_minus_x) + log_gamma(a + b) - log_gamma(a)
                       - log_gamma(b)) / a;
    double f = 1, c = 1, d = 0, step = 0;
    for (int k = 1; k < incomplete_steps && fabs(step - 1) > DBL_EPSILON; k++) {
        double m = k / 2, am = a + 2 * m;
        double odd = -(a + m) * (a + b + m) * x / (am * (am + 1));
        double even = m * (b - m) * x / ((am - 1) * am);
        f *= step = lentz_step(k % 2 ? odd : even, 1, &c, &d);
    }
    return front / f;
}

#endif
