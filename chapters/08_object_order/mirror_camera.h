/* mirror_camera.h: a plane mirror in object order: the scene drawn once more, by the eye's image.
 *
 *      e         p            The ray from e by way of the mirror to p is as long, and leaves the
 *       \       /             mirror at the same place, as the straight one from e', the image of
 *   =====x=====/=== mirror    e behind it. So a pixel that shows the mirror shows what a camera at
 *       .   \ /               e' sees through the same point of its window; its frame is mirrored,
 *      .                      too. What lies behind the mirror would be in the way: it is clipped.
 *     e'
 *
 *   camera c2 = mirror_camera(c, mirror);        e, u, v, w reflected: u x v = -w
 *   raster_how how = raster_default; how.also = mirror;        its normal towards e
 *   raster_mesh(&s, &m, c2, how);                pixel (x, y) of s: what the mirror shows there
 *
 *   x' = x - 2 ((x - p') . n) n / (n . n)                                                   (8.9)
 *
 * One more picture a mirror, and one more for each mirror seen in a mirror. A curved mirror has no
 * such camera: each of its points needs an eye of its own. There rays begin (19).
 *
 * Source: P. Diefenbach, "Pipeline Rendering: Interaction and Realism through Hardware-Based
 * Multi-Pass Rendering", thesis, 1996, ch. 3.
 */
#ifndef MIRROR_CAMERA_H
#define MIRROR_CAMERA_H

#include "../02_camera/camera.h"
#include "../04_triangle/plane.h"

/* ---------------------------------------------------------------------------------------------- */

static inline vec3 mirror_direction(vec3 d, plane s)
{
    return vmadd(d, s.n, -2 * vdot(d, s.n) / vdot(s.n, s.n));
}

static inline vec3 mirror_point(vec3 x, plane s)
{
    return vadd(s.p, mirror_direction(vsub(x, s.p), s));
}

static inline camera mirror_camera(camera c, plane s)
{
    c.e = mirror_point(c.e, s);
    c.u = mirror_direction(c.u, s), c.v = mirror_direction(c.v, s), c.w = mirror_direction(c.w, s);
    return c;
}

#endif
