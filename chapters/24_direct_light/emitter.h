/* emitter.h: something that shines, and how to draw a point of it as p sees it.
 *
 *        n_x   .-x-.  light        by area:    x uniform on the light, 1 / A per area;
 *          \  /    |               as p sees it: d omega = cos_x dA / |x - p|^2            (24.3)
 *           x      |                           pdf = |x - p|^2 / (A cos_x)      [1/sr]     (24.4)
 *          /.'                     by angle:   uniform in the solid angle omega seen from p:
 *     p --'  wi                                pdf = 1 / omega                  [1/sr]     (24.5)
 *
 *   emitter e = emitter_of_triangle(t, Le);     shines where (b - a) x (c - a) points
 *   emitter e = emitter_of_rectangle(r, Le);    where s x t points
 *   emitter e = emitter_of_sphere(s, Le);       outwards; inwards if s.r < 0
 *       Le: radiance of the front [W/(m^2 sr)]; the back is dark, or with e.both = true, of what is
 *       flat, as bright. All that does not depend on p is computed here, once.
 *
 *   emitter_power(&e)                area x radiance: what it gives off, but for a factor pi / 3
 *   vec3 x = emitter_at(&e, u, &n)   x uniform in area, and the unit normal of the front
 *   emitter_by_area(&e, p, u, &x)    draws x.s (on the light, for leave_between), x.wi (unit, from
 *   emitter_by_angle(&e, p, u, &x)   p) and x.pdf [1/sr]; no cosine is included. false: p is
 *                                    behind it or in its plane, inside of a sphere, or the point
 *                                    drawn has its back to p: then this sample counts, and is 0
 *   emitter_pdf_area(&e, p, x)       the pdf (24.4) of x, any point of e; 0 if its back faces p
 *   emitter_pdf_angle(&e, p)         (24.5); 0 if p cannot see its front
 *
 *   by area               by angle
 *   a product, a root     some 7 times the work
 *   1/r^2 close by:       never more than f cos omega: what is left of the variance is that of the
 *   no bound, variance    integrand, f cos
 *   without end if e
 *   touches the surface
 *   draws half of a sphere's points on its back
 *
 * x lies on the shape as nearly as reals allow, x.s.error and noise as in 18.
 *
 * Source: P. Shirley, C. Wang, K. Zimmerman, "Monte Carlo Techniques for Direct Lighting
 * Calculations", ACM TOG 15(1), 1996.
 */
#ifndef DIRECT_EMITTER_H
#define DIRECT_EMITTER_H

#include "../18_shade/surface.h"
#include "../20_monte_carlo/sampler.h"
#include "../22_radiometry/spherical_sampling.h"

typedef enum { EMITTER_TRIANGLE, EMITTER_RECTANGLE, EMITTER_SPHERE } emitter_kind;
typedef struct {
    emitter_kind kind;
    bool both;            /* flat: shines from the back, too */
    union { triangle triangle; rectangle rectangle; sphere sphere; };
    vec3 n;               /* unit normal of the front; sphere: 0 */
    real area;            /* > 0, or it does not shine */
    vec3 Le;
    real reach, noise;    /* x.s.error = epsilon (reach + 2 |x|), x.s.noise */
} emitter;
typedef struct { surface s; vec3 wi; real pdf; } emitter_point;

/* ---------------------------------------------------------------------------------------------- */

static inline emitter emitter_of_triangle(triangle t, vec3 Le)
{
    emitter e = {.kind = EMITTER_TRIANGLE, .triangle = t, .Le = Le};
    vec3 s = vsub(t.b, t.a), u = vsub(t.c, t.a);
    e.n = triangle_normal(t);
    e.area = vzero(e.n) ? 0 : vlength(vcross(s, u)) / 2;
    e.reach = 2 * real_max(vlength(s), vlength(u));
    e.noise = surface_on_triangle(t, no_shape, 0, 0).noise;
    return e;
}

/* The surface that rays meet is a mesh of two triangles, whose corners are o + s rounded: that much
 * more x may be off. */
static inline emitter emitter_of_rectangle(rectangle r, vec3 Le)
{
    vec3 b = vadd(r.o, r.s), d = vadd(r.o, r.t), c = vadd(b, r.t);
    emitter one = emitter_of_triangle((triangle){r.o, b, c}, Le);
    emitter two = emitter_of_triangle((triangle){r.o, c, d}, Le);
    emitter e = {.kind = EMITTER_RECTANGLE, .rectangle = r, .Le = Le, .n = one.n};
    real corners = real_max(real_max(surface_reach(r.o), surface_reach(b)),
                            real_max(surface_reach(c), surface_reach(d)));
    e.area = vzero(e.n) ? 0 : vlength(vcross(r.s, r.t));
    e.reach = real_max(one.reach, two.reach) + 2 * corners;
    e.noise = real_max(one.noise, two.noise);
    return e;
}

