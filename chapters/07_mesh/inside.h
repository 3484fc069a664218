/* inside.h: does a point lie inside a mesh? Three answers, and what each of them needs.
 *
 *        ______           parity (奇偶性): a way out of a closed mesh crosses it an odd number of
 *       /  p---\-----> 1  times, a way from outside an even number. True of the crossings of the
 *      /_______/          surface; the triangles that say "hit" are more, where the ray meets an
 *                         edge or a vertex.
 *
 *   bool first_mesh_inside(&soup, p, d) counts hits of the ray p + t d, of first.h: wrong on edges
 *                                       and vertices, where none or several triangles are hit
 *   bool inside_parity(&m, p, d)        counts crossings, one for each, edges and vertices included
 *   bool inside_winding(&m, p)          |winding number| > 1/2: no ray at all
 *   double winding_number(&m, p)        环绕数: how often the mesh surrounds p: 1 inside, 0 outside
 *
 *   needs           closed mesh    orientation of triangles    time for n triangles
 *   parity          yes            any                         n tests
 *   winding number  no             the same everywhere         3 n square roots
 *
 * On the surface itself, and closer to it than rounding can tell, any answer may come. Each is
 * O(n). Parts of a mesh that overlap: parity calls the overlap outside, the winding number there
 * is 2.
 *
 * Sources: A. Van Oosterom, J. Strackee, "The Solid Angle of a Plane Triangle", IEEE Trans.
 * Biomed. Eng. 30(2), 1983, eq. 8; A. Jacobson, L. Kavan, O. Sorkine-Hornung, "Robust
 * Inside-Outside Segmentation using Generalized Winding Numbers", ACM Trans. Graphics 32(4),
 * 2013.
 */
#ifndef MESH_INSIDE_H
#define MESH_INSIDE_H

#include "mesh.h"
#include "polygon.h"

/* ---------------------------------------------------------------------------------------------- */

/* The picture along the ray again: each corner has one place in it, and triangle a b c contains the
 * origin if an odd number of its edges cross the half axis y = 0, x > 0, by (7.9); one through the
 * ray itself counts as passing on the other side. Two triangles give their shared edge the same
 * answer, so over a closed mesh all of them cancel: the whole line has an even number of crossings
 * whatever the rounding did, and those in front of p tell where p is.                      (7.2) */
static inline bool inside_parity(const mesh *m, vec3 p, vec3 d)
{
    ray_shear s = shear_of(ray_from(p, d));
    bool odd = false;
    for (size_t i = 0; i < m->triangles; i++) {
        const uint32_t *k = m->index + 3 * i;
        vec3 a = shear_corner(&m->v[k[0]], &s), b = shear_corner(&m->v[k[1]], &s),
             c = shear_corner(&m->v[k[2]], &s);
        int crossed = (edge_of(a, b) == EDGE_CROSSES) + (edge_of(b, c) == EDGE_CROSSES)
                      + (edge_of(c, a) == EDGE_CROSSES);
        if (crossed % 2 == 0) continue;
        real ea = b.x * c.y - b.y * c.x, eb = c.x * a.y - c.y * a.x, ec = a.x * b.y - a.y * b.x;
        odd ^= (ea * a.z + eb * b.z + ec * c.z) / (ea + eb + ec) * s.sz > 0;  /* t > 0 */
    }
    return odd;
}

/* Signed solid angle Omega of a triangle seen from the origin: half of it is the angle of x + i y,
 *     tan(Omega / 2) = a.(b x c) / (|a||b||c| + (a.b)|c| + (b.c)|a| + (c.a)|b|) = y / x      (7.3)
 * Both are 0 where a corner is at the origin. */
static inline void solid_angle_half(vec3 a, vec3 b, vec3 c, double *x, double *y)
{
    real la = vlength(a), lb = vlength(b), lc = vlength(c);
    *x = (double)(la * lb * lc + vdot(a, b) * lc + vdot(b, c) * la + vdot(c, a) * lb);
    *y = (double)vdot(a, vcross(b, c));
}

/* Sum of all solid angles over that of the sphere, 4 pi. Error: some n epsilon, of 1.      (7.4)
 * Where complex numbers are multiplied their angles add: one arc tangent for all triangles, of the
 * product, and a turn for each time that it passed the negative half axis. */
static inline double winding_number(const mesh *m, vec3 p)
{
    double x = 1, y = 0, turns = 0;
    for (size_t i = 0; i < m->triangles; i++) {
        triangle t = mesh_triangle(m, i);
        double u, v;
        solid_angle_half(vsub(t.a, p), vsub(t.b, p), vsub(t.c, p), &u, &v);
        double X = x * u - y * v, Y = x * v + y * u, size = fabs(X) + fabs(Y);
        if (size == 0) continue;
        bool up = y >= 0;
        if (up == (v >= 0) && up != (Y >= 0)) turns += up ? 1 : -1;
        x = X / size, y = Y / size;
    }
    return turns + atan2(y, x) / (2 * 3.14159265358979323846);
}

static inline bool inside_winding(const mesh *m, vec3 p)
{
    return fabs(winding_number(m, p)) > 0.5;
}

#endif
