/* lens.h: a camera with a lens: sharp in one plane, blurred before and behind it.
 *
 *              lens |        plane of focus           object
 *                  /|\           |                      |
 *   film . . . .  | +- - - - - - P - - - _ - - - - - - -|- -   all rays of a film point meet in P
 *                  \|/           |               "  -  _|_
 *                   |<---- F --->|                      |  circle of confusion (弥散圆)
 *                   |<------------ z ------------------>|
 *
 *   o' = o + R (x, y)        (x, y) random in the unit disk, along u and v of the camera     (21.9)
 *   D' = D - (o' - o) / t    o + t D = P in the plane of focus: o' + t D' = P, too
 *   radius of the circle at depth z: R |z - F| / F                                          (21.10)
 *
 *   thin_lens l = {radius, focus};            radius R >= 0, focus F > 0 [scene units], or infinity
 *   ray r = lens_ray(c, l, x, y, nx, ny, u)   u: not looked at if R = 0: then it is camera_ray(..),
 *                                             to the last bit: a pinhole (针孔)
 *   real lens_blur(l, z)                      (21.10) [scene units]
 *
 * F and z are depths along the view, not distances from the eye: the plane of focus is a plane. A
 * lens of focal length f needs its film at f F / (F - f) behind it; the window of 02 is that film,
 * turned over and moved into the plane at distance d. In parallel views the lens moves along with
 * each ray: telecentric.
 *
 * Sources: M. Potmesil, I. Chakravarty, "A lens and aperture camera model for synthetic image
 * generation", SIGGRAPH 1981 (the circle); R. Cook, T. Porter, L. Carpenter, 1984 (the rays).
 */
#ifndef DISTRIBUTED_LENS_H
#define DISTRIBUTED_LENS_H

#include "../02_camera/camera.h"
#include "../20_monte_carlo/sampler.h"
#include "../20_monte_carlo/sampling.h"

typedef struct { real radius, focus; } thin_lens;

/* ---------------------------------------------------------------------------------------------- */

/* t: from the eye to the plane of focus, in lengths of D. */
fast_inline ray lens_ray(camera c, thin_lens l, real x, real y, int nx, int ny, point2 u)
{
    ray r = camera_ray(c, x, y, nx, ny);
    if (l.radius == 0) return r;
    vec3 w = sample_disk(u.u, u.v), off = vscale(vmadd(vscale(c.u, w.x), c.v, w.y), l.radius);
    real one_over_t = -vdot(r.d, c.w) / l.focus;
    r.o = vadd(r.o, off);
    r.d = vmadd(r.d, off, -one_over_t);
    return r;
}

static inline real lens_blur(thin_lens l, real z)
{
    return isinf(l.focus) ? l.radius : l.radius * (fabs(z - l.focus) / l.focus);
}

#endif
