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
 *   vec3 cone_normal(c, p)        unit normal at a point p of the side, pointing from the axis;
 *                                 at the tip of a cone: along the axis, away from the cone
 *   vec3 cone_point(c, p)         p moved at right angles to the axis on to the side
 *
 * Both ends are closed: u = 0 and u = 1 belong to the side. Two cones that share an end are not
 * watertight there. A ray that runs in the side hits nothing or any point of it; one that runs
 * parallel to the axis of a cylinder misses it. A tangent ray hits; where rounding could blur that,
 * up to 1/100 of |ra| + |rb| from a tip, twice the digits decide. Radii of unlike sign: two cones;
 * else the signs make no difference. Always a miss: a = b, both radii 0, D = 0, NaN or infinity.
 * Any size, distance and length of D will do, if o and t can be written as reals in units of the
 * cone's own size. The point o + t d of a hit is always near the side, ends included:
 *
 *          8 epsilon (L + |t d|),   L = h + |ra| + |rb|                                   (7.14)
 *
 * Needs -ffp-contract=off: a contracted product would be given back wrongly.
 *
 * Sources: E. Haines, J. Günther, T. Akenine-Möller, "Precision Improvements for Ray/Sphere
 * Intersection", Ray Tracing Gems, 2019, ch. 7 (the discriminant from near the shape, here by
 * Lagrange's identity for a cone); T. Dekker, Numer. Math. 18, 1971 (exact sums and products).
 */
#ifndef MESH_CONE_H
#define MESH_CONE_H

#include "../01_ray/hit.h"
#include "../../common/numbers/sum.h"
#include "../../common/numbers/wide.h"

typedef struct {
    vec3 a;   /* middle of the base, u = 0 */
    real ra;  /* its radius */
    vec3 b;   /* middle of the top, u = 1 */
    real rb;  /* its radius */
} cone;

/* ---------------------------------------------------------------------------------------------- */

/* (o - a) + t d, rounded as if computed with twice the digits: a point of the ray near a, however
 * far o is. */
