/* alarms.h: a ray that hits the box need not hit what is in it (误报). How often it does not, and
 * what tighter boxes save.
 *
 *    +---------+     what is hit lies in the box:   no box hit  =>  no hit inside         (9.5)
 *    |  __   -----o  the converse is false:         a box hit says nothing yet
 *    | /  \    |
 *    | \__/    |     For a convex shape in a box, and lines that come from everywhere alike,
 *    +---------+        P(shape hit | box hit) = area of the shape / area of the box      (9.6)
 *
 * (both sides of a flat shape count: a triangle has twice its area).
 *
 *   boxed b = boxed_new(t, n)      a copy of n triangles, in one box; the caller frees: boxed_free
 *   boxed_split(&b, parts)         in so many boxes [1..n], each half of the one before
 *   boxed_hit(&b, r, &h)           closest hit: tests all boxes, and all triangles of those hit
 *   alarm_count a = boxed_count(&b, seed, rays)
 *   ray line_through(b, seed, i)   the i-th of lines that come from everywhere alike
 *
 * Sources: A. Cauchy, "Mémoire sur la rectification des courbes et la quadrature des surfaces
 * courbes", 1832 (9.6); J. Goldsmith, J. Salmon, "Automatic creation of object hierarchies for ray
 * tracing", IEEE CG&A 7(5), 1987 (what it means for boxes).
 */
#ifndef ALARMS_H
#define ALARMS_H

#include "../../../common/file.h"
#include "../../../common/random.h"
#include "../../04_triangle/triangle.h"
#include "../aabb.h"

typedef struct { aabb box; size_t first, n; } box_part;
typedef struct { real key; triangle t; } keyed_triangle;
typedef struct { keyed_triangle *t; size_t n; box_part *part; size_t parts; } boxed;
typedef struct {
    size_t rays, box_tests, triangle_tests;
    size_t any_box, any_triangle;  /* rays that hit at least one box, one triangle */
    size_t box_hits, vain;         /* boxes hit; those of them where no triangle inside was hit */
} alarm_count;

/* ---------------------------------------------------------------------------------------------- */

static inline aabb triangle_box(triangle t)
{
    return aabb_grow_point(aabb_grow_point(aabb_grow_point(aabb_empty(), t.a), t.b), t.c);
}

static inline aabb boxed_bounds(const boxed *b, size_t first, size_t n)
{
    aabb box = aabb_empty();
    for (size_t i = first; i < first + n; i++) box = aabb_union(box, triangle_box(b->t[i].t));
    return box;
}

static inline int keyed_order(const void *a, const void *b)
{
    real x = ((const keyed_triangle *)a)->key, y = ((const keyed_triangle *)b)->key;
    return (x > y) - (x < y);
}

/* Cuts the triangles [first, first + n) at the middle one along the longest side of their box. */
static inline void boxed_cut(boxed *b, size_t first, size_t n, size_t parts)
{
    aabb box = boxed_bounds(b, first, n);
    if (parts == 1 || n == 1) {
        b->part[b->parts++] = (box_part){box, first, n};
        return;
    }
    int k = vlongest(vsub(box.hi, box.lo));
    for (size_t i = first; i < first + n; i++)
        b->t[i].key = vaxis(aabb_center(triangle_box(b->t[i].t)), k);
    qsort(b->t + first, n, sizeof *b->t, keyed_order);
    boxed_cut(b, first, n / 2, parts / 2);
    boxed_cut(b, first + n / 2, n - n / 2, parts - parts / 2);
}

static inline void boxed_split(boxed *b, size_t parts)
{
    free(b->part);
    b->part = allocate(parts, sizeof *b->part), b->parts = 0;
    if (b->n) boxed_cut(b, 0, b->n, parts);
}

static inline boxed boxed_new(const triangle *t, size_t n)
{
    boxed b = {.t = allocate(n ? n : 1, sizeof *b.t), .n = n};
    for (size_t i = 0; i < n; i++) b.t[i].t = t[i];
    boxed_split(&b, 1);
    return b;
}

static inline void boxed_free(boxed *b)
{
    free(b->t), free(b->part);
    *b = (boxed){0};
}

static inline bool boxed_hit(const boxed *b, ray r, hit *out)
{
    ray_inverse inverse = inverse_of(r);
    ray_shear shear = shear_of(r);
    hit best = hit_none, h;
    real enter;
    for (const box_part *p = b->part; p < b->part + b->parts; p++) {
        if (!aabb_hit_inverse(&p->box, &inverse, r, &enter)) continue;
        for (size_t i = p->first; i < p->first + p->n; i++)
            if (triangle_hit_sheared(b->t[i].t, &shear, r, &h)
                && (h.shape = (uint32_t)i, hit_before(h, best)))
                best = h, r.tmax = h.t;
    }
    if (best.shape == no_shape) return false;
    *out = best;
    return true;
}

/* A direction from all alike, and a point from all alike in the disc across it that covers the
 * sphere round the box: each line through that sphere is as likely as any other. */
static inline ray line_through(aabb b, uint64_t seed, uint64_t i)
{
    random_stream s = random_start(seed, i, 0);
    real z = 2 * random_next(&s) - 1, a = 2 * pi * random_next(&s), flat = sqrt(1 - z * z);
    vec3 d = {flat * cos(a), flat * sin(a), z}, u, v;
    real reach = vlength(vsub(b.hi, b.lo)) / 2, r = reach * sqrt(random_next(&s));
    a = 2 * pi * random_next(&s);
    vbasis(d, &u, &v);
    vec3 o = vmadd(vmadd(aabb_center(b), u, r * cos(a)), v, r * sin(a));
    return ray_from(vmadd(o, d, -2 * reach), d);
}

/* Every box and every triangle in a box that is hit, over the whole ray: no search for the closest
 * one, so that the counts do not depend on the order of the boxes. */
static inline alarm_count boxed_count(const boxed *b, uint64_t seed, size_t rays)
{
    alarm_count c = {.rays = rays};
    aabb all = boxed_bounds(b, 0, b->n);
    for (size_t n = 0; n < rays; n++) {
        ray r = line_through(all, seed, n);
        size_t boxes = c.box_hits, vain = c.vain;
        real enter;
        hit h;
        for (const box_part *p = b->part; p < b->part + b->parts; p++, c.box_tests++) {
            if (!aabb_hit(p->box, r, &enter)) continue;
            size_t inside = 0;
            for (size_t i = p->first; i < p->first + p->n; i++)
                inside += triangle_hit(b->t[i].t, r, &h);
            c.triangle_tests += p->n;
            c.box_hits++;
            c.vain += inside == 0;
        }
        c.any_box += c.box_hits > boxes;
        c.any_triangle += c.box_hits - boxes > c.vain - vain;
    }
    return c;
}

#endif
