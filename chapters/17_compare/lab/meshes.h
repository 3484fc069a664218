/* meshes.h: further scenes, of triangles alone: a stadium, a soup, needles, any OBJ file.
 *
 *   world w;
 *   world_make(generator_find(mesh_list, mesh_scenes, "soup"), scale, &w, &f)
 *   mesh_world(&w, "soup", soup_mesh(n), z_up, &f)    view and light from the size of the mesh,
 *                                                     which w then owns; false: nothing in it
 *
 *   soup_mesh(n)       n small triangles anywhere in a cube: no surface, no order         [1, 2^24]
 *   thin_mesh(n)       n triangles as long as the cube and 1/1000 as wide, at odd angles: their
 *                      boxes are empty but for a line, and overlap all over               [1, 2^24]
 *   stadium_mesh(k)    10_grid/stadium.h: the teapot in a stadium
 *
 *   scale: of stadium, k; of soup, thousands of triangles; of needles, hundreds
 */
#ifndef MESHES_H
#define MESHES_H

#include "../../../common/random.h"
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

static inline mesh loose_mesh(size_t n)  /* room for n triangles that share no corner */
{
    mesh m = {.vertices = 3 * n, .triangles = n};
    m.v = allocate(m.vertices, sizeof *m.v);
    m.index = allocate(m.vertices, sizeof *m.index);
    for (size_t i = 0; i < m.vertices; i++) m.index[i] = (uint32_t)i;
    return m;
}

static inline vec3 cube_point(random_stream *g, real half)
{
    real x = 2 * random_next(g) - 1, y = 2 * random_next(g) - 1, z = 2 * random_next(g) - 1;
    return vscale((vec3){x, y, z}, half);
}

/* Corners within 1 / cbrt(n) of a point: about as many rays pass through as are stopped. */
static inline mesh soup_mesh(size_t n)
{
    mesh m = loose_mesh(n);
    real size = 1 / cbrt((real)n);
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(1701, i, 0);
        vec3 c = cube_point(&g, 1);
        for (size_t k = 0; k < 3; k++) m.v[3 * i + k] = vadd(c, cube_point(&g, size));
    }
    return m;
}

static inline mesh thin_mesh(size_t n)
{
    mesh m = loose_mesh(n);
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(1702, i, 0);
        vec3 *v = m.v + 3 * i;
        v[0] = cube_point(&g, 1), v[1] = cube_point(&g, 1);
        v[2] = vadd(v[0], cube_point(&g, 1e-3));
    }
    return m;
}

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
    return mesh_world(w, "soup", soup_mesh(1000 * (size_t)thousands), true, f);
}

static inline bool make_needles(int hundreds, world *w, failure *f)
{
    return mesh_world(w, "needles", thin_mesh(100 * (size_t)hundreds), true, f);
}

#endif
