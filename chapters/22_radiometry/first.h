/* first.h: solid angle, and the irradiance of a shining ball: by its formula, and by directions.
 * Wrong: 1 - cos a is 0 for small caps (a < 0.0002 in float, 1e-8 in double), and what of the ball
 * is below the horizon (22.10) takes away. solid_angle.h and lab/sphere_irradiance.h mend both. */
#ifndef FIRST_RADIOMETRY_H
#define FIRST_RADIOMETRY_H
#include "../03_sphere/first.h"
#include "../20_monte_carlo/first.h"

/* Solid angle (立体角) of all directions within the angle a of one: the integral of
 *     d omega = sin theta d theta d phi                                                  (22.2)
 * over phi up to 2 pi and theta up to a is 2 pi (1 - cos a).                             (22.3) */
static inline real first_cap_solid_angle(real a) { return 2 * pi * (1 - cos(a)); }

/* A ball fills the cap with sin a = R / d, seen from p outside of it.                    (22.4) */
static inline real first_sphere_solid_angle(sphere s, vec3 p)
{
    return first_cap_solid_angle(asin(s.r / vlength(vsub(s.c, p))));
}

/* Irradiance (辐射照度) at p, of unit normal n, under a ball of radiance (辐射亮度) L: the same as
 * of a point of intensity I = L pi R^2, E = I cos / d^2 (22.7). Wholly over the horizon. (22.10) */
static inline real first_sphere_irradiance(sphere s, real L, vec3 p, vec3 n)
{
    vec3 d = vsub(s.c, p);
    real intensity = L * pi * s.r * s.r;
    return intensity * real_max(vdot(n, vunit(d)), 0) / vdot(d, d);
}

/* E = integral of L cos theta d omega over the hemisphere (22.9). One uniform direction, p = 1/2pi,
 * is worth L cos / p; if it misses the ball, nothing.                                   (22.11) */
static inline real first_irradiance_sample(sphere s, real L, vec3 p, vec3 n, real u, real v)
{
    vec3 z = first_uniform_direction(u, v);
    hit h;
    if (!first_sphere_hit(s, ray_from(p, directed(n, z)), &h)) return 0;
    return L * z.z * 2 * pi;
}

static inline first_samples first_irradiance_by_directions(sphere s, real L, vec3 p, vec3 n, int N,
                                                           random_stream *random)
{
    first_samples E = {0, 0, 0};
    for (int i = 0; i < N; i++) {
        real u = random_next(random), v = random_next(random);
        first_sample(&E, first_irradiance_sample(s, L, p, n, u, v));
    }
    return E;
}
#endif
