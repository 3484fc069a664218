/* spd_teapot.h: the Utah teapot, 64 n^2 - 8 n triangles, on a checkerboard of n x n squares. */
#ifndef MESH_SPD_TEAPOT_H
#define MESH_SPD_TEAPOT_H

#include "teapot.h"
#include "world.h"

/* ---------------------------------------------------------------------------------------------- */

/* Squares of one colour after those of the other: two groups, not n^2. */
static inline void teapot_board(world *w, int n)
{
    real side = 8 / (real)n;
    for (int black = 0; black < 2; black++) {
        real grey = black ? (real)0.5 : 1;
        world_paint(w, (finish){{grey, grey, grey}, 0.5, 0.5, 4.81884, 0, 0});
        for (int y = 0; y < n; y++)
            for (int x = 0; x < n; x++)
                if ((x + y) % 2 == black)
                    world_add_square(w, (vec3){((real)x + (real)0.5) * side - 4,
                                               ((real)y + (real)0.5) * side - 4, 0}, side / 2);
    }
}

static inline bool spd_teapot(int scale, world *w, failure *f)
{
    mesh pot = teapot_mesh(scale);
    size_t squares = (size_t)scale * (size_t)scale;
    world_room(w, pot.triangles + squares, 4 * squares, 3);
    world_paint(w, (finish){{1, 0.5, 0.1}, 0.75, 0.25, 3.0827, 0,
                             0});
    for (size_t i = 0; i < pot.triangles; i++)
        world_add(w, shape_of_triangle(mesh_triangle(&pot, i)));
    teapot_board(w, scale);
    mesh_free(&pot);
    world_light(w, vec(-3.1, 9.8, 12.1));
    world_light(w, vec(11.3, 5.1, 8.8));
    return world_look(w, vec(4.86, 7.2, 5.4), (vec3){0, 0, 0}, (vec3){0, 0, 1},
                      45, f);
}

#endif
