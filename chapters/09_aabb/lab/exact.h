/* exact.h: rays that are hard for a slab test, and the exact answer in whole numbers; others with
 * all their digits, and the answer in twice as many.
 *
 * Coordinates of boxes, origins and directions are integers below 2^10 in amount, tmin and tmax
 * multiples of 1/64 below 2^10, or infinite: all of them floats. A plane is then met at t = n / d
 * with |n| < 2^11, 0 < d < 2^10, and n d' < n' d compares two such fractions without rounding.
 *
 *   aabb_trial c = aabb_trial_of(kind, seed, i)      the i-th box and ray of a kind
 *   aabb_exact e = exact_aabb(c.b, c.r)   is it hit, and at which t
 *   not_after(t, e.enter)                  t <= e.enter, exactly
 *   aabb_full_trial_of(kind, seed, i)      with a full mantissa (尾数): parallel, flat, edge, corner
 *   aabb_wide w = wide_aabb(c.b, c.r)      is it hit, at which t, and by how much
 *
 * Whole numbers leave the differences lo - o free of rounding. With all digits these round, too,
 * and a ray aimed at a corner passes it on this or on that side: some truly miss the box, by 1e-16
 * of the distance. wide.h is off by some 1e-31: only a gap below that is undecided, and is a hit.
 */
#ifndef AABB_EXACT_H
#define AABB_EXACT_H

#include "../../../common/numbers/wide.h"
#include "../../../common/random.h"
#include "../aabb.h"

typedef enum {
    TRIAL_PARALLEL,  /* the ray runs in a plane of the box: d_k = +-0.0 on one axis or more */
    TRIAL_FLAT,      /* one, two or three sides of length 0; aimed at the box */
    TRIAL_EDGE,      /* meets the closed box in one point of an edge */
    TRIAL_CORNER,    /* aimed at a corner: three planes at one t = m / q, m and q from 1 to 15 */
    TRIAL_CONTACT,   /* the interval ends where it enters, or begins where it leaves, or at o */
    TRIAL_ANY,       /* o anywhere, also inside; aimed anywhere, also away; any interval */
    aabb_trial_kinds
} aabb_trial_kind;

typedef struct { aabb b; ray r; } aabb_trial;
typedef struct { int64_t n, d; } aabb_fraction;  /* n / d, d > 0; or -1/0, 1/0: infinite */
typedef struct { bool hit; aabb_fraction enter; } aabb_exact;
typedef struct {
    bool hit;
    wide enter;  /* the t where it enters, or tmin */
    double gap;  /* (exit - entry) / larger amount of the two: below 0 for a miss */
} aabb_wide;

/* ---------------------------------------------------------------------------------------------- */

static inline bool fraction_less(aabb_fraction a, aabb_fraction b)
{
    return a.d == 0 && b.d == 0 ? a.n < b.n : a.n * b.d < b.n * a.d;
}

/* Of a multiple of 1/64, or of an infinity. */
static inline aabb_fraction fraction_of(real t)
{
    return isinf(t) ? (aabb_fraction){t < 0 ? -1 : 1, 0} : (aabb_fraction){(int64_t)(64 * t), 64};
}

static inline aabb_fraction fraction_quotient(int64_t n, int64_t d)
{
    return d < 0 ? (aabb_fraction){-n, -d} : (aabb_fraction){n, d};
}

static inline aabb_exact exact_aabb(aabb b, ray r)
{
    aabb_fraction enter = fraction_of(r.tmin), leave = fraction_of(r.tmax);
    bool inside = true;  /* the slabs that the ray is parallel to */
    for (int k = 0; k < 3; k++) {
        int64_t o = (int64_t)vaxis(r.o, k), d = (int64_t)vaxis(r.d, k);
        int64_t lo = (int64_t)vaxis(b.lo, k) - o, hi = (int64_t)vaxis(b.hi, k) - o;
        if (d == 0) { inside = inside && lo <= 0 && hi >= 0; continue; }
        aabb_fraction near = fraction_quotient(d < 0 ? hi : lo, d);
        aabb_fraction far = fraction_quotient(d < 0 ? lo : hi, d);
        if (fraction_less(enter, near)) enter = near;
        if (fraction_less(far, leave)) leave = far;
    }
    return (aabb_exact){inside && !fraction_less(leave, enter), enter};
}

