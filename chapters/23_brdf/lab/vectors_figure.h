/* vectors_figure.h: the drawing of this chapter: wi, wo, n and h; and facets of a rough surface,
 * of which only those with the normal h send light from wi to wo.
 *
 *   draw_vectors(&o);      23_brdf_vectors.svg
 */
#ifndef BRDF_VECTORS_FIGURE_H
#define BRDF_VECTORS_FIGURE_H

#include "../../../common/lab/figure.h"

/* ---------------------------------------------------------------------------------------------- */

/* A direction of so many degrees from n, to the right positive. */
static inline void vectors_arrow(figure *g, double degrees, double length, const char *colour,
                                 const char *name)
{
    double a = degrees * (double)pi / 180, x = length * sin(a), y = length * cos(a);
    figure_arrow(g, 0, 0, x, y, colour, 2);
    figure_text(g, x, y, degrees < 0 ? -8 : 8, 0, degrees < 0 ? FIGURE_RIGHT : FIGURE_LEFT, colour,
                name);
}

enum { vectors_in = -55, vectors_out = 25, vectors_half = (vectors_in + vectors_out) / 2 };

static inline void vectors_angles(figure *g)
{
    figure_line(g, -1.1, 0, 1.1, 0, FIGURE_GREY, 2, FIGURE_WHOLE);
    figure_arc(g, 0, 0, 50, 90, 90 - vectors_in, FIGURE_BLACK, 1.2);
    figure_arc(g, 0, 0, 62, 90 - vectors_out, 90, FIGURE_BLACK, 1.2);
    figure_text(g, -0.19, 0.42, 0, 0, FIGURE_MIDDLE, FIGURE_BLACK, "_θ_~i~");
    figure_text(g, 0.11, 0.46, 0, 0, FIGURE_MIDDLE, FIGURE_BLACK, "_θ_~o~");
    vectors_arrow(g, 0, 1.15, FIGURE_BLACK, "*n*");
    vectors_arrow(g, vectors_in, 1, FIGURE_ORANGE, "*ω*~i~: to the light");
    vectors_arrow(g, vectors_out, 1, FIGURE_BLUE, "*ω*~o~: to the eye");
    vectors_arrow(g, vectors_half, 0.9, FIGURE_GREEN, "*h*");
    figure_text(g, 0, 0, 0, 45, FIGURE_MIDDLE, FIGURE_BLACK,
                "all point away from the surface; *h* halves *ω*~i~, *ω*~o~");
}

/* A mountain range of facets; those whose normal is h [within 3 degrees] are green, and mirror wi
 * to wo. */
static inline void vectors_facets(figure *g)
{
    static const double tilt[] = {12, -28, 33, -15, 20, -35, -15, 8, 30, -22, -15, 25, -30, 16};
    enum { facets = sizeof tilt / sizeof *tilt };
    double x = -1.25, y = 0.05, width = 2.5 / facets;
    for (int k = 0; k < facets; k++) {
        double a = tilt[k] * (double)pi / 180, x1 = x + width, y1 = y - width * tan(a);
        bool meets = fabs(tilt[k] - vectors_half) < 3;
        figure_line(g, x, y, x1, y1, meets ? FIGURE_GREEN : FIGURE_GREY, meets ? 4 : 2,
                    FIGURE_WHOLE);
        if (meets) {
            double mx = (x + x1) / 2, my = (y + y1) / 2;
            double in = vectors_in * (double)pi / 180, out = vectors_out * (double)pi / 180;
            figure_arrow(g, mx + 0.75 * sin(in), my + 0.75 * cos(in), mx, my, FIGURE_ORANGE, 1.3);
            figure_arrow(g, mx, my, mx + 0.75 * sin(out), my + 0.75 * cos(out), FIGURE_BLUE, 1.3);
        }
        x = x1, y = y1;
    }
    figure_text(g, 0, 0, 0, 45, FIGURE_MIDDLE, FIGURE_BLACK,
                "facets: only those with the normal *h* count");
}

cold_inline void draw_vectors(const options *o)
{
    figure g = figure_begin(o, "23_brdf_vectors.svg", 960, 300);
    figure_origin(&g, 290, 225, 165);
    vectors_angles(&g);
    figure_origin(&g, 720, 225, 165);
    vectors_facets(&g);
    figure_end(&g);
}

#endif
