/* slips.h: the experiment of this chapter. Stand inside a closed mesh, aim at an edge or a vertex:
 * the ray must hit something. If it hits nothing, it slipped through (漏缝).
 *
 *       q------            Aimed: d = point - o, rounded to real; the point is a corner of the mesh
 *      / \    /            or, rounded too, a point of the edge p q. Such a ray does not meet the
 *     /   x<-/------- O    edge exactly, and that is what matters: it passes where the rounding
 *    /     \/              errors of the neighbours decide which of them it hits, if any.
 *    ------p
 *
 *   triangle_slip_count n = slips(&mesh, triangle_hit, true, 100000, seed);
 *   n.slips   rays that hit none of all the triangles of the mesh
 *   n.hits    of the triangles round the vertex or edge: 2 a ray at an edge means both
 *   n.error   largest |t - 1| of the hits, where t = 1 is the aimed point
 *
 * Random rays show nothing: test_random_rays_show_nothing in tests/04_watertight.c.
 */
#ifndef TRIANGLE_SLIPS_H
#define TRIANGLE_SLIPS_H

#include "../../../common/random.h"
#include "../scenes/icosphere.h"

typedef bool triangle_method(triangle tri, ray r, hit *out);
typedef struct { size_t slips, hits; double error; } triangle_slip_count;

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

#endif
