/* spd_tetra.h: Sierpinski's tetrahedron: 4^scale triangles. Half of each tetrahedron is kept at
 * each of its corners, and in half of each half ...: in the end it has a surface, and no volume.
 *
 *    corners of a cube whose product of signs is +1: (- - +) (- + -) (+ - -) (+ + +)     (17.5)
 */
#ifndef MESH_SPD_TETRA_H
#define MESH_SPD_TETRA_H

#include "world.h"

/* ---------------------------------------------------------------------------------------------- */

static inline vec3 tetra_corner(vec3 centre, real reach, int k)
{
    static const int sign[4][3] = {{-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}, {1, 1, 1}};
    vec3 d = {(real)sign[k][0], (real)sign[k][1], (real)sign[k][2]};
    return vmadd(centre, d, reach);
}

static inline void tetra_add(world *w, vec3 centre, real reach, int depth)
{
    static const int face[4][3] = {{0, 1, 2}, {3, 2, 1}, {2, 3, 0}, {1, 0, 3}};
    if (depth > 1) {
        for (int k = 0; k < 4; k++)
            tetra_add(w, tetra_corner(centre, reach / 2, k), reach / 2, depth - 1);
        return;
    }
    for (int k = 0; k < 4; k++)
        world_add(w, shape_of_triangle((triangle){tetra_corner(centre, reach, face[k][0]),
                                                  tetra_corner(centre, reach, face[k][1]),
                                                  tetra_corner(centre, reach, face[k][2])}));
}

cold_inline bool spd_tetra(int scale, world *w, failure *f)
{
    real up = 0.816497, at = -0.004103;
    world_room(w, (size_t)1 << 2 * scale, 0, 1);
    world_paint(w, (finish){{1, 0.2, 0.2}, 1, 0, 0, 0, 0});
    tetra_add(w, (vec3){0, 0, 0}, 1, scale);
    world_light(w, (vec3){2, -18, -5});
    return world_look(w, vec(1.022846, -3.177154, -2.174512),
                      vec(at, at, 0.216539), (vec3){-up, -up, up}, 45, f);
}

#endif
