/* first.h: the other order (物体顺序): for each triangle its pixels; a depth buffer (深度缓冲) decides.
 * Wrong: u, v and depth are mixed as if the picture were flat, so tiles bend; what reaches behind
 * the eye is left out; a pixel on a shared edge is drawn twice. raster.h mends all three. */
#ifndef FIRST_OBJECT_ORDER_H
#define FIRST_OBJECT_ORDER_H
#include "../02_camera/first.h"
#include "../07_mesh/first.h"

/* What each pixel sees so far: nx x ny hits, row by row; t is the depth (深度). */
typedef struct { int nx, ny; hit *h; } first_raster;

static long first_covered, first_asked;  /* pixels covered, and asked, since the program began */

static inline first_raster first_raster_new(int nx, int ny)
{
    first_raster s = {nx, ny, allocate((size_t)nx * (size_t)ny, sizeof *s.h)};
    for (int k = 0; k < nx * ny; k++) s.h[k] = (hit){real_infinity, 0, 0, UINT32_MAX};
    return s;
}

/* x, y: where p shows, in pixels; z: how far it lies before the eye.                      (8.1) */
static inline vec3 first_project(first_camera c, vec3 p)
{
    vec3 q = vsub(p, c.e);
    real z = -vdot(q, c.w), s = c.d / z;
    return vec((s * vdot(q, c.u) - c.left) / (c.right - c.left) * c.nx,
               (s * vdot(q, c.v) - c.top) / (c.bottom - c.top) * c.ny, z);
}

/* Edge function (边函数): twice the area of a, b, (x, y); its sign tells the side.         (8.2) */
static inline real first_edge(vec3 a, vec3 b, real x, real y)
{
    return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

/* Triangle i, its corners projected: asks every pixel of the rectangle round it. */
static inline void first_raster_triangle(first_raster *s, vec3 a, vec3 b, vec3 c, uint32_t i)
{
    real area = first_edge(a, b, c.x, c.y);
    if (!(a.z > 0 && b.z > 0 && c.z > 0) || area == 0) return;
    int x0 = (int)real_clamp(floor(fmin(a.x, fmin(b.x, c.x))), 0, s->nx);
    int x1 = (int)real_clamp(ceil(fmax(a.x, fmax(b.x, c.x))), 0, s->nx);
    int y0 = (int)real_clamp(floor(fmin(a.y, fmin(b.y, c.y))), 0, s->ny);
    int y1 = (int)real_clamp(ceil(fmax(a.y, fmax(b.y, c.y))), 0, s->ny);
    for (int y = y0; y < y1; y++)
        for (int x = x0; x < x1; x++) {
            /* The weights of the corners at the middle of the pixel.                      (8.3) */
            real w = first_edge(b, c, x + 0.5, y + 0.5) / area;
            real u = first_edge(c, a, x + 0.5, y + 0.5) / area;
            real v = first_edge(a, b, x + 0.5, y + 0.5) / area;
            first_asked++;
            if (!(w >= 0 && u >= 0 && v >= 0)) continue;
            first_covered++;

            /* Nearer than what the pixel saw before? */
            hit *h = &s->h[y * s->nx + x];
            real z = w * a.z + u * b.z + v * c.z;
            if (z < h->t) *h = (hit){z, u, v, i};
        }
}

static inline void first_raster_mesh(first_raster *s, const first_mesh *m, first_camera c)
{
    for (int i = 0; i < m->n; i++) {
        triangle t = m->tri[i];
        first_raster_triangle(s, first_project(c, t.a), first_project(c, t.b),
                              first_project(c, t.c), (uint32_t)i);
    }
}

static inline void first_raster_free(first_raster *s)
{
    free(s->h);
    *s = (first_raster){0, 0, NULL};
}
#endif
