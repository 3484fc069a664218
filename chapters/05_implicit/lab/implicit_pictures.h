/* implicit_pictures.h: surfaces in the light of two lamps and the sky: this chapter's pictures.
 *
 *   implicit_draw(&o)                 Barth's sextic: the main picture
 *   implicit_draw_missed(&o)          Barth's sextic from close by, by steps and by intervals: red
 *                                     is what steps miss
 *
 * Gold is the side where f > 0, blue the other. A pixel gets one ray; where it differs from one of
 * its neighbours, o.samples, or the next square below.
 */
#ifndef IMPLICIT_PICTURES_H
#define IMPLICIT_PICTURES_H

#include "../../../common/lab/panels.h"
#include "../../02_camera/camera.h"
#include "implicit_trials.h"

typedef struct {
    implicit_surface s;
    implicit_how how;
    bool judge;          /* against implicit_hit: red where the first root is missed */
    camera c;
    const image *plain;  /* of one ray a pixel; NULL: not drawn yet */
    int width, height;
} implicit_view;

/* ---------------------------------------------------------------------------------------------- */

static const vec3 implicit_red = {0.8, 0.04, 0.02};
static const implicit_how implicit_sure = {IMPLICIT_INTERVAL, 0, 0};

/* At `target`, from so far away, the eye turned around the vertical, and raised; all angles in
 * degrees. */
static inline camera implicit_camera(vec3 target, real far, real angle, real turn, real rise)
{
    real a = turn * pi / 180, b = rise * pi / 180;
    vec3 from = {sin(a) * cos(b), sin(b), cos(a) * cos(b)};
    return camera_at(vmadd(target, from, far), target, vec(0, 1, 0), angle, 1);
}

/* White paper in the middle, a little darker around. */
static inline vec3 implicit_paper(ray r, camera f)
{
    real along = -vdot(vunit(r.d), f.w), light = real_clamp(1 - 3 * (1 - along), 0, 1);
    return vscale(vec(0.93, 0.95, 1), (real)0.55 + (real)0.4 * light);
}

static inline real implicit_lit(vec3 n, vec3 light) { return real_max(0, vdot(n, vunit(light))); }

/* A warm lamp on the left above the eye, a cool one on the right, the sky, and a gleam. */
static inline vec3 implicit_shade(const implicit_view *v, ray r, hit h)
{
    vec3 p = ray_at(r, h.t), n = implicit_normal(&v->s, p), d = vunit(r.d);
    bool outside = vdot(n, d) <= 0;
    if (!outside) n = vneg(n);
    vec3 base = outside ? vec(1, 0.47, 0.07) : vec(0.05, 0.3, 0.7);
    vec3 local = {vdot(n, v->c.u), vdot(n, v->c.v), vdot(n, v->c.w)};
    real key = implicit_lit(local, vec(-4, 6, 5)), fill = implicit_lit(local, vec(6, -1, 2));
    real sky = (real)0.5 + local.y / 2, face = fabs(vdot(n, d));
    vec3 light = vadd(vscale(vec(1, 0.95, 0.85), (real)0.95 * key),
                      vadd(vscale(vec(0.35, 0.5, 0.8), (real)0.45 * fill),
                           vscale(vec(0.75, 0.85, 1), (real)0.3 * sky)));
    real gleam = pow(implicit_lit(local, vadd(vunit(vec(-4, 6, 5)), vec(0, 0, 1))), (real)60);
    vec3 seen = vscale(vmul(base, light), (real)0.45 + (real)0.55 * face);
    return vmadd(seen, vec(1, 1, 1), (real)0.3 * gleam);
}

static inline vec3 implicit_colour(const implicit_view *v, ray r)
{
    hit h = hit_none, due = hit_none;
    bool is = implicit_method_hit(v->how, &v->s, r, &h);
    if (v->judge) {
        bool there = implicit_hit(&v->s, r, &due);
        real near = (real)1e-3 * v->s.ball.r / vlength(r.d);
        if (there && (!is || h.t > due.t + near)) return implicit_red;
    }
    return is ? implicit_shade(v, r, h) : implicit_paper(r, v->c);
}

/* Does the pixel differ from one of its neighbours? */
static inline bool implicit_differs(const image *im, int x, int y)
{
    static const int by[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    for (int k = 0; k < 4; k++) {
        int x1 = x + by[k][0], y1 = y + by[k][1];
        if (x1 < 0 || y1 < 0 || x1 >= im->width || y1 >= im->height) continue;
        const float *a = image_pixel(im, x, y), *b = image_pixel(im, x1, y1);
        if (fabs(a[0] - b[0]) + fabs(a[1] - b[1]) + fabs(a[2] - b[2]) > 0.2f) return true;
    }
    return false;
}

/* Of `plain` what needs no more rays. Square pixels: the window of the camera covers the shorter
 * side. */
static vec3 implicit_pixel(const void *context, real x, real y)
{
    const implicit_view *v = context;
    int w = v->width, h = v->height, least = w < h ? w : h;
    if (v->plain && !implicit_differs(v->plain, (int)x, (int)y))
        return image_get(v->plain, (int)x, (int)y);
    return implicit_colour(v, camera_ray(v->c, x - (real)(w - least) / 2,
                                         y - (real)(h - least) / 2, least, least));
}

static inline bool implicit_render(implicit_view v, int samples, int threads, image *im)
{
    int side = pixels_side(samples);
    v.width = im->width, v.height = im->height;
    bool whole = pixels_draw(im, 1, threads, "surface", implicit_pixel, &v);
    if (side == 1 || !whole) return whole;
    image plain = image_new(im->width, im->height);
    image_place(&plain, 0, 0, im);
    v.plain = &plain;
    whole = pixels_draw(im, side, threads, "edges", implicit_pixel, &v);
    image_free(&plain);
    return whole;
}

cold_inline void implicit_draw(const options *o)
{
    image im = image_new(o->width, o->height);
    implicit_view v = {.s = implicit_barth(&implicit_barth_radius), .how = implicit_sure};
    v.c = implicit_camera(vec(0, 0, 0), (real)3.6 * v.s.ball.r, (real)31.5, 22, 20);
    bool whole = implicit_render(v, o->samples, o->threads, &im);
    output_picture(o, &im, "05_implicit.png", true, whole);
    image_free(&im);
}

cold_inline void implicit_draw_missed(const options *o)
{
    static const char *const title[] = {"first.h, 24 steps; red: missed", "implicit_hit"};
    enum { gap = 6 };
    implicit_view v = {.s = implicit_barth(&implicit_barth_radius)};
    image sheet = {0}, one = image_new((960 - gap) / 2, o->quick ? 60 : 316);
    bool whole = true;
    v.c = implicit_camera(vec(0.3, 0.62, 1.2), (real)2.2 * v.s.ball.r, 14, 12, 18);
    for (int k = 0; k < 2 && whole; k++) {
        v.how = k ? implicit_sure : (implicit_how){IMPLICIT_FIRST, 24, 0}, v.judge = !k;
        whole = implicit_render(v, o->samples, o->threads, &one);
        label_panel(&sheet, 2, 1, gap, k, &one);
    }
    panels_save(o, &sheet, 2, 1, gap, title, "05_implicit_missed.png", whole);
    image_free(&one);
}

#endif
