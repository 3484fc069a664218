/* oracle.h: closed forms evaluated with 32 digits, to measure the others against.
 *
 *   wide_atan2(y, x)                        the angle of (x, y), y >= 0, off by 1e-30 relatively
 *   sphere_solid_angle_exact(s, p)          (22.4); 4 pi from inside
 *   sphere_irradiance_exact(r, a, h)        (22.13): radius, across, height; d^2 > r^2
 *   triangle_solid_angle_exact(t, p)        (22.12)
 *   rectangle_irradiance_exact(r, p, n)     of a flat light of L = 1 [sr]; it shines to the front,
 *   triangle_irradiance_exact(t, p, n)      where its corners run counterclockwise; p not in it
 *
 *        v1 ________ v0            E / L = -1/2 sum over the edges of theta_i n . g_i       (22.15)
 *          /_______/               theta_i: the angle under which p sees edge i,
 *        v2      v3 front below    g_i: unit (v_i - p) x (v_i+1 - p)
 *   _______|n__________
 *          p                       Of the part above the horizon of p.
 *
 * Their formulas cancel like the naive ones, but of 32 digits enough is left: a result that is
 * 1e-15 of its terms is right to 1e-16. p or n: as far as real knows them.
 *
 * Sources: J. H. Lambert, "Photometria", 1760; D. Baum, H. Rushmeier, J. Winget, "Improving
 * Radiosity Solutions through the Use of Analytically Determined Form-Factors", SIGGRAPH 1989.
 */
#ifndef RADIOMETRY_ORACLE_H
#define RADIOMETRY_ORACLE_H

#include "../solid_angle.h"

/* ---------------------------------------------------------------------------------------------- */

enum { oracle_most = 4 };  /* corners of a flat light */
static const wide wide_pi = {3.141592653589793116, 1.2246467991473531772e-16};

/* tan(a/2) = y / (x + r): ten times the half of the angle, by a sum or what equals it where x < 0;
 * then the series of the arc tangent, whose terms fall by 2e-6. */
static inline wide wide_atan2(wide y, wide x)
{
    wide sum = wide_of(0);
    if (wide_sign(y) == 0) return wide_sign(x) < 0 ? wide_pi : sum;
    for (int i = 0; i < 10; i++) {
        wide yy = wide_mul(y, y), r = wide_sqrt(wide_add(wide_mul(x, x), yy));
        x = wide_sign(x) < 0 ? wide_div(yy, wide_sub(r, x)) : wide_add(x, r);
    }
    wide t = wide_div(y, x), tt = wide_mul(t, t);
    for (int k = 6; k >= 0; k--)
        sum = wide_sub(wide_div(wide_of(1), wide_of(2 * k + 1)), wide_mul(tt, sum));
    return wide_mul(wide_of(1024), wide_mul(t, sum));
}

static inline double sphere_solid_angle_exact(sphere s, vec3 p)
{
    wide3 f = wide3_between(p, s.c, 0);
    wide dd = wide3_dot(f, f), rr = wide_product((double)s.r, (double)s.r);
    wide power = wide_sub(dd, rr);
    if (wide_sign(power) < 0) return 4 * 3.14159265358979324;
    wide cosine = wide_sqrt(wide_div(power, dd));
    wide q = wide_div(wide_div(rr, dd), wide_add(wide_of(1), cosine));
    return 2 * 3.14159265358979324 * wide_value(q);
}

static inline double triangle_solid_angle_exact(triangle t, vec3 p)
{
    int e;
    wide_corners k = corners_of_triangle(t, p, &e);
    wide n = wide_volume(k), d = wide_denominator(k);
    double half = wide_value(wide_atan2(wide_sign(n) < 0 ? wide_neg(n) : n, d));
    return wide_sign(n) < 0 ? -2 * half : 2 * half;
}

static inline double sphere_irradiance_exact(double r, double a, double h)
{
    wide rr = wide_product(r, r), hh = wide_product(h, h), dd = wide_add(wide_product(a, a), hh);
    wide d = wide_sqrt(dd), k = wide_sqrt(wide_sub(dd, rr)), q = wide_div(rr, dd);
    wide slope = wide_div(wide_of(h), d);
    if (h >= r) return wide_value(wide_mul(wide_mul(wide_pi, q), slope));
    if (h <= -r) return 0;
    wide w = wide_sqrt(wide_sub(rr, hh));
    wide e = wide_sub(wide_atan2(w, k), wide_div(wide_mul(k, w), dd));
    wide angle = wide_atan2(wide_mul(w, d), wide_mul(wide_of(-h), k));
    return wide_value(wide_add(e, wide_mul(wide_mul(q, slope), angle)));
}

/* Lambert's sum over the part above the horizon: where an edge crosses it, it is cut. */
static inline double irradiance_exact(const wide3 *corner, int count, vec3 n)
{
    wide3 v[2 * oracle_most], up = wide3_of(n);
    int m = 0;
    for (int i = 0; i < count; i++) {
        wide3 a = corner[i], b = corner[(i + 1) % count];
        wide za = wide3_dot(a, up), zb = wide3_dot(b, up);
        if (za.hi > 0) v[m++] = a;
        if ((za.hi > 0) != (zb.hi > 0))
            v[m++] = wide3_madd(a, wide3_sub(b, a), wide_div(za, wide_sub(za, zb)));
    }
    wide sum = wide_of(0);
    for (int i = 0; i < m; i++) {
        wide3 a = v[i], b = v[(i + 1) % m], cross = wide3_cross(a, wide3_sub(b, a));
        wide l = wide3_length(cross), slope = wide3_dot(cross, up);
        if (l.hi > 0)
            sum = wide_sub(sum, wide_mul(wide_atan2(l, wide3_dot(a, b)), wide_div(slope, l)));
    }
    return sum.hi > 0 ? sum.hi / 2 : 0;
}

static inline double triangle_irradiance_exact(triangle t, vec3 p, vec3 n)
{
    return irradiance_exact((wide3[]){wide3_between(p, t.a, 0), wide3_between(p, t.b, 0),
                                      wide3_between(p, t.c, 0)}, 3, n);
}

static inline double rectangle_irradiance_exact(rectangle r, vec3 p, vec3 n)
{
    wide3 a = wide3_between(p, r.o, 0), s = wide3_of(r.s), t = wide3_of(r.t);
    wide3 b = wide3_plus(a, s);
    return irradiance_exact((wide3[]){a, b, wide3_plus(b, t), wide3_plus(a, t)}, 4, n);
}

#endif
