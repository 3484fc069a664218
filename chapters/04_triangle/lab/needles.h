/* needles.h: needle triangles (狭长三角形), rays aimed at their inside, and the exact answer.
 *
 *    a ------------------ b      length 1, |c - line a b| = width; anywhere within 1 of the origin,
 *           c                    pointing anywhere; rays from within 3
 *
 *   triangle tri = needle(&g, width, &r);       draws one, and a ray
 *   triangle_exact_hit x = triangle_exactly(tri, r);     (4.8) in double-double: 30 digits
 *   triangle_needle_count n = triangle_needles(triangle_hit, 1e-6, 10000, seed);
 *   n.due      rays that do pass inside (by the exact answer; weights > 0.1, cosine > 0.1)
 *   n.missed   of those: no hit
 *   n.error    largest relative error of t of the hits
 *
 * The weights of a needle are quotients of areas of about its width, known to some epsilon: an
 * error of t of some epsilon / width is in the nature of the thing, unless one computes in more
 * digits.
 */
#ifndef TRIANGLE_NEEDLES_H
#define TRIANGLE_NEEDLES_H

#include "../../../common/numbers/wide.h"
#include "../triangle.h"
#include "slips.h"

typedef struct { double t, u, v, w, cosine; } triangle_exact_hit;  /* of ray and normal: |cosine| */
typedef struct { size_t due, missed; double error; } triangle_needle_count;

/* ---------------------------------------------------------------------------------------------- */

static inline triangle needle(random_stream *g, real width, ray *r)
{
    vec3 a = random_in_cube(g, 1), along = vunit(random_in_cube(g, 1)), across, unused;
    vbasis(along, &across, &unused);
    triangle tri = {a, vadd(a, along),
                    vadd(vmadd(a, along, random_next(g)), vscale(across, width))};
    vec3 o = random_in_cube(g, 3);
    real u = random_between(g, 0.2, 0.4), v = random_between(g, 0.2, 0.4);
    *r = ray_from(o, vsub(triangle_at(tri, u, v), o));
    return tri;
}

static inline triangle_exact_hit triangle_exactly(triangle tri, ray r)
{
    wide3 a = wide3_of(tri.a), d = wide3_of(r.d), s = wide3_sub(wide3_of(r.o), a);
    wide3 e1 = wide3_sub(wide3_of(tri.b), a), e2 = wide3_sub(wide3_of(tri.c), a);
    wide3 p = wide3_cross(d, e2), q = wide3_cross(s, e1);
    wide det = wide3_dot(e1, p), t = wide_div(wide3_dot(e2, q), det);
    wide u = wide_div(wide3_dot(s, p), det), v = wide_div(wide3_dot(d, q), det);
    double area = wide_value(wide3_length(wide3_cross(e1, e2)));
    double length = wide_value(wide3_length(d));
    return (triangle_exact_hit){wide_value(t), wide_value(u), wide_value(v),
                       wide_value(wide_sub(wide_sub(wide_of(1), u), v)),
                       fabs(wide_value(det)) / (area * length)};
}

static inline triangle_needle_count triangle_needles(triangle_method *method, double width,
                                                     size_t n, uint64_t seed)
{
    triangle_needle_count count = {0, 0, 0};
    random_stream g = random_start(seed, 0, 0);
    for (size_t i = 0; i < n; i++) {
        ray r;
        triangle tri = needle(&g, (real)width, &r);
        triangle_exact_hit x = triangle_exactly(tri, r);
        if (!(x.u > 0.1 && x.v > 0.1 && x.w > 0.1 && x.cosine > 0.1)) continue;
        hit h;
        count.due++;
        if (!method(tri, r, &h)) count.missed++;
        else if (!(fabs((double)h.t - x.t) <= count.error * x.t))
            count.error = fabs((double)h.t - x.t) / x.t;
    }
    return count;
}

#endif
