/* implicit_figure.h: one ray, three ways: 05_implicit_roots.svg.
 *
 *   implicit_draw_roots(&o)    a ray that cuts the near side of a torus's tube in two roots, and
 *                              the far side in two more. Above, f along the ray and the steps of
 *                              first.h, which pass the first two; in the middle the torus, cut
 *                              open, and the circles of sphere tracing; below the pieces of
 *                              search.h, each a box as high as f(T). All as the code asks for them
 */
#ifndef IMPLICIT_FIGURE_H
#define IMPLICIT_FIGURE_H

#include "../../../common/lab/figure.h"
#include "implicit_trials.h"

/* ---------------------------------------------------------------------------------------------- */

enum { implicit_most_asked = 400, implicit_drawn_steps = 10 };
typedef struct { vec3 p; interval T, f; } implicit_answer;  /* at p, or over T: f */
static implicit_answer implicit_record[implicit_most_asked];  /* one drawing at a time */
static int implicit_recorded;

/* In the plane y = 0, 0.25 above the middle of the left tube, whose radius is 0.3. */
static const ray implicit_figure_ray = {{-2, 0, (real)0.33}, 0, {1, 0, (real)-0.08}, 4};

static inline void implicit_keep(implicit_answer a)
{
    if (implicit_recorded < implicit_most_asked) implicit_record[implicit_recorded++] = a;
}

static real implicit_recorded_f(const void *ring, vec3 p)
{
    real f = implicit_torus_distance_f(ring, p);
    implicit_keep((implicit_answer){.p = p, .f = interval_at((double)f)});
    return f;
}

/* The ray begins at x = -2 with d.x = 1: T is x + 2. */
static jet implicit_recorded_range(const void *ring, jet x, jet y, jet z)
{
    jet J = implicit_torus_distance_range(ring, x, y, z);
    if (interval_width(x.v) > 1e-6)
        implicit_keep((implicit_answer){.T = interval_add(x.v, interval_at(2)), .f = J.v});
    return J;
}

/* Panels: t from 60 to 860 pixels, the line f = 0, and what it is. */
static inline void implicit_axis(figure *g, double y, double scale, const char *title)
{
    figure_origin(g, 60, y, 1);
    figure_arrow(g, 0, 0, 830, 0, FIGURE_BLACK, 1);
    figure_text(g, 830, 0, 4, 18, FIGURE_MIDDLE, FIGURE_BLACK, "_t_");
    figure_text(g, 0, scale, -48, -8, FIGURE_LEFT, FIGURE_BLACK, title);
}

static inline void implicit_curve(figure *g, double scale, const char *colour, double width)
{
    double last = 0;
    for (int k = 0; k <= 400; k++) {
        vec3 p = ray_at(implicit_figure_ray, (real)(k / 100.0));
        double f = scale * (double)implicit_torus_distance_f(&implicit_tube, p);
        if (k) figure_line(g, 2 * k - 2, last, 2 * k, f, colour, width, FIGURE_WHOLE);
        last = f;
    }
}

static inline void implicit_draw_steps(figure *g, const implicit_surface *s)
{
    const double scale = 130;
    hit h = hit_none;
    implicit_axis(g, 160, 130, "fixed steps: _f_ at _t_~k~, until its sign changes");
    implicit_curve(g, scale, FIGURE_SKY, 2);
    implicit_asked = s;
    implicit_recorded = 0;
    if (!first_implicit_hit(implicit_asked_value, implicit_figure_ray, implicit_drawn_steps, &h))
        abort();
    for (int k = 0; k < implicit_recorded; k++) {
        double x = 200 * ((double)implicit_record[k].p.x + 2);
        double y = scale * implicit_record[k].f.lo;
        figure_line(g, x, 0, x, y, FIGURE_BLUE, 1, FIGURE_WHOLE);
        figure_dot(g, x, y, k <= implicit_drawn_steps ? 4 : 2, FIGURE_BLUE);
    }
    figure_dot(g, 200 * (double)h.t, 0, 5, FIGURE_RED);
    figure_text(g, 200 * (double)h.t, 0, -4, 42, FIGURE_MIDDLE, FIGURE_RED,
                "found: the third root");
    figure_arrow(g, 200, -45, 200, -10, FIGURE_RED, 1.5);
    figure_text(g, 200, -45, 0, 14, FIGURE_MIDDLE, FIGURE_RED, "two roots, no step between them");
}

