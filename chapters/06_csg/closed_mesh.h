/* closed_mesh.h: the inside of a closed mesh, by every place where a line passes through it.
 *
 *        +1        -1      +1  -1          what enters counts +1, what leaves -1; inside, where the
 *    -----[=========]-------[===]---->     sum of what lies behind us is 1 or more:
 *     0        1        0     1    0       a winding number (环绕数)                       (6.6)
 *
 *   csg_closed m = {triangles, n, NULL}; counter-clockwise seen from outside; not copied
 *   n = csg_closed_crossings(m, r, first, out)      spans of the whole line; room for m.n + 2
 *   csg_closed_is_finite(m)              every corner is; else the mesh is for csg.h an empty set
 *
 * triangle_hit (04) answers that at least one triangle round an edge is hit. Here an edge has to
 * count once: two hits would close what they open. So the signs of 04's edge functions (4.10) are
 * computed exactly, and where one is 0, the line passes an edge or a corner, it is moved aside by a
 * step too small to be written down, the same for all triangles: (e, e^2) in the frame of the ray,
 * e -> 0. Neighbours then differ in the sign of their edge, always, and in a closed mesh
 * the sum (6.6) is 0 at both ends of every line. No tolerance, no second ray.
 *
 * A face may lie in the plane of another solid's face; coplanar.h finds that out, once, and m.plane
 * tells. Then the plane gives t, by (6.4), as it gives it to the other solid: to the last bit. Two
 * meshes that share a triangle find the same t, wherever in either of them its corners begin and
 * whichever way round they go.
 *
 *   mesh                                             answer
 *   open: a triangle is missing                      lines through the hole see a solid without end
 *   all triangles the other way round                empty
 *   overlapping shells; shells within shells         their union
 *   triangles without area                           count nothing; where closed, it stays closed
 *   one t beyond the largest real                    this line does not meet the mesh
 *
 * Cost: O(n) a ray. Sources: S. Woop, C. Benthin, I. Wald, "Watertight Ray/Triangle Intersection",
 * JCGT 2(1), 2013; H. Edelsbrunner, E. Mücke, "Simulation of Simplicity", ACM TOG 9(1), 1990.
 */
#ifndef CSG_CLOSED_MESH_H
#define CSG_CLOSED_MESH_H

#include "../04_triangle/triangle.h"
#include "spans.h"

typedef struct { vec3 n; real h; } csg_plane;  /* n . p = h */
typedef struct {
    const triangle *tri;
    size_t n;
    const csg_plane *plane;  /* [n] in which each lies, its n is 0 where in none; or NULL */
} csg_closed;

/* ---------------------------------------------------------------------------------------------- */

static inline bool csg_closed_is_finite(csg_closed m)
{
    bool finite = m.n > 0;
    for (size_t i = 0; i < m.n && finite; i++)
        finite = vfinite(m.tri[i].a) && vfinite(m.tri[i].b) && vfinite(m.tri[i].c);
    return finite;
}

/* The sign of ax by - ay bx, whose rounded products are equal. Scaling each axis is exact. At 0 the
 * place is not (0,0) but (e, e^2):  a x b + (bx - ax) e^2 - (by - ay) e. */
__attribute__((noinline, cold))
static int csg_edge_in_doubt(vec3 a, vec3 b)
{
    int up;
    vec3 x = vscaled((vec3){a.x, b.x, 0}, &up), y = vscaled((vec3){a.y, b.y, 0}, &up);
    real area = difference_of_products(x.x, y.y, y.x, x.y);
    if (area != 0) return area > 0 ? 1 : -1;
    if (a.y != b.y) return b.y < a.y ? 1 : -1;
    return (b.x > a.x) - (b.x < a.x);
}

/* On which side of the line the edge a b passes: 1 or -1, and 0 only if a is b. */
static inline int csg_edge_side(vec3 a, vec3 b)
{
    real p = a.x * b.y, q = a.y * b.x;
    return p > q ? 1 : p < q ? -1 : csg_edge_in_doubt(a, b);
}

/* By t. Shell sort: in place, and quick for the few that there are. */
static inline void csg_sort(csg_crossing *x, size_t n)
{
    for (size_t gap = n / 2; gap > 0; gap = gap == 2 ? 1 : gap * 5 / 11)
        for (size_t i = gap; i < n; i++) {
            csg_crossing one = x[i];
            size_t j = i;
            for (; j >= gap && x[j - gap].t > one.t; j -= gap) x[j] = x[j - gap];
            x[j] = one;
        }
}

/* Sorted crossings, of which the odd surfaces lead out, become spans by (6.6). All at one t count
 * at once; of those that lead the right way the lowest number stands for them. */