/* True if t <= f, exactly: the product of a real and an integer below 2^10 needs 11 bits more than
 * a real has, so it is formed as a sum of two. */
static inline bool not_after(real t, aabb_fraction f)
{
    if (isinf(t) || f.d == 0) return t == -real_infinity || (f.d == 0 && f.n > 0);
    double high = (double)t * (double)f.d, low = fma((double)t, (double)f.d, -high);
    return (high - (double)f.n) + low <= 0;
}

/* ---- the trials ---- */

/* An integer in [lowest, highest]. */
static inline int random_integer(random_stream *s, int lowest, int highest)
{
    return lowest + (int)(random_next_bits(s) % (uint64_t)(highest - lowest + 1));
}

static inline vec3 random_point(random_stream *s, int lowest, int highest)
{
    int x = random_integer(s, lowest, highest), y = random_integer(s, lowest, highest);
    return vec(x, y, random_integer(s, lowest, highest));
}

static inline bool chance(random_stream *s, int in) { return random_integer(s, 1, in) == 1; }

static inline real face_of(aabb b, int k, bool upper) { return vaxis(upper ? b.hi : b.lo, k); }

/* The ray with direction q w that reaches p after t = m / q; zeros get either sign. */
static inline ray ray_reaching(vec3 p, vec3 w, int m, int q, random_stream *s)
{
    ray r = ray_from(vmadd(p, w, (real)-m), vscale(w, (real)q));
    for (int k = 0; k < 3; k++)
        if (vaxis(r.d, k) == 0) r.d = vwith(r.d, k, chance(s, 2) ? (real)0.0 : (real)-0.0);
    return r;
}

/* p moves to a face across axis k, and w turns, to enter or to leave the slab there. */
static inline void aim_at_face(aabb b, int k, bool upper, bool enters, vec3 *p, vec3 *w)
{
    real wk = 1 + fabs(vaxis(*w, k));
    *p = vwith(*p, k, face_of(b, k, upper)), *w = vwith(*w, k, upper == enters ? -wk : wk);
}

/* The interval on one side of a face: it ends where the ray enters, or begins where the ray leaves,
 * or where it starts. */
static inline ray ray_in_contact(aabb b, int k, vec3 p, vec3 w, random_stream *s)
{
    bool upper = chance(s, 2), enters = chance(s, 2);
    aim_at_face(b, k, upper, enters, &p, &w);
    int m = random_integer(s, 0, 15), q = 1 << random_integer(s, 0, 3);
    ray r = ray_reaching(p, w, m, q, s);
    *(enters ? &r.tmax : &r.tmin) = (real)m / (real)q;
    return r;
}

static inline ray ray_anywhere(vec3 p, vec3 w, int m, int q, random_stream *s)
{
    ray r = ray_reaching(chance(s, 2) ? p : random_point(s, -255, 255), w, m, q, s);
    if (chance(s, 2)) r.tmin = (real)random_integer(s, -256, 256) / 64;
    if (chance(s, 2)) r.tmax = r.tmin + (real)random_integer(s, 0, 256) / 64;
    else if (chance(s, 4)) r.tmin = -real_infinity;
    return r;
}

