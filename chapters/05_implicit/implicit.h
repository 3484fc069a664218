/* implicit.h: where a ray meets an implicit surface, by the surest way that the surface allows.
 *
 *   implicit_hit(&s, r, &h)      the first root of f(o + t d) in the closed [tmin, tmax]
 *
 *   the surface has   method                what it can miss          what it can make up
 *   range             search.h, intervals   nothing                   misses by less than rounding
 *   lipschitz         tracing.h             rays of many steps        misses by less than eps
 *   neither           newton.h              what turns twice a step   nothing
 *   -                 first.h               what turns in a step      nothing
 *
 * h.t alone is set; u, v, shape are 0. On a miss h is untouched. What d = 0, NaN, an infinite
 * interval or a ray from the surface do is said in surface.h and in each method's header.
 */
#ifndef IMPLICIT_H
#define IMPLICIT_H

#include "newton.h"
#include "search.h"
#include "tracing.h"

/* Where there is no range: how near is a hit [scene units]; steps at most, or in the interval. */
#define implicit_trace_eps ((real)1e-4)
enum { implicit_trace_steps = 4096, implicit_newton_steps = 128 };

/* ---------------------------------------------------------------------------------------------- */

static inline bool implicit_hit(const implicit_surface *s, ray r, hit *out)
{
    if (s->range) return implicit_search_hit(s, r, out);
    if (s->lipschitz > 0)
        return implicit_trace_hit(s, r, implicit_trace_eps, implicit_trace_steps, out);
    return implicit_newton_hit(s, r, implicit_newton_steps, out);
}

#endif
