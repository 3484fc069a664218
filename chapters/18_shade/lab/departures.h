/* departures.h: many rays that leave a surface: how many meet it again, how many pass through what
 * lies close above it.
 *
 *   departure_make(&x, kind, size, T, seed, i)   number i: a shape of this kind and size, T away
 *                                                from the origin, hit by a ray; and a w that
 *                                                leaves with n.w > 1e-3
 *   bool departure_self(&x, ways[k])             the leaving ray hits its own shape
 *   bool departure_leak(&x, ways[k], gap)        it misses a plate that lies `gap` above p
 *   real departure_gap(&x)                       1e-6 max(size, T / 1e4), at least 32 ulps of |p|
 *
 * No shape here bends towards w: each hit of its own is a wrong one. Plates are triangles of the
 * shape's size, n.w > 0.1: a miss is wrong. Half of the hits come from near, half from the origin.
 */
#ifndef SHADE_LAB_DEPARTURES_H
#define SHADE_LAB_DEPARTURES_H

#include "../../../common/random.h"
#include "../../04_triangle/first.h"
#include "leave_variants.h"

typedef enum {
    DEPART_SPHERE, DEPART_TRIANGLE, DEPART_NEEDLE, DEPART_CONE, DEPART_POLYGON, departure_kinds
} departure_kind;

typedef struct {
    shape s;
    vec3 corner[5];     /* of the polygon: a departure must not be copied about */
    ray r;
    hit h, first;       /* by the robust tests; by those of 03's and 04's first.h */
    vec3 n, w, steep;   /* n towards r.o; n.w > 1e-3, n.steep > 0.1 */
    real size, T;
    departure_kind kind;
    uint64_t at;        /* seed of the plate */
} departure;

typedef struct {
    const char *name;
    ray (*leave)(surface, vec3);
    bool naive, first;  /* p = o + t d; and all tests are those of the short book */
} leaving;
enum { leavings = 6 };

/* ---------------------------------------------------------------------------------------------- */

static const leaving ways[leavings] = {
    {"first", leave_first, true, true},           {"scaled eps in t", leave_scaled, true, false},
    {"scaled eps along n", leave_normal, true, false}, {"ulps", leave_ulps, false, false},
    {"error bounds", leave_bounds, false, false}, {"leave", leave, false, false}};

static inline shape departure_shape(departure_kind kind, real size, vec3 c, random_stream *s,
                                    vec3 corner[5])
{
    vec3 x, y, z = random_unit(s);
    vbasis(z, &x, &y);
    real a = random_next(s), b = random_next(s), turn = 2 * pi * random_next(s);
    if (kind == DEPART_SPHERE) return shape_of_sphere((sphere){c, size});
    real foot = size * (a + (real)0.01) / 2, top = a < (real)0.3 ? foot : size * b / 4;
    if (kind == DEPART_CONE)
        return shape_of_cone((cone){c, foot, vmadd(c, z, size * (b + (real)0.1) / 2), top});
    int n = kind == DEPART_POLYGON ? 5 : 3;
    for (int k = 0; k < n; k++) {
        real at = turn + (2 * pi / (real)n) * ((real)k + a / 2), r = size * (b + 1) / 2;
        corner[k] = vmadd(vmadd(c, x, r * cos(at)), y, r * sin(at));
    }
    if (kind == DEPART_POLYGON) return shape_of_polygon(polygon_of(corner, 5));
    if (kind == DEPART_NEEDLE)  /* 1 to 1e-4 radius */
        corner[2] = vmadd(corner[0], vunit(vsub(corner[2], corner[1])),
                          size * pow((real)10, -4 * b));
    return shape_of_triangle((triangle){corner[0], corner[1], corner[2]});
}

/* A point in about the middle of it, to aim at. */
static inline vec3 departure_target(const shape *s, vec3 c, const vec3 corner[5], random_stream *r)
{
    real a = random_next(r), b = random_next(r);
    if (a + b > 1) a = 1 - a, b = 1 - b;
    if (s->kind == SHAPE_CONE) return vmadd(c, vsub(s->cone.b, c), a);
    if (s->kind == SHAPE_SPHERE) return vmadd(c, random_unit(r), s->sphere.r * a);
    return vmadd(vmadd(corner[0], vsub(corner[1], corner[0]), a), vsub(corner[2], corner[0]), b);
}

/* Some w with n.w = cosine. */
static inline vec3 departure_towards(vec3 n, real cosine, random_stream *s)
{
    vec3 x, y;
    real a = 2 * pi * random_next(s), sine = sqrt(1 - cosine * cosine);
    vbasis(n, &x, &y);
    return vmadd(vmadd(vscale(n, cosine), x, sine * cos(a)), y, sine * sin(a));
}

