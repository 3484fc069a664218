/* surfaces.h: four surfaces given by a formula, each with its gradient, f and f' in jets, a
 * Lipschitz bound in its ball.
 *
 *   implicit_sphere(&R)      |p|^2 - R^2                                    03 has a closed form
 *   implicit_torus(&k)       (|p|^2 + R^2 - r^2)^2 - 4 R^2 (x^2 + y^2)      (环面), around z; R > r
 *   implicit_gyroid(&ball)   sin x cos y + sin y cos z + sin z cos x        (螺旋二十四面体), cut
 *                            by that ball
 *   implicit_barth(&radius)  (1 + 2 g)(|p|^2 - 1)^2 - 4 (a x^2 - y^2)(a y^2 - z^2)(a z^2 - x^2),
 *                            a = g^2, g the golden ratio (黄金比): Barth's sextic, cut by a ball of
 *                            that radius around 0: 65 double points (二重点), as many as a surface
 *                            of the sixth degree can have; 30 at the distance 1, 20 at sqrt(3), 15
 *                            at infinity
 *
 * The surfaces keep a pointer to what is given: it must live as long as they do.
 *
 * The Lipschitz bounds are bounds of |grad f| in the ball of radius B around 0: 2 B; for the torus
 * |4 u p - 8 R^2 (x, y, 0)| <= 4 B (B^2 + R^2 - r^2) + 8 R^2 B at most; for the gyroid sqrt(3),
 * from (a cos x + b sin x)^2 <= a^2 + b^2, three times; for Barth's three factors, each <= a B^2
 * with a gradient <= 2 a B, 24 a^3 B^5, and 4 (1 + 2 g) B max(1, B^2 - 1) for the rest.
 *
 * The torus's range is `flatten`: with all that it calls inlined it takes a sixth less time from
 * plain -O2. With -march=native, and for the other ranges, it takes the same, and twice the code.
 *
 * Sources: W. Barth, "Two projective surfaces with many nodes, admitting the symmetries of the
 * icosahedron", J. Algebraic Geometry 5, 1996; A. Schoen, "Infinite periodic minimal surfaces
 * without self-intersections", NASA TN D-5541, 1970 (the formula is the usual approximation).
 */
#ifndef IMPLICIT_SURFACES_H
#define IMPLICIT_SURFACES_H

#include "../surface.h"

typedef struct { real R, r; } implicit_ring;
#define implicit_golden 1.61803398874989484820

/* ---------------------------------------------------------------------------------------------- */

static real implicit_sphere_f(const void *data, vec3 p)
{
    real R = *(const real *)data;
    return vdot(p, p) - R * R;
}
static vec3 implicit_sphere_gradient(const void *data, vec3 p) { return (void)data, vscale(p, 2); }

static inline jet implicit_square_sum(jet x, jet y, jet z)
{
    return jet_add(jet_add(jet_square(x), jet_square(y)), jet_square(z));
}

static jet implicit_sphere_range(const void *data, jet x, jet y, jet z)
{
    interval R = interval_at((double)*(const real *)data);
    jet square = {interval_square(R), interval_at(0)};
    return jet_sub(implicit_square_sum(x, y, z), square);
}

/* A ball a little larger, so that it cuts nothing. */
static inline implicit_surface implicit_sphere(const real *R)
{
    sphere ball = {{0, 0, 0}, fabs(*R) * (real)1.25};
    return (implicit_surface){implicit_sphere_f, implicit_sphere_gradient, implicit_sphere_range,
                              2 * ball.r, ball, R};
}

static real implicit_torus_f(const void *data, vec3 p)
{
    const implicit_ring *k = data;
    real flat = p.x * p.x + p.y * p.y, u = flat + p.z * p.z + (k->R * k->R - k->r * k->r);
    return u * u - 4 * k->R * k->R * flat;
}

static vec3 implicit_torus_gradient(const void *data, vec3 p)
{
    const implicit_ring *k = data;
    real u = vdot(p, p) + (k->R * k->R - k->r * k->r), v = 8 * k->R * k->R;
    return vsub(vscale(p, 4 * u), vec(v * p.x, v * p.y, 0));
}

/* As it is written the square and what is taken from it are large, and nearly cancel at the tube.
 * The same f as a product, u^2 - w^2 = (u - w)(u + w) with w = 2 R sqrt(x^2 + y^2), does not lose
 * digits there; u - w = (sqrt(x^2 + y^2) - R)^2 + z^2 - r^2. */
