/* 25_radiosity.h: two closed rooms as linear systems (辐射度方法): of two unknowns, and of many.
 *
 *    .-------.       furnace_pair(&s, r, E, rho)      two materials: a ball of radius r < 1 in the
 *   /   .-.   \                                       middle of a sphere of radius 1
 *  |   ( 1 )   |     transport t = furnace_transport(r, E, rho, channel);    (25.11) of one
 *   \   '-'  2/                                       channel; transport_free
 *    '-------'
 *
 * By symmetry each of the two has one radiance all over. The ball (0) sees the sphere alone; of
 * what leaves the sphere (1), (r/1)^2 goes to the ball:
 *
 *   K = | 0            rho_0       |                                                       (25.11)
 *       | rho_1 r^2    rho_1 (1 - r^2) |
 *
 *     .________.       the cube [-1,1]^3, wall k = 0..5 at x = -1, x = +1, y = -1, ... +1, matte,
 *    /|_|_|_|_/|       E[k] and rho[k] each; every wall is cut into m x m squares, on each of
 *   |_|_|_|_| /        which L is taken to be what it is in the middle:
 *   |_|_|_|_|/
 *                      L_i = E_i + rho_i sum over j of F_ij L_j                            (25.13)
 *
 *   transport t = radiosity_box(E, rho, m);        n = 6 m^2, (k m + row) m + column
 *   double v = radiosity_at(E, rho, m, L, p, k);   radiance at a point p of wall k, given all L_j
 *
 * F_ij, from a point to a square, is Lambert's closed form (22.15) over pi: exact, so that rows of
 * F sum to 1 to the last digits. What is left is that L varies over a square: the error falls with
 * m^2, and the step from m to 2 m tells how large it still is. Where furnaces have one number a
 * room, here K E is a picture: brighter in the middle, darker in the corners.
 */
#ifndef BOUNCES_RADIOSITY_BOX_H
#define BOUNCES_RADIOSITY_BOX_H

#include "../chapters/22_radiometry/lab/polygon_irradiance.h"
#include "../chapters/25_bounces/lab/furnace.h"
#include "../chapters/25_bounces/lab/transport.h"

/* ---------------------------------------------------------------------------------------------- */

static inline void furnace_pair(lit_scene *s, real r, const vec3 E[2], const vec3 rho[2])
{
    lit_begin(s);
    for (int k = 0; k < 2; k++) {
        uint16_t m = lit_add_material(s, (lit_material){.f = brdf_lambert(rho[k]), .Le = E[k]});
        lit_add_shape(s, shape_of_sphere((sphere){{0, 0, 0}, k ? -1 : r}), m);
    }
    lit_end(s);
}

static inline transport furnace_transport(double r, const vec3 E[2], const vec3 rho[2], int channel)
{
    transport t = transport_new(2);
    double a = (double)vaxis(rho[0], channel), b = (double)vaxis(rho[1], channel);
    for (int k = 0; k < 2; k++) t.E[k] = (double)vaxis(E[k], channel);
    t.K[1] = a, t.K[2] = b * r * r, t.K[3] = b * (1 - r * r);
    return t;
}

static inline rectangle radiosity_square(int m, int i)
{
    rectangle r = furnace_wall(i / (m * m));
    vec3 s = vscale(r.s, 1 / (real)m), t = vscale(r.t, 1 / (real)m);
    vec3 o = vmadd(vmadd(r.o, s, (real)(i / m % m)), t, (real)(i % m));
    return (rectangle){o, s, t};
}

/* Share of what is seen from p, on wall k, that is square j; its own wall is seen edge-on: 0. */
static inline double radiosity_share(int m, vec3 p, int k, int j)
{
    rectangle wall = furnace_wall(k);
    if (j / (m * m) == k) return 0;
    vec3 n = vunit(vcross(wall.s, wall.t));
    return (double)(rectangle_irradiance(radiosity_square(m, j), p, n) / pi);
}

static inline transport radiosity_box(const double E[6], const double rho[6], int m)
{
    int n = 6 * m * m;
    transport t = transport_new(n);
    for (int i = 0; i < n; i++) {
        int k = i / (m * m);
        rectangle r = radiosity_square(m, i);
        vec3 p = vmadd(vmadd(r.o, r.s, 0.5), r.t, 0.5);
        t.E[i] = E[k];
        for (int j = 0; j < n; j++) t.K[i * n + j] = rho[k] * radiosity_share(m, p, k, j);
    }
    return t;
}

static inline double radiosity_at(const double E[6], const double rho[6], int m, const double *L,
                                  vec3 p, int k)
{
    double sum = 0;
    for (int j = 0; j < 6 * m * m; j++) sum += radiosity_share(m, p, k, j) * L[j];
    return E[k] + rho[k] * sum;
}

#endif