static inline size_t csg_wind(csg_crossing *x, size_t n)
{
    size_t kept = 0;
    int depth = 0;
    for (size_t i = 0, next; i < n; i = next) {
        real t = x[i].t;
        bool before = depth > 0;
        for (next = i; next < n && x[next].t == t; next++) depth += x[next].surface % 2 ? -1 : 1;
        if ((depth > 0) == before) continue;
        uint32_t lowest = UINT32_MAX;
        for (size_t k = i; k < next; k++)
            if (x[k].surface % 2 == before && x[k].surface < lowest) lowest = x[k].surface;
        x[kept++] = (csg_crossing){t, lowest & ~(uint32_t)1};
    }
    if (kept % 2) x[kept] = (csg_crossing){real_infinity, x[kept - 1].surface};  /* not closed */
    return kept + kept % 2;
}

/* The corners in an order of their own, each with its edge: so two triangles with the same corners
 * round alike. A common change of sign of all edges is nothing to shear_meets. */
static inline void csg_in_order(vec3 v[3], real e[3])
{
    for (int k = 0; k < 3; k++) {
        int i = k == 1, j = i + 1;  /* 0 1, 1 2, 0 1 */
        bool before = v[i].x != v[j].x ? v[i].x < v[j].x
            : v[i].y != v[j].y ? v[i].y < v[j].y : v[i].z <= v[j].z;
        if (before) continue;
        vec3 p = v[i];
        real f = e[i];
        v[i] = v[j], v[j] = p, e[i] = e[j], e[j] = f;
    }
}

/* By (6.4), if the ray meets the plane at more than a degree. Else that may be noise, and counts
 * only if the place is in the box round the triangle; own, the triangle's t, is on it always. */
static inline real csg_plane_t(csg_plane g, const triangle *tri, ray r, real own)
{
    real along = vdot(g.n, r.d), t = (g.h - vdot(g.n, r.o)) / along;                 /* (6.4) */
    if (!isfinite(t)) return own;
    if (fabs(along) * 64 > vlength(g.n) * vlength(r.d)) return t;
    vec3 p = ray_at(r, t), lo = vmin(vmin(tri->a, tri->b), tri->c);
    vec3 hi = vmax(vmax(tri->a, tri->b), tri->c);
    real room = 16 * real_epsilon * (vlength(r.o) + fabs(t) * vlength(r.d));
    for (int k = 0; k < 3; k++)
        if (!(vaxis(p, k) >= vaxis(lo, k) - room && vaxis(p, k) <= vaxis(hi, k) + room)) return own;
    return t;
}

/* Where the line passes triangle i, whose corners and edges are these. False: beyond all reals. */
static inline bool csg_triangle_t(csg_closed m, size_t i, vec3 v[3], real e[3], const ray_shear *s,
                                  ray r, real *t)
{
    hit h;
    csg_in_order(v, e);
    if (!shear_meets(v[0], v[1], v[2], (vec3){e[0], e[1], e[2]}, s, r, &h)) return false;
    bool flat = m.plane && !vzero(m.plane[i].n);
    *t = flat ? csg_plane_t(m.plane[i], &m.tri[i], r, h.t) : h.t;
    return true;
}

static inline size_t csg_closed_crossings(csg_closed m, ray r, uint32_t first, csg_crossing *out)
{
    ray_shear s = shear_of(r);
    size_t n = 0;
    r.tmin = -real_infinity, r.tmax = real_infinity;
    for (size_t i = 0; i < m.n; i++) {
        vec3 a = shear_corner(&m.tri[i].a, &s), b = shear_corner(&m.tri[i].b, &s);
        vec3 c = shear_corner(&m.tri[i].c, &s);
        vec3 e = {c.x * b.y - c.y * b.x, a.x * c.y - a.y * c.x, b.x * a.y - b.y * a.x};
        if (signs_differ(e.x, e.y, e.z)) continue;
        int side = csg_edge_side(a, b);
        if (side == 0 || csg_edge_side(b, c) != side || csg_edge_side(c, a) != side) continue;
        real t;
        vec3 v[3] = {a, b, c};
        if (!csg_triangle_t(m, i, v, (real[3]){e.x, e.y, e.z}, &s, r, &t)) return 0;
        bool leads_in = (side > 0) == (s.sz < 0);  /* n . d has the sign of the area, times d's */
        out[n++] = (csg_crossing){t, 2 * (first + (uint32_t)i) + !leads_in};
    }
    csg_sort(out, n);
    return csg_wind(out, n);
}

#endif
