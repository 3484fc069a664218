/* closest.h: the closest hit (最近交点) by brute force: ask everybody. O(n) a ray, nothing to
 * build.
 *
 *   bool mesh_hit(&m, r, &h)        closest hit; h.shape is the triangle, h.u and h.v barycentrics
 *   bool mesh_occluded(&m, r)       is there any hit at all? ends at the first one found
 *
 *   query q = query_of(r);          the state of a search, this or a quicker one; then for each
 *   query_improves(&q, h)           hit found: kept, if it comes before the best so far
 *   query_answer(&q, &h)            the best; false: there was none
 *
 *   t = min { t_i : item i is hit at t_i, tmin <= t_i <= tmax }, the lowest i at equal t      (7.1)
 *
 * The interval shrinks to the best hit so far, and is closed: see hit.h. The answer does not
 * depend on the order of the search. (In first.h the last one wins at equal t.) An empty mesh is
 * never hit. `out` is untouched on a miss. Shapes of other kinds: scene.h, which asks the same way.
 */
#ifndef MESH_CLOSEST_H
#define MESH_CLOSEST_H

#include "mesh.h"

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
