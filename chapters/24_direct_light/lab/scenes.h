/* scenes.h: what this chapter draws and measures.
 *
 *   direct_stage g; stage_open(STAGE_BOX, &g);   g.s a lit scene, g.c the camera; lit_free(&g.s)
 *
 *   STAGE_BOX      the Cornell box (21): one rectangle, matte walls
 *   STAGE_FIRST    the same as first.h has it, without leaning walls: what both versions are asked
 *   STAGE_PLATES   E. Veach's: four metal plates, smooth to rough (top to bottom), each tilted so
 *                  that it mirrors four spheres of the same flux, small to large (left to right)
 *   STAGE_STRIP    a shining wall, low and long, that stands on the floor and touches it
 *
 * Source: E. Veach, L. Guibas, "Optimally Combining Sampling Techniques for Monte Carlo Rendering",
 * SIGGRAPH 1995, figure 2.
 */
#ifndef DIRECT_SCENES_H
#define DIRECT_SCENES_H

#include "../scenes/lit_cornell.h"
#include "../scenes/lit_first.h"

typedef enum { STAGE_BOX, STAGE_FIRST, STAGE_PLATES, STAGE_STRIP } direct_stage_name;
typedef struct { lit_scene s; camera c; real aspect, exposure; } direct_stage;

/* ---------------------------------------------------------------------------------------------- */

static const vec3 plate_eye = {0, 2, 15};

static inline camera stage_camera_of(direct_stage_name name, real aspect)
{
    const vec3 up = {0, 1, 0};
    return name == STAGE_BOX ? cornell_camera(aspect)
         : name == STAGE_FIRST ? lit_first_camera()
         : name == STAGE_PLATES ? camera_at(plate_eye, vec(0, -2, 2.5), up, 28, aspect)
                                : camera_at(vec(0, 2.2, 3), vec(0, .05, -1), up, 30, aspect);
}

static inline uint16_t stage_matte(lit_scene *s, double r, double g, double b)
{
    return lit_add_material(s, (material){.kd = vec(r, g, b)});
}

static inline uint16_t stage_lamp(lit_scene *s, vec3 Le)
{
    return lit_add_material(s, (material){.ke = Le});
}

/* A plate at c, 8 wide: its normal halves the angle between the eye and the origin. */
static inline void stage_plate(lit_scene *s, vec3 c, uint16_t look)
{
    vec3 n = vunit(vadd(vunit(vsub(plate_eye, c)), vunit(vneg(c)))), across = {8, 0, 0};
    vec3 t = vcross(n, (vec3){1, 0, 0});
    vec3 o = vsub(vsub(c, vscale(across, 0.5)), vscale(t, 0.5));
    lit_add_rectangle(s, (rectangle){o, across, t}, look);
}

static inline void stage_plates(direct_stage *g)
{
    static const struct { double y, z, roughness; } plate[4] = {  /* top to bottom */
        {-2.4, -0.13, 0.07}, {-3.06, 0.92, 0.14}, {-3.58, 2.22, 0.22}, {-3.91, 3.57, 0.32}};
    static const struct { double r; vec3 tint; } ball[4] = {
        {0.033, {1.5, 0.75, 0.75}}, {0.1, {1.2, 1, 0.5}}, {0.3, {0.7, 1.2, 0.7}},
        {0.9, {0.7, 0.95, 1.6}}};
    vec3 f0 = {0.85, 0.85, 0.85};
    uint16_t grey = stage_matte(&g->s, .3, .3, .3);
    lit_add_rectangle(&g->s, (rectangle){vec(-30, -4.2, 20), {60, 0, 0}, {0, 0, -22}}, grey);
    lit_add_rectangle(&g->s, (rectangle){vec(-30, -4.2, -2), {60, 0, 0}, {0, 30, 0}}, grey);
    for (int k = 0; k < 4; k++) {
        material metal = {.mirror = f0, .alpha = ggx_alpha((real)plate[k].roughness)};
        stage_plate(&g->s, vec(0, plate[k].y, plate[k].z), lit_add_material(&g->s, metal));
    }
    for (int k = 0; k < 4; k++) {  /* flux 4 pi^2 r^2 L, the same for all */
        real r = (real)ball[k].r, L = 1 / (r * r);
        shape at = shape_of_sphere((sphere){vec(-3.75 + 2.5 * k, 0, 0), r});
        lit_add_shape(&g->s, at, stage_lamp(&g->s, vscale(ball[k].tint, L)));
    }
    g->exposure = 1.2;
}

static inline void stage_strip(direct_stage *g)
{
    uint16_t grey = stage_matte(&g->s, .7, .7, .7), dark = stage_matte(&g->s, .3, .15, .1);
    uint16_t lamp = stage_lamp(&g->s, vec(2, 1.7, 1.2));
    lit_add_rectangle(&g->s, (rectangle){vec(-6, 0, 6), {12, 0, 0}, {0, 0, -12}}, grey);
    lit_add_rectangle(&g->s, (rectangle){vec(-3, 0, -2), {6, 0, 0}, {0, 1, 0}}, lamp);
    lit_add_shape(&g->s, shape_of_sphere((sphere){vec(1.2, .5, -1.3), .5}), dark);
    g->exposure = 1.5;
}

static inline void stage_open(direct_stage_name name, direct_stage *g)
{
    first_scene first = first_cornell();
    const real aspect = name <= STAGE_FIRST ? 1 : name == STAGE_PLATES ? (real)1.4 : (real)1.7;
    *g = (direct_stage){.aspect = aspect, .exposure = 1.4};
    if (name == STAGE_BOX) lit_cornell_begin(&g->s);
    else if (name == STAGE_FIRST) lit_first_begin(&first, &g->s);
    else lit_begin(&g->s);
    if (name == STAGE_PLATES) stage_plates(g);
    if (name == STAGE_STRIP) stage_strip(g);
    lit_end(&g->s);
    g->c = stage_camera_of(name, g->aspect);
}

#endif