static inline bool departure_hit(const shape *s, ray r, bool first, hit *out)
{
    if (first && s->kind == SHAPE_SPHERE) return first_sphere_hit(s->sphere, r, out);
    if (first && s->kind == SHAPE_TRIANGLE) return first_triangle_hit(s->triangle, r, out);
    return shape_hit(*s, r, out);
}

/* naive: p is where the ray says, and nobody knows how far that is from the surface. At 1e4 from
 * the origin in float: 1e-3. */
static inline surface departure_at(const departure *x, hit h, bool naive)
{
    if (!naive) return surface_of_shape(&x->s, x->r, h);
    vec3 p = ray_at(x->r, h.t), n = shape_normal(x->s, h, p);
    return (surface){p, n, n, 0, 0, h.shape};
}

static inline surface departure_surface(const departure *x, bool naive)
{
    return surface_facing(departure_at(x, x->h, naive), x->r.d);
}

/* The way out along w. */
static inline ray departure_ray(const departure *x, leaving way, vec3 w)
{
    surface s = departure_at(x, way.first ? x->first : x->h, way.naive);
    return way.leave(surface_facing(s, x->r.d), w);
}

static inline void departure_make(departure *x, departure_kind kind, real size, real T,
                                  uint64_t seed, uint64_t i)
{
    for (uint64_t sample = 0;; sample++) {  /* until a ray hits */
        random_stream s = random_start(seed + (uint64_t)kind, i, sample);
        vec3 c = vscale(random_unit(&s), T);
        x->s = departure_shape(kind, size, c, &s, x->corner);
        if (kind == DEPART_POLYGON) x->s.polygon.v = x->corner;
        real away = i % 2 ? size * (2 + 10 * random_next(&s)) : real_max(T / 2, 3 * size);
        vec3 from = vmadd(i % 2 ? c : (vec3){0, 0, 0}, random_unit(&s), away);
        x->r = ray_between(from, departure_target(&x->s, c, x->corner, &s));
        x->r.tmax = real_infinity;
        if (!shape_hit(x->s, x->r, &x->h)) continue;
        if (!departure_hit(&x->s, x->r, true, &x->first)) x->first = x->h;
        x->kind = kind, x->size = size, x->T = T, x->at = random_mix(i + sample);
        surface at = departure_at(x, x->h, false);
        x->n = surface_facing(at, x->r.d).n;
        bool round = kind == DEPART_SPHERE || kind == DEPART_CONE;
        if (round && vdot(x->n, at.n) < 0) continue;  /* from inside w meets the other wall */
        real grazing = i % 3 == 0 ? (real)0.001 : i % 3 == 1 ? (real)0.01 : 1;
        real least = 1.1e-3;
        x->w = departure_towards(x->n, least + (1 - least) * grazing * random_next(&s), &s);
        x->steep = departure_towards(x->n, (real)0.1 + (real)0.9 * random_next(&s), &s);
        return;
    }
}

static inline bool departure_self(const departure *x, leaving way)
{
    hit h;
    return departure_hit(&x->s, departure_ray(x, way, x->w), way.first, &h);
}

/* 32 units in the last place of |p|, or of the shape, whichever is larger. (Of needles, whose
 * weights are least sure, 192.) */
static inline real departure_gap(const departure *x)
{
    real reach = real_max(surface_reach(ray_at(x->r, x->h.t)), x->size);
    int e;
    (void)frexp(reach, &e);
    real ulps = (x->kind == DEPART_NEEDLE ? 192 : 32) * ldexp(real_epsilon, e - 1);
    return real_max((real)1e-6 * real_max(x->size, x->T / (real)1e4), ulps);
}

/* Its corners lie round the point straight above p where the ray passes it. */
static inline triangle departure_plate(const departure *x, real gap)
{
    random_stream s = random_start(x->at, 1, 0);
    surface at = departure_surface(x, false);
    vec3 a, b, middle = vmadd(at.p, x->steep, gap / vdot(at.n, x->steep)), corner[3];
    real turn = 2 * pi * random_next(&s), radius = real_max(x->size, 64 * gap);
    vbasis(at.n, &a, &b);
    for (int k = 0; k < 3; k++) {
        real angle = turn + 2 * pi / 3 * (real)k;
        corner[k] = vmadd(vmadd(middle, a, radius * cos(angle)), b, radius * sin(angle));
    }
    return (triangle){corner[0], corner[1], corner[2]};
}

static inline bool departure_leak(const departure *x, leaving way, real gap)
{
    hit h;
    shape plate = shape_of_triangle(departure_plate(x, gap));
    return !departure_hit(&plate, departure_ray(x, way, x->steep), way.first, &h);
}

#endif
