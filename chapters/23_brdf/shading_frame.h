/* shading_frame.h: directions as the surface sees them.                 local frame (局部坐标系)
 *
 *          n = +z
 *     wo  |  wi          shading_frame f = shading_frame_of(n);      unit n, either side
 *       \ | /            vec3 w = to_local(f, world);                w.z = cos of the angle to n
 *    ____\|/____ s = +x  vec3 d = to_world(f, w);                    and back, within 8 epsilon
 *
 * Both wi (towards the light) and wo (towards the eye) point away from the surface. With n = +z the
 * cosine is z, its square's complement x^2 + y^2: that one knows no cancellation near the normal.
 *
 *   half_vector(wi, wo)      (wi + wo) / |wi + wo|, half way between them [both above the surface]
 *   half_angle(wi, wo)       cosine of the angle between either of them and their half vector, > 0
 *   mirrored(wo, m)          wo on the other side of m, at the same angle
 *   unit_of(a)               a / |a| [a^2 neither over- nor underflows]
 */
#ifndef BRDF_SHADING_FRAME_H
#define BRDF_SHADING_FRAME_H

#include "../../common/vec3.h"

typedef struct { vec3 s, t, n; } shading_frame;

/* ---------------------------------------------------------------------------------------------- */

/* A bounce calls these several times. Large programs exceed what gcc inlines of its own will. */
fast_inline shading_frame shading_frame_of(vec3 n)
{
    shading_frame f = {.n = n};
    vbasis(n, &f.s, &f.t);
    return f;
}

fast_inline vec3 to_local(shading_frame f, vec3 w)
{
    return (vec3){vdot(f.s, w), vdot(f.t, w), vdot(f.n, w)};
}

fast_inline vec3 to_world(shading_frame f, vec3 w)
{
    return vmadd(vmadd(vscale(f.s, w.x), f.t, w.y), f.n, w.z);
}

/* vunit without its rare case, and with the same result: that one gcc does not inline (20 ns). */
fast_inline vec3 unit_of(vec3 a) { return vscale(a, 1 / sqrt(vdot(a, a))); }

fast_inline vec3 half_vector(vec3 wi, vec3 wo) { return unit_of(vadd(wi, wo)); }

/* wo.(wi + wo) = 1 + wi.wo = |wi + wo|^2 / 2. As a product, wo.h could round to below 0. */
fast_inline real half_angle(vec3 wi, vec3 wo)
{
    vec3 a = vadd(wi, wo);
    return sqrt(vdot(a, a)) / 2;
}

fast_inline vec3 mirrored(vec3 wo, vec3 m) { return vsub(vscale(m, 2 * vdot(wo, m)), wo); }

#endif
