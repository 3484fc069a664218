/* flattened.h: two ways to do without two levels: every instance asked in turn, which says what is
 * right, and a crowd as one mesh of everything (展平).
 *
 *   affine *a = crowd_inverses(&c)                   [n], once
 *   bool crowd_hit(&c, a, r, &h, &i)                 every instance asked in turn: O(n T) a ray
 *   mesh m = crowd_flattened(&c)                     corners and triangles, without normals
 *   mesh_bytes(&m)                                   memory of these
 *   double n = flattened_triangles(&x)               how many, without making it
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
    const vec3 none = {(real)NAN, (real)NAN, (real)NAN};
    for (size_t i = 0; i < c->n; i++)
        if (!instance_inverse(c->list[i].to_world, &a[i])) a[i] = (affine){none, none, none, none};
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
    return m->vertices * sizeof *m->v + 3 * m->triangles * sizeof *m->index;
}

/* The program ends if it does not fit: 2^32 - 1 corners, or memory. */
static inline mesh crowd_flattened(const crowd *c)
{
    size_t v = 0, t = 0;
    mesh m = {0};
    for (size_t i = 0; i < c->n; i++) {
        const mesh *part = &c->mesh[c->list[i].mesh];
        v += part->vertices, t += part->triangles;
    }
    if (v >= mesh_none || t >> 31) die(2, "%zu triangles flattened: fewer than 2^31 fit", t);
    m.v = allocate(v, sizeof *m.v), m.index = allocate(3 * t, sizeof *m.index);
    for (size_t i = 0; i < c->n; i++) {
        const mesh *part = &c->mesh[c->list[i].mesh];
        affine to = c->list[i].to_world, back;
        if (!instance_inverse(to, &back)) continue;
        for (size_t k = 0; k < 3 * part->triangles; k++)
            m.index[3 * m.triangles + k] = part->index[k] + (uint32_t)m.vertices;
        for (size_t k = 0; k < part->vertices; k++)
            m.v[m.vertices++] = affine_point(to, part->v[k]);
        m.triangles += part->triangles;
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
