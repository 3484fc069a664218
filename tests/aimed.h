/* aimed.h: rays that hit where structures go wrong, and meshes that are hard to cut.
 *
 *   ray r = aimed(&m, &g, kind, centre, size)   one of the aimed_kinds: at corners, along edges,
 *                                 in planes of faces, along axes, with odd intervals; the mesh lies
 *                                 within `size` of `centre`
 *   bool same(got_a, a, got_b, b)               the same answer, bit for bit
 *   mesh m = needles(n, width)                  n, 1 long, `width` wide, within a cube of side 2
 *   mesh m = floors_mesh(n)                     squares in the planes x, y, z = -1 + 2 i / n:
 *                                 faces, edges and corners on each other and on dyadic planes
 */
#ifndef AIMED_H
#define AIMED_H

#include "../chapters/07_mesh/closest.h"
#include "../chapters/07_mesh/scenes/soup.h"

enum { aimed_kinds = 12 };

/* ---------------------------------------------------------------------------------------------- */

static inline bool same(bool ga, hit a, bool gb, hit b)
{
    return ga == gb && (!ga || (a.t == b.t && a.u == b.u && a.v == b.v && a.shape == b.shape));
}

static inline size_t random_below(random_stream *g, size_t n)
{
    return (size_t)(random_next_bits(g) % n);
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

static inline void set_triangle(mesh *m, size_t i, vec3 a, vec3 b, vec3 c)
{
    m->v[3 * i] = a, m->v[3 * i + 1] = b, m->v[3 * i + 2] = c;
}

/* A bundle of needles through the unit cube, 1 long and `width` wide: seen along their length or
 * edge-on, their t is as far off as it can be. */
static inline mesh needles(size_t n, real width) { return needle_mesh(n, width, 77); }

/* 3 (n + 1) planes of n x n squares each, cut in two: 6 n^2 (n + 1) triangles. */
static inline mesh floors_mesh(int n)
{
    mesh m = mesh_room((size_t)(6 * n * n * (n + 1)));
    size_t i = 0;
    for (int k = 0; k < 3; k++)
        for (int layer = 0; layer <= n; layer++)
            for (int cell = 0; cell < n * n; cell++) {
                real p[4][3];
                for (int c = 0; c < 4; c++) {
                    int a = cell % n + (c == 1 || c == 2), b = cell / n + c / 2;
                    p[c][k] = -1 + 2 * (real)layer / (real)n;
                    p[c][(k + 1) % 3] = -1 + 2 * (real)a / (real)n;
                    p[c][(k + 2) % 3] = -1 + 2 * (real)b / (real)n;
                }
                vec3 q[4];
                for (int c = 0; c < 4; c++) q[c] = (vec3){p[c][0], p[c][1], p[c][2]};
                set_triangle(&m, i++, q[0], q[1], q[2]);
                set_triangle(&m, i++, q[0], q[2], q[3]);
            }
    return m;
}

#endif
