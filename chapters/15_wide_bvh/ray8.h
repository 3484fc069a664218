/* ray8.h: a ray in float, and what float owes: the bounds that make eight triangles at once safe.
 *
 *   bvh8_ray_of(&w, &r, &skip, &q)        the ray in the frame of the tree; once; false: it is none
 *   bvh8_limit(&q, t)                     t in the frame, rather too large
 *   bvh8_settle(&w, &q)                   asks in `real` what was written down: the test of 04
 *
 * S is the largest of 1 and the origin's coordinates, all in the frame; u = 2^-24; eps is that of
 * `real`. MEASURED.md has the sums:
 *
 *   boxes      planes may be off by delta = (16 u + 512 eps) S                              (15.6)
 *   corners    along the ray, by around = (24 u + 16 eps) S                                 (15.7)
 *   edges      by bound = 4 m around + 2 around^2 + 16 u m^2, where |x|, |y| <= m: beyond it the
 *              sign is that of 04. Two surely different signs: no hit. Three equal ones, each of
 *              more than 2 bound: a hit, wherever t is. most: bound if m = 4 S, the largest (15.8)
 *   t          by (4 bound spread / |det| + tail) / |dz|, tail = (32 u + 300 eps) S        (15.9)
 *
 * Where a number overflowed to infinity or NaN, no comparison with a bound is true: in doubt.
 */
#ifndef WIDE_RAY8_H
#define WIDE_RAY8_H

#include "tree8.h"

enum { bvh8_most_doubts = 32 };
typedef struct { const bvh8_block *block; int lane; float first; } bvh8_doubt;

typedef struct {
    floats4 near_o, far_o, inverse;               /* t of a plane: plane inverse + near_o */
    whole4 near, far;                             /* rows, in bytes: where it enters and leaves */
    size_t kx, ky, kz;                            /* rows of a corner, in the order of 04 */
    float sx, sy, cx, cy, oz, sz, around, tail, most;
    union {                                       /* its interval, and what surely lies in it */
        floats4 ends;
        struct { float tmin, limit, sure_min, sure_max; };
        uint32_t bits[4];
    };
    double scale, shift, slack;                   /* t in the frame: t scale - shift, +- slack */
    const ray *r;
    real tmax;                                    /* the t of `best`; until then that of r */
    uint32_t from, first, others;                 /* left out: from; first to first + others */
    hit best;                                     /* of what was asked in `real` */
    int doubts;
    bvh8_doubt doubt[bvh8_most_doubts];           /* what was not, and begins at `first` */
    bool sheared;
    ray_shear shear;                              /* of r, once it is asked for: balls don't */
} bvh8_ray;
#define bvh8_left_out(i, q) (((i) == (q)->from) | ((i) - (q)->first <= (q)->others))  /* lanes */

/* ---------------------------------------------------------------------------------------------- */

/* t in the frame, rather too large: rounded once, twice in float, and this product. In double: in
 * float the scale of a small tree may overflow. A far origin was moved by `shift`. */
static inline float bvh8_limit(const bvh8_ray *q, real t)
{
    float f = (float)((double)t * q->scale - q->shift + q->slack);
    return f + fabsf(f) * 0x1p-22f;
}

/* All four ends of the interval so. Infinite ones are made finite first: inf - inf is no number. A
 * NaN stays one, and no t lies in its interval. */
fast_inline void bvh8_interval(bvh8_ray *q, const ray *r)
{
    double a = (double)r->tmin * q->scale - q->shift, b = (double)r->tmax * q->scale - q->shift;
    doubles4 ends = (doubles4){a, b, a, b} + (doubles4){-1, 1, 1, -1} * q->slack;
    floats4 f = floats4_within(__builtin_convertvector(ends, floats4), FLT_MAX);
    q->ends = f + floats4_abs(f) * (floats4){-0x1p-22f, 0x1p-22f, 0x1p-22f, -0x1p-22f};
}

