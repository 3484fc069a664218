/* glossy.h: a reflection that is not quite a mirror's: rays scattered about the mirror direction.
 *
 *       d      n     r           r = d - 2 (d.n) n                     the mirror direction  (21.3)
 *        \     |    /.           pdf(w) = (s + 1) / (2 pi) (r.w)^s     Phong's lobe (波瓣)   (21.4)
 *         \    |   / .`          L = ks integral L(w) pdf(w) dw        what is seen in it    (21.5)
 *          \   |  / .` w
 *   -----------p-------------    one ray: w by (21.4), and its weight is ks: the pdf cancels
 *
 *   ray r;
 *   if (glossy_ray(s, d, shine, u, &r)) .. ks * what r meets     s faces d; d: any length
 *       false: w leads below the surface; it sees nothing, and no ray is called for
 *
 * shine s >= 0 [1]: 0 is any direction on the side of r, 10 satin, 1000 nearly a mirror. Infinity
 * is a mirror: w = r, and u is not looked at. Half of the rays lie within acos(2^(-1/(s+1))) of r.
 *
 * Below the surface: for r at a grazing angle up to half of the lobe. That light is lost here, so
 * rough surfaces get darker towards the silhouette: ks is the albedo of a surface seen from above,
 * an upper bound elsewhere. The lobe keeps no more promises than that: it does not conserve energy,
 * and it is not reciprocal.
 *
 * "Below" is meant for both normals of a smoothed mesh (07); r is lifted above its plane (19).
 *
 * Sources: Cook et al., 1984 (gloss); B. Phong, CACM 18(6), 1975 (the lobe); E. Lafortune, Y.
 * Willems, "Using the modified Phong reflectance model ..", 1994 (its normalisation).
 */
#ifndef DISTRIBUTED_GLOSSY_H
#define DISTRIBUTED_GLOSSY_H

#include "../18_shade/leave.h"
#include "../19_whitted/reflect.h"
#include "../20_monte_carlo/sampler.h"
#include "../20_monte_carlo/sampling.h"

/* ---------------------------------------------------------------------------------------------- */

/* At infinity a mirror: (21.4) has all its weight at r. */
static inline vec3 glossy_direction(surface s, vec3 d, real shine, point2 u)
{
    vec3 r = lifted(vunit(first_reflect(d, s.ns)), s.n);                               /* (21.3) */
    return isinf(shine) ? r : directed(r, sample_lobe(shine, u.u, u.v));
}

/* A NaN is below. */
static inline bool glossy_ray(surface s, vec3 d, real shine, point2 u, ray *out)
{
    vec3 w = glossy_direction(s, d, shine, u);
    if (!(vdot(w, s.n) > 0)) return false;
    if (!isinf(shine) && !(vdot(w, s.ns) > 0)) return false;
    *out = leave(s, w);
    return true;
}

#endif
