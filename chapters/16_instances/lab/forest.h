/* forest.h: plants of a few kinds, by the thousand, on rolling ground; and its picture.
 *
 *   forest w;
 *   forest_plant(&w, n, seed)           n plants
 *   crowd c = forest_crowd(&w)
 *   camera c = forest_camera(aspect)
 *   forest_view v = {&w, &x, c, width, height, naive};
 *   pixels_draw(&im, 3, threads, "forest", forest_colour, &v)
 *   forest_free(&w)
 *
 * Instance 0 is the ground. The others are turned, scaled unlike in height and width, and mirrored,
 * every second one. So dense that each has 20 square units; more of them reach farther.
 *
 * Light is the headlight of 02, and another one from the direction of the sun where nothing is in
 * between (instances_occluded). Far away all fades into the sky.
 */
#ifndef INSTANCES_LAB_FOREST_H
#define INSTANCES_LAB_FOREST_H

#include "../../../common/headlight.h"
#include "../../../common/lab/pixels.h"
#include "../../02_camera/camera.h"
#include "../../07_mesh/scenes/specimens.h"
#include "naive.h"
#include "plants.h"

typedef struct {
    mesh mesh[plant_kinds];
    uint32_t wood[plant_kinds];
    instance *list;                /* [n] */
    size_t n;
} forest;

typedef struct {
    const forest *w;
    const instances *x;
    camera c;
    int width, height;
    bool naive;                    /* rays normalised: instances_hit_naive */
} forest_view;

/* ---------------------------------------------------------------------------------------------- */

static inline void forest_free(forest *w)
{
    for (size_t k = 0; k < plant_kinds; k++) mesh_free(&w->mesh[k]);
    free(w->list);
    *w = (forest){.list = NULL};
}

static inline crowd forest_crowd(const forest *w)
{
    return (crowd){w->mesh, plant_kinds, w->list, w->n};
}

/* Of (x, y): beyond a valley it rises. */
static inline vec3 ground_at(real x, real y)
{
    real hills = 6 * sin((real)0.021 * x + (real)0.9) * sin((real)0.016 * y - (real)0.4)
        + (real)2.5 * sin((real)0.045 * x + (real)0.037 * y);
    real t = real_clamp((y - 50) / 330, 0, 1);
    return (vec3){x, y, hills - 7 * exp(-(y - 45) * (y - 45) / 1800) + 62 * t * t * (3 - 2 * t)};
}

/* How far from the path; how far the forest reaches to the sides. */
static inline real path_off(real x, real y)
{
    return fabs(x - 7 * sin((real)0.03 * y) - (real)0.02 * y);
}
static inline real forest_half_width(real y) { return 25 + (real)0.75 * y; }

/* A grid of cells, as wide as the forest at each distance, finer near the eye. */
static inline mesh ground_of(real depth)
{
    enum { n = 96 };
    mesh m = specimen_new((n + 1) * (n + 1), 2 * n * n);
    for (int k = 0; k < (n + 1) * (n + 1); k++) {
        real s = (real)(k / (n + 1)) / n, y = -20 + (depth + 60) * s * s;
        real half = forest_half_width(real_max(y, 0)) + 40;
        m.v[k] = ground_at((2 * (real)(k % (n + 1)) / n - 1) * half, y);
    }
    for (size_t k = 0; k < n * n; k++) {
        size_t a = k + k / n, c = a + n + 1;
        specimen_add(&m, a, a + 1, c + 1), specimen_add(&m, a, c + 1, c);
    }
    mesh_smooth_normals(&m);
    return m;
}

/* Some place, uniformly in the forest, not on the path. */
static inline vec3 forest_place(random_stream *g, real depth, bool low)
{
    for (;;) {
        real y = (depth + 10) * random_next(g) - 10;
        real half = forest_half_width(y), x = (2 * random_next(g) - 1) * forest_half_width(depth);
        real clear = low ? (real)1.2 : 4 + 90 / (6 + y);
        if (fabs(x) < half && path_off(x, y) > clear && y > (low ? -8 : 10)) return ground_at(x, y);
    }
}

