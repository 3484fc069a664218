/* shape.h: one shape (图元) of a scene, whatever its kind: a tag and a union.
 *
 *   shape s[] = {shape_of_sphere((sphere){c, 1}), shape_of_cone((cone){a, 1, b, 0}), ..};
 *   bool shape_hit(s[i], r, &h)               the X_hit of its kind; h.shape stays 0
 *   bool shape_hit_sheared(&s[i], &k, r, &h)  the same, k = shear_of(r) prepared once for all
 *   vec3 shape_normal(s[i], h, p)             unit, at the point p of hit h; may face away
 *   void shape_bounds(s[i], &lo, &hi)         a box that holds it, rounded outwards
 *
 * Every switch names all the kinds and has no default: a new kind makes the compiler list what to
 * add. The ends of a cone are open and a triangle has two sides, so a normal may face either way:
 * compare it with the direction of the ray.
 *
 * SHAPE_OTHER is what this header does not know, a solid of 06 for instance: it brings its own
 * functions, and `self` is for them alone. Structures see its box, and nothing else. hit is an
 * X_hit, and must keep the promise of 09_aabb/structure.h; what u and v say is its own affair.
 */
#ifndef MESH_SHAPE_H
#define MESH_SHAPE_H

#include "../03_sphere/sphere.h"
#include "../04_triangle/triangle.h"
#include "cone.h"
#include "polygon.h"

typedef enum { SHAPE_SPHERE, SHAPE_TRIANGLE, SHAPE_CONE, SHAPE_POLYGON, SHAPE_OTHER } shape_kind;

typedef struct {
    bool (*hit)(const void *self, ray r, hit *out);
    vec3 (*normal)(const void *self, hit h, vec3 p);
    const void *self;
    vec3 lo, hi;  /* a box that holds it, rounded outwards */
} shape_other;

typedef struct {
    shape_kind kind;
    union {
        sphere sphere;
        triangle triangle;
        cone cone;
        polygon polygon;
        const shape_other *other;  /* the caller's */
    };
} shape;

/* ---------------------------------------------------------------------------------------------- */

static inline shape shape_of_sphere(sphere s) { return (shape){SHAPE_SPHERE, {.sphere = s}}; }
static inline shape shape_of_triangle(triangle t)
{
    return (shape){SHAPE_TRIANGLE, {.triangle = t}};
}
static inline shape shape_of_cone(cone c) { return (shape){SHAPE_CONE, {.cone = c}}; }
static inline shape shape_of_polygon(polygon p) { return (shape){SHAPE_POLYGON, {.polygon = p}}; }
static inline shape shape_of_other(const shape_other *o)
{
    return (shape){SHAPE_OTHER, {.other = o}};
}

static inline bool shape_hit_sheared(const shape *s, const ray_shear *k, ray r, hit *out)
{
    switch (s->kind) {
    case SHAPE_SPHERE: return sphere_hit(s->sphere, r, out);
    case SHAPE_TRIANGLE: return triangle_hit_sheared(s->triangle, k, r, out);
    case SHAPE_CONE: return cone_hit(s->cone, r, out);
    case SHAPE_POLYGON: return polygon_hit_sheared(&s->polygon, k, r, out);
    case SHAPE_OTHER: return s->other->hit(s->other->self, r, out);
    }
    return false;
}

static inline bool shape_hit(shape s, ray r, hit *out)
{
    ray_shear k = shear_of(r);
    return shape_hit_sheared(&s, &k, r, out);
}

static inline vec3 shape_normal(shape s, hit h, vec3 p)
{
    switch (s.kind) {
    case SHAPE_SPHERE: return sphere_normal(s.sphere, p);
    case SHAPE_TRIANGLE: return triangle_normal(s.triangle);
    case SHAPE_CONE: return cone_normal(s.cone, p);
    case SHAPE_POLYGON: return s.polygon.normal;
    case SHAPE_OTHER: return s.other->normal(s.other->self, h, p);
    }
    return (vec3){0, 0, 0};
}

/* A disk of radius r at right angles to w reaches r sqrt(1 - wx^2 / w.w) = r sqrt(wy^2 + wz^2) /
 * |w| along x: the second form does not cancel. */
static inline vec3 disk_reach(vec3 w, real r)
{
    real h = vlength(w), k = h > 0 ? fabs(r) / h : 0;
    return (vec3){k * vlength((vec3){0, w.y, w.z}), k * vlength((vec3){w.x, 0, w.z}),
                  k * vlength((vec3){w.x, w.y, 0})};
}

static inline void bounds_add(vec3 p, vec3 reach, vec3 *lo, vec3 *hi)
{
    *lo = vmin(*lo, vsub(p, reach));
    *hi = vmax(*hi, vadd(p, reach));
}

/* Corners are their own bounds; round shapes get 8 epsilon more, for the roundings on the way. */
static inline void shape_bounds(shape s, vec3 *lo, vec3 *hi)
{
    const vec3 none = {0, 0, 0};
    real more = 8 * real_epsilon;
    *lo = (vec3){real_infinity, real_infinity, real_infinity};
    *hi = vneg(*lo);
    switch (s.kind) {
    case SHAPE_SPHERE: {
        real r = fabs(s.sphere.r);
        bounds_add(s.sphere.c, (vec3){r, r, r}, lo, hi);
        break;
    }
    case SHAPE_TRIANGLE:
        bounds_add(s.triangle.a, none, lo, hi);
        bounds_add(s.triangle.b, none, lo, hi);
        bounds_add(s.triangle.c, none, lo, hi);
        return;
    case SHAPE_CONE: {
        vec3 w = vsub(s.cone.b, s.cone.a);
        bounds_add(s.cone.a, disk_reach(w, s.cone.ra), lo, hi);
        bounds_add(s.cone.b, disk_reach(w, s.cone.rb), lo, hi);
        break;
    }
    case SHAPE_POLYGON:
        for (uint32_t i = 0; i < s.polygon.n; i++) bounds_add(s.polygon.v[i], none, lo, hi);
        return;
    case SHAPE_OTHER: *lo = s.other->lo, *hi = s.other->hi; return;
    }
    vec3 size = vmax(vabs(*hi), vabs(*lo));
    *lo = vmadd(*lo, size, -more);
    *hi = vmadd(*hi, size, more);
}

#endif
