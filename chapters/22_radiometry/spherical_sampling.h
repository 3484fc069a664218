/* spherical_sampling.h: points of a triangle or a rectangle, uniform in the solid angle p sees.
 *
 *      c___             spherical_triangle k = spherical_triangle_of(t, p);   once a p
 *      |   \ c'         vec3 b = spherical_triangle_sample(&k, u, v);   barycentrics (b0, b1, b2)
 *      |   .\           x = triangle_at(t, b.y, b.z), the direction is x - p;
 *      |  x  \          pdf = 1 / k.omega [1/sr], the same for all; k.omega = 0: nothing to see
 *      a------b
 *                       spherical_rectangle r = spherical_rectangle_of(q, p);
 *   c' on the edge      vec3 y = spherical_rectangle_sample(&r, u, v);   y.x, y.y in [0,1]
 *   a c so that a b c'  x = rectangle_at(q, y), y.x along s, y.y along t; pdf = 1 / r.omega
 *   has the share u of
 *   the solid angle;    variant                            cannot do
 *   x between b and c'  spherical_rectangle_sample_urena   small ones: a difference of sines
 *   by v                spherical_rectangle_sample_halves  neighbours: two triangles, one step in u
 *
 * A rectangle is sampled by the map of Ureña et al., whose neighbours stay neighbours, unless its
 * solid angle is below 2^20 epsilon (0.125 in float), where that map knows less than 6 digits; then
 * by its two halves. No cosine and no 1/pdf is included. A sphere: sphere_cone(s, p), sample_cone.
 *
 * Points, not directions: a unit vector of float knows a light of 1e-6 as two or three places only,
 * barycentrics know it to an epsilon of its size. Those of a triangle are computed as weights, from
 * what is small, and no angle is subtracted: it may be as small as its volume can be a real.
 *
 * Sources: J. Arvo, "Stratified Sampling of Spherical Triangles", SIGGRAPH 1995 (the map); C.
 * Peters, "BRDF Importance Sampling for Polygonal Lights", ACM TOG 40(4), 2021, section 3 (without
 * the angles at the corners); C. Ureña, M. Fajardo, A. King, "An Area-Preserving Parametrization
 * for Spherical Rectangles", Computer Graphics Forum 32(4), 2013.
 */
#ifndef RADIOMETRY_SPHERICAL_SAMPLING_H
#define RADIOMETRY_SPHERICAL_SAMPLING_H

#include "solid_angle.h"

/* Unit directions from p to the corners, their distances, a.(b x c) of the unit ones. */
typedef struct { vec3 a, b, c; real la, lb, lc, volume, omega; } spherical_triangle;
/* Names as in the paper: sides along x and y, plane z = z0, here its distance; c0^2 = 1 - b0^2. */
typedef struct { real x0, x1, y0, y1, z, b0, c0, f0, cos_k, sin_k; } urena_map;
typedef struct { spherical_triangle half[2]; urena_map map; real omega; } spherical_rectangle;

/* ---------------------------------------------------------------------------------------------- */

static inline vec3 rectangle_at(rectangle r, vec3 y)
{
    return vmadd(vmadd(r.o, r.s, y.x), r.t, y.y);
}

static inline spherical_triangle spherical_triangle_from(vec3 a, vec3 b, vec3 c, real volume,
                                                         real omega)
{
    spherical_triangle k = {vunit(a), vunit(b), vunit(c), vlength(a), vlength(b), vlength(c), 0,
                            fabs(omega)};
    k.volume = fabs(volume) / k.la / k.lb / k.lc;
    if (!(k.volume > 0)) k.omega = 0;  /* in its plane */
    return k;
}

static inline spherical_triangle spherical_triangle_of(triangle t, vec3 p)
{
    vec3 a = vsub(t.a, p), b = vsub(t.b, p), c = vsub(t.c, p);
    int e = needed_scale(real_max(vlength(a), real_max(vlength(b), vlength(c))));
    if (e) {
        t = (triangle){vscaled_by(t.a, e), vscaled_by(t.b, e), vscaled_by(t.c, e)};
        return spherical_triangle_of(t, vscaled_by(p, e));
    }
    return spherical_triangle_from(a, b, c, triangle_volume(t, p), triangle_solid_angle(t, p));
}

