/* terminator.h: the edge of light on a smoothed mesh (明暗交界), where its two normals disagree.
 *
 *            ns                The mesh says: round. Its triangles are flat. Where light grazes, a
 *       n  \ |  / l            triangle may turn its back on the light (n.l < 0) though the surface
 *        \  \| /               it stands for does not (ns.l > 0), and shadow rays from the flat
 *     ----\--p------           triangle meet its neighbours: the edge of light becomes a staircase.
 *
 *   how.surface_of = terminator_surface;    for a `shading`: p lifted to where the round surface
 *                                           would be, and ns asked alone
 *
 * Lifted: each corner has a plane at right angles to its normal. p, put on each of the three and
 * weighted as p is, lies on or above the triangle: about where a patch would, if it bulges; a
 * hollow one is left as it is. Shadow rays then begin above the triangle and its neighbours.
 * It is a guess of the surface; the hit itself, and what other rays see, stay flat.
 *
 * Source: J. Hanika, "Hacking the Shadow Terminator", Ray Tracing Gems II, 2021, ch. 4.
 */
#ifndef SHADE_TERMINATOR_H
#define SHADE_TERMINATOR_H

#include "../shade.h"

/* ---------------------------------------------------------------------------------------------- */

/* side: 1, or -1 where the mesh is seen from inside: then it bulges the other way. */
static inline vec3 terminator_point(const mesh *m, hit h, vec3 p, real side)
{
    const uint32_t *c = m->index + 3 * (size_t)h.shape;
    const real weight[3] = {1 - h.u - h.v, h.u, h.v};
    vec3 sum = {0, 0, 0};
    for (int k = 0; k < 3; k++) {
        vec3 n = vscale(vunit(mesh_corner_normal(m, h.shape, k)), side);
        real below = real_min(0, vdot(vsub(p, m->v[c[k]]), n));
        sum = vmadd(sum, vmadd(p, n, -below), weight[k]);
    }
    return sum;
}

/* n becomes ns, so that nobody asks the flat triangle any more; not where ns itself turns away from
 * the eye. The way off the triangle is longer along ns. */
static inline surface terminator_surface(const tracer *t, ray r, trace_hit x)
{
    const mesh *m = t->w->part[x.part].tree.x.m;
    surface s = surface_of_trace(t, r, x);
    if (!m || !m->n) return s;
    real side = vdot(s.n, r.d) > 0 ? -1 : 1, tilt = vdot(s.n, s.ns);
    if (!(side * vdot(s.ns, r.d) < 0) || !(tilt > (real)0.1)) return s;
    s.p = terminator_point(m, x.h, s.p, side);
    s.n = s.ns, s.error /= tilt, s.noise /= tilt;
    return s;
}

#endif
