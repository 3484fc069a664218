/* scenes.h: all the scenes of this chapter by name, and which of them a run shows.
 *
 *   const generator *g = scene_find("soup");    of spd.h or meshes.h; NULL: no such name
 *   scene_world(g, scale, &w, &f)               as world_make; scenes of triangles alone as a mesh
 */
#ifndef SCENES_H
#define SCENES_H

#include "meshes.h"
#include "../../07_mesh/scenes/spd.h"

typedef struct { const char *name; int quick, full; } scene_sizes;  /* scales beside the usual */

enum { scenes = spd_scenes + mesh_scenes };
static const scene_sizes scene_list[scenes] = {
    {"balls", 2, 5},  {"gears", 1, 9},    {"mount", 3, 8},    {"rings", 2, 17},
    {"teapot", 3, 40}, {"tetra", 3, 8},   {"tree", 5, 15},    {"stadium", 4, 64},
    {"soup", 1, 1000}, {"needles", 2, 100}};

/* ---------------------------------------------------------------------------------------------- */

static inline const generator *scene_find(const char *name)
{
    const generator *g = generator_find(spd_list, spd_scenes, name);
    return g ? g : generator_find(mesh_list, mesh_scenes, name);
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
