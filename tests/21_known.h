/* 21_known.h: questions for soft shadows, lobes, the sky, lenses and shutters with known answers.
 *
 *   known k;
 *   known_make(KNOWN_PENUMBRA, &k);           known_free(&k)
 *   k.name, k.truth                           the closed form
 *   double x = known_sample(&k, u)            one sample, by real rays; its expectation is k.truth
 *   estimate e = known_mean(&k, kind, seed, run, n)      of n samples
 *
 *   question                                              answer
 *   KNOWN_SQUARE     irradiance under a rectangle         known_rectangle                   (21.12)
 *   KNOWN_DISK       .. on the axis of a disk             pi L R^2 / (R^2 + h^2)
 *   KNOWN_BALL       .. from a ball above the horizon     I cos / d^2: as from its middle
 *   KNOWN_PENUMBRA   share of a square that is seen past  area of the part of the square beyond
 *                    the edge of a plane                  the edge's shadow line            (21.13)
 *   KNOWN_LOBE       share of a lobe (s = 20) that        glossy_above                       (21.6)
 *                    passes the edge of a ceiling
 *   KNOWN_HORIZON    share of a lobe (s = 1) above the    (1 + cos(angle)) / 2
 *                    surface, 60 degrees
 *   KNOWN_SKY_..     openness: under a disk, under a      (21.8); reach: all but a segment of the
 *                    ball, at a wall, in a corner, near   disk that cosine-distributed directions
 *                    a wall that counts to a reach only   are lifted from
 *   KNOWN_LENS       share of the lens that sees past an  all but a segment of a disk       (21.14)
 *                    edge that is out of focus
 *   KNOWN_SHARP      .. past an edge in focus             1, and each sample is
 *   KNOWN_MOTION     share of the time that a ray meets   known_passing                     (21.18)
 *                    a ball that goes by
 *
 * And a soft shadow and a glossy reflection as they are often made:
 *
 *   area_light_naive(&L, p, ng, ns, u, &x)      x.E as of the centre
 *   glossy_ray_naive(s, d, shine, u, &r)        what leads below the surface is sent into the body
 *
 * (21.12) has 32 digits (22). Source: J. Howell, "A Catalog of Radiation Configuration Factors",
 * 1982, B-4, B-13 (wall, disk).
 */
#ifndef DISTRIBUTED_KNOWN_H
#define DISTRIBUTED_KNOWN_H

#include "../common/lab/t_test.h"
#include "../chapters/21_distributed/distributed.h"
#include "../chapters/22_radiometry/lab/oracle.h"

typedef enum {
    KNOWN_SQUARE, KNOWN_DISK, KNOWN_BALL, KNOWN_PENUMBRA, KNOWN_LOBE, KNOWN_HORIZON,
    KNOWN_SKY_DISK, KNOWN_SKY_BALL, KNOWN_SKY_WALL, KNOWN_SKY_CORNER, KNOWN_SKY_REACH, KNOWN_LENS,
    KNOWN_SHARP, KNOWN_MOTION, known_kinds
} known_kind;

typedef struct {
    known_kind kind;
    const char *name;
    double truth;
    area_light light;
    surface floor;        /* the point that asks: the origin, z up */
    real reach;
    shape shapes[2];
    vec3 corner[8];
    scene s;
    world_part part;
    trace_world w;
    moving ball;          /* KNOWN_MOTION: all that there is */
} known;

/* ---------------------------------------------------------------------------------------------- */

/* The soft shadow as it is often made: the light of the centre, times the share of the shadow rays
 * that get through. Without occluders there is no noise, and E is wrong near a large light: below a
 * square of side 2 at height 1 it is 2.3 times what it should be. */
static inline bool area_light_naive(const area_light *L, vec3 p, vec3 ng, vec3 ns, point2 u,
                                    area_sample *out)
{
    area_light centre = *L;
    area_sample x;
    bool any = area_light_reaches(L, p, ng, ns, u, out);
    centre.a = centre.b = (vec3){0, 0, 0}, centre.r = 0;
    any = area_light_reaches(&centre, p, ng, ns, u, &x) && any;
    out->E = any ? x.E : (vec3){0, 0, 0};
    return any;
}

