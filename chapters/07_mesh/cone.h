/* cone.h: the side of a cone (圆锥) or a cylinder (圆柱), with open ends: one shape for both.
 *
 *          rb                     w = b - a, h = |w|
 *        .--b--.   u = 1          a point p of the side, with q = p - a and u = q.w / w.w, is at
 *       /   |   \                 this distance from the axis:
 *      /    w    \                    |q x w| / h = |ra + (rb - ra) u|,  0 <= u <= 1         (7.5)
 *     '-----a-----'  u = 0
 *           ra                    rb = ra: cylinder; rb = 0: pointed cone; else: truncated cone
 *
 *   cone c = {a, ra, b, rb};
 *   bool cone_hit(c, r, &h)       first hit of the ray; h.u = u, h.v = 0
 *   bool cone_hit_naive(c, r, &h) the textbook: fails at a distance and beside the axis
 *   vec3 cone_normal(c, p)        unit normal at a point p of the side, pointing from the axis;
 *                                 at the tip of a cone: along the axis, away from the cone
 *   vec3 cone_point(c, p)         p moved at right angles to the axis on to the side
 *
 * Both ends are closed: u = 0 and u = 1 belong to the side. Two cones that share an end are not
 * watertight there. A ray that runs in the side hits nothing or either end; one that runs parallel
 * to the axis of a cylinder misses it. Radii of unlike sign: two cones tip to tip; else the signs
 * make no difference. Always a miss: a = b, both radii 0, D = 0, NaN or infinity anywhere.
 * Any size, distance and length of D will do, if o and t can be written as reals in units of the
 * cone's own size. Needs -ffp-contract=off: a contracted product would be given back wrongly.
 *
 * Sources: E. Haines, J. Günther, T. Akenine-Möller, "Precision Improvements for Ray/Sphere
 * Intersection", Ray Tracing Gems, 2019, ch. 7 (the discriminant from near the shape, here by
 * Lagrange's identity for a cone); T. Dekker, Numer. Math. 18, 1971 (exact sums and products).
 */
#ifndef CONE_H
#define CONE_H

#include "../01_ray/hit.h"

typedef struct {
    vec3 a;   /* middle of the base, u = 0 */
    real ra;  /* its radius */
    vec3 b;   /* middle of the top, u = 1 */
    real rb;  /* its radius */
} cone;

/* ---------------------------------------------------------------------------------------------- */

/* What rounding took from s = a + b: exactly a + b - s (Knuth). */
static inline real cone_lost(real a, real b, real s)
{
    real bb = s - a;
    return (a - (s - bb)) + (b - bb);
}

/* (o - a) + t d, rounded as if computed with twice the digits: a point of the ray near a, however
 * far o is. */
static inline real cone_near(real o, real a, real t, real d)
{
    real f = o - a, p = t * d, q = f + p;
    return q + (cone_lost(o, -a, f) + fma(t, d, -p) + cone_lost(f, p, q));
}

/* The first of two roots t[0..1] in the interval whose height z[0..1] along the axis is within
 * 0..top. */
static inline bool cone_first(ray r, const real t[2], const real z[2], real top, hit *out)
{
    for (int k = 0; k < 2; k++)
        if (z[k] >= 0 && z[k] <= top && ray_covers(r, t[k])) {
            *out = (hit){t[k], z[k] / top, 0, 0};
            return true;
        }
    return false;
}

/* (7.5) squared, with p = o + t d and the unit axis n: alpha t^2 + 2 beta t + gamma = 0, solved
 * as it stands. Fails: a radius of 1 seen from 1e4 in float (b^2 and a c agree in all their
 * digits), from 1e8 in double; d parallel to the axis or to the side, where alpha is nearly 0 and
 * both roots are lost. */
static inline bool cone_hit_naive(cone c, ray r, hit *out)
{
    vec3 w = vsub(c.b, c.a), n = vunit(w), q = vsub(r.o, c.a);
    real h = vlength(w), m = (c.rb - c.ra) / h, z = vdot(q, n), g = vdot(r.d, n), rz = c.ra + m * z;
    real alpha = vdot(r.d, r.d) - (1 + m * m) * g * g;
    real beta = vdot(r.d, q) - g * z - m * g * rz;
    real gamma = vdot(q, q) - z * z - rz * rz;
    real s = sqrt(beta * beta - alpha * gamma);  /* NaN: no root, and NaN is never in an interval */
    real t0 = (-beta - s) / alpha, t1 = (-beta + s) / alpha;
    real t[2] = {real_min(t0, t1), real_max(t0, t1)};
    return cone_first(r, t, (real[2]){z + t[0] * g, z + t[1] * g}, h, out);
}

/* The t of the ray's point that is nearest to the axis between the planes of the two ends. Any t
 * near it would do as well: it only moves the origin. */
