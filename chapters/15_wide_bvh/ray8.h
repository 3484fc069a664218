/* ray8.h: a ray in float, and what float owes: the bounds that make eight triangles at once safe.
 *
 *   bvh8_ray_of(&w, &r, &skip, &q)        the ray in the frame of the tree; once a ray
 *   bvh8_before(&q, t), bvh8_limit(&q, t) t in the frame, rather too small, rather too large
 *   bvh8_settle(&w, &q)                   asks in `real` what was written down: the test of 04
 *
 * u = 2^-24; S is the largest of 1 and the origin's coordinates, all in the frame. Corners are at
 * most 1 there, distances to them at most 2 S. eps is that of `real`.
 *
 *   boxes      t = plane / d - o / d -+ delta / |d|. Origin, its shift, 1 / d, the product and the
 *              sum are off as if the plane were moved by 10 u S; items may be found 256 eps times
 *              2 S outside their boxes (14): delta = (16 u + 512 eps) S                   (15.6)
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

enum { bvh8_most_doubts = 32 };
typedef struct { const bvh8_block *block; int lane; float first; } bvh8_doubt;

typedef struct {
    float near_o[3], far_o[3], inverse[3];        /* t of a plane: plane inverse + near_o */
    size_t near[3], far[3];                       /* rows, in bytes: where it enters and leaves */
    size_t kx, ky, kz;                            /* rows of a corner, in the order of 04 */
    float sx, sy, cx, cy, oz, sz, around, tail;
    float tmin, limit, sure_min, sure_max;        /* its interval, and what surely lies in it */
    double scale, shift, slack;                   /* t in the frame: t scale - shift, +- slack */
    ray *r;                                       /* tmax is the t of `best` */
    const bvh8_skip *skip;
    hit best;                                     /* of what was asked in `real` */
    int doubts;
    bvh8_doubt doubt[bvh8_most_doubts];           /* what was not, and begins at `first` */
    bool sheared;
    ray_shear shear;                              /* of r, once it is asked for: balls don't */
} bvh8_ray;

/* ---------------------------------------------------------------------------------------------- */

#define bvh8_row(rows, offset) (*(const eight *)((const char *)(rows) + (offset)))

