/* sampling.h: two numbers u, v in [0,1) become a point of a disk or a triangle, or a direction.
 *
 *   sample                          where                      pdf (概率密度函数), and per what
 *   sample_disk(u, v)               unit disk, (x, y, 0)       pdf_disk      1 / pi         area
 *   sample_triangle(u, v)           barycentrics (b0,b1,b2)    pdf_triangle  1 / area of t  area
 *   sample_sphere(u, v)             all directions             pdf_sphere    1 / (4 pi)     1/sr
 *   sample_hemisphere(u, v)         z > 0                      1 / (2 pi)                   1/sr
 *   sample_cosine(u, v)             z > 0, more upwards        z / pi                       1/sr
 *   first_cosine_direction(u, v)    the same (first.h)         the same
 *   sample_lobe(n, u, v)            z > 0, n >= 0              (n + 1) / (2 pi) z^n         1/sr
 *   sample_cone(c, u, v)            within an angle of z       1 / (4 pi c.half_sine2)      1/sr
 *   directed(n, w)                  turns +z to the unit n
 *   triangle_at(t, b.y, b.z)        the point with barycentrics b (chapter 04)
 *
 * Directions have unit length within 4 epsilon. pdfs take the sample and are 0 outside the domain.
 * Every sample has a pdf > 0, whatever u and v. No weight is included: an estimate divides f (with
 * its cosine, if it has one) by the pdf. A pdf is a density, no probability: it may exceed 1, as
 * that of a narrow cone does.
 *
 * Three ways: inversion (逆变换), where the cumulative distribution P(x) = u can be solved for x
 * (sample_lobe, and z of all directions); transformation (变换) of a shape that is easy into one that
 * is not, with a constant ratio of areas (disk, triangle); projection (sample_cosine: a uniform
 * disk lifted to the hemisphere). Those without a suffix keep neighbours of the square neighbours,
 * which well-spread (u, v) need (sampler.h); rejection (拒绝) would throw away what they have.
 *
 * Sources: P. Shirley, K. Chiu, "A low distortion map between disk and square", J. Graphics Tools
 * 2(3), 1997; E. Heitz, "A low-distortion map between triangle and square", 2019; G. Turk,
 * "Generating random points in triangles", Graphics Gems, 1990; M. Pharr, W. Jakob, G. Humphreys,
 * "Physically Based Rendering", 3rd ed., 2016, section 13.6; T. Malley (the lifted disk), 1988.
 */
#ifndef MONTE_CARLO_SAMPLING_H
#define MONTE_CARLO_SAMPLING_H

#include "../04_triangle/triangle.h"
#include "first.h"

/* Its size: sin^2(angle / 2), the angle being the one between axis and side, in (0, pi]. */
typedef struct { real half_sine2; } direction_cone;

/* ---------------------------------------------------------------------------------------------- */

/* z and r = sqrt(1 - z^2), turned by v of a full turn about +z. */
static inline vec3 sample_turn(real r, real z, real v)
{
    real phi = 2 * pi * v;
    return (vec3){r * cos(phi), r * sin(phi), z};
}

/* ---- disk: squares of radius a become circles of radius a ---- */

/* cos and sin of x, |x| <= pi / 4, within epsilon, by polynomials: libm's, which first reduce any
 * angle, take 3 % more of all instructions of 26. Source of the factors: Sun Microsystems, fdlibm,
 * k_sin.c and k_cos.c, 1993. */
fast_inline void sample_angle(real x, real *cosine, real *sine)
{
    static const double a[6] = {1.58969099521155010221e-10, -2.50507602534068634195e-08,
                                2.75573137070700676789e-06, -1.98412698298579493134e-04,
                                8.33333333332248946124e-03, -1.66666666666666324348e-01};
    static const double b[6] = {-1.13596475577881948265e-11, 2.08757232129817482790e-09,
                                -2.75573143513906633035e-07, 2.48015872894767294178e-05,
                                -1.38888888888741095749e-03, 4.16666666666666019037e-02};
    real z = x * x, s = 0, c = 0;
#pragma GCC unroll 6
    for (int k = 0; k < 6; k++) s = (real)a[k] + z * s, c = (real)b[k] + z * c;
    *cosine = 1 - (z / 2 - z * z * c), *sine = x + x * z * s;
}

/* In the eighth next to the x axis: radius a, and the angle goes as b / a, by 45 degrees at most.
 * Which of the two is larger is an index, not a branch, which nobody could predict. */
