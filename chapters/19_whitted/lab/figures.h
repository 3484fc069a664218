/* figures.h: the drawings of the page, by the code that they explain.
 *
 *   draw_wavefronts(&o)     Snell's law: the fronts of a wave on both sides of a surface
 *   draw_critical(&o)       rays out of water: bent, weaker, and then none
 */
#ifndef WHITTED_LAB_FIGURES_H
#define WHITTED_LAB_FIGURES_H

#include "../../../common/lab/figure.h"
#include "../refract.h"

/* ---------------------------------------------------------------------------------------------- */

static const double degree = 3.14159265358979 / 180;

static inline figure_point figure_along(figure_point p, vec3 d, double t)
{
    return (figure_point){p.x + t * (double)d.x, p.y + t * (double)d.y};
}

/* The fronts through points of the surface that lie `step` apart, at right angles to d; `side` is 1
 * above it, where d comes from, and -1 below. None is drawn beyond the edges of the drawing. */
static inline void figure_fronts(figure *g, vec3 d, double step, int n, real side,
                                 const char *colour)
{
    vec3 across = vscale((vec3){-d.y, d.x, 0}, side);
    double edge = across.x < 0 ? -3.6 : 3.6;
    for (int k = -n; k <= n; k++) {
        figure_point on = {k * step, 0};
        double reach = 2.232 - 0.0864 * fabs(on.x);
        reach = fmin(reach, (edge - on.x) / (double)across.x);
        figure_point end = figure_along(on, across, reach);
        figure_line(g, on.x, on.y, end.x, end.y, colour, 1, FIGURE_WHOLE);
    }
}

cold_inline void draw_wavefronts(const options *o)
{
    const double n1 = 1, n2 = 1.5, angle = 50 * degree, step = 1.2;
    vec3 d = vec(sin(angle), -cos(angle), 0), up = {0, 1, 0};
    snell s;
    snell_of(d, up, (real)n1, (real)n2, &s);
    vec3 w = snell_refract(&s, d, up);
    double bent = asin((double)w.x) / degree;
    figure g = figure_begin(o, "19_whitted_snell.svg", 760, 500);
    figure_origin(&g, 380, 250, 100);
    double glass[8] = {-3.7, 0, 3.7, 0, 3.7, -2.4, -3.7, -2.4};
    figure_polygon(&g, 4, glass, FIGURE_SKY, 0.18, NULL);
    figure_line(&g, -3.7, 0, 3.7, 0, FIGURE_BLACK, 1.5, FIGURE_WHOLE);
    figure_fronts(&g, d, step, 3, 1, FIGURE_BLUE);
    figure_fronts(&g, w, step, 3, -1, FIGURE_RED);
    figure_point a = {0, 0}, b = {step, 0};
    /* the way that the front has still to go at b, and has gone at a */
    figure_point before = figure_along(b, d, -step * (double)d.x);
    figure_point after = figure_along(a, w, step * (double)w.x);
    figure_line(&g, before.x, before.y, b.x, b.y, FIGURE_BLUE, 3.5, FIGURE_WHOLE);
    figure_line(&g, a.x, a.y, after.x, after.y, FIGURE_RED, 3.5, FIGURE_WHOLE);
    figure_line(&g, a.x, a.y, b.x, b.y, FIGURE_BLACK, 3.5, FIGURE_WHOLE);
    figure_line(&g, 0, -2.2, 0, 2.2, FIGURE_GREY, 1, FIGURE_DASHED);
    figure_point in = figure_along(a, d, -2.3), out = figure_along(a, w, 2.3);
    figure_arrow(&g, in.x, in.y, 0, 0, FIGURE_BLACK, 1.5);
    figure_arrow(&g, 0, 0, out.x, out.y, FIGURE_BLACK, 1.5);
    figure_arc(&g, 0, 0, 60, 90, 90 + angle / degree, FIGURE_BLACK, 1);
    figure_arc(&g, 0, 0, 60, 270, 270 + bent, FIGURE_BLACK, 1);
    figure_text(&g, -0.36, 0.72, 0, 0, FIGURE_MIDDLE, FIGURE_BLACK, "_i_");
    figure_text(&g, 0.2, -0.78, 0, 0, FIGURE_MIDDLE, FIGURE_BLACK, "_t_");
    figure_text(&g, in.x, in.y, -6, 2, FIGURE_RIGHT, FIGURE_BLACK, "*d*");
    figure_text(&g, out.x, out.y, 8, -4, FIGURE_LEFT, FIGURE_BLACK, "*w*");
    figure_text(&g, 0, 2.2, 6, -4, FIGURE_LEFT, FIGURE_GREY, "*n*");
    figure_text(&g, step / 2, 0, 0, -18, FIGURE_MIDDLE, FIGURE_BLACK, "_a_");
    figure_text(&g, 1.57, 0.35, 0, 0, FIGURE_LEFT, FIGURE_BLUE, "_λ_ / _n_~1~ = _a_ sin _i_");
    figure_text(&g, 1.02, -1.4, 0, 0, FIGURE_LEFT, FIGURE_RED, "_λ_ / _n_~2~ = _a_ sin _t_");
    figure_text(&g, -3.6, 2.3, 0, -4, FIGURE_LEFT, FIGURE_BLACK, "air, _n_~1~ = 1");
    figure_text(&g, -3.6, -2.3, 0, 2, FIGURE_LEFT, FIGURE_BLACK, "glass, _n_~2~ = 1.5");
    figure_end(&g);
}

