/* tank.h: a glass tank full of water, in which a glass ball holds a bubble: nested bodies, and
 * faces that coincide.
 *
 *      |#|            |#|      body 1, glass: the outer box, and the cavity's walls, turned inwards
 *      |#|~~~~~~~~~~~~|#|      body 2, water: a box with the very same walls: each ray to the water
 *      |#|  (ball)    |#|      meets two faces at the same t
 *      |################|      bodies 3, 4: a ball of glass, and the air in it
 *    ------- table -------     the tank stands on it: glass on what is opaque
 *
 *   tank *k = tank_new();  tank_free(k)
 *   camera c = tank_camera(aspect);  tracer t = tank_tracer(k)
 *
 * k->w.apart = true is the naive way: faces that touch are taken one by one, and the second one is
 * passed unseen.
 */
#ifndef WHITTED_LAB_TANK_H
#define WHITTED_LAB_TANK_H

#include "../../02_camera/camera.h"
#include "../scenes/looks.h"
#include "../whitted.h"

enum { tank_table, tank_outer, tank_cavity = 7, tank_water = 13, tank_ball = 19, tank_bubble,
       tank_stone, tank_shapes };

typedef struct {
    whitted w;
    shape shape[tank_shapes];
    vec3 corner[76];
    scene scene;
    world_part part;
    trace_world world;
    whitted_material look[tank_shapes], dark;
    medium media[5];
    light lights[2];
} tank;

/* ---------------------------------------------------------------------------------------------- */

static inline const whitted_material *tank_material(const void *context, trace_hit x,
                                                    const surface *s, whitted_material *room)
{
    const tank *w = context;
    (void)room;
    bool odd = ((int)floor(2 * s->p.x) + (int)floor(2 * s->p.y)) & 1;
    return x.h.shape == tank_table && odd ? &w->dark : &w->look[x.h.shape];
}

static inline tank *tank_new(void)
{
    tank *k = allocate(1, sizeof *k);
    for (int i = 0; i < 4; i++)
        k->corner[72 + i] = (vec3){i == 1 || i == 2 ? 9 : -9, i > 1 ? 9 : -9, 0};
    k->shape[tank_table] = shape_of_polygon(polygon_of(k->corner + 72, 4));
    vec3 lo = {-1.5, -1, 0}, hi = {1.5, 1, 2};
    vec3 in_lo = {-1.375, -0.875, 0.125}, in_hi = {1.375, 0.875, 2};
    vec3 full = {in_hi.x, in_hi.y, 1.625};
    box_faces(lo, hi, false, k->corner, k->shape + tank_outer);
    box_faces(in_lo, in_hi, true, k->corner + 24, k->shape + tank_cavity);
    box_faces(in_lo, full, false, k->corner + 48, k->shape + tank_water);
    vec3 c = {0.55, -0.1, 0.8};
    k->shape[tank_ball] = shape_of_sphere((sphere){c, 0.55});
    k->shape[tank_bubble] = shape_of_sphere((sphere){c, 0.35});
    vec3 stone = {-0.7, 0.2, 0.525};
    k->shape[tank_stone] = shape_of_sphere((sphere){stone, 0.4});
    for (int i = 0; i < 6; i++) {
        k->look[tank_outer + i] = k->look[tank_cavity + i] = whitted_clear(1, 0.95);
        k->look[tank_water + i] = whitted_clear(2, 0.95);
    }
    k->look[tank_ball] = whitted_clear(3, 0.8);
    k->look[tank_bubble] = whitted_clear(4, 0.9);
    k->look[tank_stone] = whitted_paint(0.75, 0.2, 0.05);
    k->look[tank_table] = whitted_paint(0.75, 0.72, 0.66), k->dark = whitted_paint(0.3, 0.26, 0.22);
    k->media[0] = k->media[4] = (medium){1, {0, 0, 0}, 0};
    k->media[1] = k->media[3] = (medium){1.5, {0.18, 0.03, 0.1}, 0};
    k->media[2] = (medium){1.33, {0.25, 0.06, 0.02}, 0};
    k->lights[0] = (light){LIGHT_DIRECTIONAL, vunit(vec(-1, -1.2, 3)), {3, 3, 3}};
    k->scene = (scene){k->shape, tank_shapes};
    world_part_of_scene(&k->scene, MASK_ALL, &k->part);
    k->world = (trace_world){&k->part, 1};
    k->w = (whitted){.lights = k->lights, .n = 1, .material_of = tank_material, .context = k,
                     .media = k->media, .background = {0.55, 0.66, 0.8},
                     .depth = 12, .least = (real)1 / 256,
                     .ambient = {0.2, 0.2, 0.2}};
    return k;
}

static inline void tank_free(tank *k)
{
    world_part_free(&k->part);
    free(k);
}

static inline tracer tank_tracer(const tank *k)
{
    return (tracer){.w = &k->world, .program = whitted_programs, .user = &k->w};
}

static inline camera tank_camera(real aspect)
{
    failure why;
    camera_frame f;
    camera c;
    const vec3 eye = {-2, -7, 3.1}, to = {0, 0, 0.9}, up = {0, 0, 1};
    if (!frame_look_at(eye, to, up, &f, &why) || !camera_perspective(f, 30, aspect, &c, &why))
        fail(why);
    return c;
}

#endif
