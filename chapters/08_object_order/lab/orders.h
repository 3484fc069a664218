/* orders.h: the scene of this chapter, its picture in both orders, and where they differ.
 *
 *   mesh m = orders_scene(n)            teapot of n x n cells a patch, then two triangles of floor
 *   camera c = orders_camera(a), orders_lamp()        a: width / height
 *   bool whole = orders_rays(&s, &m, c, threads)      s as raster_mesh leaves it, by mesh_hit
 *   orders_difference d = orders_compare(&a, &b, &m, c, bits)      a drawn, b by rays
 *   vec3 x = orders_colour(&m, h, d, lit)             headlight, the pot orange; tiles by the
 *                                                   barycentrics of h
 *
 * A pixel of another triangle is explained if a ray a step of 2^-bits beside its middle hits the
 * triangle that was drawn, or at the same t: an edge passes within the step.
 */
#ifndef RASTER_ORDERS_H
#define RASTER_ORDERS_H

#include "../../../common/headlight.h"
#include "../../../common/parallel.h"
#include "../../07_mesh/closest.h"
#include "../../07_mesh/scenes/teapot.h"
#include "../raster.h"

typedef struct { size_t other, unexplained, judged; double depth; } orders_difference;
static const vec3 orders_lamp_place = {6.1, -1.7, 8.3};
enum { orders_floor = 2 };  /* triangles */

/* ---------------------------------------------------------------------------------------------- */

/* The floor is a b c, a c d, with one normal; it reaches behind the eye. */
static inline mesh orders_scene(int n)
{
    const vec3 floor[4] = {{-6, -12, 0}, {8, -12, 0}, {8, 10, 0}, {-6, 10, 0}};
    mesh pot = teapot_mesh(n), m = {.triangles = pot.triangles + orders_floor};
    uint32_t k = (uint32_t)pot.vertices, index[6] = {k, k + 1, k + 2, k, k + 2, k + 3};
    m.vertices = m.normals = pot.vertices + 4;
    m.v = allocate(m.vertices, sizeof *m.v), m.n = allocate(m.vertices, sizeof *m.n);
    m.index = allocate(3 * m.triangles, sizeof *m.index);
    memcpy(m.v, pot.v, pot.vertices * sizeof *m.v);
    memcpy(m.index, pot.index, 3 * pot.triangles * sizeof *m.index);
    memcpy(m.index + 3 * pot.triangles, index, sizeof index);
    for (size_t i = 0; i < 3 * pot.triangles; i++)
        m.n[pot.index[i]] = mesh_corner_normal(&pot, i / 3, (int)(i % 3));
    for (int i = 0; i < 4; i++) m.v[k + (uint32_t)i] = floor[i], m.n[k + (uint32_t)i].z = 1;
    mesh_free(&pot);
    return m;
}

static inline camera orders_look(vec3 e, vec3 target, real phi, real a)
{
    return camera_at(e, target, vec(0, 0, 1), phi, a);
}

static inline camera orders_camera(real a)
{
    return orders_look(vec(3.7, -9.3, 5.4), vec(-0.1, 0.2, 1), 33, a);
}

static inline camera orders_lamp(void)
{
    return orders_look(orders_lamp_place, vec(-0.4, 0.3, 0.9), 44, 1);
}

typedef struct { raster *s; const mesh *m; camera c; } orders_job;

static inline void orders_ray(int x, int y, void *context)
{
    const orders_job *j = context;
    ray r = camera_ray(j->c, (real)x + (real)0.5, (real)y + (real)0.5, j->s->nx, j->s->ny);
    (void)mesh_hit(j->m, r, &j->s->h[(size_t)y * (size_t)j->s->nx + (size_t)x]);
}

static inline bool orders_rays(raster *s, const mesh *m, camera c, int threads)
{
    orders_job j = {s, m, c};
    return parallel_pixels(s->nx, s->ny, threads, "rays", orders_ray, &j);
}

/* Does a ray within `step` pixels of the middle see what was drawn? */
static inline bool orders_explained(hit drawn, const mesh *m, camera c, int x, int y, real step,
                                    int nx, int ny)
{
    for (int k = 0; k < 25; k++) {
        hit h = hit_none;
        real dx = step * (real)(k % 5 - 2) / 2, dy = step * (real)(k / 5 - 2) / 2;
        ray r = camera_ray(c, (real)x + (real)0.5 + dx, (real)y + (real)0.5 + dy, nx, ny);
        bool may = drawn.shape == no_shape || triangle_hit(mesh_triangle(m, drawn.shape), r, &h);
        if (!may) continue;  /* most pass by what was drawn: one triangle to ask, not all */
        h = hit_none;
        (void)mesh_hit(m, r, &h);
        if (h.shape == drawn.shape || h.t == drawn.t) return true;
    }
    return false;
}

static inline orders_difference orders_compare(const raster *a, const raster *b, const mesh *m,
                                               camera c, int bits)
{
    orders_difference d = {0, 0, 0, 0};
    real step = (real)ldexp(1, -bits);
    for (int k = 0; k < a->nx * a->ny; k++) {
        hit p = a->h[k], q = b->h[k];
        double off = fabs((double)p.t / (double)q.t - 1);
        d.judged++, d.other += p.shape != q.shape;
        if (p.shape != q.shape)
            d.unexplained += !orders_explained(p, m, c, k % a->nx, k / a->nx, step, a->nx, a->ny);
        else if (p.shape != no_shape) d.depth = off > d.depth ? off : d.depth;
    }
    return d;
}

static inline vec3 orders_point(const mesh *m, hit h)
{
    triangle t = mesh_triangle(m, h.shape);
    return barycentric_mix(t.a, t.b, t.c, h.u, h.v);
}

static inline vec3 orders_colour(const mesh *m, hit h, vec3 d, bool lit)
{
    if (h.shape == no_shape) return vec(0.75, 0.82, 0.9);
    vec3 p = orders_point(m, h), light = headlight(mesh_normal(m, h.shape, h.u, h.v), d);
    bool pot = h.shape < m->triangles - orders_floor;
    bool white = ((int)floor(p.x) + (int)floor(p.y)) % 2 == 0;
    vec3 tint = pot ? vec(0.95, 0.6, 0.15) : white ? vec(0.6, 0.62, 0.65) : vec(0.08, 0.2, 0.32);
    light = pot ? vmadd(vec(0.1, 0.1, 0.1), vmul(light, light), (real)0.9) : vec(1, 1, 1);
    return vscale(vmul(tint, light), lit ? 1 : (real)0.3);
}

#endif