/* Under a thin floor it sees the sky below: the floor shines in the dark. */
static inline bool glossy_ray_naive(surface s, vec3 d, real shine, point2 u, ray *out)
{
    *out = leave(s, glossy_direction(s, d, shine, u));
    return true;
}

/* The share of (21.4) above the surface, c = n.r. With z = r.w and x the axis of the lobe in the
 * plane of n and r: n.w = c z + sin cos(phi) sqrt(1 - z^2) > 0 for cos(phi) > -edge, edge = z c /
 * (sqrt(1 - z^2) sin): a share acos(-edge) / pi of the circle. All of it (c > 0) or nothing (c < 0)
 * where z > sin. The mean of that over y = z^(s+1), which is uniform: midpoints up to y* =
 * sin^(s+1), denser near both ends, where the arc cosine is steep. Right to 1e-7.         (21.6) */
static inline double glossy_above(double c, double shine)
{
    enum { steps = 2000 };
    double sine = sqrt((1 - c) * (1 + c)), sum = 0;
    if (isinf(shine) || sine == 0) return c > 0;
    double log_y = (shine + 1) * log(sine), beyond = c > 0 ? -expm1(log_y) : 0;
    for (int i = 0; i < steps; i++) {
        double x = (i + 0.5) / steps, dy = 6 * x * (1 - x) / steps;
        double l = (log_y + log(x * x * (3 - 2 * x))) / (shine + 1), z = exp(l);
        double edge = z * c / (sqrt(-expm1(2 * l)) * sine);
        sum += dy * acos(edge < -1 ? 1 : edge > 1 ? -1 : -edge);
    }
    return beyond + exp(log_y) * sum / 3.14159265358979323846;
}

/* Form factor from a point to a rectangle that is parallel at distance 1. */
static inline double known_rectangle(double x0, double x1, double y0, double y1)
{
    rectangle r = {vec(x0, y0, 1), vec(0, y1 - y0, 0), vec(x1 - x0, 0, 0)};
    return rectangle_irradiance_exact(r, (vec3){0, 0, 0}, (vec3){0, 0, 1}) / (double)pi;
}

/* The part of the unit disk's area, 1 in all, with x > h, |h| <= 1. */
static inline double known_segment(double h)
{
    return (acos(h) - h * sqrt((1 - h) * (1 + h))) / (double)pi;
}

/* The share of the time in which the line o + t d meets a ball about c + time v: its distance from
 * the middle, |w x d| / |d| with w = c - o + time v, is r at two times, less between.  (21.18) */
static inline double known_passing(vec3 o, vec3 d, sphere b, vec3 v)
{
    vec3 at = vcross(vsub(b.c, o), d), by = vcross(v, d);
    double A = (double)vdot(by, by), B = (double)vdot(at, by);
    double C = (double)(vdot(at, at) - b.r * b.r * vdot(d, d)), under = B * B - A * C;
    if (A == 0) return C <= 0;
    if (!(under > 0)) return 0;
    double t0 = (-B - sqrt(under)) / A, t1 = (-B + sqrt(under)) / A;
    return fmax(fmin(t1, 1) - fmax(t0, 0), 0);
}

/* Where a sheet without end ends: so far away that what lies beyond is at most 2 / known_far of a
 * hemisphere, and not so far that a hit on a polygon, right to 32 epsilon of its size (07), might
 * lie behind a point at distance 1. */
enum { known_far = sizeof(real) == sizeof(float) ? 4096 : 1000000 };

/* From an edge at -+ a to the far edge, at + b. */
static inline shape known_sheet(known *k, int i, vec3 at, vec3 a, vec3 b)
{
    vec3 *v = k->corner + 4 * i;
    v[0] = vsub(at, a), v[1] = vadd(at, a);
    v[2] = vadd(v[1], b), v[3] = vadd(v[0], b);
    return shape_of_polygon(polygon_of(v, 4));
}

