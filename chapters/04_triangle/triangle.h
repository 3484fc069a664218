/* triangle.h: ray against triangle, three ways with one signature.
 *
 *             c                  u, v of a hit: the barycentric coordinates (重心坐标) of b and c,
 *            / \                 p = (1 - u - v) a + u b + v c                          (4.6)
 *           / p \
 *          a --- b               true if t is in the ray's interval; both sides count
 *
 *   triangle_hit_plane(tri, r, &h)             meets the plane, then three inside tests      (4.7)
 *   first_triangle_hit(tri, r, &h)             first.h: three unknowns by Cramer's rule      (4.8)
 *   triangle_hit(tri, r, &h)                   watertight (水密): for all later chapters   (4.10)
 *
 * The first two slip through a closed mesh when a ray is aimed at an edge or a vertex: the
 * neighbours of an edge round differently, and each says that the other one is hit. (In first.h
 * u, v and 1 - u - v come from differences with corner a; the neighbour has another a.)
 * triangle_hit never slips: of the triangles round the point where a ray passes through a closed
 * mesh at least one is hit.
 *
 * One ray against many triangles: prepare the ray once, then test; the answers are the same bits.
 *   ray_shear s = shear_of(r);                     tmin and tmax of r may change afterwards
 *   triangle_hit_sheared(tri, &s, r, &h)
 *   triangle_hit_corners(&a, &b, &c, &s, r, &h)    corners read where they lie: the fastest
 *   triangle_normal(tri)                           unit (b - a) x (c - a)
 *   triangle_at(tri, u, v)                         the point (4.6): within some epsilon of the
 *                                                  triangle, however far away the ray began
 *   triangle_weights(tri, p)                       w, u, v of p, or of its foot, as a vec3: the
 *                                                  signed areas opposite a, b, c over the whole
 *                                                  (4.11); of a triangle without area NaN. They sum
 *                                                  to 1 all over the plane, by the way they are
 *                                                  computed: p is inside if none is negative
 *
 *   input                                          answer
 *   no area: two or three corners the same, or     no hit, normal (0,0,0): what is hit has a normal
 *     all on a line (b - a parallel to c - a)
 *   seen edge-on                                   no hit if exactly so, but one of its neighbours
 *   NaN, infinity; direction 0, or so short that   no hit, never a NaN in a hit
 *     1 / d is infinite (5.6e-309 in double)
 *   tiny or huge (1e-300, 1e300 in double)         as any other: no epsilon anywhere
 *
 * u, v are in [0,1]; u + v <= 1 + 2 epsilon. t is a weighted mean of the depths of the corners.
 * Needs -ffp-contract=off: a contracted product breaks (4.10), and with it the seams.
 *
 * Sources: T. Möller, B. Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", JGT 2(1),
 * 1997; S. Woop, C. Benthin, I. Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013;
 * J. Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates",
 * Discrete & Computational Geometry 18, 1997; S. Marschner, P. Shirley, "Fundamentals of Computer
 * Graphics", 4th ed., 2015, 2.7 (weights).
 */
#ifndef TRIANGLE_H
#define TRIANGLE_H

#include "../../common/numbers/wide.h"
#include "plane.h"
#include <limits.h>
#include <stddef.h>

/* A ray, ready for (4.9): axis kz is the longest of d; o the origin in the order kx, ky, kz. */
typedef struct { int kx, ky, kz; vec3 o; real sx, sy, sz; } ray_shear;

/* ---------------------------------------------------------------------------------------------- */

/* x1 y2 - y1 x2 + x2 y3 - y2 x3 + x3 y1 - y3 x1, twice the area of a triangle in the plane. The sum
 * of its products is kept exactly, as numbers that do not overlap, the smallest first (Shewchuk's
 * expansions): the last of them that is not 0 has the sign of the whole. */
static inline double triangle_area_exactly(const double x[3], const double y[3])
{
    double sum[12], area = 0;
    int n = 0;
    for (int k = 0; k < 3; k++) {
        int next = (k + 1) % 3;
        wide p = wide_product(x[k], y[next]), m = wide_product(-y[k], x[next]);
        const double part[4] = {p.lo, p.hi, m.lo, m.hi};
        for (int j = 0; j < 4; j++) {
            wide s = {part[j], 0};
            for (int i = 0; i < n; i++) s = wide_sum(s.hi, sum[i]), sum[i] = s.lo;
            sum[n++] = s.hi;
        }
    }
    for (int i = 0; i < n; i++) area += sum[i];
    return area;
}

/* (b - a) x (c - a) = a x b + b x c + c x a from the corners as they are: no difference is rounded.
 * Scaled by some power of two, so that nothing overflows, and what underflows is 1e-290 of the
 * largest coordinate squared. */
