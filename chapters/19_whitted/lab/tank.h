/* tank.h: a glass tank full of water, in which a glass ball holds a bubble: nested bodies, and
 * faces that coincide.
 *
 *      |#|            |#|      body 1, glass: the outer box, and the cavity's walls, turned inwards
 *      |#|~~~~~~~~~~~~|#|      body 2, water: a box with the very same walls: each ray to the water
 *      |#|  (ball)    |#|      meets two faces at the same t
 *      |################|      bodies 3, 4: a ball of glass, and the air in it
 *    ------- table -------     the tank stands on it: glass on what is opaque
 *
 *   whitted_stage *k = tank_new();        stage_tracer(k); stage_end(k), free(k)
 *   camera c = tank_camera(aspect);
 *
 * k->w.apart = true is the naive way: faces that touch are taken one by one, and the second one is
 * passed unseen.
 */
#ifndef WHITTED_LAB_TANK_H
#define WHITTED_LAB_TANK_H

#include "../scenes/whitted_stage.h"

enum { tank_table, tank_stone = 21 };  /* shapes */

/* ---------------------------------------------------------------------------------------------- */

static inline whitted_stage *tank_new(void)
{
    whitted_stage *k = allocate(1, sizeof *k);
    vec3 in_lo = {-1.375, -0.875, 0.125}, in_hi = {1.375, 0.875, 2};
    vec3 full = {in_hi.x, in_hi.y, 1.625}, c = {0.55, -0.1, 0.8};
    k->checks = 2, k->odd = whitted_paint(0.3, 0.26, 0.22);
    stage_floor(k, vec(-9, -9, 0), vec(9, 9, 0), true, whitted_paint(0.75, 0.72, 0.66));
    stage_box(k, vec(-1.5, -1, 0), vec(1.5, 1, 2), false, whitted_clear(1, 0.95));
    stage_box(k, in_lo, in_hi, true, whitted_clear(1, 0.95));
    stage_box(k, in_lo, full, false, whitted_clear(2, 0.95));
    stage_ball(k, c, 0.55, whitted_clear(3, 0.8));
    stage_ball(k, c, 0.35, whitted_clear(4, 0.9));
    stage_ball(k, vec(-0.7, 0.2, 0.525), 0.4, whitted_paint(0.75, 0.2, 0.05));
    k->media[4] = (medium){1, {0, 0, 0}, 0};
    k->media[1] = k->media[3] = (medium){1.5, {0.18, 0.03, 0.1}, 0};
    k->media[2] = (medium){1.33, {0.25, 0.06, 0.02}, 0};
    k->light[0] = (light){LIGHT_DIRECTIONAL, vunit(vec(-1, -1.2, 3)), {3, 3, 3}};
    k->w = (whitted){.n = 1, .background = {0.55, 0.66, 0.8}, .least = (real)1 / 256,
                     .ambient = {0.2, 0.2, 0.2}};
    stage_begin(k, 12);
    return k;
}

static inline camera tank_camera(real aspect)
{
    return camera_at(vec(-2, -7, 3.1), vec(0, 0, 0.9), vec(0, 0, 1), 30, aspect);
}

#endif
