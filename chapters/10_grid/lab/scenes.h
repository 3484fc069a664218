/* scenes.h: the scenes and rays that this chapter measures with.
 *
 *   grid_scene_of(GRID_STADIUM, seed, &s)              a trial_scene, with rays; trial_scene_free
 *   mesh m = grid_soup(n, seed)                        small triangles
 *   mesh b = grid_boards(n, seed)                      large ones, through each other
 *   camera c = grid_stadium_camera(aspect)             so near to the small teapot that it fills
 *                                                      the picture
 *
 *   teapot       36672 triangles; lines from everywhere through its box
 *   triangles    20000, in any place and at any angle; likewise
 *   spheres      20000 of 0.3 of their mean distance; likewise
 *   stadium      a teapot of 16256 triangles in one of 4032 that is 100 times as large, seen from
 *                a place near the small one
 */
#ifndef GRID_SCENES_H
#define GRID_SCENES_H

#include "../../07_mesh/scenes/soup.h"
#include "../../07_mesh/scenes/stadium.h"
#include "../../09_aabb/trials/bench.h"

typedef enum { GRID_TEAPOT, GRID_TRIANGLES, GRID_SPHERES, GRID_STADIUM, grid_scenes } grid_scene;
static const char *const grid_scene_name[grid_scenes] = {"teapot", "triangles", "spheres",
                                                         "stadium"};

/* ---------------------------------------------------------------------------------------------- */

/* Edges about half as long as the triangles are apart. */
static inline mesh grid_soup(size_t n, uint64_t seed)
{
    return soup_mesh(n, 0.5, (real)cbrt(1 / (double)n) / 2, seed);
}

/* Across the cube of side 2: each passes through many cells, and through many others. */
static inline mesh grid_boards(size_t n, uint64_t seed)
{
    mesh m = grid_soup(n, seed);
    for (size_t i = 0; i < 3 * n; i++) {
        random_stream g = random_start(seed, i, 4);
        m.v[i] = random_in_cube(&g, 1);
    }
    return m;
}

static inline shape *grid_spheres(size_t n, uint64_t seed)
{
    shape *s = allocate(n, sizeof *s);
    real r = (real)(0.3 * cbrt(1 / (double)n));
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(seed, i, 1);
        s[i] = shape_of_sphere((sphere){random_in_cube(&g, 0.5), r});
    }
    return s;
}

static inline camera grid_stadium_camera(real aspect)
{
    mesh pot = teapot_mesh(4);
    camera c = trial_camera(&pot, aspect);
    mesh_free(&pot);
    return c;
}

static inline void grid_scene_of(grid_scene kind, uint64_t seed, trial_scene *out)
{
    const size_t n = 20000;
    failure f;
    aabb box;
    if (kind == GRID_SPHERES) trial_scene_of_shapes(grid_spheres(n, seed), n, out);
    else trial_scene_of(kind == GRID_TEAPOT ? teapot_mesh(24) : kind == GRID_TRIANGLES
                        ? grid_soup(n, seed) : stadium_mesh(16), out);
    if (!items_all_bounds(&out->x, &box, &f)) fail(f);
    out->rays[TRIAL_UNIFORM] = kind == GRID_STADIUM
        ? rays_primary(grid_stadium_camera(1), 14, 14) : rays_uniform(box, 1500, seed);
}

#endif
