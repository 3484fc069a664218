/* figures.h: the drawing of the page: the same light on a patch that is tilted.
 *
 *   draw_tilt(&o)      three patches in beams of one width; E is light_reaches' own
 */
#ifndef SHADE_LAB_FIGURES_H
#define SHADE_LAB_FIGURES_H

#include "../../../common/lab/figure.h"
#include "../light.h"

/* ---------------------------------------------------------------------------------------------- */

/* A beam of width 1 from above, about x = middle, and a patch that leans by so many degrees. */
static inline void figure_beam(figure *g, double middle, double degrees)
{
    enum { rays = 7 };
    const double a = degrees * 3.14159265358979 / 180, slope = tan(a), width = 1;
    light sun = {LIGHT_DIRECTIONAL, {0, 1, 0}, {1, 1, 1}};
    vec3 n = vec(-sin(a), cos(a), 0);
    light_sample at;
    light_reaches(&sun, (vec3){0, 0, 0}, n, n, &at);
    double left = middle - width / 2, low = left - middle, half = 0.5 * width / cos(a);
    double beam[8] = {left, 2, left + width, 2, left + width, -low * slope, left, low * slope};
    figure_polygon(g, 4, beam, FIGURE_ORANGE, 0.2, NULL);
    for (int k = 0; k < rays; k++) {
        double x = left + width * (k + 0.5) / rays;
        figure_arrow(g, x, 2, x, (x - middle) * slope + 0.03, FIGURE_ORANGE, 1.2);
    }
    figure_line(g, middle - half * cos(a), -half * sin(a), middle + half * cos(a), half * sin(a),
                FIGURE_BLACK, 5, FIGURE_WHOLE);
    figure_line(g, middle, 0, middle, 1.35, FIGURE_BLACK, 1, FIGURE_DASHED);
    figure_arrow(g, middle, 0, middle + 1.15 * (double)n.x, 1.15 * (double)n.y, FIGURE_BLUE, 2);
    figure_text(g, middle + 1.15 * (double)n.x, 1.15 * (double)n.y, -8, -2, FIGURE_RIGHT,
                FIGURE_BLUE, "*n*");
    figure_text(g, middle, 2, 0, -6, FIGURE_MIDDLE, FIGURE_BLACK, "*l*");
    if (degrees > 0) figure_arc(g, middle, 0, 52, 90, 90 + degrees, FIGURE_BLACK, 1);
    if (degrees > 0) figure_text(g, middle - 0.09, 0.62, 0, 0, FIGURE_RIGHT, FIGURE_BLACK, "_θ_");
    figure_print(g, middle, -1.0, 0, 0, FIGURE_MIDDLE, FIGURE_BLACK, "area %.2f", 2 * half);
    figure_print(g, middle, -1.0, 0, 22, FIGURE_MIDDLE, FIGURE_BLACK, "_E_ = %.2f _E_~0~",
                 (double)at.E.x);
}

static inline void draw_tilt(const options *o)
{
    figure g = figure_begin(o, "18_shade_tilt.svg", 760, 430);
    figure_origin(&g, 130, 275, 115);
    figure_beam(&g, 0, 0), figure_beam(&g, 2, 35), figure_beam(&g, 4.1, 60);
    figure_text(&g, -0.95, 2, 0, -6, FIGURE_LEFT, FIGURE_ORANGE, "one beam");
    figure_end(&g);
}

#endif
