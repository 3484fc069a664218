/* mantissa.h: hard rays with all their digits, and the answer in numbers of twice the precision.
 *
 * The integers of exact.h leave the differences lo - o free of rounding. Here all numbers have a
 * full mantissa (尾数), so that they round, too, and a ray aimed at a corner passes it on this or on
 * that side: some such rays truly miss the box, by 1e-16 of the distance.
 *
 *   aabb_trial c = aabb_full_trial_of(kind, seed, i)   kind: TRIAL_PARALLEL, TRIAL_FLAT, TRIAL_EDGE
 *                                            or TRIAL_CORNER
 *   aabb_wide w = wide_aabb(c.b, c.r)      is it hit, at which t, and by how much
 *
 * wide.h is off by some 1e-31: only a gap below that is undecided, and counts as a hit.
 */
#ifndef AABB_MANTISSA_H
#define AABB_MANTISSA_H

#include "../../../common/numbers/wide.h"
#include "exact.h"

typedef struct {
    bool hit;
    wide enter;  /* the t where it enters, or tmin */
    double gap;  /* (exit - entry) / larger amount of the two: below 0 for a miss */
} aabb_wide;

/* ---------------------------------------------------------------------------------------------- */

static inline wide wide_time(real at, real o, real d)
{
    return wide_div(wide_sub(wide_of((double)at), wide_of((double)o)), wide_of((double)d));
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
