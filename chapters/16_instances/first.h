/* first.h: instances (实例): one mesh in memory, many in the scene. The ray moves, not the mesh.
 * Slow: it asks every instance, O(n). Wrong where det M is 0, as it is, rounded, at a scale of
 * 1e-110 (1e-15 in float), and far away, as 14 is. build.h has a tree, and pays for rounding. */
#ifndef FIRST_INSTANCES_H
#define FIRST_INSTANCES_H
#include "../14_bvh/first.h"

/* Object to world: p = M q + m. M has the columns x, y, z, where the axes of the object go. */
typedef struct {
    vec3 x, y, z, m;
    vec3 a, b, c;  /* rows of A, the inverse of M: world to object */
} first_instance;

typedef struct { const first_bvh *mesh; first_instance *one; int n; } first_crowd;

/* The rows of an inverse are cross products of the columns over the determinant (Cramer again). */
static inline first_instance first_instance_at(vec3 x, vec3 y, vec3 z, vec3 m)
{
    vec3 a = vcross(y, z), b = vcross(z, x), c = vcross(x, y);
    real det = vdot(x, a);
    return (first_instance){x, y, z, m, vscale(a, 1 / det), vscale(b, 1 / det), vscale(c, 1 / det)};
}

/* o' = A (o - m), d' = A d. d' is not made unit, so that t' = t: a point of the ray has the same t
 * in the world and in the object, and hits of different instances can be compared.       (16.1) */
static inline ray first_instance_ray(const first_instance *i, ray r)
{
    vec3 o = vsub(r.o, i->m);
    r.o = (vec3){vdot(i->a, o), vdot(i->b, o), vdot(i->c, o)};
    r.d = (vec3){vdot(i->a, r.d), vdot(i->b, r.d), vdot(i->c, r.d)};
    return r;
}

/* n' = A^T n: a normal is no arrow that M could turn; it is a plane's, and stays at right angles to
 * it. Unit, out.                                                                        (16.4) */
static inline vec3 first_instance_normal(const first_instance *i, vec3 n)
{
    return vunit(vadd(vadd(vscale(i->a, n.x), vscale(i->b, n.y)), vscale(i->c, n.z)));
}

/* out->shape: the triangle; *which: the instance. */
static inline bool first_crowd_hit(const first_crowd *x, ray r, hit *out, int *which)
{
    bool found = false;
    for (int i = 0; i < x->n; i++)
        if (first_bvh_hit(x->mesh, first_instance_ray(&x->one[i], r), out)) {
            found = true;
            *which = i;
            r.tmax = out->t;
        }
    return found;
}
#endif
