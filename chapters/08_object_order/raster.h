/* raster.h: object order (物体顺序), as graphics processors do it: clip, project, snap, edge functions,
 * depth test.
 *
 *   raster s = raster_new(640, 480);
 *   raster_mesh(&s, &m, c, raster_default);       draws every triangle; the nearest stays
 *   s.h[y * s.nx + x]                             what the ray through the middle of that pixel
 *                                                 hits first: t as camera_ray counts it, u, v,
 *                                                 and the number of the triangle; none: no_shape
 *   raster_free(&s);
 *
 * The same type `hit`, so that the same shading serves both orders. c: a perspective camera. At
 * equal stored depths the triangle drawn first, the one of the lower number, stays.
 *
 * Stored is near / z in float: 1 at the near plane, 0 at infinity. Floats are dense near 0, and
 * there near / z crowds what is far. So 1e-7 of the distance is told at any distance; of 1 - near /
 * z, as was usual, what far things differ by is lost beside the 1                         (8.5).
 *
 * raster_how: bits [1, 16] of a pixel to which corners are snapped; the near plane, a depth > 0
 * before which nothing is drawn; and one more plane to clip by (n = 0: none).
 *
 *   both sides of a triangle count          no area in the picture, NaN, infinity: not drawn
 *   a mesh of 2^32 - 2 triangles at most    pictures of up to 8192 x 8192
 *
 * Corners are rounded to 2^-bits of a pixel, so edge functions are whole numbers, exact in 64 bits:
 * no rounding decides, and a pixel on an edge belongs to one side only, by the top-left rule. That
 * moves an edge by half a step: where picture and rays differ, the ray passes within a step of an
 * edge. (tests/08_object_order.c: each of them is explained so.)
 *
 * Cost: a triangle some 100 operations, a pixel of its rectangle three additions.
 *
 * Sources: J. Pineda, "A Parallel Algorithm for Polygon Rasterization", SIGGRAPH 1988 (edge
 * functions); Microsoft, Direct3D 11.3 Functional Specification, 3.4.2 (top-left rule, 8 bits);
 * J. Blinn, "Hyperbolic Interpolation", IEEE CG&A 12(4), 1992; C. Burns, W. Hunt, "The Visibility
 * Buffer", JCGT 2(2), 2013; E. Lapidous, G. Jiao, "Optimal Depth Buffer for Low-Cost Graphics
 * Hardware", Graphics Hardware 1999.
 */
#ifndef RASTER_H
#define RASTER_H

#include "../02_camera/camera.h"
#include "../07_mesh/mesh.h"
#include "first.h"
#include "raster_clip.h"

typedef struct { int bits; real near; plane also; } raster_how;

/* The depth has its precision everywhere, so the near plane may be as near as this. */
static const raster_how raster_default = {8, (real)0.001, {{0, 0, 0}, {0, 0, 0}}};

typedef struct {
    int nx, ny;
    hit *h;                  /* [ny][nx] */
    float *depth;            /* [ny][nx] near / z; -1: nothing seen */
    size_t asked, covered;   /* pixels: in rectangles; of these inside the triangle */
} raster;

/* ---------------------------------------------------------------------------------------------- */

static inline raster raster_new(int nx, int ny)
{
    size_t n = (size_t)nx * (size_t)ny;
    raster s = {nx, ny, allocate(n, sizeof *s.h), allocate(n, sizeof *s.depth), 0, 0};
    for (size_t k = 0; k < n; k++) s.h[k] = hit_none, s.depth[k] = -1;
    return s;
}

static inline void raster_free(raster *s) { free(s->h), free(s->depth), *s = (raster){0}; }

enum { raster_reach = 1 << 30 };  /* steps: products of their differences fit into 64 bits */

/* A corner in the picture: whole steps of 2^-bits pixels; 1/z; and u, v there. */
typedef struct { int64_t x, y; real iz, u, v; } raster_point;

typedef struct {
    raster *s;
    camera c;
    raster_how how;
    int64_t one;                        /* steps in a pixel */
    plane clip[raster_most_planes];
    int planes;
} raster_job;

/* Before the near plane, and so near the picture that whole numbers suffice: four planes through
 * the eye and the lines x = +-limit, y = +-limit of the window, far outside of it.        (8.8) */
static inline raster_job raster_begin(raster *s, camera c, raster_how how)
{
    raster_job j = {.s = s, .c = c, .how = how, .one = (int64_t)1 << how.bits};
    real limit = (real)(raster_reach / 2 >> how.bits);
    real px = (c.right - c.left) / (real)s->nx, py = (c.top - c.bottom) / (real)s->ny;
    plane at_near = {vmadd(c.e, c.w, -how.near), vneg(c.w)};
    plane right = {c.e, vsub(vscale(c.w, -(c.left + limit * px)), vscale(c.u, c.d))};
    plane left = {c.e, vadd(vscale(c.w, c.left - limit * px), vscale(c.u, c.d))};
    plane above = {c.e, vsub(vscale(c.w, -(c.top + limit * py)), vscale(c.v, c.d))};
    plane below = {c.e, vadd(vscale(c.w, c.top - limit * py), vscale(c.v, c.d))};
    const plane all[raster_most_planes] = {at_near, right, left, above, below, how.also};
    for (int k = 0; k < raster_most_planes; k++)
        if (!vzero(all[k].n)) j.clip[j.planes++] = all[k];
    return j;
}

/* (2.7), snapped. False: so large, beyond 1/epsilon of what is seen, that clipping lost its
 * digits. */
