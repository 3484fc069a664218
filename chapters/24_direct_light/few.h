/* few.h: a scene of few triangles, all asked at once.
 *
 *   A tree looks at some nine pairs of boxes, one after the other, before it has found a wall of
 *   the Cornell box, and each waits for the one before. 38 triangles are three times sixteen: one
 *   loop without a branch, which the compiler makes sixteen wide.
 *
 *   few f;
 *   if (few_build(&m, &f)) ...            false: more than few_most triangles, none, or too thin
 *   few_hit(&f, &m, r, skip, &h, &asked)  1, 0: the very hit of bvh_hit; -1: ask the tree (o is too
 *   few_occluded(&f, &m, r, skip)         far away, tmin < 0)
 *   few_free(&f);                         a zeroed one may be freed
 *
 * The loop only sorts out, in float, what can't be hit; the watertight test of 04 decides in `real`
 * on what is left, one triangle as a rule. Sorting out must not lose a hit, so all its rounding is
 * paid for in advance. With u = 2^-24, D the largest distance along an axis from o to what there
 * is, coordinates taken from the middle of the box:
 *
 *   a corner seen from the ray (4.9)    |x|, |y| <= 2 D, |z| <= D, off by at most 12 u D
 *   e = x1 y2 - y1 x2 (4.10)            off by 4 (2 D) (12 u D) + 16 u D^2 <= 128 u D^2 = m
 *   e1 + e2 + e3                        off by less than 4 m
 *   e1 z1 + e2 z2 + e3 z3               off by 3 (m + 32 u D^2) D + 48 u D^3 <= 5 m D
 *
 * A triangle stays if its three e are >= -m or <= m, and if its distance along the longest axis
 *
 *   z = (sum of e z - 5 m D) / (|sum of e| + 4 m)         a lower bound                   (24.20)
 *
 * is no farther than the ray's end. The nearest bound is asked first; others only if their bounds
 * are nearer than what was hit.
 *
 * skip: two triangles that are left out: a ray that leaves a triangle never meets it again (18.7),
 * but only `real` can tell, and it would be asked each time. few_skip_none: none.
 */
#ifndef FEW_H
#define FEW_H

#include "../14_bvh/bvh.h"

enum { few_most = 64, few_wide = 16 };
typedef struct {
    float *room;                   /* a line of the cache has 16 floats: each is read as a whole */
    float (*corner)[3][few_most];  /* [corner][axis][triangle], from the middle, scaled; NaN: none */
    vec3 middle, half;             /* of the box */
    real scale;                    /* a power of two: the box becomes some 1 large */
    int lanes;                     /* a multiple of few_wide; 0: nothing was built */
} few;
typedef struct { int32_t first, last, other; } few_skip;  /* first..last, and another */
#define few_none 0x7fffffffu  /* a key above all others */
#define few_skip_none ((few_skip){-1, -1, -1})

/* ---------------------------------------------------------------------------------------------- */

static inline void few_free(few *f)
{
    free(f->room);
    *f = (few){.lanes = 0};
}

static inline bool few_build(const mesh *m, few *out)
{
    vec3 lo, hi;
    *out = (few){.lanes = 0};
    if (m->triangles > few_most || !mesh_bounds(m, &lo, &hi) || !vfinite(lo) || !vfinite(hi))
        return false;
    vec3 half = vscale(vsub(hi, lo), (real)0.5);
    real size = vaxis(half, vlongest(half));
    if (!(size > real_smallest / real_epsilon && size < real_largest * real_epsilon)) return false;
    int e;
    (void)frexp(size, &e);
    *out = (few){.middle = vadd(lo, half), .half = half, .scale = ldexp((real)1, -e)};
    out->room = allocate(9 * few_most + few_wide, sizeof *out->room);
    size_t past = (uintptr_t)out->room / sizeof(float) % few_wide;
    out->corner = (float (*)[3][few_most])(void *)(out->room + (past ? few_wide - past : 0));
    out->lanes = ((int)m->triangles + few_wide - 1) / few_wide * few_wide;
    for (int i = 0; i < out->lanes; i++) {
        for (int k = 0; k < 9; k++) out->corner[k / 3][k % 3][i] = NAN;
        if (i >= (int)m->triangles) continue;
        for (int c = 0; c < 3; c++) {
            vec3 p = vsub(m->v[m->index[3 * i + c]], out->middle);
            for (int k = 0; k < 3; k++)
                out->corner[c][k][i] = (float)(vaxis(p, k) * out->scale);
        }
    }
    return true;
}

/* The ray as the loop sees it. */
typedef struct {
    const float *x[3], *y[3], *z[3];  /* corners in the order of its axes */
    float ox, oy, oz, sx, sy, sign;
    float m, m4, m5;                  /* m, 4 m, 5 m D */
    real along;                       /* t * along: distance along the longest axis, scaled */
} few_ray;