__attribute__((noinline, cold))
static vec3 triangle_cross_exactly(vec3 a, vec3 b, vec3 c)
{
    const vec3 corner[3] = {a, b, c};
    double p[3][3], n[3];
    if (!vfinite(a) || !vfinite(b) || !vfinite(c)) return (vec3){0, 0, 0};
    int most = INT_MIN, e;
    for (int i = 0; i < 9; i++) {
        p[i / 3][i % 3] = (double)vaxis(corner[i % 3], i / 3);
        (void)frexp(p[i / 3][i % 3], &e);
        if (p[i / 3][i % 3] != 0 && e > most) most = e;
    }
    if (most == INT_MIN) return (vec3){0, 0, 0};
    for (int i = 0; i < 9; i++) p[i / 3][i % 3] = ldexp(p[i / 3][i % 3], -most);
    for (int i = 0; i < 3; i++) n[i] = triangle_area_exactly(p[(i + 1) % 3], p[(i + 2) % 3]);
    (void)frexp(fabs(n[0]) + fabs(n[1]) + fabs(n[2]), &e);  /* in float n could vanish */
    return vec(ldexp(n[0], -e), ldexp(n[1], -e), ldexp(n[2], -e));
}

/* (b - a) x (c - a), scaled by some power of two; 0 only if the corners are on a line. Rounding the
 * edges and the products turns it by up to 2 epsilon |e1| |e2| (3.5 roundings of at most half an
 * epsilon each): if it is not longer than twice that, or not safe, the corners decide exactly.
 * Needed for: b = (1,0,0), c = (0,1,0), a = (1e9,1e9,1e9) in float: both edges round to -a. */
static inline vec3 triangle_cross(vec3 a, vec3 b, vec3 c)
{
    vec3 e1 = vsub(b, a), e2 = vsub(c, a), n = vcross(e1, e2);
    real nn = vdot(n, n), e11 = vdot(e1, e1), e22 = vdot(e2, e2);
    bool safe = square_is_safe(nn) && square_is_safe(e11) && square_is_safe(e22);
    if (safe && nn > 16 * real_epsilon * real_epsilon * e11 * e22) return n;
    return triangle_cross_exactly(a, b, c);
}

static inline vec3 triangle_normal(triangle tri)
{
    return vunit(triangle_cross(tri.a, tri.b, tri.c));
}

/* a + u (b - a) + v (c - a) would miss b at u = 1 by a rounding; this form meets all corners. */
static inline vec3 triangle_at(triangle tri, real u, real v)
{
    return barycentric_mix(tri.a, tri.b, tri.c, u, v);
}

/* n . (edge x (p - corner)) for the edges opposite a, b, c, n = (b - a) x (c - a): n . n times the
 * weights. */
static inline vec3 triangle_areas(triangle tri, vec3 n, vec3 p)
{
    return (vec3){vdot(n, vcross(vsub(tri.c, tri.b), vsub(p, tri.b))),
                  vdot(n, vcross(vsub(tri.a, tri.c), vsub(p, tri.c))),
                  vdot(n, vcross(vsub(tri.b, tri.a), vsub(p, tri.a)))};
}

static inline vec3 triangle_weights(triangle tri, vec3 p)
{
    vec3 n = plane_through(tri.a, tri.b, tri.c).n, area = triangle_areas(tri, n, p);
    real whole = vdot(n, n);
    return (vec3){area.x / whole, area.y / whole, area.z / whole};
}

/* Plane, then inside: p is left of each edge as seen from the tip of n, so the three signed areas
 * are not negative (4.7). Slips: p is rounded, so it lies off the plane, and each triangle computes
 * its own p. */
static inline bool triangle_hit_plane(triangle tri, ray r, hit *out)
{
    plane s = plane_through(tri.a, tri.b, tri.c);
    hit h;
    if (!plane_hit(s, r, &h)) return false;
    vec3 k = triangle_areas(tri, s.n, ray_at(r, h.t));
    if (!(real_min(real_min(k.x, k.y), k.z) >= 0)) return false;  /* one branch: see signs_differ */
    *out = (hit){h.t, k.y / vdot(s.n, s.n), k.z / vdot(s.n, s.n), 0};
    return true;
}

/* ---------------------------------------------------------------------------------------------- */

/* Seen along the ray: the shear x - (dx/dz) z, y - (dy/dz) z takes the ray to the z axis (4.9). kz
 * is the longest axis, so neither slope exceeds 1. */
static inline ray_shear shear_along(const ray *r, int kz)
{
    static const uint8_t next[5] = {0, 1, 2, 0, 1};  /* which is longest is chance: no branch */
    int kx = next[kz + 1], ky = next[kz + 2];
    const real *o = (const real *)&r->o, *d = (const real *)&r->d;  /* vaxis copies the three */
    vec3 from = {o[kx], o[ky], o[kz]};
    return (ray_shear){kx, ky, kz, from, d[kx] / d[kz], d[ky] / d[kz], 1 / d[kz]};
}

/* A direction 0, infinite or NaN makes NaN. */
static inline ray_shear shear_of(ray r)
{
    ray_shear s = shear_along(&r, vlongest(r.d));
    if (!vfinite(r.d)) s.sx = s.sy = s.sz = (real)NAN;
    return s;
}

/* A corner in the frame of the ray. It depends on the corner and the ray alone, so all triangles
 * that share the corner see it at the same place, to the last bit. */
