/* proof.h: is what a structure answers what brute force answers? By trial: the very hit, t, u, v
 * and shape, and the same "occluded".
 *
 *   bool prove_ray(c, s, r, due, &w)      due: brute force's hit, or hit_none. False: w says where
 *   bool prove_closed(c, s, r, due, &w)   the same, and again on [tmin, t] and on [t, t], t that of
 *                                         the hit: the interval is closed, so both find it (17.10)
 *
 * Rays that end exactly at their hit find out what others do not: a search that drops a box that is
 * entered at t = tmax, or whose tmax was rounded down on the way, passes all other rays. And one
 * that forgets to scale t passes all whose direction is about as long as 1 (prove_stretched).
 */
#ifndef COMPARE_LAB_PROOF_H
#define COMPARE_LAB_PROOF_H

#include "../../09_aabb/trials/aimed.h"
#include "contenders.h"

typedef struct {
    ray r;
    hit due, got;
    bool any;  /* asked was occluded(); got.shape is no_shape for "no" */
} wrong_answer;

/* ---------------------------------------------------------------------------------------------- */

static inline bool hits_same(hit a, hit b)
{
    return same(a.shape != no_shape, a, b.shape != no_shape, b);
}

static inline bool prove_ray(const contender *c, const void *s, ray r, hit due, wrong_answer *w)
{
    hit h = hit_none;
    bool met = c->hit(s, r, &h);
    if (!met) h = hit_none;
    *w = (wrong_answer){r, due, h, false};
    if (!hits_same(h, due)) return false;
    bool any = c->occluded(s, r);
    if (any == met) return true;
    w->got = any ? (hit){0, 0, 0, 0} : hit_none;
    w->any = true;
    return false;
}

static inline bool prove_closed(const contender *c, const void *s, ray r, hit due, wrong_answer *w)
{
    int ways = due.shape == no_shape ? 1 : aimed_ways;
    for (int k = 0; k < ways; k++)
        if (!prove_ray(c, s, aimed_way(r, due.t, k), due, w)) return false;
    return true;
}

#endif
