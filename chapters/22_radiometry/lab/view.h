/* view.h: what a point sees above it, drawn so that areas are solid angles, or irradiances.
 *
 *   VIEW_EQUAL_AREA   r = 2 sin(theta/2) (Lambert's map): area in the picture = solid angle
 *   VIEW_PROJECTED    r = sin theta: area = cos theta d omega: Nusselt's analog, E for L = 1
 *
 *   bool view_direction(m, x, y, &w)    (x, y) in [-1,1]^2; false outside of the hemisphere
 *   int view_met(w)                     which of view_thing[], -1 for none
 *
 * Source: W. Nusselt, "Graphische Bestimmung des Winkelverhaeltnisses bei der Waermestrahlung",
 * Zeitschrift des VDI 72, 1928.
 */
#ifndef RADIOMETRY_VIEW_H
#define RADIOMETRY_VIEW_H

#include "../relations.h"

typedef enum { VIEW_EQUAL_AREA, VIEW_PROJECTED, view_maps } radiometry_map;
enum { view_things = 4 };
static const char *const view_name[view_things] = {"sphere", "sphere, partly below", "square",
                                                   "triangle"};

/* ---------------------------------------------------------------------------------------------- */

static const sphere view_sphere[2] = {{{1, 1.2, 2}, 0.9},
                                      {{-0.3, 2, -0.25}, 1}};
static const rectangle view_square = {{-1.5, -1, 0.3}, {0, 1.6, 0},
                                      {0, 0, 1.6}};
static const triangle view_triangle = {{0.4, -1.6, 0.3},
                                       {2, -0.6, 0.3}, {1, -1.2, 3}};

static inline real view_scale(radiometry_map m) { return m == VIEW_EQUAL_AREA ? sqrt((real)2) : 1; }

static inline bool view_direction(radiometry_map m, real x, real y, vec3 *w)
{
    real k = view_scale(m), rr = k * k * (x * x + y * y);
    if (x * x + y * y >= 1) return false;
    if (m == VIEW_PROJECTED) *w = (vec3){x, y, sqrt(1 - rr)};
    else {
        real s = k * sqrt(1 - rr / 4);  /* k cos(theta/2), with rr = 4 sin^2(theta/2) */
        *w = (vec3){s * x, s * y, 1 - rr / 2};
    }
    return true;
}

static inline int view_met(vec3 w)
{
    ray r = ray_from(seen_from, w);
    hit h;
    for (int k = 0; k < 2; k++)
        if (sphere_hit(view_sphere[k], r, &h)) return k;
    if (rectangle_met(view_square, w)) return 2;
    return triangle_hit(view_triangle, r, &h) ? 3 : -1;
}

#endif
