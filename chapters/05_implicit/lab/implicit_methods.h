/* implicit_methods.h: implicit_hit by one method, for comparing.
 *
 *   implicit_method_hit(how, &s, r, &h)        the rows of the table in implicit.h
 *   implicit_first_hit(&s, r, steps, &h)       first.h's, on a surface
 */
#ifndef IMPLICIT_METHODS_H
#define IMPLICIT_METHODS_H

#include "../first.h"
#include "../implicit.h"

typedef enum {
    IMPLICIT_FIRST, IMPLICIT_NEWTON, IMPLICIT_TRACE, IMPLICIT_INTERVAL, implicit_kinds
} implicit_kind;
typedef struct {
    implicit_kind kind;
    int steps;   /* first, newton: in the interval; trace: at most; interval: not used */
    real eps;    /* trace alone: how near is a hit [scene units] */
} implicit_how;

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

#endif