fast_inline vec3 shear_corner(const vec3 *corner, const ray_shear *s)
{
    const real *p = (const real *)corner;
    real z = p[s->kz] - s->o.z;
    return (vec3){p[s->kx] - s->o.x - s->sx * z, p[s->ky] - s->o.y - s->sy * z, z};
}

/* No branch for each sign: whether a ray passes left or right of an edge is a coin toss, and a
 * branch on it costs more than the whole test (see the table of the README). */
static inline bool signs_differ(real x, real y, real z)
{
    return real_min(real_min(x, y), z) < 0 && real_max(real_max(x, y), z) > 0;
}

/* How often this thread computed edge functions a second time: for whoever wants to count. */
static _Thread_local size_t triangle_doubts;

/* The edge functions of a, b, c with their exact signs: each axis is scaled by its own power of
 * two, so that nothing over- or underflows, and the rounding of the products is given back. All
 * three change by one factor, which t does not see. Zero only if two corners and the ray are
 * exactly in line. False if a coordinate is infinite or NaN, or if all are zero. */
__attribute__((noinline, cold))
static bool edges_exactly(vec3 a, vec3 b, vec3 c, vec3 *e)
{
    vec3 x = {a.x, b.x, c.x}, y = {a.y, b.y, c.y};
    int up;
    triangle_doubts++;
    if (!vfinite(x) || !vfinite(y)) return false;
    x = vscaled(x, &up), y = vscaled(y, &up);
    e->x = difference_of_products(x.z, y.y, y.z, x.y);
    e->y = difference_of_products(x.x, y.z, y.x, x.z);
    e->z = difference_of_products(x.y, y.x, y.y, x.x);
    return e->x + e->y + e->z != 0 && !signs_differ(e->x, e->y, e->z);
}

/* The second half of the test, for the few triangles that pass the first: distance and interval. In
 * space the triangle has area: triangle_hit_corners asks that, too. */
fast_inline bool shear_meets(vec3 a, vec3 b, vec3 c, vec3 e, const ray_shear *s, ray r, hit *out)
{
    real det = e.x + e.y + e.z, size = fabs(det);
    real products = fabs(a.x * c.y) + fabs(b.x * a.y) + fabs(c.x * b.y);
    bool doubtful = !(size > products / 64)  /* seen edge-on: signs and weights lose their digits */
        || !(size > real_smallest / real_epsilon && size <= real_largest);
    if (doubtful) {  /* rare */
        vec3 exact;  /* e itself, its address given away, would be written and read for every ray */
        if (!edges_exactly(a, b, c, &exact)) return false;
        e = exact;
        det = e.x + e.y + e.z;
    }
    real w = e.x / det, u = e.y / det, v = e.z / det;
    real t = (w * a.z + u * b.z + v * c.z) * s->sz;  /* weights in [0,1]: cannot overflow */
    if (!ray_covers(r, t) || !(fabs(t) <= real_largest)) return false;
    *out = (hit){t, u, v, 0};
    return true;
}

/* The ray is now the z axis and passes inside if the origin (0,0) lies on the same side of all
 * three edges. Edge a b has the function ax by - ay bx (4.10): twice the area of (0,0) a b.
 *
 * Why no ray slips between triangles:
 * 1. The neighbour computes bx ay - by ax: the same two rounded products, so exactly the negative.
 * 2. If ax by >= ay bx, the rounded products are in the same order. So a computed sign may be 0 but
 *    is never wrong, and 0 counts as inside: every triangle whose image contains (0,0) passes.
 * 3. The images are a mesh with exactly shared corners. If it covers (0,0), one of them
 *    has area and contains (0,0), edges included. Only a determinant of 0, three zeros, refuses
 *    that one; then exact signs decide, and those of a triangle with area are not all 0.
 *
 * What has no area in space is refused last. Its image may have some, by rounding: a mesh that is
 * sealed with triangles of three different corners on a line can leak at these, and only there.
 * (Inlined: a call would copy the ray, and take twice as long.)
 */
fast_inline bool shear_passes(vec3 a, vec3 b, vec3 c, const ray_shear *s, ray r, hit *out)
{
    vec3 e = {c.x * b.y - c.y * b.x, a.x * c.y - a.y * c.x, b.x * a.y - b.y * a.x};
    return !signs_differ(e.x, e.y, e.z) && shear_meets(a, b, c, e, s, r, out);
}

fast_inline bool triangle_hit_corners(const vec3 *pa, const vec3 *pb, const vec3 *pc,
                                      const ray_shear *s, ray r, hit *out)
{
    vec3 a = shear_corner(pa, s), b = shear_corner(pb, s), c = shear_corner(pc, s);
    hit h;
    if (!shear_passes(a, b, c, s, r, &h) || vzero(triangle_cross(*pa, *pb, *pc))) return false;
    *out = h;
    return true;
}

static inline bool triangle_hit_sheared(triangle tri, const ray_shear *s, ray r, hit *out)
{
    return triangle_hit_corners(&tri.a, &tri.b, &tri.c, s, r, out);
}

static inline bool triangle_hit(triangle tri, ray r, hit *out)
{
    ray_shear s = shear_of(r);
    return triangle_hit_corners(&tri.a, &tri.b, &tri.c, &s, r, out);
}

#endif
