/* extent_figure.h: the drawing of this chapter: a lamp's rays past an obstacle, a lobe about the
 * mirror direction, and a lens whose rays meet in the plane of focus.
 *
 *   draw_extent(&o);      21_distributed_extent.svg
 */
#ifndef DISTRIBUTED_EXTENT_FIGURE_H
#define DISTRIBUTED_EXTENT_FIGURE_H

#include "../../../common/lab/figure.h"
#include "../area_light.h"
#include "../glossy.h"
#include "../lens.h"

/* ---------------------------------------------------------------------------------------------- */

/* The lamp: x = -0.5 to 0.5 at height 1.5, above an obstacle from -0.45 to 0.05 at height 0.8. */
static inline area_light extent_lamp(void)
{
    return (area_light){AREA_RECTANGLE, vec(0, 0, 1.5), {1, 0, 0}, {0, 1, 0}, {0, 0, -1}, 0,
                        {1, 1, 1}};
}

static inline bool extent_hidden(double p, vec3 q)
{
    double x = p + ((double)q.x - p) * 0.8 / (double)q.z;
    return x > -0.45 && x < 0.05;
}

/* The share of the lamp's light that reaches x on the floor, of 64 even points. */
static inline double extent_share(double x)
{
    area_light lamp = extent_lamp();
    double all = 0, seen = 0;
    for (int k = 0; k < 64; k++) {
        area_sample s;
        point2 u = {((real)k + (real)0.5) / 64, (real)0.5};
        area_light_reaches(&lamp, vec(x, 0, 0), vec(0, 0, 1), vec(0, 0, 1), u, &s);
        all += (double)s.E.x, seen += extent_hidden(x, s.to) ? 0 : (double)s.E.x;
    }
    return seen / all;
}

static inline void extent_shadow(figure *g)
{
    enum { strips = 91, rays = 8 };
    const double left = -1.3, width = 2.6, p = 0.2;
    area_light lamp = extent_lamp();
    for (int k = 0; k < strips; k++) {
        double x = left + width * k / strips, to = x + width / strips;
        double box[8] = {x, 0, to, 0, to, -0.1, x, -0.1};
        figure_polygon(g, 4, box, FIGURE_ORANGE, extent_share(x + width / strips / 2), NULL);
    }
    for (int k = 0; k < rays; k++) {
        point2 u = {((real)k + (real)0.5) / rays, (real)0.5};
        area_sample s;
        area_light_reaches(&lamp, vec(p, 0, 0), vec(0, 0, 1), vec(0, 0, 1), u, &s);
        double part = extent_hidden(p, s.to) ? 0.8 / 1.5 : 1;
        figure_line(g, p, 0, p + part * ((double)s.to.x - p), part * (double)s.to.z,
                    part < 1 ? FIGURE_RED : FIGURE_GREEN, 1.3, FIGURE_WHOLE);
        figure_dot(g, (double)s.to.x, (double)s.to.z, 3, FIGURE_BLACK);
    }
    figure_line(g, left, 0, left + width, 0, FIGURE_BLACK, 1.2, FIGURE_WHOLE);
    figure_line(g, -0.5, 1.5, 0.5, 1.5, FIGURE_ORANGE, 4, FIGURE_WHOLE);
    figure_line(g, -0.45, 0.8, 0.05, 0.8, FIGURE_BLACK, 5, FIGURE_WHOLE);
    figure_dot(g, p, 0, 4, FIGURE_BLACK);
    figure_text(g, p, 0, 10, -8, FIGURE_LEFT, FIGURE_BLACK, "*p*");
    figure_text(g, 0.5, 1.5, 10, 5, FIGURE_LEFT, FIGURE_BLACK, "*q*");
    figure_text(g, -0.45, 0.8, -8, 5, FIGURE_RIGHT, FIGURE_BLACK, "_V_ = 0");
    figure_text(g, 0.36, 0.8, 6, 5, FIGURE_LEFT, FIGURE_GREEN, "_V_ = 1");
}

