/* naive.h: solid angle and irradiance as they are published; what each loses.
 *
 *   triangle_solid_angle_girard(t, p)          sum of angles - pi: all digits of a small triangle
 *   sphere_irradiance_naive(s, p, n)           (22.13): those of a small sphere near the horizon
 *   polygon_irradiance_naive(v, count, p, n)   (22.15) with acos, and without a cut
 *
 * Sources: A. Girard, "Invention nouvelle en l'algebre", 1629; Lagarde, de Rousiers 2014 and
 * Lambert 1760, as in sphere_irradiance.h and polygon_irradiance.h.
 */
#ifndef RADIOMETRY_NAIVE_H
#define RADIOMETRY_NAIVE_H

#include "polygon_irradiance.h"
#include "sphere_irradiance.h"

/* ---------------------------------------------------------------------------------------------- */

/* The angle between the planes n, a and n, b, at the corner n of a spherical triangle. */
static inline real corner_angle_naive(vec3 n, vec3 a, vec3 b)
{
    return acos(real_clamp(vdot(vunit(vcross(n, a)), vunit(vcross(n, b))), -1, 1));
}

/* A triangle of 1e-8 r: each angle is known to some epsilon, their sum less pi to some epsilon, and
 * the answer is 1e-16. */
static inline real triangle_solid_angle_girard(triangle t, vec3 p)
{
    vec3 a = vsub(t.a, p), b = vsub(t.b, p), c = vsub(t.c, p);
    real sum = corner_angle_naive(a, b, c) + corner_angle_naive(b, c, a)
             + corner_angle_naive(c, a, b);
    return vdot(a, vcross(b, c)) < 0 ? pi - sum : sum - pi;
}

static inline real sphere_irradiance_naive(sphere s, vec3 p, vec3 n)
{
    vec3 f = vsub(s.c, p);
    real d2 = vdot(f, f), h2 = d2 / (s.r * s.r);
    if (h2 <= 1) return pi;
    real cosb = real_clamp(vdot(n, f) / sqrt(d2), -1, 1), h = sqrt(h2);
    if (h * cosb > 1) return pi * cosb / h2;
    if (h * cosb < -1) return 0;
    real sinb = sqrt(1 - cosb * cosb), x = sqrt(h2 - 1), y = -x * (cosb / sinb);
    real sy = sinb * sqrt(real_max(1 - y * y, 0));
    return (cosb * acos(real_clamp(y, -1, 1)) - x * sy) / h2 + atan(sy / x);
}

static inline real polygon_irradiance_naive(const vec3 *v, int count, vec3 p, vec3 n)
{
    real sum = 0;
    for (int i = 0; i < count; i++) {
        vec3 a = vunit(vsub(v[i], p)), b = vunit(vsub(v[(i + 1) % count], p));
        sum += acos(vdot(a, b)) * vdot(n, vunit(vcross(a, b)));
    }
    return -sum / 2;
}

#endif
