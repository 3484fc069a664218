/* leave.h: a ray that leaves a surface, and neither meets it again nor jumps over its neighbour.
 *
 *              w                 A shadow ray begins on a surface. Rounded, its origin lies a hair
 *             /                  before or behind it: behind, and the surface shadows itself (acne,
 *       O ---'     n.w > 0       自遮挡); started too far away, and what touches the surface casts
 *       |  error + noise         no shadow (leak, 漏光).
 *   ----p--------------          O = p + sign(n.w) (error + noise) n          (18.10)
 *                                [tmin, tmax] = [0, ..]: no epsilon in t
 *
 *   ray r = leave(s, w);             from s along w (not zero, any length), to infinity
 *   ray r = leave_to(s, q);          from s to a point that is on no surface: D = q - O, [0, 1]
 *   ray r = leave_between(a, b);     from one surface to another: D = Ob - Oa, [0, 1]; neither end
 *                                    is hit: line of sight (视线)
 *
 * Why it works. p is off by `error` at most, and that pays for the rounding of O, too; the shape's
 * test is off by `noise`. So O lies on the side that w leads to, and the test agrees: t = 0 is not
 * reached. Why nothing leaks: error + noise is a few epsilon of |p| and of the shape's size, 1e-12
 * of a metre at a kilometre; what is farther away than that is met.
 *
 * Which side: the sign of n.w of the geometric normal n, never of the shading normal, so that a
 * refracted ray enters, a reflected one leaves. n.w = 0, in the surface: O on the side of n.
 * Costs a dot product and a few sums. What other ways cost and miss: leave_variants.h, README.
 */
#ifndef SHADE_LEAVE_H
#define SHADE_LEAVE_H

#include "surface.h"

/* ---------------------------------------------------------------------------------------------- */

/* p moved along `side`, n or -n, far enough (18.10), and by `more` [scene units]. */
fast_inline vec3 leave_side(const surface *s, vec3 side, real more)
{
    return vmadd(s->p, side, s->error + s->noise + more);
}

/* p moved to the side of w. */
fast_inline vec3 leave_point(surface s, vec3 w, real more)
{
    real off = s.error + s.noise + more;
    return vmadd(s.p, s.n, vdot(s.n, w) < 0 ? -off : off);
}

static inline ray leave(surface s, vec3 w)
{
    return (ray){leave_point(s, w, 0), 0, w, real_infinity};
}

static inline ray leave_to(surface s, vec3 q)
{
    return ray_between(leave_point(s, vsub(q, s.p), 0), q);
}

/* The far end is seen from the near one: there the test's error is one of the distance, 3 eps D for
 * each corner (14.3) and as much for t d. 16 eps D pay for it, at both ends, so that a and b see
 * each other alike. (The sum is D or up to 1.8 D, and needs no root.) */
fast_inline ray leave_between(surface a, surface b)
{
    vec3 ab = vsub(b.p, a.p);
    real more = 16 * real_epsilon * (fabs(ab.x) + fabs(ab.y) + fabs(ab.z));
    return ray_between(leave_point(a, ab, more), leave_point(b, vneg(ab), more));
}

#endif
