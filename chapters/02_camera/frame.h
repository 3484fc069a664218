/* frame.h: where the camera stands and which way it looks: e, u, v, w (相机坐标系).
 *
 *              v up
 *              |              w = (e - target) / |e - target|
 *              |              u = up x w / |up x w|                  (2.1)
 *              e----- u right v = w x u
 *             /
 *            w backward       the camera looks along -w
 *
 * u, v, w have length 1, stand at right angles to each other, and are right-handed: u x v = w.
 * `up` need not be at right angles to the view, nor have length 1: it only says which way v leans.
 *
 *   camera_frame f;
 *   if (!frame_look_at(e, target, up, &f, &why)) fail(why);
 *
 *   call                 cannot do                                   so
 *   frame_look_at        target = e; up = 0; up along the view;      false, and *why says it;
 *                        NaN or infinity; |e - target| too big       *out is untouched
 *   first_camera_at      the same, of first.h; and up at a small     u is 0, or noise;
 *                        angle to the view                           u leans towards w
 *
 * Source: S. Marschner, P. Shirley, "Fundamentals of Computer Graphics", 4th ed., 2015, sections
 * 2.4.7 and 4.3.
 */
#ifndef CAMERA_FRAME_H
#define CAMERA_FRAME_H

#include "../../common/file.h"
#include "../../common/vec3.h"

typedef struct { vec3 e, u, v, w; } camera_frame;

/* Misuse: exit code 2. False, written so that the compiler sees it. */
#define camera_refused(why, ...) (failed(why, 2, __VA_ARGS__), false)

/* ---------------------------------------------------------------------------------------------- */

/* What any look-at must refuse. `back` is e - target. */
static inline bool frame_input_is_usable(vec3 e, vec3 target, vec3 up, vec3 back, failure *why)
{
    const char *name[] = {"viewpoint", "target", "up"};
    vec3 given[] = {e, target, up};
    for (int i = 0; i < 3; i++)
        if (!vfinite(given[i]))
            return camera_refused(why, "%s (%g, %g, %g): only finite numbers make a view", name[i],
                                  (double)given[i].x, (double)given[i].y, (double)given[i].z);
    if (!vfinite(back))
        return camera_refused(
            why, "viewpoint and target are too far apart: their distance overflows");
    if (vzero(back))
        return camera_refused(
            why, "target (%g, %g, %g) equals the viewpoint: no direction to look in",
            (double)target.x, (double)target.y, (double)target.z);
    if (vzero(up))
        return camera_refused(why, "up (0, 0, 0): any vector but zero says which way is up");
    return true;
}

/* u comes from `up` and `back` as they are given, through products that lose nothing: at any angle
 * it stands at right angles to both within a few epsilon. An angle of less than 4 epsilon is
 * refused: it is of the size that rounding the input makes of zero.
 *
 * up = (3, 5, 6), from (0, 0, 0) towards (3, 5, 6.000001), in double: an angle of 8e-8. first.h
 * rounds w to length 1 first, which turns it by some epsilon; seen against the angle, that turns u
 * by 1e-9, and u leans towards w. In float 6.0001 does as much harm. */
static inline bool frame_look_at(vec3 e, vec3 target, vec3 up, camera_frame *out, failure *why)
{
    vec3 back = vsub(e, target);
    if (!frame_input_is_usable(e, target, up, back, why)) return false;
    vec3 a = up, b = back;
    if (!square_is_safe(vdot(a, a)) || !square_is_safe(vdot(b, b))) {
        int power;
        a = vscaled(up, &power), b = vscaled(back, &power);  /* exact: the directions stay */
    }
    vec3 u = vcross_accurate(a, b), w = vunit(b);
    if (vlength(u) <= 4 * real_epsilon * vlength(a) * vlength(b))
        return camera_refused(
            why, "up (%g, %g, %g) is parallel to the view (%g, %g, %g): choose another up",
            (double)up.x, (double)up.y, (double)up.z,
            0 - (double)back.x, 0 - (double)back.y, 0 - (double)back.z);
    u = vunit(u);
    *out = (camera_frame){e, u, vcross(w, u), w};
    return true;
}

#endif
