/* sphere_irradiance.h: how much light a sphere of radiance 1 sends onto a surface, in closed form.
 *
 *            .-.  R             E = integral of L cos theta d omega                      (22.9)
 *           ( c )  |              = pi L (R/d)^2 cos beta, if all of it is above         (22.10)
 *      n     '-'   | height     the horizon (地平线) of the surface, height >= R. Partly below,
 *      |  d .'     |
 *   ___|_.'________|___         E / L = atan(w/k) - k w / d^2                            (22.13)
 *      p   across                       + R^2 height / d^3 acos(...)
 *                               k^2 = d^2 - R^2,  w^2 = R^2 - height^2
 *
 *   sphere_irradiance(s, p, n)       E / L [sr]: times L [W/(m^2 sr)] it is the irradiance [W/m^2]
 *
 *   case                                         naive                       so here
 *   far sphere (R/d = 1e-3 in float) on the      three terms of size R/d     positive numbers are
 *   horizon; or a sliver of one above it         leave (R/d)^3: noise, < 0   integrated (22.14)
 *   sphere touching the surface at p             sqrt(d^2 - R^2) is noise    d^2 - R^2 by wide.h
 *   p inside: all the light comes in             pi                          pi
 *
 * What the default gives is right to 16 epsilon where height and `across` are (n along an axis),
 * and otherwise to some epsilon d / (R + height): what the last bit of n or p already changes.
 * Distances: 1e-9 to 1e9 in float, 1e-75 to 1e75 in double.
 *
 * Sources: J. Snyder, "Area Light Sources for Real-Time Graphics", Microsoft TR 96-11, 1996; S.
 * Lagarde, C. de Rousiers, "Moving Frostbite to Physically Based Rendering 3.0", 2014, listing 7.
 */
#ifndef RADIOMETRY_SPHERE_IRRADIANCE_H
#define RADIOMETRY_SPHERE_IRRADIANCE_H

#include "../../../common/numbers/gauss.h"
#include "../solid_angle.h"

/* A sphere in the frame of the surface. power = d^2 - radius^2 [>= 0]. */
typedef struct { real radius, across, power; } sphere_view;

/* ---------------------------------------------------------------------------------------------- */

/* The part above the horizon of a sphere whose centre is `depth` [0, R) below it, as slices of one
 * elevation theta, each two phi wide:
 *     E = integral of 2 phi sin theta cos theta,  0 < theta < top = sigma - e,              (22.14)
 *     sin^2(phi / 2) = sin((sigma + e + theta) / 2) sin((top - theta) / 2) / (cos e cos theta)
 * e: depth as an angle, sigma: radius as an angle. theta = top (1 - x^2) makes phi smooth. */
static inline real sphere_sliver(sphere_view v, real depth, real d)
{
    real k = sqrt(v.power), w2 = (v.radius - depth) * (v.radius + depth);
    real e = atan2(depth, v.across), cos_e = v.across / d, sum = 0;
    real top = atan2(w2 * d / (v.radius * v.across + k * depth) * d,
                     k * v.across + v.radius * depth);
    for (int i = 0; i < gauss_n; i++) {
        real x = gauss_point(i), theta = top * (1 - x * x);
        real q = sin(e + (top + theta) / 2) * sin(top * x * x / 2) / (cos_e * cos(theta));
        real phi = 2 * asin(sqrt(real_min(q, 1)));
        sum += gauss_weight(i) * phi * sin(2 * theta) * x;
    }
    return 2 * top * sum;
}

/* (22.13) for a centre below the horizon, or (22.14) where its terms cancel. */
static inline real sphere_sunk(sphere_view v, real depth)
{
    if (!(depth < v.radius) || v.across == 0) return 0;
    real d = hypot(v.across, depth), k = sqrt(v.power), sine = v.radius / d;
    real w = sqrt((v.radius - depth) * (v.radius + depth)), first = atan2(w, k);
    real e = first - (k / d) * (w / d) - sine * sine * (depth / d) * atan2(w * d, depth * k);
    return 4 * e > first ? e : sphere_sliver(v, depth, d);
}

/* Above minus below is (22.10) whatever the height: a centre above the horizon needs only what is
 * below, and adds it. */
static inline real sphere_irradiance(sphere s, vec3 p, vec3 n)
{
    vec3 f = vsub(s.c, p);
    real r = fabs(s.r), d = vlength(f), power = (d - r) * (d + r);
    if (fabs(power) < d * d / 2) power = sphere_power_at(s, p);
    if (d == 0) return r > 0 ? pi : 0;
    if (power < 0) return pi;
    real across = vlength(vcross(n, f)), height = vdot(n, f);
    sphere_view v = {r, across, power};
    if (height <= 0) return sphere_sunk(v, -height);
    real far = hypot(across, height), sine = r / far;
    return pi * sine * sine * (height / far) + sphere_sunk(v, height);
}

#endif
