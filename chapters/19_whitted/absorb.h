/* absorb.h: light that coloured glass keeps (吸收): the law of Beer and Lambert.
 *
 *   dL/ds = -sigma L     =>     L(s) = L(0) e^(-sigma s)                      (19.9)
 *
 *   vec3 k = absorbed(sigma, s)         the part that is left after a way s; sigma per unit length
 *
 * The deeper, the darker and the more saturated: the colour of glass is no property of its surface.
 * After an infinite way nothing is left of what is absorbed, and all of what is not (sigma = 0: 0
 * times infinity would be a NaN). sigma = 0 costs no exponential.
 *
 * Sources: P. Bouguer 1729, J. Lambert 1760, A. Beer 1852.
 */
#ifndef WHITTED_ABSORB_H
#define WHITTED_ABSORB_H

#include "../../common/vec3.h"

/* ---------------------------------------------------------------------------------------------- */

static inline real absorbed_one(real a, real s) { return a == 0 ? 1 : exp(-a * s); }

static inline vec3 absorbed(vec3 a, real s)
{
    return (vec3){absorbed_one(a.x, s), absorbed_one(a.y, s), absorbed_one(a.z, s)};
}

#endif
