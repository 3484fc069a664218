/* reference.h: the reflection equation (23.2) of GGX: the truth for the tables.
 *
 *   vec3 lo = reflection_reference(&b, n, wo, incident);
 */
#ifndef BRDF_REFERENCE_H
#define BRDF_REFERENCE_H

#include "../reflection.h"

/* ---------------------------------------------------------------------------------------------- */

/* For GGX, whatever its alpha: over half vectors, spread as D is, on a lattice.
 *   D z dm = du dv,  z^2 = (1 - u) / (1 + (a^2 - 1) u),  dwi = 4 (wo.m) dm                 (23.20)
 * Shares no direction and no pdf with brdf_sample. */
static inline vec3 reflection_reference(const brdf *b, vec3 n, vec3 wo, incident_light *incident)
{
    shading_frame f = shading_frame_of(n);
    vec3 sum = {0, 0, 0}, o = to_local(f, wo);
    real a = b->alpha, whole = 0;
    for (int i = 0; i < fibonacci_large.n; i++) {
        square_point p = fibonacci_point(fibonacci_large, i);
        real q = 1 - p.u + a * a * p.u, z = sqrt((1 - p.u) / q);
        vec3 m = sample_turn(a * sqrt(p.u / q), z, p.v), wi = mirrored(o, m);
        real c = vdot(o, m);
        whole += p.area;
        if (brdf_behind(wi) || c <= 0) continue;
        vec3 fl = vmul(brdf_value_local(b, wi, o), incident(to_world(f, wi)));
        sum = vmadd(sum, fl, 4 * c * wi.z / (ggx_d(a, m) * z) * p.area);
    }
    return vscale(sum, 1 / whole);
}

#endif
