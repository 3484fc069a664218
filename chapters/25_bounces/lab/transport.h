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
 *   transport t = transport_new(n);       n < 46341 patches, all zero; fill t.E[i], t.K[i * n + j]
 *   transport_apply(&t, L, out);          out = K L; not in place                    O(n^2)
 *   transport_bounces(&t, k, false, out); K^k E                                      O(k n^2)
 *   transport_bounces(&t, k, true, out);  E + K E + ... + K^k E
 *   transport_solve(&t, out)              (25.2) by elimination; false if I - K is singular, O(n^3)
 *   transport_norm(&t)                    ||K|| = largest sum of a row
 *   transport_radius(&t, steps)           spectral radius (谱半径) of a K >= 0, by powers
 *   transport_free(&t);                   a zeroed one may be freed
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

#include "../../../common/file.h"
#include "../../../common/vec3.h"

typedef struct { int n; double *E, *K; } transport;  /* K row by row */

/* ---------------------------------------------------------------------------------------------- */

static inline transport transport_new(int n)
{
    return (transport){n, allocate((size_t)n, sizeof(double)),
                       allocate((size_t)n * (size_t)n, sizeof(double))};
}

static inline void transport_free(transport *t)
{
    free(t->E), free(t->K);
    *t = (transport){0, NULL, NULL};
}

static inline void transport_apply(const transport *t, const double *L, double *out)
{
    for (int i = 0; i < t->n; i++) {
        const double *row = t->K + (size_t)i * (size_t)t->n;
        out[i] = 0;
        for (int j = 0; j < t->n; j++) out[i] += row[j] * L[j];
    }
}

/* out = E, and then k times out = K out, + E if the sum is asked for: S_0 = E, S_k = E + K S_(k-1),
 * what the recursion of the notes computes, from the inside out. */
static inline void transport_bounces(const transport *t, int k, bool sum, double *out)
{
    double *old = allocate((size_t)t->n, sizeof *old);
    for (int i = 0; i < t->n; i++) out[i] = t->E[i];
    for (; k > 0; k--) {
        for (int i = 0; i < t->n; i++) old[i] = out[i];
        transport_apply(t, old, out);
        for (int i = 0; sum && i < t->n; i++) out[i] += t->E[i];
    }
    free(old);
}

/* Gauss and Jordan, with row pivots. A pivot below n epsilon is rounding: rows of I - K are of size
 * 1. Column n is x. */
static inline bool transport_eliminate(double *A, double *x, int n)
{
    for (int c = 0; c < n; c++) {
        int p = c;
        for (int i = c + 1; i < n; i++)
            if (fabs(A[i * n + c]) > fabs(A[p * n + c])) p = i;
        if (!(fabs(A[p * n + c]) > n * DBL_EPSILON)) return false;
        for (int j = 0; j <= n; j++) {
            double *a = j < n ? &A[c * n + j] : &x[c], *b = j < n ? &A[p * n + j] : &x[p], old = *a;
            *a = *b, *b = old;
        }
        for (int i = 0; i < n; i++) {
            double m = i == c ? 0 : A[i * n + c] / A[c * n + c];
            for (int j = c; j < n; j++) A[i * n + j] -= m * A[c * n + j];
            x[i] -= m * x[c];
        }
    }
    for (int i = 0; i < n; i++) x[i] /= A[i * n + i];
    return true;
}

static inline bool transport_solve(const transport *t, double *out)
{
    size_t n = (size_t)t->n;
    double *A = allocate(n * n, sizeof *A);
    for (size_t i = 0; i < n; i++) out[i] = t->E[i];
    for (size_t i = 0; i < n * n; i++) A[i] = (i % (n + 1) == 0) - t->K[i];
    bool regular = transport_eliminate(A, out, t->n);
    free(A);
    return regular;
}

static inline double transport_norm(const transport *t)
{
    double most = 0;
    for (int i = 0; i < t->n; i++) {
        double row = 0;
        for (int j = 0; j < t->n; j++) row += fabs(t->K[i * t->n + j]);
        most = row > most ? row : most;
    }
    return most;
}

/* Powers of (I + K)/2, whose largest eigenvalue is (1 + radius)/2 and alone in its size: K itself
 * may have -radius, too (light that goes to and fro between two surfaces), and never settle. */
static inline double transport_radius(const transport *t, int steps)
{
    double *v = allocate((size_t)t->n, sizeof *v), *w = allocate((size_t)t->n, sizeof *w);
    double grown = 0;
    for (int i = 0; i < t->n; i++) v[i] = 1;
    for (int k = 0; k < steps; k++) {
        transport_apply(t, v, w);
        grown = 0;
        for (int i = 0; i < t->n; i++) {
            w[i] = (w[i] + v[i]) / 2;
            grown = w[i] > grown ? w[i] : grown;
        }
        for (int i = 0; i < t->n; i++) v[i] = w[i] / grown;
    }
    free(v), free(w);
    return 2 * grown - 1;
}

#endif
