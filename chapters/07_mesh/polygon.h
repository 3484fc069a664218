/* polygon.h: a planar polygon (多边形) with any number of corners, concave ones too.
 *
 *       2______1         corners counter-clockwise seen from the tip of n; each edge joins a corner
 *        \    /   5      to the next, the last one to the first. Edges do not cross.
 *         \  /  .' |
 *          3 --4   |     polygon p = polygon_of(corners, count);  O(count), corners are not copied
 *         /        |     bool polygon_hit(p, r, &h)               O(count); h.u = h.v = 0
 *        6---------0     bool polygon_hit_sheared(p, &s, r, &h)   the same, the ray prepared once
 *
 * Seen along the ray the polygon is flat and the ray is the origin (0,0) of that picture (4.9).
 * Walk to the right along the x axis: a way out of the polygon crosses its edges an odd number of
 * times (奇偶规则).
 *
 * Closed: a ray through an edge or a corner hits. Watertight: of polygons and triangles of 04 that
 * share edges, corner for corner, at least one is hit by a ray through the seam. A corner of one
 * that lies within an edge of another (T-junction) is no shared edge: rays may slip there.
 * The point of a hit is near the polygon, also if that is seen edge-on or is a sliver:
 *
 *          32 epsilon D along each axis,   D = the largest |corner - o| along an axis     (7.15)
 *
 * Corners that are not quite in a plane: the plane through their mean with Newell's normal gives t
 * as long as the corners are near it, and (7.15) holds with 128; else two points of the edges do,
 * and the hit is between these. t always stays between the nearest and the farthest corner's.
 *
 *   fewer than three corners, no area, NaN or infinity anywhere, D = 0, exactly edge-on    no hit
 *
 * Sources: I. Sutherland, R. Sproull, R. Schumacker, "A Characterization of Ten Hidden-Surface
 * Algorithms", ACM Computing Surveys 6(1), 1974 (Newell's normal); E. Haines, "Point in Polygon
 * Strategies", Graphics Gems IV, 1994; S. Woop, C. Benthin, I. Wald, JCGT 2(1), 2013 (the shear).
 */
#ifndef MESH_POLYGON_H
#define MESH_POLYGON_H

#include "../04_triangle/triangle.h"

typedef struct {
    const vec3 *v;  /* [n] corners; they belong to the caller */
    uint32_t n;
    float trust;    /* seen less steeply, |n.d / dz| below this, the plane's depth is noise */
    vec3 normal;    /* unit, or 0 */
    vec3 centre;    /* mean of the corners */
    real radius;    /* of the farthest corner from there */
} polygon;

/* ---------------------------------------------------------------------------------------------- */

/* Newell's normal: sum of q_i x q_(i+1), twice the area long. It takes q from the first corner,
 * so that far from the origin no digits cancel, and scales q by a power of two, so that nothing
 * overflows. A cross product at one corner would point backwards where that corner is concave.
 *                                                                                        (7.8) */
static inline polygon polygon_of(const vec3 *v, size_t n)
{
    vec3 sum = {0, 0, 0}, offset = {0, 0, 0}, widest = {0, 0, 0};
    for (size_t i = 0; i < n; i++) {
        vec3 q = vsub(v[i], v[0]);
        offset = vmadd(offset, q, 1 / (real)n);
        widest = vmax(widest, vmax(q, vneg(q)));
    }
    int e;
    (void)vscaled(widest, &e);
    real scale = ldexp((real)1, -e);
    for (size_t i = 2; i < n; i++)
        sum = vadd(sum,
                   vcross(vscale(vsub(v[i - 1], v[0]), scale), vscale(vsub(v[i], v[0]), scale)));
    polygon p = {v, (uint32_t)n, 0, vunit(sum), n ? vadd(v[0], offset) : offset, 0};
    real off = 0, size = vaxis(widest, vlongest(widest));
    for (size_t i = 0; i < n; i++) {
        vec3 q = vsub(v[i], p.centre);
        off = real_max(fabs(vdot(p.normal, q)), off), p.radius = real_max(p.radius, vlength(q));
    }
    real steep = real_max(off / (32 * real_epsilon * size), (real)1 / 16);
    p.trust = steep < 2 ? (float)steep : INFINITY;
    return p;
}

