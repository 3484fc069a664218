/* items.h: what an acceleration structure (加速结构) holds, and what all searches share.
 *
 *   items x = items_of_mesh(&m);        the triangles of a mesh, or
 *   items x = items_of_scene(&s);       the shapes of a scene (07); either must outlive x
 *   bool items_bounds(&x, i, &box)      false: item i can never be hit; leave it out
 *   bool items_all_bounds(&x, &all, &f) around all that can be hit; false: too large, see below
 *   bool items_hit(&x, r, &h)           brute force: the answer that every structure must give
 *   bool items_occluded(&x, r)
 *
 * Every structure X of the next chapters has the same verbs, in the same order:
 *
 *   bool X_build(&x, how, &s, &f)       false: it does not fit into how.most_bytes, and f says so
 *   bool X_hit(&s, r, &h)               the very hit (t, u, v, shape) of items_hit
 *   bool X_occluded(&s, r)              the answer of items_occluded
 *   bool X_hit_counted(&s, r, &h, &w)   the same, and adds what it took to the search_work w
 *   bool X_occluded_counted(&s, r, &w)
 *   structure_stats X_stats(&s)
 *   void X_free(&s)                     a zeroed one may be freed
 *
 * A search cuts space into cells, asks the items of each cell that the ray passes, and ends when
 * the next cell begins beyond the best hit. Two things must not go wrong:
 *
 *   1. At equal t the lower index wins (hit.h), so a cell that begins at t = tmax is still asked.
 *   2. Rounding. The ray's t at a cell's side is rounded, the test of an item is rounded: each of
 *      them may place a hit on the other side of a wall. So cells are entered a little early and
 *      left a little late: by query_delta, a length, along every axis                      (10.1)
 *
 *          delta = 512 eps D,    D = the largest |side of the bounds - o| along an axis
 *
 *      A hit that an item reports lies within 256 eps D of the item and of the true ray (14 and 04
 *      say why, and (7.14) and (7.15) for cones and polygons); the planes' own t are right within
 *      4 eps D. The rest is for the building of cells.
 *      (One kind is left out: a polygon whose corners are farther off their plane than 32 eps of
 *      its size, seen edge-on. Its picture may cross itself, and the hit is only within its hull.)
 *
 * Coordinates up to items_most, 1e75 (1e9 in float), are taken: areas and volumes stay finite.
 */
#ifndef ITEMS_H
#define ITEMS_H

#include "../07_mesh/closest.h"
#include "aabb.h"

typedef struct { const mesh *m; const scene *s; size_t n; } items;  /* m or s; the other is NULL */

/* State of a search: r.tmax is the t of `best`. */
typedef struct { ray r; ray_shear shear; hit best; } query;

typedef struct {
    size_t nodes;   /* steps: inner nodes, or cells of a grid, passed */
    size_t leaves;  /* leaves, or cells, that were asked */
    size_t empty;   /* of these: with nothing in them */
    size_t tests;   /* items tested */
} search_work;

typedef struct {
    size_t inner, leaves, empty;  /* inner nodes; leaves or cells; of these with nothing in them */
    size_t references;            /* sum over the leaves of the items in them */
    size_t items;                 /* that can be hit at all; references / items: how often cut */
    int depth;                    /* of the deepest leaf; 0: the root is one */
    size_t bytes, peak;           /* held now; the most held while it was built */
} structure_stats;

#define items_most (real_is_float ? (real)1e9 : (real)1e75)

/* ---------------------------------------------------------------------------------------------- */

static inline items items_of_mesh(const mesh *m) { return (items){m, NULL, m->triangles}; }
static inline items items_of_scene(const scene *s) { return (items){NULL, s, s->n}; }

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
        vec3 far = vmax(vmax(b.hi, vneg(b.hi)), vmax(b.lo, vneg(b.lo)));
        real size = vaxis(far, vlongest(far));
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

/* ---------------------------------------------------------------------------------------------- */

/* A NaN, an infinite origin or no direction: such a ray hits nothing, and no search begins. */
static inline bool ray_is_usable(ray r) { return vfinite(r.o) && vfinite(r.d) && !vzero(r.d); }

static inline query query_of(ray r) { return (query){r, shear_of(r), hit_none}; }

/* (10.1) [scene units]; a little even where everything is 0. */
static inline real query_delta(ray r, aabb all)
{
    vec3 a = vsub(r.o, all.lo), b = vsub(all.hi, r.o);
    a = vmax(vmax(a, vneg(a)), vmax(b, vneg(b)));
    return vaxis(a, vlongest(a)) * (512 * real_epsilon) + real_smallest;
}

/* Keeps h as the best hit if it comes before it. */
__attribute__((always_inline))
static inline bool query_improves(query *q, hit h)
{
    if (!hit_before(h, q->best)) return false;
    q->best = h;
    q->r.tmax = h.t;
    return true;
}

/* Asks item i. True if it is closer than the best so far (any: if it is hit at all). */
__attribute__((always_inline))
static inline bool query_ask(query *q, const items *x, uint32_t i, bool any)
{
    hit h;
    if (x->m ? !mesh_triangle_hit(x->m, i, &q->shear, q->r, &h)
             : !shape_hit_sheared(&x->s->shapes[i], &q->shear, q->r, &h)) return false;
    h.shape = i;
    return any || query_improves(q, h);
}

static inline bool query_answer(const query *q, hit *out)
{
    if (q->best.shape == no_shape) return false;
    *out = q->best;
    return true;
}

#endif
