/* leaky.h: the search all in float, nothing paid for: the speed of cracks. Triangles only; u, v, t
 * have six digits.
 *
 *   bool bvh8_hit_leaky(&w, r, &h)    bool bvh8_occluded_leaky(&w, r)
 */
#ifndef WIDE_LEAKY_H
#define WIDE_LEAKY_H

#include "../bvh8.h"

#define EIGHT_FILE "../../chapters/15_wide_bvh/lab/leaky_walk.h"
#include "../../../common/numbers/dialects.h"

/* ---------------------------------------------------------------------------------------------- */

static inline bool bvh8_leaky(const bvh8 *w, ray r, hit *out)
{
    return EIGHT_CALL(w->dialect, bvh8_find_leaky, w, &r, out);
}

static inline bool bvh8_hit_leaky(const bvh8 *w, ray r, hit *out) { return bvh8_leaky(w, r, out); }
static inline bool bvh8_occluded_leaky(const bvh8 *w, ray r) { return bvh8_leaky(w, r, NULL); }

#endif
