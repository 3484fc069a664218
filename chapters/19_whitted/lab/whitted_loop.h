/* whitted_loop.h: the same as a loop: a stack of rays that are still to be traced.
 *
 *   vec3 colour = whitted_ray_loop(&t, r, in)      what whitted_ray gives, but for rounding
 *
 * Why: a recursion keeps, for every level, all that it will need on the way back. Here nothing is
 * needed on the way back, since each branch knows its weight at the eye: its light is added at
 * once, and the branch is forgotten. What waits is a list of rays, at most one a level and one
 * more. Such a list can be cut, sorted, or handed to another thread; on graphics cards, where a
 * function may hardly call itself, it is the usual way. The sum is taken in another order, so the
 * last bits differ.
 *
 * Source: S. Laine, T. Karras, T. Aila, "Megakernels Considered Harmful", HPG 2013.
 */
#ifndef WHITTED_LOOP_H
#define WHITTED_LOOP_H

#include "../whitted.h"

/* ---------------------------------------------------------------------------------------------- */

/* The last of the children is traced first, so that at most one a level waits. */
static inline vec3 whitted_ray_loop(tracer *t, ray r, media_set in)
{
    whitted_branch stack[whitted_most_depth + 1];
    vec3 sum = {0, 0, 0};
    real square = 1;
    int top = 0;
    for (stack[top++] = whitted_eye(r, in); top > 0; ) {
        whitted_branch b = stack[--top];
        whitted_place p;
        bool met = whitted_find(t, &b, &p);
        if (b.depth == 1) square = whitted_square(t->user, &b.in);                     /* (19.11) */
        vec3 L = met ? whitted_shade(t, &b, &p) : whitted_sky(t->user, &b);
        sum = vadd(sum, vmul(b.weight, vmul(p.left, L)));
        if (met) top += whitted_children(t->user, &b, &p, stack + top);
    }
    return vscale(sum, square);
}

#endif
