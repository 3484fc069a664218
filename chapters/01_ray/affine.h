/* affine.h: affine transforms (仿射变换), and rays under them.
 *
 * p -> M p + o for points, d -> M d for directions: all that turns, scales, shears, mirrors, moves.
 * Instancing (实例化) keeps one mesh and many transforms: not the mesh is transformed, but the ray.
 *
 *   T(O + t D) = T(O) + t M D                                                        (1.7)
 *
 * So a ray under T keeps its t and its interval, as long as D is not normalised on the way: that
 * would rescale t, by another factor for each instance, and their hits could not be compared.
 *
 *   affine t = affine_then(big, right);             first `big`, then `right`: p -> right(big(p))
 *   affine_scaling(by), affine_translation(by)      along the axes; moved
 *   affine_rotation(axis, angle)                    about a unit axis, radians, right-handed
 *   if (affine_inverse(t, &to_object)) ...          false if t flattens space
 *   ray inside = affine_ray(to_object, r);          affine_point, affine_vector: M p + o, M d
 */
#ifndef RAY_AFFINE_H
#define RAY_AFFINE_H

#include "ray.h"

typedef struct {
    vec3 x, y, z;  /* images of the three axes: the columns of M */
    vec3 o;        /* image of the origin */
} affine;

/* ---------------------------------------------------------------------------------------------- */

static inline vec3 affine_vector(affine m, vec3 v)
{
    return vmadd(vmadd(vscale(m.x, v.x), m.y, v.y), m.z, v.z);
}

static inline vec3 affine_point(affine m, vec3 p) { return vadd(affine_vector(m, p), m.o); }

/* (1.7): origin and direction change, t does not. D is not normalised. */
static inline ray affine_ray(affine m, ray r)
{
    return (ray){affine_point(m, r.o), r.tmin, affine_vector(m, r.d), r.tmax};
}

/* First a, then b: p -> b(a(p)), the product B A of their matrices. */
static inline affine affine_then(affine a, affine b)
{
    return (affine){affine_vector(b, a.x), affine_vector(b, a.y), affine_vector(b, a.z),
                    affine_point(b, a.o)};
}

static inline affine affine_translation(vec3 by)
{
    return (affine){{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, by};
}

/* Along the axes. A negative factor mirrors. */
static inline affine affine_scaling(vec3 by)
{
    return (affine){{by.x, 0, 0}, {0, by.y, 0}, {0, 0, by.z}, {0, 0, 0}};
}

/* v turned about a unit axis by an angle in radians, anticlockwise seen against the axis.
 * Source: Rodrigues 1840: v cos + (axis x v) sin + axis (axis . v) (1 - cos). */
static inline vec3 vturned(vec3 v, vec3 axis, real angle)
{
    real c = cos(angle), s = sin(angle);
    vec3 turned = vmadd(vscale(v, c), vcross(axis, v), s);
    return vmadd(turned, axis, vdot(axis, v) * (1 - c));
}

static inline affine affine_rotation(vec3 axis, real angle)
{
    return (affine){vturned((vec3){1, 0, 0}, axis, angle), vturned((vec3){0, 1, 0}, axis, angle),
                    vturned((vec3){0, 0, 1}, axis, angle), {0, 0, 0}};
}

/* a times 2^e: exact, unless it under- or overflows. */
static inline vec3 vscaled_by(vec3 a, int e)
{
    return (vec3){ldexp(a.x, e), ldexp(a.y, e), ldexp(a.z, e)};
}

/* The transform that undoes m, by Cramer's rule: row i of the inverse is the cross product of the
 * two other columns over the determinant. The columns are scaled by powers of two first, which is
 * exact, so that a scaling by 1e200 or 1e-200 can be undone too. False, and *out untouched, if m
 * flattens space (determinant 0), is not finite, or has an inverse too large to write. */
static inline bool affine_inverse(affine m, affine *out)
{
    int ex, ey, ez;
    if (!vfinite(m.x) || !vfinite(m.y) || !vfinite(m.z)) return false;
    vec3 x = vscaled(m.x, &ex), y = vscaled(m.y, &ey), z = vscaled(m.z, &ez);
    vec3 a = vcross(y, z), b = vcross(z, x), c = vcross(x, y);
    real det = vdot(x, a);
    a = vscaled_by(vscale(a, 1 / det), -ex);
    b = vscaled_by(vscale(b, 1 / det), -ey);
    c = vscaled_by(vscale(c, 1 / det), -ez);
    affine i = {{a.x, b.x, c.x}, {a.y, b.y, c.y}, {a.z, b.z, c.z}, {0, 0, 0}};
    i.o = vneg(affine_vector(i, m.o));
    if (!vfinite(a) || !vfinite(b) || !vfinite(c) || !vfinite(i.o)) return false;
    *out = i;
    return true;
}

#endif
