/* spd_balls.h: balls on balls: each ball wears nine of a third of its radius. sum of 9^k, k = 0..
 * scale, balls, and a floor.
 *
 *         o o                  A child touches its parent: centre + (4/3) r R d, where d is one of
 *       o(   )o                nine directions about +z and R takes +z to the direction in which
 *        o(_)o                 the parent itself was set on its own parent.            (17.1)
 *    ----------------
 */
#ifndef MESH_SPD_BALLS_H
#define MESH_SPD_BALLS_H

#include "world.h"

/* ---------------------------------------------------------------------------------------------- */

/* Three directions about (1,-1,0)/sqrt 2, each at 0, 120 and 240 degrees about z. */
static inline void balls_directions(vec3 out[9])
{
    real h = sqrt((real)0.5), tilt = asin(2 / sqrt((real)6));
    vec3 z = {0, 0, 1}, axis = {h, -h, 0}, first[3] = {{h, h, 0}, {h, 0, -h}, {0, h, -h}};
    for (int k = 0; k < 9; k++)
        out[k] = turned(turned(first[k % 3], axis, tilt), z, (real)(k / 3) * (2 * pi / 3));
}

/* Takes +z to the unit vector `to` by the shortest way: about z x to. */
static inline vec3 from_z(vec3 v, vec3 to)
{
    vec3 axis = {-to.y, to.x, 0};
    if (to.z >= (real)0.9999) return v;
    if (to.z <= (real)-0.9999) return (vec3){-v.x, v.y, -v.z};
    return turned(v, vunit(axis), acos(to.z));
}

static inline void balls_add(world *w, const vec3 d[9], sphere s, vec3 direction, int depth)
{
    world_add(w, shape_of_sphere(s));
    for (int k = 0; depth > 0 && k < 9; k++) {
        vec3 e = from_z(d[k], direction);
        sphere child = {vmadd(s.c, e, s.r * 4 / 3), s.r / 3};
        balls_add(w, d, child, vunit(e), depth - 1);
    }
}

cold_inline bool spd_balls(int scale, world *w, failure *f)
{
    size_t n = 1, shapes = 2;
    vec3 d[9];
    for (int k = 0; k < scale; k++) shapes += n *= 9;
    world_room(w, shapes, 4, 2);
    balls_directions(d);
    world_paint(w, (finish){{1, 0.75, 0.33}, 0.8, 0, 0, 0, 1});
    world_add_square(w, vec(0, 0, -0.5), 12);
    world_paint(w, (finish){{1, 0.9, 0.7}, 0.5, 0.5, 3.0827, 0, 1});
    balls_add(w, d, (sphere){{0, 0, 0}, 0.5}, (vec3){0, 0, 1}, scale);
    world_light(w, (vec3){4, 3, 2});
    world_light(w, (vec3){1, -4, 4});
    world_light(w, (vec3){-3, 1, 5});
    return world_look(w, vec(2.1, 1.3, 1.7), (vec3){0, 0, 0}, (vec3){0, 0, 1},
                      45, f);
}

#endif