/* w at an angle from the mirror direction, both in the plane of the drawing. */
static inline void extent_lobe(figure *g)
{
    enum { pieces = 90, rays = 10 };
    const double shine = 20, fall = 62 * (double)pi / 180;  /* from the normal */
    double outline[2 * pieces];
    for (int k = 0; k < pieces; k++) {
        double a = ((double)k / (pieces - 1) - 0.5) * (double)pi;
        double long_ = 1.15 * pow(fmax(cos(a), 0), shine);
        outline[2 * k] = long_ * sin(fall + a), outline[2 * k + 1] = long_ * cos(fall + a);
    }
    figure_polygon(g, pieces, outline, FIGURE_SKY, 0.35, FIGURE_BLUE);
    for (int k = 0; k < rays; k++) {
        real u = ((real)k + (real)0.5) / rays;
        double a = acos((double)sample_lobe((real)shine, u, 0).z) * (k % 2 ? 1 : -1);
        double x = 1.2 * sin(fall + a), y = 1.2 * cos(fall + a);
        figure_arrow(g, 0, 0, x, y, y > 0 ? FIGURE_GREEN : FIGURE_RED, 1.2);
    }
    figure_line(g, -1.2, 0, 1.3, 0, FIGURE_BLACK, 2, FIGURE_WHOLE);
    figure_arrow(g, 0, 0, 0, 1.2, FIGURE_BLACK, 1.3);
    figure_arrow(g, -1.25 * sin(fall), 1.25 * cos(fall), 0, 0, FIGURE_BLACK, 1.8);
    figure_arrow(g, 0, 0, 1.45 * sin(fall), 1.45 * cos(fall), FIGURE_BLACK, 1.8);
    figure_text(g, 0, 1.2, 8, 5, FIGURE_LEFT, FIGURE_BLACK, "*n*");
    figure_text(g, -sin(fall), cos(fall), 0, -10, FIGURE_MIDDLE, FIGURE_BLACK, "*d*");
    figure_text(g, 1.45 * sin(fall), 1.45 * cos(fall), 8, 0, FIGURE_LEFT, FIGURE_BLACK, "*r*");
    figure_text(g, 0.55, 0.95, 0, 0, FIGURE_LEFT, FIGURE_GREEN, "*ω*");
    figure_text(g, 1.1, -0.12, 0, 10, FIGURE_MIDDLE, FIGURE_RED, "lost");
}

static inline void extent_lens(figure *g)
{
    enum { rays = 5 };
    const real radius = 0.5, focus = 1.5, depth = (real)2.4;
    camera c = {CAMERA_PERSPECTIVE, {0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {-1, 0, 0}, -1, 1, -1, 1, 1,
                {0, 0, 0}};
    thin_lens l = {radius, focus};
    double blur = (double)lens_blur(l, depth);
    for (int k = 0; k < rays; k++) {
        point2 u = {(real)0.5, (real)0.02 + (real)0.96 * (real)k / (rays - 1)};
        ray r = lens_ray(c, l, 1, 1, 2, 2, u);
        vec3 end = ray_at(r, depth / r.d.x);
        figure_line(g, (double)r.o.x, (double)r.o.y, (double)end.x, (double)end.y, FIGURE_BLUE, 1.3,
                    FIGURE_WHOLE);
    }
    figure_line(g, 0, -0.5, 0, 0.5, FIGURE_BLACK, 4, FIGURE_WHOLE);
    figure_line(g, 1.5, -0.75, 1.5, 0.75, FIGURE_GREY, 1.3, FIGURE_DASHED);
    figure_line(g, 2.4, -blur, 2.4, blur, FIGURE_ORANGE, 4, FIGURE_WHOLE);
    figure_dot(g, 1.5, 0, 4, FIGURE_BLACK);
    figure_text(g, 1.5, 0, 8, -12, FIGURE_LEFT, FIGURE_BLACK, "*P*");
    figure_text(g, 0, 0.5, 0, -8, FIGURE_MIDDLE, FIGURE_BLACK, "lens, _R_");
    figure_text(g, 1.5, 0.75, 0, -8, FIGURE_MIDDLE, FIGURE_BLACK, "plane of focus");
    figure_text(g, 2.4, blur, 0, -8, FIGURE_MIDDLE, FIGURE_ORANGE, "blur");
    for (int k = 0; k < 2; k++) {
        double x = k ? 2.4 : 1.5, y = k ? -1.0 : -0.82;
        figure_arrow(g, 0, y, x, y, FIGURE_BLACK, 1);
        figure_text(g, x, y, 8, 5, FIGURE_LEFT, FIGURE_BLACK, k ? "_z_" : "_F_");
    }
}

cold_inline void draw_extent(const options *o)
{
    figure g = figure_begin(o, "21_distributed_extent.svg", 1080, 330);
    figure_origin(&g, 195, 250, 140);
    extent_shadow(&g);
    figure_text(&g, 0, 0, 0, 63, FIGURE_MIDDLE, FIGURE_BLACK,
                "the lamp, seen in part: soft shadow");
    figure_origin(&g, 530, 230, 125);
    extent_lobe(&g);
    figure_text(&g, 0, 0, 0, 83, FIGURE_MIDDLE, FIGURE_BLACK, "the lobe: gloss");
    figure_origin(&g, 775, 155, 110);
    extent_lens(&g);
    figure_text(&g, 1.2, 0, 0, 158, FIGURE_MIDDLE, FIGURE_BLACK, "the lens: depth of field");
    figure_end(&g);
}

#endif
