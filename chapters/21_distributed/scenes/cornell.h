/* cornell.h: the Cornell box (康奈尔盒), a room that was built, measured and drawn to compare.
 *
 *        ____________          mesh m = cornell_mesh();         38 triangles, open to the camera
 *       /   light   /|         cornell_of(i)                    what triangle i is part of
 *      /__=======__/ |         cornell_reflectance[part]        diffuse albedo, RGB [0, 1]
 *     |            | |         cornell_radiance                 of the light, downwards [W/m^2/sr]
 *  red|  []   []   | |green    cornell_corner, _side_s, _side_t the light is corner + [0,1] s + t
 *     |____________|/          cornell_camera(aspect)           from outside, through the open side
 *
 * Units are millimetres, y is up, x runs from the green wall (on the right, x = 0) to the red one.
 * All triangles face the room, those of the blocks outwards. The ceiling has a hole that the light
 * fills: the two share edges and no area. The blocks have no bottoms. Walls lean by some
 * millimetres, as the real ones did.
 *
 * Sources: C. Goral et al., "Modeling the Interaction of Light Between Diffuse Surfaces", SIGGRAPH
 * 1984; Cornell University Program of Computer Graphics, "The Cornell Box", measured data, 1998.
 * The three numbers a colour are the usual simplification of the measured spectra (M. McGuire,
 * Computer Graphics Archive, 2017); the reflectance of the light is the measured one.
 */
#ifndef DISTRIBUTED_CORNELL_H
#define DISTRIBUTED_CORNELL_H

#include "../../02_camera/camera.h"
#include "../../07_mesh/mesh.h"

typedef enum {
    CORNELL_WHITE, CORNELL_RED, CORNELL_GREEN, CORNELL_LIGHT, cornell_parts
} cornell_part;
enum { cornell_triangles = 38, cornell_room = 18 };  /* those of the room come first */

static const vec3 cornell_reflectance[cornell_parts] = {
    {0.725, 0.71, 0.68}, {0.63, 0.065, 0.05},
    {0.14, 0.45, 0.091}, {0.78, 0.78, 0.78}};
static const vec3 cornell_radiance = {17, 12, 4};
static const vec3 cornell_corner = {343, 548.8, 227};
static const vec3 cornell_side_s = {0, 0, 105}, cornell_side_t = {-130, 0, 0};  /* s x t: down */

/* ---------------------------------------------------------------------------------------------- */

/* Quadrilaterals a b c d, as two triangles a b c and a c d each. Ceiling: one for each side of its
 * hole, from the edge of the room to that of the light. */
enum { cornell_quads = cornell_triangles / 2 };
static const double cornell_points[][3] = {
    {552.8, 0, 0}, {0, 0, 0}, {0, 0, 559.2}, {549.6, 0, 559.2},                     /* floor */
    {556, 548.8, 0}, {556, 548.8, 559.2}, {0, 548.8, 559.2}, {0, 548.8, 0},      /* ceiling */
    {343, 548.8, 227}, {343, 548.8, 332}, {213, 548.8, 332}, {213, 548.8, 227},     /* light */
    {130, 165, 65}, {82, 165, 225}, {240, 165, 272}, {290, 165, 114},                   /* short */
    {130, 0, 65}, {82, 0, 225}, {240, 0, 272}, {290, 0, 114},
    {423, 330, 247}, {265, 330, 296}, {314, 330, 456}, {472, 330, 406},                 /* tall */
    {423, 0, 247}, {265, 0, 296}, {314, 0, 456}, {472, 0, 406}};
static const struct { uint8_t corner[4]; uint8_t part; } cornell_quad[cornell_quads] = {
    {{0, 1, 2, 3}, CORNELL_WHITE},                                                      /* floor */
    {{4, 5, 9, 8}, CORNELL_WHITE}, {{5, 6, 10, 9}, CORNELL_WHITE},                     /* ceiling */
    {{6, 7, 11, 10}, CORNELL_WHITE}, {{7, 4, 8, 11}, CORNELL_WHITE},
    {{3, 2, 6, 5}, CORNELL_WHITE},                                                      /* back */
    {{2, 1, 7, 6}, CORNELL_GREEN}, {{0, 3, 5, 4}, CORNELL_RED},
    {{8, 9, 10, 11}, CORNELL_LIGHT},
    {{12, 13, 14, 15}, CORNELL_WHITE}, {{12, 16, 17, 13}, CORNELL_WHITE},               /* short */
    {{13, 17, 18, 14}, CORNELL_WHITE}, {{14, 18, 19, 15}, CORNELL_WHITE},
    {{15, 19, 16, 12}, CORNELL_WHITE},
    {{20, 21, 22, 23}, CORNELL_WHITE}, {{20, 24, 25, 21}, CORNELL_WHITE},               /* tall */
    {{21, 25, 26, 22}, CORNELL_WHITE}, {{22, 26, 27, 23}, CORNELL_WHITE},
    {{23, 27, 24, 20}, CORNELL_WHITE}};

static inline cornell_part cornell_of(size_t i)
{
    return (cornell_part)cornell_quad[i / 2].part;
}

/* To be freed with mesh_free. */
static inline mesh cornell_mesh(void)
{
    enum { n = sizeof cornell_points / sizeof *cornell_points };
    mesh m = {.v = allocate(n, sizeof *m.v), .vertices = n, .triangles = cornell_triangles,
              .index = allocate(cornell_triangles, 3 * sizeof *m.index)};
    for (int i = 0; i < n; i++) {
        const double *p = cornell_points[i];
        m.v[i] = vec(p[0], p[1], p[2]);
    }
    for (int i = 0; i < cornell_triangles; i++) {
        const uint8_t *c = cornell_quad[i / 2].corner;
        for (int k = 0; k < 3; k++) m.index[3 * i + k] = c[k ? k + i % 2 : 0];
    }
    return m;
}

/* Film .025 wide, focal length .035: 39.3 degrees both ways if aspect = width / height = 1. */
static inline camera cornell_camera(real aspect)
{
    real view = 2 * atan((real)0.0125 / (real)0.035) * 180 / pi;
    return camera_at((vec3){278, 273, -800}, (vec3){278, 273, 0}, (vec3){0, 1, 0}, view, aspect);
}

#endif
