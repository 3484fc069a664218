/* balls_lanes.h: up to 64 balls, all asked at once.
 *
 *   A tree asks a few boxes one after another, and each waits for the one before. A loop over all
 *   balls without a branch, in float, becomes eight wide, and is done sooner.
 *
 *   ball_lanes a;
 *   if (ball_lanes_fill(s, n, &a)) ..     false: more than 64 balls, or none
 *   bool ball_lanes_hit(&a, s, r, from, &best)     closest hit; d unit, tmin >= 0; `from` is left
 *                                                  out (no_shape: none)
 *
 *        f = o - c,  b = -d.f,  k = f.f - R^2,  D = b^2 - k                   as in 03, |d| = 1
 *        missed       D < 0; or k > 0 and b < 0: outside, and behind
 *        t0 = k / (b + sqrt(D)) >= k / (b + min(b, R))       where it may be met at best    (19.11)
 *
 * The loop only sorts out what can't be met; ball_hit, the answer of 03, decides on what is left,
 * the nearest (19.11) first, until one is hit before the next could be. Sorting out must not lose a
 * hit, so its rounding is paid for in advance. U = 2^-24, S: sum of the largest coordinates of o
 * and c, and R. f is off by 2 U S a component (o and c are rounded), b by 12 U S, k by 25 U S^2,
 * b^2 by 45 U S^2; d, unit within 5 U where real is float, makes 30 U S^2 more; sums 10: m = 256 U
 * S^2 for k and D, e = 16 U S for b. What overflows is a NaN, and stays in.
 */
#ifndef WHITTED_BALLS_LANES_H
#define WHITTED_BALLS_LANES_H

#include "ball_hit.h"

enum { ball_lanes_most = 64, ball_lanes_wide = 8 };

typedef struct {
    float x[ball_lanes_most], y[ball_lanes_most], z[ball_lanes_most];  /* c */
    float r[ball_lanes_most], size[ball_lanes_most];  /* R; largest coordinate of c, and R */
    int32_t n, lanes;                                 /* lanes: a multiple of ball_lanes_wide */
} ball_lanes;

#define ball_lanes_none UINT32_MAX  /* a key above all others */

/* ---------------------------------------------------------------------------------------------- */

static inline real ball_lanes_reach(vec3 p)
{
    return real_max(real_max(fabs(p.x), fabs(p.y)), fabs(p.z));
}

static inline bool ball_lanes_fill(const sphere *s, size_t n, ball_lanes *out)
{
    *out = (ball_lanes){.n = 0};
    if (n == 0 || n > ball_lanes_most) return false;
    for (size_t i = 0; i < n; i++) {
        out->x[i] = (float)s[i].c.x, out->y[i] = (float)s[i].c.y, out->z[i] = (float)s[i].c.z;
        out->r[i] = (float)s[i].r, out->size[i] = (float)(ball_lanes_reach(s[i].c) + s[i].r);
    }
    out->n = (int32_t)n;
    out->lanes = (out->n + ball_lanes_wide - 1) / ball_lanes_wide * ball_lanes_wide;
    return true;
}

/* Key: (19.11) as the bits of a float, the lane in its six lowest; ball_lanes_none: sorted out. */
__attribute__((always_inline))
static inline void ball_lanes_keys(const ball_lanes *a, ray r, uint32_t from,
                                   uint32_t key[ball_lanes_most])
{
    float ox = (float)r.o.x, oy = (float)r.o.y, oz = (float)r.o.z;
    float dx = (float)r.d.x, dy = (float)r.d.y, dz = (float)r.d.z;
    float reach = (float)ball_lanes_reach(r.o);
    int32_t first = 0, skip = (int32_t)from;
    do for (int32_t i = first; i < first + ball_lanes_wide; i++) {  /* a fixed count: no rest */
        float fx = ox - a->x[i], fy = oy - a->y[i], fz = oz - a->z[i], R = a->r[i];
        float S = a->size[i] + reach, e = S * 0x1p-20f, m = S * S * 0x1p-16f;
        float b = -(dx * fx + dy * fy + dz * fz), k = fx * fx + fy * fy + fz * fz - R * R;
        float D = b * b - k, along = b > 0 ? b : 0, half = along < R ? along : R;
        float out = k - m, t = (out > 0 ? out : 0) / (along + half + (e + e) + 0x1p-100f);
        uint32_t bits;
        memcpy(&bits, &t, sizeof bits);
        uint32_t in = (uint32_t)(((D < -m) ^ 1) & (((b < -e) & (out > 0)) ^ 1) & (i < a->n)
                                 & (i != skip));
        key[i] = ((bits & ~63u) | (uint32_t)i) | (in - 1);
    } while ((first += ball_lanes_wide) < a->lanes);
}

/* The least key above `last`; UINT32_MAX: the least. Differences wrap: those not above become
 * large. Wide by hand: of the plain loop gcc makes a reduction for each block. */
typedef uint32_t ball_lanes_block __attribute__((vector_size(4 * ball_lanes_wide)));

__attribute__((always_inline))
static inline uint32_t ball_lanes_next(const ball_lanes *a, const uint32_t key[ball_lanes_most],
                                       uint32_t last)
{
    ball_lanes_block low, k;
    memcpy(&low, key, sizeof low);
    low -= last + 1;
    for (int32_t i = ball_lanes_wide; i < a->lanes; i += ball_lanes_wide) {
        memcpy(&k, key + i, sizeof k);
        k -= last + 1;
        ball_lanes_block less = (ball_lanes_block)(k < low);
        low = (k & less) | (low & ~less);
    }
    uint32_t best = low[0];
    for (int j = 1; j < ball_lanes_wide; j++) best = low[j] < best ? low[j] : best;
    return best > ball_lanes_none - (last + 1) ? ball_lanes_none : best + last + 1;  /* wrapped */
}

/* Lower bound on t that a key stands for; 2^-20 for the rounding of (19.11). */
__attribute__((always_inline))
static inline real ball_lanes_bound(uint32_t key)
{
    float t;
    key &= ~63u;
    memcpy(&t, &key, sizeof t);
    return (real)t * (1 - (real)0x1p-20);
}

__attribute__((always_inline))
static inline bool ball_lanes_hit(const ball_lanes *a, const sphere *s, ray r, uint32_t from,
                                  hit *best)
{
    _Alignas(64) uint32_t key[ball_lanes_most];
    hit h;
    *best = hit_none;
    ball_lanes_keys(a, r, from, key);
    for (uint32_t k = ball_lanes_next(a, key, UINT32_MAX);
         k != ball_lanes_none && ball_lanes_bound(k) <= r.tmax; k = ball_lanes_next(a, key, k)) {
        if (!ball_hit(&s[k & 63], &r, &h) || (h.shape = k & 63, !hit_before(h, *best))) continue;
        *best = h, r.tmax = h.t;
    }
    return best->shape != no_shape;
}

#endif
