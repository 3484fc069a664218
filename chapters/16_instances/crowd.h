/* crowd.h: what there is to be seen: meshes, and where they stand. To ask one after the other is to
 * do without a tree of two levels; it says what is right.
 *
 *   crowd c = {mesh, meshes, list, n};               all of it belongs to the caller
 *   affine *a = crowd_inverses(&c)                   [n], once
 *   bool crowd_hit(&c, a, r, &h, &i)                 every instance asked in turn: O(n T) a ray
 *   mesh_bytes(&m)                                   memory of a mesh
 */
#ifndef INSTANCES_CROWD_H
#define INSTANCES_CROWD_H

#include "../07_mesh/closest.h"
#include "placing.h"

typedef struct { affine to_world; uint32_t mesh; } instance;
typedef struct { const mesh *mesh; size_t meshes; const instance *list; size_t n; } crowd;

/* ---------------------------------------------------------------------------------------------- */

/* NaN where there is none: no ray passes instance_ray then. The caller frees it. */
static inline affine *crowd_inverses(const crowd *c)
{
    affine *a = allocate(c->n, sizeof *a);
    real x = (real)NAN;
    for (size_t i = 0; i < c->n; i++)
        if (!instance_inverse(c->list[i].to_world, &a[i]))
            a[i] = (affine){{x, x, x}, {x, x, x}, {x, x, x}, {x, x, x}};
    return a;
}

static inline bool crowd_hit(const crowd *c, const affine *inverse, ray r, hit *out,
                             uint32_t *which)
{
    bool found = false;
    for (size_t i = 0; i < c->n; i++) {
        ray inside;
        hit h;
        if (!instance_ray(&inverse[i], r, &inside)) continue;
        if (!mesh_hit(&c->mesh[c->list[i].mesh], inside, &h)) continue;
        if (found && !(h.t < out->t)) continue;  /* equal t: the lower instance, which came first */
        *out = h, *which = (uint32_t)i;
        r.tmax = h.t;
        found = true;
    }
    return found;
}

static inline size_t mesh_bytes(const mesh *m)
{
    size_t corners = 3 * m->triangles * sizeof *m->index;
    return (m->vertices + m->normals) * sizeof *m->v + corners + (m->normal_index ? corners : 0);
}

#endif
