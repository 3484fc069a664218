/* furnace.h: closed rooms (白炉) in which every term of the series is known exactly.
 *
 *   furnace_sphere(&s, E, rho)       a sphere of radius 1, seen from inside
 *   furnace_box(&s, E, rho)          the cube [-1,1]^3, twelve triangles
 *
 * All walls emit E and reflect rho, matte, so that each sees the same radiance all around: K is the
 * number rho, and K^k E = rho^k E, channel by channel.
 *
 *   E + K E + ... + K^n E = E (1 - rho^(n+1)) / (1 - rho)    = E (n + 1) if rho = 1         (25.5)
 *   L = E / (1 - rho)                                        rho < 1                        (25.6)
 *
 *   series_sum(E, rho, n)         (25.5), E, rho >= 0, n >= 0
 *   series_sum_naive(E, rho, n)   as it is written: 0/0 at rho = 1; at rho = 1 - 1e-9 half of the
 *                                 digits, what 1 - rho^(n+1) is beyond its first term
 *   series_whole(E, rho)          (25.6); rho >= 1: infinity, the series diverges (发散)
 *
 *   furnace_variance(N, rho, n)      variance of E = 1 in such a room, N uniform directions a hit
 *
 * Where it comes from: X_n is the estimate of S_n = 1 + rho + ... + rho^n, w = 2 rho cos the
 * weight; the mean of w is rho, that of w^2 is 4/3 rho^2; all directions see the same. So
 *
 *   X_n = 1 + 1/N (sum over the N directions of w X_(n-1))
 *   V_n = rho^2 / N (4/3 (V_(n-1) + S_(n-1)^2) - S_(n-1)^2),  V_0 = 0                      (25.12)
 *
 * So V_n stays finite only if 4/3 rho^2 < N. The mean converges for every rho < 1, the variance of
 * one uniform direction only for rho < .866: beyond, deep terms are rare and huge products of
 * weights, which a run of any length that one can afford does not meet. Cosine: w = rho, V_n = 0.
 */
#ifndef BOUNCES_FURNACE_H
#define BOUNCES_FURNACE_H

#include "../../24_direct_light/lit_scene.h"

/* ---------------------------------------------------------------------------------------------- */

static inline real series_sum_naive(real E, real rho, real n)
{
    return E * (1 - pow(rho, n + 1)) / (1 - rho);
}

/* 1 - rho is exact for rho in [.5, 2]; below .5 log rho may be off, but rho^(n+1) is then small. */
static inline real series_sum(real E, real rho, real n)
{
    real kept = 1 - rho;
    if (kept == 0) return E * (n + 1);
    return E * (-expm1((n + 1) * log1p(-kept)) / kept);
}

static inline real series_whole(real E, real rho)
{
    return rho < 1 ? E / (1 - rho) : E > 0 ? real_infinity : 0;
}

static inline void furnace_sphere(lit_scene *s, vec3 E, vec3 rho)
{
    lit_begin(s);
    uint16_t wall = lit_add_material(s, (material){.kd = rho, .ke = E});
    lit_add_shape(s, shape_of_sphere((sphere){{0, 0, 0}, -1}), wall);
    lit_end(s);
}

/* Six squares, s x t pointing inwards. */
static inline rectangle furnace_wall(int k)
{
    int axis = k / 2;
    real side = k % 2 ? 1 : -1, out[3] = {-1, -1, -1}, a[3] = {0, 0, 0}, b[3] = {0, 0, 0};
    out[axis] = side;
    a[(axis + 1) % 3] = 2, b[(axis + 2) % 3] = 2;  /* a x b = +axis: inwards where side = -1 */
    vec3 o = {out[0], out[1], out[2]}, s = {a[0], a[1], a[2]}, t = {b[0], b[1], b[2]};
    return k % 2 ? (rectangle){o, t, s} : (rectangle){o, s, t};
}

static inline void furnace_box(lit_scene *s, vec3 E, vec3 rho)
{
    lit_begin(s);
    uint16_t wall = lit_add_material(s, (material){.kd = rho, .ke = E});
    for (int k = 0; k < 6; k++) lit_add_rectangle(s, furnace_wall(k), wall);
    lit_end(s);
}

static inline double furnace_variance(int N, double rho, int n)
{
    double V = 0, S = 1;
    for (int k = 1; k <= n; k++) {
        V = rho * rho / N * ((V + S * S) * 4 / 3 - S * S);
        S = 1 + rho * S;
    }
    return V;
}

#endif