static inline void known_lights(known *k)
{
    vec3 down = {0, 0, -1};
    if (k->kind == KNOWN_SQUARE) {
        k->light = (area_light){AREA_RECTANGLE, {0.5, 0.25, 1}, {2, 0, 0},
                                {0, 1.5, 0}, down, 0, {3, 3, 3}};
        k->truth = (double)pi * known_rectangle(-0.5, 1.5, -0.5, 1);
    } else if (k->kind == KNOWN_DISK) {
        k->light = (area_light){AREA_DISK, {0, 0, 1}, {0.75, 0, 0}, {0, 0.75, 0}, down,
                                0, {1, 1, 1}};
        k->truth = 1 / (1 + 0.75 * 0.75);  /* L = 1 / (pi R^2) */
    } else if (k->kind == KNOWN_BALL) {
        k->light = (area_light){AREA_BALL, {1.5, 0, 2}, .r = 1, .colour = {1, 1, 1}};
        k->truth = 2 / 2.5 / (2.5 * 2.5);
    } else {
        /* The square [-1,1]^2 at z = 2; at z = 1 a plane that begins at the line c x + s y = .13,
         * (c, s) = (12, 5) / 13: on the light c x + s y = .26, from its lower to its upper side. */
        vec3 across = {(real)48 / 13, (real)20 / 13, 0}, along = {(real)-20 / 13, (real)48 / 13, 0};
        vec3 edge = {0.12, 0.05, 1};
        k->light = (area_light){AREA_RECTANGLE, {0, 0, 2}, {2, 0, 0}, {0, 2, 0}, down, 0,
                                {1, 1, 1}};
        k->shapes[0] = known_sheet(k, 0, edge, along, across);
        k->truth = (1 + 0.26 * 13 / 12) / 2;
        k->s.n = 1;
    }
}

static inline void known_skies(known *k)
{
    vec3 up = {0, 0, known_far}, out = {known_far, 0, 0}, aside = {0, known_far, 0};
    k->s.n = 1;
    switch (k->kind) {
    case KNOWN_SKY_DISK:  /* a cone whose base it is, apex up: open below, and not to be missed */
        k->shapes[0] = shape_of_cone((cone){{0, 0, 0.5}, 0.75, {0, 0, 1}, 0});
        k->truth = 0.25 / (0.25 + 0.5625);
        break;
    case KNOWN_SKY_BALL:
        k->shapes[0] = shape_of_sphere((sphere){{0, 0, 1.8}, 1});
        k->truth = 1 - 1 / (1.8 * 1.8);
        break;
    case KNOWN_SKY_WALL:  /* 2 high, 1 away; the sheet goes down, from its upper edge */
        k->shapes[0] = known_sheet(k, 0, (vec3){1, 0, 2}, aside, vneg(up));
        k->truth = (1 + 1 / sqrt(5.0)) / 2;
        break;
    case KNOWN_SKY_CORNER:
        k->shapes[0] = known_sheet(k, 0, (vec3){1, 0, -1}, aside, up);
        k->shapes[1] = known_sheet(k, 1, (vec3){0, 1, -1}, out, up);
        k->s.n = 2, k->truth = 0.25;
        break;
    case KNOWN_SKY_REACH:
        k->shapes[0] = known_sheet(k, 0, (vec3){1, 0, -1}, aside, up);
        k->reach = 2.5, k->truth = 1 - known_segment(0.4);
        break;
    case KNOWN_LOBE:  /* a ceiling at z = 1 for x > .2 */
        k->shapes[0] = known_sheet(k, 0, vec(0.2, 0, 1), aside, out);
        k->truth = glossy_above(0.2 / sqrt(1.04), 20);
        break;
    case KNOWN_LENS:   /* R = .3, F = 2: at z = 4 the lens is as wide again, upside down */
    case KNOWN_SHARP:
        k->shapes[0] = known_sheet(k, 0, vec(0.135, 0, k->kind == KNOWN_LENS ? 4 : 2),
                                   aside, out);
        k->truth = k->kind == KNOWN_LENS ? 1 - known_segment(0.45) : 1;
        break;
    case KNOWN_MOTION:  /* seen straight up: it comes into sight, and leaves it */
        k->shapes[0] = shape_of_sphere((sphere){{(real)-0.75, (real)-0.25, 4}, (real)0.5});
        k->ball.v = vec(1.5, 0.75, -1);
        k->truth = known_passing(k->floor.p, k->floor.n, k->shapes[0].sphere, k->ball.v);
        break;
    default: k->s.n = 0, k->truth = 0.75; break;  /* KNOWN_HORIZON */
    }
}

