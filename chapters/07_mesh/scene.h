/* scene.h: shapes of any kind together, and the closest hit among them by brute force.
 *
 *   scene s = {shapes, n};          the shapes belong to the caller
 *   bool scene_hit(&s, r, &h)       closest hit; h.shape is the index of the shape
 *   bool scene_occluded(&s, r)      is there any hit at all? ends at the first one found
 *
 * As closest.h has it for a mesh: (7.1), the lowest index at equal t. An empty scene is never hit.
 * `out` is untouched on a miss.
 */
#ifndef MESH_SCENE_H
#define MESH_SCENE_H

#include "closest.h"
#include "shape.h"

typedef struct { const shape *shapes; size_t n; } scene;

/* ---------------------------------------------------------------------------------------------- */

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

#endif
