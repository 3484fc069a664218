/* dielectric.h: glass for a path, which has one way to go. dielectric (电介质)
 *
 *       wo   n   wr       R: Fresnel's share (19.8) of what comes along is reflected,
 *         \  |  /         1 - R goes through, along Snell's direction (19.4)
 *    ______\ | /_____
 *             \           one of the two is drawn, with just this probability:              (26.9)
 *              \ wt       weight R / R = 1, or (1 - R) / (1 - R) = 1
 *
 *   vec3 wi = dielectric_scatter(n, wo, n1, n2, u, &through)
 *       n1: refractive index where wo is, n2: behind; u in [0,1); n.wo >= 0; all unit
 *   beta *= dielectric_squeeze(n1, n2)   if it went through: radiance, not power, is        (26.10)
 *       squeezed into a smaller solid angle in glass, (n1/n2)^2 seen from the eye, and out again
 *   if (dielectric_rough(g, n, wo, s, &wi, &through, &power)) beta *= power       rough: by facets
 *       (23.26), three numbers of s; power <= 1 of what came along goes that way; false: none
 *   dice look at beta / (product of all (26.10) so far): on the way out it comes back       (26.11)
 *
 * In total reflection R = 1. What the glass keeps on the way: absorbed (19.9).
 *
 * Source: E. Veach, thesis, Stanford, 1997, section 5.2 (the factor (26.10)).
 */
#ifndef PATH_DIELECTRIC_H
#define PATH_DIELECTRIC_H

#include "../19_whitted/refract.h"
#include "../19_whitted/media.h"
#include "../19_whitted/reflect.h"
#include "../23_brdf/rough_glass.h"

/* ---------------------------------------------------------------------------------------------- */

static inline vec3 dielectric_scatter(vec3 n, vec3 wo, real n1, real n2, real u, bool *through)
{
    snell s;
    vec3 d = vneg(wo);
    *through = snell_of(d, n, n1, n2, &s) && u >= fresnel(&s);                         /* (26.9) */
    if (*through) return snell_refract(&s, d, n);
    return reflect(d, n);
}

static inline real dielectric_squeeze(real n1, real n2)
{
    return n1 / n2 * (n1 / n2);                                                        /* (26.10) */
}

static inline bool dielectric_rough(rough_glass g, vec3 n, vec3 wo, random_stream *s, vec3 *wi,
                                    bool *through, real *power)
{
    shading_frame f = shading_frame_of(n);
    real u = random_next(s), v = random_next(s), coin = random_next(s), weight;
    vec3 w;
    if (!rough_glass_sample(&g, to_local(f, wo), u, v, coin, &w, &weight))
        return *through = false;
    *wi = to_world(f, w), *through = w.z < 0;
    *power = *through ? weight / dielectric_squeeze(g.n1, g.n2) : weight;
    return (vdot(*wi, n) < 0) == *through;
}

#endif
