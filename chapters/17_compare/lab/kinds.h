/* kinds.h: the rays with which structures are compared: four kinds to measure with, and rays aimed
 * where shapes end, to prove answers with.
 *
 *   ray_set p = rays_view(&w, part, edge)         primary (主光线): edge x edge from the eye, in the
 *                                                 part x0, y0, x1, y1 of the view, [-1, 1], y up
 *   ray_set s = rays_to_lights(&w, &p, hits)      shadow (阴影光线): from each hit to each light that
 *                                                 its surface faces; is anything between?
 *   ray_set d = rays_scattered(&w, &p, hits, seed)    diffuse (漫反射): one a hit, by the cosine law
 *   ray_set m = rays_mirrored(&w, &p, hits)       mirror (镜面反射): one a hit
 *   ray_set a = rays_aimed(&w, n, seed)           at corners and edges of triangles and polygons,
 *                                                 outlines, poles and rims of round shapes; in a
 *                                                 mesh half of them as 09_aabb/trials/aimed.h does
 *   ray_set e = rays_everywhere(&w, n, seed)      from anywhere near to anywhere in it
 *   rays_free(&s)
 *
 * hits[i] belongs to p.r[i]. Rays that leave a surface begin off it, by 1e-4 of their distance from
 * the eye, on the side that the eye sees.
 */
#ifndef COMPARE_KINDS_H
#define COMPARE_KINDS_H

#include "../../09_aabb/trials/aimed.h"
#include "../../09_aabb/trials/survey.h"
#include "../../07_mesh/scenes/world.h"

typedef enum { KIND_PRIMARY, KIND_SHADOW, KIND_DIFFUSE, KIND_MIRROR, compare_kinds } compare_kind;
static const char *const kind_name[compare_kinds] = {"primary", "shadow", "diffuse", "mirror"};

/* ---------------------------------------------------------------------------------------------- */

static const double whole_view[4] = {-1, -1, 1, 1};

static inline ray_set rays_view(const world *w, const double part[4], int edge)
{
    ray_set s = {allocate((size_t)edge * (size_t)edge, sizeof(ray)), 0};
    real x0 = (real)part[0], y0 = (real)part[1], x1 = (real)part[2], y1 = (real)part[3];
    for (int j = 0; j < edge; j++)
        for (int i = 0; i < edge; i++) {
            real x = ((real)i + (real)0.5) / (real)edge, y = ((real)j + (real)0.5) / (real)edge;
            s.r[s.n++] = world_ray(w, x0 + (x1 - x0) * x, y1 - (y1 - y0) * y);
        }
    return s;
}

/* Where a ray leaves the surface it hit: a point off it, and the normal on that side. */
static inline vec3 leave_surface(const world *w, ray r, hit h, vec3 *n)
{
    vec3 p = ray_at(r, h.t);
    *n = world_normal(w, h, p);
    if (vdot(*n, r.d) > 0) *n = vneg(*n);
    return vmadd(p, *n, (real)1e-4 * vlength(vsub(p, r.o)));
}

static inline ray_set rays_to_lights(const world *w, const ray_set *eye, const hit *hits)
{
    ray_set s = {allocate(eye->n * (size_t)w->lights, sizeof(ray)), 0};
    for (size_t i = 0; i < eye->n; i++)
        for (int k = 0; k < w->lights && hits[i].shape != no_shape; k++) {
            vec3 n, p = leave_surface(w, eye->r[i], hits[i], &n);
            if (vdot(n, vsub(w->light[k], p)) > 0) s.r[s.n++] = ray_between(p, w->light[k]);
        }
    return s;
}

static inline ray_set rays_scattered(const world *w, const ray_set *eye, const hit *hits,
                                     uint64_t seed)
{
    ray_set s = {allocate(eye->n, sizeof(ray)), 0};
    for (size_t i = 0; i < eye->n; i++) {
        random_stream g = random_start(seed, i, 0);
        if (hits[i].shape == no_shape) continue;
        vec3 n, p = leave_surface(w, eye->r[i], hits[i], &n);
        s.r[s.n++] = ray_from(p, diffuse_direction(n, &g));
    }
    return s;
}

static inline ray_set rays_mirrored(const world *w, const ray_set *eye, const hit *hits)
{
    ray_set s = {allocate(eye->n, sizeof(ray)), 0};
    for (size_t i = 0; i < eye->n; i++) {
        if (hits[i].shape == no_shape) continue;
        vec3 n, p = leave_surface(w, eye->r[i], hits[i], &n), d = eye->r[i].d;
        s.r[s.n++] = ray_from(p, vmadd(d, n, -2 * vdot(d, n)));
    }
    return s;
}

/* Aiming. -------------------------------------------------------------------------------------- */

