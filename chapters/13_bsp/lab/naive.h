/* naive.h: two searches of the BSP tree that lose hits, with the signature of bsp_hit, and a plane
 * that misses its own triangle.
 *
 *   bsp_hit_naive(&b, r, &h)                     planes without padding: loses hits
 *   bsp_hit_first(&b, r, &h)                     the first leaf's hit as final: wrong hits
 *   plane_of_triangle_naive(a, b, c)             by plain products
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

/* A needle 1 long and 1e-7 wide: plain products are off by eps, n by eps / 1e-7, and the corners
 * lie up to 1e-7 off their own plane. */
static inline split_plane plane_of_triangle_naive(vec3 a, vec3 b, vec3 c)
{
    vec3 n = vunit(vcross(vsub(b, a), vsub(c, a)));
    return (split_plane){n, vdot(n, a), 3};
}

#endif
