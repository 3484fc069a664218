/* naive.h: two searches of the BSP tree that lose hits, with the signature of bsp_hit.
 *
 *   bsp_hit_naive(&b, r, &h)                     planes without padding: loses hits
 *   bsp_hit_first(&b, r, &h)                     the first leaf's hit as final: wrong hits
 */
#ifndef BSP_NAIVE_H
#define BSP_NAIVE_H

#include "../bsp.h"

/* ---------------------------------------------------------------------------------------------- */

/* Dyadic faces, corners and rays (tests): t of the plane and of the hit on it are equal, or a hair
 * apart, and the side that has the item is left before the hit. */
static inline bool bsp_hit_naive(const bsp *b, ray r, hit *out)
{
    return bsp_walk(b, r, 0, false, false, out, NULL);
}

/* A large triangle that is named by the first leaf and hit behind it, beyond a small one that
 * only the second leaf names. */
static inline bool bsp_hit_first(const bsp *b, ray r, hit *out)
{
    return bsp_walk(b, r, 2, false, true, out, NULL);
}

#endif
