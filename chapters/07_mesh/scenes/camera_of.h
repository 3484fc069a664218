/* camera_of.h: a camera that has all of a box before it.
 *
 *   camera c = camera_of(lo, hi, z_up, aspect);     in front of the box, to the right and above;
 *                                                   z_up: z is up, else y; aspect: width / height
 *   model_fails(why)                                ends the program, as camera_of does where there
 *                                                   is no view: says of which file, if one was read
 */
#ifndef CAMERA_OF_H
#define CAMERA_OF_H

#include "../../02_camera/camera.h"

/* ---------------------------------------------------------------------------------------------- */

static inline _Noreturn void model_fails(failure why)
{
    if (!*file_last || strstr(why.text, file_last)) fail(why);
    die(why.exit_code, "%s: %.200s", file_last, why.text);
}

/* Three half diagonals from the middle. */
static inline camera camera_of(vec3 lo, vec3 hi, bool z_up, real aspect)
{
    real size = vlength(vsub(hi, lo)) / 2;
    vec3 centre = vscale(vadd(lo, hi), 0.5), up = {0, !z_up, z_up};
    vec3 toward = vunit(z_up ? vec(0.45, -1, 0.55) : vec(0.45, 0.55, 1));
    camera_frame f;
    camera c;
    failure why;
    if (!frame_look_at(vmadd(centre, toward, 3 * size), centre, up, &f, &why)
        || !camera_perspective(f, aspect > 1 ? 26 : 38, aspect, &c, &why)) model_fails(why);
    return c;
}

#endif
