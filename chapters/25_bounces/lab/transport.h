/* transport.h: the rendering equation (渲染方程) as an operator (算子), on surfaces cut into patches.
 *
 *   L(x,wo) = E(x,wo) + integral of f(wi,wo) L(x',-wi) cos dwi,  x' what x sees along wi    (25.1)
 *   L = E + K L                          K: light that left all surfaces -> what they reflect of it
 *   L = (I - K)^-1 E                     one linear system                                  (25.2)
 *     = E + K E + K^2 E + K^3 E + ...    Neumann series (诺伊曼级数): sorted by bounces     (25.3)
 *
 * Matte patches i of albedo rho_i, the radiance L_i the same all over each: L is a list of n
 * numbers, K a matrix. F_ij is the form factor (形状因子), the share of what leaves i that goes to j:
 *
 *   K_ij = rho_i F_ij,   sum over j of F_ij = 1 if the room is closed, less if it is open   (25.4)
 *
 * Here two patches, which are enough for every case:
 *
 *   transport t = {.E = {1, 0}, .K = {{0, 0.5}, {0.5, 0}}};
 *   transport_apply(&t, L, out);          out = K L; not in place
 *   transport_bounces(&t, k, false, out); K^k E
 *   transport_bounces(&t, k, true, out);  E + K E + ... + K^k E
 *   transport_solve(&t, out)              (25.2) by Cramer's rule; false if I - K is singular
 *   transport_norm(&t)                    ||K|| = largest sum of a row
 *   transport_radius(&t)                  spectral radius (谱半径) of a K >= 0: its larger eigenvalue
 *
 * If ||K|| < 1, the k-th term is at most ||K||^k max E: safe, but not needed. What decides whether
 * (25.3) converges is the spectral radius (MEASURED.md). With radius >= 1 I - K is singular, or
 * (25.2) has a solution with negative light that no sum of positive terms ever reaches.
 *
 * Numbers are double whatever real is: this is an oracle. Sources: J. Kajiya, "The Rendering
 * Equation", SIGGRAPH 1986; J. Arvo, "Analytic Methods for Simulated Light Transport", PhD thesis,
 * Yale, 1995 (norms of K); C. Goral et al., SIGGRAPH 1984 (radiosity, 辐射度方法).
 */
#ifndef BOUNCES_TRANSPORT_H
#define BOUNCES_TRANSPORT_H

#include <float.h>
#include <math.h>
#include <stdbool.h>

typedef struct { double E[2], K[2][2]; } transport;

/* ---------------------------------------------------------------------------------------------- */

static inline void transport_apply(const transport *t, const double *L, double *out)
{
    for (int i = 0; i < 2; i++) out[i] = t->K[i][0] * L[0] + t->K[i][1] * L[1];
}

/* out = E, and then k times out = K out, + E if the sum is asked for: S_0 = E, S_k = E + K S_(k-1),
 * what the recursion of the notes computes, from the inside out. */
static inline void transport_bounces(const transport *t, int k, bool sum, double *out)
{
    out[0] = t->E[0], out[1] = t->E[1];
    for (; k > 0; k--) {
        const double old[2] = {out[0], out[1]};
        transport_apply(t, old, out);
        for (int i = 0; sum && i < 2; i++) out[i] += t->E[i];
    }
}

/* A determinant below some epsilon is rounding: rows of I - K are of size 1. */
static inline bool transport_solve(const transport *t, double *out)
{
    double a = 1 - t->K[0][0], b = t->K[0][1], c = t->K[1][0], d = 1 - t->K[1][1];
    double det = a * d - b * c;
    if (!(fabs(det) > 2 * DBL_EPSILON)) return false;
    out[0] = (d * t->E[0] + b * t->E[1]) / det, out[1] = (c * t->E[0] + a * t->E[1]) / det;
    return true;
}

static inline double transport_norm(const transport *t)
{
    return fmax(fabs(t->K[0][0]) + fabs(t->K[0][1]), fabs(t->K[1][0]) + fabs(t->K[1][1]));
}

static inline double transport_radius(const transport *t)
{
    double half = (t->K[0][0] - t->K[1][1]) / 2;
    return (t->K[0][0] + t->K[1][1]) / 2 + sqrt(half * half + t->K[0][1] * t->K[1][0]);
}

#endif