/* Half of them at a corner, half somewhere on the edge to the next. */
static inline vec3 aim_at_corners(const vec3 *v, size_t n, random_stream *g)
{
    size_t k = (size_t)(random_next_bits(g) % n);
    real f = random_next_bits(g) & 1 ? random_next(g) : 0;
    return vmadd(v[k], vsub(v[(k + 1) % n], v[k]), f);
}

/* A pole, or a point of the outline that o sees: the tangent cone touches the sphere in a circle of
 * radius r cos a, r sin a before its centre, sin a = r / |c - o|. */
static inline vec3 aim_at_sphere(sphere s, vec3 o, random_stream *g)
{
    vec3 to = vsub(s.c, o), w = vunit(to), a, b;
    real far = vlength(to), phi = 2 * pi * random_next(g), r = fabs(s.r);
    uint64_t pick = random_next_bits(g) % 12;
    if (pick < 6 || far <= r) {
        vec3 pole = {0, 0, 0};
        ((real *)&pole)[pick % 3] = pick % 2 ? r : -r;
        return vadd(s.c, pole);
    }
    vbasis(w, &a, &b);
    real sine = r / far, cosine = sqrt(1 - sine * sine);
    vec3 across = vadd(vscale(a, cos(phi)), vscale(b, sin(phi)));
    return vadd(vmadd(s.c, w, -r * sine), vscale(across, r * cosine));
}

/* A rim, an end of the axis, or the outline. */
static inline vec3 aim_at_cone(cone c, vec3 o, random_stream *g)
{
    vec3 w = vsub(c.b, c.a), n = vunit(w), a, b, side = vunit(vcross(w, vsub(c.a, o)));
    real phi = 2 * pi * random_next(g), u = random_next(g);
    uint64_t pick = random_next_bits(g) % 8;
    vbasis(n, &a, &b);
    vec3 across = vadd(vscale(a, cos(phi)), vscale(b, sin(phi)));
    if (pick == 0) return c.b;
    if (pick < 3) return vmadd(c.a, across, c.ra);
    if (pick < 5) return vmadd(c.b, across, c.rb);
    return vmadd(vmadd(c.a, w, u), side, (pick & 1 ? 1 : -1) * (c.ra + (c.rb - c.ra) * u));
}

/* Where on shape or triangle i a ray from o should go that is hard to get right. */
static inline vec3 aim_at(const world *w, size_t i, vec3 o, random_stream *g)
{
    triangle t;
    if (w->n == 0) {
        t = mesh_triangle(&w->mesh, i);
        return aim_at_corners(&t.a, 3, g);
    }
    const shape *s = &w->shape[i];
    switch (s->kind) {
    case SHAPE_SPHERE: return aim_at_sphere(s->sphere, o, g);
    case SHAPE_CONE: return aim_at_cone(s->cone, o, g);
    case SHAPE_POLYGON: return aim_at_corners(s->polygon.v, s->polygon.n, g);
    case SHAPE_TRIANGLE: return aim_at_corners(&s->triangle.a, 3, g);
    }
    return o;
}

/* The eye, or a point of the box half as large again, or on the border of another shape. */
static inline vec3 somewhere(const world *w, vec3 lo, vec3 hi, random_stream *g)
{
    uint64_t pick = random_next_bits(g) % 4;
    real x = random_next(g), y = random_next(g), z = random_next(g);
    vec3 q = vmul((vec3){x, y, z}, vsub(hi, lo));
    if (pick == 0) return w->from;
    if (pick == 1) return aim_at(w, random_next_bits(g) % world_size(w), w->from, g);
    return vadd(vmadd(lo, vsub(hi, lo), -(real)0.25), vscale(q, 1.5));
}

static inline ray_set rays_aimed(const world *w, size_t n, uint64_t seed)
{
    ray_set s = {allocate(n, sizeof(ray)), n};
    vec3 lo, hi;
    world_bounds(w, &lo, &hi);
    vec3 centre = vscale(vadd(lo, hi), (real)0.5);
    real size = vlength(vsub(hi, lo)) / 2;
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(seed, i, 1);
        if (w->n == 0 && i % 2) {
            s.r[i] = aimed(&w->mesh, &g, (int)(i / 2 % aimed_kinds), centre, size);
            continue;
        }
        vec3 o = somewhere(w, lo, hi, &g);
        s.r[i] = ray_from(o, vsub(aim_at(w, random_next_bits(&g) % world_size(w), o, &g), o));
    }
    return s;
}

static inline ray_set rays_everywhere(const world *w, size_t n, uint64_t seed)
{
    ray_set s = {allocate(n, sizeof(ray)), n};
    vec3 lo, hi;
    world_bounds(w, &lo, &hi);
    for (size_t i = 0; i < n; i++) {
        random_stream g = random_start(seed, i, 2);
        vec3 o = somewhere(w, lo, hi, &g), to = {random_next(&g), random_next(&g), 0};
        to.z = random_next(&g);
        s.r[i] = ray_from(o, vsub(vadd(lo, vmul(to, vsub(hi, lo))), o));
    }
    return s;
}

#endif
