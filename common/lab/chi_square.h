/* chi_square.h: do these counts come from those expectations?            chi-square test (卡方检验)
 *
 *   X = sum over the bins of (observed - expected)^2 / expected                             (20.18)
 *
 * If they do, X is nearly chi-square distributed with bins - 1 degrees of freedom (自由度), and p, the
 * probability of so large an X or a larger one, is uniform in [0,1]. So a test that fails where
 * p < 1e-6 fails by bad luck once in a million seeds: its false-alarm rate (误报率). It can't prove a
 * sampler right; it shows one wrong if the bins see the fault and n is large enough.
 *
 *   chi_square_result r = chi_square_test(observed, expected, bins);
 *   r.p < 1e-6: they do not
 *
 *   chi_square_result r = chi_square_directions(sample, pdf, context, focus, seed, n);
 *   chi_square_result r = chi_square_points(sample, pdf, context, DOMAIN_DISK, seed, n);
 *
 * The last two ask a sampler and its pdf about each other: n samples from random (u, v), and the
 * pdf integrated numerically over cells of equal area. r.integral, the whole, must be 1 for a pdf
 * whose samples are never rejected. A direction (0,0,0) is a rejection; those have a bin of their
 * own.
 *
 *   sample    vec3 (real u, real v, const void *context), u, v in [0,1). Directions: unit length.
 *             DOMAIN_DISK: (x, y, 0) in the unit disk; DOMAIN_TRIANGLE: barycentrics (b0, b1, b2)
 *   pdf       real (vec3 w, const void *context): per solid angle [1/sr], or per area; the triangle
 *             has the area 1/2
 *   focus     >= 1: cells of directions grow finer towards +z, for lobes; 1: all equal
 *
 * Bins with an expectation below 5 are put together, since there the distribution is not
 * chi-square. A count where nothing can be is p = 0 at once.
 *
 * Sources: K. Pearson, "On the criterion that a given system of deviations ...", Phil. Mag. 50,
 * 1900; W. Cochran, "The chi-square test of goodness of fit", Ann. Math. Stat. 23, 1952 (the 5);
 * W. Jakob, Nori (2010..): a sampler and its pdf tested against each other.
 */
#ifndef CHI_SQUARE_H
#define CHI_SQUARE_H

#include "../random.h"
#include "../numbers/incomplete.h"
#include <stddef.h>

typedef struct { double statistic, p, integral; size_t degrees; } chi_square_result;
typedef vec3 chi_square_sampler(real u, real v, const void *context);
typedef real chi_square_pdf(vec3 w, const void *context);
typedef enum { DOMAIN_DISK, DOMAIN_TRIANGLE } chi_square_domain;

/* ---------------------------------------------------------------------------------------------- */

/* The probability that chi-square of so many degrees of freedom is x or more. */
static inline double chi_square_p(double x, size_t degrees)
{
    return degrees == 0 ? 1 : gamma_above((double)degrees / 2, x / 2);
}

static inline double chi_square_term(double observed, double expected)
{
    return (observed - expected) * (observed - expected) / expected;
}

static inline chi_square_result chi_square_test(const double *observed, const double *expected,
                                                size_t bins)
{
    const double least = 5;
    chi_square_result r = {.p = 1};
    double o = 0, e = 0;  /* small bins, put together */
    size_t used = 0;
    bool impossible = false;
    for (size_t i = 0; i < bins; i++) {
        impossible |= !(expected[i] >= 0) || (expected[i] == 0 && observed[i] > 0);
        if (expected[i] >= least) {
            r.statistic += chi_square_term(observed[i], expected[i]), used++;
            continue;
        }
        o += observed[i], e += expected[i];
        if (e >= least) r.statistic += chi_square_term(o, e), used++, o = e = 0;
    }
    if (e > 0) r.statistic += (o - e) * (o - e) / least, used++;  /* rather too small */
    r.degrees = used > 1 ? used - 1 : 0;
    r.p = impossible ? 0 : chi_square_p(r.statistic, r.degrees);
    return r;
}

enum { chi_square_down = 32, chi_square_across = 32, chi_square_cells = 32 * 32 };

/* The domain as a unit square, areas kept in proportion (up to the focus): (s, t) and back.
 * Directions: z = 1 - 2 s^focus, t turns (Archimedes). Disk: s = r^2, t turns. Triangle: the part
 * beyond the parallel to an edge through the point, and where on that parallel. */
typedef struct { int shape; double focus; } chi_square_chart;
enum { chart_directions = -1 };

static inline double chi_square_focus(chi_square_chart c, double s)
{
    return c.focus == 1 ? s : pow(s, c.focus);
}