/* All corners are within 2 epsilon of its size of the plane: as near as rounding leaves them. */
static inline bool polygon_is_flat(const polygon *p) { return p->trust <= (float)1 / 16; }

/* How edge a b lies to the origin, in the picture along the ray. */
typedef enum { EDGE_AWAY, EDGE_CROSSES, EDGE_TOUCHES } edge_side;

/* The sign of ax by - ay bx where the plain products are equal, too small or too large; NaN stays
 * one. Zero only if the origin is in line with a and b. */
static inline real edge_exactly(vec3 a, vec3 b)
{
    int e;
    vec3 p = vscaled((vec3){a.x, a.y, 0}, &e), q = vscaled((vec3){b.x, b.y, 0}, &e);
    return difference_of_products(p.x, q.y, p.y, q.x);
}

/* Crosses: meets the half axis y = 0, x > 0. One end must have y > 0 and the other y <= 0, so a
 * corner on the axis counts for one of its two edges if the polygon crosses there, for none or
 * both if not. Which side of the origin: the sign of e = ax by - ay bx (4.10), exactly the
 * negative for b a, so the neighbour that shares the edge finds the same. Touches: the origin
 * lies on the edge.                                                                      (7.9) */
static inline edge_side edge_of(vec3 a, vec3 b)
{
    bool up = b.y > 0;
    if ((a.y > 0) != up) {
        real e = a.x * b.y - a.y * b.x;
        if (!(fabs(e) > real_smallest / real_epsilon && fabs(e) <= real_largest))
            e = edge_exactly(a, b);
        return e == 0 ? EDGE_TOUCHES : (up ? e > 0 : e < 0) ? EDGE_CROSSES : EDGE_AWAY;
    }
    if (a.y != 0) return EDGE_AWAY;
    bool along = b.y == 0 && real_min(a.x, b.x) <= 0 && real_max(a.x, b.x) >= 0;
    return along || a.x == 0 ? EDGE_TOUCHES : EDGE_AWAY;
}

/* Where the line y = 0 of the picture enters and leaves the polygon, next to the origin. */
typedef struct { vec3 left, right; } polygon_walk;

/* Edge a b meets the line: nearer to the origin than what is kept? A weighted mean of a and b, so
 * it is on the edge. */
static inline void edge_nearest(vec3 a, vec3 b, polygon_walk *w)
{
    if ((a.y > 0) == (b.y > 0) && a.y != 0 && b.y != 0) return;
    real s = a.y == b.y ? a.x / (a.x - b.x) : a.y / (a.y - b.y);  /* all on the line: at x = 0 */
    s = real_clamp(s, 0, 1);
    vec3 p = {(1 - s) * a.x + s * b.x, 0, (1 - s) * a.z + s * b.z};
    if (p.x <= 0 && !(p.x < w->left.x)) w->left = p;
    if (p.x >= 0 && !(p.x > w->right.x)) w->right = p;
}

/* Depth where the plane's is noise: seen edge-on, of hardly any width, corners not in a plane. Walk
 * through the origin, along x or y, whichever the picture is narrower in. What is between the
 * edges met on the left and on the right belongs to the polygon, so does the point that divides
 * them as the origin does:
 *             z = ((xr) zl + (-xl) zr) / (xr - xl),   xl <= 0 <= xr                      (7.16)
 * If one of them is as near as rounding moves a corner, 3 epsilon D (18.6), it is taken itself. */
