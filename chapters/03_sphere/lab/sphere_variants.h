/* sphere_variants.h: other ways to meet a sphere, to be measured beside sphere.h. All have the
 * signature of sphere_hit and of sphere_roots; only their rounding differs. l: distance.
 *
 *   suffix          what it does                                  misclassified within
 *   first_sphere_.. the textbook (3.3); see first.h               eps (l/R)^2 R  of the limb
 *   _stable_root    (3.3), the roots by (3.7): no b - sqrt(D)     eps (l/R)^2 R  mends nothing
 *   _haines         D from the ray's point closest to c           eps (l/R) R
 *   _lagrange       D by (3.5), plain cross product               eps (l/R) R    and cheaper
 *   _kahan          D by (3.5), every rounding error given back   eps R          whatever l
 *   sphere_hit      D by (3.5); if too small to be sure, again in twice the precision
 *
 * Source of _haines: E. Haines, J. Günther, T. Akenine-Möller, "Precision Improvements for
 * Ray/Sphere Intersection", Ray Tracing Gems, 2019, ch. 7. Of (3.7): W. Press et al., "Numerical
 * Recipes", 2nd ed. 1992, section 5.6. Of _kahan: difference_of_products in vec3.h, and D. Knuth,
 * "The Art of Computer Programming", vol. 2, section 4.2.2 theorem B.
 */
#ifndef SPHERE_VARIANTS_H
#define SPHERE_VARIANTS_H

#include "../../../common/numbers/sum.h"
#include "../sphere.h"

typedef bool sphere_hit_function(sphere s, ray r, hit *out);
typedef bool sphere_roots_function(sphere s, ray r, real *t0, real *t1);

/* ---------------------------------------------------------------------------------------------- */

/* t0 t1 = k / a (3.7): the root that ca - sqrt(D) would spoil follows from the other one. Ordered,
 * since rounding may swap two roots that nearly coincide. ca: a t_ca, half of the textbook's -b; D
 * is a quarter of its b^2 - 4ac, and k its c. */
static inline bool sphere_by_vieta(real a, real ca, real k, real D, real *t0, real *t1)
{
    if (!(D >= 0)) return false;
    real q = ca + copysign(sqrt(D), ca), far = q / a, near = q == 0 ? 0 : k / q;
    *t0 = real_min(near, far);
    *t1 = real_max(near, far);
    return true;
}

static inline bool sphere_roots_stable_root(sphere s, ray r, real *t0, real *t1)
{
    vec3 f = vsub(r.o, s.c);
    real a = vdot(r.d, r.d), ca = -vdot(r.d, f), k = vdot(f, f) - s.r * s.r;
    return sphere_by_vieta(a, ca, k, ca * ca - a * k, t0, t1);
}

static inline bool sphere_roots_haines(sphere s, ray r, real *t0, real *t1)
{
    vec3 f = vsub(r.o, s.c);
    real a = vdot(r.d, r.d), ca = -vdot(r.d, f), k = vdot(f, f) - s.r * s.r;
    vec3 l = vmadd(f, r.d, ca / a);  /* from c to the ray's closest point */
    return sphere_by_vieta(a, ca, k, a * (s.r * s.r - vdot(l, l)), t0, t1);
}

static inline bool sphere_roots_lagrange(sphere s, ray r, real *t0, real *t1)
{
    vec3 f = vsub(r.o, s.c), x = vcross(r.d, f);
    real a = vdot(r.d, r.d), ca = -vdot(r.d, f), k = vdot(f, f) - s.r * s.r;
    return sphere_by_vieta(a, ca, k, a * (s.r * s.r) - vdot(x, x), t0, t1);  /* (3.5) */
}

/* Without branches and without a wider type; needs a machine that has fma, or it is slow. */
static inline bool sphere_roots_kahan(sphere s, ray r, real *t0, real *t1)
{
    vec3 d = r.d, f = vsub(r.o, s.c);
    vec3 e = {sum_error(r.o.x, -s.c.x, f.x), sum_error(r.o.y, -s.c.y, f.y),
              sum_error(r.o.z, -s.c.z, f.z)};  /* o - c = f + e exactly */
    vec3 x = {difference_of_products(d.y, f.z, d.z, f.y),
              difference_of_products(d.z, f.x, d.x, f.z),
              difference_of_products(d.x, f.y, d.y, f.x)};
    x = vadd(x, vcross(d, e));
    real a = vdot(d, d), ca = -(vdot(d, f) + vdot(d, e)), k = vdot(f, f) - s.r * s.r;
    return sphere_by_vieta(a, ca, k, a * (s.r * s.r) - vdot(x, x), t0, t1);  /* (3.5) */
}

#define SPHERE_HIT_BY(X_hit, X_roots)                                                              \
    static inline bool X_hit(sphere s, ray r, hit *out)                                            \
    {                                                                                              \
        real t0, t1;                                                                               \
        return X_roots(s, r, &t0, &t1) && sphere_first(r, t0, t1, out);                            \
    }
SPHERE_HIT_BY(sphere_hit_stable_root, sphere_roots_stable_root)
SPHERE_HIT_BY(sphere_hit_haines, sphere_roots_haines)
SPHERE_HIT_BY(sphere_hit_lagrange, sphere_roots_lagrange)
SPHERE_HIT_BY(sphere_hit_kahan, sphere_roots_kahan)

#endif
