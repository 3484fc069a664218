/* items.h: what an acceleration structure holds: the triangles of a mesh, or shapes of any kind.
 *
 *   items x = items_of_mesh(&m);        the triangles of a mesh, or
 *   items x = items_of_scene(&s);       the shapes of a scene (07); either must outlive x
 *   bool items_bounds(&x, i, &box)      false: item i can never be hit; leave it out
 *   bool items_triangle(&x, i, &t)      false: item i is another shape
 *   bool items_all_bounds(&x, &all, &f) around all that can be hit; false: too large, see below
 *   bool items_hit(&x, r, &h)           brute force: the answer that every structure must give
 *   bool items_occluded(&x, r)
 *   bool query_ask(&q, &x, i, any)      asks one item, in the course of a search
 *
 * Coordinates up to items_most, 1e75 (1e9 in float), are taken: areas and volumes stay finite.
 */
#ifndef AABB_ITEMS_H
#define AABB_ITEMS_H

#include "../07_mesh/scene.h"
#include "structure.h"

typedef struct { const mesh *m; const scene *s; size_t n; } items;  /* m or s; the other is NULL */

#define items_most (real_is_float ? (real)1e9 : (real)1e75)

/* ---------------------------------------------------------------------------------------------- */

static inline items items_of_mesh(const mesh *m) { return (items){m, NULL, m->triangles}; }
static inline items items_of_scene(const scene *s) { return (items){NULL, s, s->n}; }

static inline bool items_triangle(const items *x, size_t i, triangle *out)
{
    if (x->m) *out = mesh_triangle(x->m, i);
    else if (x->s->shapes[i].kind == SHAPE_TRIANGLE) *out = x->s->shapes[i].triangle;
    else return false;
    return true;
}

static inline bool items_bounds(const items *x, size_t i, aabb *out)
{
    aabb b;
    if (x->m) {
        triangle t = mesh_triangle(x->m, i);
        if (!vfinite(t.a) || !vfinite(t.b) || !vfinite(t.c)) return false;  /* as in 04 */
        b = (aabb){vmin(vmin(t.a, t.b), t.c), vmax(vmax(t.a, t.b), t.c)};
    } else {
        shape_bounds(x->s->shapes[i], &b.lo, &b.hi);
        if (!(b.lo.x <= b.hi.x && b.lo.y <= b.hi.y && b.lo.z <= b.hi.z)) return false;
    }
    *out = b;
    return true;
}

/* Empty (aabb_empty) if nothing can be hit. */
static inline bool items_all_bounds(const items *x, aabb *all, failure *f)
{
    *all = aabb_empty();
    if (x->n >= UINT32_MAX)
        return failed(f, 2, "%zu items: fewer than %u fit", x->n, (unsigned)UINT32_MAX);
    for (size_t i = 0; i < x->n; i++) {
        aabb b;
        if (!items_bounds(x, i, &b)) continue;
        *all = aabb_union(*all, b);
        real size = aabb_reach(b);
        if (!(size <= items_most))
            return failed(f, 2, "item %zu reaches to %g: coordinates up to %g are allowed", i,
                          (double)size, (double)items_most);
    }
    return true;
}

static inline bool items_hit(const items *x, ray r, hit *out)
{
    return x->m ? mesh_hit(x->m, r, out) : scene_hit(x->s, r, out);
}

static inline bool items_occluded(const items *x, ray r)
{
    return x->m ? mesh_occluded(x->m, r) : scene_occluded(x->s, r);
}

/* Asks item i. True if it is closer than the best so far (any: if it is hit at all). */
fast_inline bool query_ask(query *q, const items *x, uint32_t i, bool any)
{
    hit h;
    if (x->m ? !mesh_triangle_hit(x->m, i, &q->shear, q->r, &h)
             : !shape_hit_sheared(&x->s->shapes[i], &q->shear, q->r, &h)) return false;
    h.shape = i;
    return any || query_improves(q, h);
}

#endif