fast_inline vec3 sample_disk(real u, real v)
{
    real ab[2] = {2 * u - 1, 2 * v - 1}, xy[2];
    int flat = fabs(ab[0]) > fabs(ab[1]);
    real r = ab[!flat], q = ab[flat];
    if (r == 0) return (vec3){0, 0, 0};
    real c, s;
    sample_angle(pi / 4 * (q / r), &c, &s);
    xy[!flat] = r * c, xy[flat] = r * s;
    return (vec3){xy[0], xy[1], 0};
}

static inline real pdf_disk(vec3 p)
{
    return p.x * p.x + p.y * p.y <= 1 + 4 * real_epsilon ? 1 / pi : 0;
}

/* ---- triangle ---- */

/* Presses the square onto the half below its diagonal, along the other diagonal: halves the area
 * everywhere, and needs no root. b0 is what is left of 1: not negative, since the sum of the others
 * is max(u, v) but for rounding, which can bring it up to 1 and no further. */
static inline vec3 sample_triangle(real u, real v)
{
    if (v > u) u /= 2, v -= u;
    else v /= 2, u -= v;
    return (vec3){1 - (u + v), u, v};
}

/* Without area: infinity, so that f / pdf is 0. */
static inline real pdf_triangle(triangle t)
{
    return 2 / vlength(vcross(vsub(t.b, t.a), vsub(t.c, t.a)));
}

/* ---- directions: z by inversion. On a sphere P(z) is linear in z (Archimedes) ---- */

/* 1 - z^2 as a product: from z itself it would lose all digits near the poles. */
static inline vec3 sample_sphere(real u, real v)
{
    return sample_turn(2 * sqrt(u * (1 - u)), 1 - 2 * u, v);
}

static inline real pdf_sphere(vec3 w) { return vzero(w) ? 0 : 1 / (4 * pi); }

static inline vec3 sample_hemisphere(real u, real v)
{
    return sample_turn(sqrt(u * (2 - u)), 1 - u, v);
}

static inline real pdf_hemisphere(vec3 w) { return w.z > 0 ? 1 / (2 * pi) : 0; }

/* A unit disk lifted to the hemisphere: d omega cos = dA. Its edge (u or v = 0) would have the pdf
 * 0, and f / pdf would be 0/0: z stays above 0. */
fast_inline vec3 sample_cosine(real u, real v)
{
    vec3 w = sample_disk(u, v);
    real r = real_max(fabs(2 * u - 1), fabs(2 * v - 1));
    w.z = sqrt(real_max((1 - r) * (1 + r), real_smallest));
    return w;
}

static inline real pdf_cosine(vec3 w) { return w.z > 0 ? w.z / pi : 0; }

/* P(z) = 1 - z^(n+1) = u, so log z = log(1 - u) / (n + 1); 1 - z^2 = -expm1(2 log z) keeps its
 * digits when z is nearly 1, as it is for large n. */
static inline vec3 sample_lobe(real n, real u, real v)
{
    real l = log1p(-u) / (n + 1);
    return sample_turn(sqrt(-expm1(2 * l)), exp(l), v);
}

static inline real pdf_lobe(real n, vec3 w)
{
    return w.z > 0 ? (n + 1) / (2 * pi) * pow(w.z, n) : 0;
}

/* ---- cone: z = 1 - 2 q, q = sin^2(theta / 2) uniform below that of the side ---- */

static inline direction_cone cone_of_angle(real angle)
{
    real s = sin(angle / 2);
    return (direction_cone){s * s};
}

/* The cone under which a sphere is seen from outside: sin angle = radius / distance [at most 1],
 * and sin^2(angle/2) = (1 - cos) / 2 = sin^2 / (2 (1 + cos)). */
static inline direction_cone cone_of_sphere(real radius, real distance)
{
    real s = radius / distance, c = sqrt(real_max((1 - s) * (1 + s), 0));
    return (direction_cone){s * s / (2 * (1 + c))};
}

static inline vec3 sample_cone(direction_cone c, real u, real v)
{
    real q = u * c.half_sine2;
    return sample_turn(2 * sqrt(q * (1 - q)), 1 - 2 * q, v);
}

static inline real pdf_cone(direction_cone c, vec3 w)
{
    real q = w.z > 0 ? (w.x * w.x + w.y * w.y) / (2 * (1 + w.z)) : (1 - w.z) / 2;
    return q <= c.half_sine2 * (1 + 16 * real_epsilon) ? 1 / (4 * pi * c.half_sine2) : 0;
}

#endif
