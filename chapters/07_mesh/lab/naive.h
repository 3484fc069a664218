/* naive.h: cone and polygon as textbooks have them, with the signatures of the default functions.
 *
 *   cone_hit_naive(c, r, &h)      fails at a distance and beside the axis
 *   polygon_hit_naive(p, r, &h)   slips at edges
 */
#ifndef MESH_LAB_NAIVE_H
#define MESH_LAB_NAIVE_H

#include "../cone.h"
#include "../polygon.h"

/* ---------------------------------------------------------------------------------------------- */

/* (7.5) squared, with p = o + t d and the unit axis n: alpha t^2 + 2 beta t + gamma = 0, solved
 * as it stands. Fails: a radius of 1 seen from 1e4 in float (b^2 and a c agree in all their
 * digits), from 1e8 in double; d parallel to the axis or to the side, where alpha is nearly 0 and
 * both roots are lost. */
static inline bool cone_hit_naive(cone c, ray r, hit *out)
{
    vec3 w = vsub(c.b, c.a), n = vunit(w), q = vsub(r.o, c.a);
    real h = vlength(w), m = (c.rb - c.ra) / h, z = vdot(q, n), g = vdot(r.d, n), rz = c.ra + m * z;
    real alpha = vdot(r.d, r.d) - (1 + m * m) * g * g;
    real beta = vdot(r.d, q) - g * z - m * g * rz;
    real gamma = vdot(q, q) - z * z - rz * rz;
    real s = sqrt(beta * beta - alpha * gamma);  /* NaN: no root, and NaN is never in an interval */
    real t0 = (-beta - s) / alpha, t1 = (-beta + s) / alpha;
    real t[2] = {real_min(t0, t1), real_max(t0, t1)};
    return cone_first(r, t, (real[2]){z + t[0] * g, z + t[1] * g}, h, out);
}

/* Point on the plane first, then the two coordinates that n is longest in left out, then the same
 * walk. Slips: the neighbour across an edge computes its own point, and may leave out another
 * coordinate. In the crossing test one divides by y_j - y_i, which is not 0 as one end is above
 * and one is not. */
static inline bool polygon_hit_naive(polygon p, ray r, hit *out)
{
    real t = vdot(p.normal, vsub(p.centre, r.o)) / vdot(p.normal, r.d);
    if (!ray_covers(r, t)) return false;
    vec3 at = ray_at(r, t);
    int k = vlongest(p.normal), a = k == 2 ? 0 : k + 1, b = a == 2 ? 0 : a + 1;
    real x = vaxis(at, a), y = vaxis(at, b);
    bool inside = false;
    for (uint32_t i = 0, j = p.n - 1; i < p.n; j = i++) {
        real xi = vaxis(p.v[i], a), yi = vaxis(p.v[i], b), xj = vaxis(p.v[j], a),
             yj = vaxis(p.v[j], b);
        if ((yi > y) != (yj > y) && x < (xj - xi) * (y - yi) / (yj - yi) + xi) inside = !inside;
    }
    if (inside) *out = (hit){t, 0, 0, 0};
    return inside;
}

#endif
