/* bound.h: a box around a solid, and around what a tree makes of several; some sides may be open.
 *
 *   csg_bound b = csg_bound_of(&s);              every point of the solid is in it
 *   csg_bound_joined(CSG_UNION, a, b)            union: around both; intersection: what the two
 *                                                share, or nothing; difference: the left one
 *   csg_line x = csg_line_of(r);                 once for a ray
 *   if (!csg_bound_meets(&b, &x)) ...            then no crossing of it lies in [tmin, tmax], and
 *                                                no span reaches into it
 *
 * Along each axis the ray is between lo and hi for a span of t, and the box is where the three
 * spans and the ray's interval overlap (09 has all about boxes). An open side is at infinity. Both
 * ends of a span are moved outwards by 16 epsilon, and so are lo and hi when they are made: what is
 * left out is left out for certain. A NaN (0 times infinity, a ray within a side) narrows nothing.
 */
#ifndef CSG_BOUND_H
#define CSG_BOUND_H

#include "solid.h"

typedef struct { vec3 lo, hi; } csg_bound;
typedef struct { vec3 o, inverse; real tmin, tmax; } csg_line;

/* ---------------------------------------------------------------------------------------------- */

static inline csg_bound csg_bound_nothing(void)
{
    const real inf = real_infinity;
    return (csg_bound){{inf, inf, inf}, {-inf, -inf, -inf}};
}

/* lo and hi along axis k, with room for rounding errors of things as large as `size`. */
static inline void csg_bound_side(csg_bound *b, int k, real lo, real hi, real size)
{
    real room = 16 * real_epsilon * size;
    b->lo = vwith(b->lo, k, lo - room), b->hi = vwith(b->hi, k, hi + room);
}

/* Corners of a box are where three planes meet: p = sum of h[k] (n[i] x n[j]) / det, by Cramer's
 * rule; along each axis every h[k] that is the lesser, or the greater, adds its own. */
static inline csg_bound csg_bound_of_box(const csg_solid *s)
{
    csg_bound b;
    const vec3 *n = s->box.n;
    real det = vdot(n[0], vcross(n[1], n[2]));
    for (int k = 0; k < 3; k++) {
        real lo = 0, hi = 0, size = 0;
        for (int i = 0; i < 3; i++) {
            real c = vaxis(vcross(n[(i + 1) % 3], n[(i + 2) % 3]), k) / det;
            real x = c * s->box.lo[i], y = c * s->box.hi[i];
            lo += real_min(x, y), hi += real_max(x, y), size += fabs(x) + fabs(y);
        }
        bool flat = !(fabs(det) > (real)0.01 && size < real_largest);  /* askew: rather no bound */
        csg_bound_side(&b, k, flat ? -real_infinity : lo, flat ? real_infinity : hi,
                       flat ? 0 : size);
    }
    return b;
}

static inline csg_bound csg_bound_of_mesh(csg_closed m)
{
    csg_bound b = csg_bound_nothing();
    for (size_t i = 0; i < m.n; i++) {
        const triangle t = m.tri[i];
        b.lo = vmin(b.lo, vmin(t.a, vmin(t.b, t.c)));
        b.hi = vmax(b.hi, vmax(t.a, vmax(t.b, t.c)));
    }
    for (int k = 0; k < 3; k++) {
        real lo = vaxis(b.lo, k), hi = vaxis(b.hi, k);
        csg_bound_side(&b, k, lo, hi, real_max(fabs(lo), fabs(hi)));
    }
    return b;
}

/* A half space has one side if it stands across an axis, a cylinder four if it runs along one. */
static inline csg_bound csg_bound_of(const csg_solid *s)
{
    if (!csg_solid_is_some(s)) return csg_bound_nothing();
    if (s->kind == CSG_BOX) return csg_bound_of_box(s);
    if (s->kind == CSG_MESH) return csg_bound_of_mesh(s->mesh);
    csg_bound b;
    bool half = s->kind == CSG_HALF, ball = s->kind == CSG_SPHERE;
    vec3 v = half ? s->box.n[0] : ball ? (vec3){0, 0, 0} : s->cylinder.a;
    vec3 c = ball ? s->ball.c : s->cylinder.p;
    real r = fabs(ball ? s->ball.r : s->cylinder.r);
    for (int k = 0; k < 3; k++) {
        real at = vaxis(c, k), lo = -real_infinity, hi = real_infinity, size = 0;
        if (half && fabs(vaxis(v, k)) == vlength(v) && vaxis(v, k) != 0) {
            real h = s->box.hi[0] / vaxis(v, k);
            size = fabs(h);
            if (vaxis(v, k) > 0) hi = h;
            else lo = h;
        }
        if (!half && vaxis(v, k) == 0) lo = at - r, hi = at + r, size = fabs(at) + r;
        csg_bound_side(&b, k, lo, hi, size);
    }
    return b;
}

static inline csg_bound csg_bound_joined(csg_operation what, csg_bound a, csg_bound b)
{
    if (what == CSG_UNION) return (csg_bound){vmin(a.lo, b.lo), vmax(a.hi, b.hi)};
    if (what == CSG_DIFFERENCE) return a;
    csg_bound both = {vmax(a.lo, b.lo), vmin(a.hi, b.hi)};
    bool any = both.lo.x <= both.hi.x && both.lo.y <= both.hi.y && both.lo.z <= both.hi.z;
    return any ? both : csg_bound_nothing();
}

static inline csg_line csg_line_of(ray r)
{
    return (csg_line){r.o, {1 / r.d.x, 1 / r.d.y, 1 / r.d.z}, r.tmin, r.tmax};
}

static inline bool csg_bound_meets(const csg_bound *b, const csg_line *x)
{
    const real less = 1 - 16 * real_epsilon, more = 1 + 16 * real_epsilon;
    real enter = x->tmin, leave = x->tmax;
    for (int k = 0; k < 3; k++) {
        real inverse = vaxis(x->inverse, k), o = vaxis(x->o, k);
        bool back = signbit(inverse);
        real t0 = ((back ? vaxis(b->hi, k) : vaxis(b->lo, k)) - o) * inverse;
        real t1 = ((back ? vaxis(b->lo, k) : vaxis(b->hi, k)) - o) * inverse;
        t0 *= t0 > 0 ? less : more, t1 *= t1 > 0 ? more : less;
        if (t0 > enter) enter = t0;
        if (t1 < leave) leave = t1;
    }
    return enter <= leave;
}

#endif
