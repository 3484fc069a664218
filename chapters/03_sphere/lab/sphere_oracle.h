/* sphere_oracle.h: rays aimed at a sphere, near its limb (边缘) if wanted, and the truth.
 *
 *   sphere_aim(&s, R, far, pass, moved, &ball)   a ray from about far R away, past the centre at
 *                                                about pass R; the centre random if moved, else 0
 *   sphere_clearance(ball, r)                    how far the line passes from the centre, over R,
 *                                                minus 1: a hit is due where it is <= 0
 *   sphere_pass(ball, r)                         how far the line passes from the centre
 *
 * Computed in wide numbers from the textbook's b^2 - 4ac (3.3), which sphere.h does not use: off by
 * some 1e-31 (l/R)^2 at the distance l, which is 1e-19 for l = 1e6 R.
 */
#ifndef SPHERE_ORACLE_H
#define SPHERE_ORACLE_H

#include "../../../common/random.h"
#include "../sphere.h"

/* ---------------------------------------------------------------------------------------------- */

static inline ray sphere_aim(random_stream *s, real R, real far, real pass, bool moved,
                             sphere *ball)
{
    real v[7];
    for (int k = 0; k < 7; k++) v[k] = 2 * random_next(s) - 1;
    vec3 u = vunit((vec3){v[0], v[1], v[2]}), x, y, c = {0, 0, 0};
    if (moved) c = vscale((vec3){v[3], v[4], v[5]}, far * R);
    vbasis(u, &x, &y);
    vec3 side = vadd(vscale(x, cos(pi * v[6])), vscale(y, sin(pi * v[6])));
    vec3 o = vmadd(c, u, far * R), to = vmadd(c, side, pass * R);
    *ball = (sphere){c, R};
    return ray_from(o, vscale(vsub(to, o), 1 + random_next(s) / 2));  /* no unit length */
}

/* a, half of b, and c of (3.2); D = (b/2)^2 - a c. */
typedef struct { wide a, b, c, rr, D; } sphere_quadratic;

static inline sphere_quadratic sphere_exactly(sphere ball, ray r)
{
    wide3 d = wide3_of(r.d), f = wide3_sub(wide3_of(r.o), wide3_of(ball.c));
    sphere_quadratic q = {.a = wide3_dot(d, d), .b = wide3_dot(d, f)};
    q.rr = wide_product((double)ball.r, (double)ball.r);
    q.c = wide_sub(wide3_dot(f, f), q.rr);
    q.D = wide_sub(wide_mul(q.b, q.b), wide_mul(q.a, q.c));
    return q;
}

/* (pass / R)^2 - 1 = -D / (a R^2) */
static inline double sphere_clearance(sphere ball, ray r)
{
    sphere_quadratic q = sphere_exactly(ball, r);
    double square = -wide_value(wide_div(q.D, wide_mul(q.a, q.rr)));
    double pass = square > -1 ? sqrt(1 + square) : 0;  /* -1 - 1e-13 through c, seen from 1e9 R */
    return square / (1 + pass);
}

static inline double sphere_pass(sphere ball, ray r)
{
    ball.r = 0;  /* then -D / a is the distance, squared */
    sphere_quadratic q = sphere_exactly(ball, r);
    return wide_value(wide_sqrt(wide_div(wide_neg(q.D), q.a)));
}

#endif
