/* vec3.h: real numbers, and vectors of three of them.
 *
 * real is double, or float with -DREAL=float; a vec3 is a point, a direction or a colour, passed by
 * value. vec(x, y, z) makes one of any numbers; the others are v + what is returned; vectors first.
 *
 *   vadd(a,b)  a + b     vscale(a,s)   s a          vdot(a,b)    a . b   vmin(a,b)   smaller
 *   vsub(a,b)  a - b     vmul(a,b)     (ax bx, ..)  vcross(a,b)  a x b   vmax(a,b)   larger
 *   vneg(a)    -a        vmadd(a,b,s)  a + s b      vlength(a)   |a|     vaxis(a,k)  ax, ay, az
 *   vwith(a,k,s)  a with component k = s            vabs(a)  (|ax|, ..)  vlargest(a) max |ak|
 *   vunit(a)   a / |a|   vfinite(a)    all finite   vzero(a)     all 0   vlongest(a) k of max |ak|
 *   vbasis(n, &s, &t)     completes a unit n to a right-handed orthonormal basis s, t, n
 *
 * vlength and vunit know no overflow at 1e300 and no underflow at 1e-300; vunit of a zero, infinite
 * or NaN vector is (0,0,0). vmin, vmax, real_min, real_max return their second argument for a NaN.
 */
#ifndef VEC3_H
#define VEC3_H
#include "posix.h"
#include <float.h>
#include <stdbool.h>
#include <tgmath.h>  /* math.h; sqrt, fabs, fma .. choose float or double by their argument */

#ifndef REAL
#define REAL double
#endif
typedef REAL real;
typedef struct { real x, y, z; } vec3;
_Static_assert(sizeof(vec3) == 3 * sizeof(real), "vaxis reads a vec3 as three reals in a row");

#define pi ((real)3.14159265358979323846)
#define real_is_float (sizeof(real) == sizeof(float))
/* A copy at each place that calls it: a call would write the ray anew, and knows no constants. */
#define fast_inline __attribute__((always_inline)) static inline
#define cold_inline __attribute__((cold)) static inline  /* runs seldom: small, soon compiled */
/* From 1 to the next real: 2.2e-16 or 1.2e-7. A rounded operation is off by half of it at most. */
#define real_epsilon (real_is_float ? (real)FLT_EPSILON : (real)DBL_EPSILON)
#define real_largest (real_is_float ? (real)FLT_MAX : (real)DBL_MAX)
#define real_smallest (real_is_float ? (real)FLT_MIN : (real)DBL_MIN)
#define real_infinity ((real)INFINITY)

/* ---------------------------------------------------------------------------------------------- */
/* Plain comparisons, not fmin: one instruction each, and the second argument wins against a NaN. */
static inline real real_min(real a, real b) { return a < b ? a : b; }
static inline real real_max(real a, real b) { return a > b ? a : b; }
static inline real real_clamp(real x, real lo, real hi) { return real_min(real_max(x, lo), hi); }

