/* ways_figure.h: the drawing of this chapter: a piece of a lamp as the point x sees it; and one
 * matter for two ways: their densities by the real code, and the weights of (24.9).
 *
 *   draw_ways(&o);      24_direct_light_ways.svg
 */
#ifndef DIRECT_WAYS_FIGURE_H
#define DIRECT_WAYS_FIGURE_H

#include "../../../common/lab/figure.h"
#include "../../23_brdf/brdf.h"
#include "../emitter.h"
#include "../mis.h"

/* ---------------------------------------------------------------------------------------------- */

/* cos' dA / r^2: the lamp, a piece of it, the cone from x, and the piece as seen from there. */
static inline void ways_piece(figure *g)
{
    const double q[2] = {0.75, 1.2}, along[2] = {cos(-0.12), sin(-0.12)}, half = 0.17;
    double r = sqrt(q[0] * q[0] + q[1] * q[1]), wi[2] = {q[0] / r, q[1] / r};
    double there = along[0] * wi[1] - along[1] * wi[0];     /* cos theta' */
    double a[2] = {q[0] - half * along[0], q[1] - half * along[1]};
    double b[2] = {q[0] + half * along[0], q[1] + half * along[1]};
    double beam[6] = {0, 0, a[0], a[1], b[0], b[1]}, seen = half * there;
    figure_polygon(g, 3, beam, FIGURE_SKY, 0.35, NULL);
    figure_line(g, -0.35, 0, 1.15, 0, FIGURE_GREY, 3, FIGURE_WHOLE);
    figure_line(g, q[0] - 0.6 * along[0], q[1] - 0.6 * along[1], q[0] + 0.6 * along[0],
                q[1] + 0.6 * along[1], FIGURE_ORANGE, 4, FIGURE_WHOLE);
    figure_line(g, a[0], a[1], b[0], b[1], FIGURE_RED, 7, FIGURE_WHOLE);
    figure_line(g, q[0] - 0.16 * wi[0] + seen * wi[1], q[1] - 0.16 * wi[1] - seen * wi[0],
                q[0] - 0.16 * wi[0] - seen * wi[1], q[1] - 0.16 * wi[1] + seen * wi[0],
                FIGURE_BLUE, 3, FIGURE_WHOLE);
    figure_line(g, 0, 0, q[0], q[1], FIGURE_BLACK, 1, FIGURE_DASHED);
    figure_arrow(g, 0, 0, 0, 0.62, FIGURE_BLACK, 1.5);
    figure_arrow(g, 0, 0, 0.5 * wi[0], 0.5 * wi[1], FIGURE_BLACK, 1.8);
    figure_arrow(g, q[0], q[1], q[0] + 0.55 * along[1], q[1] - 0.55 * along[0], FIGURE_BLACK, 1.5);
    figure_arc(g, 0, 0, 38, 58, 90, FIGURE_BLACK, 1.2);
    figure_arc(g, q[0], q[1], 46, 238, 263, FIGURE_BLACK, 1.2);
    figure_dot(g, 0, 0, 4, FIGURE_BLACK);
    figure_text(g, 0, 0, -8, 20, FIGURE_LEFT, FIGURE_BLACK, "*x*");
    figure_text(g, 0, 0.62, -6, 6, FIGURE_RIGHT, FIGURE_BLACK, "*n*");
    figure_text(g, 0.09, 0.36, 0, 0, FIGURE_LEFT, FIGURE_BLACK, "_θ_");
    figure_text(g, 0.3, 0.35, 8, 10, FIGURE_LEFT, FIGURE_BLACK, "*ω*~i~");
    figure_text(g, q[0], q[1], 4, -12, FIGURE_LEFT, FIGURE_RED, "d_A_ at *q*");
    figure_text(g, 0.5, 1.06, -4, 0, FIGURE_RIGHT, FIGURE_BLUE, "cos _θ_' d_A_");
    figure_text(g, q[0], q[1], -22, 66, FIGURE_LEFT, FIGURE_BLACK, "_θ_'");
    figure_text(g, q[0] + 0.55 * along[1], q[1] - 0.55 * along[0], 8, 4, FIGURE_LEFT, FIGURE_BLACK,
                "*n*'");
    figure_text(g, 0.24, 0.62, -4, 0, FIGURE_RIGHT, FIGURE_BLACK, "_r_");
    figure_text(g, 0.4, 0, 0, 48, FIGURE_MIDDLE, FIGURE_BLACK, "d_ω_~i~ = cos _θ_' d_A_ / _r_²");
}

