/* two_spheres.h: a glass ball and a mirror ball over a chequered floor, after the picture by which
 * T. Whitted showed in 1980 what a recursion is good for.
 *
 *   whitted_stage *s = two_spheres_new();      stage_tracer(s); stage_end(s), free(s)
 *   camera c = two_spheres_camera(aspect)
 *
 * The glass ball is hollow: a ball of air in it, nested. So the floor is seen through it upright,
 * but for a rim.
 */
#ifndef WHITTED_LAB_TWO_SPHERES_H
#define WHITTED_LAB_TWO_SPHERES_H

#include "../scenes/whitted_stage.h"

enum { two_floor, two_glass, two_air, two_mirror, two_shapes };

/* ---------------------------------------------------------------------------------------------- */

/* Darker blue overhead. */
static inline vec3 two_spheres_sky(const void *context, vec3 d)
{
    const vec3 low = {0.42, 0.62, 0.92}, high = {0.1, 0.22, 0.62};
    real up = sqrt(real_clamp(d.z, 0, 1));
    (void)context;
    return vadd(vscale(low, 1 - up), vscale(high, up));
}

static inline whitted_stage *two_spheres_new(void)
{
    whitted_stage *s = allocate(1, sizeof *s);
    vec3 glass = {-0.45, -1.9, 2.05}, mirror = {0.95, 0.9, 1.12}, shine = {0.6, 0.6, 0.6};
    s->w = (whitted){.n = 1, .sky = two_spheres_sky, .least = (real)1 / 256, .apart = true,
                     .ambient = {0.16, 0.17, 0.2}};
    s->light[0] = (light){LIGHT_DIRECTIONAL, vunit(vec(-0.6, -0.75, 1.3)), {2.9, 2.8, 2.6}};
    s->media[2] = (medium){1, {0, 0, 0}, 0}, s->media[1] = (medium){1.5, {0.3, 0.06, 0.12}, 0};
    s->checks = 1, s->odd = whitted_paint(0.8, 0.62, 0.04);
    stage_floor(s, vec(-6, -6, 0), vec(4, 18, 0), true, whitted_paint(0.62, 0.025, 0.02));
    stage_ball(s, glass, 1, whitted_clear(1, 0.75));
    stage_ball(s, glass, 0.93, whitted_clear(2, 0.85));
    stage_ball(s, mirror, 0.95, whitted_mirror(0.82));
    material *mirror_look = &s->look[two_mirror].base, *glass_look = &s->look[two_glass].base;
    mirror_look->kd = vec(0.06, 0.07, 0.07), mirror_look->ks = shine, mirror_look->shine = 300;
    glass_look->ks = shine, glass_look->shine = 900;
    stage_begin(s, 8);
    return s;
}

static inline camera two_spheres_camera(real aspect)
{
    return camera_at(vec(-0.35, -9, 2.3), vec(-0.05, 0, 1.75), vec(0, 0, 1), 32, aspect);
}

#endif
