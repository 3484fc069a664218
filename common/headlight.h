/* headlight.h: how bright a surface is, lit by a lamp beside the eye (头灯): |n . d|.
 *
 *        eye  ----- d ----->|           c = |n . d| / |d|                    (2.11)
 *                       <---|  n        1 where the surface faces the eye, 0 where it is edge-on
 *
 *   vec3 colour = headlight(n, r.d);      grey, each component in [0, 1]
 *
 * n: unit length, of either orientation. d: any length. A zero n or d gives black; a NaN in n stays
 * a NaN, so that the picture counts it instead of hiding it.
 */
#ifndef HEADLIGHT_H
#define HEADLIGHT_H

#include "vec3.h"

/* ---------------------------------------------------------------------------------------------- */

static inline vec3 headlight(vec3 n, vec3 d)
{
    real c = fabs(vdot(n, vunit(d)));
    c = c > 1 ? 1 : c;  /* n.d of two unit vectors may round above 1; a NaN passes */
    return (vec3){c, c, c};
}

#endif
