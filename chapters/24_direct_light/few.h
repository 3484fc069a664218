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
 * on what is left, the nearest bound (24.21) first: one triangle as a rule, that on whose side of
 * the common edge the ray passes, and the second bound shows that it is all. Sorting out
 * must not lose a hit, so all its rounding is paid for in advance. With U = 2^-24, D the largest
 * distance along an axis from o to what there is, coordinates taken from the middle of the box:
 * o' <= 3 D is off by 20 U D at most, d' <= 1.8 by 12 U, each product by 71 U D + 5 U D, the
 * difference by 11 U D more, a |d'n| by 28 U D: m = 256 U D; e = 32 U D. Both get 256 eps D more
 * for the test of 04 itself, as in (14.3), and 16 eps times the largest coordinate for taking the
 * middle away: of weight in float only, and far from the origin.
 */
#ifndef DIRECT_FEW_H
#define DIRECT_FEW_H

#include "../14_bvh/bvh_mesh.h"

enum { few_most = 64, few_wide = 8, few_line = 16 };
enum { FEW_U, FEW_V, FEW_N };  /* axes, each x, y, z and -axis.c; then a, b */
typedef struct {
    float *room;                /* a line of the cache holds few_line floats */
    float (*row)[few_most];     /* [14][lane]; NaN: no such lane */
    int32_t number[few_most];   /* 0, 1, 2 ...: in memory, eight of them are one load */
    vec3 middle, half;          /* of the box */
    real scale;                 /* a power of two: the box becomes some 1 large */
    real blur;                  /* what coordinates lose when the middle is taken from them */
    int32_t lanes;              /* a multiple of few_wide; 0: nothing was built */
    int32_t lane[few_most];     /* [triangle] */
    uint8_t first[few_most], last[few_most];  /* [lane] its triangles */
    struct { float x, y, z, w; } side[few_most];  /* [lane] > 0 where the first of two lies */
    bool apart[few_most];       /* [lane] who is well within one can't meet the other */
} few;
typedef struct { int32_t first, last, other; } few_skip;  /* lanes first..last, and another */
#define few_skip_none ((few_skip){-1, -1, -1})
#define few_none INT32_MAX  /* a key above all others */

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

/* The largest coordinate. */
static inline real few_far(const mesh *m, size_t first, size_t last)
{
    real far = 0;
    for (size_t i = 3 * first; i < 3 * last + 3; i++) {
        vec3 p = m->v[m->index[i]];
        far = real_max(far, real_max(fabs(p.x), real_max(fabs(p.y), fabs(p.z))));
    }
    return far;
}

typedef struct { vec3 c, u, v, n; real a, b; } few_rectangle;

/* Round triangles first..last, along one edge of the first. */
static inline few_rectangle few_along(const mesh *m, size_t first, size_t last, vec3 edge)
{
    triangle t = mesh_triangle(m, first);
    vec3 u = vunit(edge), n = triangle_normal(t), v;
    real lo[2], hi[2];
    n = vunit(vsub(n, vscale(u, vdot(n, u))));  /* that of a needle leans along its length */
    v = vcross(n, u);
    few_extent(m, first, last, t.a, u, &lo[0], &hi[0]);
    few_extent(m, first, last, t.a, v, &lo[1], &hi[1]);
    vec3 c = vmadd(vmadd(t.a, u, (lo[0] + hi[0]) / 2), v, (lo[1] + hi[1]) / 2);
    return (few_rectangle){c, u, v, n, (hi[0] - lo[0]) / 2, (hi[1] - lo[1]) / 2};
}

/* Along the longest edge, where a needle's normal does least harm, unless another one makes it much
 * smaller: along the diagonal, a rectangle's would have twice its area. False if the triangles are
 * not flat, or fill less than 2/5 of it, or one has no area: never hit. */
