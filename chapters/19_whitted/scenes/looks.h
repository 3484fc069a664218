/* looks.h: the materials that the scenes of this chapter are made of, and its square walls.
 *
 *   whitted_paint(r, g, b)      reflects evenly, casts shadows
 *   whitted_mirror(m)           M = m, nothing else
 *   whitted_clear(body, keep)   clear glass that bounds `body`; shadow rays keep this part of light
 *   box_faces(lo, hi, in, corner, shape)     the six squares of a box; normals outwards, or inwards
 */
#ifndef WHITTED_SCENES_LOOKS_H
#define WHITTED_SCENES_LOOKS_H

#include "../whitted_scene.h"

/* ---------------------------------------------------------------------------------------------- */

static inline whitted_material whitted_paint(double r, double g, double b)
{
    return (whitted_material){{{(real)r, (real)g, (real)b}, {0, 0, 0}, 1, {0, 0, 0}},
                              {0, 0, 0}, {0, 0, 0}, 0, 0};
}

static inline whitted_material whitted_mirror(double m)
{
    whitted_material x = whitted_paint(0, 0, 0);
    x.mirror = vec(m, m, m);
    return x;
}

static inline whitted_material whitted_clear(uint32_t body, real keep)
{
    whitted_material x = whitted_mirror(1);
    x.through = x.mirror, x.body = body, x.shadow = keep;
    return x;
}

/* corner[24], which the shapes point into, and shape[6]. */
static inline void box_faces(vec3 lo, vec3 hi, bool in, vec3 *corner, shape *s)
{
    for (int k = 0; k < 6; k++) {
        int axis = k / 2;
        for (int i = 0; i < 4; i++) {
            /* counter-clockwise, seen from where the normal points to */
            int j = (k % 2 == 0) == in ? i : 3 - i;
            bool a = j == 1 || j == 2, b = j > 1;
            real side = k % 2 ? vaxis(hi, axis) : vaxis(lo, axis), c[3];
            c[axis] = side;
            c[(axis + 1) % 3] = a ? vaxis(hi, (axis + 1) % 3) : vaxis(lo, (axis + 1) % 3);
            c[(axis + 2) % 3] = b ? vaxis(hi, (axis + 2) % 3) : vaxis(lo, (axis + 2) % 3);
            corner[4 * k + i] = (vec3){c[0], c[1], c[2]};
        }
        s[k] = shape_of_polygon(polygon_of(corner + 4 * k, 4));
    }
}

#endif
