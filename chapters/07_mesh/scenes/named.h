/* named.h: all scenes by name, as 17 compares them: those of spd.h, three of triangles alone, and
 * one of solids (solids.h).
 *
 *   const generator *g = scene_find("soup");    NULL: no such name
 *   scene_world(g, scale, &w, &f)               as world_make; scenes of triangles alone as a mesh
 *   mesh_world(&w, "knot", m, z_up, &f)         any mesh, which w then owns: view and light from
 *                                               its size; false: nothing in it
 *
 *   stadium   the teapot in a stadium; scale k: stadium_mesh(k)
 *   soup      1000 k small triangles anywhere in a cube, corners within 1 / cbrt(n) of a point:
 *             about as many rays pass through as are stopped
 *   needles   100 k triangles as long as the cube and 1/1000 as wide, at odd angles
 */
#ifndef SCENES_NAMED_H
#define SCENES_NAMED_H

#include "solids.h"
#include "soup.h"
#include "spd.h"
#include "stadium.h"

/* Scales beside the usual: of tests; of the table that is printed without --full; or 0 */
typedef struct { const char *name; int quick, shown; } compare_sizes;

enum { mesh_scenes = 3, scenes = spd_scenes + mesh_scenes + 1 };
static const compare_sizes scene_list[scenes] = {
    {"balls", 2, 3}, {"gears", 1, 0}, {"mount", 3, 0}, {"rings", 2, 0}, {"teapot", 3, 6},
    {"tetra", 3, 0}, {"tree", 5, 0}, {"stadium", 4, 8}, {"soup", 1, 0}, {"needles", 2, 5},
    {"solids", 6, 0}};

/* ---------------------------------------------------------------------------------------------- */

/* From in front, to the right and above, so near that the scene fills the view; one light, higher
 * up. */
static inline bool mesh_world(world *w, const char *name, mesh m, bool z_up, failure *f)
{
    vec3 lo, hi;
    *w = (world){.name = name, .mesh = m, .background = {0.078, 0.361, 0.753}};
    if (!mesh_bounds(&m, &lo, &hi)) return failed(f, 2, "%.300s: no triangles in it", name);
    real size = vlength(vsub(hi, lo)) / 2;
    if (size == 0) return failed(f, 2, "%.300s: all of it is one point", name);
    vec3 centre = vscale(vadd(lo, hi), 0.5), up = {0, !z_up, z_up};
    vec3 toward = vunit(z_up ? vec(0.45, -1, 0.55)
                             : vec(0.45, 0.55, 1));
    w->group = allocate(1, sizeof *w->group);
    w->group[w->groups++].finish = (finish){{1, 1, 1}, 1, 0, 0, 0, 0};
    w->light_each = 0.5;
    world_light(w, vmadd(vmadd(centre, toward, 3 * size), up, 2 * size));
    failure why;
    if (world_look(w, vmadd(centre, toward, (real)2.4 * size), centre, up, 45, &why)) return true;
    return failed(f, why.exit_code, "%.200s: %.250s", name, why.text);
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

static const generator mesh_list[mesh_scenes] = {{"stadium", 32, 1, 150, make_stadium, 0},
                                                 {"soup", 100, 1, 4000, make_soup, 0},
                                                 {"needles", 50, 1, 10000, make_needles, 0}};

static const generator solids_scene = {"solids", 64, 1, 300, make_solids, 0};

static inline const generator *scene_find(const char *name)
{
    const generator *g = generator_find(spd_list, spd_scenes, name);
    if (!g) g = generator_find(mesh_list, mesh_scenes, name);
    return g ? g : generator_find(&solids_scene, 1, name);
}

/* Structures store less for the triangles of a mesh than for shapes of any kind. */
static inline void world_to_mesh(world *w)
{
    for (size_t i = 0; i < w->n; i++)
        if (w->shape[i].kind != SHAPE_TRIANGLE) return;
    if (w->n == 0) return;
    w->mesh = mesh_room(w->n);
    for (size_t i = 0; i < w->n; i++)
        memcpy(w->mesh.v + 3 * i, &w->shape[i].triangle, 3 * sizeof(vec3));
    free(w->shape);
    w->shape = NULL, w->n = 0;
}

static inline bool scene_world(const generator *g, int scale, world *out, failure *f)
{
    if (!world_make(g, scale, out, f)) return false;
    world_to_mesh(out);
    return true;
}

#endif
