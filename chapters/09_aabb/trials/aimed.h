/* aimed.h: rays that hit where structures go wrong: for the tests, and for 17, which proves what it
 * compares.
 *
 *   ray r = aimed(&m, &g, kind, centre, size)   one of the aimed_kinds: at corners, along edges,
 *                                 in planes of faces, along axes, with odd intervals; the mesh lies
 *                                 within `size` of `centre`
 *   ray q = aimed_way(r, t, way)  way 0: r; 1: r ending exactly at t, where it hits; 2: [t, t]:
 *                                 intervals are closed, so all aimed_ways find the same hit
 *   bool same(got_a, a, got_b, b)               the same answer, bit for bit
 */
#ifndef AABB_AIMED_H
#define AABB_AIMED_H

#include "../../07_mesh/closest.h"
#include "../../../common/random.h"

enum { aimed_kinds = 12, aimed_ways = 3 };

/* ---------------------------------------------------------------------------------------------- */

static inline bool same(bool ga, hit a, bool gb, hit b)
{
    return ga == gb && (!ga || (a.t == b.t && a.u == b.u && a.v == b.v && a.shape == b.shape));
}

static inline size_t random_below(random_stream *g, size_t n)
{
    return (size_t)(random_next_bits(g) % n);
}

static inline ray aimed_way(ray r, real t, int way)
{
    if (way > 0) r.tmax = t;
    if (way > 1) r.tmin = t;
    return r;
}

/* A ray of one of aimed_kinds at a mesh within `size` of `centre`. */
static inline ray aimed(const mesh *m, random_stream *g, int kind, vec3 centre, real size)
{
    size_t i = random_below(g, m->triangles);
    triangle t = mesh_triangle(m, i), s = mesh_triangle(m, random_below(g, m->triangles));
    vec3 o = vadd(centre, random_in_cube(g, 3 * size)), axis = {0, 0, 0};
    real u = random_next(g), v = random_next(g) * (1 - u);
    real *along = (real *)&axis + random_below(g, 3);
    *along = random_next_bits(g) & 1 ? 1 : -1;
    ray r = ray_from(o, random_in_cube(g, 1));
    switch (kind) {
    case 0: r.d = vsub(vadd(centre, random_in_cube(g, size)), o); break;
    case 1: r.d = vsub(t.a, o); break;                                       /* at a corner */
    case 2: r.d = vsub(vmadd(t.a, vsub(t.b, t.a), u), o); break;             /* at an edge */
    case 3: r.d = vsub(vmadd(vmadd(t.a, vsub(t.b, t.a), u), vsub(t.c, t.a), v), o); break;
    case 4: r.o = vmadd(t.a, axis, -4 * size), r.d = axis; break;            /* in sides of boxes */
    case 5: r.o = t.a, r.d = vsub(s.b, t.a); break;                          /* corner to corner */
    case 6: r.o = vmadd(t.a, vsub(t.b, t.a), -3), r.d = vsub(t.b, t.a); break; /* along an edge */
    case 7: r = ray_from(vmadd(t.a, axis, -4 * size), vadd(axis, random_in_cube(g, real_smallest)));
        break;
    case 8: r.d = vsub(t.a, o), r.tmin = -real_infinity; break;              /* the whole line */
    case 9: r.d = vscale(vsub(t.a, o), (real)0x1p-30), r.tmin = -5, r.tmax = (real)0x1p30; break;
    case 10: r.d = vscale(vscale(vsub(t.a, o), (real)0x1p70), (real)0x1p70); break; /* t = 2^-140 */
    default: r.d = vsub(t.a, o), r.tmax = 1; break; /* ends on the corner */
    }
    return r;
}

#endif
