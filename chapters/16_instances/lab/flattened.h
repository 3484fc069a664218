/* flattened.h: two ways to do without two levels: every instance asked in turn, which says what is
 * right, and a crowd as one mesh of everything (展平).
 *
 *   affine *a = crowd_inverses(&c)                   [n], once
 *   bool crowd_hit(&c, a, r, &h, &i)                 every instance asked in turn: O(n T) a ray
 *   mesh_bytes(&m)                                   memory of a mesh
 *   mesh m = crowd_flattened(&c)
 *   double n = flattened_triangles(&x)        how many, without making it
 *
 * The corners of instance i are M p + m, rounded; its triangles follow those of instance i - 1, so
 * the lower index is the lower instance, then the lower triangle, as it should be. An instance that
 * is never hit (placing.h) is left out. Corners keep their order, so that u and v mean the same; in
 * a mirrored instance they then go clockwise seen from outside.
 */
#ifndef INSTANCES_FLATTENED_H
#define INSTANCES_FLATTENED_H

#include "../instances.h"

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

/* One instance, behind what m holds already. */
static inline void flat_add(mesh *m, const mesh *part, affine to_world, affine to_object)
{
    uint32_t base = (uint32_t)m->vertices;
    for (size_t k = 0; k < part->vertices; k++)
        m->v[m->vertices++] = affine_point(to_world, part->v[k]);
    for (size_t k = 0; k < 3 * part->triangles; k++) {
        uint32_t *to = &m->index[3 * m->triangles + k], n = mesh_none;
        *to = part->index[k] + base;
        if (!m->n) continue;
        if (part->n) n = part->normal_index ? part->normal_index[k] : part->index[k];
        if (n != mesh_none) n += (uint32_t)m->normals;
        m->normal_index[3 * m->triangles + k] = n;
    }
    for (size_t k = 0; m->n && k < part->normals; k++)
        m->n[m->normals++] = normal_to_world(&to_object, part->n[k]);
    m->triangles += part->triangles;
}

/* The program ends if it does not fit: 2^32 - 1 corners, or memory. */
static inline mesh crowd_flattened(const crowd *c)
{
    size_t v = 0, t = 0, n = 0;
    mesh m = {0};
    for (size_t i = 0; i < c->n; i++) {
        const mesh *part = &c->mesh[c->list[i].mesh];
        v += part->vertices, t += part->triangles, n += part->n ? part->normals : 0;
    }
    if (v >= mesh_none || n >= mesh_none || t >> 31)
        die(2, "%zu triangles flattened: fewer than 2^31 fit", t);
    m.v = allocate(v, sizeof *m.v);
    m.index = allocate(3 * t, sizeof *m.index);
    if (n) m.n = allocate(n, sizeof *m.n), m.normal_index = allocate(3 * t, sizeof *m.index);
    for (size_t i = 0; i < c->n; i++) {
        affine a;
        if (!instance_inverse(c->list[i].to_world, &a)) continue;
        flat_add(&m, &c->mesh[c->list[i].mesh], c->list[i].to_world, a);
    }
    return m;
}

static inline double flattened_triangles(const instances *x)
{
    double n = 0;
    for (size_t i = 0; i < x->tree.items; i++) n += (double)x->mesh[x->place[i].mesh].triangles;
    return n;
}

#endif
