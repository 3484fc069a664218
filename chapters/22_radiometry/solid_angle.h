/* solid_angle.h: how much of the view a thing fills, in steradians [sr].       solid angle (立体角)
 *
 *            ___            Omega = A / r^2,  A the part of a sphere of radius r about p     (22.1)
 *         .-' A '-.         d omega = sin theta d theta d phi                                (22.2)
 *          \     /          all directions: 4 pi; what lies above a plane: 2 pi
 *           \   /
 *            \ /            cap_solid_angle(angle)        within [0, pi] of an axis         (22.3)
 *             p             sphere_solid_angle(s, p)      4 pi from inside                  (22.4)
 *                           sphere_cone(s, p)             its directions, for sample_cone
 *                           triangle_solid_angle(t, p)    signed, in [-2 pi, 2 pi]          (22.12)
 *                           rectangle_solid_angle(r, p)   the same
 *                           triangle_volume(t, p)         (a-p).((b-a)x(c-a)): its sign, too
 *
 * Signed: positive where the normal (b-a)x(c-a) points away from p, so that a closed mesh adds up
 * to 4 pi inside; negative in front. In the plane of the triangle: 0 outside, 2 pi within, 0 on
 * edges.
 *
 * First.h's 1 - cos loses all digits of a small cap, and of a sphere far away or near to touching;
 * the formula as it stands in chapter 07 those of a triangle seen edge-on, or from near to an edge;
 * a sum of angles less pi (Girard, lab/measure_hard.h) all of a small one.
 *
 * All here are right to 16 epsilon, relatively, for every p and nearly every triangle (as the reals
 * given describe it): the worst that a search for such triangles met is off by 39. What is clear
 * they compute fast, and again in twice the precision what is not: edge-on, slivers, p close to an
 * edge or to the sphere.
 *
 * Sources: A. Van Oosterom, J. Strackee, "The Solid Angle of a Plane Triangle", IEEE Trans. Biomed.
 * Eng. 30(2), 1983, eq. 8; J. Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast
 * Robust Geometric Predicates", 1997.
 */
#ifndef RADIOMETRY_SOLID_ANGLE_H
#define RADIOMETRY_SOLID_ANGLE_H

#include "../01_ray/affine.h"
#include "../03_sphere/sphere.h"
#include "../20_monte_carlo/sampling.h"
#include "first.h"

/* Corners o, o + s, o + s + t, o + t, with s.t = 0; its front is where s x t points. */
typedef struct { vec3 o, s, t; } rectangle;

/* ---------------------------------------------------------------------------------------------- */

/* Light, and p, may be scaled together. In float a product of three distances of 1e15 overflows, of
 * 1e-15 vanishes: then this is the e with which 2^e far comes near to 1; otherwise 0. */
static inline int needed_scale(real far)
{
    const real most = real_is_float ? (real)0x1p16 : (real)0x1p128;
    int e = 0;
    if ((far > most && far <= real_largest) || (far > 0 && far < 1 / most)) (void)frexp(far, &e);
    return -e;
}

static inline sphere sphere_scaled(sphere s, int e)
{
    return (sphere){vscaled_by(s.c, e), ldexp(s.r, e)};
}

/* ---- cap, sphere ---- */

/* The naive forms are those of first.h. */
static inline real cap_solid_angle(real angle) { return 4 * pi * cone_of_angle(angle).half_sine2; }

/* |c - p|^2 - r^2, right to the last bits even where p is an ulp from the sphere. */
static inline real sphere_power_at(sphere s, vec3 p)
{
    wide3 f = {wide_sum((double)s.c.x, -(double)p.x), wide_sum((double)s.c.y, -(double)p.y),
               wide_sum((double)s.c.z, -(double)p.z)};
    return (real)wide_value(sphere_power(f, (double)s.r));
}

/* sin^2 = r^2 / d^2 and cos = sqrt(d^2 - r^2) / d: sin^2(half) = sin^2 / (2 (1 + cos)), no 1 - cos.
 * On the sphere itself a half of all directions, inside of it all of them. */
