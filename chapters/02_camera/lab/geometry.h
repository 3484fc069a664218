/* geometry.h: eye, window, frame and a pixel's ray, drawn by the functions of first.h themselves.
 *
 *   camera_draw_geometry(&o);    02_camera_geometry.svg; seen by camera_perspective
 *   camera_draw_vanishing(&o);   a block, its edges carried on to three points, and the horizon
 */
#ifndef CAMERA_LAB_GEOMETRY_H
#define CAMERA_LAB_GEOMETRY_H

#include "../../../common/lab/figure.h"
#include "../camera.h"
#include "../first.h"

enum { camera_sheet_w = 480, camera_sheet_h = 380 };  /* of the left half [pixels] */
typedef struct { figure g; camera seen_by; } camera_sheet;

/* ---------------------------------------------------------------------------------------------- */

/* Where a point of space lies on the sheet; figures have y upwards. */
static inline void camera_spot(const camera_sheet *s, vec3 p, double *x, double *y)
{
    real px = 0, py = 0;
    if (!camera_project(s->seen_by, p, camera_sheet_w, camera_sheet_h, &px, &py)) abort();
    *x = (double)px, *y = -(double)py;
}

static inline void camera_edge(camera_sheet *s, vec3 a, vec3 b, const char *colour, double width,
                               const char *dashes)
{
    double x0, y0, x1, y1;
    camera_spot(s, a, &x0, &y0), camera_spot(s, b, &x1, &y1);
    figure_line(&s->g, x0, y0, x1, y1, colour, width, dashes);
}

static inline void camera_name(camera_sheet *s, vec3 p, double right, double down,
                               const char *colour, const char *text)
{
    double x, y;
    camera_spot(s, p, &x, &y);
    figure_text(&s->g, x, y, right, down, FIGURE_MIDDLE, colour, text);
}

static inline void camera_axis(camera_sheet *s, vec3 e, vec3 axis, double right, double down,
                               const char *colour, const char *text)
{
    double x0, y0, x1, y1;
    vec3 end = vmadd(e, axis, (real)0.4);
    camera_spot(s, e, &x0, &y0), camera_spot(s, end, &x1, &y1);
    figure_arrow(&s->g, x0, y0, x1, y1, colour, 2.5);
    camera_name(s, end, right, down, colour, text);
}

/* The point of the window under pixel coordinates x, y. */
static inline vec3 camera_window_at(first_camera c, double x, double y)
{
    return ray_at(first_camera_ray(c, (real)x, (real)y), 1);
}

static inline void camera_draw_window(camera_sheet *s, first_camera c)
{
    double xy[8], corner[][2] = {{5, 1}, {6, 1}, {6, 2}, {5, 2}};
    vec3 middle = camera_window_at(c, c.nx / 2.0, c.ny / 2.0);
    ray r = first_camera_ray(c, 5.5, 1.5);
    for (int i = 0; i < 4; i++)
        camera_spot(s, camera_window_at(c, corner[i][0], corner[i][1]), &xy[2 * i], &xy[2 * i + 1]);
    for (int i = 0; i < 4; i++) {
        vec3 at = camera_window_at(c, i % 2 * c.nx, i / 2 * c.ny);
        camera_edge(s, c.e, at, FIGURE_GREY, 1, FIGURE_DASHED);
    }
    camera_edge(s, c.e, middle, FIGURE_BLACK, 1.5, FIGURE_DASHED);
    camera_edge(s, ray_at(r, 1), ray_at(r, 2.6), FIGURE_BLUE, 2.5, FIGURE_WHOLE);
    figure_polygon(&s->g, 4, xy, FIGURE_ORANGE, 0.8, FIGURE_BLACK);
    for (int i = 0; i <= c.nx; i++)
        camera_edge(s, camera_window_at(c, i, 0), camera_window_at(c, i, c.ny), FIGURE_BLACK,
                    i % c.nx ? 0.6 : 2, FIGURE_WHOLE);
    for (int i = 0; i <= c.ny; i++)
        camera_edge(s, camera_window_at(c, 0, i), camera_window_at(c, c.nx, i), FIGURE_BLACK,
                    i % c.ny ? 0.6 : 2, FIGURE_WHOLE);
    camera_edge(s, r.o, ray_at(r, 1), FIGURE_BLUE, 2.5, FIGURE_WHOLE);
    camera_name(s, ray_at(r, 2.6), 4, -8, FIGURE_BLUE, "*o* + _t_ *d*");
    camera_name(s, vscale(vadd(c.e, middle), (real)0.5), 24, 5, FIGURE_BLACK, "_d_");
    camera_name(s, camera_window_at(c, 0, c.ny / 2.0), -21, -6, FIGURE_BLACK, "left");
    camera_name(s, camera_window_at(c, c.nx, c.ny / 2.0), 22, 4, FIGURE_BLACK, "right");
    camera_name(s, camera_window_at(c, c.nx / 2.0, 0), 0, -8, FIGURE_BLACK, "top");
    camera_name(s, camera_window_at(c, c.nx / 2.0, c.ny), -8, 26, FIGURE_BLACK, "bottom");
}

