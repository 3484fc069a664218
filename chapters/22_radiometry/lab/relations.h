/* relations.h: the definitions and laws of radiometry, each as a number that can be measured.
 *
 * A relation has a closed form, and an experiment whose mean is that number if the law is right:
 * one call of `sample` is one ray or one photon (光子), weighted. relation_measure(k, seed, n) does
 * n of them, of relation_of(k), k < relations. `holds` is false for those that are often believed,
 * and wrong: there z must be huge.
 *
 *   Omega = A / r^2                       (22.1)    E = dPhi / dA                       (22.6)
 *   d omega = sin theta d theta d phi     (22.2)    E = I cos theta / r^2               (22.7)
 *   I = dPhi / d omega                    (22.5)   L = d^2 Phi / (dA cos theta d omega) (22.8)
 *   Phi = integral of I over all          (22.21)   E = integral of L cos theta d omega (22.9)
 *
 * Sources: F. Nicodemus et al., "Geometrical Considerations and Nomenclature for Reflectance", NBS
 * Monograph 160, 1977; Marschner, Shirley, "Fundamentals of Computer Graphics", 2015, 18.1.
 */
#ifndef RADIOMETRY_RELATIONS_H
#define RADIOMETRY_RELATIONS_H

#include "../../../common/numbers/estimate.h"
#include "../../../common/random.h"
#include "../spherical_sampling.h"

typedef struct {
    const char *name, *unit;
    double closed;
    real (*sample)(random_stream *);
    bool holds;
} relation;

/* ---------------------------------------------------------------------------------------------- */

/* The things that are looked at, from the origin; z is up. */
static const sphere ball = {{0, 0, 2}, 1};
static const vec3 seen_from = {0, 0, 0}, seen_up = {0, 0, 1};

/* ---- solid angle ---- */

/* theta and phi uniform in their intervals: (22.2) says how much each counts. */
static inline real all_sample(random_stream *s) { return 2 * pi * pi * sin(pi * random_next(s)); }

/* Uniform: 4 pi times the share of them that meets a thing is its solid angle. */
static inline vec3 any_direction(random_stream *s)
{
    real u = random_next(s), v = random_next(s);
    return sample_sphere(u, v);
}

static inline real cap_sample(random_stream *s)
{
    return any_direction(s).z > cos(pi / 6) ? 4 * pi : 0;
}

static inline real ball_sample(random_stream *s)
{
    hit h;
    return sphere_hit(ball, ray_from(seen_from, any_direction(s)), &h) ? 4 * pi : 0;
}

/* ---- flux and intensity: I = 1 W/sr, everywhere or along the axis ---- */

/* A spotlight, I = cos^8 theta in front. */
#define spot_flux (2 * (double)pi / 9)
static inline real spot_sample(random_stream *s)
{
    real z = any_direction(s).z, z2 = z * z;
    return z > 0 ? 4 * pi * z2 * z2 * z2 * z2 : 0;
}

/* ---- irradiance: photons on areas ---- */

/* A source of Phi = 4 pi W in a ball of radius r. Photons a square metre on a piece of the ball, a
 * cap of 0.1 sr; they start in a cone of 0.2 sr. */
static inline real caught(random_stream *s, real r)
{
    direction_cone around = {(real)0.2 / (4 * pi)}, cap = {(real)0.1 / (4 * pi)};
    real u = random_next(s), v = random_next(s), power = 4 * pi * around.half_sine2;
    vec3 at = vscale(sample_cone(around, u, v), r);
    real side = r * (1 - 2 * cap.half_sine2), area = (real)0.1 * r * r;
    return at.z > side ? power / area : 0;
}

static inline real caught_1(random_stream *s) { return caught(s, 1); }
static inline real caught_2(random_stream *s) { return caught(s, 2); }

/* A beam of 1 W/m^2, 2 m wide and high, onto a plate of 1 m^2 that is turned by 60 degrees. */
static inline real tilted_sample(random_stream *s)
{
    real x = 2 * random_next(s) - 1, y = 2 * random_next(s) - 1, cosine = 0.5;
    bool met = fabs(x) <= (real)0.5 && fabs(y / cosine) <= (real)0.5;
    return met ? 4 : 0;
}

