/* ray8.h: a ray in float, and what float owes: the bounds that make eight triangles at once safe.
 *
 *   bvh8_ray_of(&w, r, leaky, &q)         the ray in the frame of the tree; once a ray
 *   bvh8_before(&q, t), bvh8_limit(&q, t) t in the frame, rather too small, rather too large
 *   bvh8_exactly(&w, block, k, r, &h)     triangle k of a block in `real`, by the test of 04
 *
 * u = 2^-24; S is the largest of 1 and the origin's coordinates, all in the frame. Corners are at
 * most 1 there, distances to them at most 2 S. eps is that of `real`.
 *
 *   boxes      t = plane / d - (o +- delta) / d. Origin, its shift, 1 / d, the product and the sum
 *              are off as if the plane were moved by 10 u S; items may be found 256 eps times 2 S
 *              outside their boxes (14): delta = (16 u + 512 eps) S                       (15.6)
 *   corners    x = ax - sx az - cx, as seen along the ray (4.9), is off by 20 u S: corners u + u,
 *              slope 6 u, its product and sum 3 u, cx = ox - sx oz 5 u, the sum 4 u. What 04 does
 *              in `real` is off by less than 16 eps S: around = (24 u + 16 eps) S         (15.7)
 *   edges      e = ax by - ay bx, with |x|, |y| <= m: the corners' errors are multiplied by four
 *              sides, two products and a sum round, here and in 04:
 *              |error of e| <= 4 m around + 2 around^2 + 16 u m^2 = bound                 (15.8)
 *              e > bound: 04 finds the same sign. Two surely different signs: no hit. Three equal
 *              ones: a hit, wherever t is
 *   t          a weighted mean of three depths that differ by at most `spread`; weights are off by
 *              bound / |det|: 4 bound spread / |det|, and the rest of the arithmetic in both
 *              tests: tail = (32 u + 300 eps) S; times 1 / |dz|                           (15.9)
 *
 * Where a number overflowed to infinity or NaN, no comparison with a bound is true: in doubt.
 * 1 / d_k is at most 2^60: a ray so nearly along the wall moves by less than delta on it.
 */
#ifndef WIDE_RAY8_H
#define WIDE_RAY8_H

#include "tree8.h"

typedef struct {
    float near_o[3], far_o[3], inverse[3], tmin;  /* t of a plane: plane inverse + near_o */
    size_t near[3], far[3];                       /* rows of the sides it enters and leaves by */
    size_t kx, ky, kz;                            /* rows of a corner, in the order of 04 */
    float sx, sy, cx, cy, oz, sz;
    float around, tail;
    float sure_min, sure_max, limit;              /* of the ray's interval, as limit and tmin */
    double scale, shift, slack;                   /* t in the frame: t scale - shift, +- slack */
} bvh8_ray;

/* ---------------------------------------------------------------------------------------------- */

/* In double: in float the scale of a small tree may overflow. */
static inline float bvh8_before(const bvh8_ray *q, real t)
{
    double x = (double)t * q->scale - q->shift;
    double more = real_is_float && fabs(x) < HUGE_VAL ? fabs(x) * 0x1p-23 : 0;
    return float_below((real)(x - q->slack - more));
}

static inline float bvh8_limit(const bvh8_ray *q, real t) { return -bvh8_before(q, -t); }

/* d gets a length near 1 if it is beyond 2^+-20; t changes by that factor, and by the tree's. A far
 * origin moves along the ray to where it is nearest to 0: then S is small again, and what float can
 * tell apart with it. That place is off by 3 eps of the way, as is t. */
__attribute__((always_inline))
static inline void bvh8_ray_of(const bvh8 *w, ray r, bool leaky, bvh8_ray *q)
{
    static const int8_t next[5] = {0, 1, 2, 0, 1};  /* which axis is longest is chance: no branch */
    int kz = vlongest(r.d), kx = next[kz + 1], ky = next[kz + 2];
    real s = box_ray_scale(fabs(vaxis(r.d, kz)));
    float most = 0x1p60f;
    vec3 origin = bvh8_into(w, r.o);
    real way = real_max(real_max(fabs(origin.x), fabs(origin.y)), real_max(fabs(origin.z), 1));
    q->scale = (double)w->scale, q->shift = 0;
    if (s != 1) r.d = vscale(r.d, 1 / s), q->scale *= (double)s;
    if (way > 8) {
        real t = -vdot(origin, r.d) / vdot(r.d, r.d);
        if (fabs(t) <= real_largest) origin = vmadd(origin, r.d, t), q->shift = (double)t;
    }
    float owed = (float)(way * real_epsilon);
    const float o[3] = {(float)origin.x, (float)origin.y, (float)origin.z};
    const float d[3] = {(float)r.d.x, (float)r.d.y, (float)r.d.z};
    float size = float_max(float_max(fabsf(o[0]), 1), float_max(fabsf(o[1]), fabsf(o[2])));
    float delta = leaky ? 0 : size * 0x1p-20f + 512 * owed;                          /* (15.6) */
    q->slack = (double)real_smallest * (1 + q->scale) + 0x1p-100  /* no subnormal: they are slow */
        + 4 * (double)real_epsilon * fabs(q->shift);
    q->tmin = bvh8_before(q, r.tmin);
    q->limit = bvh8_limit(q, r.tmax);
    q->sure_min = bvh8_limit(q, r.tmin);
    q->sure_max = bvh8_before(q, r.tmax);
    for (int k = 0; k < 3; k++) {
        float i = float_max(float_min(1 / d[k], most), -most), shift = copysignf(delta, i);
        size_t down = i < 0 ? 3 : 0;
        q->inverse[k] = i;
        q->near[k] = (size_t)k + down, q->far[k] = (size_t)k + 3 - down;
        q->near_o[k] = (o[k] + shift) * -i;
        q->far_o[k] = (o[k] - shift) * -i;
    }
    q->kx = (size_t)kx, q->ky = (size_t)ky, q->kz = (size_t)kz;
    q->oz = o[kz], q->sz = q->inverse[kz];
    q->sx = -d[kx] * q->sz, q->sy = -d[ky] * q->sz;
    q->cx = o[kx] + q->sx * q->oz, q->cy = o[ky] + q->sy * q->oz;
    q->around = size * 0x1.8p-20f + 16 * owed;                                       /* (15.7) */
    q->tail = (size * 0x1p-19f + 300 * owed) * fabsf(q->sz);
}

/* How often this thread asked in `real`: for whoever wants to count. */
static _Thread_local size_t bvh8_asked;

/* Building has asked for the area, so the second half of 04's test needn't. */
static inline bool bvh8_exactly(const bvh8 *w, const bvh8_block *block, int k, ray r, hit *out)
{
    ray_shear s = shear_of(r);
    triangle t;
    bvh8_asked++;
    if (w->exact) {
        const float *c = (const float *)block->corner + k;
        t.a = bvh8_back(w, c[0], c[8], c[16]);
        t.b = bvh8_back(w, c[24], c[32], c[40]);
        t.c = bvh8_back(w, c[48], c[56], c[64]);
    } else t = mesh_triangle(w->x.m, block->index[k]);
    vec3 a = shear_corner(&t.a, &s), b = shear_corner(&t.b, &s), c = shear_corner(&t.c, &s);
    vec3 e = {c.x * b.y - c.y * b.x, a.x * c.y - a.y * c.x, b.x * a.y - b.y * a.x};
    if (signs_differ(e.x, e.y, e.z) || !shear_meets(a, b, c, e, &s, r, out)) return false;
    out->shape = block->index[k];
    return true;
}

#endif
