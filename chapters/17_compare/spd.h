/* spd.h: the Standard Procedural Databases: seven scenes that acceleration structures have been
 * compared on since 1987. Each is a few lines, and any size.
 *
 *   world w;
 *   if (!spd_world("balls", 4, &w, &f)) fail(f);      world_free(&w)
 *
 *   scene    default  shapes at that size                              scale
 *   balls    4        7381 spheres + 1 square                          [1, 6]
 *   gears    4        128 144-gons + 9216 squares + 1                  [1, 20]
 *   mount    6        8192 triangles + 4 spheres                       [1, 9]
 *   rings    7        4200 spheres + 4200 cylinders + 1                [1, 30]
 *   teapot   12       9120 triangles + 144 squares                     [1, 100]
 *   tetra    6        4096 triangles                                   [1, 9]
 *   tree     11       4095 cones + 4095 spheres + 1                    [0, 17]
 *
 * The protocol of the published results: 513^2 rays through the corners of 512^2 pixels (17.7).
 *
 *   ray r = spd_ray(&w, i, j)        i, j = 0 .. 512, from left to right and from top to bottom:
 *                                    x = tan(22.5 deg) (2 i / 512 - 1), y likewise
 *
 * Sources: E. Haines, "A Proposal for Standard Graphics Environments", IEEE CG&A 7(11), 1987, and
 * the documentation of its programs; V. Havran, "Heuristic Ray Shooting Algorithms", PhD thesis,
 * Prague 2000 (the columns that comparisons print).
 */
#ifndef SPD_H
#define SPD_H

#include "spd_balls.h"
#include "spd_gears.h"
#include "spd_mount.h"
#include "spd_rings.h"
#include "spd_teapot.h"
#include "spd_tetra.h"
#include "spd_tree.h"

enum { spd_scenes = 7, spd_edge = 512, spd_rays = (spd_edge + 1) * (spd_edge + 1) };

/* hits: published, of the spd_rays primary rays at the default scale; 0: none is */
typedef struct {
    const char *name;
    int scale, least, most;
    bool (*make)(int scale, world *out, failure *f);
    size_t hits;
} spd_scene;

static const spd_scene spd_list[spd_scenes] = {
    {"balls", 4, 1, 6, spd_balls, 263169},   {"gears", 4, 1, 20, spd_gears, 245332},
    {"mount", 6, 1, 9, spd_mount, 173685},   {"rings", 7, 1, 30, spd_rings, 0},
    {"teapot", 12, 1, 100, spd_teapot, 0},   {"tetra", 6, 1, 9, spd_tetra, 49950},
    {"tree", 11, 0, 17, spd_tree, 169907}};

/* ---------------------------------------------------------------------------------------------- */

static inline const spd_scene *spd_find(const char *name)
{
    for (int k = 0; k < spd_scenes; k++)
        if (strcmp(spd_list[k].name, name) == 0) return &spd_list[k];
    return NULL;
}

/* False with exit code 2: no such scene, or no such size. */
static inline bool spd_world(const char *name, int scale, world *out, failure *f)
{
    const spd_scene *s = spd_find(name);
    *out = (world){0};
    if (!s) return failed(f, 2, "%.100s: the scenes are balls, gears, mount, rings, teapot, tetra, "
                                "tree", name);
    if (scale < s->least || scale > s->most)
        return failed(f, 2, "%s %d: allowed are sizes from %d to %d", name, scale, s->least, s->most);
    if (!s->make(scale, out, f)) return false;
    out->name = s->name;
    out->background = (vec3){(real)0.078, (real)0.361, (real)0.753};
    out->light_each = sqrt((real)out->lights) / (2 * (real)out->lights);
    return true;
}

static inline ray spd_ray(const world *w, int i, int j)
{
    return world_ray(w, (real)(2 * i) / spd_edge - 1, 1 - (real)(2 * j) / spd_edge);
}

#endif