static inline direction_cone sphere_cone(sphere s, vec3 p)
{
    real d = vlength(vsub(s.c, p)), r = fabs(s.r), power = (d - r) * (d + r);
    int e = needed_scale(real_max(d, r));
    if (e) return sphere_cone(sphere_scaled(s, e), vscaled_by(p, e));
    if (fabs(power) < d * d / 16) power = sphere_power_at(s, p);
    if (power < 0) return (direction_cone){1};
    if (d == 0) return (direction_cone){0};
    real sine = r / d;
    return (direction_cone){sine * sine / (2 * (1 + sqrt(power) / d))};
}

static inline real sphere_solid_angle(sphere s, vec3 p)
{
    return 4 * pi * sphere_cone(s, p).half_sine2;
}

/* ---- triangle ---- */

/* The three corners seen from p, without error. */
typedef struct { wide3 a, b, c; } wide_corners;

static inline wide3 wide3_between(vec3 p, vec3 q, int e)  /* 2^e (q - p) */
{
    double x = ldexp((double)p.x, e), y = ldexp((double)p.y, e), z = ldexp((double)p.z, e);
    return (wide3){wide_sum(ldexp((double)q.x, e), -x), wide_sum(ldexp((double)q.y, e), -y),
                   wide_sum(ldexp((double)q.z, e), -z)};
}

/* The e with which the farthest of them comes near to 1. */
static inline int wide_scale(vec3 a, vec3 b, vec3 c)
{
    real far = real_max(real_max(vlargest(a), vlargest(b)), vlargest(c));
    int e = 0;
    if (far > 0 && far <= real_largest) (void)frexp(far, &e);
    return -e;
}

/* a.(b x c) = a.((b-a) x (c-a)); the second form has the small differences that count. */
static inline wide wide_volume(wide_corners k)
{
    return wide3_dot(k.a, wide3_cross(wide3_sub(k.b, k.a), wide3_sub(k.c, k.a)));
}

/* The denominator of (22.12). */
static inline wide wide_denominator(wide_corners k)
{
    wide la = wide3_length(k.a), lb = wide3_length(k.b), lc = wide3_length(k.c);
    wide d = wide_mul(wide_mul(la, lb), lc);
    d = wide_add(d, wide_mul(wide3_dot(k.a, k.b), lc));
    d = wide_add(d, wide_mul(wide3_dot(k.b, k.c), la));
    return wide_add(d, wide_mul(wide3_dot(k.c, k.a), lb));
}

/* (22.12) with 32 digits; only the arc tangent is a double's. */
static inline real wide_solid_angle(wide_corners k)
{
    double n = wide_value(wide_volume(k)), d = wide_value(wide_denominator(k));
    return (real)(2 * atan2(n == 0 ? 0 : n, d));  /* no -0: inside it is +2 pi */
}

static inline wide_corners corners_of_triangle(triangle t, vec3 p, int *e)
{
    *e = wide_scale(vsub(t.a, p), vsub(t.b, p), vsub(t.c, p));
    return (wide_corners){wide3_between(p, t.a, *e), wide3_between(p, t.b, *e),
                          wide3_between(p, t.c, *e)};
}

/* tan(Omega / 2) = a.(s x t) / (|a||b||c| + a.b |c| + b.c |a| + c.a |b|),                   (22.12)
 * b = a + s, c = a + t.
 * The numerator is off by some epsilon |a||s||t|, the denominator by some epsilon |a||b||c|, and by
 * more if b or c is short: it is a + s or a + t, and off by an epsilon |a|. false: that may be more
 * than 16 epsilon of the angle; so may it be where something over- or underflows. */
static inline bool triangle_solid_angle_fast(vec3 a, vec3 s, vec3 t, real *omega)
{
    vec3 b = vadd(a, s), c = vadd(a, t);
    real la = sqrt(vdot(a, a)), lb = sqrt(vdot(b, b)), lc = sqrt(vdot(c, c));
    real n = vdot(a, vcross(s, t)), whole = la * lb * lc;
    real d = whole + vdot(a, b) * lc + vdot(b, c) * la + vdot(c, a) * lb;
    real off = la * sqrt(vdot(s, s) * vdot(t, t)), sure = fabs(n) * (fabs(n) + fabs(d));
    real off_d = 2 * whole + la * la * (lb + lc) / 2;
    *omega = 2 * atan2(n, d);
    return fabs(d) * off + fabs(n) * off_d <= 16 * sure && square_is_safe(sure)
        && 16 * sure < real_largest && square_is_safe(n * n);  /* infinity, or a NaN: false */
}