static inline emitter emitter_of_sphere(sphere s, vec3 Le)
{
    return (emitter){.kind = EMITTER_SPHERE, .sphere = s, .area = 4 * pi * s.r * s.r, .Le = Le,
                     .reach = 4 * fabs(s.r)};
}

static inline real emitter_power(const emitter *e)
{
    return (e->both ? 2 : 1) * e->area * (e->Le.x + e->Le.y + e->Le.z);
}

static inline surface emitter_surface(const emitter *e, vec3 x, vec3 n)
{
    return (surface){x, n, n, real_epsilon * (e->reach + 2 * surface_reach(x)), e->noise, no_shape};
}

/* Height of p over the plane of a flat one: its front is seen if > 0. */
static inline real emitter_height(const emitter *e, vec3 p)
{
    return vdot(e->n, vsub(p, e->kind == EMITTER_TRIANGLE ? e->triangle.a : e->rectangle.o));
}

/* Does a flat one shine to where p is? */
static inline bool emitter_faces(const emitter *e, vec3 p)
{
    real h = emitter_height(e, p);
    return h > 0 || (e->both && h < 0);
}

/* n, the normal of the front, or of the side that p sees, if both shine. */
static inline vec3 emitter_side(const emitter *e, vec3 n, vec3 p)
{
    return e->both && emitter_height(e, p) < 0 ? vneg(n) : n;
}

/* (24.4). vdot(n, wi) = -cos_x. */
static inline real emitter_density(const emitter *e, vec3 to, vec3 wi, vec3 n)
{
    return vdot(to, to) / (e->area * -vdot(n, wi));
}

/* p on the sphere may be off it by as much as 18 says: to what shines inwards it is inside. */
static inline bool emitter_sphere_around(sphere s, vec3 p)
{
    real r = fabs(s.r);
    return vlength(vsub(p, s.c)) <= r + real_epsilon * (8 * r + 4 * surface_reach(p));
}

/* The point x, from the side that n [unit] looks to. */
fast_inline bool emitter_seen(const emitter *e, vec3 x, vec3 n, vec3 p, emitter_point *out)
{
    vec3 to = vsub(x, p), wi = vunit(to);
    if (!(vdot(n, wi) < 0)) return false;  /* its back; or x = p */
    *out = (emitter_point){emitter_surface(e, x, n), wi, emitter_density(e, to, wi, n)};
    return out->pdf > 0;
}

/* A point of it, each part of its area as likely; n: where it shines from there. */
fast_inline vec3 emitter_at(const emitter *e, point2 u, vec3 *n)
{
    *n = e->n;
    if (e->kind == EMITTER_RECTANGLE)
        return vmadd(vmadd(e->rectangle.o, e->rectangle.s, u.u), e->rectangle.t, u.v);
    if (e->kind == EMITTER_TRIANGLE) {
        vec3 b = sample_triangle(u.u, u.v), a = e->triangle.a;
        return vadd(a, vmadd(vscale(vsub(e->triangle.b, a), b.y), vsub(e->triangle.c, a), b.z));
    }
    vec3 out = sample_sphere(u.u, u.v);
    *n = e->sphere.r < 0 ? vneg(out) : out;
    return vmadd(e->sphere.c, out, fabs(e->sphere.r));
}

fast_inline bool emitter_by_area(const emitter *e, vec3 p, point2 u, emitter_point *out)
{
    if (!(e->area > 0)) return false;
    if (e->kind == EMITTER_SPHERE && e->sphere.r < 0 && !emitter_sphere_around(e->sphere, p))
        return false;
    vec3 n, x = emitter_at(e, u, &n);
    return emitter_seen(e, x, emitter_side(e, n, p), p, out);
}

static inline real emitter_pdf_area(const emitter *e, vec3 p, vec3 x)
{
    vec3 n = e->kind == EMITTER_SPHERE ? sphere_normal(e->sphere, x) : emitter_side(e, e->n, p);
    vec3 to = vsub(x, p), wi = vunit(to);
    return e->area > 0 && vdot(n, wi) < 0 ? emitter_density(e, to, wi, n) : 0;
}

/* ---- sphere, by angle ---- */

/* From outside: the cone of directions that meet it. With theta the angle to the axis, D = |c - p|
 * and power = D^2 - R^2, the first of two roots is at
 *     t = D cos - sqrt(R^2 - D^2 sin^2) = power / (D cos + sqrt(R^2 - D^2 sin^2)),         (24.6)
 * which does not cancel; x - c is t cos - D along the axis and t sin across. From within a sphere
 * that shines inwards: all directions, and the other root. */