static inline real cone_nearest(vec3 q, vec3 d, vec3 w, vec3 C)
{
    real g = vdot(d, w), z = vdot(q, w), t = -vdot(C, vcross(q, w)) / vdot(C, C);
    if (g == 0) return t;  /* the ray stays in its plane across the axis */
    real t0 = -z / g, t1 = (vdot(w, w) - z) / g;
    return real_clamp(t, real_min(t0, t1), real_max(t0, t1));  /* NaN (d along w): the first end */
}

/* Step 1: move the origin to a point q of the ray near the cone; nothing is lost on the way. Step
 * 2: with C = d x w, E = q x w, radius R = h ra + m q.w and its change G = m d.w along the ray,
 *         m = (rb - ra) / h (all four are h times their size, which saves rounding a unit axis):
 *             |E + t C|^2 = (R + t G)^2                                       (7.6)
 *             alpha t^2 + 2 beta t + gamma = 0,
 *             alpha = C.C - G^2, beta = C.E - G R, gamma = E.E - R^2
 * Step 3: the discriminant without cancellation, by Lagrange's identity:
 *             beta^2 - alpha gamma = |R C - G E|^2 - |C x E|^2 = (S - T)(S + T)  (7.7)
 *         C x E is parallel to w, so T = |w.(C x E)| / h. The ray hits if T <= S.
 * Step 4: the two roots, neither by subtracting. */
static inline bool cone_hit_moderate(cone c, ray r, hit *out)
{
    vec3 w = vsub(c.b, c.a), d = r.d, C = vcross(d, w);
    real near = cone_nearest(vsub(r.o, c.a), d, w, C);
    vec3 q = {cone_near(r.o.x, c.a.x, near, d.x), cone_near(r.o.y, c.a.y, near, d.y),
              cone_near(r.o.z, c.a.z, near, d.z)};

    vec3 E = vcross(q, w);
    real h = vlength(w), hh = vdot(w, w), m = (c.rb - c.ra) / h, z = vdot(q, w), g = vdot(d, w);
    real R = h * c.ra + m * z, G = m * g;
    real S = vlength(vsub(vscale(C, R), vscale(E, G))),
         T = fabs(vdot(vscale(w, 1 / h), vcross(C, E)));
    if (!(S >= T) || (c.ra == 0 && c.rb == 0)) return false;  /* written so that a NaN is a miss */

    real alpha = vdot(C, C) - G * G, beta = vdot(C, E) - G * R, gamma = vdot(E, E) - R * R;
    real far = -(beta + copysign(sqrt((S - T) * (S + T)), beta));
    real t0 = far / alpha, t1 = gamma / far;  /* 1/0 and 0/0 are in no interval: no hit there */
    if (t0 > t1) { real swap = t0; t0 = t1; t1 = swap; }
    return cone_first(r, (real[2]){near + t0, near + t1}, (real[2]){z + t0 * g, z + t1 * g}, hh,
                      out);
}

/* Sizes whose products could over- or underflow: the same problem in units of the cone and of d,
 * powers of two, so that nothing is rounded. Rare, so it may be slow. */
static inline bool cone_hit_extreme(cone c, ray r, hit *out)
{
    vec3 w = vsub(c.b, c.a), radii = {c.ra, c.rb, 0};
    int e, f;
    if (!vfinite(w) || !vfinite(radii) || !vfinite(r.d) || !vfinite(r.o)) return false;
    (void)vscaled(vmax(vmax(w, vneg(w)), vmax(radii, vneg(radii))), &e);
    r.d = vscaled(r.d, &f);
    real k = ldexp((real)1, -e);
    c = (cone){vscale(c.a, k), c.ra * k, vscale(c.b, k), c.rb * k};
    r = (ray){vscale(r.o, k), ldexp(r.tmin, f - e), r.d, ldexp(r.tmax, f - e)};
    if (!cone_hit_moderate(c, r, out)) return false;
    out->t = ldexp(out->t, e - f);
    return true;
}

static inline bool cone_hit(cone c, ray r, hit *out)
{
    vec3 w = vsub(c.b, c.a);
    real size = vdot(w, w) + c.ra * c.ra + c.rb * c.rb;
    if (!square_is_safe(size * size * size * vdot(r.d, r.d))) return cone_hit_extreme(c, r, out);
    return cone_hit_moderate(c, r, out);
}

/* At right angles to the axis, from it to p: h^2 times the vector. */
static inline vec3 cone_outward(vec3 q, vec3 w) { return vcross(w, vcross(q, w)); }

static inline vec3 cone_normal(cone c, vec3 p)
{
    vec3 w = vsub(c.b, c.a), q = vsub(p, c.a);
    real hh = vdot(w, w), k = (c.rb - c.ra) / hh, radius = c.ra + k * vdot(q, w);
    return vunit(vmadd(vunit(cone_outward(q, w)), w, radius < 0 ? k : -k));
}

static inline vec3 cone_point(cone c, vec3 p)
{
    vec3 w = vsub(c.b, c.a), q = vsub(p, c.a);
    real u = vdot(q, w) / vdot(w, w), radius = fabs(c.ra + (c.rb - c.ra) * u);
    return vadd(c.a, vmadd(vscale(w, u), vunit(cone_outward(q, w)), radius));
}

#endif
