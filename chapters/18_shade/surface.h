/* surface.h: the point of a surface that a ray has hit, and how far off it may be.
 *
 *            ns n          p      on the surface as nearly as reals allow: put back on the shape
 *             \|             by its own equation, not left where o + t d ends
 *      --------p-------    n      unit normal of the shape, as the shape points it (geometric)
 *                          ns     unit normal for shading (着色法线); n itself if there is no other
 *                          error  p is at most so far from the surface (误差界), along n, if p is
 *                                 moved along n and rounded once more                       (18.5)
 *                          noise  the shape's own hit test sees its surface so far off      (18.6)
 *                          shape  index in the scene, no_shape if unknown
 *
 *   surface s = surface_of_shape(&shapes[h.shape], r, h);     a shape of a scene (07)
 *   surface s = surface_of_mesh(&m, h);                       a triangle of a mesh (07)
 *   surface s = surface_facing(s, d);                         n and ns turned against d
 *
 * How far o + t d is off: epsilon (|o| + |t d|) for the sum, and |d| times the error of t, whatever
 * that is. Put back on the shape, p forgets where the ray came from: what is left are the roundings
 * of the last steps, and they are bounded here, with eps = real_epsilon, |p| the largest component:
 *
 *   shape      p                     error                             noise (18.6)
 *   sphere     c + R unit(p - c)     4 eps R + 2 eps |p|               0: 03 decides exactly
 *   triangle   (18.9)                2 eps L + 2 eps |p|, L an edge    (4 + k/2) eps L
 *   polygon    p - n (n.(p - m))     4 eps L + 2 eps |p|, L radius     4 eps L
 *   cone       moved on to the side  4 eps H + 2 eps |p|, H extent     8 eps H
 *
 * On a triangle, p = a + u (b-a) + v (c-a) with 1-u-v, u, v >= margin (18.9): some eps away from
 * its edges. Where two walls of a room meet, a point on the edge lies on both. `leave` moves it off
 * one of them alone, and the other's test may then see it behind: the ray gets out at the edge.
 *
 * 2 eps |p|: two roundings of a sum, each off by eps/2 in each component, along n at most
 * sqrt(3) eps/2. The rest: unit() is right to 2.25 eps, products and edges to eps/2 each.
 *
 * Sources: C. Wächter, N. Binder, "A Fast and Robust Method for Avoiding Self-Intersection", Ray
 * Tracing Gems, 2019, ch. 6 (the barycentric point); M. Pharr, W. Jakob, G. Humphreys, "Physically
 * Based Rendering", 3rd ed., 2016, section 3.9.4 (reprojection, bounds).
 */
#ifndef SHADE_SURFACE_H
#define SHADE_SURFACE_H

#include "../07_mesh/scene.h"

typedef struct {
    vec3 p, n, ns;
    real error, noise;  /* >= 0, scene units */
    uint32_t shape;
} surface;

/* ---------------------------------------------------------------------------------------------- */

static inline real surface_reach(vec3 p)
{
    return real_max(real_max(fabs(p.x), fabs(p.y)), fabs(p.z));
}

/* k = L^2 / |e x f|: some 1 for a fat triangle, large for a needle; a NaN, of no area: 64. */
static inline real surface_needle(vec3 e, vec3 f, real LL)
{
    vec3 x = vcross(e, f);
    return real_min(LL / sqrt(vdot(x, x)), 64);
}

/* (18.9) The height over an edge is L / k or more, so p stays 16 eps L + 4 eps |a| away from it:
 * more than p is off and than the test of the wall behind is, if that is no larger. Of no area, or
 * far away: 1/8 of the height, where reals tell no more. */
static inline real surface_margin(vec3 a, real L, real k)
{
    real m = real_epsilon * k * (16 + 4 * surface_reach(a) / L);
    return m < (real)0.125 ? m : (real)0.125;
}

/* a + u e + v f, all three weights (18.9) at least m [<= 1/8]. */
fast_inline vec3 surface_inside(vec3 a, vec3 e, vec3 f, real m, real u, real v)
{
    u = real_max(u, m), v = real_max(v, m);
    real over = u + v - (1 - m);
    if (over > 0) {
        if (u > v) u -= over;
        else v -= over;
    }
    return vadd(a, vmadd(vscale(e, u), f, v));
}

/* (18.6) The test of 04 moves each corner by up to 3 eps of its distance from o, which lies on the
 * triangle: 3 eps L, wherever between the corners p is. Its weights are right to k eps, where k =
 * L^2 / |e x f|, some 1 for a fat triangle, large for a needle; beyond 64, 04 multiplies exactly. A
 * ray at angle theta to n meets the plane k eps L sin(theta) too early, k/2 eps L seen along n. The
 * rest of 4 is for normals of needles, which lean. */
