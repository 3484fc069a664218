/* sampling_naive.h: ways to a disk, a triangle, a sphere that are wrong.
 *
 * What comes out is not uniform, and every estimate that takes it for uniform has an error that no
 * number of samples mends. Pictures hide it, chi-square shows it (tests/20_sampling.c).
 *
 *   sample_disk_naive          r = u: half of the points in the inner quarter of the area, and
 *                              their density grows without bound towards the centre
 *   sample_triangle_naive      b1 = u, b2 = v (1 - u): crowds at the corner u = 1
 *   sample_sphere_naive        a point of the cube, normalised: crowds towards the corners; the
 *                              density there is 3^1.5 = 5.2 times that at the faces' middles
 *   sample_hemisphere_naive    theta = pi/2 u: crowds at the pole
 */
#ifndef MONTE_CARLO_SAMPLING_NAIVE_H
#define MONTE_CARLO_SAMPLING_NAIVE_H

#include "../../../common/random.h"
#include "../sampling.h"

/* ---------------------------------------------------------------------------------------------- */

static inline vec3 sample_disk_naive(real u, real v) { return sample_turn(u, 0, v); }

static inline vec3 sample_triangle_naive(real u, real v)
{
    return (vec3){(1 - u) * (1 - v), u, v * (1 - u)};
}

/* A third number: the lower digits of u, which are as random as the upper ones. */
static inline real lower_digits(real u)
{
    real x = u * 4096;
    return x - floor(x);
}

static inline vec3 sample_sphere_naive(real u, real v)
{
    return vunit((vec3){2 * u - 1, 2 * v - 1, 2 * lower_digits(u) - 1});
}

static inline vec3 sample_hemisphere_naive(real u, real v)
{
    return sample_turn(sin(pi / 2 * u), cos(pi / 2 * u), v);
}

#endif