/* One ray from a lamp under water, at `degrees`: what goes out as thick as 1 - R, what is reflected
 * as thick as R. */
static inline void figure_out_of_water(figure *g, figure_point lamp, double degrees)
{
    double a = degrees * degree;
    vec3 d = vec(sin(a), cos(a), 0), down = {0, -1, 0};
    snell s;
    bool bends = snell_of(d, down, (real)1.33, 1, &s);
    double R = (double)fresnel(&s), reach = -lamp.y / (double)d.y;
    figure_point on = figure_along(lamp, d, reach);
    vec3 back = reflect(d, down);
    double far = 0.85 * lamp.y / (double)back.y;
    if (on.x + far * (double)back.x > 5.8) far = (5.8 - on.x) / (double)back.x;
    figure_point below = figure_along(on, back, far);
    const char *colour = bends ? FIGURE_BLUE : FIGURE_RED;
    figure_line(g, lamp.x, lamp.y, on.x, on.y, colour, 2.5, FIGURE_WHOLE);
    figure_line(g, on.x, on.y, below.x, below.y, colour, 0.3 + 3 * R, FIGURE_DASHED);
    if (!bends) return;
    figure_point out = figure_along(on, snell_refract(&s, d, down), 1.55);
    figure_arrow(g, on.x, on.y, out.x, out.y, FIGURE_BLUE, 0.3 + 3 * (1 - R));
    figure_print(g, out.x, out.y, 8, 4, FIGURE_LEFT, FIGURE_BLUE, "%.0f %%", 100 * (1 - R));
}

cold_inline void draw_critical(const options *o)
{
    static const double fan[] = {0, 15, 30, 40, 45, 48, 55, 65};
    const figure_point lamp = {0, -1.6};
    double critical = asin(1 / 1.33);
    figure g = figure_begin(o, "19_whitted_critical.svg", 760, 420);
    figure_origin(&g, 120, 210, 105);
    double water[8] = {-1.1, 0, 6, 0, 6, -1.95, -1.1, -1.95};
    figure_polygon(&g, 4, water, FIGURE_SKY, 0.18, NULL);
    figure_line(&g, -1.1, 0, 6, 0, FIGURE_BLACK, 1.5, FIGURE_WHOLE);
    for (size_t k = 0; k < sizeof fan / sizeof *fan; k++) figure_out_of_water(&g, lamp, fan[k]);
    double at = -lamp.y * tan(critical);
    figure_line(&g, lamp.x, lamp.y, at, 0, FIGURE_BLACK, 1, FIGURE_DASHED);
    figure_line(&g, 0, lamp.y, 0, 0, FIGURE_GREY, 1, FIGURE_DASHED);
    figure_arc(&g, lamp.x, lamp.y, 46, 90 - critical / degree, 90, FIGURE_BLACK, 1);
    figure_text(&g, -0.1, lamp.y + 0.5, 0, 0, FIGURE_RIGHT, FIGURE_BLACK, "_i_~c~ = 48.8°");
    figure_dot(&g, lamp.x, lamp.y, 6, FIGURE_ORANGE);
    figure_text(&g, lamp.x, lamp.y, -12, -5, FIGURE_RIGHT, FIGURE_BLACK, "a lamp");
    figure_text(&g, 4.6, 0.1, 0, 0, FIGURE_LEFT, FIGURE_BLACK, "air, _n_~2~ = 1");
    figure_text(&g, 4.6, -0.25, 0, 0, FIGURE_LEFT, FIGURE_BLACK, "water, _n_~1~ = 1.33");
    figure_text(&g, 4.5, -1.5, 0, 0, FIGURE_LEFT, FIGURE_RED, "total reflection");
    figure_end(&g);
}

#endif
