/* few.h: a scene of few triangles, all asked at once.
 *
 *   A tree looks at some nine pairs of boxes, one after the other, before it has found a wall of
 *   the Cornell box, and each waits for the one before. Its 38 triangles are 20 rectangles: one
 *   loop without a branch, which the compiler makes eight wide.
 *
 *   few f;
 *   few_build(&m, &f)                  false: more than few_most triangles, none, or of no size
 *   few_hit(&f, &m, r, skip, &h)       1, 0: the very hit of bvh_hit, or none; -1: ask the tree
 *   few_occluded(&f, &m, r, skip)      (nothing was built, o is too far away, tmin < 0)
 *   few_free(&f);                      a zeroed one may be freed
 *   skip: lanes that are left out, f.lane[triangle]: a ray that leaves a triangle never meets it
 *   again (18.7), but only `real` can tell, and it would be asked each time. few_skip_none: none.
 *
 *   Each lane is a rectangle round one triangle, or round two that lie in a plane (within what
 *   leave.h steps off): middle c, unit axes u, v in the plane, n across, half widths a, b.
 *
 *       o' = (u.(o - c), v.(o - c), n.(o - c)),   d' = (u.d, v.d, n.d),   d's longest axis 1
 *       |o'u d'n - o'n d'u| <= a |d'n| + m,  the same for v and b                           (24.20)
 *       z = (-o'n / d'n: distance along d's longest axis) >= (|o'n| - e) / (|d'n| + 16 u)   (24.21)
 *
 * The loop only sorts out, in float, what can't be hit; the watertight test of 04 decides in `real`
 * on what is left, one or two triangles as a rule, the nearest bound (24.21) first. Sorting out
 * must not lose a hit, so all its rounding is paid for in advance. With U = 2^-24, D the largest
 * distance along an axis from o to what there is, coordinates taken from the middle of the box:
 * o' <= 3 D is off by 20 U D at most, d' <= 1.8 by 12 U, each product by 71 U D + 5 U D, the
 * difference by 11 U D more, a |d'n| by 28 U D: m = 256 U D; e = 32 U D.
 */
#ifndef FEW_H
#define FEW_H

#include "../14_bvh/bvh.h"

enum { few_most = 64, few_wide = 8, few_line = 16 };
enum { FEW_U, FEW_V, FEW_N };  /* axes, each x, y, z and -axis.c; then a, b */
typedef struct {
    float *room;                /* a line of the cache holds few_line floats */
    float (*row)[few_most];     /* [14][lane]; NaN: no such lane */
    vec3 middle, half;          /* of the box */
    real scale;                 /* a power of two: the box becomes some 1 large */
    int32_t lanes;              /* a multiple of few_wide; 0: nothing was built */
    int32_t lane[few_most];     /* [triangle] */
    uint8_t first[few_most], last[few_most];  /* [lane] its triangles */
} few;
typedef struct { int32_t first, last, other; } few_skip;  /* lanes first..last, and another */
#define few_skip_none ((few_skip){-1, -1, -1})
#define few_none UINT32_MAX  /* a key above all others */

/* ---------------------------------------------------------------------------------------------- */

static inline void few_free(few *f)
{
    free(f->room);
    *f = (few){.lanes = 0};
}

/* Widths of the triangles first..last about c along w: at least and at most. */
static inline void few_extent(const mesh *m, size_t first, size_t last, vec3 c, vec3 w, real *lo,
                              real *hi)
{
    *lo = real_infinity, *hi = -real_infinity;
    for (size_t i = 3 * first; i < 3 * last + 3; i++) {
        real x = vdot(w, vsub(m->v[m->index[i]], c));
        *lo = real_min(*lo, x), *hi = real_max(*hi, x);
    }
}

typedef struct { vec3 c, u, v, n; real a, b; } few_rectangle;

/* Round triangles first..last, along the longest edge of the first; false if they are not flat, or
 * fill less than 2/5 of it. A triangle of no area is never hit: any rectangle will do. */