static inline bool few_around(const mesh *m, size_t first, size_t last, few_rectangle *out)
{
    triangle t = mesh_triangle(m, first);
    vec3 edge[3] = {vsub(t.b, t.a), vsub(t.c, t.b), vsub(t.a, t.c)};
    real lo, hi, area = 0;
    int longest = 0;
    for (size_t i = first; i <= last; i++) {
        triangle k = mesh_triangle(m, i);
        if (vzero(triangle_normal(k))) return false;
        area += vlength(vcross(vsub(k.b, k.a), vsub(k.c, k.a))) / 2;
    }
    for (int k = 1; k < 3; k++)
        if (vlength(edge[k]) > vlength(edge[longest])) longest = k;
    for (int k = 0; k < 3; k++) {
        few_rectangle r = few_along(m, first, last, edge[(longest + k) % 3]);
        if (k == 0 || r.a * r.b < out->a * out->b * (real)0.75) *out = r;
    }
    few_extent(m, first, last, out->c, out->n, &lo, &hi);
    bool flat = hi - lo <= 4 * real_epsilon * few_far(m, first, last);
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

/* Two triangles: on which side of their common edge is which? That edge of the first has the second
 * behind it. Corners off by 2^-12 of the triangle's height do not matter, see few_within. */
static inline void few_divide(few *f, int lane, const mesh *m)
{
    real far = few_far(m, f->first[lane], f->last[lane]);
    triangle t = mesh_triangle(m, f->first[lane]), o = mesh_triangle(m, f->last[lane]);
    const vec3 p[5] = {t.a, t.b, t.c, t.a, t.b};
    for (int k = 0; k < 3; k++) {
        vec3 in = vunit(vcross(triangle_normal(t), vsub(p[k + 1], p[k])));
        real height = vdot(in, vsub(p[k + 2], p[k])), a = vdot(in, vsub(o.a, p[k]));
        real b = vdot(in, vsub(o.b, p[k])), c = vdot(in, vsub(o.c, p[k]));
        if (!(real_max(real_max(a, b), c) < height * (real)0x1p-12)) continue;
        vec3 from = vscale(vsub(p[k], f->middle), f->scale);
        f->side[lane].x = (float)in.x, f->side[lane].y = (float)in.y;
        f->side[lane].z = (float)in.z, f->side[lane].w = -(float)vdot(in, from);
        f->apart[lane] = real_epsilon * far < height * (real)0x1p-20;
    }
}

static inline bool few_build(const mesh *m, few *out)
{
    vec3 lo, hi;
    int e, lanes = 0;
    *out = (few){.lanes = 0};
    if (m->triangles > few_most || !mesh_bounds(m, &lo, &hi) || !vfinite(lo) || !vfinite(hi))
        return false;
    vec3 half = vscale(vsub(hi, lo), 0.5);
    real size = vaxis(half, vlongest(half));
    if (!(size > real_smallest / real_epsilon && size < real_largest * real_epsilon)) return false;
    (void)frexp(size, &e);
    vec3 far = vmax(vmax(hi, vneg(hi)), vmax(lo, vneg(lo)));
    *out = (few){.middle = vadd(lo, half), .half = half, .scale = ldexp((real)1, -e)};
    out->blur = 16 * real_epsilon * vaxis(far, vlongest(far)) * out->scale;
    out->room = allocate(14 * few_most + few_line, sizeof *out->room);
    size_t past = (uintptr_t)out->room / sizeof(float) % few_line;
    out->row = (float (*)[few_most])(void *)(out->room + (past ? few_line - past : 0));
    for (int i = 0; i < 14 * few_most; i++) out->row[i / few_most][i % few_most] = NAN;
    for (int i = 0; i < few_most; i++) out->number[i] = i;
    for (size_t i = 0; i < m->triangles; i++, lanes++) {
        few_rectangle r;
        bool two = i + 1 < m->triangles && few_around(m, i, i + 1, &r);
        out->first[lanes] = (uint8_t)i, out->last[lanes] = (uint8_t)(i + two);
        out->lane[i] = lanes;
        if (two || few_around(m, i, i, &r)) few_store(out, lanes, &r);
        if (two) few_divide(out, lanes, m), out->lane[++i] = lanes;
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
    real own = 256 * real_epsilon;
    if (!(D < (real)0x1p60) || !(f->blur < 1) || !(q->r.tmin >= 0)) return false;
    *out = (few_ray){(float)o.x, (float)o.y, (float)o.z, (float)d.x, (float)d.y, (float)d.z,
                     (float)(D * ((real)0x1p-16 + own) + f->blur),
                     (float)(D * ((real)0x1p-19 + own) + f->blur),
                     fabs(vaxis(q->r.d, q->shear.kz)) * f->scale};
    return true;
}

/* Beyond all that there is, never mind how far; 2^-19 for its rounding and that of (24.21). */
static inline float few_limit(const few_ray *r, real t)
{
    return (float)real_min(t * r->along * (1 + (real)0x1p-19), (real)0x1p62);
}

/* The keys of all lanes, and the least two of each column i mod 8: for most rays the second shows
 * that the first is all there is to ask. */
typedef struct { int32_t key[few_most], low[few_wide], next[few_wide]; } few_list;

/* Key: (24.21) as the bits of a float, the lane in its six lowest; few_none: sorted out. Masks, not
 * branches: a `?` would be one, and the loop would not become wide. */
__attribute__((always_inline))
static inline void few_keys(const few *f, const few_ray *ray_, float limit, few_skip skip,
                            few_list *out)
{
    few_ray r = *ray_;
    const float (*k)[few_most] = (const float (*)[few_most])f->row;
    int32_t first = 0;
    for (int j = 0; j < few_wide; j++) out->low[j] = out->next[j] = few_none;
    do for (int32_t j = 0, i = first; j < few_wide; j++, i++) {  /* a fixed count: no remainder */
        float ou = k[0][i] * r.ox + k[1][i] * r.oy + (k[2][i] * r.oz + k[3][i]);
        float ov = k[4][i] * r.ox + k[5][i] * r.oy + (k[6][i] * r.oz + k[7][i]);
        float on = k[8][i] * r.ox + k[9][i] * r.oy + (k[10][i] * r.oz + k[11][i]);
        float du = k[0][i] * r.dx + k[1][i] * r.dy + k[2][i] * r.dz;
        float dv = k[4][i] * r.dx + k[5][i] * r.dy + k[6][i] * r.dz;
        float dn = k[8][i] * r.dx + k[9][i] * r.dy + k[10][i] * r.dz;
        float size = fabs(dn), up = dn < 0 ? on : -on;
        float qu = fabs(ou * dn - on * du), qv = fabs(ov * dn - on * dv);
        float z = (up - r.e) / (size + 0x1p-20f);
        int32_t bits, lane = f->number[i];
        memcpy(&bits, &z, sizeof bits);
        bits = bits > 0 ? bits : 0;  /* below 0: 0 */
        uint32_t in = (uint32_t)((qu <= k[12][i] * size + r.m) & (qv <= k[13][i] * size + r.m)
            & (up >= -r.e) & (z <= limit) & ((lane < skip.first) | (lane > skip.last))
            & (lane != skip.other));
        int32_t key = ((bits & ~63) | lane) | (int32_t)((in - 1) >> 1), low = out->low[j];
        int32_t high = key > low ? key : low, next = out->next[j];
        out->key[i] = key;
        out->low[j] = key < low ? key : low, out->next[j] = high < next ? high : next;
    } while ((first += few_wide) < f->lanes);
}

__attribute__((always_inline))
static inline int32_t few_least(const int32_t x[few_wide])
{
    int32_t a[4], b[2];
    for (int j = 0; j < 4; j++) a[j] = x[j] < x[j + 4] ? x[j] : x[j + 4];
    for (int j = 0; j < 2; j++) b[j] = a[j] < a[j + 2] ? a[j] : a[j + 2];
    return b[0] < b[1] ? b[0] : b[1];
}

__attribute__((always_inline))
static inline int32_t few_second(const few_list *l, int32_t least)
{
    int32_t x[few_wide];
    for (int j = 0; j < few_wide; j++) x[j] = l->low[j] == least ? l->next[j] : l->low[j];
    return few_least(x);
}

/* The least key above `last`. */
static inline int32_t few_next(const few *f, const few_list *l, int32_t last)
{
    int32_t low[few_wide];
    for (int j = 0; j < few_wide; j++) low[j] = few_none;
    for (int32_t first = 0; first < f->lanes; first += few_wide)
        for (int j = 0; j < few_wide; j++) {
            int32_t x = l->key[first + j] > last ? l->key[first + j] : few_none;
            low[j] = x < low[j] ? x : low[j];
        }
    return few_least(low);
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
static inline float few_bound(int32_t key)
{
    float z;
    key &= ~63;  /* few_none becomes a NaN */
    memcpy(&z, &key, sizeof z);
    return z;
}

/* The test of 04, of a triangle that has area. */
__attribute__((always_inline))
static inline bool few_meets(const mesh *m, uint32_t i, const query *q, hit *h)
{
    const uint32_t *k = m->index + 3 * i;
    vec3 a = shear_corner(&m->v[k[0]], &q->shear), b = shear_corner(&m->v[k[1]], &q->shear);
    vec3 c = shear_corner(&m->v[k[2]], &q->shear);
    vec3 e = {c.x * b.y - c.y * b.x, a.x * c.y - a.y * c.x, b.x * a.y - b.y * a.x};
    if (signs_differ(e.x, e.y, e.z) || !shear_meets(a, b, c, e, &q->shear, q->r, h)) return false;
    h->shape = i;
    return true;
}

/* Of the two triangles of a lane the one that the ray seems to meet. Any answer is right. */
__attribute__((always_inline))
static inline bool few_guess(const few *f, const few_ray *r, int32_t key)
{
    int32_t lane = key & 63;
    float z = few_bound(key);
    return f->side[lane].x * (r->ox + r->dx * z) + f->side[lane].y * (r->oy + r->dy * z)
        + f->side[lane].z * (r->oz + r->dz * z) + f->side[lane].w < 0;
}

/* So far inside that the other triangle of the lane is not met: it begins behind an edge, and no
 * rounding moves the point there. */
__attribute__((always_inline))
static inline bool few_within(hit h)
{
    return real_min(real_min(h.u, h.v), 1 - h.u - h.v) > (real)0x1p-10;
}

__attribute__((always_inline))
static inline int few_search(const few *f, const mesh *m, ray r, few_skip skip, bool any, hit *out)
{
    _Alignas(64) few_list list;
    few_ray look;
    hit h;
    if (f->lanes == 0 || !ray_is_usable(r)) return -1;
    query q = {r, few_shear(r), hit_none};
    if (!few_look(f, &q, &look)) return -1;
    float limit = few_limit(&look, r.tmax);
    few_keys(f, &look, limit, skip, &list);
    int32_t k = few_least(list.low), second = few_second(&list, k);
    for (int n = 0; few_bound(k) <= limit; k = n++ ? few_next(f, &list, k) : second) {
        int32_t lane = k & 63;
        uint32_t both = f->first[lane] + (uint32_t)f->last[lane];
        uint32_t i = few_guess(f, &look, k) ? f->last[lane] : f->first[lane];
        bool met = few_meets(m, i, &q, &h);
        if (any && met) return 1;
        if (met && query_improves(&q, h)) limit = few_limit(&look, h.t);
        if (2 * i == both || (met && f->apart[lane] && few_within(h))) continue;
        if (!few_meets(m, both - i, &q, &h)) continue;
        if (any) return 1;
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
