/* lit_cornell.h: the Cornell box (21) as a lit scene: 38 triangles, matte, and one light.
 *
 *   lit_scene s;
 *   lit_cornell(&s);              then lit_trace(&s, ..), in the end lit_free(&s)
 *   lit_cornell_begin(&s);        or before lit_end: to add things to the box
 *   lit_cornell_room(&s, n);      the same, of the first n triangles; cornell_room: no blocks
 *   camera c = cornell_camera(1);
 *
 * The light is ONE rectangle emitter, number 0, though rays meet it as two triangles. The order of
 * the triangles is that of cornell_mesh; materials are in the order of cornell_part.
 */
#ifndef DIRECT_LIT_CORNELL_H
#define DIRECT_LIT_CORNELL_H

#include "../../21_distributed/scenes/cornell.h"
#include "../lit_scene.h"

/* ---------------------------------------------------------------------------------------------- */

static inline void lit_cornell_room(lit_scene *s, size_t triangles)
{
    mesh m = cornell_mesh();
    lit_begin(s);
    for (int k = 0; k < cornell_parts; k++) {
        material x = {.kd = cornell_reflectance[k]};
        if (k == CORNELL_LIGHT) x.ke = cornell_radiance;
        lit_add_material(s, x);
    }
    for (size_t i = 0; i < triangles; i++) {
        cornell_part part = cornell_of(i);
        rectangle lamp = {cornell_corner, cornell_side_s, cornell_side_t};
        if (part != CORNELL_LIGHT) lit_add_triangle(s, mesh_triangle(&m, i), (uint16_t)part);
        else if (i % 2 == 0) lit_add_rectangle(s, lamp, (uint16_t)part);
    }
    mesh_free(&m);
}

static inline void lit_cornell_begin(lit_scene *s) { lit_cornell_room(s, cornell_triangles); }

static inline void lit_cornell(lit_scene *s)
{
    lit_cornell_begin(s);
    lit_end(s);
}

#endif