__attribute__((noinline, cold))
static real polygon_depth_in_doubt(polygon p, const ray_shear *s, real near, real far)
{
    polygon_walk x = {{-real_infinity, 0, near}, {real_infinity, 0, far}}, y = x;
    vec3 a = shear_corner(&p.v[p.n - 1], s), lo = a, hi = a;
    for (uint32_t i = 0; i < p.n; i++) {
        vec3 b = shear_corner(&p.v[i], s);
        edge_nearest(a, b, &x);
        edge_nearest((vec3){a.y, a.x, a.z}, (vec3){b.y, b.x, b.z}, &y);
        lo = vmin(lo, b), hi = vmax(hi, b);
        a = b;
    }
    polygon_walk w = hi.x - lo.x > hi.y - lo.y ? y : x;
    real blur = 4 * real_epsilon * real_max(fabs(near), fabs(far));
    vec3 nearer = -w.left.x < w.right.x ? w.left : w.right;
    if (!(fabs(nearer.x) > blur)) return nearer.z;
    real k = -w.left.x / (w.right.x - w.left.x);
    return k > 0 && k < 1 ? (1 - k) * w.left.z + k * w.right.z : nearer.z;
}

/* The same walk, edge by edge, where a plain sign says too little. */
__attribute__((noinline, cold))
static void polygon_in_doubt(polygon p, const ray_shear *s, bool *odd, bool *touched)
{
    vec3 a = shear_corner(&p.v[p.n - 1], s);
    *odd = false;
    for (uint32_t i = 0; i < p.n; i++) {
        vec3 b = shear_corner(&p.v[i], s);
        edge_side side = edge_of(a, b);
        *odd ^= side == EDGE_CROSSES, *touched |= side == EDGE_TOUCHES;
        a = b;
    }
}

/* Why nothing slips: each corner has one place in the picture, and each shared edge counts the
 * same for both its polygons. Summed over all polygons of a surface, the shared edges cancel,
 * modulo 2, and what is left is the crossings of the outer border: odd, if the ray passes within.
 * So an odd number of polygons, at least one, finds itself crossed an odd number of times,
 * whatever the rounding did. */
static inline bool polygon_hit_sheared(const polygon *p, const ray_shear *s, ray r, hit *out)
{
    if (p->n < 3) return false;
    bool odd = false, touched = false;
    const vec3 first = shear_corner(&p->v[0], s);
    vec3 a = first;
    real near = a.z, far = a.z, least = real_infinity, sum = 0;
    for (uint32_t i = 1; i <= p->n; i++) {
        vec3 b = i < p->n ? shear_corner(&p->v[i], s) : first;
        real e = a.x * b.y - a.y * b.x;  /* edge_of without a branch: each would be a coin toss */
        bool up = b.y > 0;
        odd ^= ((a.y > 0) != up) & ((e > 0) == up);
        least = real_min(fabs(e), least), sum += fabs(e);
        near = real_min(b.z, near), far = real_max(b.z, far);
        a = b;
    }
    if (!(least > real_smallest / real_epsilon && sum <= real_largest))  /* or it touches: e = 0 */
        polygon_in_doubt(*p, s, &odd, &touched);
    if ((!odd && !touched) || vzero(p->normal)) return false;

    /* Depth of the plane at (0,0): the shear takes the normal to (nx, ny, n.d / dz).      (7.10) */
    const real *n = (const real *)&p->normal;  /* vaxis copies the three */
    vec3 c = shear_corner(&p->centre, s);
    real nd = vdot(p->normal, r.d), steep = nd * s->sz;
    if (nd == 0 && !odd) return false;  /* edge-on: the ray may touch, but the neighbours are hit */
    real z = c.z + (n[s->kx] * c.x + n[s->ky] * c.y) / steep;
    if (!(fabs(steep) >= (real)p->trust)) z = polygon_depth_in_doubt(*p, s, near, far);
    real t = real_clamp(z, near, far) * s->sz;
    if (!ray_covers(r, t) || !(fabs(t) <= real_largest)) return false;
    *out = (hit){t, 0, 0, 0};
    return true;
}

static inline bool polygon_hit(polygon p, ray r, hit *out)
{
    ray_shear s = shear_of(r);
    return polygon_hit_sheared(&p, &s, r, out);
}

#endif
