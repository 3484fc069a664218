/* meshes.h: further scenes, of triangles alone: a stadium, a soup, needles, any OBJ file.
 *
 *   world w;
 *   world_make(generator_find(mesh_list, mesh_scenes, "soup"), scale, &w, &f)
 *   mesh_world(&w, "knot", m, z_up, &f)               view and light from the size of the mesh,
 *                                                     which w then owns; false: nothing in it
 *
 *   stadium   the teapot in a stadium; scale k: stadium_mesh(k)
 *   soup      1000 k small triangles anywhere in a cube, corners within 1 / cbrt(n) of a point: about
 *             as many rays pass through as are stopped
 *   needles   100 k triangles as long as the cube and 1/1000 as wide, at odd angles
 */
#ifndef MESHES_H
#define MESHES_H

#include "../../07_mesh/scenes/soup.h"
#include "../../07_mesh/scenes/stadium.h"
#include "../../07_mesh/scenes/world.h"

enum { mesh_scenes = 3 };
static inline bool make_stadium(int fine, world *w, failure *f);
static inline bool make_soup(int thousands, world *w, failure *f);
static inline bool make_needles(int hundreds, world *w, failure *f);

static const generator mesh_list[mesh_scenes] = {{"stadium", 32, 1, 150, make_stadium, 0},
                                                 {"soup", 100, 1, 4000, make_soup, 0},
                                                 {"needles", 50, 1, 10000, make_needles, 0}};

/* ---------------------------------------------------------------------------------------------- */

/* From in front, to the right and above, so near that the scene fills the view; one light, higher
 * up. */
static inline bool mesh_world(world *w, const char *name, mesh m, bool z_up, failure *f)
{
    vec3 lo, hi;
    *w = (world){.name = name, .mesh = m, .background = {0.078, 0.361, 0.753}};
    if (!mesh_bounds(&m, &lo, &hi)) return failed(f, 2, "%.300s: no triangles in it", name);
    real size = vlength(vsub(hi, lo)) / 2;
    vec3 centre = vscale(vadd(lo, hi), 0.5), up = {0, !z_up, z_up};
    vec3 toward = vunit(z_up ? vec(0.45, -1, 0.55)
                             : vec(0.45, 0.55, 1));
    w->group = allocate(1, sizeof *w->group);
    w->group[w->groups++].finish = (finish){{1, 1, 1}, 1, 0, 0, 0, 0};
    w->light_each = 0.5;
    world_light(w, vmadd(vmadd(centre, toward, 3 * size), up, 2 * size));
    return world_look(w, vmadd(centre, toward, (real)2.4 * size), centre, up, 45, f);
}

/* One looks at the teapot, not at the hall. */
static inline bool make_stadium(int fine, world *w, failure *f)
{
    vec3 lo, hi;
    mesh pot = teapot_mesh(1);
    mesh_bounds(&pot, &lo, &hi);
    mesh_free(&pot);
    if (!mesh_world(w, "stadium", stadium_mesh(fine), true, f)) return false;
    vec3 centre = vscale(vadd(lo, hi), 0.5);
    w->light[0] = vadd(centre, (vec3){4, -6, 8});
    return world_look(w, vadd(centre, (vec3){4, -8, 5}), centre, (vec3){0, 0, 1}, 45, f);
}

static inline bool make_soup(int thousands, world *w, failure *f)
{
    size_t n = 1000 * (size_t)thousands;
    return mesh_world(w, "soup", soup_mesh(n, 1, 1 / cbrt((real)n), 1701), true, f);
}

static inline bool make_needles(int hundreds, world *w, failure *f)
{
    return mesh_world(w, "needles", needle_mesh(100 * (size_t)hundreds, 1e-3, 1702), true, f);
}

#endif
