/* forty.h: forty balls of mirror, glass and paint, the largest of them the ground: the scene that
 * speed is measured on.
 *
 *   forty f;
 *   forty_fill(&f)                  always the same balls; three suns
 *   camera c = forty_camera(aspect)
 *   tracer t = forty_tracer(&f);    for whitted_ray
 *   forty_free(&f)
 *
 * Glass casts no shadow here. So there are two parts: all balls, which are seen, and those that
 * shadow rays ask for, of which nothing but a hit is asked.
 */
#ifndef WHITTED_SCENES_FORTY_H
#define WHITTED_SCENES_FORTY_H

#include "../../02_camera/camera.h"
#include "../whitted.h"
#include "looks.h"

enum { forty_balls = 40 };

typedef struct {
    whitted w;
    shape shape[forty_balls], caster[forty_balls];
    scene scene[2];
    world_part part[2];
    trace_world world;
    whitted_material look[forty_balls], light_ground;
    medium media[forty_balls];
    light suns[3];
} forty;

/* ---------------------------------------------------------------------------------------------- */

/* x, y, z of the centre and the radius, in thousandths; by turns mirror, glass, paint. */
static const int forty_ball[forty_balls][4] = {
    {0, 0, -1000000, 1000000}, {1934, 3162, 2049, 480}, {-3768, 525, 1895, 591},
    {-3094, 553, 583, 583}, {592, -3095, 451, 451}, {3331, 2926, 353, 353},
    {-2890, 1740, 545, 545}, {2971, -1524, 251, 251}, {2979, -886, 1685, 613},
    {-2362, 4328, 2530, 501}, {-1610, -310, 581, 581}, {-3479, -789, 312, 304},
    {-150, 2437, 367, 367}, {-3817, 2798, 647, 611}, {-1071, 1428, 541, 541},
    {-2553, 4441, 267, 267}, {3437, 4336, 530, 530}, {2378, 3678, 527, 527},
    {-3271, -474, 2436, 600}, {3394, 1161, 376, 376}, {-2580, -2574, 367, 367},
    {3974, -1908, 505, 505}, {268, 47, 615, 615}, {2610, 445, 470, 470}, {3329, -2938, 271, 271},
    {-2955, 2653, 1846, 560}, {-1641, 425, 2299, 563}, {-372, 705, 1564, 611},
    {-770, -2028, 358, 358}, {2158, 2327, 430, 430}, {1198, 1445, 600, 600},
    {1179, 3181, 552, 552}, {2959, 2307, 2511, 562}, {235, -1871, 2465, 442},
    {-3567, -2132, 334, 334}, {909, -2441, 263, 263}, {647, 4466, 1308, 376},
    {-962, 4489, 1796, 610}, {-1810, 4282, 976, 447}, {-203, 1959, 2055, 475}};

static inline const whitted_material *forty_material(const void *context, trace_hit x,
                                                     const surface *s, whitted_material *room)
{
    const forty *f = context;
    (void)room;
    if (x.h.shape == 0 && (((int)floor(s->p.x) + (int)floor(s->p.y)) & 1)) return &f->light_ground;
    return &f->look[x.h.shape];
}

static inline void forty_ball_fill(forty *f, int k)
{
    const int *b = forty_ball[k];
    vec3 c = {(real)b[0] / 1000, (real)b[1] / 1000, (real)b[2] / 1000};
    f->shape[k] = shape_of_sphere((sphere){c, (real)b[3] / 1000});
    f->media[k] = (medium){k % 3 == 2 ? (real)1.5 : 1, {0, 0, 0}, 0};
    if (k % 3 == 1) f->look[k] = whitted_mirror(0.9);
    else if (k % 3 == 2) f->look[k] = whitted_clear((uint32_t)k, 1);
    else f->look[k] = whitted_paint(0.3 + 0.15 * (k * 7 % 5), 0.3 + 0.15 * (k * 3 % 5),
                                    0.3 + 0.1 * (k * 11 % 7));
    if (f->look[k].shadow == 0) f->caster[f->scene[1].n++] = f->shape[k];
}

static inline void forty_fill(forty *f)
{
    static const double sun[3][4] = {{5, -6, 9, 2}, {-6, -4, 5, 0.7}, {1, 8, 6, 0.4}};
    *f = (forty){.scene = {{f->shape, forty_balls}, {f->caster, 0}}};
    for (int k = 0; k < forty_balls; k++) forty_ball_fill(f, k);
    f->look[0] = whitted_paint(0.3, 0.3, 0.3), f->light_ground = whitted_paint(0.8, 0.8, 0.8);
    for (int k = 0; k < 3; k++) {
        const double *s = sun[k];
        f->suns[k] = (light){LIGHT_DIRECTIONAL, vunit(vec(s[0], s[1], s[2])),
                             {(real)s[3], (real)s[3], (real)s[3]}};
    }
    world_part_of_scene(&f->scene[0], MASK_SEEN, &f->part[0]);
    world_part_of_scene(&f->scene[1], MASK_SHADOW, &f->part[1]);
    f->part[1].opaque = true;
    f->world = (trace_world){f->part, 2};
    f->w = (whitted){.lights = f->suns, .n = 3, .material_of = forty_material, .context = f,
                     .media = f->media, .depth = 8, .least = (real)1 / 256, .apart = true,
                     .background = {0.35, 0.55, 0.85}, .ambient = {0.1, 0.1, 0.1}};
}

static inline void forty_free(forty *f)
{
    world_part_free(&f->part[0]), world_part_free(&f->part[1]);
}

static inline tracer forty_tracer(const forty *f)
{
    return (tracer){.w = &f->world, .program = whitted_programs, .user = &f->w};
}

static inline camera forty_camera(real aspect)
{
    failure why;
    camera_frame f;
    camera c;
    const vec3 eye = {0, -11, 4.5}, to = {0, 0.4, 0.9}, up = {0, 0, 1};
    if (!frame_look_at(eye, to, up, &f, &why)) fail(why);
    if (!camera_perspective(f, 31, aspect, &c, &why)) fail(why);
    return c;
}

#endif
