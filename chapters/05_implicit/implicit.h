/* implicit.h: where a ray meets an implicit surface, by the surest way that the surface allows.
 *
 *   implicit_hit(&s, r, &h)      the first root of f(o + t d) in the closed [tmin, tmax]
 *   implicit_method_hit(how, &s, r, &h)           by one method, for comparing
 *
 *   the surface has   method                 what it can miss           what it can make up
 *   range             IMPLICIT_INTERVAL      nothing: search.h         misses by less than rounding
 *   lipschitz         IMPLICIT_TRACE         rays of many steps         misses by less than eps
 *   neither           IMPLICIT_NEWTON        what turns twice a step    nothing
 *   -                 IMPLICIT_FIRST         what turns in a step       nothing
 *
 * h.t alone is set; u, v, shape are 0. On a miss h is untouched. What d = 0, NaN, an infinite
 * interval or a ray from the surface do is said in surface.h and in each method's header.
 */
#ifndef IMPLICIT_H
#define IMPLICIT_H

#include "first.h"
#include "newton.h"
#include "search.h"
#include "tracing.h"

typedef enum {
    IMPLICIT_FIRST, IMPLICIT_NEWTON, IMPLICIT_TRACE, IMPLICIT_INTERVAL, implicit_kinds
} implicit_kind;
typedef struct {
    implicit_kind kind;
    int steps;   /* first, newton: in the interval; trace: at most; interval: not used */
    real eps;    /* trace alone: how near is a hit [scene units] */
} implicit_how;

/* Of implicit_hit where there is no range. */
#define implicit_trace_defaults ((implicit_how){IMPLICIT_TRACE, 4096, (real)1e-4})
#define implicit_newton_defaults ((implicit_how){IMPLICIT_NEWTON, 128, 0})

/* ---------------------------------------------------------------------------------------------- */

/* first.h takes an f without data: this thread's surface is handed to it aside. */
static _Thread_local const implicit_surface *implicit_asked;
static inline real implicit_asked_value(vec3 p) { return implicit_value(implicit_asked, p); }

static inline bool implicit_first_hit(const implicit_surface *s, ray r, int steps, hit *out)
{
    implicit_asked = s;
    return implicit_clip(s, &r) && first_implicit_hit(implicit_asked_value, r, steps, out);
}

static inline bool implicit_method_hit(implicit_how how, const implicit_surface *s, ray r, hit *out)
{
    switch (how.kind) {
    case IMPLICIT_FIRST: return implicit_first_hit(s, r, how.steps, out);
    case IMPLICIT_NEWTON: return implicit_newton_hit(s, r, how.steps, out);
    case IMPLICIT_TRACE: return implicit_trace_hit(s, r, how.eps, how.steps, out);
    case IMPLICIT_INTERVAL: return implicit_search_hit(s, r, out);
    case implicit_kinds: break;
    }
    return false;
}

static inline bool implicit_hit(const implicit_surface *s, ray r, hit *out)
{
    if (s->range) return implicit_search_hit(s, r, out);
    return implicit_method_hit(s->lipschitz > 0 ? implicit_trace_defaults
                                                : implicit_newton_defaults, s, r, out);
}

#endif
