/* aimed.h: meshes that are hard to cut, beside the rays of 09_aabb/trials/aimed.h.
 *
 *   mesh m = needles(n, width)                  n, 1 long, `width` wide, within a cube of side 2
 *   mesh m = floors_mesh(n)                     squares in the planes x, y, z = -1 + 2 i / n:
 *                                 faces, edges and corners on each other and on dyadic planes
 *   sick_ray[sick_count]          rays that are none, and (from 5 on) intervals that hold no t
 */
#ifndef TESTS_AIMED_H
#define TESTS_AIMED_H

#include "../chapters/07_mesh/scenes/soup.h"
#include "../chapters/09_aabb/trials/aimed.h"

enum { sick_count = 8 };
static const ray sick_ray[sick_count] = {
    {{(real)NAN, 0, 0}, 0, {0, 0, 1}, real_infinity},
    {{0, 0, -9}, 0, {0, (real)NAN, 1}, real_infinity},
    {{0, 0, -9}, 0, {0, 0, 0}, real_infinity},
    {{0, 0, -real_infinity}, 0, {0, 0, 1}, real_infinity},
    {{0, 0, -9}, 0, {0, 0, real_infinity}, real_infinity},
    {{0, 0, -9}, (real)NAN, {0, 0, 1}, 99},
    {{0, 0, -9}, 0, {0, 0, 1}, (real)NAN},
    {{0, 0, -9}, 5, {0, 0, 1}, 4}};

/* ---------------------------------------------------------------------------------------------- */

static inline void set_triangle(mesh *m, size_t i, vec3 a, vec3 b, vec3 c)
{
    m->v[3 * i] = a, m->v[3 * i + 1] = b, m->v[3 * i + 2] = c;
}

/* A bundle of needles through the unit cube, 1 long and `width` wide: seen along their length or
 * edge-on, their t is as far off as it can be. */
static inline mesh needles(size_t n, real width) { return needle_mesh(n, width, 77); }

/* 3 (n + 1) planes of n x n squares each, cut in two: 6 n^2 (n + 1) triangles. */
static inline mesh floors_mesh(int n)
{
    mesh m = mesh_room((size_t)(6 * n * n * (n + 1)));
    size_t i = 0;
    for (int k = 0; k < 3; k++)
        for (int layer = 0; layer <= n; layer++)
            for (int cell = 0; cell < n * n; cell++) {
                real p[4][3];
                for (int c = 0; c < 4; c++) {
                    int a = cell % n + (c == 1 || c == 2), b = cell / n + c / 2;
                    p[c][k] = -1 + 2 * (real)layer / (real)n;
                    p[c][(k + 1) % 3] = -1 + 2 * (real)a / (real)n;
                    p[c][(k + 2) % 3] = -1 + 2 * (real)b / (real)n;
                }
                vec3 q[4];
                for (int c = 0; c < 4; c++) q[c] = (vec3){p[c][0], p[c][1], p[c][2]};
                set_triangle(&m, i++, q[0], q[1], q[2]);
                set_triangle(&m, i++, q[0], q[2], q[3]);
            }
    return m;
}

#endif
