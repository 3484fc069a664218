/* lit_first.h: the scene of first.h as a lit scene, so that both versions can be asked the same.
 *
 *   first_scene f = first_cornell();
 *   lit_scene s;
 *   lit_first(&f, &s);            flat things and balls, matte; in the end lit_free(&s)
 *
 * Thing i is a rectangle emitter of its own if it shines; thing 0 is the first of the emitters. Two
 * triangles for each flat thing, so that the last bits of what rays meet may differ from first.h's.
 */
#ifndef DIRECT_LIT_FIRST_H
#define DIRECT_LIT_FIRST_H

#include "../first.h"
#include "../lit_scene.h"

/* ---------------------------------------------------------------------------------------------- */

static inline void lit_first(const first_scene *f, lit_scene *s)
{
    lit_begin(s);
    for (int i = 0; i < f->things; i++) {
        const first_thing *x = &f->thing[i];
        lit_material m = {.f = brdf_lambert(x->m.kd), .Le = x->m.ke};
        uint16_t k = lit_add_material(s, m);
        if (x->ball.r != 0) lit_add_shape(s, shape_of_sphere(x->ball), k);
        else lit_add_rectangle(s, (rectangle){x->corner, x->a, x->b}, k);
    }
    lit_end(s);
}

#endif
