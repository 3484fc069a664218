/* scenes.h: the scenes that this chapter measures with.
 *
 *   mesh b = grid_boards(n, seed)                      large triangles, through each other
 *   camera c = grid_stadium_camera()                   so near to the small teapot of a stadium
 *                                                      that it fills the picture
 */
#ifndef GRID_SCENES_H
#define GRID_SCENES_H

#include "../../07_mesh/scenes/soup.h"
#include "../../07_mesh/scenes/stadium.h"
#include "../../09_aabb/trials/bench.h"

/* ---------------------------------------------------------------------------------------------- */

/* Across the cube of side 2: each passes through many cells, and through many others. */
static inline mesh grid_boards(size_t n, uint64_t seed)
{
    mesh m = mesh_room(n);
    for (size_t i = 0; i < 3 * n; i++) {
        random_stream g = random_start(seed, i, 4);
        m.v[i] = random_in_cube(&g, 1);
    }
    return m;
}

static inline camera grid_stadium_camera(void)
{
    mesh pot = teapot_mesh(4);
    camera c = trial_camera(&pot, 1);
    mesh_free(&pot);
    return c;
}

#endif
