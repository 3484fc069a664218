/* sight.h: can two points see each other? Ray casting (光线投射) that draws nothing.
 *
 *   bool sight(&t, a, b)                one ray of kind RAY_SIGHT between two surfaces
 *
 * Only pairs that face each other are asked: where n.(b - a) <= 0 at either end, the surface itself
 * is in between. The same answer for a, b and b, a: one ray serves both. Used for who can see whom
 * in a game, antennas, view factors, guards.
 */
#ifndef SHADE_SIGHT_H
#define SHADE_SIGHT_H

#include "shade.h"

/* ---------------------------------------------------------------------------------------------- */

static inline bool sight_possible(surface a, surface b)
{
    vec3 ab = vsub(b.p, a.p);
    return vdot(a.n, ab) > 0 && vdot(b.n, ab) < 0;
}

/* Points in the air have n = 0: for them give a surface {p, {0,0,0}, ..} with error 0, and ask with
 * sight_free. */
static inline bool sight_free(tracer *t, surface a, surface b)
{
    shade_lit answer = {false};
    trace(t, RAY_SIGHT, leave_between(a, b), &answer);
    return answer.lit;
}

static inline bool sight(tracer *t, surface a, surface b)
{
    return sight_possible(a, b) && sight_free(t, a, b);
}

#endif
