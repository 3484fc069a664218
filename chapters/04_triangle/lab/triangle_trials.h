/* triangle_trials.h: rays that are hard for a triangle test: at edges, at vertices, at needles.
 *
 * Slips (漏缝): stand inside a closed mesh, aim at an edge or a vertex: the ray must hit something.
 *
 *       q------            Aimed: d = point - o, rounded to real; the point is a corner of the mesh
 *      / \    /            or, rounded too, a point of the edge p q. Such a ray does not meet the
 *     /   x<-/------- O    edge exactly, and that is what matters: it passes where the rounding
 *    /     \/              errors of the neighbours decide which of them it hits, if any.
 *    ------p               Random rays show nothing: test_random_rays_show_nothing.
 *
 *   triangle_slip_count n = slips(&mesh, triangle_hit, true, 100000, seed);
 *   n.slips   rays that hit none of all the triangles of the mesh
 *   n.hits    of the triangles round the vertex or edge: 2 a ray at an edge means both
 *   n.error   largest |t - 1| of the hits, where t = 1 is the aimed point
 *
 * Needles (狭长三角形), whose weights are quotients of areas of about their width, known to some
 * epsilon: an error of t of some epsilon / width, unless one computes in more digits.
 *
 *    a ------------------ b      length 1, |c - line a b| = width; anywhere within 1 of the origin,
 *           c                    pointing anywhere; rays from within 3, at the inside
 *
 *   triangle tri = needle(&g, width, &r);                draws one, and a ray
 *   triangle_exact_hit x = triangle_exactly(tri, r);     (4.8) in double-double: 30 digits
 *   triangle_needle_count n = triangle_needles(triangle_hit, 1e-6, 10000, seed);
 *   n.due      rays that do pass inside (by the exact answer; weights > 0.1, cosine > 0.1)
 *   n.missed   of those: no hit
 *   n.error    largest relative error of t of the hits
 */
#ifndef TRIANGLE_TRIALS_H
#define TRIANGLE_TRIALS_H

#include "../../../common/numbers/wide.h"
#include "../../../common/random.h"
#include "../scenes/icosphere.h"
#include "../triangle.h"

typedef bool triangle_method(triangle tri, ray r, hit *out);
typedef struct { size_t slips, hits; double error; } triangle_slip_count;
typedef struct { double t, u, v, w, cosine; } triangle_exact_hit;  /* of ray and normal: |cosine| */
typedef struct { size_t due, missed; double error; } triangle_needle_count;

/* ---------------------------------------------------------------------------------------------- */

/* A random point near the centre [well inside the mesh]; `radius` is that of the mesh. */
static inline vec3 slip_origin(random_stream *g, vec3 centre, real radius)
{
    return vadd(centre, random_in_cube(g, radius / 4));
}

/* One aimed ray; *near: the triangles that it should hit, round the vertex, or beside the edge. */
static inline ray slip_aim(const icosphere *m, bool at_vertex, random_stream *g,
                           icosphere_fan *near)
{
    vec3 o = slip_origin(g, m->centre, m->radius);
    uint32_t k = (uint32_t)(random_next_bits(g) >> 32);
    if (at_vertex) {
        *near = m->fan[k % m->vertices];
        return ray_from(o, vsub(m->v[k % m->vertices], o));
    }
    icosphere_edge e = m->edge[k % m->edges];
    *near = (icosphere_fan){2, {e.triangle[0], e.triangle[1]}};
    vec3 p = m->v[e.p], q = m->v[e.q], aim = vmadd(p, vsub(q, p), random_next(g));
    return ray_from(o, vsub(aim, o));
}

static inline bool slip_misses_all(const icosphere *m, triangle_method *method, ray r)
{
    hit h;
    for (uint32_t i = 0; i < m->triangles; i++)
        if (method(icosphere_triangle(m, i), r, &h)) return false;
    return true;
}

/* n rays from random points near the centre. The triangles that should be hit are tried first,
 * because that is quick, and only then all others. */
static inline triangle_slip_count slips(const icosphere *m, triangle_method *method, bool at_vertex,
                                        size_t n, uint64_t seed)
{
    triangle_slip_count count = {0, 0, 0};
    random_stream g = random_start(seed, at_vertex, 0);
    for (size_t i = 0; i < n; i++) {
        icosphere_fan near;
        ray r = slip_aim(m, at_vertex, &g, &near);
        size_t before = count.hits;
        for (uint32_t j = 0; j < near.count; j++) {
            hit h;
            if (!method(icosphere_triangle(m, near.triangle[j]), r, &h)) continue;
            double error = fabs((double)h.t - 1);
            if (!(error <= count.error)) count.error = error;
            count.hits++;
        }
        if (count.hits == before) count.slips += slip_misses_all(m, method, r);
    }
    return count;
}

/* ---- needles ---- */

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
