/* plane.h: the plane (平面) in both of its forms, and the ray that meets it.
 *
 *         n                      (p - p') . n = 0            a point p' and a normal n  (4.1)
 *         |    ray               e.a x + e.b y + e.c z + e.d = 0    four numbers        (4.2)
 *     ____p'__p_______           the same plane if (e.a, e.b, e.c) = n, e.d = -n . p'   (4.3)
 *            /                   t = (p' - o) . n / (d . n)                             (4.4)
 *                                t = -(n . o + e.d) / (d . n)                           (4.5)
 *
 *   plane p = {point, normal};                  n: any length but 0
 *   plane p = plane_through(a, b, c);           n = (b - a) x (c - a); 0 if a, b, c lie on a line
 *   plane_equation e = plane_equation_of(p);
 *   if (plane_hit(p, r, &h)) ...                (4.4), the robust one; that of first.h hits at an
 *                                               infinite t, if the ray is nearly parallel
 *   if (plane_equation_hit(e, r, &h)) ...       (4.5), the same in exact arithmetic
 *
 * Never hit: a ray parallel to the plane, in it or not (no single t); n = 0; NaN or infinite input.
 *
 * (4.5) adds n . o and e.d: two large numbers with a small sum when the scene lies far from the
 * origin. (4.4) subtracts the points first, which is exact when they are close. At a distance of
 * 1e4 from the origin (4.5) has lost more than three digits of t, (4.4) none.
 *
 * Sources: S. Marschner, P. Shirley, "Fundamentals of Computer Graphics", 4th ed., 2015, 2.5.3;
 * GAMES101, lecture 13, "Ray-Surface Intersection".
 */
#ifndef TRIANGLE_PLANE_H
#define TRIANGLE_PLANE_H

#include "../01_ray/hit.h"
#include "first.h"

typedef struct { real a, b, c, d; } plane_equation;

/* ---------------------------------------------------------------------------------------------- */

static inline plane plane_through(vec3 a, vec3 b, vec3 c)
{
    return (plane){a, vcross(vsub(b, a), vsub(c, a))};
}

static inline plane_equation plane_equation_of(plane p)  /* (4.3) */
{
    return (plane_equation){p.n.x, p.n.y, p.n.z, -vdot(p.n, p.p)};
}

/* t = above / across, if there is one t and the ray covers it. Both 0: the ray lies in the plane,
 * and 0/0 would be a NaN; across alone 0: the infinite quotient would lie in [0, infinity]. */
static inline bool plane_quotient_hit(real above, real across, ray r, hit *out)
{
    real t = above / across;
    if (across == 0 || !isfinite(t) || !ray_covers(r, t)) return false;
    *out = (hit){t, 0, 0, 0};
    return true;
}

static inline bool plane_hit(plane p, ray r, hit *out)  /* (4.4) */
{
    return plane_quotient_hit(vdot(vsub(p.p, r.o), p.n), vdot(r.d, p.n), r, out);
}

static inline bool plane_equation_hit(plane_equation e, ray r, hit *out)  /* (4.5) */
{
    vec3 n = {e.a, e.b, e.c};
    return plane_quotient_hit(-(vdot(n, r.o) + e.d), vdot(r.d, n), r, out);
}

#endif
