/* angles_figure.h: the drawing of this chapter: a patch of directions, a beam on a tilted patch of
 * floor, and one meter at two distances.
 *
 *   draw_angles(&o);      22_radiometry_angles.svg
 */
#ifndef RADIOMETRY_ANGLES_FIGURE_H
#define RADIOMETRY_ANGLES_FIGURE_H

#include "../../../common/lab/figure.h"

/* ---------------------------------------------------------------------------------------------- */

/* The direction theta, phi [degrees] on the unit sphere, seen from front above. */
static inline figure_point angles_place(double theta, double phi)
{
    double t = theta * (double)pi / 180, p = phi * (double)pi / 180;
    double x = sin(t) * cos(p), y = sin(t) * sin(p), z = cos(t);
    return (figure_point){y - 0.5 * x, z - 0.38 * x};
}

/* A curve of directions from (theta, phi) to (theta2, phi2), straight in the angles. */
static inline void angles_curve(figure *g, double theta, double phi, double theta2, double phi2,
                                const char *colour, double width)
{
    enum { pieces = 24 };
    figure_point a = angles_place(theta, phi);
    for (int k = 1; k <= pieces; k++) {
        double s = (double)k / pieces;
        figure_point b = angles_place(theta + s * (theta2 - theta), phi + s * (phi2 - phi));
        figure_line(g, a.x, a.y, b.x, b.y, colour, width, FIGURE_WHOLE);
        a = b;
    }
}

static inline void angles_patch(figure *g)
{
    const double theta = 42, wide = 16, phi = 34, turn = 24;
    double xy[8];
    const double corner[4][2] = {{theta, phi}, {theta + wide, phi}, {theta + wide, phi + turn},
                                 {theta, phi + turn}};
    for (int k = 0; k < 4; k++) {
        figure_point p = angles_place(corner[k][0], corner[k][1]);
        xy[2 * k] = p.x, xy[2 * k + 1] = p.y;
        figure_line(g, 0, 0, p.x, p.y, FIGURE_GREY, 1, FIGURE_DASHED);
    }
    figure_polygon(g, 4, xy, FIGURE_ORANGE, 0.7, NULL);
    for (int k = 0; k < 2; k++) {
        angles_curve(g, 0, phi + k * turn, 90, phi + k * turn, FIGURE_BLUE, 1.2);
        angles_curve(g, theta + k * wide, 0, theta + k * wide, 90, FIGURE_BLUE, 1.2);
        angles_curve(g, 0, 90 * k, 90, 90 * k, FIGURE_GREY, 1.2);
    }
    angles_curve(g, 90, 0, 90, 90, FIGURE_GREY, 1.2);
    figure_arrow(g, 0, 0, 0, 1.18, FIGURE_BLACK, 1.5);
    for (int k = 0; k < 2; k++) {
        figure_point axis = angles_place(90, 90 * k);
        figure_arrow(g, 0, 0, 1.12 * axis.x, 1.12 * axis.y, FIGURE_BLACK, 1.2);
    }
    figure_text(g, 0, 1.18, 8, 6, FIGURE_LEFT, FIGURE_BLACK, "*n*");
    figure_text(g, xy[2], xy[3], 16, 24, FIGURE_LEFT, FIGURE_BLACK, "sin _θ_ d_φ_");
    figure_text(g, xy[6], xy[7], 10, 6, FIGURE_LEFT, FIGURE_BLACK, "d_θ_");
    figure_text(g, 0, 0.42, 6, 0, FIGURE_LEFT, FIGURE_BLACK, "_θ_");
    figure_text(g, 0, 0, 30, 95, FIGURE_MIDDLE, FIGURE_BLACK, "d_ω_ = sin _θ_ d_θ_ d_φ_");
}

static inline void angles_beam(figure *g)
{
    const double tilt = 50 * (double)pi / 180, dx = -sin(tilt), dy = cos(tilt), half = 0.55;
    double beam[8] = {-half, 0, half, 0, half + 1.35 * dx, 1.35 * dy, -half + 1.35 * dx, 1.35 * dy};
    double out = half * cos(tilt);  /* half the beam's width */
    figure_polygon(g, 4, beam, FIGURE_ORANGE, 0.35, NULL);
    figure_line(g, -1.1, 0, 1.1, 0, FIGURE_GREY, 1.5, FIGURE_WHOLE);
    figure_line(g, -half, 0, half, 0, FIGURE_BLUE, 4, FIGURE_WHOLE);
    figure_arrow(g, 0, 0, 0, 1.18, FIGURE_BLACK, 1.5);
    figure_arrow(g, 1.3 * dx, 1.3 * dy, 0.06 * dx, 0.06 * dy, FIGURE_BLACK, 1.5);
    double cx = 0.72 * dx, cy = 0.72 * dy;
    figure_line(g, cx - out * dy, cy + out * dx, cx + out * dy, cy - out * dx, FIGURE_BLUE, 2.5,
                FIGURE_WHOLE);
    figure_arc(g, 0, 0, 46, 90, 140, FIGURE_BLACK, 1.2);
    figure_text(g, -0.16, 0.5, 0, 0, FIGURE_MIDDLE, FIGURE_BLACK, "_θ_");
    figure_text(g, 0, 1.18, 8, 6, FIGURE_LEFT, FIGURE_BLACK, "*n*");
    figure_text(g, 0, 0, 0, 22, FIGURE_MIDDLE, FIGURE_BLUE, "d_A_");
    figure_text(g, cx - out * dy, cy + out * dx, -8, 14, FIGURE_RIGHT, FIGURE_BLUE, "cos _θ_ d_A_");
    figure_text(g, 0, 0, 0, 95, FIGURE_MIDDLE, FIGURE_BLACK, "the same power on more floor");
}

/* Both meters see the same cone; the spot of the farther one is three times as wide. */
static inline void angles_meters(figure *g)
{
    const double wall = 1.15, apex[2] = {0.5, -1.15}, y[2] = {0.85, 0.15};
    figure_line(g, wall, -0.35, wall, 1.2, FIGURE_BLACK, 3, FIGURE_WHOLE);
    for (int k = 0; k < 2; k++) {
        double far = wall - apex[k], spot = 0.17 * far;
        double cone[6] = {apex[k], y[k], wall, y[k] - spot, wall, y[k] + spot};
        figure_polygon(g, 3, cone, FIGURE_SKY, 0.35, FIGURE_BLUE);
        figure_line(g, wall, y[k] - spot, wall, y[k] + spot, FIGURE_ORANGE, 6, FIGURE_WHOLE);
        figure_dot(g, apex[k], y[k], 6, FIGURE_BLUE);
        figure_text(g, apex[k], y[k], -2, -14, FIGURE_MIDDLE, FIGURE_BLACK, "_L_");
    }
    figure_text(g, 0, 0, 0, 95, FIGURE_MIDDLE, FIGURE_BLACK,
                "farther: less of each point, more points");
}

cold_inline void draw_angles(const options *o)
{
    figure g = figure_begin(o, "22_radiometry_angles.svg", 1040, 350);
    figure_origin(&g, 130, 235, 175), angles_patch(&g);
    figure_origin(&g, 560, 235, 160), angles_beam(&g);
    figure_origin(&g, 860, 235, 130), angles_meters(&g);
    figure_end(&g);
}

#endif
