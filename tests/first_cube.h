/* first_cube.h: a closed room as first.h has it. */
#ifndef FIRST_CUBE_H
#define FIRST_CUBE_H

#include "../chapters/24_direct_light/first.h"

/* The cube [-1,1]^3; thing 0 is wall number `shining`, and alone has E. */
static inline first_scene first_cube(int shining, first_material m, vec3 E, real eps)
{
    static const double wall[6][9] = {
        {-1, -1, -1, 0, 2, 0, 0, 0, 2}, {1, -1, -1, 0, 0, 2, 0, 2, 0},
        {-1, -1, -1, 0, 0, 2, 2, 0, 0}, {-1, 1, -1, 2, 0, 0, 0, 0, 2},
        {-1, -1, -1, 2, 0, 0, 0, 2, 0}, {-1, -1, 1, 0, 2, 0, 2, 0, 0}};
    first_scene s = {.eps = eps};
    for (int i = 0; i < 6; i++) {
        const double *w = wall[(shining + i) % 6];
        m.ke = i ? (vec3){0, 0, 0} : E;
        first_add_flat(&s, vec(w[0], w[1], w[2]), vec(w[3], w[4], w[5]), vec(w[6], w[7], w[8]), m);
    }
    return s;
}

#endif
