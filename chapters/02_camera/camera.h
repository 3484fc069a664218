/* camera.h: the ray through a point of the picture, for four kinds of camera.
 *
 *   (0,0)---------- x ->  nx        u = left + (right - left) x / nx          (2.2)
 *     |  v = top                    v = top + (bottom - top) y / ny           (2.3)
 *     y   . u = v = 0
 *     |          u = right          parallel:     o = e + u u + v v, d fixed  (2.4)
 *     ny --------------             perspective:  o = e, d = -d w + u u + v v (2.5)
 *
 * Vectors are bold in print: in (2.4) and (2.5) each first u, v and the d before w are numbers.
 * FCG calls the window l, r, b, t; here t is a ray's parameter alone.
 *
 * (x, y) are pixel coordinates (像素坐标): x from 0 at the left edge to nx at the right edge, y from 0
 * at the top edge to ny at the bottom edge, fractions allowed. Pixel (i, j) of an image covers
 * [i, i+1] x [j, j+1]; its centre is (i + 0.5, j + 0.5).
 *
 * The window {left, right, bottom, top} is measured from e along u and v; left < right, and
 * bottom < top; d > 0 is the distance from e to its plane. All rays have tmin = 0, tmax = infinity.
 *
 *   builder (false and *why if it cannot)   rays                              t counts
 *   camera_orthographic(f, win, ..)         parallel, along -w (正交)         units from the plane
 *   camera_oblique(f, win, direction, ..)   parallel, along direction (倾斜)  units from the plane
 *   camera_perspective(f, phi, a, ..)       from e, window centred (透视)     t = 1 on the plane
 *   camera_off_axis(f, win, d, ..)          from e, window anywhere (离轴)    t = 1 on the plane
 *       phi: vertical field of view in degrees (0, 180); a: width / height
 *   camera c = camera_at(e, target, up, phi, a)     for scenes of the book: what frame_look_at or
 *                                           camera_perspective refuse ends the program
 *
 *   real D = camera_distance(&f, half, a, tangent)  the least, from the middle of a box along w, at
 *                                           which all of it shows; tangent: half_tangent(phi)
 *
 *   ray r = camera_ray(c, x, y, nx, ny);    d has length 1 in parallel views only: see ray_unit
 *   camera_project(c, p, nx, ny, &x, &y)    the inverse: where p shows; false if p is not in front
 *   camera_vanishing_point(c, D, nx, ny, &x, &y)  where lines along D meet (消失点); false if nowhere
 *
 * Parallel rays begin in the plane of e. What lies behind that plane is not seen, though such a
 * view has no eye to be behind of: r.tmin = -real_infinity sees it.
 *
 * Source: Marschner, Shirley 2015 (see frame.h), sections 4.1 to 4.3.
 */
#ifndef CAMERA_H
#define CAMERA_H

#include "../01_ray/ray.h"
#include "frame.h"

typedef enum { CAMERA_PARALLEL, CAMERA_PERSPECTIVE } camera_kind;
typedef struct { real left, right, bottom, top; } camera_window;
typedef struct {
    camera_kind kind;
    vec3 e, u, v, w;
    real left, right, bottom, top;
    real d;          /* perspective: distance from e to the image plane */
    vec3 direction;  /* parallel: of all rays, unit length */
} camera;

/* ---------------------------------------------------------------------------------------------- */

static inline bool camera_window_is_usable(camera_window n, failure *why)
{
    real width = n.right - n.left, height = n.top - n.bottom;
    if (width > 0 && height > 0 && isfinite(width) && isfinite(height)) return true;
    return camera_refused(
        why, "window left %g, right %g, bottom %g, top %g: left < right, bottom < top",
        (double)n.left, (double)n.right, (double)n.bottom, (double)n.top);
}

static inline bool camera_oblique(camera_frame f, camera_window n, vec3 direction, camera *out,
                                  failure *why)
{
    vec3 unit = vunit(direction);
    if (!camera_window_is_usable(n, why)) return false;
    if (!(vdot(unit, f.w) < -4 * real_epsilon))  /* a NaN or zero direction comes here too */
        return camera_refused(
            why, "direction (%g, %g, %g): it must lead forward, direction . w < 0",
            (double)direction.x, (double)direction.y, (double)direction.z);
    *out = (camera){CAMERA_PARALLEL, f.e, f.u, f.v, f.w, n.left, n.right, n.bottom, n.top, 0,
                    unit};
    return true;
}

static inline bool camera_orthographic(camera_frame f, camera_window n, camera *out, failure *why)
{
    if (!camera_oblique(f, n, vneg(f.w), out, why)) return false;
    out->direction = vneg(f.w);  /* as it is: no second rounding */
    return true;
}

static inline bool camera_off_axis(camera_frame f, camera_window n, real d, camera *out,
                                   failure *why)
{
    if (!camera_window_is_usable(n, why)) return false;
    if (!(d > 0 && isfinite(d)))
        return camera_refused(why, "image plane at distance d = %g: it takes d > 0, finite",
                              (double)d);
    *out = (camera){CAMERA_PERSPECTIVE, f.e, f.u, f.v, f.w, n.left, n.right, n.bottom, n.top, d,
                    {0, 0, 0}};
    return true;
}

