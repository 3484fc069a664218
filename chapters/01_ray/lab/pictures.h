/* pictures.h: what the page of 01 shows.
 *
 *   ray_draw_steps(&o);     the main one: one ray in float, at four distances from the origin
 *   ray_draw_interval(&o);  a ray, its points at some t, its interval; and a shadow ray: an SVG
 *
 * Both are drawn by the very functions that they explain.
 */
#ifndef RAY_LAB_PICTURES_H
#define RAY_LAB_PICTURES_H

#include "../../../common/lab/figure.h"
#include "../../../common/lab/label.h"
#include "../../../common/parallel.h"
#include "ray_f32.h"

enum { ray_panels = 4, ray_gap = 6, ray_points = 64 * 64 };
typedef struct {
    image *im;
    int panel;
    vec3_f32 o[ray_panels], (*p)[ray_points];
} ray_steps;

/* ---------------------------------------------------------------------------------------------- */

static inline void ray_steps_pixel(int x, int y, void *context)
{
    ray_steps *s = context;
    int k = x / (s->panel + ray_gap);
    real scale = (real)s->panel / 64, half = 0.5;  /* pixels a unit */
    real u = ((real)(x - k * (s->panel + ray_gap)) + half) / scale;
    real v = ((real)(s->im->height - y) - half) / scale;
    if (u > 64 || k >= ray_panels) { image_set(s->im, x, y, (vec3){1, 1, 1}); return; }
    real nearest = real_infinity;
    /* A dot less than 1 away from u has a t within 1 and half the way between two floats of u. */
    real reach = 1 + ldexp((real)1, 2 * k - 4);
    int first = (int)real_max(64 * (u - reach), 0);
    int end = (int)real_min(64 * (u + reach) + 1, ray_points);
    for (int i = first; i < end; i++) {
        real dx = (real)(s->p[k][i].x - s->o[k].x) - u, dy = (real)(s->p[k][i].y - s->o[k].y) - v;
        nearest = real_min(nearest, dx * dx + dy * dy);
    }
    real off = fabs(v - u * (real)0.625) * scale / (real)1.18;  /* from the true line, pixels */
    real dot = real_clamp(3 - sqrt(nearest) * scale, 0, 1);
    real thin = real_clamp((real)1.2 - off, 0, 1);
    vec3 c = vscale((vec3){1, 1, 1}, (real)0.93 - (real)0.75 * thin);
    c = vadd(vscale(c, 1 - dot), vscale(vec(0.67, 0.11, 0), dot));
    image_set(s->im, x, y, c);
}

/* p(t) for t in [0, 64], every 1/64, seen from close by. */
cold_inline void ray_draw_steps(const options *o)
{
    image im = image_new(o->width, o->height);
    int panel = (o->width - (ray_panels - 1) * ray_gap) / ray_panels;
    ray_steps s = {&im, panel > 0 ? panel : 1, .p = allocate(ray_panels, sizeof *s.p)};
    for (int k = 0; k < ray_panels; k++) {
        float far = ldexp(1.0f, 20 + 2 * k);  /* floats are 1/8, 1/2, 2 and 8 apart from here on */
        s.o[k] = (vec3_f32){far, far, 0};
        for (int i = 0; i < ray_points; i++)
            s.p[k][i] = ray_at_f32(s.o[k], (vec3_f32){1, 0.625f, 0}, (float)i / 64);
    }
    bool whole = parallel_pixels(im.width, im.height, o->threads, "steps", ray_steps_pixel, &s);
    static const char *const tag[] = {"o at 2^20: floats 1/8 apart", "2^22: 1/2", "2^24: 2",
                                      "2^26: 8"};
    for (int k = 0; k < ray_panels && panel > 200; k++)
        label_tag(&im, k * (panel + ray_gap) + 6, 6, 12, tag[k]);
    output_picture(o, &im, "01_ray.png", true, whole);
    image_free(&im);
    free(s.p);
}

static inline void ray_draw_part(figure *g, ray r, double from, double to, const char *colour,
                                 double width, const char *dashes)
{
    vec3 a = ray_at(r, (real)from), b = ray_at(r, (real)to);
    figure_line(g, (double)a.x, (double)a.y, (double)b.x, (double)b.y, colour, width, dashes);
}

