/* two_spheres.h: a glass ball and a mirror ball over a chequered floor, after the picture by which
 * T. Whitted showed in 1980 what a recursion is good for.
 *
 *   two_spheres *s = two_spheres_new();        two_spheres_free(s)
 *   camera c = two_spheres_camera(aspect)
 *   tracer t = two_spheres_tracer(s)           whitted_ray(&t, r, (media_set){0})
 *
 * The glass ball is hollow: a ball of air in it, nested. So the floor is seen through it upright,
 * but for a rim.
 */
#ifndef WHITTED_LAB_TWO_SPHERES_H
#define WHITTED_LAB_TWO_SPHERES_H

#include "../../02_camera/camera.h"
#include "../scenes/looks.h"
#include "../whitted.h"

enum { two_floor, two_glass, two_air, two_mirror, two_shapes };

typedef struct {
    whitted w;
    shape shape[two_shapes];
    vec3 corner[4];
    scene scene;
    world_part part;
    trace_world world;
    whitted_material look[two_shapes], yellow;
    medium media[3];
    light lights[2];
} two_spheres;

/* ---------------------------------------------------------------------------------------------- */

static inline const whitted_material *two_spheres_material(const void *context, trace_hit x,
                                                           const surface *s, whitted_material *room)
{
    const two_spheres *w = context;
    (void)room;
    bool odd = ((int)floor(s->p.x) + (int)floor(s->p.y)) & 1;
    return x.h.shape == two_floor && odd ? &w->yellow : &w->look[x.h.shape];
}

/* Darker blue overhead. */
static inline vec3 two_spheres_sky(const void *context, vec3 d)
{
    const vec3 low = {0.42, 0.62, 0.92};
    const vec3 high = {0.1, 0.22, 0.62};
    real up = sqrt(real_clamp(d.z, 0, 1));
    (void)context;
    return vadd(vscale(low, 1 - up), vscale(high, up));
}

static inline two_spheres *two_spheres_new(void)
{
    two_spheres *s = allocate(1, sizeof *s);
    for (int k = 0; k < 4; k++)  /* from x = -6 to 4, y = -6 to 18 */
        s->corner[k] = (vec3){k == 1 || k == 2 ? 4 : -6, k > 1 ? 18 : -6, 0};
    vec3 glass = {-0.45, -1.9, 2.05};
    vec3 mirror = {0.95, 0.9, 1.12};
    s->shape[two_floor] = shape_of_polygon(polygon_of(s->corner, 4));
    s->shape[two_glass] = shape_of_sphere((sphere){glass, 1});
    s->shape[two_air] = shape_of_sphere((sphere){glass, 0.93});
    s->shape[two_mirror] = shape_of_sphere((sphere){mirror, 0.95});
    s->look[two_floor] = whitted_paint(0.62, 0.025, 0.02);
    s->yellow = whitted_paint(0.8, 0.62, 0.04);
    s->look[two_glass] = whitted_clear(1, 0.75);
    s->look[two_air] = whitted_clear(2, 0.85);
    s->look[two_mirror] = whitted_mirror(0.82);
    s->look[two_mirror].base.kd = vec(0.06, 0.07, 0.07);
    vec3 shine = {0.6, 0.6, 0.6};
    s->look[two_mirror].base.ks = s->look[two_glass].base.ks = shine;
    s->look[two_mirror].base.shine = 300, s->look[two_glass].base.shine = 900;
    s->media[0] = s->media[2] = (medium){1, {0, 0, 0}, 0};
    s->media[1] = (medium){1.5, {0.3, 0.06, 0.12}, 0};
    s->lights[0] = (light){LIGHT_DIRECTIONAL, vunit(vec(-0.6, -0.75, 1.3)),
                           {2.9, 2.8, 2.6}};
    s->scene = (scene){s->shape, two_shapes};
    world_part_of_scene(&s->scene, MASK_ALL, &s->part);
    s->world = (trace_world){&s->part, 1};
    s->w = (whitted){.lights = s->lights, .n = 1, .material_of = two_spheres_material, .context = s,
                     .media = s->media, .sky = two_spheres_sky, .depth = 8,
                     .least = (real)1 / 256, .apart = true,
                     .ambient = {0.16, 0.17, 0.2}};
    return s;
}

static inline void two_spheres_free(two_spheres *s)
{
    world_part_free(&s->part);
    free(s);
}

static inline tracer two_spheres_tracer(const two_spheres *s)
{
    return (tracer){.w = &s->world, .program = whitted_programs, .user = &s->w};
}

static inline camera two_spheres_camera(real aspect)
{
    failure why;
    camera_frame f;
    camera c;
    const vec3 eye = {-0.35, -9, 2.3}, up = {0, 0, 1};
    const vec3 to = {-0.05, 0, 1.75};
    if (!frame_look_at(eye, to, up, &f, &why) || !camera_perspective(f, 32, aspect, &c, &why))
        fail(why);
    return c;
}

#endif