static inline bool emitter_sphere_by_angle(const emitter *e, vec3 p, point2 u, emitter_point *out)
{
    sphere s = e->sphere;
    real R = fabs(s.r);
    vec3 f = vsub(s.c, p), w, m;
    if (s.r < 0) {
        if (!emitter_sphere_around(s, p)) return false;
        w = sample_sphere(u.u, u.v);
        real b = vdot(f, w), k = (R - vlength(f)) * (R + vlength(f));
        m = vunit(vsub(vscale(w, b + sqrt(real_max(b * b + k, 0))), f));
        *out = (emitter_point){emitter_surface(e, vmadd(s.c, m, R), vneg(m)), w, 1 / (4 * pi)};
        return true;
    }
    direction_cone c = sphere_cone(s, p);
    if (!(c.half_sine2 > 0) || c.half_sine2 >= 1) return false;  /* a point; or p is inside */
    vec3 l = sample_cone(c, u.u, u.v);
    real D = vlength(f), across = D * sqrt(l.x * l.x + l.y * l.y);
    real power = D > 2 * R ? (D - R) * (D + R) : sphere_power_at(s, p);
    real t = power / (D * l.z + sqrt(real_max((R - across) * (R + across), 0)));
    vec3 axis = vscale(f, 1 / D);
    w = directed(axis, l);
    m = vunit(vsub(vscale(w, t), f));
    *out = (emitter_point){emitter_surface(e, vmadd(s.c, m, R), m), w, 1 / (4 * pi * c.half_sine2)};
    return true;
}

/* ---- rectangle, by angle ---- */

/* spherical_rectangle_of prepares for every size, and half of that is not used. Here the common
 * case alone is prepared: not small, no overflow near. The same bits, in half of the time. */
static inline bool emitter_rectangle_sample(rectangle r, vec3 p, point2 u, vec3 *x, real *omega)
{
    vec3 d = vsub(r.o, p);
    real reach = vdot(d, d) + vdot(r.s, r.s) + vdot(r.t, r.t);
    *omega = fabs(rectangle_solid_angle(r, p));
    spherical_rectangle k;
    if (reach > (real)0x1p-24 && reach < (real)0x1p24 && *omega > (real)0x1p20 * real_epsilon) {
        k.map = urena_map_of(r, p), k.omega = *omega;
        *x = rectangle_at(r, spherical_rectangle_sample_urena(&k, u.u, u.v));
        return true;
    }
    k = spherical_rectangle_of(r, p);
    *omega = k.omega;
    if (!(k.omega > 0)) return false;
    *x = rectangle_at(r, spherical_rectangle_sample(&k, u.u, u.v));
    return true;
}

/* ---- all, by angle ---- */

static inline bool emitter_by_angle(const emitter *e, vec3 p, point2 u, emitter_point *out)
{
    vec3 x;
    real omega;
    if (!(e->area > 0)) return false;
    if (e->kind == EMITTER_SPHERE) return emitter_sphere_by_angle(e, p, u, out);
    if (!emitter_faces(e, p)) return false;
    if (e->kind == EMITTER_TRIANGLE) {
        spherical_triangle k = spherical_triangle_of(e->triangle, p);
        omega = k.omega;
        if (!(omega > 0)) return false;
        vec3 b = spherical_triangle_sample(&k, u.u, u.v);
        x = triangle_at(e->triangle, b.y, b.z);
    } else {
        if (!emitter_rectangle_sample(e->rectangle, p, u, &x, &omega)) return false;
    }
    surface s = emitter_surface(e, x, emitter_side(e, e->n, p));
    *out = (emitter_point){s, vunit(vsub(x, p)), 1 / omega};
    return !vzero(out->wi);
}

static inline real emitter_pdf_angle(const emitter *e, vec3 p)
{
    real omega = 0;
    if (!(e->area > 0)) return 0;
    if (e->kind == EMITTER_SPHERE) {
        bool around = e->sphere.r < 0 && emitter_sphere_around(e->sphere, p);
        if (e->sphere.r < 0) return around ? 1 / (4 * pi) : 0;
        real h = sphere_cone(e->sphere, p).half_sine2;
        return h > 0 && h < 1 ? 1 / (4 * pi * h) : 0;
    }
    if (!emitter_faces(e, p)) return 0;
    if (e->kind == EMITTER_TRIANGLE) omega = fabs(triangle_solid_angle(e->triangle, p));
    else omega = fabs(rectangle_solid_angle(e->rectangle, p));
    return omega > 0 ? 1 / omega : 0;
}

#endif