/* ---- radiance ---- */

/* A meter: an opening of radius 0.1, behind it a tube that lets through what comes within 0.1 rad
 * of its axis. It looks at a wall of L = 1 at distance d. Power goes from each dA' of the wall to
 * each dA of the opening: L cos cos' / r^2 dA dA'. Divided by opening and projected solid angle: L.
 */
static inline real meter(random_stream *s, real d)
{
    const real a = 0.1, tube = 0.1;
    real spot = a + d * tan(tube), sine = sin(tube);
    real u = random_next(s), v = random_next(s), u2 = random_next(s), v2 = random_next(s);
    vec3 x = vscale(sample_disk(u, v), a), y = vscale(sample_disk(u2, v2), spot), w;
    y.z = d;
    w = vsub(y, x);
    real r2 = vdot(w, w), cosine = w.z / sqrt(r2);
    if (cosine < cos(tube)) return 0;
    return cosine * cosine / r2 * (pi * spot * spot) / (pi * sine * sine);
}

static inline real meter_1(random_stream *s) { return meter(s, 1); }
static inline real meter_1000(random_stream *s) { return meter(s, 1000); }

/* L = 1 from everywhere above, directions uniform in the hemisphere. */
static inline real sky_sample(random_stream *s)
{
    real u = random_next(s), v = random_next(s);
    vec3 w = sample_hemisphere(u, v);
    return w.z / pdf_hemisphere(w);
}

/* A disk of 1 m^2 that shines with L = 1: power in the direction 60 degrees off, per sr. Photons
 * leave with the density cos / pi; a ring of directions, cos in [0.45, 0.55], counts them. */
static inline real lambert_sample(random_stream *s)
{
    real u = random_next(s), v = random_next(s), ring = 2 * pi * (real)0.1;
    real z = sample_cosine(u, v).z;
    return z > (real)0.45 && z < (real)0.55 ? pi / ring : 0;
}

/* ---- all of them ---- */

enum { relations = 15 };

static inline relation relation_of(size_t k)
{
    const double one_pi = (double)pi, four_pi = 4 * one_pi;
    const relation list[relations] = {
        {"all directions, (22.2)", "sr", four_pi, all_sample, true},
        {"cap of 30 degrees", "sr", (double)cap_solid_angle(pi / 6), cap_sample, true},
        {"sphere, R = 1, d = 2", "sr", (double)sphere_solid_angle(ball, seen_from), ball_sample,
         true},
        {"flux, I = 1 everywhere: 4 pi I", "W", four_pi, all_sample, true},
        {"flux of a spotlight, I = cos^8", "W", spot_flux, spot_sample, true},
        {"- is it 4 pi I, as the notes say?", "W", four_pi, spot_sample, false},
        {"irradiance at 1 m, I = 1", "W/m^2", 1, caught_1, true},
        {"irradiance at 2 m", "W/m^2", 0.25, caught_2, true},
        {"- beam, plate turned by 60 degrees", "W/m^2", 1, tilted_sample, false},
        {"the same with the cosine", "W/m^2", 0.5, tilted_sample, true},
        {"radiance of a wall from 1 m", "W/(m^2 sr)", 1, meter_1, true},
        {"radiance of a wall from 1000 m", "W/(m^2 sr)", 1, meter_1000, true},
        {"intensity of a disk, 60 degrees off", "W/sr", 0.5, lambert_sample, true},
        {"irradiance of a white sky: pi L", "W/m^2", one_pi, sky_sample, true},
        {"- is it 2 pi L, without the cosine?", "W/m^2", 2 * one_pi, sky_sample, false}};
    return list[k];
}

static inline estimate relation_measure(size_t k, uint64_t seed, size_t n)
{
    const relation of = relation_of(k);
    estimate e = {0};
    for (size_t i = 0; i < n; i++) {
        random_stream s = random_start(seed, k, i);
        e = estimate_add(e, (double)of.sample(&s));
    }
    return e;
}

#endif
