/* camera_of.h: a camera that has all of a box before it.
 *
 *   camera c = camera_of(lo, hi, z_up, aspect);     in front of the box, to the right and above;
 *                                                   z_up: z is up, else y; aspect: width / height
 */
#ifndef CAMERA_OF_H
#define CAMERA_OF_H

#include "../../02_camera/camera.h"

/* ---------------------------------------------------------------------------------------------- */

/* Three half diagonals from the middle. */
static inline camera camera_of(vec3 lo, vec3 hi, bool z_up, real aspect)
{
    real size = vlength(vsub(hi, lo)) / 2;
    vec3 centre = vscale(vadd(lo, hi), 0.5), up = {0, !z_up, z_up};
    vec3 toward = vunit(z_up ? vec(0.45, -1, 0.55) : vec(0.45, 0.55, 1));
    return camera_at(vmadd(centre, toward, 3 * size), centre, up, aspect > 1 ? 26 : 38, aspect);
}

#endif