/* A plate of roughness .35 and a lamp of radius .28, one away; directions in the plane of wo and n,
 * by their angle from n in degrees. */
enum { ways_out = -40, ways_lamp = 55 };
static inline vec3 ways_direction(double degrees)
{
    double a = degrees * (double)pi / 180;
    return vec((real)sin(a), 0, (real)cos(a));
}

/* The density of a direction, by the plate or by the lamp; or its weight. */
typedef struct { bool lamp, weight; } ways_choice;
static inline double ways_value(ways_choice of, double degrees)
{
    const real R = (real)0.28;
    brdf b = brdf_ggx((vec3){1, 1, 1}, (real)0.35);
    emitter e = emitter_of_sphere((sphere){ways_direction(ways_lamp), R}, (vec3){1, 1, 1});
    bool meets = fabs(degrees - ways_lamp) < asin((double)R) * 180 / (double)pi;
    real plate = brdf_pdf_local(&b, ways_direction(degrees), ways_direction(ways_out));
    real lamp = meets ? emitter_pdf_angle(&e, (vec3){0, 0, 0}) : 0;
    real own = of.lamp ? lamp : plate, other = of.lamp ? plate : lamp;
    return (double)(of.weight ? mis_power(own, other) : own);
}

/* Its curve over 0 to 85 degrees, a unit wide; densities up to 8. */
static inline void ways_curve(figure *g, ways_choice of, const char *colour)
{
    double most = of.weight ? 1 : 8;
    for (double x = 0; x < 85; x += 0.25)
        figure_line(g, x / 85, ways_value(of, x) / most, (x + 0.25) / 85,
                    ways_value(of, x + 0.25) / most, colour, 2.5, FIGURE_WHOLE);
}

static inline void ways_axes(figure *g, const char *title, const char *top)
{
    figure_line(g, 0, 0, 1, 0, FIGURE_BLACK, 1, FIGURE_WHOLE);
    figure_line(g, 0, 0, 0, 1.05, FIGURE_BLACK, 1, FIGURE_WHOLE);
    for (int x = 0; x <= 80; x += 20) {
        figure_line(g, x / 85.0, 0, x / 85.0, -0.02, FIGURE_BLACK, 1, FIGURE_WHOLE);
        figure_print(g, x / 85.0, 0, 0, 20, FIGURE_MIDDLE, FIGURE_BLACK, "%d°", x);
    }
    figure_text(g, 0, 1, -6, 5, FIGURE_RIGHT, FIGURE_BLACK, top);
    figure_text(g, 0.5, 0, 0, 48, FIGURE_MIDDLE, FIGURE_BLACK, title);
}

cold_inline void draw_ways(const options *o)
{
    figure g = figure_begin(o, "24_direct_light_ways.svg", 1040, 330);
    figure_origin(&g, 80, 260, 165);
    ways_piece(&g);
    figure_origin(&g, 420, 260, 230);
    ways_axes(&g, "two densities of the same direction", "8");
    ways_curve(&g, (ways_choice){false, false}, FIGURE_BLUE);
    ways_curve(&g, (ways_choice){true, false}, FIGURE_ORANGE);
    figure_text(&g, 0.03, 0.93, 0, 0, FIGURE_LEFT, FIGURE_BLUE, "_p_~B~: the plate");
    figure_text(&g, 0.86, 0.55, 0, 0, FIGURE_MIDDLE, FIGURE_ORANGE, "_p_~L~: the lamp");
    figure_origin(&g, 760, 260, 230);
    ways_axes(&g, "their weights, by squares", "1");
    ways_curve(&g, (ways_choice){false, true}, FIGURE_BLUE);
    ways_curve(&g, (ways_choice){true, true}, FIGURE_ORANGE);
    figure_text(&g, 0.2, 0.88, 0, 0, FIGURE_MIDDLE, FIGURE_BLUE, "_w_~B~");
    figure_text(&g, 0.72, 0.7, 0, 0, FIGURE_MIDDLE, FIGURE_ORANGE, "_w_~L~");
    figure_end(&g);
}

#endif
