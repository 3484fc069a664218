/* own_box.h: what a triangle test calls a hit, against the box of that very triangle: rounding
 * against rounding.
 *
 * Never lost (a hit whose box is missed) is what a tree needs: else it loses triangles that brute
 * force finds. Early is a hit whose computed t lies before the *t_enter of its box: the box is
 * right, the triangle's t is off. A search that prunes by t_enter > tmax, with tmax from such a
 * hit, may skip another box that begins in between.
 *
 *   own_box_case c = own_box_case_of(seed, i, width, flat)   a triangle, and a ray at a corner of
 *                                 it, an edge or the inside; width 1: any shape, small: a needle;
 *                                 flat: in a plane z = constant, and so its box
 *   own_box_count n = own_box_counted(seed, cases, width, flat)
 */
#ifndef OWN_BOX_H
#define OWN_BOX_H

#include "alarms.h"
#include "mantissa.h"
#include "slabs.h"

typedef struct { triangle t; ray r; } own_box_case;
typedef struct { size_t hits, lost, lost_inclusive, early; } own_box_count;

/* ---------------------------------------------------------------------------------------------- */

static inline own_box_case own_box_case_of(uint64_t seed, uint64_t i, real width, bool flat)
{
    random_stream s = random_start(seed, i, 0);
    vec3 a = random_in_cube(&s), e = random_in_cube(&s), f = random_in_cube(&s);
    triangle t = {a, vadd(a, e), vadd(vmadd(a, e, random_next(&s)), vscale(f, width))};
    if (flat) t.b.z = t.c.z = t.a.z;
    int aim = random_integer(&s, 0, 2);  /* 0: a corner, 1: an edge, 2: inside */
    real u = aim > 0 ? random_next(&s) : 0, v = aim > 1 ? (1 - u) * random_next(&s) : 0;
    vec3 p = vmadd(vmadd(vscale(t.a, 1 - u - v), t.b, u), t.c, v);
    real far = pow((real)100, 2 * random_next(&s) - 1);
    vec3 o = vscale(random_in_cube(&s), far);
    return (own_box_case){t, ray_from(o, vsub(p, o))};
}

static inline own_box_count own_box_counted(uint64_t seed, size_t cases, real width, bool flat)
{
    own_box_count n = {0};
    for (size_t i = 0; i < cases; i++) {
        own_box_case c = own_box_case_of(seed, i, width, flat);
        aabb b = triangle_box(c.t);
        real t, u;
        hit h;
        if (!triangle_hit(c.t, c.r, &h)) continue;
        n.hits++;
        n.lost_inclusive += !aabb_hit_inclusive(b, c.r, &u);
        if (!aabb_hit(b, c.r, &t)) n.lost++;
        else n.early += h.t < t;
    }
    return n;
}

#endif
