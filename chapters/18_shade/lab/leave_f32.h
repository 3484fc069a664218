/* leave_f32.h: what most first ray tracers do, in float whatever real is: textbook tests, p = o + t
 * d, and a fixed eps for tmin. Exhibits, to be counted beside the others. */
#ifndef SHADE_LAB_LEAVE_F32_H
#define SHADE_LAB_LEAVE_F32_H

#include "../../../common/lab/vec3_f32.h"
#include "departures.h"

/* ---------------------------------------------------------------------------------------------- */

/* First root t >= tmin of (3.2), or infinity. */
static inline float sphere_hit_f32(sphere s, vec3_f32 o, vec3_f32 d, float tmin)
{
    vec3_f32 f = f32_sub(o, f32_of(s.c));
    float a = f32_dot(d, d), b = f32_dot(d, f), k = f32_dot(f, f) - (float)s.r * (float)s.r;
    float D = b * b - a * k, t0 = (-b - sqrtf(D)) / a, t1 = (-b + sqrtf(D)) / a;
    return t0 >= tmin ? t0 : t1 >= tmin ? t1 : INFINITY;
}

/* (4.8). */
static inline float triangle_hit_f32(triangle t, vec3_f32 o, vec3_f32 d, float tmin)
{
    vec3_f32 a = f32_of(t.a), e = f32_sub(f32_of(t.b), a), f = f32_sub(f32_of(t.c), a);
    vec3_f32 p = f32_cross(d, f), s = f32_sub(o, a), q = f32_cross(s, e);
    float i = 1 / f32_dot(e, p), u = i * f32_dot(s, p), v = i * f32_dot(d, q);
    float at = i * f32_dot(f, q);
    return u >= 0 && v >= 0 && u + v <= 1 && at >= tmin ? at : INFINITY;
}

static inline float departure_hit_f32(const shape *s, vec3_f32 o, vec3_f32 d, float tmin)
{
    return s->kind == SHAPE_SPHERE ? sphere_hit_f32(s->sphere, o, d, tmin)
                                   : triangle_hit_f32(s->triangle, o, d, tmin);
}

/* False if the first ray already misses: then nothing is left to leave. */
static inline bool departure_point_f32(const departure *x, vec3_f32 *p)
{
    vec3_f32 o = f32_of(x->r.o), d = f32_of(x->r.d);
    float t = departure_hit_f32(&x->s, o, d, 0);
    *p = (vec3_f32){o.x + t * d.x, o.y + t * d.y, o.z + t * d.z};
    return t < INFINITY;
}

/* Spheres and triangles only. */
static inline bool departure_self_f32(const departure *x, float eps)
{
    vec3_f32 p;
    return departure_point_f32(x, &p) && departure_hit_f32(&x->s, p, f32_of(x->w), eps) < INFINITY;
}

static inline bool departure_leak_f32(const departure *x, float eps, real gap)
{
    vec3_f32 p;
    return departure_point_f32(x, &p)
           && triangle_hit_f32(departure_plate(x, gap), p, f32_of(x->steep), eps) == INFINITY;
}

#endif