static inline bool few_around(const mesh *m, size_t first, size_t last, few_rectangle *out)
{
    triangle t = mesh_triangle(m, first);
    vec3 edge[3] = {vsub(t.b, t.a), vsub(t.c, t.b), vsub(t.a, t.c)}, u = edge[0];
    for (int k = 1; k < 3; k++) if (vlength(edge[k]) > vlength(u)) u = edge[k];
    vec3 n = triangle_normal(t), v;
    real lo[3], hi[3], area = 0, far = 0;
    if (vzero(n)) vbasis(vzero(u) ? (vec3){0, 0, 1} : vunit(u), &n, &v);
    u = vzero(u) ? (vec3){0, 0, 1} : vunit(u), v = vcross(n, u);
    few_extent(m, first, last, t.a, u, &lo[0], &hi[0]);
    few_extent(m, first, last, t.a, v, &lo[1], &hi[1]);
    few_extent(m, first, last, t.a, n, &lo[2], &hi[2]);
    vec3 c = vmadd(vmadd(t.a, u, (lo[0] + hi[0]) / 2), v, (lo[1] + hi[1]) / 2);
    *out = (few_rectangle){c, u, v, n, (hi[0] - lo[0]) / 2, (hi[1] - lo[1]) / 2};
    for (size_t i = first; i <= last; i++) {
        triangle k = mesh_triangle(m, i);
        vec3 p = vmax(vmax(k.a, vneg(k.a)), vmax(k.b, vneg(k.b)));
        far = real_max(far, vaxis(p, vlongest(p)));
        area += vlength(vcross(vsub(k.b, k.a), vsub(k.c, k.a))) / 2;
    }
    bool flat = real_max(hi[2], -lo[2]) <= 4 * real_epsilon * far;
    return first == last || (flat && area > out->a * out->b * (real)1.6);
}

static inline void few_store(few *f, int lane, const few_rectangle *r)
{
    vec3 axis[3] = {r->u, r->v, r->n}, c = vscale(vsub(r->c, f->middle), f->scale);
    for (int k = 0; k < 3; k++) {
        for (int j = 0; j < 3; j++) f->row[4 * k + j][lane] = (float)vaxis(axis[k], j);
        f->row[4 * k + 3][lane] = -(float)vdot(axis[k], c);
    }
    f->row[12][lane] = float_beyond(r->a * f->scale);
    f->row[13][lane] = float_beyond(r->b * f->scale);
}

static inline bool few_build(const mesh *m, few *out)
{
    vec3 lo, hi;
    int e, lanes = 0;
    *out = (few){.lanes = 0};
    if (m->triangles > few_most || !mesh_bounds(m, &lo, &hi) || !vfinite(lo) || !vfinite(hi))
        return false;
    vec3 half = vscale(vsub(hi, lo), (real)0.5);
    real size = vaxis(half, vlongest(half));
    if (!(size > real_smallest / real_epsilon && size < real_largest * real_epsilon)) return false;
    (void)frexp(size, &e);
    *out = (few){.middle = vadd(lo, half), .half = half, .scale = ldexp((real)1, -e)};
    out->room = allocate(14 * few_most + few_line, sizeof *out->room);
    size_t past = (uintptr_t)out->room / sizeof(float) % few_line;
    out->row = (float (*)[few_most])(void *)(out->room + (past ? few_line - past : 0));
    for (int i = 0; i < 14 * few_most; i++) out->row[i / few_most][i % few_most] = NAN;
    for (size_t i = 0; i < m->triangles; i++, lanes++) {
        few_rectangle r;
        bool two = i + 1 < m->triangles && few_around(m, i, i + 1, &r);
        if (!two) few_around(m, i, i, &r);
        few_store(out, lanes, &r);
        out->first[lanes] = (uint8_t)i, out->lane[i] = lanes;
        if (two) out->lane[++i] = lanes;
        out->last[lanes] = (uint8_t)i;
    }
    out->lanes = (lanes + few_wide - 1) / few_wide * few_wide;
    return true;
}

/* The ray as the loop sees it. */
typedef struct {
    float ox, oy, oz, dx, dy, dz, m, e;
    real along;  /* t * along: distance along the longest axis, scaled */
} few_ray;

/* False if o is too far away, or not a number. */
__attribute__((always_inline))
static inline bool few_look(const few *f, const query *q, few_ray *out)
{
    vec3 o = vscale(vsub(q->r.o, f->middle), f->scale), d = vscale(q->r.d, fabs(q->shear.sz));
    real x = fabs(o.x) + f->half.x * f->scale, y = fabs(o.y) + f->half.y * f->scale;
    real D = real_max(x, real_max(y, fabs(o.z) + f->half.z * f->scale));
    if (!(D < (real)0x1p60) || !(q->r.tmin >= 0)) return false;
    *out = (few_ray){(float)o.x, (float)o.y, (float)o.z, (float)d.x, (float)d.y, (float)d.z,
                     (float)(D * (real)0x1p-16), (float)(D * (real)0x1p-19),
                     fabs(vaxis(q->r.d, q->shear.kz)) * f->scale};
    return true;
}

/* Beyond all that there is, never mind how far; 2^-20 for the rounding of (24.21). */
static inline float few_limit(const few_ray *r, real t)
{
    real z = t * r->along * (1 + (real)0x1p-20);
    return z < (real)0x1p62 ? float_above(z) : 0x1p62f;
}

/* Key: (24.21) as the bits of a float, the lane in its six lowest; few_none: sorted out. Masks, not
 * branches: a `?` would be one, and the loop would not become wide. */