static inline real triangle_solid_angle(triangle t, vec3 p)
{
    real omega;
    int e;
    if (triangle_solid_angle_fast(vsub(t.a, p), vsub(t.b, t.a), vsub(t.c, t.a), &omega))
        return omega;
    return wide_solid_angle(corners_of_triangle(t, p, &e));
}

/* Six times the signed volume of the tetrahedron p a b c; relatively right, as above. */
static inline real triangle_volume(triangle t, vec3 p)
{
    vec3 a = vsub(t.a, p), s = vsub(t.b, t.a), u = vsub(t.c, t.a);
    real n = vdot(a, vcross(s, u)), off2 = vdot(a, a) * vdot(s, s) * vdot(u, u);
    if (64 * n * n >= off2 && square_is_safe(n * n) && off2 <= real_largest) return n;
    int e;
    wide_corners k = corners_of_triangle(t, p, &e);
    return ldexp((real)wide_value(wide_volume(k)), -3 * e);
}

/* ---- rectangle: two triangles, halves of it ---- */

static inline wide3 wide3_exactly(vec3 s, int e) { return wide3_between((vec3){0, 0, 0}, s, e); }
static inline wide3 wide3_plus(wide3 a, wide3 b) { return wide3_madd(a, b, wide_of(1)); }

/* The two triangles o, o+s, o+t and o+s+t, o+t, o+s. */
static inline int corners_of_rectangle(rectangle r, vec3 p, wide_corners k[2])
{
    vec3 a = vsub(r.o, p), b = vadd(a, r.s);
    int e = wide_scale(a, b, vadd(b, r.t));
    wide3 s = wide3_exactly(r.s, e), t = wide3_exactly(r.t, e), wa = wide3_between(p, r.o, e);
    k[0] = (wide_corners){wa, wide3_plus(wa, s), wide3_plus(wa, t)};
    k[1] = (wide_corners){wide3_plus(k[0].b, t), k[0].c, k[0].b};
    return e;
}

static inline real rectangle_volume(rectangle r, vec3 p)
{
    vec3 a = vsub(r.o, p);
    real n = vdot(a, vcross(r.s, r.t)), off2 = vdot(a, a) * vdot(r.s, r.s) * vdot(r.t, r.t);
    if (64 * n * n >= off2 && square_is_safe(n * n) && off2 <= real_largest) return n;
    wide_corners k[2];
    int e = corners_of_rectangle(r, p, k);
    return ldexp((real)wide_value(wide_volume(k[0])), -3 * e);
}

/* Of its two halves. */
static inline void rectangle_solid_angles(rectangle r, vec3 p, real *one, real *two)
{
    vec3 a = vsub(r.o, p), c = vadd(vadd(a, r.s), r.t);
    if (triangle_solid_angle_fast(a, r.s, r.t, one)
        && triangle_solid_angle_fast(c, vneg(r.s), vneg(r.t), two)) return;
    wide_corners k[2];
    corners_of_rectangle(r, p, k);
    *one = wide_solid_angle(k[0]), *two = wide_solid_angle(k[1]);
}

static inline rectangle rectangle_scaled(rectangle r, int e)
{
    return (rectangle){vscaled_by(r.o, e), vscaled_by(r.s, e), vscaled_by(r.t, e)};
}

/* The longest side or way from p to o. */
static inline real rectangle_far(rectangle r, vec3 p)
{
    return real_max(vlength(vsub(r.o, p)), real_max(vlength(r.s), vlength(r.t)));
}

static inline real rectangle_solid_angle(rectangle r, vec3 p)
{
    real one, two;
    rectangle_solid_angles(r, p, &one, &two);
    return one + two;
}

#endif
