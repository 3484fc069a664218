/* 25_radiosity.h: a closed box whose walls differ, as a linear system (辐射度方法).
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

#include "../chapters/22_radiometry/polygon_irradiance.h"
#include "../chapters/25_bounces/lab/furnace.h"

/* ---------------------------------------------------------------------------------------------- */

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