static inline void known_make(known_kind kind, known *k)
{
    static const char *const names[known_kinds] = {
        "under a rectangle", "under a disk", "under a ball", "penumbra", "lobe past an edge",
        "lobe above the surface", "sky behind a disk", "sky behind a ball", "sky at a wall",
        "sky in a corner", "sky at a wall, reach", "lens past an edge", "lens, edge in focus",
        "a ball goes by"};
    vec3 up = {0, 0, 1};
    *k = (known){.kind = kind, .name = names[kind], .reach = real_infinity};
    k->floor = (surface){{0, 0, 0}, up, up, 0, 0, no_shape};
    k->s.shapes = k->shapes;
    if (kind <= KNOWN_PENUMBRA) known_lights(k);
    else known_skies(k);
    world_part_of_scene(&k->s, MASK_ALL, &k->part);
    k->w = (trace_world){&k->part, 1};
    if (kind == KNOWN_MOTION) k->ball.w = k->w, k->w.parts = 0;
}

static inline void known_free(known *k) { world_part_free(&k->part); }

/* The eye at the origin looks up; the picture is one pixel, and its middle is the zenith. */
static inline ray known_eye(point2 u)
{
    static const camera c = {CAMERA_PERSPECTIVE, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1},
                             -1, 1, -1, 1, 1, {0, 0, 0}};
    return lens_ray(c, (thin_lens){0.3, 2}, 0.5, 0.5, 1, 1, u);
}

static inline double known_passes(tracer *t, ray_kind kind, ray r)
{
    shade_lit answer = {false};
    trace(t, kind, r, &answer);
    return answer.lit;
}

static inline double known_sample(const known *k, point2 u)
{
    static const ray_program programs[ray_kinds] = {
        [RAY_CAMERA] = {MASK_ALL, true, NULL, NULL, shade_nothing_between},
        [RAY_SHADOW] = {MASK_ALL, true, NULL, NULL, shade_nothing_between},
        [RAY_REFLECTION] = {MASK_ALL, true, NULL, NULL, shade_nothing_between},
        [RAY_SIGHT] = {MASK_ALL, true, NULL, NULL, shade_nothing_between}};
    tracer t = {.w = &k->w, .program = programs};
    const surface *s = &k->floor;
    vec3 down = {0, 0, -1};
    area_sample x;
    ray r;
    switch (k->kind) {
    case KNOWN_SQUARE: case KNOWN_DISK: case KNOWN_BALL:
        area_light_reaches(&k->light, s->p, s->n, s->ns, u, &x);
        return (double)x.E.x;
    case KNOWN_PENUMBRA:
        area_light_reaches(&k->light, s->p, s->n, s->ns, u, &x);
        return known_passes(&t, RAY_SHADOW, leave_to(*s, x.to));
    case KNOWN_LOBE:
        return glossy_ray(*s, down, 20, u, &r) ? known_passes(&t, RAY_REFLECTION, r) : 0;
    case KNOWN_HORIZON: return glossy_ray(*s, vec(sqrt((real)0.75), 0, -0.5), 1, u, &r);
    case KNOWN_LENS: case KNOWN_SHARP: return known_passes(&t, RAY_CAMERA, known_eye(u));
    case KNOWN_MOTION: return motion_any(&t, &k->ball, 1, u.u, RAY_CAMERA, ray_from(s->p, s->n));
    default: return ambient_ray(*s, u, k->reach, &r) ? known_passes(&t, RAY_SIGHT, r) : 0;
    }
}

static inline estimate known_mean(const known *k, sequence_kind kind, uint64_t seed, uint64_t run,
                                  uint32_t n)
{
    estimate e = {0};
    for (uint32_t i = 0; i < n; i++) {
        sampler s = sampler_start(kind, seed, run, i, n);
        e = estimate_add(e, known_sample(k, sampler_pair(&s)));
    }
    return e;
}

#endif