/* False if o is so far away that D^3 leaves the floats, or not a number. */
__attribute__((always_inline))
static inline bool few_look(const few *f, const query *q, few_ray *out)
{
    const ray_shear *s = &q->shear;
    vec3 o = vscale(vsub(q->r.o, f->middle), f->scale);
    real x = fabs(o.x) + f->half.x * f->scale, y = fabs(o.y) + f->half.y * f->scale;
    real D = real_max(x, real_max(y, fabs(o.z) + f->half.z * f->scale));
    if (!(D < (real)0x1p30) || !(q->r.tmin >= 0)) return false;
    real m = D * D * (real)0x1p-17;
    for (int c = 0; c < 3; c++) {
        out->x[c] = f->corner[c][s->kx];
        out->y[c] = f->corner[c][s->ky];
        out->z[c] = f->corner[c][s->kz];
    }
    o = shear_turn(o, s->kz);
    out->ox = (float)o.x, out->oy = (float)o.y, out->oz = (float)o.z;
    out->sx = (float)s->sx, out->sy = (float)s->sy, out->sign = s->sz < 0 ? -1 : 1;
    out->m = (float)m, out->m4 = (float)(4 * m), out->m5 = (float)(5 * m * D);
    out->along = fabs(vaxis(q->r.d, s->kz)) * f->scale;
    return true;
}

static inline float few_limit(const few_ray *r, real t)
{
    real z = t * r->along;  /* beyond all that there is: never mind how far */
    return z < (real)0x1p40 ? float_above(z) : 0x1p40f;
}

/* Key: (24.20) as the bits of a float, the triangle in its six lowest; few_none: sorted out. */
__attribute__((always_inline))
static inline void few_keys(const few *f, const few_ray *q, float limit, few_skip skip,
                            uint32_t key[few_most])
{
    few_ray r = *q;
    int32_t first = 0;
    do for (int32_t i = first; i < first + few_wide; i++) {  /* a fixed count: no remainder */
        float az = r.z[0][i] - r.oz, bz = r.z[1][i] - r.oz, cz = r.z[2][i] - r.oz;
        float ax = r.x[0][i] - r.ox - r.sx * az, ay = r.y[0][i] - r.oy - r.sy * az;
        float bx = r.x[1][i] - r.ox - r.sx * bz, by = r.y[1][i] - r.oy - r.sy * bz;
        float cx = r.x[2][i] - r.ox - r.sx * cz, cy = r.y[2][i] - r.oy - r.sy * cz;
        float u = cx * by - cy * bx, v = ax * cy - ay * cx, w = bx * ay - by * ax;
        float lo = float_min(float_min(u, v), w), hi = float_max(float_max(u, v), w);
        float det = u + v + w, up = (u * az + v * bz + w * cz) * r.sign;
        up = det < 0 ? -up : up;
        float size = det < 0 ? -det : det;
        float z = (up - r.m5) / (size + r.m4);
        z = z > 0 ? z : 0;
        uint32_t bits;
        memcpy(&bits, &z, sizeof bits);
        int32_t in = ((lo >= -r.m) | (hi <= r.m)) & (up >= -r.m5) & (z <= limit)
            & ((i < skip.first) | (i > skip.last)) & (i != skip.other);
        key[i] = in ? (bits & ~63u) | (uint32_t)i : few_none;
    } while ((first += few_wide) < f->lanes);
}

/* The least key above `last`; -1u: the least. Differences wrap: those not above become large. */
__attribute__((always_inline))
static inline uint32_t few_next(const few *f, const uint32_t key[few_most], uint32_t last)
{
    uint32_t best = UINT32_MAX;
    for (int i = 0; i < f->lanes; i++) {
        uint32_t k = key[i] - last - 1;
        best = k < best ? k : best;
    }
    return best + last + 1;
}

__attribute__((always_inline))
static inline float few_bound(uint32_t key)
{
    float z;
    key &= ~63u;
    memcpy(&z, &key, sizeof z);
    return z;
}

/* 1: hit, 0: not, -1: cannot tell. */
__attribute__((always_inline))
static inline int few_search(const few *f, const mesh *m, ray r, few_skip skip, bool any, hit *out)
{
    _Alignas(64) uint32_t key[few_most];
    few_ray look;
    query q = query_of(r);
    if (f->lanes == 0 || !few_look(f, &q, &look)) return -1;
    float limit = few_limit(&look, r.tmax);
    few_keys(f, &look, limit, skip, key);
    for (uint32_t k = few_next(f, key, UINT32_MAX); k < few_none && few_bound(k) <= limit;
         k = few_next(f, key, k)) {
        const uint32_t *c = m->index + 3 * (k & 63);
        hit h;
        if (!triangle_hit_corners(&m->v[c[0]], &m->v[c[1]], &m->v[c[2]], &q.shear, q.r, &h))
            continue;
        if (any) return 1;
        h.shape = k & 63;
        if (query_improves(&q, h)) limit = few_limit(&look, h.t);
    }
    return any ? 0 : query_answer(&q, out);
}

static inline int few_hit(const few *f, const mesh *m, ray r, few_skip skip, hit *out)
{
    return few_search(f, m, r, skip, false, out);
}

static inline int few_occluded(const few *f, const mesh *m, ray r, few_skip skip)
{
    return few_search(f, m, r, skip, true, NULL);
}

#endif
