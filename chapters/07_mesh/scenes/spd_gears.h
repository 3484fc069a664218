/* spd_gears.h: scale x scale x scale meshing gears, each of two 144-gons and 144 squares, and a
 * floor. A few of them are of glass.
 *
 *        _   _                 36 teeth, tau = 10 degrees apart. A tooth has four corners: at
 *      _/ \_/ \_               -+ .19 tau on .995 R, at .3 tau and .7 tau on .9 R        (17.2)
 *     \         /
 */
#ifndef MESH_SPD_GEARS_H
#define MESH_SPD_GEARS_H

#include "world.h"

enum { gear_teeth = 36, gear_corners = 4 * gear_teeth };

/* ---------------------------------------------------------------------------------------------- */

/* Counter-clockwise from above, the angles from `turn` on. */
static inline void gear_rim(vec3 centre, real R, real turn, vec3 rim[gear_corners])
{
    static const struct { double angle, radius; } tooth[4] = {
        {-0.19, 0.995}, {0.19, 0.995}, {0.3, 0.9}, {0.7, 0.9}};
    for (int k = 0; k < gear_corners; k++) {
        real angle = turn + ((real)(k / 4) + (real)tooth[k % 4].angle) * (2 * pi / gear_teeth);
        real r = R * (real)tooth[k % 4].radius;
        rim[k] = vadd(centre, (vec3){r * cos(angle), r * sin(angle), 0});
    }
}

static inline void gear_add(world *w, vec3 centre, real R, real turn, real thickness)
{
    vec3 top[gear_corners], bottom[gear_corners], upside_down[gear_corners];
    gear_rim(centre, R, turn, top);
    for (int k = 0; k < gear_corners; k++) {
        bottom[k] = vsub(top[k], (vec3){0, 0, thickness});
        upside_down[(gear_corners + 1 - k) % gear_corners] = bottom[k];
    }
    world_add_polygon(w, top, gear_corners);
    for (int k = 0; k < gear_corners; k++) {
        int next = (k + 1) % gear_corners;
        world_add_polygon(w, (vec3[]){top[k], bottom[k], bottom[next], top[next]}, 4);
    }
    world_add_polygon(w, upside_down, gear_corners);
}

static inline real gear_shade(int k, int steps)  /* the fraction of k steps of 1/7, a little more */
{
    return (real)0.01 + (real)(k * steps % 7) / 7;
}

static inline finish gear_finish(int x, int y, int z)
{
    vec3 c = {gear_shade(3 * x + 2 * y + z + 1, 5), gear_shade(3 * y + 2 * z + x + 1, 3),
              gear_shade(3 * z + 2 * x + y + 1, 2)};
    c = vscale(c, 1 / vaxis(c, vlongest(c)));
    if ((4 * x + 2 * y + z) % 5 == 0)
        return (finish){c, 0.2, 0, 0, 0.8, 1.1};
    return (finish){c, 1, 0, 0, 0, 0};
}

cold_inline bool spd_gears(int scale, world *w, failure *f)
{
    size_t gears = (size_t)scale * (size_t)scale * (size_t)scale;
    real R = 1 / ((real)scale - (real)0.05 * (real)(scale - 1)), step = (real)1.9 * R;
    real thickness = real_min(0.1, (real)0.5 / (real)scale);
    world_room(w, 1 + gears * (gear_corners + 2), 4 + gears * 6 * gear_corners, gears + 1);
    world_paint(w, (finish){{1, 0.85, 0.7}, 0.3, 0.6, 3.0827, 0, 0});
    world_add_square(w, (vec3){0, 0, 0}, 2);
    for (int z = 0; z < scale; z++)
        for (int y = 0; y < scale; y++)
            for (int x = 0; x < scale; x++) {
                vec3 c = {R - 1 + step * (real)x, R - 1 + step * (real)y,
                          1 - (real)z / (real)scale};
                world_paint(w, gear_finish(x, y, z));
                gear_add(w, c, R, (x + y + z) % 2 ? pi / 36 : 0, thickness);
            }
    world_light(w, (vec3){2, 4, 4});
    world_light(w, (vec3){-2, 4, 3});
    world_light(w, vec(2, -2.5, 2.5));
    world_light(w, (vec3){-1, -4, 2});
    world_light(w, vec(-1.111, -2.121, 2.626));
    return world_look(w, vec(-1.1, -2.1, 2.6), (vec3){0, 0, 0},
                      (vec3){0, 0, 1}, 45, f);
}

#endif
