/* hit.h: what a ray hits first.
 *
 * Every shape has a function `bool X_hit(X, ray, hit *out)`: true if the ray meets it at a t of its
 * interval; `out` is untouched on a miss. The search for the closest hit (最近交点) narrows the
 * interval:
 *
 *   hit best = hit_none, h;
 *   for (i = 0; i < n; i++) {
 *       if (!X_hit(x[i], r, &h)) continue;
 *       h.shape = i;
 *       if (!hit_before(h, best)) continue;
 *       best = h;
 *       r.tmax = h.t;                        what lies beyond cannot be the closest
 *   }
 *
 * The interval is closed, so a later shape at the very same t is reported too; then the lower index
 * wins. That rule makes the answer independent of the order of the search: every acceleration
 * structure gives the same hit as this loop. `hit` itself stands in first.h.
 */
#ifndef RAY_HIT_H
#define RAY_HIT_H

#include "ray.h"

#define no_shape UINT32_MAX
#define hit_none ((hit){real_infinity, 0, 0, no_shape})

/* ---------------------------------------------------------------------------------------------- */

/* True if a comes before b: smaller t, or the same t and the lower index. */
static inline bool hit_before(hit a, hit b)
{
    return a.t < b.t || (a.t == b.t && a.shape < b.shape);
}

#endif
