/* directions.h: one irradiance, estimated in four ways: what a sample is chosen by.
 *
 *   by                    pdf                  weight of a sample that meets the light
 *   uniform hemisphere    1 / (2 pi)           2 pi cos theta                             (22.11)
 *   cosine                cos / pi             pi                                         (22.22)
 *   area of the light     1 / A, as area       cos cos' A / r^2                           (22.23)
 *   its solid angle       1 / Omega            cos theta Omega                            (22.24)
 *
 * cos': at the light. The first two go where the light is not; the area of a sphere is half hidden,
 * and near a light cos' / r^2 varies. What is left in the last is cos theta alone.
 *
 *   radiometry_seen k = radiometry_seen_of(p);                                once a point p
 *   real x = direction_sample(LIGHT_SPHERE, BY_AREA, &k, u, v);     u, v in [0, 1); radiance 1
 *   direction_exact(LIGHT_SPHERE)                                   closed form
 */
#ifndef RADIOMETRY_DIRECTIONS_H
#define RADIOMETRY_DIRECTIONS_H

#include "oracle.h"
#include "relations.h"
#include "sphere_irradiance.h"

typedef enum { LIGHT_SPHERE, LIGHT_SQUARE, radiometry_lights } radiometry_light;
typedef enum { BY_HEMISPHERE, BY_COSINE, BY_AREA, BY_SOLID_ANGLE, direction_ways } direction_way;
static const char *const radiometry_light_name[radiometry_lights] = {"sphere", "square"};
static const char *const direction_name[direction_ways] = {"uniform hemisphere", "cosine", "area",
                                                           "solid angle"};

/* ---------------------------------------------------------------------------------------------- */

static const sphere lamp = {{1, 0, 2}, 1};
static const rectangle pane = {{0.5, -1, 0.5}, {0, 0, 1}, {0, 2, 0}};  /* faces -x */

typedef struct { direction_cone cone; vec3 axis; spherical_rectangle square; } radiometry_seen;

static inline double direction_exact(radiometry_light l)
{
    return l == LIGHT_SPHERE ? (double)sphere_irradiance(lamp, seen_from, seen_up)
                             : rectangle_irradiance_exact(pane, seen_from, seen_up);
}

static inline radiometry_seen radiometry_seen_of(vec3 p)
{
    return (radiometry_seen){sphere_cone(lamp, p), vunit(vsub(lamp.c, p)),
                             spherical_rectangle_of(pane, p)};
}

/* Does the ray from the origin meet it? Where the plane is met, in shares of s and t. */
static inline bool rectangle_met(rectangle r, vec3 w)
{
    vec3 m = vcross(r.s, r.t);
    real t = vdot(r.o, m) / vdot(w, m);
    vec3 y = vsub(vscale(w, t), r.o);
    real a = vdot(y, r.s) / vdot(r.s, r.s), b = vdot(y, r.t) / vdot(r.t, r.t);
    return t > 0 && a >= 0 && a <= 1 && b >= 0 && b <= 1;
}

/* By area: cos cos' / r^2 of a point of it. */
static inline real area_term(rectangle r, vec3 p, vec3 n, real u, real v)
{
    vec3 y = vsub(rectangle_at(r, (vec3){u, v, 0}), p), m = vcross(r.s, r.t);
    real r2 = vdot(y, y);
    return real_max(vdot(n, y), 0) * real_max(-vdot(m, y), 0) / (r2 * r2);  /* |m| is the area */
}

/* Of light l: a point of it, by area. */
static inline real light_by_area(radiometry_light l, real u, real v)
{
    if (l == LIGHT_SQUARE) return area_term(pane, seen_from, seen_up, u, v);
    vec3 m = sample_sphere(u, v), y = vmadd(lamp.c, m, lamp.r);
    real r2 = vdot(y, y), facing = -vdot(m, y);
    return 4 * pi * lamp.r * lamp.r * real_max(y.z, 0) * real_max(facing, 0) / (r2 * r2);
}

/* A direction within its solid angle. */
static inline real light_by_angle(radiometry_light l, const radiometry_seen *k, real u, real v)
{
    if (l == LIGHT_SPHERE)
        return real_max(directed(k->axis, sample_cone(k->cone, u, v)).z, 0)
             * 4 * pi * k->cone.half_sine2;
    vec3 y = rectangle_at(pane, spherical_rectangle_sample(&k->square, u, v));
    return real_max(vunit(y).z, 0) * k->square.omega;
}

/* k: for BY_SOLID_ANGLE, prepared once a point. */
static inline real direction_sample(radiometry_light l, direction_way by,
                                    const radiometry_seen *k, real u, real v)
{
    hit h;
    if (by == BY_AREA) return light_by_area(l, u, v);
    if (by == BY_SOLID_ANGLE) return light_by_angle(l, k, u, v);
    vec3 w = by == BY_COSINE ? sample_cosine(u, v) : sample_hemisphere(u, v);
    bool met = l == LIGHT_SPHERE ? sphere_hit(lamp, ray_from(seen_from, w), &h)
                                 : rectangle_met(pane, w);
    return !met ? 0 : by == BY_COSINE ? pi : 2 * pi * w.z;
}

/* The mean of n samples. */
static inline double direction_estimate(radiometry_light l, direction_way by, uint64_t seed,
                                        uint64_t run, uint32_t n)
{
    radiometry_seen k = radiometry_seen_of(seen_from);
    double sum = 0;
    for (uint32_t i = 0; i < n; i++) {
        random_stream s = random_start(seed, run, i);
        real u = random_next(&s), v = random_next(&s);
        sum += (double)direction_sample(l, by, &k, u, v);
    }
    return sum / n;
}

#endif
