/* world.h: a scene with all that a renderer needs to know of it: view, lights, surfaces.
 *
 *   world w;                             what a generator fills: spd.h, meshes.h
 *   w.shape[0 .. w.n-1]                  shapes of any kind, or, if w.n is 0:
 *   w.mesh                               triangles alone
 *   finish s = world_finish(&w, i)     of shape or triangle i: O(log groups)
 *   ray r = world_ray(&w, x, y)          x to the right, y up, [-1, 1] from edge to edge of it
 *   scene s = world_scene(&w)            for scene_hit and the like of 07
 *   vec3 n = world_normal(&w, h, p)      unit, of the shape of hit h at its point p; either side
 *   world_bounds(&w, &lo, &hi)           a box round everything
 *   world_free(&w)                       a zeroed one may be freed
 *
 * The view is square: from -> at, `up` somewhere upwards, `angle` from edge to edge. Directions of
 * rays are not unit: their part along the axis of the view is 1.
 *
 *   finish    colour [0,1]; kd, ks: how much of it diffuse and mirror; shine: Phong exponent, 0 if
 *             ks is; transmit: how much passes; ior: refractive index (折射率), 0 if opaque
 *   group     shapes group[k].first .. group[k+1].first - 1 have the same finish
 *
 *   const generator *g = generator_find(list, n, "balls");   NULL: no such name
 *   if (!world_make(g, scale, &w, &f)) fail(f);              exit code 2: no such scale
 */
#ifndef MESH_WORLD_H
#define MESH_WORLD_H

#include "../../02_camera/frame.h"
#include "../scene.h"

typedef struct { vec3 colour; real kd, ks, shine, transmit, ior; } finish;
typedef struct { size_t first; finish finish; } finish_group;

enum { world_most_lights = 8 };

typedef struct {
    const char *name;
    vec3 from, at, up;
    real angle;                      /* degrees */
    vec3 background;
    vec3 light[world_most_lights];
    int lights;
    real light_each;                 /* intensity of each light */
    shape *shape;                    /* [n] */
    size_t n;
    vec3 *corner;                    /* [corners] of the polygons among them */
    size_t corners;
    void *others;                    /* what those of SHAPE_OTHER are made of, and who frees it */
    void (*free_others)(void *);
    mesh mesh;
    finish_group *group;            /* [groups] by rising `first`; the first begins at 0 */
    size_t groups;
    camera_frame frame;              /* of the view: world_look */
} world;

typedef struct {
    const char *name;
    int scale, least, most;                          /* usual; allowed */
    bool (*make)(int scale, world *out, failure *f); /* *out is zero before */
    size_t hits;                                     /* published: see spd.h; 0: none are */
} generator;

/* ---------------------------------------------------------------------------------------------- */

static inline void world_free(world *w)
{
    free(w->shape);
    free(w->corner);
    if (w->others) w->free_others(w->others);
    free(w->group);
    mesh_free(&w->mesh);
    *w = (world){0};
}

static inline scene world_scene(const world *w) { return (scene){w->shape, w->n}; }

static inline size_t world_size(const world *w) { return w->n ? w->n : w->mesh.triangles; }

/* Sets the view; false if from, at and up make none. */
static inline bool world_look(world *w, vec3 from, vec3 at, vec3 up, real angle, failure *f)
{
    w->from = from, w->at = at, w->up = up, w->angle = angle;
    return frame_look_at(from, at, up, &w->frame, f);
}

static inline ray world_ray(const world *w, real x, real y)
{
    real k = tan(w->angle * (pi / 360));
    vec3 d = vmadd(vneg(w->frame.w), w->frame.u, k * x);
    return ray_from(w->from, vmadd(d, w->frame.v, k * y));
}

static inline finish world_finish(const world *w, size_t i)
{
    size_t lo = 0, hi = w->groups;
    while (hi - lo > 1) {
        size_t middle = lo + (hi - lo) / 2;
        if (w->group[middle].first <= i) lo = middle;
        else hi = middle;
    }
    return w->group[lo].finish;
}

static inline vec3 world_normal(const world *w, hit h, vec3 p)
{
    return w->n ? shape_normal(w->shape[h.shape], h, p)
                : triangle_normal(mesh_triangle(&w->mesh, h.shape));
}

static inline void world_bounds(const world *w, vec3 *lo, vec3 *hi)
{
    *lo = (vec3){real_infinity, real_infinity, real_infinity};
    *hi = vneg(*lo);
    if (w->n == 0) mesh_bounds(&w->mesh, lo, hi);
    for (size_t i = 0; i < w->n; i++) {
        vec3 a, b;
        shape_bounds(w->shape[i], &a, &b);
        *lo = vmin(a, *lo), *hi = vmax(b, *hi);  /* of a NaN the other is kept */
    }
}

static inline const generator *generator_find(const generator *list, size_t n, const char *name)
{
    for (size_t k = 0; k < n; k++)
        if (strcmp(list[k].name, name) == 0) return &list[k];
    return NULL;
}

/* Background and strength of lights are those of the SPD for all. */
static inline bool world_make(const generator *g, int scale, world *out, failure *f)
{
    *out = (world){0};
    if (scale < g->least || scale > g->most)
        return failed(f, 2, "scale %d: allowed for %s are whole numbers from %d to %d", scale,
                      g->name, g->least, g->most);
    if (!g->make(scale, out, f)) return false;
    out->name = g->name;
    out->background = vec(0.078, 0.361, 0.753);
    out->light_each = sqrt((real)out->lights) / (2 * (real)out->lights);
    return true;
}

/* What generators are written with. ------------------------------------------------------------ */

/* Room for so many; they are then added one by one. */
static inline void world_room(world *w, size_t shapes, size_t corners, size_t groups)
{
    w->shape = allocate(shapes, sizeof *w->shape);
    w->corner = allocate(corners, sizeof *w->corner);
    w->group = allocate(groups, sizeof *w->group);
}

static inline void world_add(world *w, shape s) { w->shape[w->n++] = s; }

/* The shapes added from now on have this finish. */
static inline void world_paint(world *w, finish s)
{
    w->group[w->groups++] = (finish_group){w->n ? w->n : w->mesh.triangles, s};
}

static inline void world_add_polygon(world *w, const vec3 *corner, size_t n)
{
    vec3 *own = w->corner + w->corners;
    memcpy(own, corner, n * sizeof *own);
    w->corners += n;
    world_add(w, shape_of_polygon(polygon_of(own, n)));
}

static inline void world_add_square(world *w, vec3 centre, real half)  /* seen from above, z up */
{
    static const int sign[4][2] = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
    vec3 c[4];
    for (int k = 0; k < 4; k++)
        c[k] = vadd(centre, (vec3){half * (real)sign[k][0], half * (real)sign[k][1], 0});
    world_add_polygon(w, c, 4);
}

static inline void world_light(world *w, vec3 p) { w->light[w->lights++] = p; }

/* v turned by `angle` (radians) about the unit axis k, right-handed (Rodrigues). */
static inline vec3 turned(vec3 v, vec3 k, real angle)
{
    real c = cos(angle), s = sin(angle);
    return vmadd(vmadd(vscale(v, c), vcross(k, v), s), k, vdot(k, v) * (1 - c));
}

#endif