/* What triangles need: (4.9), from the axis along which d is longest. */
fast_inline void bvh8_ray_sheared(bvh8_ray *q, floats4 o, floats4 along, floats4 owed, float S)
{
    static const uint8_t next[5] = {0, 1, 2, 0, 1};
    int kz = vlongest(q->r->d), kx = next[kz + 1], ky = next[kz + 2];
    q->kx = sizeof(eight) * (size_t)kx, q->ky = sizeof(eight) * (size_t)ky;
    q->kz = sizeof(eight) * (size_t)kz, q->oz = o[kz], q->sz = q->inverse[kz];
    q->sx = -along[kx] * q->sz, q->sy = -along[ky] * q->sz;
    q->cx = o[kx] + q->sx * q->oz, q->cy = o[ky] + q->sy * q->oz;
    q->around = owed[1], q->tail = owed[2] * fabsf(q->sz);                   /* (15.7), (15.9) */
    q->most = S > 0x1p20f ? NAN : q->around * (20 * S + 2 * q->around) + S * S * 0x1.4p-16f;
}

/* What all rays need, in the frame. size: S; way: S before o was moved; afar: o / d may overflow,
 * and then inf - inf meets empty places. */
fast_inline void bvh8_ray_from(const bvh8 *w, bvh8_ray *q, vec3 at, vec3 d, real size, real way,
                               bool afar)
{
    q->slack = (double)real_smallest * (1 + q->scale) + 0x1p-100  /* no subnormal: they are slow */
        + 4 * (double)real_epsilon * fabs(q->shift);
    bvh8_interval(q, q->r);
    float S = (float)size, eps = (float)(way * real_epsilon);
    floats4 owed = S * (floats4){0x1p-20f, 0x1.8p-20f, 0x1p-19f} + eps * (floats4){512, 16, 300};
    floats4 o = floats4_of(at), along = floats4_of(d), i = 1 / along;
    q->inverse = i = floats4_within(i, 0x1p60f);
    floats4 error = floats4_abs(i) * owed[0];                                        /* (15.6) */
    floats4 p = afar ? floats4_within(o * i, FLT_MAX) : o * i, near = -p - error, far = error - p;
    q->near_o = near, q->far_o = far;
    if (afar) q->near_o = floats4_within(near, FLT_MAX), q->far_o = floats4_within(far, FLT_MAX);
    const int32_t row = sizeof(eight);  /* enters three rows on if it goes down */
    whole4 high = (i < 0) & 3 * row;
    q->near = (whole4){0, row, 2 * row} + high, q->far = (whole4){3 * row, 4 * row, 5 * row} - high;
    if (w->block) bvh8_ray_sheared(q, o, along, owed, S);
}

/* What few rays need before that. d gets a length near 1 if it is beyond 2^+-20; t changes by that
 * factor, and by the tree's. A far origin moves along the ray to where it is nearest to 0: then S
 * is small again, and what float can tell apart with it. That place is off by 3 eps of the way, as
 * is t. False: the ray is none. (Handed o and d, it would make all rays write them to memory.) */
__attribute__((noinline, cold))
static bool bvh8_ray_moved(const bvh8 *w, bvh8_ray *q)
{
    vec3 o = frame_into(&w->frame, q->r->o), d = q->r->d;
    if (!ray_is_usable(*q->r)) return false;
    real way = real_max(fabs(vaxis(o, vlongest(o))), 1);
    real s = direction_scale(fabs(vaxis(d, vlongest(d)))), t;
    d = vscale(d, 1 / s), q->scale *= (double)s, t = -vdot(o, d) / vdot(d, d);
    if (way > 8 && fabs(t) <= real_largest) o = vmadd(o, d, t), q->shift = (double)t;
    bvh8_ray_from(w, q, o, d, real_max(fabs(vaxis(o, vlongest(o))), 1), way, true);
    return true;
}

/* False: no ray (a NaN, a direction of 0). Field by field: what is copied as a whole right after it
 * was written waits for all that is under way. Sums are NaN or too large where any number is. */
