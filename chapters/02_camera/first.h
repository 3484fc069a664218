/* first.h: which ray belongs to which pixel: eye, window, and two ways to look through it.
 * Wrong where `up` is along the view: u becomes (0,0,0), or, at a small angle, leans to one side.
 * frame.h refuses the first and mends the second. */
#ifndef FIRST_CAMERA_H
#define FIRST_CAMERA_H
#include "../01_ray/first.h"

typedef struct {
    vec3 e;           /* the eye, or viewpoint (视点) */
    vec3 u, v, w;     /* right, up, backward: the camera frame (相机坐标系), right-handed */
    real left, right, bottom, top;  /* of the window, along u and v */
    real d;           /* from the eye to the window: the focal length (焦距) */
    int nx, ny;       /* pixels across and down */
} first_camera;

/* Looks from e to the target; phi: full vertical angle of view, in degrees. */
static inline first_camera first_camera_at(vec3 e, vec3 target, vec3 up, real phi, int nx, int ny)
{
    /* w = (e - target) / |e - target|,  u = up x w / |up x w|,  v = w x u                 (2.1) */
    vec3 w = vunit(vsub(e, target));
    vec3 u = vunit(vcross(up, w));
    vec3 v = vcross(w, u);

    /* top = -bottom = tan(phi / 2),  right = -left = top nx / ny,  d = 1                  (2.6) */
    real top = tan(phi / 2 * pi / 180), right = top * nx / ny;
    return (first_camera){e, u, v, w, -right, right, -top, top, 1, nx, ny};
}

/* The point of the window that pixel coordinates x, y stand for: x + 0.5, y + 0.5 is the middle of
 * a pixel, and y grows downward, as the rows of a picture do.
 *     u = left + (right - left) x / nx                                                    (2.2)
 *     v = top + (bottom - top) y / ny                                                     (2.3) */
static inline vec3 first_camera_window(first_camera c, real x, real y)
{
    real u = c.left + (c.right - c.left) * x / c.nx;
    real v = c.top + (c.bottom - c.top) * y / c.ny;
    return vadd(vscale(c.u, u), vscale(c.v, v));
}

/* Orthographic (正交): all rays run along -w and begin in the plane of e.                 (2.4) */
static inline ray first_orthographic_ray(first_camera c, real x, real y)
{
    return ray_from(vadd(c.e, first_camera_window(c, x, y)), vneg(c.w));
}

/* Perspective (透视): all rays begin at e, with d = -d w + u u + v v.                     (2.5) */
static inline ray first_camera_ray(first_camera c, real x, real y)
{
    return ray_from(c.e, vsub(first_camera_window(c, x, y), vscale(c.w, c.d)));
}

/* Ray s of n x n through pixel x, y. The colour of the pixel is the mean of theirs.       (2.10) */
static inline ray first_pixel_ray(first_camera c, int x, int y, int s, int n)
{
    return first_camera_ray(c, x + (s % n + 0.5) / n, y + (s / n + 0.5) / n);
}
#endif