static inline bool raster_project(const raster_job *j, raster_corner k, raster_point *out)
{
    real x, y, z = -vdot(vsub(k.p, j->c.e), j->c.w), one = (real)j->one;
    if (!camera_project(j->c, k.p, j->s->nx, j->s->ny, &x, &y)) return false;
    x *= one, y *= one;
    if (!(fabs(x) <= raster_reach && fabs(y) <= raster_reach)) return false;
    *out = (raster_point){llrint((double)x), llrint((double)y), 1 / z, k.u, k.v};
    return true;
}

/* Edge a b: e(x, y) = (bx - ax)(y - ay) - (by - ay)(x - ax), exactly; and what it gains a pixel to
 * the right and down (8.2). Inside e > 0; e = 0 belongs to top and left edges alone: of the two
 * triangles at an edge one sees a b, the other b a, and just one of these leads right or up. The
 * other takes off 1, the tie, so that 0 is outside; weights want it back. */
typedef struct { int64_t e, right, down, tie; } raster_edge;

static inline raster_edge raster_edge_of(raster_point a, raster_point b, int64_t x, int64_t y,
                                         int64_t one)
{
    int64_t dx = b.x - a.x, dy = b.y - a.y;
    int64_t tie = !(dy < 0 || (dy == 0 && dx > 0));
    return (raster_edge){dx * (y - a.y) - dy * (x - a.x) - tie, -dy * one, dx * one, tie};
}

/* The first pixel whose middle is at `at` or beyond it, and the last one before it plus 1. */
static inline int raster_pixel(const raster_job *j, int64_t at, int most)
{
    int64_t k = (at - j->one / 2 + j->one - 1) >> j->how.bits;
    return k < 0 ? 0 : k > most ? most : (int)k;
}

/* A pixel that triangle a b c covers: weights w, u, v of its corners in the picture (8.3). 1/z is
 * linear there, and so are u/z and v/z (8.4). */
static inline void raster_pixel_seen(const raster_job *j, size_t k, const raster_point *p, real w,
                                     real u, real v, uint32_t number)
{
    real iz = w * p[0].iz + u * p[1].iz + v * p[2].iz;
    float depth = (float)(j->how.near * iz);
    j->s->covered++;
    if (depth <= j->s->depth[k]) return;
    real a = w * p[0].iz / iz, b = u * p[1].iz / iz, c = v * p[2].iz / iz;
    j->s->depth[k] = depth;
    j->s->h[k] = (hit){1 / (iz * j->c.d), a * p[0].u + b * p[1].u + c * p[2].u,
                       a * p[0].v + b * p[1].v + c * p[2].v, number};
}

/* Visits the rectangle row by row; edge functions step by additions. What lies exactly at its right
 * or lower end is on no top or left edge. */
static inline void raster_points(const raster_job *j, raster_point a, raster_point b,
                                 raster_point c, uint32_t number)
{
    raster *s = j->s;
    int64_t twice = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    if (twice == 0) return;
    raster_point p[3] = {a, twice > 0 ? b : c, twice > 0 ? c : b};
    int64_t x_low = a.x, x_high = a.x, y_low = a.y, y_high = a.y;
    for (int k = 1; k < 3; k++) {
        x_low = p[k].x < x_low ? p[k].x : x_low, x_high = p[k].x > x_high ? p[k].x : x_high;
        y_low = p[k].y < y_low ? p[k].y : y_low, y_high = p[k].y > y_high ? p[k].y : y_high;
    }
    int x0 = raster_pixel(j, x_low, s->nx), x1 = raster_pixel(j, x_high, s->nx);
    int y0 = raster_pixel(j, y_low, s->ny), y1 = raster_pixel(j, y_high, s->ny);
    if (x0 >= x1 || y0 >= y1) return;
    int64_t x = x0 * j->one + j->one / 2, y = y0 * j->one + j->one / 2;
    raster_edge e[3];
    for (int k = 0; k < 3; k++) e[k] = raster_edge_of(p[(k + 1) % 3], p[(k + 2) % 3], x, y, j->one);
    real inverse = 1 / (real)llabs(twice);
    s->asked += (size_t)(x1 - x0) * (size_t)(y1 - y0);
    for (int row = y0; row < y1; row++) {
        int64_t w = e[0].e, u = e[1].e, v = e[2].e;
        for (int column = x0; column < x1; column++) {
            if ((w | u | v) >= 0)  /* none is negative */
                raster_pixel_seen(j, (size_t)row * (size_t)s->nx + (size_t)column, p,
                                  (real)(w + e[0].tie) * inverse, (real)(u + e[1].tie) * inverse,
                                  (real)(v + e[2].tie) * inverse, number);
            w += e[0].right, u += e[1].right, v += e[2].right;
        }
        for (int k = 0; k < 3; k++) e[k].e += e[k].down;
    }
}

static inline void raster_triangle(const raster_job *j, triangle t, uint32_t number)
{
    raster_corner p[raster_most_corners] = {{t.a, 0, 0}, {t.b, 1, 0}, {t.c, 0, 1}};
    raster_point q[raster_most_corners];
    int n = 3;
    if (!vfinite(t.a) || !vfinite(t.b) || !vfinite(t.c)) return;
    for (int k = 0; k < j->planes && n; k++) n = raster_clip(p, n, j->clip[k]);
    for (int k = 0; k < n; k++)
        if (!raster_project(j, p[k], &q[k])) return;
    for (int k = 2; k < n; k++) raster_points(j, q[0], q[k - 1], q[k], number);
}

static inline void raster_mesh(raster *s, const mesh *m, camera c, raster_how how)
{
    raster_job j = raster_begin(s, c, how);
    for (size_t i = 0; i < m->triangles; i++)
        raster_triangle(&j, mesh_triangle(m, i), (uint32_t)i);
}

#endif