__attribute__((always_inline))
static inline void few_keys(const few *f, const few_ray *ray_, float limit, few_skip skip,
                            uint32_t key[few_most])
{
    few_ray r = *ray_;
    const float (*k)[few_most] = (const float (*)[few_most])f->row;
    int32_t first = 0;
    do for (int32_t i = first; i < first + few_wide; i++) {  /* a fixed count: no remainder */
        float ou = k[0][i] * r.ox + k[1][i] * r.oy + (k[2][i] * r.oz + k[3][i]);
        float ov = k[4][i] * r.ox + k[5][i] * r.oy + (k[6][i] * r.oz + k[7][i]);
        float on = k[8][i] * r.ox + k[9][i] * r.oy + (k[10][i] * r.oz + k[11][i]);
        float du = k[0][i] * r.dx + k[1][i] * r.dy + k[2][i] * r.dz;
        float dv = k[4][i] * r.dx + k[5][i] * r.dy + k[6][i] * r.dz;
        float dn = k[8][i] * r.dx + k[9][i] * r.dy + k[10][i] * r.dz;
        float size = dn < 0 ? -dn : dn, up = dn < 0 ? on : -on;
        float qu = ou * dn - on * du, qv = ov * dn - on * dv;
        qu = qu < 0 ? -qu : qu, qv = qv < 0 ? -qv : qv;
        float z = (up - r.e) / (size + 0x1p-20f);
        z = z > 0 ? z : 0;
        uint32_t bits;
        memcpy(&bits, &z, sizeof bits);
        uint32_t in = (uint32_t)((qu <= k[12][i] * size + r.m) & (qv <= k[13][i] * size + r.m)
            & (up >= -r.e) & (z <= limit) & ((i < skip.first) | (i > skip.last))
            & (i != skip.other));
        key[i] = ((bits & ~63u) | (uint32_t)i) | (in - 1);
    } while ((first += few_wide) < f->lanes);
}

/* The least key above `last`; UINT32_MAX: the least. Differences wrap: those not above become large.
 * Eight at a time by hand: of the plain loop gcc makes a reduction for each block, 4 times slower. */
typedef uint32_t few_eight __attribute__((vector_size(4 * few_wide)));

__attribute__((always_inline))
static inline uint32_t few_next(const few *f, const uint32_t key[few_most], uint32_t last)
{
    few_eight low, k;
    memcpy(&low, key, sizeof low);
    low -= last + 1;
    for (int32_t i = few_wide; i < f->lanes; i += few_wide) {
        memcpy(&k, key + i, sizeof k);
        k -= last + 1;
        few_eight less = (few_eight)(k < low);
        low = (k & less) | (low & ~less);
    }
    uint32_t best = low[0];
    for (int j = 1; j < few_wide; j++) best = low[j] < best ? low[j] : best;
    return best + last + 1;
}

/* shear_of (04) without branches: which axis is the longest is a matter of chance. */
__attribute__((always_inline))
static inline ray_shear few_shear(ray r)
{
    static const int8_t next[5] = {0, 1, 2, 0, 1};
    real x = fabs(r.d.x), y = fabs(r.d.y), z = fabs(r.d.z);
    int xy = x >= y, xz = x >= z, yz = y >= z;
    int kz = 2 - 2 * (xy & xz) - ((1 - xy) & yz), kx = next[kz + 1], ky = next[kz + 2];
    real dz = vaxis(r.d, kz);
    vec3 o = {vaxis(r.o, kx), vaxis(r.o, ky), vaxis(r.o, kz)};
    return (ray_shear){kx, ky, kz, o, vaxis(r.d, kx) / dz, vaxis(r.d, ky) / dz, 1 / dz};
}

__attribute__((always_inline))
static inline float few_bound(uint32_t key)
{
    float z;
    key &= ~63u;
    memcpy(&z, &key, sizeof z);
    return z;
}

__attribute__((always_inline))
static inline int few_search(const few *f, const mesh *m, ray r, few_skip skip, bool any, hit *out)
{
    _Alignas(64) uint32_t key[few_most];
    few_ray look;
    hit h;
    if (f->lanes == 0 || !ray_is_usable(r)) return -1;
    query q = {r, few_shear(r), hit_none};
    if (!few_look(f, &q, &look)) return -1;
    float limit = few_limit(&look, r.tmax);
    few_keys(f, &look, limit, skip, key);
    for (uint32_t k = few_next(f, key, UINT32_MAX); k != few_none && few_bound(k) <= limit;
         k = few_next(f, key, k))
        for (uint32_t i = f->first[k & 63]; i <= f->last[k & 63]; i++) {
            const uint32_t *c = m->index + 3 * i;
            if (!triangle_hit_corners(&m->v[c[0]], &m->v[c[1]], &m->v[c[2]], &q.shear, q.r, &h))
                continue;
            if (any) return 1;
            h.shape = i;
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
