/* ball_hit.h: sphere_hit of 03 for rays that begin at tmin = 0: the same answers to the last bit,
 * sooner where they are clear.
 *
 *   bool ball_hit(&s, &r, &h)      the first root: outside and behind is clear before the root is
 *                                  drawn, outside and in front takes one division, not two
 *   bool ball_exit(&s, &r, &h)     the same; expects r to begin inside
 *   bool ball_outwards(&s, &r)     of a ray that begins on s: it leaves, or begins inside and is to
 *
 * Clear is k = |f|^2 - R^2 > 64 epsilon (|f|^2 + R^2): the signs of k, and of the roots, are then
 * beyond the rounding of all that is computed. The rest asks 03.
 */
#ifndef WHITTED_BALL_HIT_H
#define WHITTED_BALL_HIT_H

#include "../../03_sphere/sphere.h"

/* ---------------------------------------------------------------------------------------------- */

/* As in sphere_roots: (3.5). `sure`: D is beyond its noise. */
typedef struct { double a, b, D, k, size; bool sure; } ball_look;

__attribute__((always_inline))
static inline ball_look ball_look_at(const sphere *s, const ray *r)
{
    const double noise = 10 * DBL_EPSILON, tiny = DBL_MIN / (DBL_EPSILON * DBL_EPSILON);
    double dx = (double)r->d.x, fx = (double)r->o.x - (double)s->c.x, R = (double)s->r;
    double dy = (double)r->d.y, fy = (double)r->o.y - (double)s->c.y;
    double dz = (double)r->d.z, fz = (double)r->o.z - (double)s->c.z;
    double x = dy * fz - dz * fy, y = dz * fx - dx * fz, z = dx * fy - dy * fx;
    double a = dx * dx + dy * dy + dz * dz, b = -(dx * fx + dy * fy + dz * fz);
    double ff = fx * fx + fy * fy + fz * fz, rr = R * R, size = ff + rr;
    double arr = a * rr, xx = x * x + y * y + z * z, D = arr - xx;
    bool sure = (a > tiny) & (size > tiny) & (D * D > noise * noise * (arr + xx) * (a * size));
    return (ball_look){a, b, D, ff - rr, 64 * DBL_EPSILON * size, sure & (r->tmin == 0)};
}

__attribute__((always_inline))
static inline bool ball_hit(const sphere *s, const ray *r, hit *out)
{
    ball_look q = ball_look_at(s, r);
    if (!(q.sure & (q.k > q.size))) return sphere_hit(*s, *r, out);
    if ((q.D < 0) | (q.b < 0)) return false;
    real t = (real)((q.b - sqrt(q.D)) / q.a);                                            /* (3.6) */
    if (!(t <= real_min(real_largest, r->tmax))) return false;
    *out = (hit){t, 0, 0, 0};
    return true;
}

/* From inside, k < 0, also by rounding: the far root is the one (3.6), and no noise if b >= 0. */
__attribute__((always_inline))
static inline bool ball_exit(const sphere *s, const ray *r, hit *out)
{
    ball_look q = ball_look_at(s, r);
    if (!(q.sure & (q.D > 0) & (q.b >= 0) & (r->tmax == real_infinity)))
        return sphere_hit(*s, *r, out);
    real t = (real)((q.b + sqrt(q.D)) / q.a);
    if (!(t <= real_largest)) return false;
    *out = (hit){t, 0, 0, 0};
    return true;
}

__attribute__((always_inline))
static inline bool ball_outwards(const sphere *s, const ray *r)
{
    return vdot(vsub(r->o, s->c), r->d) > 0;
}

#endif
