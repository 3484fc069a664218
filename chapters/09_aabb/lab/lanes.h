/* lanes.h: one ray against four or eight boxes at once (单指令多数据, SIMD).
 *
 *      side     box 0   1   2   3   4   5   6   7     A processor adds eight floats in the time
 *   0  lo.x       .   .   .   .   .   .   .   .       that one takes. So boxes lie side by side, a
 *   1  lo.y       .   .   .   .   .   .   .   .       row for each plane (structure of arrays), and
 *   2  lo.z       .   .   .   .   .   .   .   .       the slab test is a loop along the rows, no
 *   3  hi.x       .   .   .   .   .   .   .   .       branches: plain C, of which compilers make
 *   ...                                               vector instructions.
 *
 *   aabb8 group;  lanes_empty(group.side[0], 8);       eight boxes that no ray meets
 *   lanes_put(group.side[0], 8, k, b);      box k [0..7], rounded outwards to float
 *   aabb_lanes l = aabb_lanes_of(r);        once a ray
 *   unsigned mask = aabb8_hit(&group, &l, t_enter);    bit k: box k is hit, not before the float
 *                                           t_enter[k]; that of a box that is missed says nothing
 *   aabb4, aabb4_hit                        four boxes; 24 bytes a box in both
 *
 * As in aabb.h: never a false negative, and t_enter[k] is never behind the exact one. A float has
 * 24 bits: what passes a box by some 1e-6 of its distance, or of the coordinates, may be reported.
 * Coordinates up to 1e38; a component of d whose inverse is no normal float says nothing.
 *
 * Source: I. Wald, C. Benthin, S. Boulos, "Getting Rid of Packets", IRT 2008 (boxes side by side).
 */
#ifndef AABB_LANES_H
#define AABB_LANES_H

#include "../../../common/numbers/float_round.h"
#include "../aabb.h"

typedef struct { float side[6][4]; } aabb4;
typedef struct { float side[6][8]; } aabb8;

typedef struct {
    float inverse[3];              /* 1 / d_k; +-infinity for 0; NaN: this axis says nothing */
    float enter_o[3], leave_o[3];  /* o_k, rounded so that entries come early, and exits late */
    int enter[3], leave[3];        /* rows of `side` */
    float tmin, tmax;
} aabb_lanes;

/* ---------------------------------------------------------------------------------------------- */

static inline aabb_lanes aabb_lanes_of(ray r)
{
    aabb_lanes l = {.tmin = float_below(r.tmin), .tmax = float_above(r.tmax)};
    for (int k = 0; k < 3; k++) {
        real d = vaxis(r.d, k), o = vaxis(r.o, k);
        float i = (float)(1 / d);
        bool down = i < 0;
        l.inverse[k] = d == 0 || isnormal(i) ? i : NAN;
        l.enter_o[k] = down ? float_below(o) : float_above(o);
        l.leave_o[k] = down ? float_above(o) : float_below(o);
        l.enter[k] = down ? k + 3 : k, l.leave[k] = down ? k : k + 3;
    }
    return l;
}

/* As aabb_hit_inverse, for a row at a time, with u = 2^-24. Rounded are the difference, the inverse
 * and the product: 3 u for each t, and one more u for the product that pads: 7 u < pad = 8 u. A NaN
 * comes as the first argument, and loses. n is a constant where this is inlined; gcc would unroll
 * so short a loop before it looks for vectors. */
fast_inline unsigned lanes_hit(const float *side, int n, aabb_lanes l, float *restrict t_enter)
{
    const float pad = 4 * FLT_EPSILON;
    const float *ax = side + n * l.enter[0], *bx = side + n * l.leave[0];
    const float *ay = side + n * l.enter[1], *by = side + n * l.leave[1];
    const float *az = side + n * l.enter[2], *bz = side + n * l.leave[2];
    static const unsigned bit[8] = {1, 2, 4, 8, 16, 32, 64, 128};
    unsigned mask = 0;
#pragma GCC unroll 1
    for (int k = 0; k < n; k++) {
        float t0 = float_max((ax[k] - l.enter_o[0]) * l.inverse[0], l.tmin);
        float t1 = float_min((bx[k] - l.leave_o[0]) * l.inverse[0], l.tmax);
        t0 = float_max((ay[k] - l.enter_o[1]) * l.inverse[1], t0);
        t1 = float_min((by[k] - l.leave_o[1]) * l.inverse[1], t1);
        t0 = float_max((az[k] - l.enter_o[2]) * l.inverse[2], t0);
        t1 = float_min((bz[k] - l.leave_o[2]) * l.inverse[2], t1);
        t0 = float_min(t0 * (1 - pad), t0 * (1 + pad)) - FLT_MIN;
        t_enter[k] = t0;
        mask |= bit[k] & -(unsigned)(t0 <= t1);
    }
    return mask;
}

static inline unsigned aabb4_hit(const aabb4 *b, const aabb_lanes *l, float t_enter[4])
{
    return lanes_hit(b->side[0], 4, *l, t_enter);
}

static inline unsigned aabb8_hit(const aabb8 *b, const aabb_lanes *l, float t_enter[8])
{
    return lanes_hit(b->side[0], 8, *l, t_enter);
}

static inline void lanes_put(float *side, int n, int k, aabb b)
{
    for (int a = 0; a < 3; a++) {
        side[n * a + k] = float_below(vaxis(b.lo, a));
        side[n * (a + 3) + k] = float_above(vaxis(b.hi, a));
    }
}

static inline void lanes_empty(float *side, int n)
{
    for (int k = 0; k < n; k++) lanes_put(side, n, k, aabb_empty());
}

#endif