static inline real cone_near(real o, real a, real t, real d)
{
    real f = o - a, p = t * d, q = f + p;
    return q + (sum_error(o, -a, f) + fma(t, d, -p) + sum_error(f, p, q));
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

/* The t of the ray's point that is nearest to the axis between the planes of the two ends. Any t
 * near it would do as well: it only moves the origin. */
static inline real cone_nearest(vec3 q, vec3 d, vec3 w, vec3 C)
{
    real g = vdot(d, w), z = vdot(q, w), t = -vdot(C, vcross(q, w)) / vdot(C, C);
    if (g == 0) return t;  /* the ray stays in its plane across the axis */
    real t0 = -z / g, t1 = (vdot(w, w) - z) / g;
    return real_clamp(t, real_min(t0, t1), real_max(t0, t1));  /* NaN (d along w): the first end */
}

/* The same problem in units of the cone and of d, powers of two, so that nothing is rounded. t of
 * the result times 2^*exponent is t. False if something is infinite or NaN, or d = 0. */
static inline bool cone_in_units(cone *c, ray *r, int *exponent)
{
    vec3 w = vsub(c->b, c->a), radii = {c->ra, c->rb, 0};
    int e, f;
    if (!vfinite(w) || !vfinite(radii) || !vfinite(r->d) || !vfinite(r->o)) return false;
    (void)vscaled(vmax(vabs(w), vabs(radii)), &e);
    r->d = vscaled(r->d, &f);
    real k = ldexp((real)1, -e);
    *c = (cone){vscale(c->a, k), c->ra * k, vscale(c->b, k), c->rb * k};
    *r = (ray){vscale(r->o, k), ldexp(r->tmin, f - e), r->d, ldexp(r->tmax, f - e)};
    *exponent = e - f;
    return !vzero(r->d);
}

/* How far |E + t C| and |R + t G| may be apart at a hit: 4 epsilon L of distance from the side. */
static inline real cone_off(real h, cone c)
{
    real L = h + fabs(c.ra) + fabs(c.rb);
    return 4 * real_epsilon * L * (h + fabs(c.rb - c.ra));
}

/* Steps 1 to 4 below in wide numbers, everything times h once more, so that no root of w.w is
 * needed. Once the discriminant is nothing but rounding, 1e-29 of its parts, the ray is tangent:
 * one root, -beta / alpha. Each root must prove that it is on the side. */
__attribute__((noinline, cold))
static bool cone_hit_in_doubt(cone c, ray r, hit *out)
{
    int exponent;
    if (!cone_in_units(&c, &r, &exponent) || (c.ra == 0 && c.rb == 0)) return false;
    vec3 rough = vsub(c.b, c.a);
    real near = cone_nearest(vsub(r.o, c.a), r.d, rough, vcross(r.d, rough));
    wide3 a = wide3_of(c.a), d = wide3_of(r.d), w = wide3_sub(wide3_of(c.b), a),
          q = wide3_madd(wide3_sub(wide3_of(r.o), a), d, wide_of((double)near));
    wide ra = wide_of((double)c.ra), k = wide_sub(wide_of((double)c.rb), ra), hh = wide3_dot(w, w);
    wide3 C = wide3_cross(d, w), E = wide3_cross(q, w);
    wide z = wide3_dot(q, w), g = wide3_dot(d, w);
    wide R = wide_add(wide_mul(hh, ra), wide_mul(k, z)), G = wide_mul(k, g);
    wide alpha = wide_sub(wide_mul(hh, wide3_dot(C, C)), wide_mul(G, G));
    wide beta = wide_sub(wide_mul(hh, wide3_dot(C, E)), wide_mul(G, R));
    wide gamma = wide_sub(wide_mul(hh, wide3_dot(E, E)), wide_mul(R, R));

    wide D = wide_sub(wide_mul(beta, beta), wide_mul(alpha, gamma));
    double hh_CC = wide_value(wide_mul(hh, wide3_dot(C, C))), G0 = wide_value(G),
           hh_EE = wide_value(wide_mul(hh, wide3_dot(E, E))), R0 = wide_value(R);
    double noise = 1e-29 * (hh_CC + G0 * G0) * (hh_EE + R0 * R0);
    if (!(wide_value(D) >= -noise)) return false;
    wide root = wide_value(D) <= noise ? wide_of(0) : wide_sqrt(D);
    wide far = wide_neg(wide_sign(beta) < 0 ? wide_sub(beta, root) : wide_add(beta, root));
    wide t[2] = {wide_div(far, alpha), wide_div(gamma, far)};
    if (wide_sign(root) == 0) t[1] = t[0];
    if (wide_value(wide_sub(t[0], t[1])) > 0) { wide swap = t[0]; t[0] = t[1]; t[1] = swap; }

    real h = vlength(rough);
    double off = (double)(h * cone_off(h, c));
    for (int i = 0; i < 2; i++) {
        wide3 e = wide3_madd(E, C, t[i]);
        double ee = wide_value(wide_mul(hh, wide3_dot(e, e))),
               rho = fabs(wide_value(wide_add(R, wide_mul(t[i], G))));
        if (!(fabs(ee - rho * rho) <= off * (off + rho))) continue;
        double size = wide_value(hh), up = wide_value(wide_add(z, wide_mul(t[i], g)));
        double over = wide_value(wide_sub(wide_add(z, wide_mul(t[i], g)), hh));
        if (!(up >= -1e-29 * size && over <= 1e-29 * size)) continue;
        real at = (real)wide_value(wide_add(wide_of((double)near), t[i]));
        if (!ray_covers(r, at)) continue;
        *out = (hit){ldexp(at, exponent), real_clamp((real)(up / size), 0, 1), 0, 0};
        return true;
    }
    return false;
}

/* Is root t on the side, within rounding, or its height z clearly none of the cone's? */
static inline bool cone_proves(real t, real z, real hh, vec3 E, vec3 C, real R, real G, real off)
{
    vec3 e = vmadd(E, C, t);
    real rho = R + t * G;
    return fabs(vdot(e, e) - rho * rho) <= off * (off + fabs(rho)) || fabs(z - hh / 2) > hh;
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
 * Step 4: the two roots, neither by subtracting.
 * Rounding moves E and R by some epsilon h L, so S - T by that times |C| and |G|. If it may be
 * nothing else, the ray nearly touches, gamma / far of step 4 may be nothing else either, and
 * wide numbers decide. So they do along a side, where alpha cancels, if a root is off it. */
static inline bool cone_hit_moderate(cone c, ray r, hit *out)
{
    vec3 w = vsub(c.b, c.a), d = r.d, C = vcross(d, w);
    real near = cone_nearest(vsub(r.o, c.a), d, w, C);
    vec3 q = {cone_near(r.o.x, c.a.x, near, d.x), cone_near(r.o.y, c.a.y, near, d.y),
              cone_near(r.o.z, c.a.z, near, d.z)};

    vec3 E = vcross(q, w);
    real hh = vdot(w, w), EE = vdot(E, E), rough = 32 * real_epsilon * near;
    if (EE > 2 * hh * (hh + c.ra * c.ra + c.rb * c.rb + rough * rough * vdot(d, d)))
        return false;  /* not near at all: between the ends, the ray is far away */
    real h = sqrt(hh), m = (c.rb - c.ra) / h, z = vdot(q, w), g = vdot(d, w);
    real R = h * c.ra + m * z, G = m * g;
    real S = vlength(vsub(vscale(C, R), vscale(E, G))),
         T = fabs(vdot(vscale(w, 1 / h), vcross(C, E))), gap = S - T;
    real rr = fabs(c.ra) + fabs(c.rb);
    if (!(fabs(gap) * rr > 64 * real_epsilon * (S + T) * (h + rr)))  /* a NaN comes here too */
        return cone_hit_in_doubt(c, r, out);
    if (gap < 0) return false;

    real alpha = vdot(C, C) - G * G, beta = vdot(C, E) - G * R, gamma = EE - R * R;
    real far = -(beta + copysign(sqrt(gap * (S + T)), beta));
    real t0 = far / alpha, t1 = gamma / far;  /* 1/0 and 0/0 are in no interval: no hit there */
    if (!(fabs(alpha) > G * G / 16)) {
        real off = cone_off(h, c);
        if (!cone_proves(t0, z + t0 * g, hh, E, C, R, G, off)
            || !cone_proves(t1, z + t1 * g, hh, E, C, R, G, off))
            return cone_hit_in_doubt(c, r, out);
    }
    if (t0 > t1) { real swap = t0; t0 = t1; t1 = swap; }
    return cone_first(r, (real[2]){near + t0, near + t1}, (real[2]){z + t0 * g, z + t1 * g}, hh,
                      out);
}

/* Sizes whose products could over- or underflow. Rare, so it may be slow. */
__attribute__((noinline, cold))
static bool cone_hit_extreme(cone c, ray r, hit *out)
{
    int exponent;
    if (!cone_in_units(&c, &r, &exponent) || !cone_hit_moderate(c, r, out)) return false;
    out->t = ldexp(out->t, exponent);
    return true;
}

static inline bool cone_hit(cone c, ray r, hit *out)
{
    vec3 w = vsub(c.b, c.a);
    real size = vdot(w, w) + c.ra * c.ra + c.rb * c.rb;
    if (!square_is_safe(size * size * size * vdot(r.d, r.d)) || !square_is_safe(size * size))
        return cone_hit_extreme(c, r, out);
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