/* From the side: -w to the right, v up; a ray for each row of pixels. */
static inline void camera_draw_side(figure *g, first_camera c, bool parallel)
{
    double top = (double)c.top, d = parallel ? 0 : (double)c.d;
    if (!parallel) {
        figure_line(g, 0, 0, 2, 2 * top, FIGURE_GREY, 1, FIGURE_DASHED);
        figure_line(g, 0, 0, 2, -2 * top, FIGURE_GREY, 1, FIGURE_DASHED);
    }
    for (int j = 0; j < c.ny; j++) {
        real x = (real)c.nx / 2, y = (real)j + (real)0.5;
        ray r = parallel ? first_orthographic_ray(c, x, y) : first_camera_ray(c, x, y);
        vec3 from = vsub(r.o, c.e), to = vsub(ray_at(r, 2), c.e);
        figure_arrow(g, -(double)vdot(from, c.w), (double)vdot(from, c.v),
                     -(double)vdot(to, c.w), (double)vdot(to, c.v), FIGURE_BLUE, 1.2);
    }
    figure_line(g, d, -top, d, top, FIGURE_BLACK, 3, FIGURE_WHOLE);
    figure_dot(g, 0, 0, 6, FIGURE_BLACK);
    figure_text(g, 0, 0, -12, 5, FIGURE_RIGHT, FIGURE_BLACK, "*e*");
    if (parallel) figure_text(g, d, top, 0, -8, FIGURE_MIDDLE, FIGURE_BLACK, "top");
    else figure_text(g, d, top, -8, -12, FIGURE_RIGHT, FIGURE_BLACK, "top = tan(\xcf\x86/2)");
}

cold_inline void camera_draw_geometry(const options *o)
{
    camera_sheet s = {.g = figure_begin(o, "02_camera_geometry.svg", 820, camera_sheet_h)};
    first_camera c = first_camera_at(vec(0, 0, 0), vec(0, 0, -1), vec(0, 1, 0), 56, 8, 6);
    s.seen_by = camera_at(vec(2.5, 1.7, 1.9), vec(0.28, 0.08, -0.85), vec(0, 1, 0), 36,
                          (real)camera_sheet_w / camera_sheet_h);
    figure_origin(&s.g, 0, 0, 1);
    camera_draw_window(&s, c);
    camera_axis(&s, c.e, c.u, 12, 10, FIGURE_RED, "*u*");
    camera_axis(&s, c.e, c.v, 0, -8, FIGURE_GREEN, "*v*");
    camera_axis(&s, c.e, c.w, -10, 16, FIGURE_PURPLE, "*w*");
    double x, y;
    camera_spot(&s, c.e, &x, &y);
    figure_dot(&s.g, x, y, 6, FIGURE_BLACK);
    figure_text(&s.g, x, y, -20, 2, FIGURE_MIDDLE, FIGURE_BLACK, "*e*");

    c = first_camera_at(vec(0, 0, 0), vec(0, 0, -1), vec(0, 1, 0), 56, 6, 6);
    figure_origin(&s.g, 545, 110, 95);
    camera_draw_side(&s.g, c, false);
    figure_arc(&s.g, 0, 0, 42, 0, 28, FIGURE_BLACK, 1.5);
    figure_line(&s.g, 0, 0, 1, 0, FIGURE_BLACK, 1, FIGURE_DASHED);
    figure_text(&s.g, 0, 0, 16, -26, FIGURE_MIDDLE, FIGURE_BLACK, "\xcf\x86/2");
    figure_text(&s.g, 2, 0, 14, 5, FIGURE_LEFT, FIGURE_BLACK, "(2.5)");
    figure_text(&s.g, 0.5, 0, 0, 62, FIGURE_MIDDLE, FIGURE_BLACK, "_d_ = 1");
    figure_origin(&s.g, 545, 300, 95);
    camera_draw_side(&s.g, c, true);
    figure_text(&s.g, 2, 0, 14, 5, FIGURE_LEFT, FIGURE_BLACK, "(2.4)");
    figure_end(&s.g);
}

/* The three faces of a block that the eye sees, and their edges carried on. */
cold_inline void camera_draw_vanishing(const options *o)
{
    static const char *const colour[3] = {FIGURE_RED, FIGURE_GREEN, FIGURE_BLUE};
    camera_sheet s = {.g = figure_begin(o, "02_camera_vanishing.svg", 560, 450)};
    double x[3], y[3], xy[8];
    s.seen_by = camera_at(vec(3.1, 1.9, 2.3), vec(0, 0, 0), vec(0, 0, 1), 100,
                          (real)camera_sheet_w / camera_sheet_h);
    figure_origin(&s.g, 110, -40, 1);
    for (int k = 0; k < 3; k++) {
        vec3 axis = vwith(vec(0, 0, 0), k, 1);
        real u = 0, v = 0;
        if (!camera_vanishing_point(s.seen_by, axis, camera_sheet_w, camera_sheet_h, &u, &v))
            abort();
        x[k] = (double)u, y[k] = -(double)v;
        for (int i = 0; i < 4; i++) {  /* round the face across axis k; edges along it */
            vec3 p = vwith(vwith(axis, (k + 1) % 3, i == 1 || i == 2 ? 1 : -1), (k + 2) % 3,
                           i < 2 ? 1 : -1);
            camera_spot(&s, p, &xy[2 * i], &xy[2 * i + 1]);
            figure_line(&s.g, xy[2 * i], xy[2 * i + 1], x[k], y[k], colour[k], 1, FIGURE_WHOLE);
        }
        figure_polygon(&s.g, 4, xy, colour[k], 0.3, FIGURE_BLACK);
        figure_dot(&s.g, x[k], y[k], 6, colour[k]);
    }
    figure_line(&s.g, x[0], y[0], x[1], y[1], FIGURE_BLACK, 2, FIGURE_WHOLE);
    figure_text(&s.g, (x[0] + x[1]) / 2, y[0], 0, -8, FIGURE_MIDDLE, FIGURE_BLACK, "horizon");
    figure_end(&s.g);
}
#endif
