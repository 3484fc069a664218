/* shading_frame.h: directions as the surface sees them.                 local frame (局部坐标系)
 *
 *          n = +z
 *     wo  |  wi          shading_frame f = shading_frame_of(n);      unit n, either side
 *       \ | /            vec3 w = to_local(f, world);                w.z = cos of the angle to n
 *    ____\|/____ s = +x  vec3 d = to_world(f, w);                    and back, within 8 epsilon
 *
 * Both wi (towards the light) and wo (towards the eye) point away from the surface. With n = +z the
 * cosine is z, its square's complement x^2 + y^2: that one knows no cancellation near the normal.
 */
#ifndef SHADING_FRAME_H
#define SHADING_FRAME_H

#include "../../common/vec3.h"

typedef struct { vec3 s, t, n; } shading_frame;

/* ---------------------------------------------------------------------------------------------- */

static inline shading_frame shading_frame_of(vec3 n)
{
    shading_frame f = {.n = n};
    vbasis(n, &f.s, &f.t);
    return f;
}

static inline vec3 to_local(shading_frame f, vec3 w)
{
    return (vec3){vdot(f.s, w), vdot(f.t, w), vdot(f.n, w)};
}

static inline vec3 to_world(shading_frame f, vec3 w)
{
    return vmadd(vmadd(vscale(f.s, w.x), f.t, w.y), f.n, w.z);
}

#endif
