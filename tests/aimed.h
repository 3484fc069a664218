/* aimed.h: meshes that are hard to cut, beside the rays of 09_aabb/trials/aimed.h.
 *
 *   mesh m = needles(n, width)                  n, 1 long, `width` wide, within a cube of side 2
 *   sick_ray[sick_count]          rays that are none, and (from 5 on) intervals that hold no t
 */
#ifndef TESTS_AIMED_H
#define TESTS_AIMED_H

#include "../chapters/07_mesh/scenes/soup.h"
#include "../chapters/07_mesh/scenes/specimens.h"
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

#endif