static inline uint32_t float_bits(float x)
{
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

/* x as a float, and a little less: rounded once, twice in float, and this product. */
static inline float bvh8_down(double x)
{
    float f = float_min((float)x, FLT_MAX);
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
static inline void bvh8_ray_of(const bvh8 *w, ray *r, const bvh8_skip *skip, bvh8_ray *q)
{
    int kz = vlongest(r->d), kx = kz == 2 ? 0 : kz + 1, ky = 3 - kx - kz;
    vec3 at = bvh8_into(w, r->o), d = r->d;
    real way = real_max(real_max(real_max(fabs(at.x), fabs(at.y)), fabs(at.z)), 1);
    real longest = fabs(vaxis(d, kz));
    q->r = r, q->skip = skip, q->best = hit_none, q->sheared = false, q->doubts = 0;
    q->scale = (double)w->scale, q->shift = 0;
    if (way > 8 || longest < (real)0x1p-20 || longest > (real)0x1p20)
        bvh8_ray_moved(q, &at, &d, way);
    q->slack = (double)real_smallest * (1 + q->scale) + 0x1p-100  /* no subnormal: they are slow */
        + 4 * (double)real_epsilon * fabs(q->shift);
    q->tmin = bvh8_before(q, r->tmin), q->limit = bvh8_limit(q, r->tmax);
    q->sure_min = bvh8_limit(q, r->tmin), q->sure_max = bvh8_before(q, r->tmax);
    float o[3] = {(float)at.x, (float)at.y, (float)at.z}, owed = (float)(way * real_epsilon);
    float along[3] = {(float)d.x, (float)d.y, (float)d.z};
    float size = float_max(float_max(fabsf(o[0]), fabsf(o[1])), float_max(fabsf(o[2]), 1));
    float delta = size * 0x1p-20f + 512 * owed;                                      /* (15.6) */
    EIGHT_UNROLL
    for (unsigned k = 0; k < 3; k++) {
        float i = float_max(float_min(1 / along[k], 0x1p60f), -0x1p60f);
        float t = o[k] * i, error = fabsf(i) * delta;
        q->inverse[k] = i, q->near_o[k] = -t - error, q->far_o[k] = error - t;
        q->near[k] = sizeof(eight) * (k + 3 * (float_bits(i) >> 31));
        q->far[k] = sizeof(eight) * (2 * k + 3) - q->near[k];
    }
    q->kx = sizeof(eight) * (size_t)kx, q->ky = sizeof(eight) * (size_t)ky;
    q->kz = sizeof(eight) * (size_t)kz, q->oz = o[kz], q->sz = q->inverse[kz];
    q->sx = -along[kx] * q->sz, q->sy = -along[ky] * q->sz;
    q->cx = o[kx] + q->sx * q->oz, q->cy = o[ky] + q->sy * q->oz;
    q->around = size * 0x1.8p-20f + 16 * owed;                                       /* (15.7) */
    q->tail = (size * 0x1p-19f + 300 * owed) * fabsf(q->sz);
}

/* Children onto the stack, the nearest on top: `mask` of them, entered at `enter`, not before 0. A
 * child is one whole number: the bits of t, which rise with t, and then its own. */
__attribute__((always_inline))
static inline int bvh8_push(const bvh8_node *n, unsigned mask, const eight *enter,
                            uint64_t *stack, int top)
{
    uint32_t bits[8];
    int base = top, k = __builtin_ctz(mask);
    memcpy(bits, enter, sizeof bits);
    uint64_t near = (uint64_t)bits[k] << 32 | n->child[k];
    while (mask &= mask - 1) {
        k = __builtin_ctz(mask);
        uint64_t next = (uint64_t)bits[k] << 32 | n->child[k];
        uint64_t far = next < near ? near : next;  /* without a branch, and mostly that is all */
        near = next < near ? next : near;
        int j = top++;
        for (; j > base && stack[j - 1] < far; j--) stack[j] = stack[j - 1];
        stack[j] = far;
    }
    stack[top++] = near;
    return top;
}

/* ---------------------------------------------------------------------------------------------- */

static inline const ray_shear *bvh8_shear(bvh8_ray *q)
{
    if (!q->sheared) q->shear = shear_of(*q->r), q->sheared = true;
    return &q->shear;
}

/* Field by field: what is copied as a whole right after it was written waits for all of it. */
static inline void bvh8_keep(bvh8_ray *q, hit h, uint32_t i)
{
    h.shape = i;
    if (!hit_before(h, q->best)) return;
    q->best = (hit){h.t, h.u, h.v, i}, q->r->tmax = h.t, q->limit = bvh8_limit(q, h.t);
}

/* How often this thread asked in `real`: for whoever wants to count. */
static _Thread_local size_t bvh8_asked;

/* Building has asked for the area, so the second half of 04's test needn't. */
static inline bool bvh8_exactly(const bvh8 *w, const bvh8_doubt *d, bvh8_ray *q, hit *out)
{
    const float *c = (const float *)d->block->corner + d->lane;
    const ray_shear *s = bvh8_shear(q);
    triangle t;
    bvh8_asked++;
    if (!w->exact) t = mesh_triangle(w->x.m, d->block->index[d->lane]);
    else t = (triangle){bvh8_back(w, c[0], c[8], c[16]), bvh8_back(w, c[24], c[32], c[40]),
                        bvh8_back(w, c[48], c[56], c[64])};
    vec3 a = shear_corner(&t.a, s), b = shear_corner(&t.b, s), g = shear_corner(&t.c, s);
    vec3 e = {g.x * b.y - g.y * b.x, a.x * g.y - a.y * g.x, b.x * a.y - b.y * a.x};
    return !signs_differ(e.x, e.y, e.z) && shear_meets(a, b, g, e, s, *q->r, out);
}

/* True: there is a hit. */
__attribute__((noinline))
static bool bvh8_settle(const bvh8 *w, bvh8_ray *q)
{
    const bvh8_skip *s = q->skip;
    for (const bvh8_doubt *d = q->doubt; d < q->doubt + q->doubts; d++) {
        uint32_t i = d->block->index[d->lane];
        hit h;
        if (d->first > q->limit || i == no_shape || i == s->from
            || i - s->first <= s->last - s->first) continue;
        if (bvh8_exactly(w, d, q, &h)) bvh8_keep(q, h, i);
    }
    q->doubts = 0;
    return q->best.shape != no_shape;
}

__attribute__((always_inline))
static inline bool bvh8_shape(const bvh8 *w, uint32_t i, bvh8_ray *q)
{
    const shape *x = &w->x.s->shapes[i];
    hit h;
    if (x->kind == SHAPE_SPHERE ? sphere_hit(x->sphere, *q->r, &h)
        : shape_hit_sheared(x, bvh8_shear(q), *q->r, &h)) bvh8_keep(q, h, i);
    return q->best.shape != no_shape;
}

#endif
