/* survey.h: the rays with which the structures are measured.
 *
 *   ray_set s = rays_primary(c, width, height);    one ray a pixel of camera c (主光线)
 *   ray_set d = rays_diffuse(&m, &s, hits, seed);  one on from each of their hits: cosine law
 *   ray_set c = rays_corners(&m, eye, n, seed);    at corners of triangles, all from one point
 *   ray_set u = rays_uniform(box, n, seed);        lines through a box, uniformly distributed:
 *                              origin uniform on its surface, direction by the cosine law
 *   rays_free(&s);
 *
 * hits: one for each ray of s, hit_none where there is none; any structure may have found them.
 */
#ifndef AABB_SURVEY_H
#define AABB_SURVEY_H

#include "../../../common/clock.h"
#include "../../../common/random.h"
#include "../../02_camera/camera.h"
#include "../../07_mesh/mesh.h"
#include "../../07_mesh/scenes/camera_of.h"
#include "../aabb.h"
#include "../../01_ray/hit.h"

typedef struct { ray *r; size_t n; } ray_set;

/* ---------------------------------------------------------------------------------------------- */

static inline void rays_free(ray_set *s)
{
    free(s->r);
    *s = (ray_set){NULL, 0};
}

static inline ray_set rays_primary(camera c, int width, int height)
{
    ray_set s = {allocate((size_t)width * (size_t)height, sizeof(ray)), 0};
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++)
            s.r[s.n++] = camera_ray(c, (real)x + (real)0.5, (real)y + (real)0.5, width,
                                    height);
    return s;
}

/* A direction about n with density cos / pi: n plus a point of the unit sphere. */
static inline vec3 diffuse_direction(vec3 n, random_stream *g)
{
    return vadd(n, random_unit(g));
}

/* Where a ray leaves what it hit at t, of normal n: a little off it, by 1e-4 of the distance that
 * the eye keeps. n is turned to the side that the eye sees. */
static inline vec3 leave_surface(ray r, real t, vec3 *n)
{
    vec3 p = ray_at(r, t);
    if (vdot(*n, r.d) > 0) *n = vneg(*n);
    return vmadd(p, *n, (real)1e-4 * vlength(vsub(p, r.o)));
}

static inline ray_set rays_diffuse(const mesh *m, const ray_set *eye, const hit *hits,
                                   uint64_t seed)
{
    ray_set s = {allocate(eye->n, sizeof(ray)), 0};
    for (size_t i = 0; i < eye->n; i++) {
        random_stream g = random_start(seed, i, 0);
        if (hits[i].shape == no_shape) continue;
        vec3 n = triangle_normal(mesh_triangle(m, hits[i].shape));
        vec3 off = leave_surface(eye->r[i], hits[i].t, &n);
        s.r[s.n++] = ray_from(off, diffuse_direction(n, &g));
    }
    return s;
}

/* Rays aimed at corners of the mesh, from the eye: where boxes and triangles end. */
static inline ray_set rays_corners(const mesh *m, vec3 eye, size_t n, uint64_t seed)
{
    ray_set s = {allocate(n, sizeof(ray)), n};
    for (size_t i = 0; i < n; i++)
        s.r[i] = ray_from(eye, vsub(m->v[random_bits(seed, i, 1, 0) % m->vertices], eye));
    return s;
}

/* The inward half of directions suffices: a line that enters also leaves. */
static inline ray_set rays_uniform(aabb box, size_t n, uint64_t seed)
{
    ray_set s = {allocate(n, sizeof(ray)), n};
    real size[3], area[3];
    for (int k = 0; k < 3; k++) size[k] = vaxis(box.hi, k) - vaxis(box.lo, k);
    for (int k = 0; k < 3; k++) area[k] = size[(k + 1) % 3] * size[(k + 2) % 3];
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(seed, i, 2);
        real pick = random_next(&g) * (area[0] + area[1] + area[2]);
        int k = pick < area[0] ? 0 : pick < area[0] + area[1] ? 1 : 2;
        int high = (int)(random_next_bits(&g) & 1);
        vec3 o, n_in = {0, 0, 0};
        for (int j = 0; j < 3; j++)
            ((real *)&o)[j] = vaxis(box.lo, j) + random_next(&g) * size[j];
        ((real *)&o)[k] = vaxis(high ? box.hi : box.lo, k);
        ((real *)&n_in)[k] = high ? -1 : 1;
        s.r[i] = ray_from(o, diffuse_direction(n_in, &g));
    }
    return s;
}

#endif