/* a b c' shall have the solid angle w = u omega. Let h be a multiple of a + c'. By (22.12)
 *     tan(w/2) = det(a, b, h) / (h.(a + b)),
 * and h = A a + B c gives B = sin(w/2) (1 + a.b), A = cos(w/2) det - sin(w/2) (a.c + b.c);
 * 1 + a.b is |a + b|^2 / 2, which keeps its digits where a and b are on opposite sides of p;
 *     c' = 2 (h.a) / (h.h) h - a                                                         (22.17)
 * Then 1 - cos of the angle between b and x is v times that between b and c': with q the quotient
 * of their sines, x = q c' + (cos - q b.c') b.                                           (22.18) */
static inline vec3 spherical_triangle_sample(const spherical_triangle *k, real u, real v)
{
    vec3 ab = vadd(k->a, k->b);
    real s = sin(u * k->omega / 2), B = s * vdot(ab, ab) / 2;
    real A = cos(u * k->omega / 2) * k->volume - s * vdot(ab, k->c);
    real scale = real_max(fabs(A), B);
    if (scale > 0) A /= scale, B /= scale;  /* their squares might vanish */
    else A = 1;
    vec3 h = vmadd(vscale(k->a, A), k->c, B);
    real twice = 2 * vdot(h, k->a) / vdot(h, h), ca = twice * A - 1, cc = twice * B;  /* c' */
    vec3 end = vmadd(vscale(k->a, ca), k->c, cc), apart = vsub(end, k->b), both = vadd(end, k->b);
    real away = vdot(apart, apart) / 2, near = 2 - away, bc = 1 - away;  /* 1 -+ b.c', b.c' */
    if (away > 1) near = vdot(both, both) / 2, bc = near - 1;
    real up = away > 1 ? 2 * (1 - v) + v * near : 2 - v * away;  /* 1 + cosine */
    real cosine = away > 1 ? up - 1 : 1 - v * away, q = near > 0 ? sqrt(v * up / near) : 0;
    real wa = real_max(q * ca, 0) / k->la, wc = real_max(q * cc, 0) / k->lc;
    real wb = real_max(cosine - q * bc, 0) / k->lb, sum = wa + wb + wc;
    if (!(sum > 0)) {  /* p on an edge, and c' opposite of b: take c' */
        wa = real_max(ca, 0) / k->la, wc = real_max(cc, 0) / k->lc, sum = wa + wc;
    }
    return (vec3){wa / sum, wb / sum, wc / sum};
}

/* ---- rectangle ---- */

/* Length of (a, z); small ones would vanish when squared. */
static inline real urena_length(real a, real z)
{
    real square = a * a + z * z;
    return square > real_smallest / real_epsilon ? sqrt(square) : hypot(a, z);
}

/* The planes through p and the sides y0, y1, x0 have unit normals whose z are b0, b1, n; those of
 * y1 and x0 meet at the angle g2, of x0 and y0 at g3, in lines from p to corners r1, r0 away:
 *     cos g2 = -b1 n, sin g2 = z r1 / (l2 l3);   cos g3 = -n b0, sin g3 = z r0 / (l0 l3);
 * of k = 2 pi - g2 - g3 the cosine and sine are enough. With h = b1 sin g3 + b0 sin g2 nothing has
 * to cancel: sin k = n h, f0 = cos k b0 - b1 = -sin g3 h.                                (22.25) */
