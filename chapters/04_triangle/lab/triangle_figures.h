/* triangle_figures.h: the two drawings that explain: weights as areas, and the edge functions. The
 * numbers in them are those that barycentrics_of and the watertight test compute.
 *
 *   triangle_draw_areas(&o)    a point inside, and one outside: w, u, v as areas (4.6), (4.11)
 *   triangle_draw_edges(&o)    two triangles seen along a ray (4.9), and their edge functions
 *                              (4.10)
 */
#ifndef TRIANGLE_FIGURES_H
#define TRIANGLE_FIGURES_H

#include "../../../common/lab/figure.h"
#include "../barycentrics.h"
#include "../triangle.h"

/* ---------------------------------------------------------------------------------------------- */

/* A part of the whole, opposite its corner: p and the other two. Negative: an outline. */
static inline void figure_area(figure *g, vec3 p, vec3 from, vec3 to, const char *colour,
                               const char *name, real weight)
{
    const double xy[] = {(double)p.x, (double)p.y, (double)from.x, (double)from.y,
                         (double)to.x, (double)to.y};
    vec3 m = vscale(vadd(vadd(p, from), to), (real)1 / 3);
    figure_polygon(g, 3, xy, weight < 0 ? NULL : colour, 0.3, colour);
    for (int k = 0; weight < 0 && k < 3; k++)
        figure_line(g, xy[2 * k], xy[2 * k + 1], xy[(2 * k + 2) % 6], xy[(2 * k + 3) % 6], colour,
                    3, FIGURE_WHOLE);
    /* w stands outside, beside its part: inside, a line would cross it. */
    bool beside = *name == 'w';
    vec3 other = weight < 0 ? p : from;
    if (beside) m = vscale(vadd(to, other), (real)0.5);
    double right = beside ? 12 : *name == 'u' && 2 * weight < 1 ? 11 : 0;
    figure_print(g, (double)m.x, (double)m.y, right, beside ? -8 : 5,
                  beside ? FIGURE_LEFT : FIGURE_MIDDLE, beside ? colour : FIGURE_BLACK,
                  "_%s_ = %s%.2f", name, weight < 0 ? "\u2212" : "", fabs((double)weight));
}

static inline void figure_corners(figure *g, triangle t)
{
    const double xy[] = {(double)t.a.x, (double)t.a.y, (double)t.b.x, (double)t.b.y,
                         (double)t.c.x, (double)t.c.y};
    figure_polygon(g, 3, xy, NULL, 1, FIGURE_BLACK);
    figure_text(g, xy[0], xy[1], -10, 14, FIGURE_RIGHT, FIGURE_BLACK, "*a*");
    figure_text(g, xy[2], xy[3], 10, 14, FIGURE_LEFT, FIGURE_BLACK, "*b*");
    figure_text(g, xy[4], xy[5], 0, -10, FIGURE_MIDDLE, FIGURE_BLACK, "*c*");
}

static inline void triangle_draw_areas(const options *o)
{
    const triangle t = {{0, 0, 0}, {1.9, 0.1, 0}, {0.7, 1.6, 0}};
    const vec3 inside = triangle_at(t, (real)0.4, (real)0.28);
    const vec3 outside = triangle_at(t, (real)0.8, (real)0.75);
    figure g = figure_begin(o, "04_triangle_areas.svg", 820, 360);
    for (int k = 0; k < 2; k++) {
        vec3 p = k ? outside : inside;
        barycentrics n = barycentrics_of(t, p);
        figure_origin(&g, k ? 440 : 40, 300, 150);
        figure_area(&g, p, t.c, t.a, FIGURE_GREEN, "u", n.u);
        figure_area(&g, p, t.a, t.b, FIGURE_BLUE, "v", n.v);
        figure_corners(&g, t);
        figure_area(&g, p, t.b, t.c, FIGURE_RED, "w", n.w);
        figure_dot(&g, (double)p.x, (double)p.y, 4, FIGURE_BLACK);
        figure_text(&g, (double)p.x, (double)p.y, 8, -6, FIGURE_LEFT, FIGURE_BLACK, "*p*");
        figure_print(&g, 0.95, 0, 0, 46, FIGURE_MIDDLE, FIGURE_BLACK,
                      k ? "outside: _w_ is negative, and the sum is still %.2f"
                        : "inside: none is negative; the sum is %.2f",
                      (double)barycentrics_sum(n));
    }
    figure_end(&g);
}