static inline surface surface_on_triangle(triangle t, uint32_t index, real u, real v)
{
    vec3 e = vsub(t.b, t.a), f = vsub(t.c, t.a), n = triangle_normal(t);
    real LL = real_max(vdot(e, e), vdot(f, f)), L = sqrt(LL), k = surface_needle(e, f, LL);
    vec3 p = surface_inside(t.a, e, f, surface_margin(t.a, L, k), u, v);
    real error = real_epsilon * (2 * L + 2 * surface_reach(p));
    return (surface){p, n, n, error, real_epsilon * L * (4 + k / 2), index};
}

/* Field by field: what is copied as a whole right after it was written waits for all of it. */
fast_inline surface surface_copy(const surface *s)
{
    return (surface){{s->p.x, s->p.y, s->p.z}, {s->n.x, s->n.y, s->n.z},
                     {s->ns.x, s->ns.y, s->ns.z}, s->error, s->noise, s->shape};
}

static inline surface surface_of_mesh(const mesh *m, hit h)
{
    surface s = surface_on_triangle(mesh_triangle(m, h.shape), h.shape, h.u, h.v);
    if (m->n) s.ns = mesh_normal(m, h.shape, h.u, h.v);
    return s;
}

/* unit(p - c), inwards if R < 0. (p - c) / R has length 1 + x; one step of Newton's method for
 * 1/sqrt makes 1 - 3/2 x^2: less than rounding does, if the ray came from no farther away than some
 * 1e7 R (in float: 1000 R). No root stands in the way of what waits for n, then. */
fast_inline vec3 surface_sphere_normal(sphere b, vec3 p)
{
    const real near = real_is_float ? (real)0x1p-13 : (real)0x1p-27;
    vec3 n = vscale(vsub(p, b.c), 1 / b.r);
    real square = vdot(n, n);
    if (fabs(square - 1) < near) return vscale(n, (3 - square) / 2);
    return sphere_normal(b, p);  /* R = 0, a NaN, too */
}

fast_inline surface surface_on_sphere(sphere b, uint32_t index, vec3 p)
{
    vec3 n = surface_sphere_normal(b, p);
    p = vmadd(b.c, n, b.r);  /* sphere_point, which finds n on the way */
    real error = real_epsilon * (4 * fabs(b.r) + 2 * surface_reach(p));
    return (surface){p, n, n, error, 0, index};
}

static inline surface surface_on_cone(cone c, uint32_t index, vec3 p)
{
    p = cone_point(c, p);
    vec3 n = cone_normal(c, p);
    real H = vlength(vsub(c.b, c.a)) + fabs(c.ra) + fabs(c.rb);
    real error = real_epsilon * (4 * H + 2 * surface_reach(p));
    return (surface){p, n, n, error, 8 * real_epsilon * H, index};
}

/* Twice: the first step may have come from far away. */
static inline surface surface_on_polygon(polygon g, uint32_t index, vec3 p)
{
    real L = g.radius;
    vec3 n = g.normal;
    for (int k = 0; k < 2; k++) p = vmadd(p, n, -vdot(n, vsub(p, g.centre)));
    real error = real_epsilon * (4 * L + 2 * surface_reach(p));
    return (surface){p, n, n, error, 4 * real_epsilon * L, index};
}

/* What structure.h of 09 asks of every test; nothing is known to move p to. far: from the ray's
 * origin. */
static inline surface surface_on_other(const shape_other *s, hit h, vec3 p, real far)
{
    vec3 n = s->normal(s->self, h, p);
    real D = far + vlength(vsub(s->hi, s->lo));
    return (surface){p, n, n, real_epsilon * (256 * D + 2 * surface_reach(p)), 0, h.shape};
}

fast_inline surface surface_of_shape(const shape *s, ray r, hit h)
{
    vec3 p = ray_at(r, h.t);
    switch (s->kind) {
    case SHAPE_SPHERE: return surface_on_sphere(s->sphere, h.shape, p);
    case SHAPE_TRIANGLE: return surface_on_triangle(s->triangle, h.shape, h.u, h.v);
    case SHAPE_CONE: return surface_on_cone(s->cone, h.shape, p);
    case SHAPE_POLYGON: return surface_on_polygon(s->polygon, h.shape, p);
    case SHAPE_OTHER: return surface_on_other(s->other, h, p, vlength(vsub(p, r.o)));
    }
    return (surface){p, {0, 0, 0}, {0, 0, 0}, 0, 0, no_shape};
}

/* Seen from where the ray comes from: n.d <= 0. ns turns with n. */
static inline surface surface_facing(surface s, vec3 d)
{
    real turn = vdot(s.n, d) > 0 ? -1 : 1;  /* a factor, not a branch: it is a toss */
    s.n = vscale(s.n, turn), s.ns = vscale(s.ns, turn);
    return s;
}

#endif
