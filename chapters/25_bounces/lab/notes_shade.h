/* notes_shade.h: shade() as the lecture notes print it, with N = 1, and what it leaves out.
 *
 *   shade(p, wo)                                   what is missing
 *       Lo = 0.0                                   1. emission of p itself: what the eye sees of a
 *       choose wi ~ pdf, trace r(p, wi)               light is black
 *       if r hit the light                         2. "else": a light reflects, too (the Cornell
 *           Lo += L_i f_r cosine / pdf                box's .78 of what it gets), and here it
 *       else if r hit an object at q                  does not
 *           Lo += shade(q, -wi) f_r cosine / pdf   3. an end: in a closed room of objects none
 *       return Lo
 *
 *   vec3 L = notes_shade(&p, eye, &s, &counts);    p.depth mends the third
 *
 * Its expectation is K' E + K'^2 E + ..: E is missing, and K' is K without the rows of what shines,
 * but for the first hit. In a furnace, where all walls shine: rho E instead of E / (1 - rho).
 */
#ifndef BOUNCES_NOTES_SHADE_H
#define BOUNCES_NOTES_SHADE_H

#include "../naive_path.h"

/* ---------------------------------------------------------------------------------------------- */

static inline vec3 notes_shade(const naive_path *p, ray r, sampler *s, naive_counts *c)
{
    lit_hit x;
    bool met;
    vec3 through = {1, 1, 1}, weight;
    (void)naive_find(p, r, 0, &x, &met, c);
    for (int k = 1; met && k <= p->depth; k++) {
        if (!naive_direction(p, &x, vneg(vunit(r.d)), sampler_pair(s), &r, &weight)) break;
        through = naive_through(through, weight);
        vec3 Le = naive_find(p, r, k, &x, &met, c);
        if (!vzero(Le)) return vmul(through, Le);
    }
    return (vec3){0, 0, 0};
}

#endif