fast_inline bool bvh8_ray_of(const bvh8 *w, const ray *r, const bvh8_skip *skip, bvh8_ray *q)
{
    vec3 at = frame_into(&w->frame, r->o), d = {r->d.x, r->d.y, r->d.z};
    real x = fabs(at.x), y = fabs(at.y), z = fabs(at.z), dd = fabs(d.x) + fabs(d.y) + fabs(d.z);
    real way = real_max(real_max(real_max(x, y), z), 1);
    q->r = r, q->tmax = r->tmax, q->best = hit_none, q->sheared = false, q->doubts = 0;
    q->from = skip->from, q->first = skip->first, q->others = skip->last - skip->first;
    q->scale = (double)w->frame.scale, q->shift = 0;
    if (!(x + y + z <= 8 && dd >= (real)0x1p-20 && dd <= (real)0x1p20))
        return bvh8_ray_moved(w, q);
    bvh8_ray_from(w, q, at, d, way, way, false);
    return true;
}

/* ---------------------------------------------------------------------------------------------- */

fast_inline ray bvh8_rest(const bvh8_ray *q)
{
    return (ray){q->r->o, q->r->tmin, q->r->d, q->tmax};
}

static inline const ray_shear *bvh8_shear(bvh8_ray *q, int kz)
{
    if (!q->sheared) q->shear = shear_along(q->r, kz), q->sheared = true;
    return &q->shear;
}

static inline bool bvh8_keep(bvh8_ray *q, hit h, uint32_t i)
{
    if (!hit_before((hit){h.t, h.u, h.v, i}, q->best)) return true;
    q->best = (hit){h.t, h.u, h.v, i}, q->tmax = h.t, q->limit = bvh8_limit(q, h.t);
    return true;
}

static _Thread_local size_t bvh8_asked;  /* in `real`, by this thread: for whoever counts */

/* True: there is a hit. Building asked for the area, so 04's test of a ray needn't. */
__attribute__((noinline))
static bool bvh8_settle(const bvh8 *w, bvh8_ray *q)
{
    for (const bvh8_doubt *d = q->doubt; d < q->doubt + q->doubts; d++) {
        if (!(d->first <= q->limit)) continue;
        const float *c = (const float *)d->block->corner + d->lane;
        const ray_shear *s = bvh8_shear(q, (int)(q->kz / sizeof(eight)));
        const size_t i = d->block->index[d->lane];
        vec3 p[3], own;  /* corners read where they lie: a copy costs a tenth */
        EIGHT_UNROLL
        for (size_t k = 0; k < 3; k++, c += 24) {
            if (w->exact) own = frame_back(&w->frame, vec(c[0], c[8], c[16]));
            p[k] = shear_corner(w->exact ? &own : &w->x.m->v[w->x.m->index[3 * i + k]], s);
        }
        hit h;
        bvh8_asked++;
        if (shear_passes(p[0], p[1], p[2], s, bvh8_rest(q), &h)) bvh8_keep(q, h, (uint32_t)i);
    }
    q->doubts = 0;
    return q->best.shape != no_shape;
}

/* flatten: the test of the shape in here, or shape and ray are copied to hand them over. */
__attribute__((noinline, flatten))
static bool bvh8_sheared(const shape *x, uint32_t i, bvh8_ray *q)
{
    hit h;
    return shape_hit_sheared(x, bvh8_shear(q, vlongest(q->r->d)), bvh8_rest(q), &h)
        && bvh8_keep(q, h, i);
}

/* Most spheres are clear, and the test of these alone needs hardly a stack. */
__attribute__((noinline, flatten))
static bool bvh8_sphere(const shape *x, uint32_t i, bvh8_ray *q)
{
    hit h;
    sphere_answer answer = sphere_hit_if_clear(x->sphere, bvh8_rest(q), &h);
    if (answer == SPHERE_DOUBT) return bvh8_sheared(x, i, q);
    return answer == SPHERE_HIT && bvh8_keep(q, h, i);
}

fast_inline bool bvh8_shape(const bvh8 *w, uint32_t i, bvh8_ray *q)
{
    const shape *x = &w->x.s->shapes[i];
    return x->kind == SHAPE_SPHERE ? bvh8_sphere(x, i, q) : bvh8_sheared(x, i, q);
}

#endif
