/* 07_oracle.h: the hits of cone.h and polygon.h with 32 digits, to measure errors against.
 *
 *   cone_truth x = cone_exact(c, r);      x.hit, x.t: first hit of the side in the interval
 *   polygon_truth y = polygon_exact(p, r);
 *
 * Both also tell how close the call was, in `margin`: 0 on the border between hit and miss. Every
 * real is a wide without error, so the answers are right for the very numbers that the tested
 * code was given.
 */
#ifndef TESTS_07_ORACLE_H
#define TESTS_07_ORACLE_H

#include "../common/numbers/wide.h"
#include "../chapters/07_mesh/cone.h"
#include "../chapters/07_mesh/polygon.h"

typedef struct {
    bool hit;
    double t;       /* of the first hit in the ray's interval */
    double apart;   /* |t1 - t0|: how far the other root is */
    double margin;  /* the smaller of (S^2 - T^2) / S^2, (7.7), and how near u came to an end */
} cone_truth;

typedef struct {
    bool hit;
    double t;       /* of the plane; meaningless without a hit */
    double margin;  /* from the ray to the nearest edge, seen along the ray [scene units] */
} polygon_truth;

/* ---------------------------------------------------------------------------------------------- */

static inline wide wide_square(wide a) { return wide_mul(a, a); }

/* (7.6) times w.w, which needs no square root, from the ray's own origin: 32 digits stand it. */
static inline cone_truth cone_exact(cone c, ray r)
{
    wide3 a = wide3_of(c.a), w = wide3_sub(wide3_of(c.b), a), d = wide3_of(r.d),
          q = wide3_sub(wide3_of(r.o), a);
    wide ra = wide_of((double)c.ra), k = wide_sub(wide_of((double)c.rb), ra), hh = wide3_dot(w, w);
    wide3 C = wide3_cross(d, w), E = wide3_cross(q, w);
    wide z = wide3_dot(q, w), g = wide3_dot(d, w);
    wide R = wide_add(wide_mul(hh, ra), wide_mul(k, z)), G = wide_mul(k, g);
    wide alpha = wide_sub(wide_mul(hh, wide3_dot(C, C)), wide_square(G));
    wide beta = wide_sub(wide_mul(hh, wide3_dot(C, E)), wide_mul(G, R));
    wide gamma = wide_sub(wide_mul(hh, wide3_dot(E, E)), wide_square(R));
    wide root = wide_sub(wide_square(beta), wide_mul(alpha, gamma));
    wide3 CE = wide3_cross(C, E);
    double TT = wide_value(wide_mul(wide_square(hh), wide3_dot(CE, CE)));
    double graze = wide_value(root) / (wide_value(root) + TT);
    cone_truth truth = {false, 0, 0, fabs(graze)};
    if (wide_sign(root) < 0 || !(graze == graze)) return truth;
    root = wide_sqrt(root);
    wide far = wide_neg(wide_sign(beta) < 0 ? wide_sub(beta, root) : wide_add(beta, root));
    wide t[2] = {wide_div(gamma, far), wide_div(far, alpha)};
    truth.apart = fabs(wide_value(wide_sub(t[1], t[0])));
    for (int i = 0; i < 2; i++) {
        double u = wide_value(wide_div(wide_add(z, wide_mul(t[i], g)), hh)), at = wide_value(t[i]);
        double end = fabs(u) < fabs(u - 1) ? fabs(u) : fabs(u - 1);
        if (end * sqrt(fabs(graze)) < truth.margin) truth.margin = end * sqrt(fabs(graze));
        if (u >= 0 && u <= 1 && at >= (double)r.tmin && at <= (double)r.tmax
            && (!truth.hit || at < truth.t))
            truth.hit = true, truth.t = at;
    }
    return truth;
}

/* How far the point at t is from the side, measured across the axis. */
static inline double cone_residual(cone c, ray r, real t)
{
    wide3 a = wide3_of(c.a), w = wide3_sub(wide3_of(c.b), a);
    wide3 q = wide3_sub(wide3_madd(wide3_of(r.o), wide3_of(r.d), wide_of((double)t)), a);
    wide hh = wide3_dot(w, w), u = wide_div(wide3_dot(q, w), hh), ra = wide_of((double)c.ra);
    wide radius = wide_add(ra, wide_mul(wide_sub(wide_of((double)c.rb), ra), u));
    wide distance = wide_div(wide3_length(wide3_cross(q, w)), wide_sqrt(hh));
    if (wide_sign(radius) < 0) radius = wide_neg(radius);
    return fabs(wide_value(wide_sub(distance, radius)));
}

static inline wide3 wide3_cross_sum(wide3 a, wide3 b, wide3 c)
{
    wide3 x = wide3_cross(b, c);
    return (wide3){wide_add(a.x, x.x), wide_add(a.y, x.y), wide_add(a.z, x.z)};
}

/* Distance of the origin from segment a b of the picture, to a few digits. */
static inline double segment_distance(double ax, double ay, double bx, double by)
{
    double dx = bx - ax, dy = by - ay, s = -(ax * dx + ay * dy) / (dx * dx + dy * dy);
    s = s > 0 ? (s < 1 ? s : 1) : 0;
    return sqrt((ax + s * dx) * (ax + s * dx) + (ay + s * dy) * (ay + s * dy));
}

/* The picture along the ray in wide numbers: e1 and e2 are at right angles to d, not unit. */
static inline polygon_truth polygon_exact(polygon p, ray r)
{
    wide3 d = wide3_of(r.d), o = wide3_of(r.o), v0 = wide3_of(p.v[0]);
    wide3 n = {{0, 0}, {0, 0}, {0, 0}}, mean = n;
    wide3 axis = wide3_of(vlongest(r.d) == 0 ? (vec3){0, 1, 0} : (vec3){1, 0, 0});
    wide3 e1 = wide3_cross(d, axis), e2 = wide3_cross(d, e1);
    double size1 = wide_value(wide3_length(e1)), size2 = wide_value(wide3_length(e2));
    polygon_truth truth = {false, 0, HUGE_VAL};
    for (uint32_t i = 0; i < p.n; i++) {
        wide3 a = wide3_sub(wide3_of(p.v[i]), o), b = wide3_sub(wide3_of(p.v[(i + 1) % p.n]), o);
        wide ax = wide3_dot(a, e1), ay = wide3_dot(a, e2);
        wide bx = wide3_dot(b, e1), by = wide3_dot(b, e2);
        bool up = wide_sign(by) > 0;
        wide e = wide_sub(wide_mul(ax, by), wide_mul(ay, bx));
        if ((wide_sign(ay) > 0) != up && (up ? wide_sign(e) > 0 : wide_sign(e) < 0))
            truth.hit = !truth.hit;
        double near = segment_distance(wide_value(ax) / size1, wide_value(ay) / size2,
                                       wide_value(bx) / size1, wide_value(by) / size2);
        if (near < truth.margin) truth.margin = near;
        n = wide3_cross_sum(n, wide3_sub(wide3_of(p.v[i]), v0),
                            wide3_sub(wide3_of(p.v[(i + 1) % p.n]), v0));
        mean = wide3_madd(mean, a, wide_div(wide_of(1), wide_of(p.n)));
    }
    truth.t = wide_value(wide_div(wide3_dot(n, mean), wide3_dot(n, d)));
    truth.hit = truth.hit && truth.t >= (double)r.tmin && truth.t <= (double)r.tmax;
    return truth;
}

#endif
