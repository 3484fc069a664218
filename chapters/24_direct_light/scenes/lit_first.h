/* lit_first.h: the scene of first.h as a lit scene, so that both versions can be asked the same.
 *
 *   first_scene f = first_cornell();
 *   lit_scene s;
 *   lit_first(&f, &s);            flat things and balls, matte; in the end lit_free(&s)
 *   lit_first_begin(&f, &s);      or before lit_end
 *   camera c = lit_first_camera();                 as first_cornell_camera of a square picture
 *
 * Thing i is a rectangle emitter of its own if it shines; thing 0 is the first of the emitters. Two
 * triangles for each flat thing, so that the last bits of what rays meet may differ from first.h's.
 */
#ifndef DIRECT_LIT_FIRST_H
#define DIRECT_LIT_FIRST_H

#include "../../02_camera/camera.h"
#include "../first.h"
#include "../lit_scene.h"

/* ---------------------------------------------------------------------------------------------- */

static inline void lit_first_begin(const first_scene *f, lit_scene *s)
{
    lit_begin(s);
    for (int i = 0; i < f->things; i++) {
        const first_thing *x = &f->thing[i];
        material m = {.kd = x->m.kd, .ke = x->m.ke};
        uint16_t k = lit_add_material(s, m);
        if (x->ball.r != 0) lit_add_shape(s, shape_of_sphere(x->ball), k);
        else lit_add_rectangle(s, (rectangle){x->corner, x->a, x->b}, k);
    }
}

static inline void lit_first(const first_scene *f, lit_scene *s)
{
    lit_first_begin(f, s);
    lit_end(s);
}

static inline camera lit_first_camera(void)
{
    first_camera c = first_cornell_camera(1, 1);
    return camera_at(c.e, vsub(c.e, c.w), c.v, 2 * atan(c.top) * 180 / pi, 1);
}

#endif