static inline vec3 chi_square_point(chi_square_chart c, double s, double t)
{
    double turn = 2 * (double)pi * t, q = chi_square_focus(c, s), z = 1 - 2 * q;
    if (c.shape == DOMAIN_TRIANGLE)
        return vec((1 - sqrt(s)), (sqrt(s) * (1 - t)), (sqrt(s) * t));
    double r = c.shape == DOMAIN_DISK ? sqrt(s) : sqrt(4 * q * (1 + z) / 2);
    if (c.shape == DOMAIN_DISK) z = 0;
    return vec((r * cos(turn)), (r * sin(turn)), z);
}

/* Area between s0 and s1, for all t: of 1/2 (triangle), pi (disk), 4 pi (directions). */
static inline double chi_square_area(chi_square_chart c, double s0, double s1)
{
    if (c.shape == DOMAIN_TRIANGLE) return (s1 - s0) / 2;
    if (c.shape == DOMAIN_DISK) return (double)pi * (s1 - s0);
    return 4 * (double)pi * (chi_square_focus(c, s1) - chi_square_focus(c, s0));
}

/* The cell of a point; -1 for one outside the domain by more than rounding. */
static inline int chi_square_cell(chi_square_chart c, vec3 w)
{
    double x = (double)w.x, y = (double)w.y, z = (double)w.z, s, t, off;
    if (c.shape == DOMAIN_TRIANGLE) {
        s = (1 - x) * (1 - x), t = z / (y + z > 0 ? y + z : 1);
        off = fabs(x + y + z - 1);
        if (x < 0 || y < 0 || z < 0) off = 1;
    } else {
        double rr = x * x + y * y;
        t = atan2(y, x) / (2 * (double)pi);
        if (c.shape == DOMAIN_DISK) s = rr, off = rr > 1 ? rr - 1 : fabs(z);
        else {
            s = pow(z > 0 ? rr / (2 * (1 + z)) : (1 - z) / 2, 1 / c.focus);  /* (1 - z) / 2 */
            off = fabs(rr + z * z - 1);
        }
        t -= floor(t);
    }
    if (!(off < 16 * (double)real_epsilon)) return -1;  /* a NaN, too */
    int i = (int)(s * chi_square_down), j = (int)(t * chi_square_across);
    if (i >= chi_square_down) i = chi_square_down - 1;
    if (j >= chi_square_across) j = chi_square_across - 1;
    return i * chi_square_across + j;
}

/* The pdf over one cell: the midpoint rule, 16 x 8 points. */
static inline double chi_square_expected(chi_square_chart c, int cell, chi_square_pdf *pdf,
                                         const void *context)
{
    enum { down = 16, across = 8 };
    int i = cell / chi_square_across, j = cell % chi_square_across;
    double sum = 0, h = 1.0 / (down * chi_square_down);
    for (int k = 0; k < down * across; k++) {
        double s = (i * down + k / across) * h;
        double t = (j + (k % across + 0.5) / across) / chi_square_across;
        vec3 w = chi_square_point(c, s + h / 2, t);
        sum += (double)pdf(w, context) * chi_square_area(c, s, s + h);
    }
    return sum / (across * chi_square_across);
}

/* One bin more for rejections, and one for what lies outside the domain: nothing must. */
static inline chi_square_result chi_square_charted(chi_square_chart c, chi_square_sampler *sample,
                                                   chi_square_pdf *pdf, const void *context,
                                                   uint64_t seed, size_t n)
{
    enum { rejected = chi_square_cells, outside, bins };
    double observed[bins] = {0}, expected[bins] = {0}, whole = 0;
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(seed, 0, i);
        real u = random_next(&s), v = random_next(&s);
        vec3 w = sample(u, v, context);
        int cell = vzero(w) && c.shape == chart_directions ? rejected : chi_square_cell(c, w);
        observed[cell < 0 ? outside : cell]++;
    }
    for (int k = 0; k < chi_square_cells; k++) {
        double p = chi_square_expected(c, k, pdf, context);
        whole += p, expected[k] = p * (double)n;
    }
    if (observed[rejected] > 0) expected[rejected] = (1 - whole) * (double)n;
    chi_square_result r = chi_square_test(observed, expected, bins);
    r.integral = whole;
    return r;
}

static inline chi_square_result chi_square_directions(chi_square_sampler *sample,
                                                      chi_square_pdf *pdf, const void *context,
                                                      double focus, uint64_t seed, size_t n)
{
    chi_square_chart c = {chart_directions, focus};
    return chi_square_charted(c, sample, pdf, context, seed, n);
}

static inline chi_square_result chi_square_points(chi_square_sampler *sample, chi_square_pdf *pdf,
                                                  const void *context, chi_square_domain shape,
                                                  uint64_t seed, size_t n)
{
    return chi_square_charted((chi_square_chart){(int)shape, 1}, sample, pdf, context, seed, n);
}

#endif
