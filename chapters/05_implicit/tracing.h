/* tracing.h: sphere tracing (球体追踪): steps that cannot pass a root, if f has a Lipschitz bound L.
 *
 *      o --( . )( . )( .)(.)|     |f(p) - f(q)| <= L |p - q|, so where f is 0 is |f(p)| / L away
 *          steps shrink as the    from p at least: that far is free, in every direction
 *          surface comes near         t  <-  t + |f(o + t d)| / (L |d|)                     (5.4)
 *
 *   implicit_trace_hit(&s, r, eps, steps, &h)    a hit where |f| / L <= eps [scene units]
 *
 *   input                        answer
 *   f is a distance              L = 1: the steps are as long as they can be
 *   L is larger than needed      more steps, no other harm
 *   L is too small               holes: that it is a bound is not checked
 *   no L (0)                     a miss: nothing is known of f between two points
 *   steps used up                a miss; grazing rays take most
 *   passes within eps            a hit: false, if the surface is not met: everything is eps fatter
 *   o on the surface             a hit at tmin
 *   f is NaN there               a miss
 *
 * t comes out before the surface, by eps / cos at least where the ray meets it at an angle; in
 * exact numbers it never lies beyond. f and the sums round: at eps near epsilon |f| is noise.
 *
 * Source: Hart 1996 (see surface.h).
 */
#ifndef IMPLICIT_TRACING_H
#define IMPLICIT_TRACING_H

#include "../01_ray/hit.h"
#include "surface.h"

/* ---------------------------------------------------------------------------------------------- */

static inline bool implicit_trace_hit(const implicit_surface *s, ray r, real eps, int steps,
                                      hit *out)
{
    if (!(s->lipschitz > 0) || !implicit_clip(s, &r)) return false;
    real speed = vlength(r.d), t = r.tmin;
    for (int k = 0; k < steps && t <= r.tmax; k++) {
        real free = fabs(implicit_value(s, ray_at(r, t))) / s->lipschitz;
        if (free <= eps) {
            *out = (hit){t, 0, 0, 0};
            return true;
        }
        real next = t + free / speed;                                                   /* (5.4) */
        if (!(next > t)) return false;  /* NaN; or free is below the rounding of t */
        t = next;
    }
    return false;
}

#endif
