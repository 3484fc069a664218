/* reflect.h: mirror reflection (镜面反射).
 *
 *        d   n   w         w = d + 2 c n,   c = -n.d                          (19.1)
 *         \  |  /          d towards the surface, w away from it; the angles with n are equal,
 *          v | /           and the three lie in one plane
 *     -------p-------
 *
 *   vec3 w = reflect(d, n)          unit, if d and n are, within some epsilon
 *   first_reflect(d, n)             of first.h: (19.1) as it stands
 *   vec3 u = unit_again(w)          length 1 + x becomes 1 - 3/2 x^2: no root, no division
 *   vec3 u = lifted(w, n)           w, or, if it leads below the plane of n, in that plane
 *
 * n of either side gives the same w. |w|^2 = |d|^2 + 4 c^2 (n.n - 1): if n is longer than 1 by
 * rounding, so is w, and the next reflection starts from there. Between two mirrors that grows with
 * the number of reflections; and t counts in lengths of w, so distances are wrong, too. One step of
 * Newton's method for 1/sqrt ends it.
 *
 * On which side of the surface w begins is known: it is the side that d came from. Its sign of n.w
 * is not asked for that: at a grazing angle it is rounding. But on a smoothed mesh w is made with
 * the shading normal, and near an outline it may lead below the surface itself, where it would meet
 * the surface's own back at once: a black rim. There it is lifted into the plane of n.
 *
 * Source: T. Whitted, "An Improved Illumination Model for Shaded Display", CACM 23(6), 1980.
 */
#ifndef WHITTED_REFLECT_H
#define WHITTED_REFLECT_H

#include "first.h"

/* ---------------------------------------------------------------------------------------------- */

/* 1/sqrt(1 + y) = 1 - y/2 + 3/8 y^2 .., y = w.w - 1. */
static inline vec3 unit_again(vec3 w) { return vscale(w, (3 - vdot(w, w)) / 2); }

/* Two mirrors with n = (0.6, 0.8, 0) as reals have it, a ray along n to and fro: after 1e5 plain
 * reflections |w| would be off by 1e5 times as much as n. */
static inline vec3 reflect(vec3 d, vec3 n) { return unit_again(first_reflect(d, n)); }

/* A hair above the plane, 16 epsilon, so that n.w > 0 whatever rounding makes of it. */
static inline vec3 lifted(vec3 w, vec3 n)
{
    real above = vdot(w, n);
    return above < 0 ? vunit(vmadd(w, n, 16 * real_epsilon - above)) : w;
}

#endif
