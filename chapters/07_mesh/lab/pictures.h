/* pictures.h: a mesh in a frame that fits it, and slices through meshes.
 *
 *   bool whole = draw_mesh(&m, up, samples, threads, &im)  by brute force, `up` the axis upwards
 *                                                          [0,3); it sees all from front above.
 *                                                          False: stopped by Ctrl-C; the picture
 *                                                          holds what there was
 *   draw_slices(&o, "07_mesh_inside.png")                  3 x 2 panels
 */
#ifndef MESH_LAB_PICTURES_H
#define MESH_LAB_PICTURES_H

#include "../../../common/headlight.h"
#include "../../../common/lab/panels.h"
#include "../scenes/camera_of.h"
#include "../scenes/teapot.h"
#include "trials.h"

/* ---------------------------------------------------------------------------------------------- */

typedef struct { camera c; int width, height; const mesh *m; } mesh_view;

/* A ray may take a tenth of a second, a tile of pixels half a minute: Ctrl-C works between rays. */
static vec3 mesh_view_colour(const void *context, real x, real y)
{
    const mesh_view *w = context;
    ray r = camera_ray(w->c, x, y, w->width, w->height);
    hit h;
    if (parallel_is_stopped()) return vec(0, 0, 0);
    if (!mesh_hit(w->m, r, &h)) return vec(0.015, 0.02, 0.03);
    return vmul(vec(0.9, 0.4, 0.18), headlight(mesh_normal(w->m, h.shape, h.u, h.v), r.d));
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
    if (!frame_look_at(vmadd(centre, vunit(away), 3 * radius), centre, above, &f, &why))
        model_fails(why);
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
        model_fails(why);
    return c;
}

cold_inline bool draw_mesh(const mesh *m, int up, int samples, int threads, image *im)
{
    mesh_view w = {camera_fit(m, up, im->width, im->height), im->width, im->height, m};
    return pixels_draw(im, pixels_side(samples), threads, "picture", mesh_view_colour, &w);
}

/* ---------------------------------------------------------------------------------------------- */

/* Columns: parity of hits, parity of crossings, winding number. Rows: a closed ring in the plane
 * z = 0, which holds vertices and edges; the teapot, an open mesh, in its plane of symmetry y = 0,
 * which holds edges. True is: of the ring, parity along a ray that leaves the plane; the teapot is
 * open, so nothing is true, and what differs from the winding number counts as wrong. */
typedef struct { const mesh *m; int side, top; bool open; image *sheet; } mesh_slice;
enum { slice_gap = 6 };

/* One point, by all three: blue inside, pale outside, between them a winding number between 0 and
 * 1; orange: wrong. */
static inline void slice_point(int x, int y, void *context)
{
    const vec3 in = {0, 0.17, 0.45}, out = {0.8, 0.85, 0.9}, d = {1, 0, 0};
    const mesh_slice *s = context;
    real a = (2 * (real)x + 1) / (real)s->side - 1, b = 1 - (2 * (real)y + 1) / (real)s->side;
    vec3 p = vec((real)1.1 * a, (real)1.1 * b, 0);
    if (s->open) p = vec((real)3.4 * a + (real)0.2, 0, (real)3.4 * b + (real)1.6);
    const double w[3] = {inside_parity_naive(s->m, p, d), inside_parity(s->m, p, d),
                         winding_number(s->m, p)};
    bool due = s->open ? w[2] > 0.5 : inside_parity(s->m, p, vec(0.36, 0.48, 0.8));
    for (int k = 0; k < 3; k++)
        image_set(s->sheet, k * (s->side + slice_gap) + x, s->top + y, (w[k] > 0.5) != due
                  ? vec(0.67, 0.11, 0)
                  : vmadd(out, vsub(in, out), (real)fmin(fmax(w[k], 0), 1)));
}

cold_inline void draw_slices(const options *o, const char *name)
{
    static const char *const title[] = {"parity of hits", "parity of crossings", "winding number",
                                        "parity of hits", "parity of crossings", "winding number"};
    const int side = o->quick ? 16 : 180, next = side + slice_gap;
    mesh ring = torus_mesh(12), teapot = teapot_mesh(3);
    image sheet = label_sheet(3 * next - slice_gap, 2 * next - slice_gap);
    mesh_slice s[2] = {{&ring, side, 0, false, &sheet}, {&teapot, side, next, true, &sheet}};
    bool whole = true;
    for (int k = 0; k < 2 && whole; k++)
        whole = parallel_pixels(side, side, o->threads, "slices", slice_point, &s[k]);
    panels_save(o, &sheet, 3, 2, slice_gap, title, name, whole);
    mesh_free(&ring), mesh_free(&teapot);
}

#endif
