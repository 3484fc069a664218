/* spd_rings.h: a pyramid of balls of rings: six linked pentagons of five balls and five cylinders
 * each, one for each pair of faces of a dodecahedron; and a wall behind.
 *
 *      o===o          Layer d = 0 .. scale-1 has (d+1)^2 copies, at (2i - d, s (d+1), 2j - d). The
 *     //    \\        pentagons stand at the angle of the dodecahedron's axes to each other,
 *     o      o        2 acos(cos 60 / sin 36) = 63.4 degrees                            (17.4)
 *      \\  //
 *        o
 *
 * Balls and cylinders have radius r = .07412, the pentagons 1 / (1 + r). The balls of a pentagon
 * are 1.09 apart, far more than 2 r. But of two linked rings the axes pass each other at 2 r /
 * (1 + r): they would just touch if the pentagons had radius 1, and overlap by 2 r^2 / (1 + r) =
 * .0102, 14 % of r. So do rings of copies that are neighbours in x; in z and between layers there
 * is room.
 */
#ifndef MESH_SPD_RINGS_H
#define MESH_SPD_RINGS_H

#include "world.h"

enum { ring_points = 5, ring_count = 6 };

/* ---------------------------------------------------------------------------------------------- */

static inline finish rings_finish(int k)
{
    static const double c[ring_count][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1},
                                            {0, 1, 1}, {1, 0, 1}, {1, 1, 0}};
    return (finish){{(real)c[k][0], (real)c[k][1], (real)c[k][2]}, 0.5, 0.2,
                     3.0827, 0, 0};
}

static inline void rings_directions(vec3 out[ring_count][ring_points])
{
    vec3 x = {1, 0, 0}, z = {0, 0, 1};
    real tilt = 2 * acos(cos(pi / 3) / sin(pi / 5));
    for (int k = 0; k < ring_count; k++)
        for (int i = 0; i < ring_points; i++) {
            vec3 p = turned(x, z, (real)i * (2 * pi / 5));
            out[k][i] = k == 0 ? p : turned(turned(p, x, tilt), z, (real)(2 * k - 1) * (pi / 5));
        }
}

static inline void rings_copy(world *w, vec3 d[ring_count][ring_points], vec3 centre)
{
    real r = 0.07412, reach = 1 / (1 + r);
    for (int k = 0; k < ring_count; k++) {
        world_paint(w, rings_finish(k));
        for (int i = 0; i < ring_points; i++) {
            vec3 a = vmadd(centre, d[k][i], reach);
            vec3 b = vmadd(centre, d[k][(i + 1) % ring_points], reach);
            world_add(w, shape_of_sphere((sphere){a, r}));
            world_add(w, shape_of_cone((cone){a, r, b, r}));
        }
    }
}

cold_inline bool spd_rings(int scale, world *w, failure *f)
{
    size_t n = (size_t)scale, copies = n * (n + 1) * (2 * n + 1) / 6;
    real s = 1 / sin(pi / 8), far = s * (real)(scale + 1), half = (real)1.01 * (far + s);
    vec3 d[ring_count][ring_points], eye = {-1, -s, 0.5}, c[4];
    half *= tan(pi / 8);
    world_room(w, 1 + 2 * ring_points * ring_count * copies, 4, 1 + ring_count * copies);
    rings_directions(d);
    world_paint(w, (finish){{1, 1, 1}, 1, 0, 0, 0, 0});
    for (int k = 0; k < 4; k++)  /* seen from the eye, counter-clockwise */
        c[k] = (vec3){eye.x + (k == 0 || k == 3 ? half : -half), far,
                      eye.z + (k < 2 ? half : -half)};
    world_add_polygon(w, c, 4);
    for (int layer = 0; layer < scale; layer++)
        for (int i = 0; i <= layer; i++)
            for (int j = 0; j <= layer; j++)
                rings_copy(w, d, vec((2 * i - layer), s * (real)(layer + 1),
                                        (2 * j - layer)));
    world_light(w, (vec3){3, -s, 3});
    world_light(w, (vec3){-4, -s, 1});
    world_light(w, (vec3){2, -s, -4});
    return world_look(w, eye, vadd(eye, (vec3){0, 1, 0}), (vec3){0, 0, 1}, 45, f);
}

#endif