static inline urena_map urena_map_of(rectangle r, vec3 p)
{
    real s = vlength(r.s), t = vlength(r.t);
    vec3 x = vscale(r.s, 1 / s), y = vscale(r.t, 1 / t), d = vsub(r.o, p);
    real x0 = vdot(d, x), y0 = vdot(d, y), y1 = y0 + t, z = fabs(vdot(d, vcross(x, y)));
    real l0 = urena_length(y0, z), l2 = urena_length(y1, z), l3 = urena_length(x0, z);
    real r0 = sqrt(x0 * x0 + y0 * y0 + z * z), r1 = sqrt(x0 * x0 + y1 * y1 + z * z);
    real b0 = -y0 / l0, c0 = z / l0, b1 = y1 / l2, n = -x0 / l3;
    real sin2 = z / l2 * (r1 / l3), sin3 = c0 * (r0 / l3), h = c0 / l2 / l3;
    if (y0 < 0 && y1 > 0) h *= y1 * r0 - y0 * r1;
    else h *= l3 * (l3 * (y1 - y0) * (y1 + y0) / (y1 * r0 + y0 * r1));
    return (urena_map){x0, x0 + s, y0, y1, z, b0, c0, -sin3 * h, b0 * b1 * n * n - sin2 * sin3,
                       n * h};
}

static inline spherical_rectangle spherical_rectangle_of(rectangle r, vec3 p)
{
    int e = needed_scale(rectangle_far(r, p));
    if (e) return spherical_rectangle_of(rectangle_scaled(r, e), vscaled_by(p, e));
    vec3 a = vsub(r.o, p), b = vadd(a, r.s), d = vadd(a, r.t), c = vadd(b, r.t);
    real volume = rectangle_volume(r, p), one, two;
    rectangle_solid_angles(r, p, &one, &two);
    spherical_rectangle k = {{spherical_triangle_from(a, b, d, volume, one),
                              spherical_triangle_from(c, d, b, volume, two)},
                             urena_map_of(r, p), 0};
    k.omega = k.half[0].omega + k.half[1].omega;
    return k;
}

/* The part u of the solid angle lies between x0 and xu:
 *     a = k + u omega,  f = cos a b0 - b1,  xu = z sin a sign(f) / sqrt(f^2 - (c0 sin a)^2) (22.26)
 * cos a and sin a as those of k, and small changes. A rectangle of 1e-5 in float: h1 - h0 below is
 * noise. */
static inline vec3 spherical_rectangle_sample_urena(const spherical_rectangle *r, real u, real v)
{
    const urena_map *m = &r->map;
    real half = sin(u * r->omega / 2), sine = 2 * half * cos(u * r->omega / 2);
    real less = 2 * half * half;  /* 1 - cosine */
    real sin_a = m->sin_k + (m->cos_k * sine - m->sin_k * less);
    real f = m->f0 - m->b0 * (m->cos_k * less + m->sin_k * sine), g = m->c0 * sin_a;
    real root = sqrt(real_max((f - g) * (f + g), real_smallest));
    real xu = real_clamp((f > 0 ? m->z : -m->z) * sin_a / root, m->x0, m->x1);
    real dd = xu * xu + m->z * m->z;
    real h0 = m->y0 / sqrt(dd + m->y0 * m->y0), h1 = m->y1 / sqrt(dd + m->y1 * m->y1);
    real h = h0 + v * (h1 - h0), yu = h * sqrt(dd / real_max((1 - h) * (1 + h), real_smallest));
    return (vec3){(xu - m->x0) / (m->x1 - m->x0),
                  real_clamp((yu - m->y0) / (m->y1 - m->y0), 0, 1), 0};
}

static inline vec3 spherical_rectangle_sample_halves(const spherical_rectangle *k, real u, real v)
{
    real share = k->half[0].omega / k->omega;
    int second = !(u < share);
    u = second ? (u - share) / (1 - share) : u / share;
    vec3 b = spherical_triangle_sample(&k->half[second], real_clamp(u, 0, 1), v);
    return second ? (vec3){1 - b.y, 1 - b.z, 0} : (vec3){b.y, b.z, 0};
}

static inline vec3 spherical_rectangle_sample(const spherical_rectangle *k, real u, real v)
{
    return k->omega > (real)0x1p20 * real_epsilon ? spherical_rectangle_sample_urena(k, u, v)
                                             : spherical_rectangle_sample_halves(k, u, v);
}

#endif
