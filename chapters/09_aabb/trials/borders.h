/* borders.h: rays at a whole scene, of any shapes, where answers are hard to get right.
 *
 *   ray_set a = rays_aimed(&w, n, seed)           at corners and edges of triangles and polygons,
 *                                                 outlines, poles and rims of round shapes, edges
 *                                                 of solids; in a mesh half as aimed.h does
 *   ray_set e = rays_everywhere(&w, n, seed)      from anywhere near to anywhere in it
 *   rays_stretch(&e)                              directions become 2^30 or 2^-30 long: t is tiny
 *                                                 or huge, and a search may have to scale it
 */
#ifndef AABB_BORDERS_H
#define AABB_BORDERS_H

#include "../../07_mesh/scenes/world.h"
#include "aimed.h"
#include "survey.h"

/* ---------------------------------------------------------------------------------------------- */

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

/* A corner of its box; or an outline of it, or an edge where two of its surfaces meet: between two
 * places of the box of which o sees different things, the last real that still shows the one. */
static inline vec3 aim_at_other(const shape_other *s, vec3 o, random_stream *g)
{
    vec3 to[2], size = vsub(s->hi, s->lo);
    hit h[2] = {hit_none, hit_none}, between;
    for (int k = 0; k < 2; k++) {
        real x = random_next(g), y = random_next(g), z = random_next(g);
        to[k] = vadd(s->lo, vmul((vec3){x, y, z}, size));
        s->hit(s->self, ray_from(o, vsub(to[k], o)), &h[k]);
    }
    uint64_t pick = random_next_bits(g);
    if (pick % 8 == 0)
        return (vec3){pick & 8 ? s->lo.x : s->hi.x, pick & 16 ? s->lo.y : s->hi.y,
                      pick & 32 ? s->lo.z : s->hi.z};
    for (int k = 0; k < 60; k++) {
        vec3 p = vscale(vadd(to[0], to[1]), (real)0.5);
        between = hit_none;
        s->hit(s->self, ray_from(o, vsub(p, o)), &between);
        to[between.shape != h[0].shape || between.u != h[0].u] = p;
    }
    return to[0];
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
    case SHAPE_OTHER: return aim_at_other(s->other, o, g);
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

static inline void rays_stretch(ray_set *s)
{
    for (size_t i = 0; i < s->n; i++) {
        vec3 *d = &s->r[i].d;
        int e;
        (void)frexp(vaxis(*d, vlongest(*d)), &e);
        *d = vscale(*d, ldexp((real)1, (i % 2 ? 30 : -30) - e));
    }
}

#endif
