/* shadow_map.h: shadows in object order (阴影贴图): a picture from the lamp, of depths.
 *
 *   lamp                 What the lamp sees is lit, what it does not see is dark. So draw what it
 *    | \                 sees, once, and ask for each point p: does the texel (纹素) into which p
 *    |  \  stored        falls store something nearer than p?
 *    |---x
 *    |    \              t_p > (1 + bias) t_stored                                          (8.6)
 *    |     p   dark
 *
 *   shadow_map s = shadow_map_new(&m, lamp, 512, raster_default);     512 x 512 texels
 *   bool dark = shadow_map_dark(&s, p, 0.01);                         bias: a share of the distance
 *   shadow_map_free(&s);
 *
 * A texel holds one depth for all of its width. Within it a slanted surface is partly behind the
 * stored depth: without bias it shadows itself in stripes (acne); with a large one contact shadows
 * come loose from what casts them (peter-panning). A shadow ray (18) has the same two troubles at
 * 1e-15 instead of 1e-2 of the distance. Outside of the lamp's picture: lit.
 *
 * Source: L. Williams, "Casting Curved Shadows on Curved Surfaces", SIGGRAPH 1978.
 */
#ifndef SHADOW_MAP_H
#define SHADOW_MAP_H

#include "raster.h"

typedef struct { camera lamp; raster depths; } shadow_map;

/* ---------------------------------------------------------------------------------------------- */

static inline shadow_map shadow_map_new(const mesh *m, camera lamp, int side, raster_how how)
{
    shadow_map s = {lamp, raster_new(side, side)};
    raster_mesh(&s.depths, m, lamp, how);
    return s;
}

static inline bool shadow_map_dark(const shadow_map *s, vec3 p, real bias)
{
    int n = s->depths.nx;
    real x, y;
    if (!camera_project(s->lamp, p, n, n, &x, &y)) return false;
    if (!(x >= 0 && x < (real)n && y >= 0 && y < (real)n)) return false;
    real t = -vdot(vsub(p, s->lamp.e), s->lamp.w) / s->lamp.d;  /* as a ray of the lamp counts it */
    return t > (1 + bias) * s->depths.h[(size_t)y * (size_t)n + (size_t)x].t;
}

static inline void shadow_map_free(shadow_map *s) { raster_free(&s->depths); }

#endif