/* A dot at p(t), blue where the interval covers t, and what t is here and with a d of length 1. */
static inline void ray_draw_point(figure *g, ray r, double t)
{
    vec3 p = ray_at(r, (real)t);
    const char *colour = ray_covers(r, (real)t) ? FIGURE_BLUE : FIGURE_GREY;
    figure_dot(g, (double)p.x, (double)p.y, 5.5, colour);
    figure_print(g, (double)p.x, (double)p.y, -5, -13, FIGURE_MIDDLE, FIGURE_BLACK, "%g", t);
    figure_print(g, (double)p.x, (double)p.y, 7, 27, FIGURE_MIDDLE, FIGURE_GREY, "%g",
                 t * (double)vlength(r.d));
}

cold_inline void ray_draw_interval(const options *o)
{
    figure g = figure_begin(o, "01_ray_interval.svg", 820, 330);
    ray r = ray_from((vec3){0, 0, 0}, vec(0.8, 0.6, 0));  /* a 3-4-5 triangle: |d| = 1, times 1.5 */
    r.d = vscale(r.d, 1.5);
    r.tmin = 0.5, r.tmax = 2;
    figure_origin(&g, 120, 262, 72);
    ray_draw_part(&g, r, -0.7, 0, FIGURE_GREY, 1.5, FIGURE_DASHED);
    ray_draw_part(&g, r, 0, 2.8, FIGURE_GREY, 1.5, FIGURE_WHOLE);
    ray_draw_part(&g, r, (double)r.tmin, (double)r.tmax, FIGURE_SKY, 9, FIGURE_WHOLE);
    vec3 d = ray_at(r, 1);
    figure_arrow(&g, 0, 0, (double)d.x, (double)d.y, FIGURE_RED, 2.5);
    for (double t = -0.5; t <= 2.5; t += 0.5) ray_draw_point(&g, r, t);
    figure_dot(&g, 0, 0, 5.5, FIGURE_RED);
    figure_text(&g, 0, 0, -22, -9, FIGURE_RIGHT, FIGURE_RED, "*o*");
    figure_text(&g, (double)d.x / 4, (double)d.y / 4, -13, -12, FIGURE_MIDDLE, FIGURE_RED, "*d*");
    figure_text(&g, 0, 3.3, -105, 0, FIGURE_LEFT, FIGURE_BLACK, "*p*(_t_) = *o* + _t_ *d*,");
    figure_text(&g, 0, 3.3, -105, 22, FIGURE_LEFT, FIGURE_BLACK, "_t_ above the line");
    figure_text(&g, 0, 3.3, -105, 44, FIGURE_LEFT, FIGURE_GREY, "below it: _t_ |*d*|, a distance");
    figure_text(&g, 2.4, 1.1, 5, 20, FIGURE_LEFT, FIGURE_BLUE, "[_t_~min~, _t_~max~]");

    ray s = ray_between((vec3){0, 0, 0}, vec(2.2, 2.7, 0));
    s.tmin = 0.12, s.tmax = 1 - s.tmin;
    vec3 light = ray_at(s, 1), ball = ray_at(s, 0.55);
    figure_origin(&g, 520, 262, 72);
    figure_line(&g, -0.7, 0, 3.6, 0, FIGURE_BLACK, 2, FIGURE_WHOLE);
    figure_dot(&g, (double)ball.x + 0.25, (double)ball.y - 0.1, 34, "#dddddd");
    ray_draw_part(&g, s, 0, 1, FIGURE_GREY, 1.5, FIGURE_WHOLE);
    ray_draw_part(&g, s, (double)s.tmin, (double)s.tmax, FIGURE_SKY, 9, FIGURE_WHOLE);
    ray_draw_part(&g, s, 0, 1, FIGURE_BLACK, 1, FIGURE_WHOLE);
    figure_dot(&g, 0, 0, 5.5, FIGURE_RED);
    figure_dot(&g, (double)light.x, (double)light.y, 8, FIGURE_ORANGE);
    figure_text(&g, 0, 0, 0, 26, FIGURE_MIDDLE, FIGURE_BLACK, "*p*, _t_ = 0");
    figure_text(&g, (double)light.x, (double)light.y, 16, 5, FIGURE_LEFT, FIGURE_BLACK,
                "light *l*, _t_ = 1");
    figure_text(&g, (double)ball.x, (double)ball.y, 62, 14, FIGURE_LEFT, FIGURE_BLACK,
                "in between?");
    figure_text(&g, 0, 1, 30, 10, FIGURE_RIGHT, FIGURE_BLUE, "[\xce\xb5, 1 \xe2\x88\x92 \xce\xb5]");
    figure_end(&g);
}
#endif
