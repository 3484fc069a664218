/* closest.h: the closest hit (最近交点) by brute force: ask everybody. O(n) a ray, nothing to
 * build.
 *
 *   scene s = {shapes, n};                    the shapes belong to the caller
 *   bool scene_hit(&s, r, &h)                 closest hit; h.shape is the index of the shape
 *   bool scene_occluded(&s, r)                is there any hit at all? ends at the first one found
 *   bool mesh_hit(&m, r, &h)                  the same for the triangles of a mesh: h.shape is the
 *   bool mesh_occluded(&m, r)                 triangle, h.u and h.v its barycentrics
 *
 *   t = min { t_i : shape i is hit at t_i, tmin <= t_i <= tmax }, the lowest i at equal t     (7.1)
 *
 * The interval shrinks to the best hit so far, and is closed: see hit.h. The answer does not
 * depend on the order of the search. (In first.h the last one wins at equal t.) An empty scene is
 * never hit. `out` is untouched on a miss.
 */
#ifndef MESH_CLOSEST_H
#define MESH_CLOSEST_H

#include "mesh.h"
#include "shape.h"

typedef struct { const shape *shapes; size_t n; } scene;

/* State of a search: r.tmax is the t of `best`. */
typedef struct { ray r; ray_shear shear; hit best; } query;

/* ---------------------------------------------------------------------------------------------- */

static inline query query_of(ray r) { return (query){r, shear_of(r), hit_none}; }

/* Keeps h as the best hit if it comes before it. */
fast_inline bool query_improves(query *q, hit h)
{
    if (!hit_before(h, q->best)) return false;
    q->best = h;
    q->r.tmax = h.t;
    return true;
}

static inline bool query_answer(const query *q, hit *out)
{
    if (q->best.shape == no_shape) return false;
    *out = q->best;
    return true;
}

static inline bool scene_hit(const scene *s, ray r, hit *out)
{
    query q = query_of(r);
    hit h;
    for (size_t i = 0; i < s->n; i++)
        if (shape_hit_sheared(&s->shapes[i], &q.shear, q.r, &h))
            h.shape = (uint32_t)i, query_improves(&q, h);
    return query_answer(&q, out);
}

static inline bool scene_occluded(const scene *s, ray r)
{
    ray_shear k = shear_of(r);
    hit h;
    for (size_t i = 0; i < s->n; i++)
        if (shape_hit_sheared(&s->shapes[i], &k, r, &h)) return true;
    return false;
}

fast_inline bool mesh_triangle_hit(const mesh *m, size_t i, const ray_shear *k, ray r, hit *out)
{
    const uint32_t *c = m->index + 3 * i;
    return triangle_hit_corners(&m->v[c[0]], &m->v[c[1]], &m->v[c[2]], k, r, out);
}

static inline bool mesh_hit(const mesh *m, ray r, hit *out)
{
    query q = query_of(r);
    hit h;
    for (size_t i = 0; i < m->triangles; i++)
        if (mesh_triangle_hit(m, i, &q.shear, q.r, &h))
            h.shape = (uint32_t)i, query_improves(&q, h);
    return query_answer(&q, out);
}

static inline bool mesh_occluded(const mesh *m, ray r)
{
    ray_shear k = shear_of(r);
    hit h;
    for (size_t i = 0; i < m->triangles; i++)
        if (mesh_triangle_hit(m, i, &k, r, &h)) return true;
    return false;
}

#endif
