/* first.h: integrals by chance: an estimator and its error, inversion, importance; directions.
 * Wrong: variance as mean of squares minus square of the mean. For mean 1000, deviation 1 it keeps
 * no digit in float, and may be negative. estimate.h (20.11) mends it. */
#ifndef FIRST_MONTE_CARLO_H
#define FIRST_MONTE_CARLO_H
#include "../../common/random.h"

typedef struct { real n, sum, squares; } first_samples;

static inline void first_sample(first_samples *s, real y)
{
    s->n += 1;
    s->sum += y;
    s->squares += y * y;
}

/* The mean (y_1 + ... + y_N) / N, each y being f/p of a random X.                        (20.3) */
static inline real first_mean(first_samples s) { return s.sum / s.n; }

/* The variance (方差) of one sample; N - 1, since the mean is an estimate itself.        (20.5) */
static inline real first_variance(first_samples s)
{
    return (s.squares / s.n - first_mean(s) * first_mean(s)) * s.n / (s.n - 1);
}

/* The standard error (标准误差) of the mean: four times the samples halve it.            (20.6) */
static inline real first_error(first_samples s) { return sqrt(first_variance(s) / s.n); }

/* ------------------------------------------------------------------------------------------------
 * Three ways to pi. All are f(X) / p(X) with X drawn from p: on average each is the integral
 * of f (20.4); the more p looks like f, the less f / p varies. u, v: uniform in [0,1). */

/* Darts (飞镖): f = 4 inside the quarter of a disk, else 0; p = 1. Variance pi (4 - pi) = 2.70 */
static inline real first_pi_darts(real u, real v) { return u * u + v * v < 1 ? 4 : 0; }

/* f = 4 sqrt(1 - x^2) on [0,1], p = 1. Variance 32/3 - pi^2 = 0.80 */
static inline real first_pi_uniform(real u) { return 4 * sqrt(1 - u * u); }

/* A density that falls as f does, p = (4 - 2x) / 3, and x drawn from it by inversion (逆变换): the
 * probability of a sample below x, P(x) = (4x - x^2) / 3, is to be u.                    (20.7) */
static inline real first_pi_density(real x) { return (4 - 2 * x) / 3; }
static inline real first_pi_inversion(real u) { return 2 - sqrt(4 - 3 * u); }

/* The same f with this p: importance sampling (重要性采样). Variance 60 - 72 ln 2 - pi^2 = 0.22 */
static inline real first_pi_importance(real u)
{
    real x = first_pi_inversion(u);
    return 4 * sqrt(real_max(1 - x * x, 0)) / first_pi_density(x);
}

/* ------------------------------------------------------------------------------------------------
 * Directions of the upper hemisphere, z >= 0, by inversion of the height z. */

/* Uniform: heights are evenly spread (Archimedes). p = 1 / (2 pi) */
static inline vec3 first_uniform_direction(real u, real v)
{
    real r = sqrt(real_max(1 - u * u, 0)), phi = 2 * pi * v;
    return vec(r * cos(phi), r * sin(phi), u);
}

/* Towards the pole: p = cos(theta) / pi, and each weight of cos(theta) is pi            (20.10).
 * The probability of a height below z is then z^2: with 1 - u for it, z = sqrt(1 - u). */
static inline vec3 first_cosine_direction(real u, real v)
{
    real r = sqrt(u), phi = 2 * pi * v;
    return vec(r * cos(phi), r * sin(phi), sqrt(1 - u));
}

/* w, given round the z axis, now round the unit vector n. */
static inline vec3 directed(vec3 n, vec3 w)
{
    vec3 s, t;
    vbasis(n, &s, &t);
    return vadd(vadd(vscale(s, w.x), vscale(t, w.y)), vscale(n, w.z));
}
#endif
