/* pattern.h: two pictures whose filtered value is known exactly, to measure filters with.
 *
 *   checkerboard   1/2 + 1/2 s(x) s(y), s = +1 and -1 in turn, on stretches of length `cell`
 *   zone plate     1/2 + 1/2 cos(a (x^2 + y^2)): rings that get finer outward (波带片);
 *                  at distance R they are pi / (a R) apart, so a grid of pixels can show them up to
 *                  R = pi / (2 a), and nothing but grey should remain beyond
 *
 *   checkerboard(x, y, cell)   checkerboard_filtered(x, y, cell, f)       f: box or tent
 *   zone_plate(x, y, a)        zone_plate_filtered(x, y, a, sigma)       under a Gaussian
 *
 * (x, y) in pixels. A separable filter turns s(x) s(y) into the product of two integrals:
 * differences of the first antiderivative of s under the box, of the second under the tent. The
 * zone plate is the real part of exp(i a x^2) exp(i a y^2), and under a Gaussian without cut-off,
 * with g = 1 - 2 i a sigma^2,
 *   E exp(i a X^2) = g^(-1/2) exp(i a x^2 / g)                                 (2.12)
 * These are oracles: always in double, right to 1e-12 for |x|, |y| up to 1000, but for the zone
 * plate unfiltered: to an epsilon of its phase a (x^2 + y^2).
 */
#ifndef CAMERA_LAB_PATTERN_H
#define CAMERA_LAB_PATTERN_H

#include "../filter.h"

/* ---------------------------------------------------------------------------------------------- */

/* s(x): +1 on [0, cell), -1 on [cell, 2 cell), and so on, both ways. */
static inline double square_wave(double x, double cell)
{
    double k = floor(x / cell);
    return k - 2 * floor(k / 2) == 0 ? 1 : -1;
}

/* Its first antiderivative without the mean, and the antiderivative of that: periodic. */
static inline double square_wave_integral(double x, double cell)
{
    double p = x - 2 * cell * floor(x / (2 * cell));
    return p < cell ? p - cell / 2 : 3 * cell / 2 - p;
}

static inline double square_wave_integral_2(double x, double cell)
{
    double p = x - 2 * cell * floor(x / (2 * cell)), y = p < cell ? p : p - cell;
    return (p < cell ? 1 : -1) * (y * y - cell * y) / 2;
}

static inline double square_wave_filtered(double x, double cell, filter f)
{
    double R = (double)f.radius;
    if (f.kind == FILTER_BOX)
        return (square_wave_integral(x + R, cell) - square_wave_integral(x - R, cell)) / (2 * R);
    return (square_wave_integral_2(x + R, cell) - 2 * square_wave_integral_2(x, cell)
            + square_wave_integral_2(x - R, cell)) / (R * R);
}

static inline double checkerboard(double x, double y, double cell)
{
    return 0.5 + 0.5 * square_wave(x, cell) * square_wave(y, cell);
}

static inline double checkerboard_filtered(double x, double y, double cell, filter f)
{
    return 0.5 + 0.5 * square_wave_filtered(x, cell, f) * square_wave_filtered(y, cell, f);
}

static inline double zone_plate(double x, double y, double a)
{
    return 0.5 + 0.5 * cos(a * (x * x + y * y));
}

/* (2.12) for both axes: g^-1 exp(i a r^2 / g), 1 / g = (1 + i q) / (1 + q^2), q = 2 a sigma^2. */
static inline double zone_plate_filtered(double x, double y, double a, double sigma)
{
    double q = 2 * a * sigma * sigma, h = 1 / (1 + q * q), phase = a * (x * x + y * y) * h;
    return 0.5 + 0.5 * h * exp(-q * phase) * (cos(phase) - q * sin(phase));
}

#endif
