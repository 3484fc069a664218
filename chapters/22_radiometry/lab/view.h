/* view.h: what a point sees above it, drawn so that areas are solid angles, or irradiances.
 *
 *   VIEW_EQUAL_AREA   r = 2 sin(theta/2) (Lambert's map): area in the picture = solid angle
 *   VIEW_PROJECTED    r = sin theta: area = cos theta d omega: Nusselt's analog, E for L = 1
 *
 *   bool view_direction(m, x, y, &w)    (x, y) in [-1,1]^2; false outside of the hemisphere
 *   int view_met(w)                     which of view_thing[], -1 for none
 *   view_closed(m, k)                   the area as a closed form
 *   view_count(m, n, area)              the areas of all, counted on n x n pixels
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

/* The part of a sphere below the horizon: no closed form here for its solid angle, NaN. */
static inline double view_closed(radiometry_map m, int k)
{
    vec3 v[3] = {view_triangle.a, view_triangle.b, view_triangle.c};
    vec3 back[3] = {v[0], v[2], v[1]};
    bool e = m == VIEW_PROJECTED;
    if (k == 1 && !e) return (double)NAN;
    if (k < 2)
        return (double)(e ? sphere_irradiance(view_sphere[k], seen_from, seen_up)
                          : sphere_solid_angle(view_sphere[k], seen_from));
    if (k == 2)
        return (double)(e ? rectangle_irradiance(view_square, seen_from, seen_up)
                          : fabs(rectangle_solid_angle(view_square, seen_from)));
    if (!e) return (double)fabs(triangle_solid_angle(view_triangle, seen_from));
    return (double)(polygon_irradiance(v, 3, seen_from, seen_up) +
                    polygon_irradiance(back, 3, seen_from, seen_up));
}

static inline void view_count(radiometry_map m, int n, double area[view_things])
{
    double side = 2 * (double)view_scale(m) / n;
    for (int k = 0; k < view_things; k++) area[k] = 0;
    for (int i = 0; i < n * n; i++) {
        real x = (2 * (real)(i % n) + 1) / (real)n - 1, y = (2 * (real)(i / n) + 1) / (real)n - 1;
        vec3 w;
        int k = view_direction(m, x, y, &w) ? view_met(w) : -1;
        if (k >= 0) area[k] += side * side;
    }
}

#endif
