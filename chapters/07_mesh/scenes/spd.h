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
 *   spd_print_digits(&w, &f)         rounds view and shapes to the six digits of the files that
 *                                    were traced. Some rays pass an outline so closely that
 *                                    the seventh digit decides
 *
 *   hits of 263169      balls    gears    mount    tetra   tree
 *   published           263169   245332   173685   49950   169907
 *   six digits, here    263169   245332   173686   49950   169909
 *   all digits, here    263169   245332   173686   49949   169911
 *
 * Sources: E. Haines, "A Proposal for Standard Graphics Environments", IEEE CG&A 7(11), 1987, and
 * the documentation of its programs; V. Havran, "Heuristic Ray Shooting Algorithms", PhD thesis,
 * Prague 2000 (the columns that comparisons print).
 */
#ifndef MESH_SPD_H
#define MESH_SPD_H

#include "spd_balls.h"
#include "spd_gears.h"
#include "spd_mount.h"
#include "spd_rings.h"
#include "spd_teapot.h"
#include "spd_tetra.h"
#include "spd_tree.h"

enum { spd_scenes = 7, spd_edge = 512, spd_rays = (spd_edge + 1) * (spd_edge + 1) };

static const generator spd_list[spd_scenes] = {
    {"balls", 4, 1, 6, spd_balls, 263169},   {"gears", 4, 1, 20, spd_gears, 245332},
    {"mount", 6, 1, 9, spd_mount, 173685},   {"rings", 7, 1, 30, spd_rings, 0},
    {"teapot", 12, 1, 100, spd_teapot, 0},   {"tetra", 6, 1, 9, spd_tetra, 49950},
    {"tree", 11, 0, 17, spd_tree, 169907}};

/* ---------------------------------------------------------------------------------------------- */

/* False with exit code 2: no such scene, or no such scale. */
static inline bool spd_world(const char *name, int scale, world *out, failure *f)
{
    const generator *g = generator_find(spd_list, spd_scenes, name);
    if (!g) return failed(f, 2, "%.100s: the scenes are balls, gears, mount, rings, teapot, tetra, "
                                "tree", name);
    return world_make(g, scale, out, f);
}

static inline ray spd_ray(const world *w, int i, int j)
{
    return world_ray(w, (real)(2 * i) / spd_edge - 1, 1 - (real)(2 * j) / spd_edge);
}

static inline real six_digits(real x)  /* as %g prints it */
{
    char text[32];
    snprintf(text, sizeof text, "%g", (double)x);
    return (real)strtod(text, NULL);
}

static inline vec3 six_digits_of(vec3 p)
{
    return (vec3){six_digits(p.x), six_digits(p.y), six_digits(p.z)};
}

static inline void shape_six_digits(shape *s)
{
    switch (s->kind) {
    case SHAPE_SPHERE: {
        sphere *b = &s->sphere;
        *b = (sphere){six_digits_of(b->c), six_digits(b->r)};
        return;
    }
    case SHAPE_CONE: {
        cone *c = &s->cone;
        *c = (cone){six_digits_of(c->a), six_digits(c->ra), six_digits_of(c->b), six_digits(c->rb)};
        return;
    }
    case SHAPE_TRIANGLE: {
        triangle *t = &s->triangle;
        *t = (triangle){six_digits_of(t->a), six_digits_of(t->b), six_digits_of(t->c)};
        return;
    }
    case SHAPE_POLYGON: s->polygon = polygon_of(s->polygon.v, s->polygon.n); return;
    case SHAPE_OTHER: return;
    }
}

static inline bool spd_print_digits(world *w, failure *f)
{
    for (size_t i = 0; i < w->corners; i++) w->corner[i] = six_digits_of(w->corner[i]);
    for (size_t i = 0; i < w->n; i++) shape_six_digits(&w->shape[i]);
    return world_look(w, six_digits_of(w->from), six_digits_of(w->at), six_digits_of(w->up),
                      w->angle, f);
}

#endif
