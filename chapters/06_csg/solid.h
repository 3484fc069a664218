/* solid.h: five solids, and where a line crosses the surface of each: the leaves of a tree.
 *
 *   solid                                    points                       surfaces
 *   csg_sphere(c, r)                         |p - c| <= |r|               0
 *   csg_half(n, h)                           n . p <= h                   1     half space (半空间)
 *   csg_box(lo, hi)                          lo <= p <= hi, each axis     0 to 5: x lo, x hi, y lo
 *   csg_box_turned(n, lo, hi)                lo[k] <= n[k] . p <= hi[k]   the same
 *   csg_cylinder(p, a, r)                    within |r| of the line       0     cylinder (圆柱)
 *   csg_mesh(triangles, n)                   inside: closed_mesh.h        that of the triangle
 *
 *   n = csg_solid_crossings(&s, r, first, out)      of the whole line, as in spans.h; surface k of
 *                                                   this solid has the number first + k
 *   csg_solid_surfaces(&s)   how many it has; a mesh of n triangles crosses a line in n + 2 places
 *                            at most, all others in 2
 *   csg_solid_normal(&s, k, p)                      unit, outwards, of surface k near p
 *
 * A face is a plane n . p = h. All faces find their t by one expression:
 *
 *      t = (h - n . o) / (n . d)                                                       (6.4)
 *
 * so one plane gives one t, to the last bit, whatever it bounds: with -n, -h the same, with 2 n,
 * 2 h; for a plane across an axis the other components add 0. That, and spans_merge, is why faces
 * that coincide don't speckle. It takes the same numbers n, h: a plane that was computed twice, in
 * two ways, is two planes. Faces of meshes: coplanar.h.
 *
 *   input                                                    answer
 *   a NaN or an infinity; r = 0; n = 0; lo >= hi; a = 0      the empty set: nothing is crossed
 *   tangent line: both crossings at one t                    no crossing
 *   line in a face                                           in the solid: faces belong to it
 *   line along the cylinder, within it                       one span, from -inf to inf
 *
 * Needs a ray whose o and d are finite, d not 0; any length.
 */
#ifndef CSG_SOLID_H
#define CSG_SOLID_H

#include "../03_sphere/sphere.h"
#include "closed_mesh.h"

typedef enum { CSG_SPHERE, CSG_HALF, CSG_BOX, CSG_CYLINDER, CSG_MESH } csg_kind;
typedef struct {
    csg_kind kind;
    union {
        sphere ball;
        struct { vec3 n[3]; real lo[3], hi[3]; } box;  /* a half space: n[0], and hi[0] for h */
        struct { vec3 p, a; real r; } cylinder;
        csg_closed mesh;
    };
} csg_solid;

/* ---------------------------------------------------------------------------------------------- */

static inline csg_solid csg_sphere(vec3 c, real r)
{
    return (csg_solid){.kind = CSG_SPHERE, .ball = {c, r}};
}

static inline csg_solid csg_half(vec3 n, real h)
{
    const real far = real_infinity;
    return (csg_solid){.kind = CSG_HALF, .box = {{n}, {-far, -far, -far}, {h, far, far}}};
}

static inline csg_solid csg_box_turned(const vec3 n[3], const real lo[3], const real hi[3])
{
    return (csg_solid){.kind = CSG_BOX, .box = {{n[0], n[1], n[2]}, {lo[0], lo[1], lo[2]},
                                                {hi[0], hi[1], hi[2]}}};
}

static inline csg_solid csg_box(vec3 lo, vec3 hi)
{
    return (csg_solid){.kind = CSG_BOX, .box = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                                {lo.x, lo.y, lo.z}, {hi.x, hi.y, hi.z}}};
}

/* The axis, of any length, is brought to some 1 by a power of two, so that no square overflows. */
static inline csg_solid csg_cylinder(vec3 p, vec3 a, real r)
{
    int up;
    if (vfinite(a)) a = vscaled(a, &up);
    return (csg_solid){.kind = CSG_CYLINDER, .cylinder = {p, a, r}};
}

static inline csg_solid csg_mesh(const triangle *tri, size_t n)
{
    return (csg_solid){.kind = CSG_MESH, .mesh = {tri, n, NULL}};
}

static inline size_t csg_solid_surfaces(const csg_solid *s)
{
    return s->kind == CSG_MESH ? s->mesh.n : s->kind == CSG_BOX ? 6 : s->kind == CSG_HALF ? 2 : 1;
}

/* Whether it holds any point: to be asked once, not for each ray. O(triangles). */
static inline bool csg_solid_is_some(const csg_solid *s)
{
    bool some = true;
    if (s->kind == CSG_SPHERE) return vfinite(s->ball.c) && isfinite(s->ball.r) && s->ball.r != 0;
    if (s->kind == CSG_MESH) return csg_closed_is_finite(s->mesh);
    if (s->kind == CSG_CYLINDER)
        return vfinite(s->cylinder.p) && vfinite(s->cylinder.a) && !vzero(s->cylinder.a)
            && isfinite(s->cylinder.r) && s->cylinder.r != 0;
    for (int k = 0; k < (s->kind == CSG_BOX ? 3 : 1); k++) {
        real lo = s->box.lo[k], hi = s->box.hi[k];
        some = some && vfinite(s->box.n[k]) && !vzero(s->box.n[k]) && isfinite(hi);
        if (s->kind == CSG_BOX) some = some && isfinite(lo) && lo < hi;
    }
    return some;
}

