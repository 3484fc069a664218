/* pictures.h: a mesh in a frame that fits it, and slices through meshes.
 *
 *   bool whole = draw_mesh(&m, up, samples, threads, &im)  by brute force, `up` the axis upwards
 *                                                          [0,3); it sees all from front above
 *   bool whole = draw_slices(side, threads, &im)           3 x 2 panels, each side x side pixels,
 *                                                          titled; a new image
 * False: stopped by Ctrl-C; the picture holds what there was.
 */
#ifndef MESH_LAB_PICTURES_H
#define MESH_LAB_PICTURES_H

#include "../../../common/headlight.h"
#include "../../../common/lab/label.h"
#include "../../../common/parallel.h"
#include "../../02_camera/camera.h"
#include "../../02_camera/samples.h"
#include "../scenes/teapot.h"
#include "trials.h"

/* ---------------------------------------------------------------------------------------------- */

typedef struct {
    camera c;
    image *im;
    const mesh *m;
    int cells;
} mesh_view;

static inline vec3 mesh_view_colour(const mesh_view *w, ray r)
{
    hit h;
    if (!mesh_hit(w->m, r, &h)) return vec(0.015, 0.02, 0.03);
    return vmul(vec(0.9, 0.4, 0.18), headlight(mesh_normal(w->m, h.shape, h.u, h.v), r.d));
}

/* A ray may take a tenth of a second, a tile of pixels half a minute: Ctrl-C works between rays. */
static inline void mesh_view_pixel(int x, int y, void *context)
{
    const mesh_view *w = context;
    vec3 sum = {0, 0, 0};
    int n = w->cells * w->cells;
    for (int k = 0; k < n; k++) {
        real dx, dy;
        if (atomic_load(&parallel_stop)) return;
        samples_place(SAMPLES_REGULAR, k, w->cells, 0.5, NULL, &dx, &dy);
        ray r = camera_ray(w->c, (real)x + (real)0.5 + dx, (real)y + (real)0.5 + dy, w->im->width,
                           w->im->height);
        sum = vadd(sum, mesh_view_colour(w, r));
    }
    image_set(w->im, x, y, vscale(sum, 1 / (real)n));
}

/* Axis `up` [0,3) upwards, the one before it to the right. Eye at three radii of the sphere round
 * the box; then the window closes in on the corners, all of which are in front. */
static inline camera camera_fit(const mesh *m, int up, int width, int height)
{
    failure why;
    camera c;
    camera_frame f;
    vec3 lo, hi, away = {0, 0, 0};
    if (!mesh_bounds(m, &lo, &hi)) lo = hi = away;
    vec3 centre = vmadd(lo, vsub(hi, lo), 0.5);
    int right = up == 2 ? 0 : up == 1 ? 0 : 2, front = 3 - up - right;
    vec3 above = vwith(away, up, 1);
    /* right x up points to the eye */
    away = vwith(vwith(vwith(away, up, (real)0.45), right, (real)0.3), front, up == 2 ? -1 : 1);
    real radius = vlength(vsub(hi, lo)) / 2;
    if (!(radius > 0)) radius = 1;
    if (!frame_look_at(vmadd(centre, vunit(away), 3 * radius), centre, above, &f, &why)) fail(why);
    camera_window n = {real_infinity, -real_infinity, real_infinity, -real_infinity};
    for (size_t i = 0; i < 3 * m->triangles; i++) {
        vec3 q = vsub(m->v[m->index[i]], f.e);
        real x = vdot(q, f.u) / -vdot(q, f.w), y = vdot(q, f.v) / -vdot(q, f.w);
        n = (camera_window){real_min(n.left, x), real_max(n.right, x), real_min(n.bottom, y),
                            real_max(n.top, y)};
    }
    if (!(n.left < n.right && n.bottom < n.top))
        n = (camera_window){-0.3, 0.3, -0.3, 0.3};
    real x = (n.left + n.right) / 2, y = (n.bottom + n.top) / 2, a = (real)width / (real)height;
    real half = (real)0.52 * real_max(n.top - n.bottom, (n.right - n.left) / a);
    if (!camera_off_axis(f, (camera_window){x - a * half, x + a * half, y - half, y + half}, 1,
                         &c, &why))
        fail(why);
    return c;
}

static inline bool draw_mesh(const mesh *m, int up, int samples, int threads, image *im)
{
    mesh_view w = {camera_fit(m, up, im->width, im->height), im, m, 1};
    while ((w.cells + 1) * (w.cells + 1) <= samples) w.cells++;
    return parallel_pixels(im->width, im->height, threads, "picture", mesh_view_pixel, &w);
}

/* ---------------------------------------------------------------------------------------------- */

/* Columns: parity of hits, parity of crossings, winding number. Rows: a closed ring in the plane
 * z = 0, which holds vertices and edges; the teapot, an open mesh, in its plane of symmetry y = 0,
 * which holds edges. True is: of the ring, parity along a ray that leaves the plane; the teapot is
 * open, so nothing is true, and what differs from the winding number counts as wrong. */
enum { slice_gap = 6 };
typedef struct { mesh ring, teapot; image *im; int side; } mesh_slices;

/* Blue inside, pale outside, between them a winding number between 0 and 1; orange: wrong. */
static inline vec3 slice_colour(double w, bool wrong)
{
    const vec3 in = {0, 0.17, 0.45}, out = {0.8, 0.85, 0.9};
    return wrong ? vec(0.67, 0.11, 0)
                 : vmadd(out, vsub(in, out), (real)(w < 0 ? 0 : w > 1 ? 1 : w));
}

static inline void slice_pixel(int x, int y, void *context)
{
    const mesh_slices *s = context;
    int step = s->side + slice_gap, row = y / s->side, j = y % s->side;
    real a = 2 * ((real)x + (real)0.5) / (real)s->side - 1;
    real b = 1 - 2 * ((real)j + (real)0.5) / (real)s->side;
    const mesh *m = row ? &s->teapot : &s->ring;
    vec3 p = row ? vec((real)3.4 * a + (real)0.2, 0, (real)3.4 * b + (real)1.6)
                 : vec((real)1.1 * a, (real)1.1 * b, 0), d = {1, 0, 0};
    double w[3] = {inside_parity_naive(m, p, d), inside_parity(m, p, d), winding_number(m, p)};
    bool due = row ? w[2] > 0.5 : inside_parity(m, p, vec(0.36, 0.48, 0.8));
    for (int k = 0; k < 3; k++)
        image_set(s->im, k * step + x, row * step + j,
                  slice_colour(w[k], (w[k] > 0.5) != due));
}

static inline bool draw_slices(int side, int threads, image *im)
{
#define SLICE_TITLES "parity of hits", "parity of crossings", "winding number"
    static const char *const title[] = {SLICE_TITLES, SLICE_TITLES};
    *im = image_new(3 * side + 2 * slice_gap, 2 * side + slice_gap);
    mesh_slices s = {torus_mesh(12), teapot_mesh(3), im, side};
    bool whole = parallel_pixels(side, 2 * side, threads, "slices", slice_pixel, &s);
    label_titles(im, 3, 2, slice_gap, title);
    mesh_free(&s.ring), mesh_free(&s.teapot);
    return whole;
}

#endif