/* An edge as the watertight test sees it, and the value of its edge function beside it. */
static inline void figure_edge(figure *g, vec3 from, vec3 to, real value, double right,
                               double down, const char *where, const char *colour,
                               const char *name)
{
    figure_arrow(g, (double)from.x, (double)from.y, (double)to.x, (double)to.y, colour, 1.5);
    figure_print(g, (double)(from.x + to.x) / 2, (double)(from.y + to.y) / 2, right, down, where,
                  colour, "%s%s%.2f", name, value < 0 ? "\u2212" : "+", fabs((double)value));
}

static inline void triangle_draw_edges(const options *o)
{
    /* The ray begins in the origin, and goes down the z axis, a little askew. */
    const ray r = ray_from((vec3){0, 0, 0}, vec(0.2, -0.1, -1));
    const vec3 corner[4] = {vec(0.78, -1.35, -3), vec(0.95, 0.6, -2.6), vec(-1.2, -0.4, -3.2),
                            vec(2.55, -0.75, -3)};  /* a, b, c of the left; the right's third */
    const int of[2][3] = {{0, 1, 2}, {1, 0, 3}};
    figure g = figure_begin(o, "04_triangle_edges.svg", 820, 420);
    ray_shear s = shear_of(r);
    for (int k = 0; k < 2; k++) {
        vec3 v[3];
        hit h;
        const char *colour = k ? FIGURE_RED : FIGURE_BLUE;
        for (int i = 0; i < 3; i++) v[i] = shear_corner(&corner[of[k][i]], &s);
        const triangle t = {corner[of[k][0]], corner[of[k][1]], corner[of[k][2]]};
        const real e[3] = {v[0].x * v[1].y - v[0].y * v[1].x, v[1].x * v[2].y - v[1].y * v[2].x,
                           v[2].x * v[0].y - v[2].y * v[0].x};
        const double xy[] = {(double)v[0].x, (double)v[0].y, (double)v[1].x, (double)v[1].y,
                             (double)v[2].x, (double)v[2].y};
        figure_origin(&g, k ? 404 : 396, 190, 150);  /* a little apart */
        figure_polygon(&g, 3, xy, colour, 0.15, NULL);
        figure_edge(&g, v[0], v[1], e[0], k ? 10 : -10, k ? -12 : 46,
                    k ? FIGURE_LEFT : FIGURE_RIGHT, colour,
                    k ? "_E_(*b*, *a*) = " : "_E_(*a*, *b*) = ");
        figure_edge(&g, v[1], v[2], e[1], k ? 0 : -6, k ? 22 : -10, FIGURE_MIDDLE, colour, "");
        figure_edge(&g, v[2], v[0], e[2], k ? 20 : -6, k ? -10 : 22, FIGURE_MIDDLE, colour, "");
        figure_text(&g, (xy[0] + xy[2] + xy[4]) / 3, (xy[1] + xy[3] + xy[5]) / 3, k ? 20 : -40,
                    k ? 12 : 10, FIGURE_MIDDLE, colour, triangle_hit(t, r, &h) ? "one sign: hit"
                                                                  : "two signs: no hit");
        if (k) {
            figure_text(&g, xy[4], xy[5], 10, 5, FIGURE_LEFT, FIGURE_BLACK, "*c*\u2032");
            continue;
        }
        figure_text(&g, xy[0], xy[1], 4, 20, FIGURE_MIDDLE, FIGURE_BLACK, "*a*");
        figure_text(&g, xy[2], xy[3], 4, -9, FIGURE_MIDDLE, FIGURE_BLACK, "*b*");
        figure_text(&g, xy[4], xy[5], -10, 5, FIGURE_RIGHT, FIGURE_BLACK, "*c*");
    }
    figure_origin(&g, 400, 190, 150);
    figure_dot(&g, 0, 0, 5, FIGURE_BLACK);
    figure_text(&g, 0, 0, -8, -8, FIGURE_RIGHT, FIGURE_BLACK, "the ray");
    figure_end(&g);
}

#endif
