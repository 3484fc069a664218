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
 * spans and the ray's interval overlap (09 has all about boxes). An open side is at infinity. A NaN
 * (0 times infinity, a ray within a side) narrows nothing.
 *
 * A solid rounds, too: from afar it reports crossings beside itself, and those must not be lost,
 * or bounds would change the picture. So sides are moved outwards by
 *
 *      2048 epsilon (S + |o|),    S, |o|: the largest coordinate of the sides; of the origin  (6.8)
 *
 * (6.4) puts a point off its plane by 4 epsilon |o| and 3/2 epsilon |p| at most (lengths: sqrt(3)
 * times S). The three planes of a box make 12 times that of it, if |det| is a quarter of the
 * product of their normals' lengths, and 350 epsilon S for the rounding of lo and hi themselves;
 * more askew boxes have no bound. A mesh may miss such a plane by 8 epsilon (sqrt(3) S + |h|)
 * more (6.7), and a ray runs along it for 64 times all that: 1940 epsilon S and 443 epsilon |o|.
 */
#ifndef CSG_BOUND_H
#define CSG_BOUND_H

#include "solid.h"

typedef struct { vec3 lo, hi; } csg_bound;
typedef struct { vec3 o, inverse; real tmin, tmax, room; } csg_line;

#define csg_no_end ((vec3){real_infinity, real_infinity, real_infinity})
#define csg_bound_all ((csg_bound){vneg(csg_no_end), csg_no_end})
#define csg_bound_nothing ((csg_bound){csg_no_end, vneg(csg_no_end)})

/* ---------------------------------------------------------------------------------------------- */

#define csg_rounding (2048 * real_epsilon)  /* (6.8) */

/* Corners of a box are where three planes meet: p = sum of h[k] (n[i] x n[j]) / det, by Cramer's
 * rule; along each axis every h[k] that is the lesser, or the greater, adds its own. */
static inline csg_bound csg_bound_of_box(const csg_solid *s)
{
    csg_bound b = {{0, 0, 0}, {0, 0, 0}};
    const vec3 *n = s->box.n;
    real det = vdot(n[0], vcross(n[1], n[2]));
    for (int i = 0; i < 3; i++) {
        vec3 c = vscale(vcross(n[(i + 1) % 3], n[(i + 2) % 3]), 1 / det);
        vec3 x = vscale(c, s->box.lo[i]), y = vscale(c, s->box.hi[i]);
        b.lo = vadd(b.lo, vmin(x, y)), b.hi = vadd(b.hi, vmax(x, y));
    }
    bool askew = !(fabs(det) > vlength(n[0]) * vlength(n[1]) * vlength(n[2]) / 4);
    return askew || !vfinite(b.lo) || !vfinite(b.hi) ? csg_bound_all : b;
}

static inline csg_bound csg_bound_of_mesh(csg_closed m)
{
    csg_bound b = csg_bound_nothing;
    for (size_t i = 0; i < m.n; i++) {
        const triangle t = m.tri[i];
        b.lo = vmin(b.lo, vmin(t.a, vmin(t.b, t.c)));
        b.hi = vmax(b.hi, vmax(t.a, vmax(t.b, t.c)));
    }
    return b;
}

/* A half space has one side if it stands across an axis, a cylinder four if it runs along one. */
static inline csg_bound csg_bound_exact(const csg_solid *s)
{
    if (s->kind == CSG_BOX) return csg_bound_of_box(s);
    if (s->kind == CSG_MESH) return csg_bound_of_mesh(s->mesh);
    csg_bound b = csg_bound_all;
    bool half = s->kind == CSG_HALF, ball = s->kind == CSG_SPHERE;
    vec3 v = half ? s->box.n[0] : ball ? (vec3){0, 0, 0} : s->cylinder.a;
    vec3 c = ball ? s->ball.c : s->cylinder.p;
    real r = fabs(ball ? s->ball.r : s->cylinder.r);
    int across = (v.x == 0) + (v.y == 0) + (v.z == 0);
    for (int k = 0; k < 3 && across >= 2; k++) {
        real n = vaxis(v, k), h = s->box.hi[0] / n, at = vaxis(c, k);
        if (half && n > 0) b.hi = vwith(b.hi, k, h);
        if (half && n < 0) b.lo = vwith(b.lo, k, h);
        if (!half && n == 0) b.lo = vwith(b.lo, k, at - r), b.hi = vwith(b.hi, k, at + r);
    }
    return b;
}

static inline csg_bound csg_bound_of(const csg_solid *s)
{
    if (!csg_solid_is_some(s)) return csg_bound_nothing;
    csg_bound b = csg_bound_exact(s);
    real room = 0;
    for (int k = 0; k < 3; k++) {
        real lo = fabs(vaxis(b.lo, k)), hi = fabs(vaxis(b.hi, k));
        room = real_max(real_max(room, lo < real_infinity ? lo : 0), hi < real_infinity ? hi : 0);
    }
    vec3 more = vscale(vec(1, 1, 1), csg_rounding * room);
    return (csg_bound){vsub(b.lo, more), vadd(b.hi, more)};
}

static inline csg_bound csg_bound_joined(csg_operation what, csg_bound a, csg_bound b)
{
    if (what == CSG_UNION) return (csg_bound){vmin(a.lo, b.lo), vmax(a.hi, b.hi)};
    if (what == CSG_DIFFERENCE) return a;
    csg_bound both = {vmax(a.lo, b.lo), vmin(a.hi, b.hi)};
    bool any = both.lo.x <= both.hi.x && both.lo.y <= both.hi.y && both.lo.z <= both.hi.z;
    return any ? both : csg_bound_nothing;
}

static inline csg_line csg_line_of(ray r)
{
    return (csg_line){r.o, {1 / r.d.x, 1 / r.d.y, 1 / r.d.z}, r.tmin, r.tmax,
                      csg_rounding * vlargest(r.o)};
}

static inline bool csg_bound_meets(const csg_bound *b, const csg_line *x)
{
    real enter = x->tmin, leave = x->tmax;
    for (int k = 0; k < 3; k++) {
        real inverse = vaxis(x->inverse, k), o = vaxis(x->o, k);
        real lo = vaxis(b->lo, k) - x->room - o, hi = vaxis(b->hi, k) + x->room - o;
        bool back = signbit(inverse);
        real t0 = (back ? hi : lo) * inverse, t1 = (back ? lo : hi) * inverse;
        if (t0 > enter) enter = t0;
        if (t1 < leave) leave = t1;
    }
    return enter <= leave;
}

#endif
