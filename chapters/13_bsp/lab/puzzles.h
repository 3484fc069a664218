/* puzzles.h: triangles that are hard to paint in order, and a town, which slanted planes suit.
 *
 *   mesh m = cyclic_mesh()          three long triangles, each over the next: no order
 *   mesh m = town_mesh(n, turn)     n x n blocks of 12 triangles on a square of 2, turned by `turn`
 *                                   [radians] about (1, 2, 3)
 *
 * mesh_free releases them.
 */
#ifndef BSP_PUZZLES_H
#define BSP_PUZZLES_H

#include "../../01_ray/affine.h"
#include "../../07_mesh/scenes/soup.h"

/* ---------------------------------------------------------------------------------------------- */

/* The same triangle turned by thirds: it rises along its length, so each ends over the next. */
static inline mesh cyclic_mesh(void)
{
    mesh m = mesh_room(3);
    for (size_t i = 0; i < 3; i++) {
        real a = 2 * pi * (real)i / 3, c = cos(a), s = sin(a);
        const vec3 q[3] = {{-1.1, -0.8, -0.3}, {1.3, -0.5, 0.3},
                           {-1.1, -0.1, -0.3}};
        for (size_t k = 0; k < 3; k++)
            m.v[3 * i + k] = (vec3){c * q[k].x - s * q[k].y, s * q[k].x + c * q[k].y, q[k].z};
    }
    return m;
}

static inline mesh town_mesh(size_t n, real turn)
{
    mesh m = mesh_room(12 * n * n);
    vec3 axis = vunit((vec3){1, 2, 3});
    for (size_t i = 0; i < n * n; i++) {
        random_stream g = random_start(7, i, 0);
        real w = 2 / (real)n, h = (real)0.1 + (real)0.6 * random_next(&g), edge = w / 6;
        vec3 lo = {w * (real)(i % n) - 1 + edge, w * (real)(i / n) - 1 + edge, 0};
        vec3 size = {w - 2 * edge, w - 2 * edge, h}, q[8];
        for (int k = 0; k < 8; k++)
            q[k] = vturned(vadd(lo, vmul(vec(k & 1, k >> 1 & 1, k >> 2), size)), axis, turn);
        static const int face[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                       {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
        for (size_t k = 0; k < 12; k++) {
            const int *f = face[k / 2];
            vec3 *v = m.v + 36 * i + 3 * k;
            v[0] = q[f[0]], v[1] = q[f[1 + k % 2]], v[2] = q[f[2 + k % 2]];
        }
    }
    return m;
}

#endif
