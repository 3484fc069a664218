/* triangle_figures.h: the two drawings that explain: weights as areas, and the edge functions. The
 * numbers in them are those that triangle_weights and the watertight test compute.
 *
 *   triangle_draw_areas(&o)    a point inside, and one outside: w, u, v as areas (4.6), (4.11)
 *   triangle_draw_edges(&o)    two triangles seen along a ray (4.9), and their edge functions
 *                              (4.10)
 */
#ifndef TRIANGLE_FIGURES_H
#define TRIANGLE_FIGURES_H

#include "../../../common/lab/figure.h"
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

cold_inline void triangle_draw_areas(const options *o)
{
    const triangle t = {{0, 0, 0}, {1.9, 0.1, 0}, {0.7, 1.6, 0}};
    const vec3 inside = triangle_at(t, (real)0.4, (real)0.28);
    const vec3 outside = triangle_at(t, (real)0.8, (real)0.75);
    figure g = figure_begin(o, "04_triangle_areas.svg", 820, 360);
    for (int k = 0; k < 2; k++) {
        vec3 p = k ? outside : inside;
        vec3 n = triangle_weights(t, p);
        figure_origin(&g, k ? 440 : 40, 300, 150);
        figure_area(&g, p, t.c, t.a, FIGURE_GREEN, "u", n.y);
        figure_area(&g, p, t.a, t.b, FIGURE_BLUE, "v", n.z);
        figure_corners(&g, t);
        figure_area(&g, p, t.b, t.c, FIGURE_RED, "w", n.x);
        figure_dot(&g, (double)p.x, (double)p.y, 4, FIGURE_BLACK);
        figure_text(&g, (double)p.x, (double)p.y, 8, -6, FIGURE_LEFT, FIGURE_BLACK, "*p*");
        figure_print(&g, 0.95, 0, 0, 46, FIGURE_MIDDLE, FIGURE_BLACK,
                      k ? "outside: _w_ is negative, and the sum is still %.2f"
                        : "inside: none is negative; the sum is %.2f",
                      (double)(n.x + n.y + n.z));
    }
    figure_end(&g);
}

cold_inline void triangle_draw_edges(const options *o)
{
    /* The ray begins in the origin, and goes down the z axis, a little askew. */
    const ray r = ray_from((vec3){0, 0, 0}, vec(0.2, -0.1, -1));
    const vec3 corner[4] = {vec(0.78, -1.35, -3), vec(0.95, 0.6, -2.6), vec(-1.2, -0.4, -3.2),
                            vec(2.55, -0.75, -3)};  /* a, b, c of the left; the right's third */
    const int of[2][3] = {{0, 1, 2}, {1, 0, 3}};
    static const struct { double right, down; const char *where, *text; }
        corner_name[4] = {{4, 20, FIGURE_MIDDLE, "*a*"}, {4, -9, FIGURE_MIDDLE, "*b*"},
                          {-10, 5, FIGURE_RIGHT, "*c*"}, {10, 5, FIGURE_LEFT, "*c*\u2032"}},
        edge_name[2][3] = {{{-10, 46, FIGURE_RIGHT, "_E_(*a*, *b*) = "},
                            {-6, -10, FIGURE_MIDDLE, ""}, {-6, 22, FIGURE_MIDDLE, ""}},
                           {{10, -12, FIGURE_LEFT, "_E_(*b*, *a*) = "},
                            {0, 22, FIGURE_MIDDLE, ""}, {20, -10, FIGURE_MIDDLE, ""}}};
    figure g = figure_begin(o, "04_triangle_edges.svg", 820, 420);
    ray_shear s = shear_of(r);
    for (int k = 0; k < 2; k++) {
        const triangle t = {corner[of[k][0]], corner[of[k][1]], corner[of[k][2]]};
        const char *colour = k ? FIGURE_RED : FIGURE_BLUE;
        double x[3], y[3];
        vec3 v[3];
        hit h;
        for (int i = 0; i < 3; i++) {
            v[i] = shear_corner(&corner[of[k][i]], &s);
            x[i] = (double)v[i].x, y[i] = (double)v[i].y;
        }
        figure_origin(&g, k ? 404 : 396, 190, 150);  /* a little apart */
        const double xy[] = {x[0], y[0], x[1], y[1], x[2], y[2]};
        figure_polygon(&g, 3, xy, colour, 0.15, NULL);
        for (int i = 0, j = 1; i < 3; i++, j = (i + 1) % 3) {
            real e = v[i].x * v[j].y - v[i].y * v[j].x;                             /* (4.10) */
            figure_arrow(&g, x[i], y[i], x[j], y[j], colour, 1.5);
            figure_print(&g, (x[i] + x[j]) / 2, (y[i] + y[j]) / 2, edge_name[k][i].right,
                         edge_name[k][i].down, edge_name[k][i].where, colour, "%s%s%.2f",
                         edge_name[k][i].text, e < 0 ? "\u2212" : "+", fabs((double)e));
        }
        figure_text(&g, (x[0] + x[1] + x[2]) / 3, (y[0] + y[1] + y[2]) / 3, k ? 20 : -40,
                    k ? 12 : 10, FIGURE_MIDDLE, colour, triangle_hit(t, r, &h) ? "one sign: hit"
                                                                  : "two signs: no hit");
        for (int i = k ? 2 : 0; i < 3; i++) {
            int c = of[k][i];
            figure_text(&g, x[i], y[i], corner_name[c].right, corner_name[c].down,
                        corner_name[c].where, FIGURE_BLACK, corner_name[c].text);
        }
    }
    figure_origin(&g, 400, 190, 150);
    figure_dot(&g, 0, 0, 5, FIGURE_BLACK);
    figure_text(&g, 0, 0, -8, -8, FIGURE_RIGHT, FIGURE_BLACK, "the ray");
    figure_end(&g);
}

#endif
