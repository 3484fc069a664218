/* scenes.h: the scenes that this chapter measures with.
 *
 *   mesh m = grid_soup(n, seed)                        small triangles
 *   mesh b = grid_boards(n, seed)                      large ones, through each other
 *   camera c = grid_stadium_camera()                   so near to the small teapot of a stadium
 *                                                      that it fills the picture
 */
#ifndef GRID_SCENES_H
#define GRID_SCENES_H

#include "../../07_mesh/scenes/soup.h"
#include "../../07_mesh/scenes/stadium.h"
#include "../../09_aabb/trials/bench.h"

/* ---------------------------------------------------------------------------------------------- */

/* Edges about half as long as the triangles are apart. */
static inline mesh grid_soup(size_t n, uint64_t seed)
{
    return soup_mesh(n, 0.5, (real)cbrt(1 / (double)n) / 2, seed);
}

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
