/* naive.h: a search that makes each ray's direction in object space unit, as if t did not change.
 *
 *   instances_hit_naive(&x, r, &h)        normalises D': hits in the wrong order
 */
#ifndef INSTANCES_LAB_NAIVE_H
#define INSTANCES_LAB_NAIVE_H

#include "../instances.h"

/* ---------------------------------------------------------------------------------------------- */

/* A mesh an eighth as large, 10 away, before another of full size, 40 away: in the small one's
 * space D' is eight times as long. Normalised, it takes eight times the t: 80. Each instance counts
 * in lengths of its own: t of one is not the t of another, the ray's interval means nothing, and
 * what is behind comes out in front. */
static inline bool instances_hit_naive(const instances *x, ray r, instance_hit *out)
{
    return instances_walk(x, r, false, true, out, NULL);
}

#endif