static inline void implicit_draw_circles(figure *g, const implicit_surface *s)
{
    hit h = hit_none;
    ray r = implicit_figure_ray;
    figure_origin(g, 460, 432, 200);
    figure_text(g, 2, 0.5, 0, -12, FIGURE_RIGHT, FIGURE_BLACK,
                "sphere tracing: each circle is free of the surface");
    implicit_recorded = 0;
    if (!implicit_trace_hit(s, r, (real)0.003, 200, &h)) abort();
    double xy[128];
    for (int k = 0; k < 2; k++) {
        for (int i = 0; i < 64; i++) {
            xy[2 * i] = 2 * k - 1 + 0.3 * cos(i * 3.14159265 / 32);
            xy[2 * i + 1] = 0.3 * sin(i * 3.14159265 / 32);
        }
        figure_polygon(g, 64, xy, FIGURE_ORANGE, 0.35, FIGURE_BLACK);
    }
    for (int k = 0; k < implicit_recorded; k++) {
        double x = (double)implicit_record[k].p.x, y = (double)implicit_record[k].p.z;
        double free = 200 * fabs(implicit_record[k].f.lo);
        for (int turn = 0; turn < 360; turn += 120)
            figure_arc(g, x, y, free, turn, turn + 120, FIGURE_GREEN, 1.5);
        figure_dot(g, x, y, 2.5, FIGURE_GREEN);
    }
    vec3 from = r.o, to = ray_at(r, 4), at = ray_at(r, h.t);
    figure_arrow(g, (double)from.x, (double)from.z, (double)to.x, (double)to.z, FIGURE_BLUE, 1.5);
    figure_dot(g, (double)at.x, (double)at.z, 5, FIGURE_RED);
    figure_text(g, (double)from.x, (double)from.z, -8, 6, FIGURE_RIGHT, FIGURE_BLACK, "*o*");
    figure_text(g, (double)at.x, (double)at.z, 4, -10, FIGURE_LEFT, FIGURE_RED,
                "found, a little before the first root");
    figure_text(g, 1, 0, 0, 5, FIGURE_MIDDLE, FIGURE_BLACK, "_f_ < 0");
    figure_text(g, 0, 0, 0, 20, FIGURE_MIDDLE, FIGURE_BLACK, "_f_ > 0");
}

static inline void implicit_draw_boxes(figure *g, const implicit_surface *s)
{
    const double scale = 130, most = 1.06;
    implicit_root root[8];
    implicit_axis(g, 690, 138, "intervals: _f_(_T_) of each piece _T_");
    implicit_recorded = 0;
    int roots = implicit_roots(s, implicit_figure_ray, root, 8);
    for (int turn = 0; turn < 2; turn++)  /* the proven ones in front */
        for (int k = 0; k < implicit_recorded; k++) {
            interval T = implicit_record[k].T, f = implicit_record[k].f;
            bool open = interval_has(f, 0);
            if (open != (turn == 0)) continue;
            double a = 200 * T.lo, b = 200 * T.hi, lo = scale * fmax(f.lo, -0.36);
            double hi = scale * fmin(f.hi, most);
            const double box[] = {a, lo, b, lo, b, hi, a, hi};
            figure_polygon(g, 4, box, open ? FIGURE_GREY : FIGURE_GREEN, open ? 0.06 : 0.35,
                           open ? "#bbbbbb" : FIGURE_GREEN);
        }
    implicit_curve(g, scale, FIGURE_BLUE, 1.5);
    for (int k = 0; k < roots; k++)
        figure_dot(g, 100 * (root[k].lo + root[k].hi), 0, 5, FIGURE_RED);
    figure_text(g, 400, 0, 0, 64, FIGURE_MIDDLE, FIGURE_GREEN,
                "green: 0 is not in _f_(_T_): no root");
    figure_text(g, 100 * (root[0].lo + root[0].hi), 0, 4, 64, FIGURE_RIGHT, FIGURE_RED,
                "found and proven: all four");
}

cold_inline void implicit_draw_roots(const options *o)
{
    implicit_surface s = implicit_torus_distance(&implicit_tube);
    s.f = implicit_recorded_f, s.range = implicit_recorded_range;
    implicit_surface all = s;
    all.ball.r = (real)2.5;  /* all begin at o, not where the ray enters the ball */
    figure g = figure_begin(o, "05_implicit_roots.svg", 920, 770);
    implicit_draw_steps(&g, &s);
    implicit_draw_circles(&g, &all);
    implicit_draw_boxes(&g, &all);
    figure_end(&g);
}

#endif
