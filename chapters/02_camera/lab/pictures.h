/* pictures.h: what the page of 02 shows.
 *
 *   camera_draw_four(&o, v)        one room through four cameras: the main picture
 *   camera_draw_slips(&o, v)       RTR's sign; s - e far from the origin
 *   camera_draw_zone_plate(&o, v)  one ray a pixel, and 64 under two filters
 *
 * v says which scene, and how many rays a pixel.
 */
#ifndef CAMERA_LAB_PICTURES_H
#define CAMERA_LAB_PICTURES_H

#include "rtr_camera.h"
#include "draw.h"
#include "measure.h"

static const vec3 camera_eye = {9, 7.5, 7}, camera_target = {1.7, 1.9, 1.6}, camera_up = {0, 0, 1};

/* ---------------------------------------------------------------------------------------------- */

/* Above: parallel; below: perspective. Left: into the corner; right: level with the wall y = 0. */
cold_inline void camera_draw_four(const options *o, camera_view v)
{
    camera_view four[4] = {v, v, v, v};
    static const char *const tag[] = {"orthographic", "oblique", "perspective", "off-axis"};
    camera_frame corner, level, near_level;
    failure why;
    real s = 3.6, a = (real)o->width / (real)o->height, half = 0.5, k = sqrt(half) / 2;
    if (!frame_look_at(camera_eye, camera_target, camera_up, &corner, &why)
        || !frame_look_at(vec(2, 5, 2), vec(2, 0, 2), camera_up, &level, &why)
        || !frame_look_at(vec(6, 11, 6.2), vec(6, 0, 6.2), camera_up, &near_level, &why))
        fail(why);
    /* the cabinet view: depth halved, at 45 degrees */
    vec3 cabinet = vadd(vneg(level.w), vadd(vscale(level.u, k), vscale(level.v, -k)));
    camera_window square = {-a * s, a * s, -s, s};
    camera_window beside = {a * -4, a * (real)2.3, -2.2, 4.1};
    camera_window above = {(real)3.95 - a * (real)2.85, (real)3.95 + a * (real)2.85, -6.6, -0.9};
    four[2].c = camera_at(camera_eye, camera_target, camera_up, 38, a);
    if (!camera_orthographic(corner, square, &four[0].c, &why)
        || !camera_oblique(level, beside, cabinet, &four[1].c, &why)
        || !camera_off_axis(near_level, above, 7, &four[3].c, &why))
        fail(why);
    for (int i = 0; i < 4; i++) four[i].tag = tag[i];
    int gap = o->width >= 64 && o->height >= 64 ? 6 : 0;
    camera_draw_panels(o, four, (panels_shape){o->width, o->height, 2, 2, gap, 1, true},
                       "02_camera.png", true);
}

static inline ray camera_aim_rtr(const camera_view *v, real x, real y)
{
    const rtr_camera *k = v->own;
    return rtr_camera_ray(*k, x, y, v->nx, v->ny);
}

/* (2.5), every operation in float; with an e in v->own, (e + d) - e: what is left of d. */
static inline ray camera_aim_f32(const camera_view *v, real x, real y)
{
    const camera *c = &v->c;
    const float *e = v->own;
    float l = (float)c->left, r = (float)c->right, b = (float)c->bottom, t = (float)c->top, d[3];
    float u = l + (r - l) * (float)x / (float)v->nx;
    float up = t + (b - t) * (float)y / (float)v->ny;
    for (int k = 0; k < 3; k++) {
        d[k] = u * (float)vaxis(c->u, k) + up * (float)vaxis(c->v, k)
             - (float)c->d * (float)vaxis(c->w, k);
        float s = e ? e[k] + d[k] : 0;
        if (e) d[k] = s - e[k];
    }
    return ray_from(c->e, vec(d[0], d[1], d[2]));
}

cold_inline void camera_draw_slips(const options *o, camera_view v)
{
    int side = o->quick ? 100 : 400;
    const panels_shape g = {2 * side + 6, side, 2, 1, 6, 1, true};
    static const float far[3] = {120000, 96000, 128000};  /* an e 200 km from the origin */
    v.c = camera_at(camera_eye, camera_target, camera_up, 38, 1);
    const rtr_camera mended = rtr_camera_of(v.c), printed = rtr_as_printed(mended);
    camera_view p[2] = {v, v};
    p[0].aim = p[1].aim = camera_aim_rtr;
    p[0].own = &printed, p[0].tag = "as printed";
    p[1].own = &mended, p[1].tag = "mended";
    camera_draw_panels(o, p, g, "02_camera_rtr.png", false);
    v.aim = camera_aim_f32;
    p[0] = p[1] = v;
    p[0].own = far, p[0].tag = "float, s - e";
    p[1].tag = "float, (2.5)";
    camera_draw_panels(o, p, g, "02_camera_far.png", false);
}

cold_inline void camera_draw_zone_plate(const options *o, camera_view v)
{
    static const camera_pattern rings = {zone_plate, 0.0131};  /* too fine beyond 120 pixels */
    static const char *const tag[] = {"1 ray", "64, box", "64, Gaussian"};
    camera_view p[3];
    int zone = o->quick ? 80 : 320;
    v.c = camera_grid(zone);
    v.see = see_pattern, v.own = &rings, v.how = SAMPLES_REGULAR, v.f = filter_box;
    p[0] = p[1] = p[2] = v;
    p[0].n = 1, p[1].n = p[2].n = 8, p[2].f = filter_gaussian;
    for (int i = 0; i < 3; i++) p[i].tag = tag[i];
    camera_draw_panels(o, p, (panels_shape){3 * zone + 12, zone, 3, 1, 6, 1, true},
                       "02_camera_zone_plate.png", false);
}
#endif
