/* rtr_camera.h: the same perspective camera in the left-handed frame of Real-Time Rendering, 26.1.
 *
 *        u up   v view          s(x, y) = a f (2 (x + 0.5) / w - 1) r
 *         |   /                         -   f (2 (y + 0.5) / h - 1) u + v     (2.9)
 *         | /                   f = tan(phi / 2), a = w / h
 *         c------ r right       O = c, D = s / |s|
 *
 * r, u, v are left-handed: r x u = -v. (x, y) are whole pixel numbers, y counts downward from the
 * top row; the 0.5 leads to the pixel's centre. D has length 1, so t is a distance.
 *
 * The notes' translation of (26.2) has a plus in the second term: y grows downward and u points up,
 * so the first row of the picture looks down and the picture stands on its head. (The plus is right
 * where y counts upward; the sign of the original was not looked up.)
 *
 * Letters: this w is the picture's width, and this v points forward; in camera.h w points backward
 * and v up.
 *
 * Source: T. Akenine-Möller et al., "Real-Time Rendering", 4th ed., 2018, online chapter 26,
 * section 26.1, equation 26.2.
 */
#ifndef RTR_CAMERA_H
#define RTR_CAMERA_H

#include "../camera.h"

typedef struct {
    vec3 c;        /* position */
    vec3 r, u, v;  /* right, up, view: unit length, left-handed */
    real f;        /* tan(phi / 2), phi the vertical field of view */
} rtr_camera;

/* ---------------------------------------------------------------------------------------------- */

/* The same view; k: camera_perspective. The third axis is turned round. */
static inline rtr_camera rtr_camera_of(camera k)
{
    return (rtr_camera){k.e, k.u, k.v, vneg(k.w), k.top};
}

/* + f (..) u, as printed, is - f (..) (-u). */
static inline rtr_camera rtr_as_printed(rtr_camera k) { return k.u = vneg(k.u), k; }

/* Through any point (x, y) of the picture: the 0.5 is the caller's. */
static inline ray rtr_camera_ray(rtr_camera k, real x, real y, int w, int h)
{
    real a = (real)w / (real)h;
    real right = a * k.f * (2 * x / (real)w - 1), up = -k.f * (2 * y / (real)h - 1);
    return ray_from(k.c, vunit(vadd(vmadd(vscale(k.r, right), k.u, up), k.v)));
}

#endif