__attribute__((flatten)) static jet implicit_torus_range(const void *data, jet x, jet y, jet z)
{
    const implicit_ring *k = data;
    jet flat = jet_length(x, y, (jet){interval_at(0), interval_at(0)});
    double R = (double)k->R;
    interval rr = interval_square(interval_at((double)k->r));
    jet zz = jet_sub(jet_square(z), (jet){rr, interval_at(0)});
    jet near = jet_add(jet_square(jet_shift(flat, -R)), zz);
    jet far = jet_add(jet_square(jet_shift(flat, R)), zz);
    return jet_mul(near, far);
}

static inline implicit_surface implicit_torus(const implicit_ring *k)
{
    sphere ball = {{0, 0, 0}, (k->R + k->r) * (real)1.25};
    real B = ball.r, RR = k->R * k->R;
    return (implicit_surface){implicit_torus_f, implicit_torus_gradient, implicit_torus_range,
                              4 * B * (B * B + RR) + 8 * RR * B, ball, k};
}

static real implicit_gyroid_f(const void *data, vec3 p)
{
    (void)data;
    return sin(p.x) * cos(p.y) + sin(p.y) * cos(p.z) + sin(p.z) * cos(p.x);
}

static vec3 implicit_gyroid_gradient(const void *data, vec3 p)
{
    (void)data;
    real sx = sin(p.x), sy = sin(p.y), sz = sin(p.z), cx = cos(p.x), cy = cos(p.y), cz = cos(p.z);
    return (vec3){cx * cy - sz * sx, cy * cz - sx * sy, cz * cx - sy * sz};
}

static jet implicit_gyroid_range(const void *data, jet x, jet y, jet z)
{
    (void)data;
    jet a = jet_mul(jet_sin(x), jet_cos(y)), b = jet_mul(jet_sin(y), jet_cos(z));
    return jet_add(jet_add(a, b), jet_mul(jet_sin(z), jet_cos(x)));
}

static inline implicit_surface implicit_gyroid(const sphere *ball)
{
    return (implicit_surface){implicit_gyroid_f, implicit_gyroid_gradient, implicit_gyroid_range,
                              (real)1.7320509, *ball, ball};
}

static real implicit_barth_f(const void *data, vec3 p)
{
    const real g = (real)implicit_golden, a = g * g;
    (void)data;
    vec3 q = vmul(p, p);
    real u = q.x + q.y + q.z - 1;
    return (1 + 2 * g) * u * u - 4 * (a * q.x - q.y) * (a * q.y - q.z) * (a * q.z - q.x);
}

static vec3 implicit_barth_gradient(const void *data, vec3 p)
{
    const real g = (real)implicit_golden, a = g * g;
    (void)data;
    vec3 q = vmul(p, p);
    real u = a * q.x - q.y, v = a * q.y - q.z, w = a * q.z - q.x;
    real c = 4 * (1 + 2 * g) * (q.x + q.y + q.z - 1);
    return (vec3){p.x * (c - 8 * v * (a * w - u)), p.y * (c - 8 * w * (a * u - v)),
                  p.z * (c - 8 * u * (a * v - w))};
}

/* g is no number of the machine: the surface is that of the double nearest to it. */
static jet implicit_barth_range(const void *data, jet x, jet y, jet z)
{
    const double g = implicit_golden, a = g * g;
    (void)data;
    jet xx = jet_square(x), yy = jet_square(y), zz = jet_square(z);
    jet u = jet_sub(jet_scale(xx, a), yy), v = jet_sub(jet_scale(yy, a), zz);
    jet w = jet_sub(jet_scale(zz, a), xx), s = jet_shift(jet_add(jet_add(xx, yy), zz), -1);
    return jet_sub(jet_scale(jet_square(s), 1 + 2 * g), jet_scale(jet_mul(jet_mul(u, v), w), 4));
}

static inline implicit_surface implicit_barth(const real *radius)
{
    sphere ball = {{0, 0, 0}, *radius};
    real g = (real)implicit_golden, a = g * g, B = *radius, BB = B * B;
    real rest = 4 * (1 + 2 * g) * B * real_max(1, BB - 1);
    return (implicit_surface){implicit_barth_f, implicit_barth_gradient, implicit_barth_range,
                              24 * a * a * a * BB * BB * B + rest, ball, radius};
}

#endif