static inline aabb_trial aabb_trial_of(aabb_trial_kind kind, uint64_t seed, uint64_t i)
{
    random_stream s = random_start(seed, i, kind);
    int k = random_integer(&s, 0, 2), m = random_integer(&s, 1, 15), q = random_integer(&s, 1, 15);
    vec3 lo = random_point(&s, -127, 127), w = random_point(&s, -31, 31);
    aabb b = {lo, vadd(lo, random_point(&s, 1, 127))};
    if (kind == TRIAL_FLAT)
        for (int n = 0; n < 3; n++)
            if (n == k || chance(&s, 3)) b.hi = vwith(b.hi, n, vaxis(b.lo, n));
    vec3 p = b.lo;
    for (int n = 0; n < 3; n++)
        p = vwith(p, n, (real)random_integer(&s, (int)vaxis(b.lo, n), (int)vaxis(b.hi, n)));
    for (int n = 0; n < 3; n++) {
        bool upper = chance(&s, 2);
        if (kind == TRIAL_CORNER) p = vwith(p, n, face_of(b, n, upper));
        if (kind == TRIAL_PARALLEL && (n == k || chance(&s, 4)))
            p = vwith(p, n, face_of(b, n, upper)), w = vwith(w, n, 0);
    }
    if (kind == TRIAL_EDGE) {  /* along axis k: leaves one of the slabs there, enters the other */
        bool ui = chance(&s, 2), uj = chance(&s, 2);
        aim_at_face(b, (k + 1) % 3, ui, false, &p, &w);
        aim_at_face(b, (k + 2) % 3, uj, true, &p, &w);
    }
    if (vzero(w)) w = vwith(w, (k + 1) % 3, 1);
    if (kind == TRIAL_CONTACT) return (aabb_trial){b, ray_in_contact(b, k, p, w, &s)};
    if (kind == TRIAL_ANY) return (aabb_trial){b, ray_anywhere(p, w, m, q, &s)};
    return (aabb_trial){b, ray_reaching(p, w, m, q, &s)};
}

/* ---- all digits ---- */

static inline wide wide_time(real at, real o, real d)
{
    return wide_div(wide_sum((double)at, -(double)o), wide_of((double)d));
}

/* Finite boxes; tmin finite, tmax maybe infinite. */
static inline aabb_wide wide_aabb(aabb b, ray r)
{
    wide enter = wide_of((double)r.tmin), leave = wide_of((double)r.tmax);
    bool inside = true;
    for (int k = 0; k < 3; k++) {
        real lo = vaxis(b.lo, k), hi = vaxis(b.hi, k), o = vaxis(r.o, k), d = vaxis(r.d, k);
        if (d == 0) { inside = inside && lo <= o && o <= hi; continue; }
        wide near = wide_time(d < 0 ? hi : lo, o, d), far = wide_time(d < 0 ? lo : hi, o, d);
        if (wide_sign(wide_sub(near, enter)) > 0) enter = near;
        if (isinf(leave.hi) || wide_sign(wide_sub(leave, far)) > 0) leave = far;
    }
    double gap = isinf(leave.hi) ? 1 : wide_value(wide_sub(leave, enter));
    double size = fmax(fabs(enter.hi), fabs(leave.hi));
    gap = gap == 0 || isinf(size) ? gap : gap / size;
    return (aabb_wide){inside && gap >= -1e-30, enter, gap};
}

/* In [-1, 1]. */
static inline aabb_trial aabb_full_trial_of(aabb_trial_kind kind, uint64_t seed, uint64_t i)
{
    random_stream s = random_start(seed, i, 16 + kind);
    real size = pow((real)1000, 2 * random_next(&s) - 1);  /* the whole from 1/1000 to 1000 */
    vec3 lo = vscale(random_in_cube(&s, 1), size), side = vscale(random_in_cube(&s, 1), size / 2);
    aabb b = {lo, vadd(lo, (vec3){fabs(side.x), fabs(side.y), fabs(side.z)})};
    vec3 o = vscale(random_in_cube(&s, 1), 4 * size), p = lo;
    int k = random_integer(&s, 0, 2);
    if (kind == TRIAL_FLAT) b.hi = vwith(b.hi, k, vaxis(b.lo, k));
    for (int n = 0; n < 3; n++) {
        real u = random_next(&s), l = vaxis(b.lo, n), h = vaxis(b.hi, n);
        bool on_face = kind == TRIAL_CORNER || (kind == TRIAL_EDGE && n != k);
        if (kind == TRIAL_PARALLEL) on_face = n == k;
        p = vwith(p, n, on_face ? (u < (real)0.5 ? l : h) : l + u * (h - l));
    }
    ray r = ray_from(o, vscale(vsub(p, o), (real)0.25 + random_next(&s)));
    if (kind == TRIAL_PARALLEL) {
        r.o = vwith(r.o, k, vaxis(p, k));
        r.d = vwith(r.d, k, chance(&s, 2) ? (real)0.0 : (real)-0.0);
    }
    return (aabb_trial){b, r};
}

#endif
