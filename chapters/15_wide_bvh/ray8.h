/* ray8.h: a ray in float, and what float owes: the bounds that make eight triangles at once safe.
 *
 *   bvh8_ray_of(&w, &r, leaky, &q)        the ray in the frame of the tree; once a ray
 *   bvh8_before(&q, t), bvh8_limit(&q, t) t in the frame, rather too small, rather too large
 *   bvh8_exactly(&w, block, k, &r, &shear, &h)   triangle k of a block in `real`: the test of 04
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
    size_t near[3], far[3];                       /* rows, in bytes: where it enters and leaves */
    size_t kx, ky, kz;                            /* rows of a corner, in the order of 04 */
    float sx, sy, cx, cy, oz, sz;
    float around, tail;
    float sure_min, sure_max, limit;              /* of the ray's interval, as limit and tmin */
    double scale, shift, slack;                   /* t in the frame: t scale - shift, +- slack */
} bvh8_ray;

/* ---------------------------------------------------------------------------------------------- */

#define bvh8_row(rows, offset) (*(const eight *)((const char *)(rows) + (offset)))

/* x as a float, and a little less: rounded once, twice in float, and this product. */
static inline float bvh8_down(double x)
{
    float f = (float)(x < 1e38 ? x : 1e38);
    return f - fabsf(f) * 0x1p-22f;
}

/* In double: in float the scale of a small tree may overflow. */
static inline float bvh8_before(const bvh8_ray *q, real t)
{
    return bvh8_down((double)t * q->scale - q->shift - q->slack);
}

/* A far origin was moved by `shift`: the interval's end moves with it, as its beginning does. */
static inline float bvh8_limit(const bvh8_ray *q, real t)
{
    return -bvh8_down(q->shift - (double)t * q->scale - q->slack);
}

/* As vlongest, without a branch: which axis it is is a toss. */
static inline unsigned bvh8_longest(vec3 d)
{
    real x = fabs(d.x), y = fabs(d.y), z = fabs(d.z), most = x >= y ? x : y;
    unsigned second = !(x >= y), third = !(most >= z);
    return 2 * third | (second & ~third);
}

__attribute__((always_inline))
static inline void bvh8_axis(bvh8_ray *q, unsigned k, float o, float d, float delta)
{
    uint32_t down;
    float i = 1 / d;
    i = i < 0x1p60f ? i : 0x1p60f, i = i > -0x1p60f ? i : -0x1p60f;
    memcpy(&down, &i, sizeof down);
    down = (down >> 31) * 3;
    q->inverse[k] = i;
    q->near[k] = (k + down) * sizeof(eight), q->far[k] = (k + 3 - down) * sizeof(eight);
    delta = copysignf(delta, i);
    q->near_o[k] = (o + delta) * -i;
    q->far_o[k] = (o - delta) * -i;
}

/* What few rays need. d gets a length near 1 if it is beyond 2^+-20; t changes by that factor, and
 * by the tree's. A far origin moves along the ray to where it is nearest to 0: then S is small
 * again, and what float can tell apart with it. That place is off by 3 eps of the way, as is t. */
__attribute__((noinline, cold))
static void bvh8_ray_moved(bvh8_ray *q, vec3 *o, vec3 *d, real way)
{
    real s = box_ray_scale(fabs(vaxis(*d, vlongest(*d))));
    *d = vscale(*d, 1 / s), q->scale *= (double)s;
    if (way > 8) {
        real t = -vdot(*o, *d) / vdot(*d, *d);
        if (fabs(t) <= real_largest) *o = vmadd(*o, *d, t), q->shift = (double)t;
    }
}

__attribute__((always_inline))
static inline void bvh8_ray_of(const bvh8 *w, const ray *r, bool leaky, bvh8_ray *q)
{
    unsigned kz = bvh8_longest(r->d), kx = (0x09 >> 2 * kz) & 3, ky = (0x12 >> 2 * kz) & 3;
    vec3 origin = bvh8_into(w, r->o), d = r->d;
    real way = real_max(real_max(real_max(fabs(origin.x), fabs(origin.y)), fabs(origin.z)), 1);
    real longest = real_max(real_max(fabs(d.x), fabs(d.y)), fabs(d.z));
    q->scale = (double)w->scale, q->shift = 0;
    if (way > 8 || longest < (real)0x1p-20 || longest > (real)0x1p20)
        bvh8_ray_moved(q, &origin, &d, way);
    float o[3] = {(float)origin.x, (float)origin.y, (float)origin.z};
    float along[3] = {(float)d.x, (float)d.y, (float)d.z};
    float owed = (float)(way * real_epsilon);
    float size = float_max(float_max(fabsf(o[0]), fabsf(o[1])), float_max(fabsf(o[2]), 1));
    float delta = leaky ? 0 : size * 0x1p-20f + 512 * owed;                          /* (15.6) */
    q->slack = (double)real_smallest * (1 + q->scale) + 0x1p-100  /* no subnormal: they are slow */
        + 4 * (double)real_epsilon * fabs(q->shift);
    q->tmin = bvh8_before(q, r->tmin);
    q->limit = bvh8_limit(q, r->tmax);
    q->sure_min = bvh8_limit(q, r->tmin);
    q->sure_max = bvh8_before(q, r->tmax);
    bvh8_axis(q, 0, o[0], along[0], delta);
    bvh8_axis(q, 1, o[1], along[1], delta);
    bvh8_axis(q, 2, o[2], along[2], delta);
    q->kx = kx * sizeof(eight), q->ky = ky * sizeof(eight), q->kz = kz * sizeof(eight);
    q->oz = o[kz], q->sz = q->inverse[kz];
    q->sx = -along[kx] * q->sz, q->sy = -along[ky] * q->sz;
    q->cx = o[kx] + q->sx * q->oz, q->cy = o[ky] + q->sy * q->oz;
    q->around = size * 0x1.8p-20f + 16 * owed;                                       /* (15.7) */
    q->tail = (size * 0x1p-19f + 300 * owed) * fabsf(q->sz);
}

/* How often this thread asked in `real`: for whoever wants to count. */
static _Thread_local size_t bvh8_asked;

/* Building has asked for the area, so the second half of 04's test needn't. */
static inline bool bvh8_exactly(const bvh8 *w, const bvh8_block *block, int k, const ray *r,
                                const ray_shear *s, hit *out)
{
    triangle t;
    bvh8_asked++;
    if (w->exact) {
        const float *c = (const float *)block->corner + k;
        t.a = bvh8_back(w, c[0], c[8], c[16]);
        t.b = bvh8_back(w, c[24], c[32], c[40]);
        t.c = bvh8_back(w, c[48], c[56], c[64]);
    } else t = mesh_triangle(w->x.m, block->index[k]);
    vec3 a = shear_corner(&t.a, s), b = shear_corner(&t.b, s), c = shear_corner(&t.c, s);
    vec3 e = {c.x * b.y - c.y * b.x, a.x * c.y - a.y * c.x, b.x * a.y - b.y * a.x};
    if (signs_differ(e.x, e.y, e.z) || !shear_meets(a, b, c, e, s, *r, out)) return false;
    out->shape = block->index[k];
    return true;
}

#endif