/* The span between two crossings, if there is anything between them. A NaN: nothing. */
static inline size_t csg_span(real t0, uint32_t in, real t1, uint32_t out, csg_crossing *to)
{
    if (!(t0 < t1)) return 0;
    to[0] = (csg_crossing){t0, 2 * in}, to[1] = (csg_crossing){t1, 2 * out};
    return 2;
}

/* Six half spaces, two by two, as opposite ones share n . o and n . d. Of one half space the other
 * five hold everything: n = 0, or h is infinite. */
static inline size_t csg_box_crossings(const csg_solid *s, ray r, uint32_t first, csg_crossing *out)
{
    real enter = -real_infinity, leave = real_infinity;
    uint32_t in = first, from = first;
    for (uint32_t k = 0; k < 3; k++) {
        real along = vdot(s->box.n[k], r.d), at = vdot(s->box.n[k], r.o);
        real lo = s->box.lo[k], hi = s->box.hi[k];
        if (along == 0) {
            if (!(at >= lo && at <= hi)) return 0;
            continue;
        }
        bool back = along < 0;
        real t0 = ((back ? hi : lo) - at) / along, t1 = ((back ? lo : hi) - at) / along; /* (6.4) */
        if (!(t0 <= enter)) enter = t0, in = first + 2 * k + back;      /* a NaN stays, and */
        if (!(t1 >= leave)) leave = t1, from = first + 2 * k + !back;   /* csg_span refuses it */
    }
    return csg_span(enter, in, leave, from, out);
}

/* With x = d x a, y = (o - p) x a the distance from the axis is |y + t x| / |a|:
 *
 *      |x|^2 t^2 + 2 x.y t + |y|^2 - r^2 |a|^2 = 0                                     (6.5)
 *
 * Its discriminant, by Lagrange's identity, is |a|^2 (r^2 |x|^2 - q^2), q = a . (d x (o - p)): as
 * for the sphere (3.5), nothing huge cancels. In double whatever real is. */
static inline size_t csg_cylinder_crossings(const csg_solid *s, ray r, uint32_t first,
                                            csg_crossing *out)
{
    vec3 axis = s->cylinder.a;
    double a[3] = {(double)axis.x, (double)axis.y, (double)axis.z}, f[3], d[3], x[3], y[3];
    double aa = a[0] * a[0] + a[1] * a[1] + a[2] * a[2], R = (double)s->cylinder.r;
    double xx = 0, xy = 0, yy = 0, q = 0;
    for (int k = 0; k < 3; k++) {
        f[k] = (double)vaxis(r.o, k) - (double)vaxis(s->cylinder.p, k);
        d[k] = (double)vaxis(r.d, k);
    }
    for (int k = 0; k < 3; k++) {
        int i = (k + 1) % 3, j = (k + 2) % 3;
        x[k] = d[i] * a[j] - d[j] * a[i], y[k] = f[i] * a[j] - f[j] * a[i];
        xx += x[k] * x[k], xy += x[k] * y[k], yy += y[k] * y[k];
        q += a[k] * (d[i] * f[j] - d[j] * f[i]);
    }
    if (xx == 0)  /* along the axis */
        return yy <= R * R * aa ? csg_span(-real_infinity, first, real_infinity, first, out) : 0;
    double D = R * R * xx - q * q;
    if (!(D > 0)) return 0;
    double half = sqrt(aa * D);
    return csg_span((real)((-xy - half) / xx), first, (real)((-xy + half) / xx), first, out);
}

static inline size_t csg_solid_crossings(const csg_solid *s, ray r, uint32_t first,
                                         csg_crossing *out)
{
    real t0, t1;
    switch (s->kind) {
    case CSG_SPHERE:
        return sphere_roots(s->ball, r, &t0, &t1) ? csg_span(t0, first, t1, first, out) : 0;
    case CSG_HALF: case CSG_BOX: return csg_box_crossings(s, r, first, out);
    case CSG_CYLINDER: return csg_cylinder_crossings(s, r, first, out);
    case CSG_MESH: return csg_closed_crossings(s->mesh, r, first, out);
    }
    return 0;
}

static inline vec3 csg_solid_normal(const csg_solid *s, size_t face, vec3 p)
{
    if (s->kind == CSG_MESH) return triangle_normal(s->mesh.tri[face]);
    if (s->kind == CSG_BOX || s->kind == CSG_HALF)
        return vscale(vunit(s->box.n[face / 2]), face % 2 ? (real)1 : (real)-1);
    if (s->kind == CSG_SPHERE) return sphere_normal((sphere){s->ball.c, fabs(s->ball.r)}, p);
    vec3 from = vsub(p, s->cylinder.p), a = vunit(s->cylinder.a);
    return vunit(vmadd(from, a, -vdot(from, a)));
}

#endif