/* Firs on the heights, birches along the path, and what is low in between. */
static inline instance forest_stand(random_stream *g, vec3 at, bool low)
{
    static const real sizes[plant_kinds] = {1, 9, 7, 8, 0.8, 0.45};
    real pick = random_next(g), high = at.z / 120 + (real)0.2 * sin(at.x / 23) * cos(at.y / 31);
    uint32_t of = low ? pick < (real)0.25 ? PLANT_BUSH : PLANT_GRASS
        : path_off(at.x, at.y) < 14 && pick < (real)0.6 ? PLANT_BIRCH
        : pick < (real)0.35 + high ? PLANT_FIR : pick < (real)0.85 ? PLANT_OAK : PLANT_BIRCH;
    real height = sizes[of] * random_between(g, 1, 1.7);
    real width = height * random_between(g, 0.75, 1.3);
    affine a = affine_scaling((vec3){random_next_bits(g) & 1 ? width : -width, width, height});
    a = affine_then(a, affine_rotation((vec3){0, 0, 1}, random_between(g, 0, 2 * pi)));
    return (instance){affine_then(a, affine_translation(at)), of};
}

static inline void forest_plant(forest *w, size_t n, uint64_t seed)
{
    /* n = integral of 2 half_width / 20 */
    real depth = real_max((-50 + sqrt(2500 + 60 * (real)n)) / (real)1.5, 60);
    *w = (forest){.n = n + 1, .list = allocate(n + 1, sizeof *w->list)};
    for (int k = 1; k < plant_kinds; k++) w->mesh[k] = plant_grown(k, seed, &w->wood[k]);
    w->mesh[PLANT_GROUND] = ground_of(depth);
    w->list[0] = (instance){affine_translation((vec3){0, 0, 0}), PLANT_GROUND};
    for (size_t i = 1; i < w->n; i++) {
        random_stream g = random_start(seed, i, 7);
        bool low = i % 3 == 0;
        vec3 at = forest_place(&g, low ? real_min(depth, 110) : depth, low);
        w->list[i] = forest_stand(&g, at, low);
    }
}

static inline camera forest_camera(real aspect)
{
    vec3 eye = vadd(ground_at(-2, -16), (vec3){0, 0, 11});
    return camera_at(eye, (vec3){6, 60, 5}, (vec3){0, 0, 1}, 44, aspect);
}

/* ---- light ---- */

static inline vec3 blend(vec3 a, vec3 b, real t) { return vmadd(vscale(a, 1 - t), b, t); }

static inline vec3 sky_colour(vec3 d, vec3 sun)
{
    vec3 horizon = {0.72, 0.80, 0.86}, u = vunit(d);
    vec3 zenith = {0.20, 0.40, 0.72}, warm = {0.30, 0.20, 0.08};
    real glow = real_max(vdot(u, sun), 0);
    return vmadd(blend(horizon, zenith, real_clamp(2 * u.z, 0, 1)), warm, glow * glow * glow);
}

static inline vec3 forest_paint(const forest *w, instance_hit h)
{
    uint32_t kind = w->list[h.instance].mesh;
    const plant_habit *p = &plant_habits[kind];
    random_stream g = random_start(3, h.instance, 0);
    if (h.h.shape < w->wood[kind]) return p->bark;
    vec3 own = blend(p->leaf, p->leaf_too, random_next(&g));
    return vscale(own, random_between(&g, 0.8, 1.2));
}

static inline vec3 forest_colour(const void *context, real x, real y)
{
    const forest_view *p = context;
    const vec3 sun = vunit(vec(-0.75, 0.35, 0.62));
    ray r = camera_ray(p->c, x, y, p->width, p->height);
    instance_hit h;
    if (!(p->naive ? instances_hit_naive(p->x, r, &h) : instances_hit(p->x, r, &h)))
        return sky_colour(r.d, sun);
    vec3 n = instances_normal(p->x, h);
    real far = h.h.t * vlength(r.d);
    ray shadow = ray_from(ray_at(r, h.h.t), sun);
    shadow.tmin = (real)1e-4 * far + (real)0.01;
    vec3 light = vmadd(vscale(headlight(n, r.d), 0.55), vec(0.15, 0.2, 0.3), 1);
    if (!instances_occluded(p->x, shadow))
        light = vadd(light, vmul(headlight(n, sun), vec(2.3, 2.0, 1.5)));
    vec3 seen = vmul(forest_paint(p->w, h), light);
    return blend(sky_colour((vec3){r.d.x, r.d.y, 0}, sun), seen, exp(-far / 1000));
}

#endif
