/* 02_oracle.h: how far a ray and a frame are off, measured in wide arithmetic.
 *
 * The input (e, window, frame) is taken as the exact numbers that it is; what follows from
 * it is computed again with 32 digits, and compared.
 *
 *   double camera_error(c, D, x, y, nx, ny)    how far D passes from (x, y), in pixels
 *   double frame_error(f, target, up)       |u - exact u|: radians, if small
 *   camera_frame frame_first(e, target, up) that of first.h
 */
#ifndef CAMERA_ORACLE_H
#define CAMERA_ORACLE_H

#include "../chapters/02_camera/camera.h"
#include "../chapters/02_camera/first.h"
#include "../common/numbers/wide.h"

/* ---------------------------------------------------------------------------------------------- */

/* The frame as first.h has it, for the same questions. */
static inline camera_frame frame_first(vec3 e, vec3 target, vec3 up)
{
    first_camera c = first_camera_at(e, target, up, 90, 1, 1);
    return (camera_frame){c.e, c.u, c.v, c.w};
}

static inline wide wide_ratio(wide a, double b, double n)
{
    return wide_div(wide_mul(a, wide_of(b)), wide_of(n));
}

/* Both rays are met with the image plane, the given one and the exact one (2.2, 2.3, 2.5). u, v, w
 * are taken as they are, so that rounding the frame does not count here. */
static inline double camera_error(camera c, vec3 D, real x, real y, int nx, int ny)
{
    wide width = wide_sub(wide_of((double)c.right), wide_of((double)c.left));
    wide height = wide_sub(wide_of((double)c.bottom), wide_of((double)c.top));
    wide u = wide_add(wide_of((double)c.left), wide_ratio(width, (double)x, nx));
    wide v = wide_add(wide_of((double)c.top), wide_ratio(height, (double)y, ny));
    wide3 U = wide3_of(c.u), V = wide3_of(c.v), W = wide3_of(c.w), zero = wide3_of((vec3){0, 0, 0});
    wide3 plane = wide3_madd(wide3_madd(zero, U, u), V, v), given = wide3_of(D);
    wide3 exact = wide3_madd(plane, W, wide_of(-(double)c.d));
    if (!(wide_sign(wide3_dot(given, W)) < 0)) return (double)INFINITY;  /* nothing is left of D */
    wide scale = wide_div(wide3_dot(exact, W), wide3_dot(given, W));
    wide3 off = wide3_sub(wide3_madd(zero, given, scale), exact);
    double dx = wide_value(wide_div(wide3_dot(off, U), width)) * nx;
    double dy = wide_value(wide_div(wide3_dot(off, V), height)) * ny;
    return sqrt(dx * dx + dy * dy);
}

static inline double frame_error(camera_frame f, vec3 target, vec3 up)
{
    wide3 back = wide3_sub(wide3_of(f.e), wide3_of(target)), u = wide3_cross(wide3_of(up), back);
    wide one_over = wide_div(wide_of(-1), wide3_length(u));
    return wide_value(wide3_length(wide3_madd(wide3_of(f.u), u, one_over)));
}

#endif
