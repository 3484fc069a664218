/* floors.h: a floor under three lights; its irradiance in closed form, and as photons count it.
 *
 *   FLOOR_SPHERE      radius 1, partly buried: it touches the floor all round
 *   FLOOR_RECTANGLE   upright, standing on the floor, shining to +x
 *   FLOOR_SPOTLIGHT   a point, I = cos^8 of the angle off its axis: E = I cos theta / r^2  (22.7)
 *
 *   floor_exact(light, x, y)                     E [W/m^2] at (x, y, 0), the surface facing up
 *   floor_photons(light, seed, first, n, count)  n photons (光子), numbers first, first + 1 .., leave
 *                                                the light, from a place and in a direction by
 *                                                chance; where they land counts
 *   floor_flux(light)                            power of all of them [W]: each carries 1/n of it
 *
 * L = 1 W/(m^2 sr), I = 1 W/sr along the axis. The floor: |x|, |y| < 4, floor_cells^2 cells.
 */
#ifndef RADIOMETRY_FLOORS_H
#define RADIOMETRY_FLOORS_H

#include "relations.h"
#include "sphere_irradiance.h"

typedef enum { FLOOR_SPHERE, FLOOR_RECTANGLE, FLOOR_SPOTLIGHT, floor_lights } floor_light;
enum { floor_cells = 64 };
#define floor_half ((real)4)

/* ---------------------------------------------------------------------------------------------- */

static const sphere buried = {{0, 0, 0.6}, 1};
static const rectangle screen = {{-3.75, -1.5, 0}, {0, 3, 0}, {0, 0, 2}};
static const vec3 spot_at = {-2.5, 0, 3}, spot_axis = {0.6, 0, -0.8};

static inline real spot_intensity(vec3 w)
{
    real c = real_max(vdot(w, spot_axis), 0), c2 = c * c, c4 = c2 * c2;
    return c4 * c4;
}

/* E at the distance c > 0 from the screen's plane, of the part from y to y + b (J. Howell, "A
 * Catalog of Radiation Heat Transfer Configuration Factors", B-4). */
static inline real screen_corner(real c, real b)
{
    real far = hypot(c, screen.t.z);
    return (atan(b / c) - c / far * atan(b / far)) / 2;
}

static inline real floor_exact(floor_light light, real x, real y)
{
    vec3 p = {x, y, 0}, w = vsub(p, spot_at);
    real d = vlength(w);
    switch (light) {
    case FLOOR_SPHERE: return sphere_irradiance(buried, p, seen_up);
    case FLOOR_RECTANGLE:
        if (!(x > screen.o.x)) return 0;
        return screen_corner(x - screen.o.x, screen.o.y + screen.s.y - y)
             - screen_corner(x - screen.o.x, screen.o.y - y);
    case FLOOR_SPOTLIGHT: return spot_intensity(vscale(w, 1 / d)) * (-w.z / d) / (d * d);
    case floor_lights: break;
    }
    return 0;
}

/* A Lambertian surface sends pi L from each square metre; all of the sphere's is counted, though
 * what starts below the floor stays there. */
static inline double floor_flux(floor_light light)
{
    double area = light == FLOOR_SPHERE ? 4 * (double)pi : 6;
    return light == FLOOR_SPOTLIGHT ? spot_flux : (double)pi * area;
}

/* Where it starts and where it goes. */
static inline void photon_start(floor_light light, random_stream *s, vec3 *o, vec3 *d)
{
    real u = random_next(s), v = random_next(s), u2 = random_next(s), v2 = random_next(s);
    vec3 m = spot_axis;
    *o = spot_at, *d = light == FLOOR_SPOTLIGHT ? sample_lobe(8, u, v) : sample_cosine(u2, v2);
    if (light == FLOOR_SPHERE) m = sample_sphere(u, v), *o = vmadd(buried.c, m, buried.r);
    if (light == FLOOR_RECTANGLE) m.x = 1, m.z = 0, *o = rectangle_at(screen, (vec3){u, v, 0});
    *d = directed(m, *d);
}

/* x or y as a cell; -1: beside the floor. */
static inline int floor_cell(real x)
{
    real at = (x + floor_half) / (2 * floor_half) * floor_cells;
    return at >= 0 && at < floor_cells ? (int)at : -1;
}

static inline void floor_photons(floor_light light, uint64_t seed, size_t first, size_t n,
                                 uint32_t *count)
{
    for (size_t i = first; i < first + n; i++) {
        random_stream s = random_start(seed, 1000 + (uint64_t)light, i);
        vec3 o, d;
        photon_start(light, &s, &o, &d);
        if (!(o.z > 0) || !(d.z < 0)) continue;
        vec3 q = vmadd(o, d, -o.z / d.z);
        int x = floor_cell(q.x), y = floor_cell(q.y);
        if (x >= 0 && y >= 0) count[y * floor_cells + x]++;
    }
}

/* Photons that n of them are expected to bring to a cell in which E is the mean. */
static inline double floor_expected(floor_light light, double e, double n)
{
    double side = 2 * (double)floor_half / floor_cells;
    return e * side * side * n / floor_flux(light);
}

#endif