/* tan(phi / 2), phi in degrees (0, 180). At phi = 179.99 in float, tan(phi pi / 360) is off by
 * 1e-3: it rounds an angle close to a right angle, whose tangent depends on what is missing to it.
 * There 180 - phi is exact. */
static inline real half_tangent(real phi)
{
    return phi <= 90 ? tan(phi * pi / 360) : 1 / tan((180 - phi) * pi / 360);
}

/* Half height tan(phi / 2) at distance 1 (2.6). */
static inline bool camera_perspective(camera_frame f, real phi, real a, camera *out, failure *why)
{
    if (!(phi > 0 && phi < 180))
        return camera_refused(why, "field of view %g: it takes degrees between 0 and 180",
                              (double)phi);
    if (!(a > 0 && isfinite(a)))
        return camera_refused(why, "width / height %g: it takes a positive number", (double)a);
    real top = half_tangent(phi);
    return camera_off_axis(f, (camera_window){-a * top, a * top, -top, top}, 1, out, why);
}

static inline camera camera_at(vec3 e, vec3 target, vec3 up, real phi, real a)
{
    camera_frame f;
    camera c;
    failure why;
    if (!frame_look_at(e, target, up, &f, &why) || !camera_perspective(f, phi, a, &c, &why))
        fail(why);
    return c;
}

/* A corner q, from the middle of the box: |q.v| <= (D - q.w) tan(phi/2), |q.u| <= a times that. */
static inline real camera_distance(const camera_frame *c, vec3 half, real a, real tangent)
{
    real D = 0;
    for (int k = 0; k < 8; k++) {
        vec3 q = {k & 1 ? half.x : -half.x, k & 2 ? half.y : -half.y, k & 4 ? half.z : -half.z};
        real u = vdot(q, c->u), v = vdot(q, c->v), w = vdot(q, c->w);
        D = real_max(D, w + real_max(fabs(v), fabs(u) / a) / tangent);
    }
    return D;
}

static inline real camera_u(camera c, real x, int nx)
{
    return c.left + (c.right - c.left) * x / (real)nx;
}

static inline real camera_v(camera c, real y, int ny)
{
    return c.top + (c.bottom - c.top) * y / (real)ny;
}

static inline vec3 camera_in_plane(camera c, real u, real v)
{
    return vmadd(vscale(c.u, u), c.v, v);
}

/* d never meets e: wherever the camera stands, d is off by a few epsilon of the window's size,
 * since u and v are differences of numbers of that size. In the middle of the picture, where
 * |d| = 1, that is an angle of a few epsilon tan(phi / 2); everywhere a few epsilon nx pixels. */
static inline ray camera_ray(camera c, real x, real y, int nx, int ny)
{
    vec3 in_plane = camera_in_plane(c, camera_u(c, x, nx), camera_v(c, y, ny));
    if (c.kind == CAMERA_PARALLEL) return ray_from(vadd(c.e, in_plane), c.direction);
    return ray_from(c.e, vmadd(in_plane, c.w, -c.d));
}

/* With q = p - e: perspective u = d (q.u) / -(q.w), the same for v; parallel: p goes back to the
 * plane along the direction, u = (q - t direction).u with t = (q.w) / (direction.w)       (2.7)
 * In front means -(q.w) > 0 in perspective, t >= 0 in parallel views; a NaN is not in front. */
static inline bool camera_project(camera c, vec3 p, int nx, int ny, real *x, real *y)
{
    vec3 q = vsub(p, c.e);
    real depth = -vdot(q, c.w), s = 1;
    if (c.kind == CAMERA_PARALLEL) {
        real t = depth / -vdot(c.direction, c.w);
        if (!(t >= 0)) return false;
        q = vmadd(q, c.direction, -t);
    } else {
        if (!(depth > 0)) return false;
        s = c.d / depth;
    }
    *x = (s * vdot(q, c.u) - c.left) / (c.right - c.left) * (real)nx;
    *y = (s * vdot(q, c.v) - c.top) / (c.bottom - c.top) * (real)ny;
    return true;
}

/* p + t D shows at u = d (q.u + t D.u) / -(q.w + t D.w), which tends to -d (D.u) / (D.w): p drops
 * out, so all lines along D meet there (2.8). Not in parallel views, nor if D lies along the image
 * plane. */
static inline bool camera_vanishing_point(camera c, vec3 D, int nx, int ny, real *x, real *y)
{
    real forward = -vdot(D, c.w);
    if (c.kind == CAMERA_PARALLEL) return false;
    *x = (c.d * vdot(D, c.u) / forward - c.left) / (c.right - c.left) * (real)nx;
    *y = (c.d * vdot(D, c.v) / forward - c.top) / (c.bottom - c.top) * (real)ny;
    return isfinite(*x) && isfinite(*y);  /* forward = 0, or too small */
}

#endif
