/* leave_variants.h: how else rays are made to leave a surface: ray leave_X(surface s, vec3 w).
 *
 *   leave_first      tmin = 1e-4: the notes' epsilon, as in first.h      small or large scenes
 *   leave_scaled     tmin = 32 eps max(1, |p|_max) / |w|                  grazing rays
 *   leave_normal     O = p + 32 eps max(1, |p|_max) n                     large flat shapes
 *   leave_ulps       O = p moved by 256 ulps along n (整数偏移)          large shapes near 0
 *   leave_bounds     O = p + (error bounds . |n|) n, rounded outwards     needles
 *                                                                         ^ where it fails
 * Sources: C. Wächter, N. Binder, Ray Tracing Gems, 2019, ch. 6 (ulps); M. Pharr, W. Jakob, G.
 * Humphreys, "Physically Based Rendering", 3rd ed., 2016, section 3.9.5 (bounds).
 */
#ifndef SHADE_LAB_LEAVE_VARIANTS_H
#define SHADE_LAB_LEAVE_VARIANTS_H

#include "../leave.h"

/* ---------------------------------------------------------------------------------------------- */

/* w of length 1 or not: tmin counts in lengths of w, as in most programs that do this. */
static inline ray leave_first(surface s, vec3 w)
{
    return (ray){s.p, 1e-4, w, real_infinity};
}

static inline real leave_scale(surface s)
{
    return 32 * real_epsilon * real_max(1, surface_reach(s.p));
}

/* A grazing ray moves away from the surface by n.w of tmin only. */
static inline ray leave_scaled(surface s, vec3 w)
{
    return (ray){s.p, leave_scale(s) / vlength(w), w, real_infinity};
}

/* The test of a triangle of size 1e3 at the origin is off by eps 1e3: |p| may not tell. */
static inline ray leave_normal(surface s, vec3 w)
{
    real off = leave_scale(s);
    return (ray){vmadd(s.p, s.n, vdot(s.n, w) < 0 ? -off : off), 0, w, real_infinity};
}

/* x moved by n * 256 of its units in the last place. Near zero these vanish: there by n * 2^-16 in
 * float, as published, and as many digits later in double. */
static inline real leave_ulps_axis(real x, real n)
{
    const real near = (real)1 / 32, step = real_is_float ? (real)0x1p-16 : (real)0x1p-45;
    int e;
    if (fabs(x) < near) return x + step * n;
    (void)frexp(x, &e);
    return x + trunc(256 * n) * ldexp(real_epsilon, e - 1);
}

static inline ray leave_ulps(surface s, vec3 w)
{
    vec3 n = vdot(s.n, w) < 0 ? vneg(s.n) : s.n;
    vec3 o = {leave_ulps_axis(s.p.x, n.x), leave_ulps_axis(s.p.y, n.y),
              leave_ulps_axis(s.p.z, n.z)};
    return (ray){o, 0, w, real_infinity};
}

/* Each component to the next real on the side it was moved to. */
static inline real leave_outward(real x, real by)
{
    return by == 0 ? x : nextafter(x, by > 0 ? real_infinity : -real_infinity);
}

/* p is sure, but the test of one needle in 2e4 weighs corners that nearly cancel, and is not. */
static inline ray leave_bounds(surface s, vec3 w)
{
    real off = s.error * (fabs(s.n.x) + fabs(s.n.y) + fabs(s.n.z));
    vec3 by = vscale(s.n, vdot(s.n, w) < 0 ? -off : off), o = vadd(s.p, by);
    o = (vec3){leave_outward(o.x, by.x), leave_outward(o.y, by.y), leave_outward(o.z, by.z)};
    return (ray){o, 0, w, real_infinity};
}

#endif