/* Of any numbers: who writes vec(0.3, n, 2) need not say of each that it may lose digits. */
#define vec(x, y, z) ((vec3){(real)(x), (real)(y), (real)(z)})
static inline vec3 vadd(vec3 a, vec3 b) { return (vec3){a.x + b.x, a.y + b.y, a.z + b.z}; }
static inline vec3 vsub(vec3 a, vec3 b) { return (vec3){a.x - b.x, a.y - b.y, a.z - b.z}; }
static inline vec3 vmul(vec3 a, vec3 b) { return (vec3){a.x * b.x, a.y * b.y, a.z * b.z}; }
static inline vec3 vneg(vec3 a) { return (vec3){-a.x, -a.y, -a.z}; }
static inline vec3 vscale(vec3 a, real s) { return (vec3){s * a.x, s * a.y, s * a.z}; }
static inline vec3 vmadd(vec3 a, vec3 b, real s) { return vadd(a, vscale(b, s)); }
static inline real vdot(vec3 a, vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

static inline vec3 vcross(vec3 a, vec3 b)
{
    return (vec3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static inline vec3 vmin(vec3 a, vec3 b)
{
    return (vec3){real_min(a.x, b.x), real_min(a.y, b.y), real_min(a.z, b.z)};
}

static inline vec3 vmax(vec3 a, vec3 b)
{
    return (vec3){real_max(a.x, b.x), real_max(a.y, b.y), real_max(a.z, b.z)};
}

static inline real vaxis(vec3 a, int k) { return ((const real *)&a)[k]; }
static inline vec3 vwith(vec3 a, int k, real s) { return ((real *)&a)[k] = s, a; }

static inline int vlongest(vec3 a)
{
    real x = fabs(a.x), y = fabs(a.y), z = fabs(a.z);
    int first = x >= y;
    return 2 - ((first ? x : y) >= z) * (1 + first);
}

static inline vec3 vabs(vec3 a) { return (vec3){fabs(a.x), fabs(a.y), fabs(a.z)}; }
static inline real vlargest(vec3 a) { return fabs(vaxis(a, vlongest(a))); }
static inline bool vzero(vec3 a) { return fabs(a.x) + fabs(a.y) + fabs(a.z) == 0; }
static inline bool vfinite(vec3 a) { return isfinite(a.x) && isfinite(a.y) && isfinite(a.z); }

/* a scaled by the power of two that brings its longest component into [1/2, 1): exact, and its
 * square neither overflows nor vanishes. *exponent undoes it: a = ldexp(result, *exponent). */
cold_inline vec3 vscaled(vec3 a, int *exponent)
{
    (void)frexp(fabs(vaxis(a, vlongest(a))), exponent);
    return (vec3){ldexp(a.x, -*exponent), ldexp(a.y, -*exponent), ldexp(a.z, -*exponent)};
}

/* True if the squares of a vector with this a.a lost nothing that counts to over- or underflow. */
static inline bool square_is_safe(real aa)
{
    return aa > real_smallest / (real_epsilon * real_epsilon) && aa < real_largest;
}

static inline real vlength(vec3 a)
{
    real aa = vdot(a, a);
    int e;
    if (square_is_safe(aa) || !vfinite(a) || vzero(a)) return sqrt(aa);
    a = vscaled(a, &e);  /* as exact as above: the length of 2^k a is 2^k |a| to the last bit */
    return ldexp(sqrt(vdot(a, a)), e);
}

/* Length 1 within 2.25 epsilon. Cost: one square root and one division. */
static inline vec3 vunit(vec3 a)
{
    real aa = vdot(a, a);
    if (!square_is_safe(aa)) {  /* rare: written so that a NaN comes here too */
        int e;
        if (!vfinite(a) || vzero(a)) return (vec3){0, 0, 0};
        a = vscaled(a, &e), aa = vdot(a, a);
    }
    return vscale(a, 1 / sqrt(aa));
}

/* s, t, n: orthonormal within 4 epsilon for every unit n, whatever the signs of its zeros.
 * Source: Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017, listing 3. */
fast_inline void vbasis(vec3 n, vec3 *s, vec3 *t)
{
    real sign = copysign((real)1, n.z);
    real a = -1 / (sign + n.z), b = n.x * n.y * a;
    *s = (vec3){1 + sign * n.x * n.x * a, sign * b, -sign * n.x};
    *t = (vec3){b, sign + n.y * n.y * a, -n.y};
}

/* a b - c d within 1.5 units in the last place: the rounding error of c d, which fma finds exactly,
 * is given back. The plain form loses everything when the products nearly cancel.
 * Source: Jeannerod, Louvet, Muller, "Further analysis of Kahan's algorithm", Math. Comp. 2013 */
static inline real difference_of_products(real a, real b, real c, real d)
{
    real cd = c * d;
    return fma(a, b, -cd) + fma(-c, d, cd);
}

/* a x b, each component right to 2 epsilon of itself: of nearly parallel vectors vcross keeps only
 * rounding errors. */
static inline vec3 vcross_accurate(vec3 a, vec3 b)
{
    return (vec3){difference_of_products(a.y, b.z, a.z, b.y),
                  difference_of_products(a.z, b.x, a.x, b.z),
                  difference_of_products(a.x, b.y, a.y, b.x)};
}
#endif
